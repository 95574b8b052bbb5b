// GlobalWaypointListDriver 1.1, urn:jaus:jss:mobility:GlobalWaypointListDriver.
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

namespace services {

/// GlobalWaypointListDriver: what it is called, and its messages.
struct global_waypoint_list_driver {
    static constexpr std::string_view name = "GlobalWaypointListDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalWaypointListDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:ListManager";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        execute_list,
        execute_list_ext,
        query_travel_speed,
        query_travel_speed_ext,
        query_global_waypoint,
        query_global_waypoint_ext,
        query_active_element>;
    using outputs = jaus::message_list<
        report_travel_speed,
        report_travel_speed_ext,
        report_global_waypoint,
        report_global_waypoint_ext,
        report_active_element>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
