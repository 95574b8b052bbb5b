// Reassembles large data sets in memory of the caller. RA 3.3 part 2, large data sets.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/message/peer_share.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace jauscat::jaus {

/// Result of a packet.
enum class reassembled : std::uint8_t {
    only,     ///< no part of a large data set, or an acknowledgement: it is the caller's
    waiting,  ///< kept; others are missing. A last packet with acknowledgement request is not kept: it is repeated
    whole,    ///< the last missing one: the complete body has been delivered
    repeated, ///< a duplicate, or a late packet of the data set that was just delivered; dropped
    doubtful, ///< not to be acknowledged: equal to a part of the data set that was handed on before; it may be a late
              ///< copy
    no_capacity, ///< dropped: every place, or its source's share of them, is taken by data sets that go on
    too_large,   ///< dropped together with its data set, which has more bytes or packets than a place holds
};

/// The result in one line, for logs.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(reassembled what) noexcept;

/// A place for one data set of which packets are missing, and what is known of it.
struct partial_data_set {
    jaus::header header{};               ///< of packet 0, or of the first received one
    std::size_t packets{};               ///< how many are held; 0: the place is free
    std::size_t bytes{};                 ///< of body that are held
    std::optional<std::uint16_t> last{}; ///< sequence number of the last packet, once that has come
    bool last_is_doubtful{};             ///< the last packet was received once, and may have been a late copy
    bool begun{};                        ///< packet 0 is held
    time_point begun_at{};               ///< time of the last packet 0; before there is one, of the first other packet
    time_point last_heard_at{};          ///< time of its last packet
    std::uint64_t order{};               ///< the higher the later, among packets of one time too
    std::size_t handed_on{};             ///< packets of the whole that was made here last; the place is free then
};

/// A packet that is held: its sequence number, the bytes of its body, and where they begin among its place's.
struct held_packet {
    std::uint16_t sequence_number{}; ///< the packet's
    std::uint16_t size{};            ///< bytes of its body
    std::uint32_t offset{};          ///< where they begin
};

struct reassembly_limits {
    /// Places that one source may take, with several command codes at a time; 0: half of them, at least one. All
    /// sources of one node have three quarters at most, see peer_share.
    std::size_t places_per_source{};
    /// For this time after a data set is complete, packets equal to its own count as late copies of it, not as parts of
    /// an equal or similar next one; and for this time other packets may precede packet 0. As long as packets overtake
    /// each other, and shorter than senders pause.
    duration linger{std::chrono::milliseconds{2}};
    /// For this time after a data set is complete, the first packet with acknowledgement request that is equal to that
    /// of its number is doubtful: the network may have copied it, and acknowledging the copy would confirm a packet of
    /// the next data set. It is kept, except a last one; the second such packet is acknowledged. Longer than the
    /// network delays packets.
    duration linger_of_copies{};
    /// The same for a last packet with acknowledgement request: its sender repeats it until it is acknowledged, and the
    /// acknowledgement may be lost. As long as senders repeat.
    duration linger_of_repeats{std::chrono::seconds{2}};
    /// A data set without acknowledgement request is dropped when the next packet arrives after this silence: it may be
    /// of another data set. Shorter than senders pause between two of them.
    duration longest_gap{std::chrono::milliseconds{125}};
};

/// Reassembles data sets by command code and source. Packets may be reordered and duplicated.
///
/// All memory is the caller's. A data set with a second packet is active, and keeps its place until it has been silent
/// for the timeout. One with a single packet is replaced by packet 0 of a new one if no place is free, the longest
/// silent one first, so a flood of first packets from any sources neither displaces active data sets nor blocks others.
///
/// Packets do not identify their data set: the next one of the same source and code uses the same numbers. Packets that
/// may be of two data sets are dropped, never combined. A data set is dropped when a packet arrives
/// - that contradicts it: another body or another end under a number that it has, or no acknowledgement request
///   where the first one has it;
/// - and packet 0 has not come within `linger` of the first other one;
/// - after `longest_gap`, or with another packet 0 after `linger`, where no acknowledgement is asked for. Who asks for
///   it sends the last packet when all others are acknowledged, and these have been compared with what is held.
/// This is safe with senders that pause between two data sets for longer than the network holds packets back, and
/// longest_gap more after one that was not acknowledged. Whoever can send as the source of a data set can spoil it: let
/// only known senders through.
///
///     std::array<jaus::partial_data_set, 4> places{};
///     std::array<jaus::held_packet, 4 * 64> packets{};
///     std::array<std::byte, 4 * 64 * jaus::max_body_size> memory{};
///     jaus::reassembler large{places, packets, memory, 5s};
///     large.on_packet(header, body, now, [&](const jaus::header& head, std::span<const std::byte> whole) { ... },
///                     [&](const jaus::partial_data_set& incomplete) { ... });
class reassembler {
  public:
    /// Each place has an equal share of `packets` and of `memory`. A late packet moves the packets held after it; the
    /// share bounds this cost. `timeout`: a data set that has been silent for this time is dropped when its place is
    /// needed, or by on_time. All three must outlive this.
    JAUSCAT_CONSTEXPR reassembler(std::span<partial_data_set> places, std::span<held_packet> packets,
                                  std::span<std::byte> memory, duration timeout,
                                  reassembly_limits limits = {}) noexcept;

    /// A packet received at `now`. `take(const header&, std::span<const std::byte>)` gets a whole data set: the header
    /// of its packet 0, whose data size and flag are that packet's, and the whole body, valid during the call.
    /// `lost(const partial_data_set&)` is called for a dropped one.
    constexpr reassembled on_packet(const header& head, std::span<const std::byte> body, time_point now, auto&& take,
                                    auto&& lost) {
        // There are nodes that repeat the data flag when they acknowledge.
        if (head.data_flag == data_flag::only || is_acknowledgement(head)) return reassembled::only;
        partial_data_set* set = find(head);
        if (set == nullptr && is_straggler(head, body, now, linger_of(head))) return reassembled::repeated;
        const bool is_doubtful =
            is_requested(head) && !holds(set, head, body) && is_straggler(head, body, now, limits_.linger_of_copies);
        if (is_doubtful && set != nullptr && packet_of(*set, head) != nullptr) return reassembled::doubtful;
        if (set != nullptr && (contradicts(*set, head, body) || may_be_another(*set, head, now))) {
            forget(*set, lost);
            set = nullptr;
        }
        if (comes_too_early(set, head)) return reassembled::waiting;
        const bool ends = head.data_flag == data_flag::last;
        if (is_doubtful && ends && !std::exchange(set->last_is_doubtful, true)) return reassembled::doubtful;
        if (set == nullptr) set = free_place(head, now, lost);
        if (set == nullptr) return reassembled::no_capacity;
        if (set->packets == 0) *set = {.header = head, .begun_at = now};
        if (head.sequence_number == 0) {
            set->header = head;
            set->begun = true;
            set->begun_at = now;
        }
        set->last_heard_at = now;
        set->order = ++order_;

        const auto list = share(packets_, *set);
        const auto bytes = share(memory_, *set);
        const auto held = list.first(set->packets);
        const auto at = position(held, head.sequence_number);
        const auto before = static_cast<std::size_t>(at - held.begin());
        if (at != held.end() && at->sequence_number == head.sequence_number) return reassembled::repeated;
        if (set->packets == list.size() || body.size() > bytes.size() - set->bytes || body.size() > 0xFFFF) {
            forget(*set, lost);
            return reassembled::too_large;
        }
        const std::size_t offset = at == held.end() ? set->bytes : at->offset;
        for (held_packet& behind : held.subspan(before)) behind.offset += static_cast<std::uint32_t>(body.size());
        insert(list, set->packets, before,
               std::array{held_packet{.sequence_number = head.sequence_number,
                                      .size = static_cast<std::uint16_t>(body.size()),
                                      .offset = static_cast<std::uint32_t>(offset)}});
        insert(bytes, set->bytes, offset, body);
        ++set->packets;
        set->bytes += body.size();

        if (ends) set->last = head.sequence_number;
        if (!set->last || set->packets != *set->last + std::size_t{1})
            return is_doubtful ? reassembled::doubtful : reassembled::waiting;
        take(std::as_const(set->header), std::span<const std::byte>{bytes.first(set->bytes)});
        *set = {.header = set->header, .last_heard_at = now, .order = order_, .handed_on = set->packets};
        return reassembled::whole;
    }

    /// Drops data sets that have timed out. Optional: on_packet does so for the place that it needs.
    constexpr void on_time(time_point now, auto&& lost) {
        for (partial_data_set& set : places_)
            if (set.packets != 0 && stale(set, now)) forget(set, lost);
    }

    /// The data set to which a packet with this header belongs, as far as it has come, or nullptr.
    [[nodiscard]] JAUSCAT_CONSTEXPR const partial_data_set* incomplete(const header& head) const noexcept {
        return find(head);
    }
    /// The places, to inspect incomplete data sets.
    [[nodiscard]] constexpr std::span<const partial_data_set> places() const noexcept { return places_; }

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR partial_data_set* find(const header& head) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_requested(const header& head) noexcept;
    // A sender that has gone on to its next data set uses the numbers of the old one again, for other bytes.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool contradicts(const partial_data_set& set, const header& head,
                                                     std::span<const std::byte> body) const noexcept;
    // A last packet with acknowledgement request is not kept while others are missing: a packet of a later data set
    // that fills the gap would combine both. It is repeated.
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool comes_too_early(const partial_data_set* set,
                                                                const header& head) noexcept;
    // By the time alone: the packet may belong to a later data set than those that are held.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool may_be_another(const partial_data_set& set, const header& head,
                                                        time_point now) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR const held_packet* packet_of(const partial_data_set& set,
                                                                 const header& head) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool holds(const partial_data_set* set, const header& head,
                                               std::span<const std::byte> body) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR duration linger_of(const header& head) const noexcept;
    // Its body is still in the memory of its place.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_straggler(const header& head, std::span<const std::byte> body,
                                                      time_point now, duration linger) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<const std::byte> body_of(const partial_data_set& set,
                                                                       const held_packet& packet) const noexcept;
    // Where the packet of this number is among those held, or would be.
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::span<held_packet>::iterator position(std::span<held_packet> held,
                                                                                     std::uint16_t number) noexcept;
    // The place for a new data set: a free one, the longest unused first, so that late packets are recognised for long;
    // else that of a silent data set; else, for packet 0 only, that of one with a single packet.
    [[nodiscard]] constexpr partial_data_set* free_place(const header& head, time_point now, auto& lost) {
        const auto of_source = [&](const partial_data_set& set) {
            return set.packets != 0 && set.header.source == head.source;
        };
        const auto of_node = [&](const partial_data_set& set) {
            return set.packets != 0 && are_of_one_node(set.header.source, head.source);
        };
        const bool share_is_full =
            std::cmp_greater_equal(std::ranges::count_if(places_, of_source), limits_.places_per_source);
        const bool node_is_full =
            std::cmp_greater_equal(std::ranges::count_if(places_, of_node), peer_share(places_.size()));
        const auto reluctance = [&](const partial_data_set& set) {
            if (set.packets == 0) return 0;
            return stale(set, now) ? 1 : set.packets == 1 ? 2 : 3;
        };
        const int most = head.sequence_number == 0 ? 2 : 1;
        partial_data_set* best = nullptr;
        for (partial_data_set& set : places_) {
            if (reluctance(set) > most || (share_is_full && !of_source(set)) || (node_is_full && !of_node(set)))
                continue;
            if (best == nullptr || std::pair{reluctance(set), set.order} < std::pair{reluctance(*best), best->order})
                best = &set;
        }
        if (best != nullptr && best->packets != 0) forget(*best, lost);
        return best;
    }
    [[nodiscard]] JAUSCAT_CONSTEXPR bool stale(const partial_data_set& set, time_point now) const noexcept;
    static constexpr void forget(partial_data_set& set, auto& lost) {
        lost(std::as_const(set));
        set = {};
    }
    template <class T>
    [[nodiscard]] constexpr std::span<T> share(std::span<T> all, const partial_data_set& set) const noexcept {
        const std::size_t size = all.size() / places_.size();
        return all.subspan(static_cast<std::size_t>(&set - places_.data()) * size, size);
    }
    // Puts `more` into the first `used` elements of `all`, in front of the one at `place`.
    template <class T>
    static constexpr void insert(std::span<T> all, std::size_t used, std::size_t place, const auto& more) noexcept {
        const auto at = all.begin() + static_cast<std::ptrdiff_t>(place);
        const auto end = all.begin() + static_cast<std::ptrdiff_t>(used);
        std::copy_backward(at, end, end + static_cast<std::ptrdiff_t>(more.size()));
        std::ranges::copy(more, at);
    }

    std::span<partial_data_set> places_;
    std::span<held_packet> packets_;
    std::span<std::byte> memory_;
    duration timeout_;
    reassembly_limits limits_;
    std::uint64_t order_{};
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/large_data/impl/reassembler.ipp>
#endif
