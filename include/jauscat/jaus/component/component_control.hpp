// Control of a component: request, grant, takeover, release, loss; refusal of other senders' commands. RA 3.3 part 3,
// core subgroup, and the notes on authority.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/command_rules.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <span>

namespace jauscat::jaus {

struct controller {
    jaus::address address{};       ///< of the component in control
    std::uint8_t authority_code{}; ///< 0 lowest to 255 highest, as in its request
    friend constexpr bool operator==(const controller&, const controller&) = default;
};

/// Cause of a change of the controller.
enum class control_change : std::uint8_t {
    granted,    ///< control was granted, or the controller's authority changed
    taken_over, ///< one of higher authority has it
    released,   ///< the controller has given it back
    rejected,   ///< the component has revoked it
    /// The controller, or another sender whose motion command is in force, has disappeared or was silent for the
    /// timeout: the actuators have to come to rest.
    lost,
};

/// What becomes of motion commands while no component has control. docs/safety.md has the reasons.
enum class motion_without_control : std::uint8_t {
    watched,   ///< executed; the loss of the sender is the loss of a controller
    refused,   ///< refused as not_controller; what a controller leaves in force when control ends is watched
    unwatched, ///< executed, and in force after the sender is lost
};

struct control_options {
    /// The component's own authority, until Set Component Authority.
    std::uint8_t authority_code{};
    /// User-defined codes that cause no motion: accepted from every sender, in every state. All other user-defined
    /// codes count as motion commands, see command_rules. Must outlive the component.
    std::span<const std::uint16_t> harmless{};
    /// Timeout: control is lost without a message of the controller for this time. After a quarter of it the controller
    /// is queried for its heartbeat pulse, so that an idle controller keeps control. The same holds for other senders
    /// whose motion command is in force. 0: never, only by on_lost.
    duration timeout{std::chrono::milliseconds{500}};
    /// Motion commands of senders while no component has control.
    motion_without_control without_control{};
};

/// Control of one component, component side. A request of higher authority than the controller's takes control over,
/// and the old controller gets Reject Component Control; one of equal or lower authority is answered with "control not
/// accepted". The controller may ask again, also with another authority: that is accepted and counts as life. There is
/// no queue of requests.
///
/// A sender whose motion command is in force is watched as a controller is, until the command of another sender was
/// executed in its place or the actuators are at rest: also where it has no control, or no longer. A command that waits
/// for its execution counts, too. Eight senders are watched at a time; of more, those whose commands have come
/// last.
class component_control {
  public:
    constexpr explicit component_control(const address& self, const control_options& options = {}) noexcept
        : self_{self}, authority_{options.authority_code}, options_{options} {}

    /// The controller, if any.
    [[nodiscard]] constexpr const std::optional<jaus::controller>& controller() const noexcept { return controller_; }
    /// Cause of the last change; meaningless before control was first granted.
    [[nodiscard]] constexpr control_change last_change() const noexcept { return last_change_; }
    /// The component's own authority code.
    [[nodiscard]] constexpr std::uint8_t authority_code() const noexcept { return authority_; }
    /// Number of commands from senders other than the controller that `admits` refused.
    [[nodiscard]] constexpr std::uint64_t refused() const noexcept { return refused_; }

    [[nodiscard]] JAUSCAT_CONSTEXPR command_rule rule(std::uint16_t command_code) const noexcept;
    /// Whether the message is admitted. Call once for each received message: counts refusals.
    JAUSCAT_CONSTEXPR bool admits(const header& head) noexcept;
    /// The same, without counting.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool would_admit(const header& head) const noexcept;
    /// Call for every received message, also repetitions and acknowledgements: messages of the controller keep its
    /// control alive. Query Heartbeat Pulse (2202h) does not: nodes send it in the name of their components, also of
    /// one that hangs.
    JAUSCAT_CONSTEXPR void heard(const header& head, time_point now) noexcept;
    /// Whether this message is the heartbeat pulse that was requested from the controller.
    JAUSCAT_CONSTEXPR bool takes_pulse(const header& head) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool controls(const address& who) const noexcept;

    /// Call with the outcome of each message that was admitted: watches the sender of a motion command.
    JAUSCAT_CONSTEXPR void obeyed(const header& head, message_outcome outcome, time_point now) noexcept;
    /// Call for a motion command that was deferred: it was executed in place of the others; or it is unknown whether.
    JAUSCAT_CONSTEXPR void finished(const header& head, bool executed, time_point now) noexcept;
    /// The actuators are at rest, or are being brought to rest: no motion command is in force.
    JAUSCAT_CONSTEXPR void at_rest() noexcept;
    /// A motion command of this sender is in force, or may be.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_moved_by(const address& who) const noexcept;
    /// The sender that was lost while its motion command was in force, if it had no control; until at_rest.
    [[nodiscard]] constexpr const std::optional<address>& lost_mover() const noexcept { return lost_mover_; }

    /// Takes Request and Release Component Control, Set Component Authority, and the queries of authority and control.
    /// Ask `admits` first. Confirm and Reject Component Control are for the other side: see held_control.
    JAUSCAT_CONSTEXPR message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                                 message_sink out) noexcept;

    /// The component takes control back: the controller, if there is one, gets Reject Component Control.
    JAUSCAT_CONSTEXPR void reject(message_sink out) noexcept { take_back(control_change::rejected, out); }
    /// Removes the components for which `gone(const address&)` is true: a controller among them loses control. No
    /// message is sent to it.
    constexpr void on_lost(auto&& gone) noexcept {
        if (controller_ && gone(std::as_const(controller_->address))) end(control_change::lost);
        for (const mover& each : moving())
            if (gone(each.sender)) return lose(each.sender);
    }
    /// Queries the pulse of a silent controller, and ends the control of one that has been silent for the timeout. The
    /// same for senders whose motion commands are in force.
    JAUSCAT_CONSTEXPR void on_time(time_point now, message_sink out) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;

  private:
    static constexpr std::size_t max_movers = 8;

    // Signs of life of a controller or mover.
    struct watch {
        time_point heard{};
        std::int64_t asked{};  // quarters of the timeout without a message, at the last query
        std::uint8_t pulses{}; // queried and not yet received
    };
    // A sender whose motion command is in force.
    struct mover {
        address sender{};
        watch life{};
        bool is_in_force{};      // or may be; else it waits for its execution
        std::uint32_t waiting{}; // its commands that were deferred, and are not finished
    };

    [[nodiscard]] constexpr std::span<const mover> moving() const noexcept {
        return std::span{movers_}.first(mover_count_);
    }
    [[nodiscard]] constexpr std::span<mover> moving() noexcept { return std::span{movers_}.first(mover_count_); }
    [[nodiscard]] JAUSCAT_CONSTEXPR mover* mover_of(const address& who) noexcept;
    JAUSCAT_CONSTEXPR mover& watched(const address& who, time_point now) noexcept;
    JAUSCAT_CONSTEXPR void remove(const mover& gone) noexcept;
    // The command of `who` was executed in place of those of all others.
    JAUSCAT_CONSTEXPR void replace_others(const address& who) noexcept;
    JAUSCAT_CONSTEXPR void lose(const address& who) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_motion(const header& head) const noexcept;
    [[nodiscard]] constexpr bool is_timed() const noexcept { return options_.timeout != options_.timeout.zero(); }
    [[nodiscard]] JAUSCAT_CONSTEXPR time_point next_event(const watch& life) const noexcept;
    // Queries the pulse where that is due. False: lost.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool look(watch& life, const address& who, time_point now,
                                              message_sink out) noexcept;

    JAUSCAT_CONSTEXPR void request(const header& head, std::uint8_t authority, time_point now,
                                   message_sink out) noexcept;

    [[nodiscard]] constexpr duration quarter() const noexcept { return std::max(options_.timeout / 4, duration{1}); }
    JAUSCAT_CONSTEXPR void end(control_change why) noexcept;
    // Sends Reject Component Control to the controller.
    JAUSCAT_CONSTEXPR void take_back(control_change why, message_sink out) noexcept;

    address self_;
    std::uint8_t authority_;
    control_options options_;
    std::optional<jaus::controller> controller_{};
    control_change last_change_{};
    watch life_{};                           // of the controller
    std::array<mover, max_movers> movers_{}; // in order of their last command
    std::size_t mover_count_{};
    std::optional<address> lost_mover_{};
    std::uint64_t refused_{};
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/component_control.ipp>
#endif
