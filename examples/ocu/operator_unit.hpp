// The operator's side of a session with one component of a robot: control, commands, questions, heartbeats.
#pragma once
#include "support/event.hpp"
#include "support/repeated_lines.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/jaus/component/held_control.hpp>
#include <jauscat/net.hpp>

#include <functional>
#include <string>
#include <vector>

namespace ocu {

namespace jaus = jauscat::jaus;
namespace net = jauscat::net;

/// A message to the robot.
struct order {
    std::uint16_t command_code{};
    std::vector<std::byte> body{};
};
/// How it was answered.
enum class reply : std::uint8_t {
    taken,    ///< acknowledged; a query: its report is there
    sent,     ///< and no acknowledgement was requested
    refused,  ///< NAK
    silence,  ///< no answer to any of its copies
    not_sent, ///< it cannot be sent
    stopped,  ///< by the user
};

/// A line that begins with FAILED or LOST is bad news, one that begins with OK good.
void say(example::event_kind kind, const example::event_members& members, const std::string& line);

/// A JAUS component on a node of its own. Each call lets the node work until there is an answer, or none is to be
/// expected any more, or the user stops the program; what happens meanwhile comes out as lines.
class operator_unit {
  public:
    using bytes = std::span<const std::byte>;
    using milliseconds = std::chrono::milliseconds;

    /// `retry`: of a message that must be answered. `acknowledged`: messages ask for an acknowledgement; else commands
    /// are sent once.
    operator_unit(const net::jaus_config& config, const jaus::address& robot, const jauscat::retry_policy& retry,
                  bool acknowledged);

    /// Waits for a heartbeat of any component of the robot. False: none arrived.
    bool hear_robot(milliseconds patience);
    /// Requests control of the robot. False: it is refused, or there is no answer.
    bool take_control(std::uint8_t authority);
    [[nodiscard]] bool has_lost_control() const noexcept;
    /// Sends an order and waits until it is acknowledged, and for the report if it is a query. Silence is a failure,
    /// unless its caller checks whether the order was executed.
    reply give(const order& what, bool may_be_obeyed_silently = false);
    /// For a peer that has executed a command without an acknowledgement: none is requested from now on.
    void expect_no_acknowledgements() noexcept { acknowledged_ = false; }
    /// The body of the report to the last answered query.
    [[nodiscard]] bytes report() const { return report_.value(); }
    /// Continues to receive from the robot, and to control it; ends when control is lost.
    void hold(milliseconds how_long);
    /// Releases control if it is held, also after Ctrl-C. False: it was not acknowledged.
    bool finish();

  private:
    using control_state = jaus::control_state;

    struct application_type {
        jaus::message_outcome operator()(const jaus::header& head, bytes body) const noexcept;
    };
    /// Shows sent messages.
    struct shown_output {
        operator_unit& mine;
        void operator()(bytes message) const;
    };

    [[nodiscard]] bool holds() const noexcept { return held_.state() == control_state::held; }
    net::jaus_node_options node_options();
    void on_delivered(const jaus::awaited_message& m, jaus::delivered what);
    void seen(const jaus::address& component, const jaus::header& head, bytes body);
    void robot_is_there(const jaus::address& who, bool is_there);
    bool work(const std::function<bool()>& done, const std::function<bool()>& given_up);
    void wait(const std::function<bool()>& done);
    bool wait(const std::function<bool()>& done, jauscat::duration how_long);
    reply exchange(const order& what);
    bool send(bytes message);
    [[nodiscard]] bool is_of_robot(const jaus::address& who) const noexcept;
    [[nodiscard]] std::string part_of_robot() const;
    [[nodiscard]] bool is_robot_gone() const;
    void wait_for_report(bytes message);
    [[nodiscard]] std::string hint() const;
    void tell_control();
    void tell_why();

    jaus::address self_, robot_, manager_of_robot_, heard_{manager_of_robot_};
    jauscat::retry_policy retry_;
    bool acknowledged_;
    boost::asio::io_context context_{};

    // What the message that was sent last has come to.
    std::uint16_t number_{}, awaited_report_{};
    std::optional<jaus::delivered> outcome_{};
    std::optional<std::vector<std::byte>> report_{};

    control_state told_state_{};
    bool quiet_{};
    std::uint64_t heartbeats_{};
    example::repeated_lines log_lines_{};

    application_type application_{};
    shown_output out_{*this};
    std::array<std::byte, 512> services_{};
    jaus::component_memory<16, jaus::header_size + jaus::max_body_size> memory_{};
    jaus::held_control held_;
    jaus::described_component described_;
    jaus::component<jaus::held_control, jaus::described_component> core_;
    net::jaus_node node_;
};

} // namespace ocu
