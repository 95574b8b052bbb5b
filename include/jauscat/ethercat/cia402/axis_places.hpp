// The objects of one axis in process data: targets out, feedback in.
#pragma once

#include <jauscat/ethercat/cia402/axis.hpp>
#include <jauscat/ethercat/cia402/pdo_layout.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace jauscat::cia402 {

/// Found once, used in each cycle. Drives with other indices (7010h in modular devices): set the places by
/// `pdo_layout::find`.
struct axis_places {
    // Outputs.
    pdo_place controlword{};
    pdo_place mode{};
    pdo_place target_position{};
    pdo_place target_velocity{};
    pdo_place target_torque{};
    pdo_place profile_velocity{};
    // Inputs.
    pdo_place statusword{};
    pdo_place mode_display{};
    pdo_place position{};
    pdo_place velocity{};
    pdo_place torque{};
    pdo_place error_code{};
    /// The mode where 6061h is not mapped: the one that 6060h has been set to by SDO.
    cia402::mode fixed_mode{};

    constexpr void store(const axis_targets& targets, std::span<std::byte> outputs) const noexcept {
        cia402::store(controlword, outputs, targets.controlword);
        cia402::store(mode, outputs, static_cast<std::int8_t>(targets.mode));
        cia402::store(target_position, outputs, targets.position);
        cia402::store(target_velocity, outputs, targets.velocity);
        cia402::store(target_torque, outputs, targets.torque);
        cia402::store(profile_velocity, outputs, targets.profile_velocity);
    }
    [[nodiscard]] constexpr axis_feedback load(std::span<const std::byte> inputs) const noexcept {
        return {.statusword = cia402::load<std::uint16_t>(statusword, inputs),
                .mode = mode_display.is_mapped() ? cia402::load<cia402::mode>(mode_display, inputs) : fixed_mode,
                .position = cia402::load<std::int32_t>(position, inputs),
                .velocity = cia402::load<std::int32_t>(velocity, inputs),
                .torque = cia402::load<std::int16_t>(torque, inputs),
                .error_code = cia402::load<std::uint16_t>(error_code, inputs)};
    }
    /// The first object that `mode` needs and the process data do not have; nullptr if it can be used. A drive with
    /// objects that are not mapped uses their last value by SDO, or a fault.
    [[nodiscard]] constexpr const object* missing_for(cia402::mode wanted) const noexcept {
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
        case cia402::mode::cyclic_synchronous_torque:
            return target_torque.is_mapped() ? nullptr : &objects::target_torque;
        default: return nullptr;
        }
    }
};

/// The places of axis `axis` (from 0) of a drive with these process data.
[[nodiscard]] constexpr axis_places places_of(const auto& outputs, const auto& inputs, std::size_t axis = 0) noexcept {
    return {.controlword = outputs.find(objects::controlword, axis),
            .mode = outputs.find(objects::mode_of_operation, axis),
            .target_position = outputs.find(objects::target_position, axis),
            .target_velocity = outputs.find(objects::target_velocity, axis),
            .target_torque = outputs.find(objects::target_torque, axis),
            .profile_velocity = outputs.find(objects::profile_velocity, axis),
            .statusword = inputs.find(objects::statusword, axis),
            .mode_display = inputs.find(objects::mode_display, axis),
            .position = inputs.find(objects::position_actual, axis),
            .velocity = inputs.find(objects::velocity_actual, axis),
            .torque = inputs.find(objects::torque_actual, axis),
            .error_code = inputs.find(objects::error_code, axis)};
}

} // namespace jauscat::cia402
