// ManipulatorSpecificationService 2.0, urn:jaus:jss:manipulator:ManipulatorSpecificationService.
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

/// QueryManipulatorSpecifications: ID 2600h, input of ManipulatorSpecificationService.
struct query_manipulator_specifications {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(
        const query_manipulator_specifications&,
        const query_manipulator_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2600;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_manipulator_specifications;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// Record ManipulatorCoordinateSystemRec.
struct manipulator_coordinate_system_rec {
    double manipulator_coordinate_sys_x{};     ///< meter, -30 to 30
    double manipulator_coordinate_sys_y{};     ///< meter, -30 to 30
    double manipulator_coordinate_sys_z{};     ///< meter, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    friend constexpr bool operator==(
        const manipulator_coordinate_system_rec&,
        const manipulator_coordinate_system_rec&) = default;

    struct schema : wire::items {
        using T = manipulator_coordinate_system_rec;
        using type = layout<
            field<&T::manipulator_coordinate_sys_x, scaled<u32le, meter_minus_30_to_30>>,
            field<&T::manipulator_coordinate_sys_y, scaled<u32le, meter_minus_30_to_30>>,
            field<&T::manipulator_coordinate_sys_z, scaled<u32le, meter_minus_30_to_30>>,
            field<&T::d_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
            field<&T::a_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
            field<&T::b_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
            field<&T::c_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>>;
    };
};

/// Record RevoluteJoint1OffsetRec.
struct revolute_joint1_offset_rec {
    double joint1_offset{};                                  ///< meter, -10 to 10
    std::optional<double> joint1_min_value{};                ///< radian, -8 pi to 8 pi
    std::optional<double> joint1_max_value{};                ///< radian, -8 pi to 8 pi
    std::optional<double> joint1_max_speed{};                ///< radian per second, 0 to 10 pi
    std::optional<double> joint1_max_torque{};               ///< newton meter, 0 to 5000
    std::optional<double> offset_bounding_cylinder_radius{}; ///< meter, 0 to 10
    friend constexpr bool operator==(const revolute_joint1_offset_rec&, const revolute_joint1_offset_rec&) = default;

    struct schema : wire::items {
        using T = revolute_joint1_offset_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::joint1_offset, scaled<u16le, meter_minus_10_to_10>>,
                field<&T::joint1_min_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::joint1_max_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::joint1_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
                field<&T::joint1_max_torque, scaled<u32le, newton_meter_0_to_5000>>,
                field<&T::offset_bounding_cylinder_radius, scaled<u16le, meter_0_to_10>>>>;
    };
};

/// Record PrismaticJoint1AngleRec.
struct prismatic_joint1_angle_rec {
    double joint1_angle{};                                  ///< radian, -pi to pi
    double joint1_min_value{};                              ///< meter, -10 to 10
    double joint1_max_value{};                              ///< meter, -10 to 10
    std::optional<double> joint1_max_speed{};               ///< meter per second, -5 to 5
    std::optional<double> joint1_max_force{};               ///< newton, 0 to 5000
    std::optional<double> joint_bounding_cylinder_radius{}; ///< meter, 0 to 10
    friend constexpr bool operator==(const prismatic_joint1_angle_rec&, const prismatic_joint1_angle_rec&) = default;

    struct schema : wire::items {
        using T = prismatic_joint1_angle_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::joint1_angle, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::joint1_min_value, scaled<u32le, meter_minus_10_to_10>>,
                field<&T::joint1_max_value, scaled<u32le, meter_minus_10_to_10>>,
                field<&T::joint1_max_speed, scaled<u32le, meter_per_second_minus_5_to_5>>,
                field<&T::joint1_max_force, scaled<u32le, newton_0_to_5000>>,
                field<&T::joint_bounding_cylinder_radius, scaled<u16le, meter_0_to_10>>>>;
    };
};

/// Record RevoluteJointSpecificationRec.
struct revolute_joint_specification_rec {
    double link_length{};                                         ///< meter, -10 to 10
    double twist_angle{};                                         ///< radian, -pi to pi
    double joint_offset{};                                        ///< meter, -10 to 10
    std::optional<double> min_value{};                            ///< radian, -8 pi to 8 pi
    std::optional<double> max_value{};                            ///< radian, -8 pi to 8 pi
    std::optional<double> max_speed{};                            ///< radian per second, 0 to 10 pi
    std::optional<double> max_torque{};                           ///< newton meter, 0 to 5000
    std::optional<double> offset_bounding_cylinder_radius{};      ///< meter, 0 to 10
    std::optional<double> link_length_bounding_cylinder_radius{}; ///< meter, 0 to 10
    friend constexpr bool operator==(
        const revolute_joint_specification_rec&,
        const revolute_joint_specification_rec&) = default;

    struct schema : wire::items {
        using T = revolute_joint_specification_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::link_length, scaled<u16le, meter_minus_10_to_10>>,
                field<&T::twist_angle, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::joint_offset, scaled<u16le, meter_minus_10_to_10>>,
                field<&T::min_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::max_value, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                field<&T::max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
                field<&T::max_torque, scaled<u32le, newton_meter_0_to_5000>>,
                field<&T::offset_bounding_cylinder_radius, scaled<u16le, meter_0_to_10>>,
                field<&T::link_length_bounding_cylinder_radius, scaled<u16le, meter_0_to_10>>>>;
    };
};

/// Record PrismaticJointSpecificationRec.
struct prismatic_joint_specification_rec {
    double link_length{};                                         ///< meter, -10 to 10
    double twist_angle{};                                         ///< radian, -pi to pi
    double joint_angle{};                                         ///< radian, -pi to pi
    double min_value{};                                           ///< meter, -10 to 10
    double max_value{};                                           ///< meter, -10 to 10
    std::optional<double> max_speed{};                            ///< meter per second, -5 to 5
    std::optional<double> max_force{};                            ///< newton, 0 to 5000
    std::optional<double> joint_bounding_cylinder_radius{};       ///< meter, 0 to 10
    std::optional<double> link_length_bounding_cylinder_radius{}; ///< meter, 0 to 10
    friend constexpr bool operator==(
        const prismatic_joint_specification_rec&,
        const prismatic_joint_specification_rec&) = default;

    struct schema : wire::items {
        using T = prismatic_joint_specification_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::link_length, scaled<u16le, meter_minus_10_to_10>>,
                field<&T::twist_angle, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::joint_angle, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::min_value, scaled<u32le, meter_minus_10_to_10>>,
                field<&T::max_value, scaled<u32le, meter_minus_10_to_10>>,
                field<&T::max_speed, scaled<u32le, meter_per_second_minus_5_to_5>>,
                field<&T::max_force, scaled<u32le, newton_0_to_5000>>,
                field<&T::joint_bounding_cylinder_radius, scaled<u16le, meter_0_to_10>>,
                field<&T::link_length_bounding_cylinder_radius, scaled<u16le, meter_0_to_10>>>>;
    };
};

/// Variant JointSpecifications.
struct joint_specifications {
    std::variant<revolute_joint_specification_rec, prismatic_joint_specification_rec> value{};
    friend constexpr bool operator==(const joint_specifications&, const joint_specifications&) = default;

    struct schema : wire::items {
        using T = joint_specifications;
        using type = layout<variant<&T::value, u8>>;
    };
};

/// Record JointNameRec.
struct joint_name_rec {
    std::string_view description{}; ///< up to 255 characters
    friend constexpr bool operator==(const joint_name_rec&, const joint_name_rec&) = default;

    struct schema : wire::items {
        using T = joint_name_rec;
        using type = layout<string<&T::description, count<"description_size", u8>>>;
    };
};

/// ReportManipulatorSpecifications: ID 4600h, output of ManipulatorSpecificationService.
struct report_manipulator_specifications {
    std::optional<manipulator::manipulator_coordinate_system_rec> manipulator_coordinate_system_rec{};
    std::variant<revolute_joint1_offset_rec, prismatic_joint1_angle_rec> first_joint_parameters{};
    wire::list<joint_specifications> joint_specification_list{};  ///< up to 255 elements
    std::optional<wire::list<joint_name_rec>> joint_names_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_manipulator_specifications&,
        const report_manipulator_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4600;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_manipulator_specifications;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                nested<&T::manipulator_coordinate_system_rec>,
                variant<&T::first_joint_parameters, u8>,
                repeated<&T::joint_specification_list, count<"number_of_joint_specification_list", u8>>,
                repeated<&T::joint_names_list, count<"number_of_joint_names_list", u8>>>>;
    };
};

namespace services {

/// ManipulatorSpecificationService: what it is called, and its messages.
struct manipulator_specification_service {
    static constexpr std::string_view name = "ManipulatorSpecificationService";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorSpecificationService";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_manipulator_specifications>;
    using outputs = jaus::message_list<report_manipulator_specifications>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
