// OdometryService 1.0, urn:jaus:jss:ugv:OdometryService.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::ugv {

/// Values of OdometryType.
enum class odometry_type : std::uint8_t {
    trip_a = 2,
    trip_b = 3,
    trip_c = 4,
};

/// ResetOdometry: ID 0515h, command, input of OdometryService.
struct reset_odometry {
    ugv::odometry_type odometry_type{};
    friend constexpr bool operator==(const reset_odometry&, const reset_odometry&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0515;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = reset_odometry;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::odometry_type, in_value_set<enumeration<ugv::odometry_type, u8>, between<2, 4>>>>;
    };
};

/// Values of odom.
enum class odom : std::uint8_t {
    platform = 1,
    trip_a = 2,
    trip_b = 3,
    trip_c = 4,
};

/// QueryOdometry: ID 2515h, input of OdometryService.
struct query_odometry {
    ugv::odom odom{};
    friend constexpr bool operator==(const query_odometry&, const query_odometry&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2515;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_odometry;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::odom, in_value_set<enumeration<ugv::odom, u8>, between<1, 4>>>>;
    };
};

/// ReportOdometry: ID 4515h, output of OdometryService.
struct report_odometry {
    ugv::odom odom{};
    std::uint32_t odometry{}; ///< meter
    friend constexpr bool operator==(const report_odometry&, const report_odometry&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4515;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_odometry;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::odom, in_value_set<enumeration<ugv::odom, u8>, between<1, 4>>>,
            field<&T::odometry, in_units<u32le, meter>>>;
    };
};

namespace services {

/// OdometryService: what it is called, and its messages.
struct odometry_service {
    static constexpr std::string_view name = "OdometryService";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:OdometryService";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<reset_odometry, query_odometry>;
    using outputs = jaus::message_list<report_odometry>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
