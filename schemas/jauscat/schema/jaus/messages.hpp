// Every message that has a schema, as a list of types.
#pragma once
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jauscat::jaus {

/// Message types, for code that is the same for each of them.
template <class... Messages> struct message_list {};

// One line per message, by command code.
// clang-format off
using messages = message_list<
    set_component_authority,
    set_emergency,
    clear_emergency,
    set_wrench_effort,
    set_travel_speed,
    query_component_status,
    query_global_pose,
    query_wrench_effort,
    query_travel_speed,
    report_component_status,
    report_heartbeat_pulse,
    report_global_pose,
    report_wrench_effort,
    report_travel_speed>;
// clang-format on

} // namespace jauscat::jaus
