// ManipulatorJointPositionListDriver 2.0, urn:jaus:jss:manipulator:ManipulatorJointPositionListDriver.
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

namespace services {

/// ManipulatorJointPositionListDriver: what it is called, and its messages.
struct manipulator_joint_position_list_driver {
    static constexpr std::string_view name = "ManipulatorJointPositionListDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorJointPositionListDriver";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:manipulator:ManipulatorListDriver";
    static constexpr std::string_view parent_version = "2.0";
    using inputs = jaus::message_list<query_commanded_joint_positions>;
    using outputs = jaus::message_list<report_commanded_joint_positions>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
