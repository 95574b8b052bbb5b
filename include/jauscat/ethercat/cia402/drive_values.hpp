// The values of the objects of one emulated axis, and the table that joins them to their indices.
#pragma once

#include <jauscat/schema/ethercat/cia402_objects.hpp>
#include <jauscat/wire/member.hpp>

#include <array>
#include <cstdint>

namespace jauscat::cia402 {

/// Positions in increments, velocities in increments/s, accelerations in increments/s^2, torques in per mille of the
/// rated torque. The defaults are those of a drive that was never configured.
struct drive_values {
    std::uint16_t error_code{};
    std::uint16_t controlword{};
    std::uint16_t statusword{};
    std::int16_t quick_stop_option{2};
    std::int16_t shutdown_option{0};
    std::int16_t disable_option{1};
    std::int16_t halt_option{1};
    std::int16_t fault_reaction_option{2};
    std::int8_t mode_of_operation{};
    std::int8_t mode_display{};
    std::int32_t position_demand{};
    std::int32_t position_actual{};
    std::uint32_t following_error_window{10'000};
    std::uint16_t following_error_time{10};
    std::uint32_t position_window{10};
    std::int32_t velocity_demand{};
    std::int32_t velocity_actual{};
    std::int16_t target_torque{};
    std::uint16_t max_torque{3000};
    std::int16_t torque_demand{};
    std::uint32_t rated_current{2000};
    std::uint32_t rated_torque{500};
    std::int16_t torque_actual{};
    std::int16_t current_actual{};
    std::int32_t target_position{};
    std::int32_t home_offset{};
    std::int32_t min_position_limit{}; ///< as high as the maximum: no limits
    std::int32_t max_position_limit{};
    std::uint32_t profile_velocity{100'000};
    std::uint32_t profile_acceleration{1'000'000};
    std::uint32_t profile_deceleration{1'000'000};
    std::uint32_t quick_stop_deceleration{5'000'000};
    std::uint32_t torque_slope{100'000};
    std::int8_t homing_method{35};
    std::int32_t position_offset{};
    std::int32_t velocity_offset{};
    std::int16_t torque_offset{};
    std::uint8_t interpolation_time{1};
    std::int8_t interpolation_index{-3};
    std::int32_t following_error{};
    std::uint32_t digital_inputs{};
    std::int32_t target_velocity{};
    std::uint32_t supported_modes{cia402::supported_modes(
        mode::profile_position, mode::profile_velocity, mode::profile_torque, mode::homing,
        mode::cyclic_synchronous_position, mode::cyclic_synchronous_velocity, mode::cyclic_synchronous_torque)};
};

/// An object and its value.
struct value_slot {
    const object* described{};
    std::int64_t (*get)(const drive_values&) noexcept {};
    void (*set)(drive_values&, std::int64_t) noexcept {};
};

namespace detail {

template <auto Member, class Value> constexpr value_slot slot_of(const object_of<Value>& described) noexcept {
    using member = std::remove_cvref_t<decltype(drive_values{}.*Member)>;
    static_assert(std::is_same_v<member, Value>, "drive_values: the value has not the type of its object");
    return {
        .described = &described,
        .get = [](const drive_values& values) noexcept { return static_cast<std::int64_t>(values.*Member); },
        .set = [](drive_values& values, std::int64_t value) noexcept { values.*Member = static_cast<Value>(value); }};
}

} // namespace detail

// One line per object, by index.
// clang-format off
inline constexpr std::array value_slots{
    detail::slot_of<&drive_values::error_code>(objects::error_code),
    detail::slot_of<&drive_values::controlword>(objects::controlword),
    detail::slot_of<&drive_values::statusword>(objects::statusword),
    detail::slot_of<&drive_values::quick_stop_option>(objects::quick_stop_option),
    detail::slot_of<&drive_values::shutdown_option>(objects::shutdown_option),
    detail::slot_of<&drive_values::disable_option>(objects::disable_option),
    detail::slot_of<&drive_values::halt_option>(objects::halt_option),
    detail::slot_of<&drive_values::fault_reaction_option>(objects::fault_reaction_option),
    detail::slot_of<&drive_values::mode_of_operation>(objects::mode_of_operation),
    detail::slot_of<&drive_values::mode_display>(objects::mode_display),
    detail::slot_of<&drive_values::position_demand>(objects::position_demand),
    detail::slot_of<&drive_values::position_actual>(objects::position_actual),
    detail::slot_of<&drive_values::following_error_window>(objects::following_error_window),
    detail::slot_of<&drive_values::following_error_time>(objects::following_error_time),
    detail::slot_of<&drive_values::position_window>(objects::position_window),
    detail::slot_of<&drive_values::velocity_demand>(objects::velocity_demand),
    detail::slot_of<&drive_values::velocity_actual>(objects::velocity_actual),
    detail::slot_of<&drive_values::target_torque>(objects::target_torque),
    detail::slot_of<&drive_values::max_torque>(objects::max_torque),
    detail::slot_of<&drive_values::torque_demand>(objects::torque_demand),
    detail::slot_of<&drive_values::rated_current>(objects::rated_current),
    detail::slot_of<&drive_values::rated_torque>(objects::rated_torque),
    detail::slot_of<&drive_values::torque_actual>(objects::torque_actual),
    detail::slot_of<&drive_values::current_actual>(objects::current_actual),
    detail::slot_of<&drive_values::target_position>(objects::target_position),
    detail::slot_of<&drive_values::home_offset>(objects::home_offset),
    detail::slot_of<&drive_values::min_position_limit>(objects::min_position_limit),
    detail::slot_of<&drive_values::max_position_limit>(objects::max_position_limit),
    detail::slot_of<&drive_values::profile_velocity>(objects::profile_velocity),
    detail::slot_of<&drive_values::profile_acceleration>(objects::profile_acceleration),
    detail::slot_of<&drive_values::profile_deceleration>(objects::profile_deceleration),
    detail::slot_of<&drive_values::quick_stop_deceleration>(objects::quick_stop_deceleration),
    detail::slot_of<&drive_values::torque_slope>(objects::torque_slope),
    detail::slot_of<&drive_values::homing_method>(objects::homing_method),
    detail::slot_of<&drive_values::position_offset>(objects::position_offset),
    detail::slot_of<&drive_values::velocity_offset>(objects::velocity_offset),
    detail::slot_of<&drive_values::torque_offset>(objects::torque_offset),
    detail::slot_of<&drive_values::interpolation_time>(objects::interpolation_time),
    detail::slot_of<&drive_values::interpolation_index>(objects::interpolation_index),
    detail::slot_of<&drive_values::following_error>(objects::following_error),
    detail::slot_of<&drive_values::digital_inputs>(objects::digital_inputs),
    detail::slot_of<&drive_values::target_velocity>(objects::target_velocity),
    detail::slot_of<&drive_values::supported_modes>(objects::supported_modes),
};
// clang-format on

} // namespace jauscat::cia402
