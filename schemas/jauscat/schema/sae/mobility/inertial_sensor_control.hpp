// InertialSensorControl 1.1, urn:jaus:jss:mobility:InertialSensorControl.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/mobility/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::mobility {

/// Values of Command.
enum class command : std::uint8_t {
    off = 0,
    on = 1,
    restart = 2,
};

/// InertialSensorControl: ID 0429h, command, input of InertialSensorControl.
struct inertial_sensor_control {
    mobility::command command{};
    friend constexpr bool operator==(const inertial_sensor_control&, const inertial_sensor_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0429;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = inertial_sensor_control;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::command, in_value_set<enumeration<mobility::command, u8>, between<0, 2>>>>;
    };
};

/// QueryInertialSensorStatus: ID 2429h, input of InertialSensorControl.
struct query_inertial_sensor_status {
    friend constexpr bool operator==(
        const query_inertial_sensor_status&,
        const query_inertial_sensor_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2429;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Values of PowerState.
enum class power_state : std::uint8_t {
    off = 0,
    on = 1,
    restarting = 2,
};

/// Values of OperatingState.
enum class operating_state : std::uint8_t {
    init = 0,
    operational = 1,
    coarse_stationary_alignment = 2,
    coarse_gps_alignment = 3,
    fine_stationary_alignment_started = 4,
    fine_stationary_alignment_complete = 5,
    fine_gps_alignment_started = 6,
    fine_gps_alignment_complete = 7,
    inertial_sensor_failure = 8,
};

/// ReportInertialSensorStatus: ID 4429h, output of InertialSensorControl.
struct report_inertial_sensor_status {
    mobility::power_state power_state{};
    mobility::operating_state operating_state{};
    friend constexpr bool operator==(
        const report_inertial_sensor_status&,
        const report_inertial_sensor_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4429;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_inertial_sensor_status;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::power_state, in_value_set<enumeration<mobility::power_state, u8>, between<0, 2>>>,
            field<&T::operating_state, in_value_set<enumeration<mobility::operating_state, u8>, between<0, 8>>>>;
    };
};

namespace services {

/// InertialSensorControl: what it is called, and its messages.
struct inertial_sensor_control {
    static constexpr std::string_view name = "InertialSensorControl";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:InertialSensorControl";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<inertial_sensor_control, query_inertial_sensor_status>;
    using outputs = jaus::message_list<report_inertial_sensor_status>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
