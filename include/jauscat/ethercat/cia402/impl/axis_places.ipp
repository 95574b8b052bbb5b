// The functions of axis_places.
#pragma once
#include <jauscat/ethercat/cia402/axis_places.hpp>

namespace jauscat::cia402 {

JAUSCAT_CONSTEXPR void axis_places::store(const axis_targets& targets, std::span<std::byte> outputs) const noexcept {
    cia402::store(controlword, outputs, targets.controlword);
    cia402::store(mode, outputs, static_cast<std::int8_t>(targets.mode));
    cia402::store(target_position, outputs, targets.position);
    cia402::store(target_velocity, outputs, targets.velocity);
    cia402::store(target_torque, outputs, targets.torque);
    cia402::store(profile_velocity, outputs, targets.profile_velocity);
}

JAUSCAT_CONSTEXPR axis_feedback axis_places::load(std::span<const std::byte> inputs) const noexcept {
    return {.statusword = cia402::load<std::uint16_t>(statusword, inputs),
            .mode = mode_display.is_mapped() ? cia402::load<cia402::mode>(mode_display, inputs) : fixed_mode,
            .position = cia402::load<std::int32_t>(position, inputs),
            .velocity = cia402::load<std::int32_t>(velocity, inputs),
            .torque = cia402::load<std::int16_t>(torque, inputs),
            .error_code = cia402::load<std::uint16_t>(error_code, inputs),
            .has_position = position.is_mapped(),
            .has_velocity = velocity.is_mapped()};
}

JAUSCAT_CONSTEXPR const object* axis_places::missing_for(cia402::mode wanted) const noexcept {
    if (!controlword.is_mapped()) return &objects::controlword;
    if (!statusword.is_mapped()) return &objects::statusword;
    if (!mode.is_mapped() && fixed_mode != wanted) return &objects::mode_of_operation;
    switch (wanted) {
    case cia402::mode::profile_position:
    case cia402::mode::cyclic_synchronous_position:
        if (!target_position.is_mapped()) return &objects::target_position;
        return position.is_mapped() ? nullptr : &objects::position_actual;
    case cia402::mode::profile_velocity:
    case cia402::mode::cyclic_synchronous_velocity:
        if (!target_velocity.is_mapped()) return &objects::target_velocity;
        return velocity.is_mapped() ? nullptr : &objects::velocity_actual;
    case cia402::mode::profile_torque:
    case cia402::mode::cyclic_synchronous_torque: return target_torque.is_mapped() ? nullptr : &objects::target_torque;
    default: return nullptr;
    }
}

} // namespace jauscat::cia402
