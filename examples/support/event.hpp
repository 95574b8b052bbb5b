// The events that the programs log. docs/log-events.md lists them with their members; tests/nodes/log_events.py
// compares.
#pragma once
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace example {

/// A kind of event, by its stable name.
struct event_kind {
    std::string_view name;
};

/// A typed member of an event. Addresses are texts such as "2.2.33.1", bytes texts such as "0a ff".
struct event_member {
    std::string_view name;
    std::variant<bool, std::int64_t, double, std::string> value;

    template <class Value>
    requires std::integral<Value> || std::floating_point<Value> || std::convertible_to<Value, std::string_view>
    event_member(std::string_view member_name, const Value& of) : name{member_name} {
        if constexpr (std::same_as<Value, bool>)
            value = of;
        else if constexpr (std::integral<Value>)
            value = static_cast<std::int64_t>(of);
        else if constexpr (std::floating_point<Value>)
            value = static_cast<double>(of);
        else
            value = std::string{std::string_view{of}};
    }
    /// The underlying number of an enumerator.
    template <class Value>
    requires std::is_enum_v<Value>
    event_member(std::string_view member_name, Value of)
        : event_member{member_name, static_cast<std::underlying_type_t<Value>>(of)} {}
};
using event_members = std::vector<event_member>;

/// `first`, then `more`.
inline event_members operator+(event_members first, const event_members& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

namespace events {

// All programs.
inline constexpr event_kind ready{"ready"};
inline constexpr event_kind stopped{"stopped"};
inline constexpr event_kind failed{"failed"};
inline constexpr event_kind usage_error{"usage_error"};
inline constexpr event_kind link_opened{"link_opened"};
inline constexpr event_kind link_problem{"link_problem"};
inline constexpr event_kind frame_not_returned{"frame_not_returned"};
inline constexpr event_kind web_opened{"web_opened"};

// JAUS nodes.
inline constexpr event_kind node_log{"node_log"};
inline constexpr event_kind bus_log{"bus_log"};
inline constexpr event_kind message_received{"message_received"};
inline constexpr event_kind message_sent{"message_sent"};
inline constexpr event_kind message_repeated{"message_repeated"};
inline constexpr event_kind peer_heard{"peer_heard"};
inline constexpr event_kind peer_lost{"peer_lost"};
inline constexpr event_kind state_changed{"state_changed"};
inline constexpr event_kind controller_taken{"controller_taken"};
inline constexpr event_kind controller_gone{"controller_gone"};

// The bridge of robot_controller.
inline constexpr event_kind slave_up{"slave_up"};
inline constexpr event_kind slave_lost{"slave_lost"};
inline constexpr event_kind slave_emergency{"slave_emergency"};
inline constexpr event_kind bring_up_failed{"bring_up_failed"};
inline constexpr event_kind no_process_data{"no_process_data"};
inline constexpr event_kind no_keep_alive{"no_keep_alive"};
inline constexpr event_kind drive_fault{"drive_fault"};
inline constexpr event_kind drive_fault_ended{"drive_fault_ended"};
inline constexpr event_kind stop_owed{"stop_owed"};
inline constexpr event_kind stop_refused{"stop_refused"};
inline constexpr event_kind stop_confirmed{"stop_confirmed"};
inline constexpr event_kind not_at_rest{"not_at_rest"};
inline constexpr event_kind packet_translated{"packet_translated"};
inline constexpr event_kind report_requested{"report_requested"};
inline constexpr event_kind image_written{"image_written"};
inline constexpr event_kind image_read{"image_read"};
inline constexpr event_kind not_delivered{"not_delivered"};
inline constexpr event_kind sdo_sent{"sdo_sent"};
inline constexpr event_kind sdo_received{"sdo_received"};
inline constexpr event_kind second_master{"second_master"};
inline constexpr event_kind broken_ring{"broken_ring"};

// EtherCAT slaves: robot_arm and emulated_bus.
inline constexpr event_kind slave_state{"slave_state"};
inline constexpr event_kind station_address{"station_address"};
inline constexpr event_kind object_written{"object_written"};
inline constexpr event_kind object_refused{"object_refused"};
inline constexpr event_kind emergency_sent{"emergency_sent"};

// robot_arm.
inline constexpr event_kind no_command_timeout{"no_command_timeout"};
inline constexpr event_kind efforts_in_force{"efforts_in_force"};
inline constexpr event_kind efforts_zeroed{"efforts_zeroed"};
inline constexpr event_kind efforts_commanded{"efforts_commanded"};
inline constexpr event_kind travel_speed_set{"travel_speed_set"};
inline constexpr event_kind emergency_cleared{"emergency_cleared"};
inline constexpr event_kind emergency_code_missing{"emergency_code_missing"};
inline constexpr event_kind authority_set{"authority_set"};
inline constexpr event_kind report_taken{"report_taken"};
inline constexpr event_kind report_prepared{"report_prepared"};
inline constexpr event_kind report_failed{"report_failed"};
inline constexpr event_kind message_unknown{"message_unknown"};
inline constexpr event_kind message_malformed{"message_malformed"};
inline constexpr event_kind refused_in_emergency{"refused_in_emergency"};

// ocu and communicator.
inline constexpr event_kind robot_heard{"robot_heard"};
inline constexpr event_kind robot_silent{"robot_silent"};
inline constexpr event_kind no_heartbeat{"no_heartbeat"};
inline constexpr event_kind heartbeats_counted{"heartbeats_counted"};
inline constexpr event_kind control_gained{"control_gained"};
inline constexpr event_kind control_refused{"control_refused"};
inline constexpr event_kind control_unanswered{"control_unanswered"};
inline constexpr event_kind control_lost{"control_lost"};
inline constexpr event_kind control_released{"control_released"};
inline constexpr event_kind release_unanswered{"release_unanswered"};
inline constexpr event_kind holding{"holding"};
inline constexpr event_kind not_sent{"not_sent"};
inline constexpr event_kind no_answer{"no_answer"};
inline constexpr event_kind not_acknowledged{"not_acknowledged"};
inline constexpr event_kind message_refused{"message_refused"};
inline constexpr event_kind copies_sent{"copies_sent"};
inline constexpr event_kind robot_controlled_by{"robot_controlled_by"};
inline constexpr event_kind robot_state{"robot_state"};
inline constexpr event_kind report_compared{"report_compared"};
inline constexpr event_kind done{"done"};
inline constexpr event_kind delivery{"delivery"};
inline constexpr event_kind peers{"peers"};
inline constexpr event_kind command_help{"command_help"};
inline constexpr event_kind log_switched{"log_switched"};
inline constexpr event_kind acknowledgement_switched{"acknowledgement_switched"};
inline constexpr event_kind line_refused{"line_refused"};

// cyclic.
inline constexpr event_kind memory_not_locked{"memory_not_locked"};
inline constexpr event_kind slave_configured{"slave_configured"};
inline constexpr event_kind clock_set_up{"clock_set_up"};
inline constexpr event_kind clocks_settling{"clocks_settling"};
inline constexpr event_kind clocks_locked{"clocks_locked"};
inline constexpr event_kind slave_stopped{"slave_stopped"};
inline constexpr event_kind slave_runs_again{"slave_runs_again"};
inline constexpr event_kind upload_failed{"upload_failed"};
inline constexpr event_kind measured{"measured"};

} // namespace events

} // namespace example
