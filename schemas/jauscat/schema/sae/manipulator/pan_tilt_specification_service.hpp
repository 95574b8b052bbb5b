// PanTiltSpecificationService 2.0, urn:jaus:jss:manipulator:PanTiltSpecificationService.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/manipulator/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::manipulator {

/// QueryPanTiltSpecifications: ID 2620h, input of PanTiltSpecificationService.
struct query_pan_tilt_specifications {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(
        const query_pan_tilt_specifications&,
        const query_pan_tilt_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2620;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_pan_tilt_specifications;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// ReportPanTiltSpecifications: ID 4620h, output of PanTiltSpecificationService.
struct report_pan_tilt_specifications {
    std::optional<double> pan_tilt_coordinate_sys_x{};        ///< meter, -30 to 30
    std::optional<double> pan_tilt_coordinate_sys_y{};        ///< meter, -30 to 30
    std::optional<double> pan_tilt_coordinate_sys_z{};        ///< meter, -30 to 30
    std::optional<double> d_component_of_unit_quaternion_q{}; ///< -1 to 1
    std::optional<double> a_component_of_unit_quaternion_q{}; ///< -1 to 1
    std::optional<double> b_component_of_unit_quaternion_q{}; ///< -1 to 1
    std::optional<double> c_component_of_unit_quaternion_q{}; ///< -1 to 1
    double joint1_min_value{};                                ///< radian, -8 pi to 8 pi
    double joint1_max_value{};                                ///< radian, -8 pi to 8 pi
    double joint1_max_speed{};                                ///< radian per second, 0 to 10 pi
    double joint2_min_value{};                                ///< radian, -8 pi to 8 pi
    double joint2_max_value{};                                ///< radian, -8 pi to 8 pi
    double joint2_max_speed{};                                ///< radian per second, 0 to 10 pi
    friend constexpr bool operator==(
        const report_pan_tilt_specifications&,
        const report_pan_tilt_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4620;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_pan_tilt_specifications;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::pan_tilt_coordinate_sys_x, scaled<u32le, meter_minus_30_to_30>>,
                field<&T::pan_tilt_coordinate_sys_y, scaled<u32le, meter_minus_30_to_30>>,
                field<&T::pan_tilt_coordinate_sys_z, scaled<u32le, meter_minus_30_to_30>>,
                field<&T::d_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
                field<&T::a_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
                field<&T::b_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
                field<&T::c_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
                field<&T::joint1_min_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::joint1_max_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::joint1_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
                field<&T::joint2_min_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::joint2_max_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::joint2_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>>>;
    };
};

namespace services {

/// PanTiltSpecificationService: what it is called, and its messages.
struct pan_tilt_specification_service {
    static constexpr std::string_view name = "PanTiltSpecificationService";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PanTiltSpecificationService";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_pan_tilt_specifications>;
    using outputs = jaus::message_list<report_pan_tilt_specifications>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
