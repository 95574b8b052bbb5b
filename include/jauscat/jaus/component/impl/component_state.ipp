// The functions of component_state.
#pragma once
#include <jauscat/jaus/component/component_state.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR std::optional<primary_status_code> state_after(primary_status_code from, state_event event) noexcept {
    using enum primary_status_code;
    const bool ended = from == primary_status_code::shutdown;
    const auto if_possible = [](bool possible, primary_status_code to) {
        return possible ? std::optional{to} : std::nullopt;
    };
    switch (event) {
    case state_event::initialized: return if_possible(from == initialize || from == ready, ready);
    case state_event::failed: return if_possible(!ended && from != emergency, failure);
    case state_event::shutdown: return primary_status_code::shutdown;
    case state_event::standby:
        return if_possible(from == ready || from == primary_status_code::standby, primary_status_code::standby);
    case state_event::resume: return if_possible(from == ready || from == primary_status_code::standby, ready);
    case state_event::reset: return if_possible(!ended && from != emergency, initialize);
    case state_event::emergency: return ended ? from : emergency;
    case state_event::emergency_cleared: return if_possible(from != emergency, from);
    }
    return std::nullopt;
}

JAUSCAT_CONSTEXPR bool is_state_command(std::uint16_t command_code) noexcept {
    return command_code >= command_code_of<shutdown> && command_code <= command_code_of<clear_emergency>;
}

JAUSCAT_CONSTEXPR bool says_emergency(std::span<const std::byte> body) noexcept {
    set_emergency message{};
    return wire::decode(message, body) && message.emergency_code.test(set_emergency_code::transition_to_emergency);
}

} // namespace jauscat::jaus
