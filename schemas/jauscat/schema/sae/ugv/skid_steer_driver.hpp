// SkidSteerDriver 1.0, urn:jaus:jss:ugv:SkidSteerDriver.
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

/// SetSkidSteerEffort: ID 0501h, command, input of SkidSteerDriver.
struct set_skid_steer_effort {
    double left_side_propulsive_effort{};  ///< -100 to 100
    double right_side_propulsive_effort{}; ///< -100 to 100
    friend constexpr bool operator==(const set_skid_steer_effort&, const set_skid_steer_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0501;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_skid_steer_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::left_side_propulsive_effort, scaled<u16le, one_minus_100_to_100>>,
            field<&T::right_side_propulsive_effort, scaled<u16le, one_minus_100_to_100>>>;
    };
};

/// QuerySkidSteerEffort: ID 2501h, input of SkidSteerDriver.
struct query_skid_steer_effort {
    friend constexpr bool operator==(const query_skid_steer_effort&, const query_skid_steer_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2501;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportSkidSteerEffort: ID 4501h, output of SkidSteerDriver.
struct report_skid_steer_effort {
    double left_side_propulsive_effort{};  ///< -100 to 100
    double right_side_propulsive_effort{}; ///< -100 to 100
    friend constexpr bool operator==(const report_skid_steer_effort&, const report_skid_steer_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4501;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_skid_steer_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::left_side_propulsive_effort, scaled<u16le, one_minus_100_to_100>>,
            field<&T::right_side_propulsive_effort, scaled<u16le, one_minus_100_to_100>>>;
    };
};

namespace services {

/// SkidSteerDriver: what it is called, and its messages.
struct skid_steer_driver {
    static constexpr std::string_view name = "SkidSteerDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:SkidSteerDriver";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<set_skid_steer_effort, query_skid_steer_effort>;
    using outputs = jaus::message_list<report_skid_steer_effort>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
