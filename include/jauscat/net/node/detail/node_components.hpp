// The components of one program: delivers messages and large data sets, and calls due components.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/message/ignored_bits.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/jaus/routing/liveness_table.hpp>
#include <jauscat/net/config/jaus_node_options.hpp>
#include <jauscat/net/config/jausip.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/node/detail/attached_component.hpp>
#include <jauscat/net/node/detail/default_answers.hpp>
#include <jauscat/net/node/detail/large_data_memory.hpp>
#include <jauscat/net/node/detail/large_data_queue.hpp>
#include <jauscat/net/node/detail/peer_watch.hpp>
#include <jauscat/schema/jaus/catalog.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// `0x0405`, for logs.
inline std::string in_hex(std::uint32_t number) {
    std::array<char, 12> text{};
    std::snprintf(text.data(), text.size(), "0x%04X", unsigned{number});
    return text.data();
}
/// `Set Wrench Effort (0x0405) 1.1.32.1 -> 2.1.33.1`, for logs.
inline std::string in_text(const jaus::header& head) {
    const auto name = jaus::standard_name(head.command_code);
    const auto code = in_hex(head.command_code);
    return (name.empty() ? "command code " + code : std::string{name} + " (" + code + ")") + ' ' +
           to_jausip(head.source) + " -> " + to_jausip(head.destination);
}

/// Time of processing of a message, and its time in the queue before.
struct arrival {
    time_point now{};
    duration waited{};
};

/// A component's number is its position in the order of addition.
class node_components {
  public:
    using bytes = std::span<const std::byte>;

    node_components(const jaus_node_options& options, limited_log& log)
        : options_{options}, log_{log}, peers_{options.timeout} {}

    /// `answers` gets what component and application do not handle.
    void add(const attached_component& component, std::unique_ptr<default_answers> answers = {}) {
        all_.push_back({.it = component, .answers = std::move(answers)});
    }
    void remove(const jaus::address& self) {
        std::erase_if(all_, [&](const entry& one) { return one.it.self == self; });
    }
    void replace(std::size_t place, const attached_component& component) { all_[place] = {.it = component}; }
    [[nodiscard]] std::vector<jaus::address> addresses() const {
        std::vector<jaus::address> list;
        for (const auto& one : all_) list.push_back(one.it.self);
        return list;
    }

    /// Allocates memory for large data sets: up to 64 KiB for the node manager, which is the first component if there
    /// is one, equal parts of the rest for the others. `present`: the node manager's table of live components, or
    /// nullptr.
    void start(std::size_t memory, const jaus::liveness_table* present) {
        const bool first_is_manager = present != nullptr;
        const std::size_t of_manager = first_is_manager ? std::min(memory / 4, std::size_t{64} << 10U) : 0;
        const std::size_t others = std::max<std::size_t>(all_.size() - (first_is_manager ? 1 : 0), 1);
        for (std::size_t i = 0; i != all_.size(); ++i)
            all_[i].large = std::make_unique<large_data_memory>(
                options_.large_data_sets, first_is_manager && i == 0 ? of_manager : (memory - of_manager) / others,
                options_.large_data_timeout,
                jaus::reassembly_limits{.linger_of_copies = options_.large_data_pause / 4 * 3,
                                        .linger_of_repeats = large_data_queue::memory,
                                        .longest_gap = longest_gap()});
        constexpr jaus::address all{255, 255, 255, 255};
        for (auto& one : all_)
            if (one.answers) one.answers->subscriptions().on_lost(all);
        stale_at_ = time_point::max();
        peers_.clear();
        present_ = present;
        going_ = true;
    }
    /// No delivery from now on.
    void stop() noexcept { going_ = false; }

  private:
    [[nodiscard]] auto report_lost(time_point now, const jaus::address& self) {
        return [this, now, &self](const jaus::partial_data_set& set) {
            log_(now, [&] {
                const auto first = std::to_string(set.header.sequence_number);
                return in_text(set.header) + ": at " + to_jausip(self) + ": a large data set is dropped after " +
                       std::to_string(set.packets) + " packets: " +
                       (!set.begun ? "its packet 0 has not come, the first was " + first +
                                         "; a set is numbered from 0, also in a service connection"
                        : set.last ? std::to_string(*set.last + std::size_t{1} - set.packets) + " of it have not come"
                                   : std::string{"its last packet has not come, or another set follows"});
            });
        };
    }

  public:
    /// Delivers a message, or a packet of a large data set. A packet is acknowledged when it is stored. The last
    /// packet, and one that completes the data set, get the outcome of the delivery.
    void hand_on(std::uint16_t to, const jaus::header& head, bytes body, const arrival& at, jaus::message_sink out) {
        if (!going_ || peers_.heard(head, at.now)) return;
        if (head.data_flag == jaus::data_flag::only || jaus::is_acknowledgement(head)) {
            give(all_[to], head, body, at.now, out);
            return;
        }
        if (at.waited > longest_gap()) { // its sender may have started the next data set
            log_(at.now, [&] { return in_text(head) + ": dropped: waited in the socket for " + in_ms(at.waited); });
            return;
        }
        hand_on_packet(all_[to], head, body, at, out);
    }

    void on_time(time_point now, jaus::message_sink out) {
        for (auto& one : all_) {
            one.changed = true;
            if (!going_) continue;
            one.it.on_time(now, out);
            if (!one.answers) continue;
            one.answers->subscriptions().on_time(now, out);
            one.answers->subscriptions().look(now, out);
        }
        if (going_) watch_peers(now, out);
        if (!going_ || now < stale_at_) return;
        stale_at_ = time_point::max();
        for (auto& one : all_) {
            (*one.large)->on_time(now, report_lost(now, one.it.self));
            for (const auto& set : (*one.large)->places())
                if (set.packets != 0)
                    stale_at_ = std::min(stale_at_, saturating_add(set.last_heard_at, options_.large_data_timeout));
        }
    }
    /// Queries only components that were called or have sent: next_event searches all that a component waits for.
    [[nodiscard]] std::optional<time_point> next_event() {
        time_point next = std::min(stale_at_, peers_.next_event().value_or(time_point::max()));
        for (auto& one : all_) {
            if (std::exchange(one.changed, false)) {
                one.next = one.it.next_event().value_or(time_point::max());
                if (one.answers)
                    one.next =
                        std::min(one.next, one.answers->subscriptions().next_event().value_or(time_point::max()));
            }
            next = std::min(next, one.next);
        }
        return next == time_point::max() ? std::nullopt : std::optional{next};
    }
    /// A component has sent: its next event may be earlier.
    void sends(const jaus::address& who) noexcept {
        for (auto& one : all_)
            if (one.it.self == who) one.changed = true;
    }
    void on_lost(const jaus::address& who) {
        peers_.forget(who);
        report_lost_components(who);
    }

  private:
    [[nodiscard]] duration longest_gap() const noexcept { return options_.large_data_pause / 4; }
    [[nodiscard]] static std::string in_ms(duration t) {
        return std::to_string(t / std::chrono::milliseconds{1}) + " ms";
    }

    /// A delivered large data set.
    struct whole_set {
        jaus::address source{};
        std::uint16_t command_code{};
        bool taken{};
        std::uint64_t digest{};
        time_point until{};
    };
    struct entry {
        attached_component it;
        std::unique_ptr<default_answers> answers{};
        std::unique_ptr<large_data_memory> large{};
        std::vector<whole_set> whole{}; ///< the last one of each source and code, for some time
        bool changed{true};             ///< since the last query of `next`
        time_point next{};              ///< its next event
    };

    void report_lost_components(const jaus::address& who) {
        for (auto& one : all_) {
            one.changed = true;
            if (!going_) continue;
            one.it.on_lost(who);
            if (one.answers) one.answers->subscriptions().on_lost(who);
        }
    }
    void watch_peers(time_point now, jaus::message_sink out) {
        const auto is_known = [&](const jaus::address& peer) {
            bool any = false;
            if (present_ != nullptr) present_->for_each([&](const jaus::address& who) { any = any || who == peer; });
            return any;
        };
        peers_.on_time(now, is_known, out, [&](const jaus::address& gone) {
            if (!going_) return;
            log_(now, [&] { return to_jausip(gone) + " does not answer any more: it counts as lost"; });
            report_lost_components(gone);
        });
    }
    [[nodiscard]] bool is_here(const jaus::address& who) const noexcept {
        return std::ranges::any_of(all_, [&](const entry& one) { return one.it.self == who; });
    }

    void hand_on_packet(entry& receiver, const jaus::header& head, bytes body, const arrival& at,
                        jaus::message_sink out) {
        using jaus::reassembled;
        const time_point now = at.now;
        std::erase_if(receiver.whole, [&](const whole_set& one) { return one.until <= now; });
        bool has_outcome = true;
        const auto whole = [&](const jaus::header& first, bytes complete) {
            has_outcome = hand_on_whole(receiver, head, first, complete, now, out);
        };
        const auto what =
            (*receiver.large)->on_packet(head, body, now - at.waited, whole, report_lost(now, receiver.it.self));
        if (what == reassembled::no_capacity || what == reassembled::too_large)
            log_(now, [&] { return in_text(head) + ": refused: " + std::string{describe(what)}; });
        if (what == reassembled::waiting || what == reassembled::doubtful)
            stale_at_ = std::min(stale_at_, saturating_add(now, options_.large_data_timeout));
        if (!is_acknowledged(head) || !has_outcome) return;
        if (const auto before = find_whole(receiver, head); before != receiver.whole.end())
            before->until = saturating_add(now, large_data_queue::memory);
        if (const auto answer = answer_to(receiver, head, what))
            static_cast<void>(jaus::acknowledge(head, receiver.it.self, *answer, out)); // its header was received
    }
    [[nodiscard]] static bool is_acknowledged(const jaus::header& head) noexcept {
        return head.ack_nak == jaus::ack_nak::request && jaus::names_one_component(head.destination);
    }
    /// False: not delivered, because a repeat could not be detected; the sender will repeat it.
    bool hand_on_whole(entry& receiver, const jaus::header& last, jaus::header first, bytes complete, time_point now,
                       jaus::message_sink out) {
        const auto before = find_whole(receiver, last);
        const auto digest = is_acknowledged(last) ? digest_of(complete) : 0;
        if (is_acknowledged(last) && before != receiver.whole.end() && before->digest == digest)
            return true; // its sender has not received the outcome
        if (before != receiver.whole.end()) receiver.whole.erase(before);
        if (is_acknowledged(last) && !has_place(receiver, last.source)) return false;
        first.ack_nak = jaus::ack_nak::none;
        first.data_flag = jaus::data_flag::only;
        const auto what = give(receiver, first, complete, now, out);
        const bool taken = what == jaus::component_outcome::handled || what == jaus::component_outcome::deferred;
        if (is_acknowledged(last))
            receiver.whole.push_back(
                {last.source, last.command_code, taken, digest, saturating_add(now, large_data_queue::memory)});
        return true;
    }
    [[nodiscard]] static bool has_place(const entry& receiver, const jaus::address& source) {
        const auto is_its = [&](const whole_set& one) { return jaus::are_of_one_node(one.source, source); };
        return receiver.whole.size() < max_complete &&
               std::cmp_less(std::ranges::count_if(receiver.whole, is_its), jaus::peer_share(max_complete));
    }
    [[nodiscard]] static std::vector<whole_set>::iterator find_whole(entry& receiver, const jaus::header& head) {
        return std::ranges::find_if(receiver.whole, [&](const whole_set& one) {
            return one.source == head.source && one.command_code == head.command_code;
        });
    }
    /// The answer to a packet, if any: its sender repeats an unanswered one.
    static std::optional<jaus::ack_nak> answer_to(entry& receiver, const jaus::header& head, jaus::reassembled what) {
        using enum jaus::reassembled;
        if (what == too_large) return jaus::ack_nak::nak;
        if (what == waiting || what == repeated)
            if (const auto* const set = (*receiver.large)->incomplete(head)) {
                const bool ends = head.data_flag == jaus::data_flag::last;
                return set->begun && !ends ? std::optional{jaus::ack_nak::ack} : std::nullopt;
            }
        if (what != whole && what != repeated) return std::nullopt;
        const auto one = find_whole(receiver, head);
        if (one == receiver.whole.end()) return std::nullopt;
        return one->taken ? jaus::ack_nak::ack : jaus::ack_nak::nak;
    }

    jaus::component_outcome give(entry& receiver, const jaus::header& head, bytes body, time_point now,
                                 jaus::message_sink out) {
        using enum jaus::component_outcome;
        auto& to = receiver.it;
        receiver.changed = true;
        const auto rest = [&](const jaus::header& h, bytes b) { return receiver.answers->on_message(h, b, now, out); };
        if (going_ && options_.on_received) options_.on_received(to.self, head, body);
        const auto what =
            to.on_message(head, body, now, out,
                          receiver.answers ? attached_component::unhandled{rest} : attached_component::unhandled{});
        if (receiver.answers) receiver.answers->subscriptions().look(now, out);
        if ((what == handled || what == deferred) && peer_watch::binds(head.command_code) && !is_here(head.source) &&
            !peers_.bind(head.source, to.self, now))
            log_(now, [&] {
                return in_text(head) + ": its sender is not watched: too many peers are, of its node or of all";
            });
        if (what == handled || what == deferred) note_ignored_bits(head, body, now);
        constexpr std::array unremarkable{handled, deferred, acknowledgement, repeated, pending};
        if (std::ranges::find(unremarkable, what) == unremarkable.end())
            log_(now, [&] {
                const auto line = in_text(head) + ": at " + to_jausip(to.self) + ": " + std::string{describe(what)};
                const auto why = what == malformed && options_.explain_malformed
                                     ? options_.explain_malformed(head.command_code, body)
                                     : std::string{};
                return why.empty() ? line : line + ": " + why;
            });
        if (going_ && options_.on_message) options_.on_message(to.self, head, body, what);
        return what;
    }
    // Once for each sender and code: a peer that sets such bits sets them in every message.
    void note_ignored_bits(const jaus::header& head, bytes body, time_point now) {
        const auto bits = jaus::ignored_presence_bits(head.command_code, body);
        if (bits == 0) return;
        const std::pair one{head.source, head.command_code};
        if (std::ranges::find(noted_, one) != noted_.end()) return;
        if (noted_.size() == max_noted) noted_.clear();
        noted_.push_back(one);
        log_(now, [&] { return in_text(head) + ": presence bits without a field are ignored: " + in_hex(bits); });
    }
    static constexpr std::size_t max_complete = 256, max_noted = 256;

    const jaus_node_options& options_;
    limited_log& log_;
    std::vector<entry> all_{};
    peer_watch peers_;
    std::vector<std::pair<jaus::address, std::uint16_t>> noted_{}; ///< who sends bits without a field in which message
    const jaus::liveness_table* present_{};
    time_point stale_at_{time_point::max()}; ///< when a large data set may have to be discarded
    bool going_{};
};

} // namespace jauscat::net::detail
