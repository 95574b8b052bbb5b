// State of a component, and the senders that may change it: Shutdown, Standby, Resume, Reset, Set and Clear Emergency,
// Query Component Status, and the application. RA 3.3 part 3, core subgroup.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <algorithm>
#include <optional>

namespace jauscat::jaus {

/// Events that change the state. The first two come only from the application, the others also from messages.
enum class state_event : std::uint8_t {
    initialized, ///< the application has done what it does first
    failed,      ///< the application has failed
    shutdown,
    standby,
    resume,
    reset,
    emergency,         ///< Set Emergency
    emergency_cleared, ///< Clear Emergency with its bit, when no sender holds the emergency any more
};

/// The next state; empty if the event is refused. The RA names the states, not every transition: a component that is
/// shut down remains so, and only Clear Emergency and Shutdown end an emergency.
///
///     state      | initialized failed   shutdown standby  resume reset       emergency emergency_cleared
///     -----------+--------------------------------------------------------------------------------------
///     Initialize | Ready       Failure  Shutdown -        -      Initialize  Emergency Initialize
///     Ready      | Ready       Failure  Shutdown Standby  Ready  Initialize  Emergency Ready
///     Standby    | -           Failure  Shutdown Standby  Ready  Initialize  Emergency Standby
///     Shutdown   | -           -        Shutdown -        -      -           Shutdown  Shutdown
///     Failure    | -           Failure  Shutdown -        -      Initialize  Emergency Failure
///     Emergency  | *           *        Shutdown -        -      -           Emergency *
///
/// * In an emergency, initialized and failed change the state that follows it, see component_state. Set Emergency is
/// never refused; in Shutdown it changes nothing.
[[nodiscard]] JAUSCAT_CONSTEXPR std::optional<primary_status_code> state_after(primary_status_code from,
                                                                               state_event event) noexcept;

/// Whether a component's state takes this command: Shutdown, Standby, Resume, Reset, Set and Clear Emergency.
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_state_command(std::uint16_t command_code) noexcept;

/// Whether the body of a Set Emergency has its bit. A component stops without it, too: some nodes send the code 0.
[[nodiscard]] JAUSCAT_CONSTEXPR bool says_emergency(std::span<const std::byte> body) noexcept;

/// State after an emergency of a component that was Ready before.
enum class after_emergency : std::uint8_t {
    standby, ///< nothing moves before a Resume: what the RA and its nodes do
    resume,  ///< back to Ready
};

/// A component's state, and its answer to Query Component Status. It begins in Initialize.
///
/// An emergency is held by each component that has set it, and by the application if it has. Each can only clear its
/// own hold; the emergency ends with the last one. A sender without a hold cannot clear it, not even a controller,
/// while a holder is present; the hold of a lost component (on_lost) can be cleared by any sender that has none itself.
/// `Holders`: number of components that are remembered; the emergency of a further one also takes effect, and is
/// cleared like that of a lost component.
///
/// After an emergency the component is in Standby, or in Ready with after_emergency::resume, if it was Ready; a
/// component in another state returns to that state.
template <std::size_t Holders = 8> class component_state {
  public:
    /// The state is Initialize.
    constexpr explicit component_state(const address& self, after_emergency after = {}) noexcept
        : self_{self}, after_{after} {}

    /// Initialize, Ready, Standby, Shutdown, Failure or Emergency.
    [[nodiscard]] constexpr primary_status_code state() const noexcept { return state_; }
    /// The 32 bits of the component's own meaning in Report Component Status.
    std::uint32_t secondary_status{};

    /// The application's events. False: refused, see state_after. Of an emergency the application holds its own part.
    constexpr bool change(state_event event) noexcept {
        if (event == state_event::emergency && state_ != primary_status_code::shutdown) own_hold_ = true;
        if (event == state_event::emergency_cleared) {
            own_hold_ = false;
            return end_if_unheld();
        }
        return apply(event);
    }
    /// Ends an emergency of any sender: for an operator at the machine, when a holder cannot be reached.
    constexpr void end_emergency() noexcept {
        held_ = 0;
        own_hold_ = anyones_hold_ = false;
        end_if_unheld();
    }

    /// Handles the messages above; answers Query Component Status. Set Emergency is handled with any body. Refused:
    /// what the table refuses, and a Clear Emergency from a sender without a hold. A Clear Emergency without its bit is
    /// handled and changes nothing.
    constexpr message_outcome on_message(const header& head, std::span<const std::byte> body, time_point,
                                         message_sink out) noexcept {
        switch (head.command_code) {
        case command_code_of<shutdown>: return command<shutdown>(body, state_event::shutdown);
        case command_code_of<standby>: return command<standby>(body, state_event::standby);
        case command_code_of<resume>: return command<resume>(body, state_event::resume);
        case command_code_of<reset>: return command<reset>(body, state_event::reset);
        case command_code_of<set_emergency>: hold(head.source); return message_outcome::handled;
        case command_code_of<clear_emergency>:
            return decode_for<clear_emergency>(body, [&](const clear_emergency& m) {
                return !m.emergency_code.test(clear_emergency_code::clear_emergency) || release(head.source)
                           ? message_outcome::handled
                           : message_outcome::refused;
            });
        case command_code_of<query_component_status>:
            return decode_for<query_component_status>(body, [&](const query_component_status&) {
                static_cast<void>(answer(head, self_, report_component_status{state_, secondary_status}, out));
            });
        default: return message_outcome::unhandled;
        }
    }

    /// Whether this component has set the emergency that is in force, and so may clear its part.
    [[nodiscard]] constexpr bool holds_emergency(const address& who) const noexcept {
        return std::ranges::find(held(), who) != held().end();
    }
    /// Marks the components for which `gone(const address&)` is true as lost: any sender may clear their holds.
    constexpr void on_lost(auto&& gone) noexcept {
        const std::size_t before = held_;
        drop_holders(gone);
        if (held_ != before) anyones_hold_ = true;
    }

  private:
    [[nodiscard]] constexpr std::span<const address> held() const noexcept { return std::span{holders_}.first(held_); }

    constexpr void drop_holders(auto&& which) noexcept {
        const auto end = holders_.begin() + static_cast<std::ptrdiff_t>(held_);
        held_ = static_cast<std::size_t>(std::remove_if(holders_.begin(), end, which) - holders_.begin());
    }

    template <coded_message T>
    constexpr message_outcome command(std::span<const std::byte> body, state_event event) noexcept {
        return decode_for<T>(
            body, [&](const T&) { return apply(event) ? message_outcome::handled : message_outcome::refused; });
    }

    constexpr bool apply(state_event event) noexcept {
        if (state_ == primary_status_code::emergency &&
            (event == state_event::initialized || event == state_event::failed)) {
            const auto next = state_after(before_, event);
            if (next) before_ = *next;
            return next.has_value();
        }
        const auto next = state_after(state_, event);
        if (!next) return false;
        if (*next == primary_status_code::emergency && state_ != *next) before_ = state_;
        state_ = *next;
        if (state_ != primary_status_code::emergency) held_ = 0, own_hold_ = anyones_hold_ = false;
        return true;
    }

    constexpr void hold(const address& who) noexcept {
        apply(state_event::emergency);
        if (state_ != primary_status_code::emergency || holds_emergency(who)) return;
        if (held_ == Holders)
            anyones_hold_ = true;
        else
            holders_[held_++] = who;
    }
    constexpr bool release(const address& who) noexcept {
        if (state_ != primary_status_code::emergency) return true;
        if (!holds_emergency(who) && !anyones_hold_) return false;
        if (holds_emergency(who))
            drop_holders([&](const address& holder) { return holder == who; });
        else
            anyones_hold_ = false;
        end_if_unheld();
        return true;
    }
    // False while others hold the emergency.
    constexpr bool end_if_unheld() noexcept {
        if (state_ != primary_status_code::emergency) return true;
        if (held_ != 0 || own_hold_ || anyones_hold_) return false;
        const bool was_ready = before_ == primary_status_code::ready;
        state_ = was_ready && after_ == after_emergency::standby ? primary_status_code::standby : before_;
        return true;
    }

    address self_;
    after_emergency after_;
    primary_status_code state_{};
    primary_status_code before_{}; // the state that the emergency interrupted
    std::array<address, Holders> holders_{};
    std::size_t held_{};
    bool own_hold_{};     // the application's
    bool anyones_hold_{}; // of one that is gone, or that there was no place for
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/component_state.ipp>
#endif
