// ManipulatorJointPositionDriver 2.0, urn:jaus:jss:manipulator:ManipulatorJointPositionDriver.
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

/// SetJointPositions: ID 0602h, command, input of ManipulatorJointPositionDriver.
struct set_joint_positions {
    wire::list<joint_position_rec> joint_position_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const set_joint_positions&, const set_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0602;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_joint_positions;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::joint_position_list, count<"number_of_joint_position_list", u8>>>;
    };
};

namespace services {

/// ManipulatorJointPositionDriver: what it is called, and its messages.
struct manipulator_joint_position_driver {
    static constexpr std::string_view name = "ManipulatorJointPositionDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_commanded_joint_positions, set_joint_positions>;
    using outputs = jaus::message_list<report_commanded_joint_positions>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
