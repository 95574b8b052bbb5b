// A component of a node behind its handle: the state machines of jaus/ with functions instead of template parameters.
#pragma once
#include <jauscat/app/component_options.hpp>
#include <jauscat/app/detail/unit.hpp>
#include <jauscat/app/impl/node_context.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/jaus/message/hook.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// A function that is called periodically.
struct periodic_function {
    duration period{};
    std::function<void()> call{};
    time_point due{};
};

class clients;

/// A node_component of net/: the node refers to it as long as it lives, the handle as long as the application wants it.
class component_state {
  public:
    component_state(node_state& node, const jaus::address& self, component_options options);
    ~component_state();
    component_state(const component_state&) = delete;
    component_state& operator=(const component_state&) = delete;

    void take(taken_message message);
    void give(given_report report);
    void ready();
    void fail(std::string_view why);
    void reject_control();
    void changed();
    /// Builds the state machines for what has been registered. `identity`: by the configuration. `beats`: it sends
    /// heartbeats to the node manager, which is in another program.
    void start(const jaus::identity& identity, bool beats, time_point now);
    /// Brings the actuators to rest; no function of the application is called afterwards until `start`.
    void stop() noexcept;
    /// The application's handle has gone: as if the component were not there.
    void close() noexcept;

    [[nodiscard]] jaus::primary_status_code state() const noexcept;
    [[nodiscard]] std::optional<jaus::address> controller() const noexcept;
    [[nodiscard]] bool is_running() const noexcept { return is_running_; }
    [[nodiscard]] bool is_closed() const noexcept { return closed_; }
    /// The node has ended.
    void lose_node() noexcept { node_ = nullptr; }
    [[nodiscard]] bool has_node() const noexcept { return node_ != nullptr; }
    /// A function of the application may be active.
    [[nodiscard]] bool is_in_turn() const noexcept { return in_turn_; }
    /// Where the configuration does not name the component.
    [[nodiscard]] jaus::identity identity() const noexcept {
        return {.identification = options_.name, .type = 60001, .authority_code = options_.authority};
    }
    /// While it runs.
    [[nodiscard]] node_state& node() noexcept { return *node_; }
    [[nodiscard]] clients& others() noexcept;
    /// The node works: tells the application what the component has become.
    void begin();
    void on_appeared(const jaus::address& who); ///< a component of the network
    /// A large data set of this component was acknowledged, or not.
    void on_large_delivered(const jaus::header& head, jaus::delivered what);
    /// Outlives the node.
    [[nodiscard]] const std::shared_ptr<node_context>& context() const noexcept { return context_; }
    /// The header of a message to another component.
    [[nodiscard]] jaus::header head_of(std::uint16_t command_code, const jaus::address& to) const noexcept {
        return {.experimental = jaus::is_private(command_code),
                .command_code = command_code,
                .destination = to,
                .source = self_};
    }
    /// Sends a whole message of this component until it is acknowledged.
    result<std::uint16_t, jaus::send_error> send_acknowledged(bytes message);
    /// Sends it no more, if it still waits for its acknowledgement.
    void forget(const jaus::header& sent) noexcept;
    /// Whether the configuration has a system for it.
    [[nodiscard]] bool is_routable(const jaus::address& to) const;

    // As a component of net/.
    [[nodiscard]] const jaus::address& self() const noexcept { return self_; }
    jaus::component_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out,
                                       jaus::hook<jaus::message_outcome(const jaus::header&, bytes)> unhandled);
    void on_time(time_point now, jaus::message_sink out);
    [[nodiscard]] std::optional<time_point> next_event() const;
    void on_lost(const jaus::address& who);
    using listing = jaus::hook<void(const jaus::supported_message&)>;
    void list_messages(listing takes, listing sends) const;

    std::function<void()> on_stopped{}, on_ready{};
    std::function<void(bool begins)> on_emergency{};
    std::function<void(const std::optional<jaus::address>& by)> on_controlled{};
    std::function<jaus::message_outcome(const jaus::header& head, bytes body)> on_others{};
    std::vector<periodic_function> periodic{};
    std::vector<std::byte> lists{};  ///< memory for the lists of the message that is handled
    std::string malformed_because{}; ///< of the last malformed message
    bool is_added{};                 ///< the node has it

  private:
    struct core;

    jaus::message_outcome handle(const jaus::header& head, bytes body);
    jaus::message_outcome write(const given_report& report, const report_request& request);
    void send_changes(time_point now, jaus::message_sink out);
    void note_state(jaus::primary_status_code from, jaus::primary_status_code to);
    void note_controller(const std::optional<jaus::controller>& by, jaus::control_change why);
    void tell_stopped() noexcept;
    /// Does what functions of the application have asked for while the state machines were at work.
    void settle();
    /// After a turn: settles, and sends the events of what has changed.
    void end_turn(time_point now, jaus::message_sink out);
    /// Calls a function of the application. An exception is logged, and the component fails.
    /// `command_code`: of the message that follows `what` in the log; 0: none.
    bool guard(std::string_view what, std::uint16_t command_code, jaus::hook<void()> call) noexcept;
    bool guard(std::string_view what, const std::function<void()>& call) noexcept;
    auto in_turn(auto&& work);
    [[nodiscard]] const given_report* report_of(std::uint16_t command_code) const;

    std::shared_ptr<boost::asio::io_context> own_context_; ///< of the node, if it has one
    node_state* node_;                                     ///< nullptr: it has ended
    std::shared_ptr<node_context> context_;
    jaus::address self_;
    component_options options_;
    std::vector<taken_message> takes_{};
    std::vector<given_report> gives_{};
    std::vector<std::byte> body_{}; ///< of the last report
    std::unique_ptr<core> core_{};
    bool is_running_{};
    bool is_ready_{}; ///< says the application
    bool has_failed_{};
    bool has_changed_{}; ///< data of reports, perhaps: a function of the application was called
    bool closed_{};
    bool is_stopping_{};
    bool in_turn_{};
    std::optional<jaus::address> controller_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
