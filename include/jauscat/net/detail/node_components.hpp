// The components of one program: messages and large data sets are handed to them, and they are driven.
#pragma once

#include <jauscat/jaus/answer.hpp>
#include <jauscat/jaus/later.hpp>
#include <jauscat/jaus/presence_table.hpp>
#include <jauscat/net/detail/attached_component.hpp>
#include <jauscat/net/detail/large_data_memory.hpp>
#include <jauscat/net/detail/peer_watch.hpp>
#include <jauscat/net/jaus_node_options.hpp>
#include <jauscat/net/jausip.hpp>
#include <jauscat/net/limited_log.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace jauscat::net::detail {

/// `command code 0x0405 1.1.32.1 -> 2.1.33.1`, for logs.
inline std::string in_text(const jaus::header& head) {
    std::array<char, 8> code{};
    std::snprintf(code.data(), code.size(), "0x%04X", unsigned{head.command_code});
    return std::string{"command code "} + code.data() + ' ' + to_jausip(head.source) + " -> " +
           to_jausip(head.destination);
}

/// A component's number is its place in the order in which they were added.
class node_components {
  public:
    using time = std::chrono::nanoseconds;
    using bytes = std::span<const std::byte>;

    node_components(const jaus_node_options& options, limited_log& log)
        : options_{options}, log_{log}, peers_{options.patience} {}

    void add(attached_component component) { all_.push_back({.it = std::move(component)}); }
    void replace(std::size_t place, attached_component component) { all_[place] = {.it = std::move(component)}; }
    [[nodiscard]] std::vector<jaus::address> addresses() const {
        std::vector<jaus::address> list;
        for (const auto& one : all_) list.push_back(one.it.self);
        return list;
    }

    /// Memory for large data sets anew: up to 64 KiB for the node manager, which is the first component if there is
    /// one, equal parts of the rest for the others. `present`: whom the node manager hears, or nullptr.
    void start(std::size_t memory, const jaus::presence_table* present) {
        const bool first_is_manager = present != nullptr;
        const std::size_t of_manager = first_is_manager ? std::min(memory / 4, std::size_t{64} << 10U) : 0;
        const std::size_t others = std::max<std::size_t>(all_.size() - (first_is_manager ? 1 : 0), 1);
        for (std::size_t i = 0; i != all_.size(); ++i)
            all_[i].large = std::make_unique<large_data_memory>(
                options_.large_data_sets, first_is_manager && i == 0 ? of_manager : (memory - of_manager) / others,
                options_.large_data_patience);
        stale_at_ = time::max();
        peers_.clear();
        present_ = present;
        going_ = true;
    }
    /// No component gets anything from now on.
    void stop() noexcept { going_ = false; }

  private:
    [[nodiscard]] auto tell_lost(time now, const jaus::address& self) {
        return [this, now, &self](const jaus::partial_data_set& set) {
            log_(now, [&] {
                return in_text(set.header) + ": at " + to_jausip(self) + ": a large data set is given up, of which " +
                       std::to_string(set.packets) + " packets came";
            });
        };
    }

  public:
    /// A message or a packet of a large data set, whose packets are acknowledged one by one: the last with what the
    /// component makes of the whole.
    void hand_on(std::uint16_t to, const jaus::header& head, bytes body, time now, jaus::message_sink out) {
        if (!going_ || peers_.heard(head, now)) return;
        if (head.data_flag == jaus::data_flag::only || jaus::is_acknowledgement(head)) {
            give(all_[to], head, body, now, out);
            return;
        }
        hand_on_packet(all_[to], head, body, now, out);
    }

    void on_time(time now, jaus::message_sink out) {
        for (auto& one : all_) {
            one.changed = true;
            if (going_) one.it.on_time(now, out);
        }
        if (going_) watch_peers(now, out);
        if (!going_ || now < stale_at_) return;
        stale_at_ = time::max();
        for (auto& one : all_) {
            (*one.large)->on_time(now, tell_lost(now, one.it.self));
            for (const auto& set : (*one.large)->places())
                if (set.packets != 0)
                    stale_at_ = std::min(stale_at_, jaus::later(set.last_heard_at, options_.large_data_patience));
        }
    }
    /// Asks those that have got, sent or done something since: each looks through all that it waits for.
    [[nodiscard]] std::optional<time> next_event() {
        time next = std::min(stale_at_, peers_.next_event().value_or(time::max()));
        for (auto& one : all_) {
            if (std::exchange(one.changed, false)) one.next = one.it.next_event().value_or(time::max());
            next = std::min(next, one.next);
        }
        return next == time::max() ? std::nullopt : std::optional{next};
    }
    /// It sends something: there may be more to do for it.
    void sends(const jaus::address& who) noexcept {
        for (auto& one : all_)
            if (one.it.self == who) one.changed = true;
    }
    void on_lost(const jaus::address& who) {
        peers_.forget(who);
        tell_components_lost(who);
    }

  private:
    struct entry {
        attached_component it;
        std::unique_ptr<large_data_memory> large{};
        std::optional<jaus::header> refused{}; ///< the packet that made a large data set whole, which was refused
        bool changed{true};                    ///< since `next` was asked for
        time next{};                           ///< when it wants to be driven
    };

    void tell_components_lost(const jaus::address& who) {
        for (auto& one : all_) {
            one.changed = true;
            if (going_) one.it.on_lost(who);
        }
    }
    void watch_peers(time now, jaus::message_sink out) {
        const auto is_known = [&](const jaus::address& peer) {
            bool any = false;
            if (present_ != nullptr)
                present_->for_each([&](const jaus::address& who) {
                    any = any || (who.subsystem == peer.subsystem && who.node == peer.node);
                });
            return any;
        };
        peers_.on_time(now, is_known, out, [&](const jaus::address& gone) {
            if (!going_) return;
            log_(now, [&] { return to_jausip(gone) + " does not answer any more: it counts as lost"; });
            tell_components_lost(gone);
        });
    }
    [[nodiscard]] bool is_here(const jaus::address& who) const noexcept {
        return std::ranges::any_of(all_, [&](const entry& one) { return one.it.self == who; });
    }

    void hand_on_packet(entry& receiver, const jaus::header& head, bytes body, time now, jaus::message_sink out) {
        using jaus::reassembled;
        bool taken = false;
        const auto whole = [&](jaus::header first, bytes complete) {
            first.ack_nak = jaus::ack_nak::none;
            first.data_flag = jaus::data_flag::only;
            taken = give(receiver, first, complete, now, out) == jaus::component_outcome::taken;
        };
        const auto what = (*receiver.large)->on_packet(head, body, now, whole, tell_lost(now, receiver.it.self));
        if (what == reassembled::no_room || what == reassembled::too_large)
            log_(now, [&] { return in_text(head) + ": refused: " + std::string{describe(what)}; });
        if (what == reassembled::waiting)
            stale_at_ = std::min(stale_at_, jaus::later(now, options_.large_data_patience));
        if (head.ack_nak != jaus::ack_nak::request || !jaus::names_one_component(head.destination)) return;
        const bool good = is_good(receiver, head, what, taken);
        jaus::acknowledge(head, receiver.it.self, good ? jaus::ack_nak::ack : jaus::ack_nak::nak, out);
    }
    /// Whether a packet gets an ACK. `taken`: what the component made of the whole.
    static bool is_good(entry& receiver, const jaus::header& head, jaus::reassembled what, bool taken) {
        auto& refused = receiver.refused;
        const bool is_of_refused =
            refused && refused->source == head.source && refused->command_code == head.command_code;
        switch (what) {
        case jaus::reassembled::whole:
            if (!taken) refused = head;
            return taken;
        case jaus::reassembled::waiting:
            if (is_of_refused) refused.reset(); // another data set
            return true;
        case jaus::reassembled::repeated: // the one that made a refused data set whole: its sender has not got the NAK
            return !is_of_refused || refused->sequence_number != head.sequence_number;
        default: return false;
        }
    }

    jaus::component_outcome give(entry& receiver, const jaus::header& head, bytes body, time now,
                                 jaus::message_sink out) {
        using enum jaus::component_outcome;
        auto& to = receiver.it;
        receiver.changed = true;
        const auto what = to.on_message(head, body, now, out);
        if ((what == taken || what == deferred) && peer_watch::binds(head.command_code) && !is_here(head.source))
            peers_.bind(head.source, to.self, now);
        constexpr std::array unremarkable{taken, deferred, acknowledgement, repeated, pending};
        if (std::ranges::find(unremarkable, what) == unremarkable.end())
            log_(now,
                 [&] { return in_text(head) + ": at " + to_jausip(to.self) + ": " + std::string{describe(what)}; });
        if (going_ && options_.seen) options_.seen(to.self, head, body, what);
        return what;
    }
    const jaus_node_options& options_;
    limited_log& log_;
    std::vector<entry> all_{};
    peer_watch peers_;
    const jaus::presence_table* present_{};
    time stale_at_{time::max()}; ///< when a large data set may have to be given up
    bool going_{};
};

} // namespace jauscat::net::detail
