// PrimitivePanTilt 2.0, urn:jaus:jss:manipulator:PrimitivePanTilt.
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

/// QueryPanTiltJointEffort: ID 2621h, input of PrimitivePanTilt.
struct query_pan_tilt_joint_effort {
    friend constexpr bool operator==(const query_pan_tilt_joint_effort&, const query_pan_tilt_joint_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2621;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// SetPanTiltJointEffort: ID 0621h, command, input of PrimitivePanTilt.
struct set_pan_tilt_joint_effort {
    double joint1_effort{}; ///< -100 to 100
    double joint2_effort{}; ///< -100 to 100
    friend constexpr bool operator==(const set_pan_tilt_joint_effort&, const set_pan_tilt_joint_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0621;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_pan_tilt_joint_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_effort, scaled<u16le, one_minus_100_to_100>>,
            field<&T::joint2_effort, scaled<u16le, one_minus_100_to_100>>>;
    };
};

/// ReportPanTiltJointEffort: ID 4621h, output of PrimitivePanTilt.
struct report_pan_tilt_joint_effort {
    double joint1_effort{}; ///< -100 to 100
    double joint2_effort{}; ///< -100 to 100
    friend constexpr bool operator==(
        const report_pan_tilt_joint_effort&,
        const report_pan_tilt_joint_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4621;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_pan_tilt_joint_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_effort, scaled<u16le, one_minus_100_to_100>>,
            field<&T::joint2_effort, scaled<u16le, one_minus_100_to_100>>>;
    };
};

namespace services {

/// PrimitivePanTilt: what it is called, and its messages.
struct primitive_pan_tilt {
    static constexpr std::string_view name = "PrimitivePanTilt";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PrimitivePanTilt";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_pan_tilt_joint_effort, set_pan_tilt_joint_effort>;
    using outputs = jaus::message_list<report_pan_tilt_joint_effort>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
