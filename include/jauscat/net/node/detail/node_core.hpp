// Routing of messages to components and peers, without sockets.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/net/node/detail/large_data_queue.hpp>
#include <jauscat/net/node/detail/local_queue.hpp>
#include <jauscat/net/node/detail/node_components.hpp>
#include <jauscat/net/node/detail/node_routes.hpp>
#include <jauscat/schema/jaus/event.hpp>

#include <functional>

namespace jauscat::net::detail {

/// A message from one component of the program to another is queued until the end of the turn, so that no component is
/// called from within a call. A turn is the processing of a message from the network, or of the time.
class node_core {
  public:
    using bytes = std::span<const std::byte>;
    using send_handler = std::function<void(bytes message, const node_routes::endpoint& to, jaus::framing framing)>;

    node_core(const jaus_node_options& options, limited_log& log, send_handler send)
        : large{options.max_waiting, {options.large_data_pace, options.large_data_pause, options.large_data_retry}},
          components{options, log},
          options_{options},
          log_{log},
          send_{std::move(send)},
          local_{options.max_waiting} {}

    /// `strangers`: as in node_routes. Throws `config_error`.
    void start(const jaus_config& config, const jaus::address& manager, std::uint8_t primary,
               std::optional<duration> strangers) {
        local_.clear();
        routes_.emplace(config, components.addresses(), manager.subsystem, manager.node, strangers);
        router_.emplace(routes_->table(), primary);
    }
    [[nodiscard]] node_routes& routes() noexcept { return *routes_; }
    /// Whether a component may be active.
    [[nodiscard]] bool in_turn() const noexcept { return in_turn_; }
    /// Whether messages between components are queued.
    [[nodiscard]] bool has_more() const noexcept { return !local_.empty(); }

    /// A message of a local component.
    jaus::routing send(bytes message, time_point now) {
        const auto m = jaus::split(message);
        return m ? send(message, m.header, now) : jaus::routing{.outcome = jaus::routed::invalid_source};
    }
    /// The same; unroutable messages are logged.
    void send_or_tell(bytes message, time_point now) {
        if (const auto m = jaus::split(message))
            tell(m.header, send(message, m.header, now), now);
        else
            log_(now, [&] { return "a message of a component is not sent: " + std::string{describe(m.error)}; });
    }
    jaus::routing send(bytes message, const jaus::header& head, time_point now) {
        components.sends(head.source);
        if (options_.on_sent) options_.on_sent(message);
        const auto queue = [&](std::uint16_t component) {
            if (!local_.push(component, message))
                log_(now, [&] { return in_text(head) + ": lost: too many messages wait between components"; });
        };
        return route(message, head, jaus::here, now, queue);
    }
    /// Where a message of this node would go: nothing is sent.
    [[nodiscard]] jaus::routing route_of(const jaus::header& head) {
        return router_->route(head, jaus::here, [](std::uint16_t, const jaus::address&) {}, [](jaus::hop) {});
    }
    /// A message from the network.
    jaus::routing received(bytes message, const jaus::split_message& m, jaus::hop from, const arrival& at,
                           jaus::message_sink out) {
        to_here_.clear();
        const auto collect = [&](std::uint16_t to) { to_here_.push_back(to); };
        const auto what = route(message, m.header, from, at.now, collect);
        const auto deliver = [&] {
            for (const auto to : to_here_) hand_on(to, m.header, m.body, at, out);
        };
        turn(at.now, out, deliver);
        return what;
    }
    /// Calls `work()` in a turn of its own, and then delivers the messages between components.
    void turn(time_point now, jaus::message_sink out, jaus::hook<void()> work) {
        struct guard {
            bool& flag;
            explicit guard(bool& f) : flag{f} { flag = true; }
            ~guard() { flag = false; }
        } const busy{in_turn_};
        work();
        for (int round = 0; !local_.empty() && round != max_rounds; ++round)
            local_.hand_on([&](std::uint16_t to, bytes message) {
                const auto m = jaus::split(message);
                hand_on(to, m.header, m.body, {now, {}}, out);
            });
    }
    void tell(const jaus::header& head, const jaus::routing& what, time_point now) {
        if (what.outcome < jaus::routed::no_such_component) return;
        log_(now, [&] { return in_text(head) + ": " + std::string{describe(what.outcome)}; });
    }

    large_data_queue large;
    node_components components;

  private:
    void hand_on(std::uint16_t to, const jaus::header& head, bytes body, const arrival& at, jaus::message_sink out) {
        if (jaus::is_acknowledgement(head) && large.on_acknowledgement(head, at.now)) return;
        components.hand_on(to, head, body, at, out);
    }
    jaus::routing route(bytes message, const jaus::header& head, jaus::hop from, time_point now,
                        jaus::hook<void(std::uint16_t)> to_component) {
        return router_->route(
            head, from, [&](std::uint16_t component, const jaus::address&) { to_component(component); },
            [&](jaus::hop by) {
                const auto& to = (*routes_)[by];
                if (now <= to.quiet_after || is_answer(head)) send_(message, to.to, to.framing);
            });
    }

    // Not broadcasts, service connections and events, which are sent repeatedly without a request.
    static bool is_answer(const jaus::header& head) noexcept {
        return jaus::names_one_component(head.destination) && !head.service_connection &&
               head.command_code != jaus::command_code_of<jaus::event>;
    }

    static constexpr int max_rounds = 16; ///< of components that answer each other, so that the network is served

    const jaus_node_options& options_;
    limited_log& log_;
    send_handler send_;
    local_queue local_;
    std::optional<node_routes> routes_{};
    std::optional<jaus::router> router_{};
    std::vector<std::uint16_t> to_here_{};
    bool in_turn_{};
};

} // namespace jauscat::net::detail
