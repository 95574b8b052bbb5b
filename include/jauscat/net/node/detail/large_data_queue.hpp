// Queue of large data sets to be sent, paced so that neither buffers nor a peer's rate limit overflow.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/large_data/large_data_sender.hpp>
#include <jauscat/jaus/message/stands_for.hpp>
#include <jauscat/net/node/detail/body_digest.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// Pacing of large data sets.
struct large_data_pacing {
    unsigned packets{4}; ///< each millisecond
    /// Pause between two data sets of the same source and code to the same destination, if packets of the first may
    /// still be in transit, or the receiver may have a part of it: see large_data_queue.
    duration pause{std::chrono::milliseconds{500}};
    retry_policy retry{.interval = std::chrono::milliseconds{50}, .attempts = 21}; ///< of a packet
};

/// Copies of bodies. Those to one node are sent one after the other, and those of one source and code to one
/// destination in their order, because packets do not identify their data set; other nodes do not wait for them. All
/// share the pacing.
///
/// A report without acknowledgement takes the place of an earlier one that waits.
///
/// If a data set requests acknowledgement, each packet is repeated until its ACK is received. The first packet is sent
/// alone, and so is the last: the receiver then has a place for the data set before a packet is repeated, and
/// acknowledges the last one only when it has the whole. If a packet is not answered several times, the receiver has
/// lost the data set: all of it is sent once more, unless the receiver may have forgotten that it has received it.
///
/// A packet that equals that of the previous data set is sent twice if that one was acknowledged shortly before: the
/// receiver does not acknowledge the first copy, which may be a late packet of the previous data set.
///
/// A data set follows the previous one of its source and code to the same destination
/// - 40 ms after the end of one that was acknowledged without a repeat;
/// - after the pause, if that one requested no acknowledgement, was repeated or refused, and after a start;
/// - after twice the pause, if that one was abandoned, because late acknowledgements of its packets would count for
/// this;
/// - after `memory` and the pause, if both request acknowledgement and have the same body, because the receiver would
///   treat the second as a repeat of the first.
class large_data_queue {
  public:
    /// Called once for each data set that requested an acknowledgement.
    using done_handler = std::function<void(const jaus::header&, jaus::delivered)>;

    /// Time for which a receiver remembers an acknowledged data set.
    static constexpr duration memory = std::chrono::seconds{2};

    /// `most`: limit of queued bytes.
    large_data_queue(std::size_t most, const large_data_pacing& pacing) : most_{most}, pacing_{pacing} {
        pacing_.packets = std::max(pacing_.packets, 1U);
        pacing_.retry.attempts = std::max(pacing_.retry.attempts, 1U);
    }

    /// Errors: no_space above `most` bytes, and those of large_data_sender.
    [[nodiscard]] jaus::errc push(const jaus::header& head, std::span<const std::byte> body) {
        const auto old = superseded_by(head);
        const auto left = old == sets_.end() ? waiting_ : waiting_ - (*old)->body.size();
        if (body.size() > most_ - left) return jaus::errc::no_space;
        auto made = std::make_unique<entry>(head, body);
        if (made->sender.error() != jaus::errc::ok) return made->sender.error();
        if (is_awaited(head)) {
            made->packets.resize(made->sender.packets());
            made->digest = digest_of(body);
            made->digests = digests_of(body);
        }
        waiting_ = left + body.size();
        if (old != sets_.end()) {
            *old = std::move(made);
            return jaus::errc::ok;
        }
        choose_at_ = std::min(choose_at_, ready_at(*made));
        next_ = std::min(next_, choose_at_);
        sets_.push_back(std::move(made));
        return jaus::errc::ok;
    }
    void on_time(time_point now, jaus::message_sink out, const done_handler& done) {
        if (now < next_) return;
        if (choose_at_ <= now) choose(now);
        if (next_beat_ <= now) {
            next_beat_ = now + beat;
            if (!send(now, out, done)) return; // cleared by a handler
        }
        set_next_event();
    }
    /// True if it was the ACK or NAK of a sent packet, also a late one.
    bool on_acknowledgement(const jaus::header& head, time_point now) {
        for (const auto& each : active_) {
            auto& set = *each;
            if (set.packets.empty() || head.command_code != set.head.command_code ||
                head.source != set.head.destination || head.destination != set.head.source ||
                head.sequence_number >= set.packets.size())
                continue;
            auto& packet = set.packets[head.sequence_number];
            if (packet.sent == 0) return false;
            if (set.outcome || packet.tries == 0) return true;
            if (head.ack_nak == jaus::ack_nak::nak)
                set.outcome = jaus::delivered::refused;
            else if (!std::exchange(packet.acknowledged, true) && ++set.acknowledged == set.packets.size())
                set.outcome = jaus::delivered::acknowledged;
            set.next = std::min(set.next, now + beat); // the next packets may be sent, or it has ended
            set_next_event();
            return true;
        }
        return false;
    }
    [[nodiscard]] std::optional<time_point> next_event() const noexcept {
        return size() == 0 ? std::nullopt : std::optional{next_};
    }
    /// Number of data sets that are not yet sent.
    [[nodiscard]] std::size_t size() const noexcept { return sets_.size() + active_.size(); }
    /// Clears the queue and sends nothing before the pause is over: packets from before a restart may still be in
    /// transit.
    void start(time_point now) {
        clear();
        rests_.clear();
        begins_at_ = saturating_add(now, pacing_.pause);
    }
    /// May be called from a handler.
    void clear() noexcept {
        sets_.clear();
        active_.clear();
        waiting_ = 0;
        next_ = choose_at_ = time_point::max();
        ++clears_;
    }

  private:
    static constexpr duration beat = std::chrono::milliseconds{1};
    static constexpr duration short_pause = std::chrono::milliseconds{40}; ///< for copies made by the network
    static constexpr duration latest_resent = memory * 3 / 4; ///< after the first transmission of the last packet
    static constexpr unsigned tries_until_restart = 4;

    struct sent_packet {
        time_point due{};     ///< time of the next repeat
        std::uint32_t sent{}; ///< number of transmissions
        unsigned tries{};     ///< the same since the last start of the data set
        bool acknowledged{};
        bool is_alike{}; ///< equals that of the previous data set: the receiver does not acknowledge the first copy
    };
    struct entry {
        entry(const jaus::header& h, std::span<const std::byte> bytes)
            : head{h}, body(bytes.begin(), bytes.end()), sender{head, body, packet} {}
        jaus::header head;
        std::vector<std::byte> body;
        std::array<std::byte, jaus::header_size + jaus::max_body_size> packet{};
        jaus::large_data_sender sender;
        std::vector<sent_packet> packets{};   ///< none without acknowledgement
        std::uint64_t digest{};               ///< of the body, with acknowledgement
        std::vector<std::uint64_t> digests{}; ///< of the packets
        std::size_t acknowledged{};           ///< of the packets
        std::size_t first_open{};             ///< all before it are acknowledged
        unsigned restarts{};
        bool is_sent_again{};                     ///< all of it, after the last packet
        std::optional<time_point> last_sent_at{}; ///< first transmission of the last packet
        std::optional<jaus::delivered> outcome{};
        time_point next{}; ///< when something is to be sent, or it has ended
    };
    /// What went last from a source to a destination with a command code.
    struct rest {
        jaus::header head{};
        time_point since{};
        duration pause{};                        ///< before the next data set
        std::optional<time_point> known_since{}; ///< since then the receiver may remember this digest
        std::uint64_t digest{};
        std::vector<std::uint64_t> digests{}; ///< of its packets
    };

    [[nodiscard]] time_point ready_at(const entry& set) const noexcept {
        time_point at = begins_at_;
        for (const rest& one : rests_) {
            if (!collide(one.head, set.head)) continue;
            at = std::max(at, saturating_add(one.since, one.pause));
            if (!set.packets.empty() && one.known_since && one.digest == set.digest)
                at = std::max(at, saturating_add(*one.known_since, saturating_add(memory, pacing_.pause)));
        }
        return at;
    }
    [[nodiscard]] static std::vector<std::uint64_t> digests_of(std::span<const std::byte> body) {
        std::vector<std::uint64_t> made;
        for (; !body.empty(); body = body.subspan(std::min(body.size(), jaus::max_body_size)))
            made.push_back(digest_of(body.first(std::min(body.size(), jaus::max_body_size))));
        return made;
    }
    void note_alike(entry& set, time_point now) const noexcept {
        for (const rest& one : rests_) {
            if (one.head.command_code != set.head.command_code || one.head.source != set.head.source ||
                one.head.destination != set.head.destination || saturating_add(one.since, pacing_.pause) <= now)
                continue;
            for (std::size_t i = 0; i != std::min(set.digests.size(), one.digests.size()); ++i)
                set.packets[i].is_alike = set.digests[i] == one.digests[i];
        }
    }
    /// Its packets are acknowledged.
    [[nodiscard]] static bool is_awaited(const jaus::header& head) noexcept {
        return head.ack_nak == jaus::ack_nak::request && jaus::names_one_component(head.destination);
    }
    /// An earlier report that waits, without acknowledgement: nobody wants its old values.
    [[nodiscard]] std::deque<std::unique_ptr<entry>>::iterator superseded_by(const jaus::header& head) noexcept {
        const bool is_report = head.command_code >= 0x4000 && head.command_code < 0x6000;
        if (!is_report || is_awaited(head)) return sets_.end();
        return std::ranges::find_if(sets_, [&](const auto& each) {
            return each->packets.empty() && each->head.command_code == head.command_code &&
                   each->head.source == head.source && each->head.destination == head.destination;
        });
    }
    /// Packets of the two cannot be told apart by a receiver.
    [[nodiscard]] static bool collide(const jaus::header& one, const jaus::header& other) noexcept {
        const auto &to = one.destination, &before = other.destination;
        return one.command_code == other.command_code && one.source == other.source &&
               (jaus::stands_for(to, before) || jaus::stands_for(before, to));
    }
    [[nodiscard]] static bool have_one_node(const jaus::header& one, const jaus::header& other) noexcept {
        return one.destination.subsystem == other.destination.subsystem &&
               one.destination.node == other.destination.node;
    }
    // The first of each node that is not in its pause, and overtakes none, becomes active.
    void choose(time_point now) {
        choose_at_ = time_point::max();
        const auto longest = saturating_add(saturating_add(memory, pacing_.pause), pacing_.pause);
        std::erase_if(rests_, [&](const rest& one) { return saturating_add(one.since, longest) <= now; });
        std::vector<jaus::header> before; // of those that wait
        for (auto at = sets_.begin(); at != sets_.end();) {
            const auto& head = (*at)->head;
            const bool waits =
                std::ranges::any_of(
                    active_,
                    [&](const auto& each) { return have_one_node(each->head, head) || collide(each->head, head); }) ||
                std::ranges::any_of(before, [&](const auto& each) { return collide(each, head); });
            const auto ready = waits ? time_point::max() : ready_at(**at);
            if (ready > now) {
                choose_at_ = std::min(choose_at_, ready);
                before.push_back(head);
                ++at;
                continue;
            }
            active_.push_back(std::move(*at));
            at = sets_.erase(at);
            note_alike(*active_.back(), now);
            active_.back()->next = now;
        }
    }
    // The packets of one beat, of the active data sets in turn: the next beat begins with the one for which none were
    // left. False: a handler has cleared the queue.
    bool send(time_point now, jaus::message_sink out, const done_handler& done) {
        const auto clears = clears_;
        unsigned left = pacing_.packets;
        for (auto count = active_.size(); left != 0 && count-- != 0;) {
            const auto set = active_.front(); // a handler may clear the queue
            std::rotate(active_.begin(), active_.begin() + 1, active_.end());
            if (set->next > now) continue;
            const bool is_over =
                set->packets.empty() ? send_plain(*set, left, out) : send_awaited(*set, now, left, out);
            if (clears != clears_) return false;
            if (!is_over) continue;
            end(set, now);
            if (!set->outcome || !done) continue;
            done(set->head, *set->outcome);
            if (clears != clears_) return false;
        }
        return true;
    }
    [[nodiscard]] bool is_active(const entry& set) const noexcept {
        return std::ranges::any_of(active_, [&](const auto& each) { return each.get() == &set; });
    }
    // True: it has ended.
    bool send_plain(entry& set, unsigned& left, jaus::message_sink out) {
        while (left != 0 && is_active(set) && set.sender.next(out)) --left;
        set.next = next_beat_;
        return set.sender.sent() == set.sender.packets();
    }
    bool send_awaited(entry& set, time_point now, unsigned& left, jaus::message_sink out) {
        if (!set.outcome && !send_acknowledged(set, now, left, out)) set.outcome = jaus::delivered::timed_out;
        return set.outcome.has_value();
    }
    void set_next_event() noexcept {
        next_ = choose_at_;
        for (const auto& each : active_) next_ = std::min(next_, std::max(each->next, next_beat_));
    }

    /// False if all attempts of a packet are made.
    bool send_acknowledged(entry& set, time_point now, unsigned& left, jaus::message_sink out) {
        if (set.is_sent_again && !is_known_still(set, now)) return false;
        const auto last = set.packets.size() - 1;
        while (set.first_open != last && set.packets[set.first_open].acknowledged) ++set.first_open;
        const auto behind = set.first_open == 0 ? std::size_t{1} : set.first_open == last ? last + 1 : last;
        set.next = saturating_add(now, pacing_.retry.interval);
        for (auto i = set.first_open; i != behind; ++i) {
            auto& packet = set.packets[i];
            if (packet.acknowledged) continue;
            if (packet.tries == 0 || packet.due <= now) {
                if (left == 0) {
                    set.next = now + beat;
                    break;
                }
                if (!pacing_.retry.allows_another(packet.sent)) return false;
                if (i != 0 && packet.tries == tries_until_restart && may_restart(set, now)) {
                    restart(set);
                    set.next = now;
                    return true;
                }
                --left;
                // Each repeat of the first packet has the flag first: the receiver may not have the data set yet.
                if (i == 0) set.sender.restart();
                if (i == last && !set.last_sent_at) set.last_sent_at = now;
                const bool again = packet.tries != 0;
                ++packet.sent;
                ++packet.tries;
                const bool is_doubted = packet.is_alike && !again;
                packet.due = saturating_add(now, is_doubted ? beat : pacing_.retry.interval);
                if (again && i != 0)
                    static_cast<void>(set.sender.repeat(i, out)); // the packet was sent before
                else
                    set.sender.next(out);
                if (!is_active(set)) return true; // cleared by a handler
            }
            set.next = std::min(set.next, packet.due);
        }
        return true;
    }
    [[nodiscard]] bool may_restart(const entry& set, time_point now) const noexcept {
        return set.restarts < (pacing_.retry.attempts - 1) / tries_until_restart && is_known_still(set, now);
    }
    [[nodiscard]] static bool is_known_still(const entry& set, time_point now) noexcept {
        return !set.last_sent_at || now - *set.last_sent_at < latest_resent;
    }
    static void restart(entry& set) noexcept {
        ++set.restarts;
        set.is_sent_again = set.last_sent_at.has_value();
        set.acknowledged = set.first_open = 0;
        for (auto& packet : set.packets) packet.tries = 0, packet.acknowledged = false;
    }
    void end(const std::shared_ptr<entry>& ended, time_point now) {
        auto& set = *ended;
        note({.head = set.head,
              .since = now,
              .pause = pause_after(set),
              .known_since = set.last_sent_at ? std::optional{now} : std::nullopt,
              .digest = set.digest,
              .digests = std::move(set.digests)});
        waiting_ -= set.body.size();
        std::erase(active_, ended);
        if (!sets_.empty()) choose_at_ = now;
    }

    [[nodiscard]] duration pause_after(const entry& set) const noexcept {
        if (set.packets.empty()) return pacing_.pause;
        // Packets may be in transit, and afterwards their acknowledgements.
        if (set.outcome == jaus::delivered::timed_out) return saturating_add(pacing_.pause, pacing_.pause);
        const bool repeated =
            std::ranges::any_of(set.packets, [](const auto& p) { return p.sent > (p.is_alike ? 2U : 1U); });
        const bool is_clean = set.outcome == jaus::delivered::acknowledged && !repeated;
        return is_clean ? short_pause : pacing_.pause;
    }

    void note(rest made) {
        const auto before = std::ranges::find_if(rests_, [&](const rest& one) {
            return one.head.command_code == made.head.command_code && one.head.source == made.head.source &&
                   one.head.destination == made.head.destination;
        });
        if (before == rests_.end()) return rests_.push_back(std::move(made));
        if (!made.known_since && before->known_since) { // its packets have made the receiver remember the previous one
            made.known_since = made.since;
            made.digest = before->digest;
        }
        *before = std::move(made);
    }

    std::size_t most_;
    large_data_pacing pacing_;
    std::size_t waiting_{};
    time_point next_{time_point::max()};
    time_point choose_at_{time_point::max()}; ///< when a waiting data set may become active
    time_point next_beat_{time_point::min()};
    time_point begins_at_{time_point::min()};
    std::deque<std::unique_ptr<entry>> sets_{};
    std::vector<std::shared_ptr<entry>> active_{}; ///< being sent, at most one to each node
    std::vector<rest> rests_{};
    unsigned clears_{}; ///< calls of clear(), which handlers may make
};

} // namespace jauscat::net::detail
