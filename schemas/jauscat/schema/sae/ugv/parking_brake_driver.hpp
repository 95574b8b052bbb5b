// ParkingBrakeDriver 1.0, urn:jaus:jss:ugv:ParkingBrakeDriver.
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

/// SetParkingBrake: ID 0512h, command, input of ParkingBrakeDriver.
struct set_parking_brake {
    double parking_brake{}; ///< 0 to 100
    friend constexpr bool operator==(const set_parking_brake&, const set_parking_brake&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0512;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_parking_brake;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::parking_brake, scaled<u8, one_0_to_100>>>;
    };
};

/// QueryParkingBrake: ID 2512h, input of ParkingBrakeDriver.
struct query_parking_brake {
    friend constexpr bool operator==(const query_parking_brake&, const query_parking_brake&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2512;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportParkingBrake: ID 4512h, output of ParkingBrakeDriver.
struct report_parking_brake {
    double commanded_parking_brake{}; ///< 0 to 100
    double actual_parking_brake{};    ///< 0 to 100
    friend constexpr bool operator==(const report_parking_brake&, const report_parking_brake&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4512;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_parking_brake;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::commanded_parking_brake, scaled<u8, one_0_to_100>>,
            field<&T::actual_parking_brake, scaled<u8, one_0_to_100>>>;
    };
};

namespace services {

/// ParkingBrakeDriver: what it is called, and its messages.
struct parking_brake_driver {
    static constexpr std::string_view name = "ParkingBrakeDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:ParkingBrakeDriver";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<set_parking_brake, query_parking_brake>;
    using outputs = jaus::message_list<report_parking_brake>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
