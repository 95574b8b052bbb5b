// The operator's side of a session with one component of a robot: control, commands, questions, heartbeats.
#pragma once
#include "support/event.hpp"
#include "support/live_node.hpp"
#include "support/repeated_lines.hpp"
#include <jauscat/app/component.hpp>
#include <jauscat/net/config/jaus_config.hpp>

#include <boost/asio/io_context.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
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
    /// are sent once. `type`: by default that of the configuration. `feed`: of a live view, or nullptr.
    operator_unit(const net::jaus_config& config, const jaus::address& robot, const jauscat::retry_policy& retry,
                  bool acknowledged, std::optional<jaus::subsystem_type> type = {}, net::live_feed* feed = nullptr);

    /// Waits for a heartbeat of any component of the robot. False: none arrived.
    bool hear_robot(milliseconds patience);
    /// Requests control of the robot. False: it is refused, or there is no answer.
    bool take_control(std::uint8_t authority);
    [[nodiscard]] bool has_lost_control() const noexcept { return has_lost_control_; }
    /// Sends an order and waits until it is acknowledged, and for the report if it is a query. Silence is a failure,
    /// unless its caller checks whether the order was executed.
    reply give(const order& what, bool may_be_obeyed_silently = false);
    /// For a peer that has executed a command without an acknowledgement: none is requested from now on.
    void expect_no_acknowledgements() noexcept { acknowledged_ = false; }
    /// The body of the report to the last answered query.
    [[nodiscard]] bytes report() const noexcept { return report_; }
    /// Continues to receive from the robot, and to control it; ends when control is lost.
    void hold(milliseconds how_long);
    /// Releases control if it is held, also after Ctrl-C. False: it was not acknowledged.
    bool finish();

  private:
    using error_code = boost::system::error_code;

    [[nodiscard]] bool holds() const noexcept { return has_control_ && control_.is_held(); }
    jauscat::node_options node_options(const net::jaus_config& config, std::optional<jaus::subsystem_type> type);
    [[nodiscard]] net::live_state live_state() const;
    void on_control(error_code error, jauscat::control made);
    void sent(bytes message);
    void seen(const jaus::address& component, const jaus::header& head, bytes body);
    void robot_is_there(const jaus::address& who, bool is_there);
    bool work(const std::function<bool()>& done, const std::function<bool()>& given_up);
    void wait(const std::function<bool()>& done);
    bool wait(const std::function<bool()>& done, jauscat::duration how_long);
    reply exchange(const order& what);
    [[nodiscard]] bool is_of_robot(const jaus::address& who) const noexcept;
    [[nodiscard]] std::string part_of_robot() const;
    [[nodiscard]] bool is_robot_gone() const;
    void will_send(std::uint16_t command_code);
    void tell_copies() const;
    [[nodiscard]] std::string hint() const;
    void tell_unanswered() const;
    void tell_loss();
    void tell_why();

    jaus::address self_, robot_, heard_{};
    jauscat::retry_policy retry_;
    bool acknowledged_;
    bool quiet_{};
    bool has_spoken_{}; ///< a message of the robot's component has come

    // What the message that was sent last has come to.
    std::uint16_t sent_code_{};
    std::uint32_t copies_{};
    std::optional<error_code> outcome_{}, release_outcome_{};
    std::vector<std::byte> report_{};

    bool asks_control_{}, is_refused_{}, has_control_{}, is_taken_away_{}, has_lost_control_{};
    std::uint64_t heartbeats_{};
    std::vector<jaus::address> present_{}; ///< of the robot's components, those whose heartbeats come
    example::repeated_lines log_lines_{};

    boost::asio::io_context context_{};
    jauscat::node node_;
    jauscat::component unit_;
    net::jaus_config config_;
    example::live_reporter reporter_;
    jauscat::control control_{};
};

} // namespace ocu
