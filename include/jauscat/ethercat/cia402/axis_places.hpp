// The objects of one axis in process data: targets out, feedback in.
#pragma once

#include <jauscat/base/compilation.hpp>
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

    /// Calls `f(place, is_output)` for each of them.
    constexpr void for_each(auto&& f) const {
        for (const auto* each :
             {&controlword, &mode, &target_position, &target_velocity, &target_torque, &profile_velocity})
            f(*each, true);
        for (const auto* each : {&statusword, &mode_display, &position, &velocity, &torque, &error_code})
            f(*each, false);
    }
    static constexpr std::size_t capacity = 12;

    JAUSCAT_CONSTEXPR void store(const axis_targets& targets, std::span<std::byte> outputs) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR axis_feedback load(std::span<const std::byte> inputs) const noexcept;
    /// The first object that `mode` needs and the process data do not have; nullptr if it can be used. A drive with
    /// objects that are not mapped uses their last value by SDO, or a fault.
    [[nodiscard]] JAUSCAT_CONSTEXPR const object* missing_for(cia402::mode wanted) const noexcept;
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

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/cia402/impl/axis_places.ipp>
#endif
