// A drive by the table of transitions alone: no time, no motor. One status for each controlword.
#pragma once

#include <jauscat/ethercat/cia402/axis.hpp>

namespace jauscat::test {

struct plain_drive {
    cia402::state state{cia402::state::switch_on_disabled};
    std::uint16_t before{};
    std::uint16_t bits{cia402::status_bits::follows_target}; // bit 10 and up, of the mode
    bool stuck{};
    cia402::axis_feedback feedback{.statusword = cia402::status_of(cia402::state::switch_on_disabled)};

    constexpr void take(const cia402::axis_targets& targets) {
        const auto cause = cia402::command_of(targets.controlword, before);
        before = targets.controlword;
        if (const auto found = cia402::transition_of(state, cause); found && !stuck) state = found->to;
        show();
        feedback.mode = targets.mode;
    }
    constexpr void show() {
        const bool enabled = state == cia402::state::operation_enabled;
        feedback.statusword = static_cast<std::uint16_t>(cia402::status_of(state) | (enabled ? bits : 0));
    }
    constexpr void fail(std::uint16_t code) {
        state = cia402::state::fault;
        feedback.error_code = code;
        show();
    }
};

} // namespace jauscat::test
