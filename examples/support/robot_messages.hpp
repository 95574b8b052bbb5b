// The messages that the example nodes show field by field. Others are shown in hex, because a node with all 158 takes
// long to compile; jausdump shows all.
#pragma once
#include <jauscat/schema/jaus/messages.hpp>

using robot_messages = jauscat::jaus::message_list<
    jauscat::jaus::set_component_authority, jauscat::jaus::set_emergency, jauscat::jaus::clear_emergency,
    jauscat::jaus::set_wrench_effort, jauscat::jaus::set_travel_speed, jauscat::jaus::query_component_status,
    jauscat::jaus::query_global_pose, jauscat::jaus::query_wrench_effort, jauscat::jaus::query_travel_speed,
    jauscat::jaus::report_component_status, jauscat::jaus::report_heartbeat_pulse, jauscat::jaus::report_global_pose,
    jauscat::jaus::report_wrench_effort, jauscat::jaus::report_travel_speed>;
