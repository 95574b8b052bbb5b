// PrimitiveManipulator 2.0, urn:jaus:jss:manipulator:PrimitiveManipulator.
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

/// QueryJointEffort: ID 2601h, input of PrimitiveManipulator.
struct query_joint_effort {
    friend constexpr bool operator==(const query_joint_effort&, const query_joint_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2601;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Record JointEffortRec.
struct joint_effort_rec {
    double joint_effort{}; ///< -100 to 100
    friend constexpr bool operator==(const joint_effort_rec&, const joint_effort_rec&) = default;

    struct schema : wire::items {
        using T = joint_effort_rec;
        using type = layout<field<&T::joint_effort, scaled<u16le, one_minus_100_to_100>>>;
    };
};

/// SetJointEffort: ID 0601h, command, input of PrimitiveManipulator.
struct set_joint_effort {
    wire::list<joint_effort_rec> joint_effort_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const set_joint_effort&, const set_joint_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0601;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_joint_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::joint_effort_list, count<"number_of_joint_effort_list", u8>>>;
    };
};

/// ReportJointEffort: ID 4601h, output of PrimitiveManipulator.
struct report_joint_effort {
    wire::list<joint_effort_rec> joint_effort_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_joint_effort&, const report_joint_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4601;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_joint_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::joint_effort_list, count<"number_of_joint_effort_list", u8>>>;
    };
};

namespace services {

/// PrimitiveManipulator: what it is called, and its messages.
struct primitive_manipulator {
    static constexpr std::string_view name = "PrimitiveManipulator";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PrimitiveManipulator";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_joint_effort, set_joint_effort>;
    using outputs = jaus::message_list<report_joint_effort>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
