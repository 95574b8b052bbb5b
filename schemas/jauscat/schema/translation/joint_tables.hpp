// JAUS joint messages and the objects of CiA 402 drives: positions, velocities and efforts, set and reported.
#pragma once
#include <jauscat/schema/ethercat/cia402_objects.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>
#include <jauscat/translate/object_table.hpp>

#include <limits>

namespace jauscat::translation {

/// How a joint is connected to its drive. Positions in the drive's units, mostly increments of its encoder.
struct joint_scale {
    double increments_per_radian{1}; ///< of the joint: encoder increments x gear ratio / 2 pi; above 0
    double zero{};                   ///< the drive's position where the joint's is 0
    bool reversed{};                 ///< the drive turns against the joint
    double velocity_units{1};        ///< units of velocity of one increment/s; above 0
    double full_effort{1000};        ///< per mille of the rated torque at 100 %; above 0
    double min_position{std::numeric_limits<std::int32_t>::min()};
    double max_position{std::numeric_limits<std::int32_t>::max()};
    double max_velocity{std::numeric_limits<std::int32_t>::max()}; ///< units of velocity; 0 or above
    double max_torque{std::numeric_limits<std::int16_t>::max()};   ///< per mille of the rated torque; 0 or above

    [[nodiscard]] constexpr double sign() const noexcept { return reversed ? -1 : 1; }
};
/// Whether all parameters are within their ranges, also none is NaN.
[[nodiscard]] constexpr bool is_valid(const joint_scale& scale) noexcept {
    constexpr double lowest = std::numeric_limits<std::int32_t>::min();
    constexpr double highest = std::numeric_limits<std::int32_t>::max();
    return scale.increments_per_radian > 0 && scale.increments_per_radian <= highest && scale.zero >= lowest &&
           scale.zero <= highest && scale.velocity_units > 0 && scale.velocity_units <= highest &&
           scale.full_effort > 0 && scale.full_effort <= highest && scale.min_position >= lowest &&
           scale.min_position < scale.max_position && scale.max_position <= highest && scale.max_velocity >= 0 &&
           scale.max_velocity <= highest && scale.max_torque >= 0 && scale.max_torque <= highest;
}

namespace detail {
[[nodiscard]] constexpr double limited_to(double value, double lowest, double highest) noexcept {
    return value < lowest ? lowest : value > highest ? highest : value;
}
} // namespace detail

struct radians_as_position {
    static constexpr std::string_view from = "rad";
    static constexpr auto to = cia402::unit::position;
    static constexpr bool zero_within_step = false;
    [[nodiscard]] static constexpr double to_object(double radians, const joint_scale& scale) noexcept {
        return radians * scale.sign() * scale.increments_per_radian + scale.zero;
    }
    [[nodiscard]] static constexpr double limited(double position, const joint_scale& scale) noexcept {
        return detail::limited_to(position, scale.min_position, scale.max_position);
    }
    [[nodiscard]] static constexpr double from_object(double position, const joint_scale& scale) noexcept {
        return (position - scale.zero) * scale.sign() / scale.increments_per_radian;
    }
};

struct radians_per_second_as_velocity {
    static constexpr std::string_view from = "rad/s";
    static constexpr auto to = cia402::unit::velocity;
    static constexpr bool zero_within_step = true;
    [[nodiscard]] static constexpr double to_object(double rate, const joint_scale& scale) noexcept {
        return rate * scale.sign() * scale.increments_per_radian * scale.velocity_units;
    }
    [[nodiscard]] static constexpr double limited(double velocity, const joint_scale& scale) noexcept {
        return detail::limited_to(velocity, -scale.max_velocity, scale.max_velocity);
    }
    [[nodiscard]] static constexpr double from_object(double velocity, const joint_scale& scale) noexcept {
        return velocity * scale.sign() / scale.increments_per_radian / scale.velocity_units;
    }
};

struct percent_as_torque {
    static constexpr std::string_view from = "%";
    static constexpr auto to = cia402::unit::rated_torque;
    static constexpr bool zero_within_step = true;
    [[nodiscard]] static constexpr double to_object(double percent, const joint_scale& scale) noexcept {
        return percent * scale.sign() * scale.full_effort / 100;
    }
    [[nodiscard]] static constexpr double limited(double torque, const joint_scale& scale) noexcept {
        return detail::limited_to(torque, -scale.max_torque, scale.max_torque);
    }
    [[nodiscard]] static constexpr double from_object(double torque, const joint_scale& scale) noexcept {
        return torque * scale.sign() * 100 / scale.full_effort;
    }
};

// clang-format off
/// For up to `Joints` joints.
template <std::size_t Joints>
using set_joint_positions_table = translate::object_table<jaus::basic_set_joint_positions<Joints>, joint_scale,
    translate::axis_row<&jaus::basic_set_joint_positions<Joints>::joint_position, cia402::objects::target_position, radians_as_position>>;
template <std::size_t Joints>
using set_joint_velocities_table = translate::object_table<jaus::basic_set_joint_velocities<Joints>, joint_scale,
    translate::axis_row<&jaus::basic_set_joint_velocities<Joints>::joint_velocity, cia402::objects::target_velocity, radians_per_second_as_velocity>>;
template <std::size_t Joints>
using set_joint_efforts_table = translate::object_table<jaus::basic_set_joint_efforts<Joints>, joint_scale,
    translate::axis_row<&jaus::basic_set_joint_efforts<Joints>::joint_effort, cia402::objects::target_torque, percent_as_torque>>;

template <std::size_t Joints>
using report_joint_positions_table = translate::object_table<jaus::basic_report_joint_positions<Joints>, joint_scale,
    translate::axis_row<&jaus::basic_report_joint_positions<Joints>::joint_position, cia402::objects::position_actual, radians_as_position>>;
template <std::size_t Joints>
using report_joint_velocities_table = translate::object_table<jaus::basic_report_joint_velocities<Joints>, joint_scale,
    translate::axis_row<&jaus::basic_report_joint_velocities<Joints>::joint_velocity, cia402::objects::velocity_actual, radians_per_second_as_velocity>>;
template <std::size_t Joints>
using report_joint_efforts_table = translate::object_table<jaus::basic_report_joint_efforts<Joints>, joint_scale,
    translate::axis_row<&jaus::basic_report_joint_efforts<Joints>::joint_effort, cia402::objects::torque_actual, percent_as_torque>>;
// clang-format on

} // namespace jauscat::translation
