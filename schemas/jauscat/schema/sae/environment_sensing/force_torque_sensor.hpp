// ForceTorqueSensor 2.0, urn:jaus:jss:environmentSensing:ForceTorqueSensor.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/environment_sensing/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::environment_sensing {

/// Record QueryForceTorqueCapabilitiesRec.
struct query_force_torque_capabilities_rec {
    std::uint16_t sensor_id{};
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_force_torque_capabilities_rec&,
        const query_force_torque_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = query_force_torque_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, u16le>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryForceTorqueCapabilities: ID 280Bh, input of ForceTorqueSensor.
struct query_force_torque_capabilities {
    wire::list<query_force_torque_capabilities_rec> query_force_torque_capabilities_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_force_torque_capabilities&,
        const query_force_torque_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x280B;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_force_torque_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_force_torque_capabilities_list,
                count<"number_of_query_force_torque_capabilities_list", u16le>>>;
    };
};

/// Values of CoordinateSystem.
enum class coordinate_system : std::uint8_t {
    native_coordinate_systems = 0,
    vehicle_coordinate_systems = 1,
};

/// Record QueryForceTorqueRec.
struct query_force_torque_rec {
    std::uint16_t sensor_id{};
    environment_sensing::coordinate_system coordinate_system{};
    std::uint8_t query_presence_vector{};
    friend constexpr bool operator==(const query_force_torque_rec&, const query_force_torque_rec&) = default;

    struct schema : wire::items {
        using T = query_force_torque_rec;
        using type = layout<
            field<&T::sensor_id, u16le>,
            field<&T::coordinate_system,
                in_value_set<enumeration<environment_sensing::coordinate_system, u8>, between<0, 1>>>,
            field<&T::query_presence_vector, u8>>;
    };
};

/// QueryForceTorque: ID 280Ch, input of ForceTorqueSensor.
struct query_force_torque {
    wire::list<query_force_torque_rec> query_force_torque_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const query_force_torque&, const query_force_torque&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x280C;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_force_torque;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_force_torque_list, count<"number_of_query_force_torque_list", u16le>>>;
    };
};

/// Values of CoordinateTransformSupported.
enum class coordinate_transform_supported : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Record ReportForceTorqueCapabilitiesRec.
struct report_force_torque_capabilities_rec {
    std::uint16_t sensor_id{};
    std::string_view sensor_name{};       ///< up to 255 characters
    std::optional<environment_sensing::coordinate_transform_supported> coordinate_transform_supported{};
    std::optional<double> min_force_x{};  ///< newton, -5000 to 5000
    std::optional<double> max_force_x{};  ///< newton, -5000 to 5000
    std::optional<double> min_force_y{};  ///< newton, -5000 to 5000
    std::optional<double> max_force_y{};  ///< newton, -5000 to 5000
    std::optional<double> min_force_z{};  ///< newton, -5000 to 5000
    std::optional<double> max_force_z{};  ///< newton, -5000 to 5000
    std::optional<double> min_torque_x{}; ///< newton meter, -5000 to 5000
    std::optional<double> max_torque_x{}; ///< newton meter, -5000 to 5000
    std::optional<double> min_torque_y{}; ///< newton meter, -5000 to 5000
    std::optional<double> max_torque_y{}; ///< newton meter, -5000 to 5000
    std::optional<double> min_torque_z{}; ///< newton meter, -5000 to 5000
    std::optional<double> max_torque_z{}; ///< newton meter, -5000 to 5000
    friend constexpr bool operator==(
        const report_force_torque_capabilities_rec&,
        const report_force_torque_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = report_force_torque_capabilities_rec;
        using type = layout<
            lenient_presence<u16le,
                field<&T::sensor_id, u16le>,
                string<&T::sensor_name, count<"sensor_name_size", u8>>,
                field<&T::coordinate_transform_supported,
                    in_value_set<enumeration<environment_sensing::coordinate_transform_supported, u8>, between<0, 1>>>,
                field<&T::min_force_x, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::max_force_x, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::min_force_y, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::max_force_y, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::min_force_z, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::max_force_z, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::min_torque_x, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::max_torque_x, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::min_torque_y, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::max_torque_y, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::min_torque_z, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::max_torque_z, scaled<u16le, newton_meter_minus_5000_to_5000>>>>;
    };
};

/// ReportForceTorqueCapabilities: ID 480Bh, output of ForceTorqueSensor.
struct report_force_torque_capabilities {
    wire::list<report_force_torque_capabilities_rec> report_force_torque_capabilities_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_force_torque_capabilities&,
        const report_force_torque_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x480B;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_force_torque_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::report_force_torque_capabilities_list,
                count<"number_of_report_force_torque_capabilities_list", u16le>>>;
    };
};

/// Record ReportForceTorqueRec.
struct report_force_torque_rec {
    std::uint16_t sensor_id{};
    environment_sensing::coordinate_system coordinate_system{};
    std::optional<double> force_x{};  ///< newton, -5000 to 5000
    std::optional<double> force_y{};  ///< newton, -5000 to 5000
    std::optional<double> force_z{};  ///< newton, -5000 to 5000
    std::optional<double> torque_x{}; ///< newton meter, -5000 to 5000
    std::optional<double> torque_y{}; ///< newton meter, -5000 to 5000
    std::optional<double> torque_z{}; ///< newton meter, -5000 to 5000
    friend constexpr bool operator==(const report_force_torque_rec&, const report_force_torque_rec&) = default;

    struct schema : wire::items {
        using T = report_force_torque_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, u16le>,
                field<&T::coordinate_system,
                    in_value_set<enumeration<environment_sensing::coordinate_system, u8>, between<0, 1>>>,
                field<&T::force_x, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::force_y, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::force_z, scaled<u16le, newton_minus_5000_to_5000>>,
                field<&T::torque_x, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::torque_y, scaled<u16le, newton_meter_minus_5000_to_5000>>,
                field<&T::torque_z, scaled<u16le, newton_meter_minus_5000_to_5000>>>>;
    };
};

/// ReportForceTorque: ID 480Ch, output of ForceTorqueSensor.
struct report_force_torque {
    wire::list<report_force_torque_rec> report_force_torque_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const report_force_torque&, const report_force_torque&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x480C;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_force_torque;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::report_force_torque_list, count<"number_of_report_force_torque_list", u16le>>>;
    };
};

namespace services {

/// ForceTorqueSensor: what it is called, and its messages.
struct force_torque_sensor {
    static constexpr std::string_view name = "ForceTorqueSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:ForceTorqueSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_force_torque_capabilities, query_force_torque>;
    using outputs = jaus::message_list<report_force_torque_capabilities, report_force_torque>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
