// Liveness of the components that local components depend on, if no node manager receives their heartbeats.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/command_rules.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/jaus/message/stands_for.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/event.hpp>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace jauscat::net::detail {

/// The heartbeats of a node manager say nothing about the other components of its node: a component may end while its
/// node lives. A peer is therefore watched if it requests control, a service connection or events from a local
/// component, moves or stops one, or confirms its event. After a time without
/// messages it is sent a Query Heartbeat Pulse (2202h); after the timeout without any message it is lost. The number of
/// watched peers is bounded, and that of one node, see jaus::peer_share.
class peer_watch {
  public:
    static constexpr std::size_t most = 4096;

    explicit peer_watch(duration timeout) : timeout_{std::max(timeout, 3 * shortest)} {}

    /// Whether a component depends on the sender of a message that it has accepted.
    [[nodiscard]] static constexpr bool binds(std::uint16_t command_code) noexcept {
        switch (command_code) {
        case jaus::command_code_of<jaus::set_emergency>:
        case jaus::command_code_of<jaus::request_component_control>:
        case jaus::command_code_of<jaus::create_service_connection>:
        case jaus::command_code_of<jaus::create_event>:
        case jaus::command_code_of<jaus::confirm_event_request>: return true;
        default: return jaus::rule_of(command_code) == jaus::command_rule::moving;
        }
    }
    /// `component` depends on `peer` from now on. False: no place is left to watch it.
    [[nodiscard]] bool bind(const jaus::address& peer, const jaus::address& component, time_point now) {
        if (!peers_.contains(peer) && !has_place(peer)) return false;
        auto& bound = peers_.try_emplace(peer, entry{.component = component}).first->second;
        bound.heard_at = now;
        bound.due = saturating_add(now, silence());
        next_ = std::min(next_, bound.due);
        return true;
    }
    /// Call for each received message. True if it is the answer to a query of this object. A Query Heartbeat Pulse is
    /// no sign of life: the peer's own watch sends it in the name of a component that may hang.
    bool heard(const jaus::header& head, time_point now) {
        if (peers_.empty()) return false;
        const auto found = peers_.find(head.source);
        if (found == peers_.end()) return false;
        auto& peer = found->second;
        if (head.command_code == jaus::command_code_of<jaus::query_heartbeat_pulse>) return false;
        peer.heard_at = now;
        const bool answers = head.command_code == jaus::command_code_of<jaus::report_heartbeat_pulse> &&
                             !jaus::is_acknowledgement(head) && head.destination == peer.component;
        return answers && std::exchange(peer.asked, false);
    }
    /// Removes all peers that `who` covers.
    void forget(const jaus::address& who) {
        std::erase_if(peers_, [&](const auto& peer) { return jaus::stands_for(who, peer.first); });
    }
    void clear() noexcept {
        peers_.clear();
        next_ = time_point::max();
    }

    /// `is_known(peer)`: a local node manager receives the heartbeats of this component and detects its loss.
    /// `lost(peer)` is called for each lost peer.
    void on_time(time_point now, auto&& is_known, jaus::message_sink out, auto&& lost) {
        if (now < next_) return;
        next_ = time_point::max();
        for (auto at = peers_.begin(); at != peers_.end();) {
            auto& [who, peer] = *at;
            if (peer.due <= now && is_known(who)) peer.heard_at = now;
            if (now - peer.heard_at >= timeout_) {
                const auto gone = who;
                peers_.erase(at);
                lost(gone); // which may make others known, or forget them
                at = peers_.upper_bound(gone);
                continue;
            }
            if (peer.due <= now) ask(who, peer, now, out);
            next_ = std::min(next_, peer.due);
            ++at;
        }
    }
    [[nodiscard]] std::optional<time_point> next_event() const noexcept {
        return next_ == time_point::max() ? std::nullopt : std::optional{next_};
    }

  private:
    static constexpr duration shortest = std::chrono::milliseconds{1};

    struct entry {
        jaus::address component{}; ///< local, sends the query
        time_point heard_at{};
        time_point due{}; ///< time of the next check
        bool asked{};     ///< without an answer
    };
    struct by_number {
        static constexpr auto of(const jaus::address& a) noexcept {
            return std::tuple{a.subsystem, a.node, a.component, a.instance};
        }
        constexpr bool operator()(const jaus::address& a, const jaus::address& b) const noexcept {
            return of(a) < of(b);
        }
    };

    [[nodiscard]] bool has_place(const jaus::address& peer) const {
        const auto first =
            peers_.lower_bound({.instance = 0, .component = 0, .node = peer.node, .subsystem = peer.subsystem});
        const auto last =
            peers_.upper_bound({.instance = 255, .component = 255, .node = peer.node, .subsystem = peer.subsystem});
        return peers_.size() < most && std::cmp_less(std::distance(first, last), jaus::peer_share(most));
    }
    [[nodiscard]] duration silence() const noexcept { return timeout_ / 3; }
    void ask(const jaus::address& who, entry& peer, time_point now, jaus::message_sink out) const {
        const auto silent_at = saturating_add(peer.heard_at, silence());
        if (silent_at > now) {
            peer.due = silent_at;
            return;
        }
        peer.asked = true;
        peer.due = std::min(saturating_add(now, timeout_ / 12), saturating_add(peer.heard_at, timeout_));
        static_cast<void>(
            jaus::put({.destination = who, .source = peer.component}, jaus::query_heartbeat_pulse{}, out));
    }

    duration timeout_;
    std::map<jaus::address, entry, by_number> peers_{};
    time_point next_{time_point::max()};
};

} // namespace jauscat::net::detail
