// Dispatch by hand: a switch over the command codes of every message, one case each. The floor for the dispatcher.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/messages.hpp>

namespace hand_written {

namespace jaus = jauscat::jaus;

/// Calls `step.operator()<Message>()` for the message that has this code; false for a code that none has.
// clang-format off
inline bool dispatch(std::uint16_t command_code, auto&& step) {
    switch (command_code) {
    case jaus::command_code_of<jaus::set_component_authority>: return step.template operator()<jaus::set_component_authority>();
    case jaus::command_code_of<jaus::shutdown>: return step.template operator()<jaus::shutdown>();
    case jaus::command_code_of<jaus::standby>: return step.template operator()<jaus::standby>();
    case jaus::command_code_of<jaus::resume>: return step.template operator()<jaus::resume>();
    case jaus::command_code_of<jaus::reset>: return step.template operator()<jaus::reset>();
    case jaus::command_code_of<jaus::set_emergency>: return step.template operator()<jaus::set_emergency>();
    case jaus::command_code_of<jaus::clear_emergency>: return step.template operator()<jaus::clear_emergency>();
    case jaus::command_code_of<jaus::create_service_connection>: return step.template operator()<jaus::create_service_connection>();
    case jaus::command_code_of<jaus::confirm_service_connection>: return step.template operator()<jaus::confirm_service_connection>();
    case jaus::command_code_of<jaus::activate_service_connection>: return step.template operator()<jaus::activate_service_connection>();
    case jaus::command_code_of<jaus::suspend_service_connection>: return step.template operator()<jaus::suspend_service_connection>();
    case jaus::command_code_of<jaus::terminate_service_connection>: return step.template operator()<jaus::terminate_service_connection>();
    case jaus::command_code_of<jaus::request_component_control>: return step.template operator()<jaus::request_component_control>();
    case jaus::command_code_of<jaus::release_component_control>: return step.template operator()<jaus::release_component_control>();
    case jaus::command_code_of<jaus::confirm_component_control>: return step.template operator()<jaus::confirm_component_control>();
    case jaus::command_code_of<jaus::reject_component_control>: return step.template operator()<jaus::reject_component_control>();
    case jaus::command_code_of<jaus::set_time>: return step.template operator()<jaus::set_time>();
    case jaus::command_code_of<jaus::create_event>: return step.template operator()<jaus::create_event>();
    case jaus::command_code_of<jaus::update_event>: return step.template operator()<jaus::update_event>();
    case jaus::command_code_of<jaus::cancel_event>: return step.template operator()<jaus::cancel_event>();
    case jaus::command_code_of<jaus::confirm_event_request>: return step.template operator()<jaus::confirm_event_request>();
    case jaus::command_code_of<jaus::reject_event_request>: return step.template operator()<jaus::reject_event_request>();
    case jaus::command_code_of<jaus::set_data_link_state>: return step.template operator()<jaus::set_data_link_state>();
    case jaus::command_code_of<jaus::set_data_link_select>: return step.template operator()<jaus::set_data_link_select>();
    case jaus::command_code_of<jaus::set_selected_data_link_state>: return step.template operator()<jaus::set_selected_data_link_state>();
    case jaus::command_code_of<jaus::set_velocity_state>: return step.template operator()<jaus::set_velocity_state>();
    case jaus::command_code_of<jaus::set_wrench_effort>: return step.template operator()<jaus::set_wrench_effort>();
    case jaus::command_code_of<jaus::set_discrete_devices>: return step.template operator()<jaus::set_discrete_devices>();
    case jaus::command_code_of<jaus::set_global_vector>: return step.template operator()<jaus::set_global_vector>();
    case jaus::command_code_of<jaus::set_local_vector>: return step.template operator()<jaus::set_local_vector>();
    case jaus::command_code_of<jaus::set_travel_speed>: return step.template operator()<jaus::set_travel_speed>();
    case jaus::command_code_of<jaus::set_global_waypoint>: return step.template operator()<jaus::set_global_waypoint>();
    case jaus::command_code_of<jaus::set_local_waypoint>: return step.template operator()<jaus::set_local_waypoint>();
    case jaus::command_code_of<jaus::set_global_path_segment>: return step.template operator()<jaus::set_global_path_segment>();
    case jaus::command_code_of<jaus::set_local_path_segment>: return step.template operator()<jaus::set_local_path_segment>();
    case jaus::command_code_of<jaus::set_joint_efforts>: return step.template operator()<jaus::set_joint_efforts>();
    case jaus::command_code_of<jaus::set_joint_positions>: return step.template operator()<jaus::set_joint_positions>();
    case jaus::command_code_of<jaus::set_joint_velocities>: return step.template operator()<jaus::set_joint_velocities>();
    case jaus::command_code_of<jaus::set_tool_point>: return step.template operator()<jaus::set_tool_point>();
    case jaus::command_code_of<jaus::set_end_effector_pose>: return step.template operator()<jaus::set_end_effector_pose>();
    case jaus::command_code_of<jaus::set_end_effector_velocity_state>: return step.template operator()<jaus::set_end_effector_velocity_state>();
    case jaus::command_code_of<jaus::set_joint_motion>: return step.template operator()<jaus::set_joint_motion>();
    case jaus::command_code_of<jaus::set_end_effector_path_motion>: return step.template operator()<jaus::set_end_effector_path_motion>();
    case jaus::command_code_of<jaus::set_camera_pose>: return step.template operator()<jaus::set_camera_pose>();
    case jaus::command_code_of<jaus::select_camera>: return step.template operator()<jaus::select_camera>();
    case jaus::command_code_of<jaus::set_camera_capabilities>: return step.template operator()<jaus::set_camera_capabilities>();
    case jaus::command_code_of<jaus::set_camera_format_options>: return step.template operator()<jaus::set_camera_format_options>();
    case jaus::command_code_of<jaus::create_vector_knowledge_store_objects>: return step.template operator()<jaus::create_vector_knowledge_store_objects>();
    case jaus::command_code_of<jaus::set_vector_knowledge_store_feature_class_metadata>: return step.template operator()<jaus::set_vector_knowledge_store_feature_class_metadata>();
    case jaus::command_code_of<jaus::terminate_vector_knowledge_store_data_transfer>: return step.template operator()<jaus::terminate_vector_knowledge_store_data_transfer>();
    case jaus::command_code_of<jaus::delete_vector_knowledge_store_objects>: return step.template operator()<jaus::delete_vector_knowledge_store_objects>();
    case jaus::command_code_of<jaus::set_payload_data_element>: return step.template operator()<jaus::set_payload_data_element>();
    case jaus::command_code_of<jaus::spool_mission>: return step.template operator()<jaus::spool_mission>();
    case jaus::command_code_of<jaus::run_mission>: return step.template operator()<jaus::run_mission>();
    case jaus::command_code_of<jaus::abort_mission>: return step.template operator()<jaus::abort_mission>();
    case jaus::command_code_of<jaus::pause_mission>: return step.template operator()<jaus::pause_mission>();
    case jaus::command_code_of<jaus::resume_mission>: return step.template operator()<jaus::resume_mission>();
    case jaus::command_code_of<jaus::remove_messages>: return step.template operator()<jaus::remove_messages>();
    case jaus::command_code_of<jaus::replace_messages>: return step.template operator()<jaus::replace_messages>();
    case jaus::command_code_of<jaus::query_component_authority>: return step.template operator()<jaus::query_component_authority>();
    case jaus::command_code_of<jaus::query_component_status>: return step.template operator()<jaus::query_component_status>();
    case jaus::command_code_of<jaus::query_component_control>: return step.template operator()<jaus::query_component_control>();
    case jaus::command_code_of<jaus::query_time>: return step.template operator()<jaus::query_time>();
    case jaus::command_code_of<jaus::query_events>: return step.template operator()<jaus::query_events>();
    case jaus::command_code_of<jaus::query_data_link_status>: return step.template operator()<jaus::query_data_link_status>();
    case jaus::command_code_of<jaus::query_selected_data_link_status>: return step.template operator()<jaus::query_selected_data_link_status>();
    case jaus::command_code_of<jaus::query_heartbeat_pulse>: return step.template operator()<jaus::query_heartbeat_pulse>();
    case jaus::command_code_of<jaus::query_platform_specifications>: return step.template operator()<jaus::query_platform_specifications>();
    case jaus::command_code_of<jaus::query_platform_operational_data>: return step.template operator()<jaus::query_platform_operational_data>();
    case jaus::command_code_of<jaus::query_global_pose>: return step.template operator()<jaus::query_global_pose>();
    case jaus::command_code_of<jaus::query_local_pose>: return step.template operator()<jaus::query_local_pose>();
    case jaus::command_code_of<jaus::query_velocity_state>: return step.template operator()<jaus::query_velocity_state>();
    case jaus::command_code_of<jaus::query_wrench_effort>: return step.template operator()<jaus::query_wrench_effort>();
    case jaus::command_code_of<jaus::query_discrete_devices>: return step.template operator()<jaus::query_discrete_devices>();
    case jaus::command_code_of<jaus::query_global_vector>: return step.template operator()<jaus::query_global_vector>();
    case jaus::command_code_of<jaus::query_local_vector>: return step.template operator()<jaus::query_local_vector>();
    case jaus::command_code_of<jaus::query_travel_speed>: return step.template operator()<jaus::query_travel_speed>();
    case jaus::command_code_of<jaus::query_waypoint_count>: return step.template operator()<jaus::query_waypoint_count>();
    case jaus::command_code_of<jaus::query_global_waypoint>: return step.template operator()<jaus::query_global_waypoint>();
    case jaus::command_code_of<jaus::query_local_waypoint>: return step.template operator()<jaus::query_local_waypoint>();
    case jaus::command_code_of<jaus::query_path_segment_count>: return step.template operator()<jaus::query_path_segment_count>();
    case jaus::command_code_of<jaus::query_global_path_segment>: return step.template operator()<jaus::query_global_path_segment>();
    case jaus::command_code_of<jaus::query_local_path_segment>: return step.template operator()<jaus::query_local_path_segment>();
    case jaus::command_code_of<jaus::query_manipulator_specifications>: return step.template operator()<jaus::query_manipulator_specifications>();
    case jaus::command_code_of<jaus::query_joint_efforts>: return step.template operator()<jaus::query_joint_efforts>();
    case jaus::command_code_of<jaus::query_joint_positions>: return step.template operator()<jaus::query_joint_positions>();
    case jaus::command_code_of<jaus::query_joint_velocities>: return step.template operator()<jaus::query_joint_velocities>();
    case jaus::command_code_of<jaus::query_tool_point>: return step.template operator()<jaus::query_tool_point>();
    case jaus::command_code_of<jaus::query_joint_force_torques>: return step.template operator()<jaus::query_joint_force_torques>();
    case jaus::command_code_of<jaus::query_camera_pose>: return step.template operator()<jaus::query_camera_pose>();
    case jaus::command_code_of<jaus::query_camera_count>: return step.template operator()<jaus::query_camera_count>();
    case jaus::command_code_of<jaus::query_relative_object_position>: return step.template operator()<jaus::query_relative_object_position>();
    case jaus::command_code_of<jaus::query_selected_camera>: return step.template operator()<jaus::query_selected_camera>();
    case jaus::command_code_of<jaus::query_camera_capabilities>: return step.template operator()<jaus::query_camera_capabilities>();
    case jaus::command_code_of<jaus::query_camera_format_options>: return step.template operator()<jaus::query_camera_format_options>();
    case jaus::command_code_of<jaus::query_image>: return step.template operator()<jaus::query_image>();
    case jaus::command_code_of<jaus::query_vector_knowledge_store_feature_class_metadata>: return step.template operator()<jaus::query_vector_knowledge_store_feature_class_metadata>();
    case jaus::command_code_of<jaus::query_vector_knowledge_store_bounds>: return step.template operator()<jaus::query_vector_knowledge_store_bounds>();
    case jaus::command_code_of<jaus::query_vector_knowledge_store_objects>: return step.template operator()<jaus::query_vector_knowledge_store_objects>();
    case jaus::command_code_of<jaus::query_identification>: return step.template operator()<jaus::query_identification>();
    case jaus::command_code_of<jaus::query_configuration>: return step.template operator()<jaus::query_configuration>();
    case jaus::command_code_of<jaus::query_subsystem_list>: return step.template operator()<jaus::query_subsystem_list>();
    case jaus::command_code_of<jaus::query_services>: return step.template operator()<jaus::query_services>();
    case jaus::command_code_of<jaus::query_payload_interface>: return step.template operator()<jaus::query_payload_interface>();
    case jaus::command_code_of<jaus::query_payload_data_element>: return step.template operator()<jaus::query_payload_data_element>();
    case jaus::command_code_of<jaus::query_spooling_preference>: return step.template operator()<jaus::query_spooling_preference>();
    case jaus::command_code_of<jaus::query_mission_status>: return step.template operator()<jaus::query_mission_status>();
    case jaus::command_code_of<jaus::report_component_authority>: return step.template operator()<jaus::report_component_authority>();
    case jaus::command_code_of<jaus::report_component_status>: return step.template operator()<jaus::report_component_status>();
    case jaus::command_code_of<jaus::report_component_control>: return step.template operator()<jaus::report_component_control>();
    case jaus::command_code_of<jaus::report_time>: return step.template operator()<jaus::report_time>();
    case jaus::command_code_of<jaus::report_events>: return step.template operator()<jaus::report_events>();
    case jaus::command_code_of<jaus::event>: return step.template operator()<jaus::event>();
    case jaus::command_code_of<jaus::report_data_link_status>: return step.template operator()<jaus::report_data_link_status>();
    case jaus::command_code_of<jaus::report_selected_data_link_status>: return step.template operator()<jaus::report_selected_data_link_status>();
    case jaus::command_code_of<jaus::report_heartbeat_pulse>: return step.template operator()<jaus::report_heartbeat_pulse>();
    case jaus::command_code_of<jaus::report_platform_specifications>: return step.template operator()<jaus::report_platform_specifications>();
    case jaus::command_code_of<jaus::report_platform_operational_data>: return step.template operator()<jaus::report_platform_operational_data>();
    case jaus::command_code_of<jaus::report_global_pose>: return step.template operator()<jaus::report_global_pose>();
    case jaus::command_code_of<jaus::report_local_pose>: return step.template operator()<jaus::report_local_pose>();
    case jaus::command_code_of<jaus::report_velocity_state>: return step.template operator()<jaus::report_velocity_state>();
    case jaus::command_code_of<jaus::report_wrench_effort>: return step.template operator()<jaus::report_wrench_effort>();
    case jaus::command_code_of<jaus::report_discrete_devices>: return step.template operator()<jaus::report_discrete_devices>();
    case jaus::command_code_of<jaus::report_global_vector>: return step.template operator()<jaus::report_global_vector>();
    case jaus::command_code_of<jaus::report_local_vector>: return step.template operator()<jaus::report_local_vector>();
    case jaus::command_code_of<jaus::report_travel_speed>: return step.template operator()<jaus::report_travel_speed>();
    case jaus::command_code_of<jaus::report_waypoint_count>: return step.template operator()<jaus::report_waypoint_count>();
    case jaus::command_code_of<jaus::report_global_waypoint>: return step.template operator()<jaus::report_global_waypoint>();
    case jaus::command_code_of<jaus::report_local_waypoint>: return step.template operator()<jaus::report_local_waypoint>();
    case jaus::command_code_of<jaus::report_path_segment_count>: return step.template operator()<jaus::report_path_segment_count>();
    case jaus::command_code_of<jaus::report_global_path_segment>: return step.template operator()<jaus::report_global_path_segment>();
    case jaus::command_code_of<jaus::report_local_path_segment>: return step.template operator()<jaus::report_local_path_segment>();
    case jaus::command_code_of<jaus::report_manipulator_specifications>: return step.template operator()<jaus::report_manipulator_specifications>();
    case jaus::command_code_of<jaus::report_joint_efforts>: return step.template operator()<jaus::report_joint_efforts>();
    case jaus::command_code_of<jaus::report_joint_positions>: return step.template operator()<jaus::report_joint_positions>();
    case jaus::command_code_of<jaus::report_joint_velocities>: return step.template operator()<jaus::report_joint_velocities>();
    case jaus::command_code_of<jaus::report_tool_point>: return step.template operator()<jaus::report_tool_point>();
    case jaus::command_code_of<jaus::report_joint_force_torques>: return step.template operator()<jaus::report_joint_force_torques>();
    case jaus::command_code_of<jaus::report_camera_pose>: return step.template operator()<jaus::report_camera_pose>();
    case jaus::command_code_of<jaus::report_camera_count>: return step.template operator()<jaus::report_camera_count>();
    case jaus::command_code_of<jaus::report_relative_object_position>: return step.template operator()<jaus::report_relative_object_position>();
    case jaus::command_code_of<jaus::report_selected_camera>: return step.template operator()<jaus::report_selected_camera>();
    case jaus::command_code_of<jaus::report_camera_capabilities>: return step.template operator()<jaus::report_camera_capabilities>();
    case jaus::command_code_of<jaus::report_camera_format_options>: return step.template operator()<jaus::report_camera_format_options>();
    case jaus::command_code_of<jaus::report_image>: return step.template operator()<jaus::report_image>();
    case jaus::command_code_of<jaus::report_vector_knowledge_store_objects_creation>: return step.template operator()<jaus::report_vector_knowledge_store_objects_creation>();
    case jaus::command_code_of<jaus::report_vector_knowledge_store_feature_class_metadata>: return step.template operator()<jaus::report_vector_knowledge_store_feature_class_metadata>();
    case jaus::command_code_of<jaus::report_vector_knowledge_store_bounds>: return step.template operator()<jaus::report_vector_knowledge_store_bounds>();
    case jaus::command_code_of<jaus::report_vector_knowledge_store_objects>: return step.template operator()<jaus::report_vector_knowledge_store_objects>();
    case jaus::command_code_of<jaus::report_vector_knowledge_store_data_transfer_termination>: return step.template operator()<jaus::report_vector_knowledge_store_data_transfer_termination>();
    case jaus::command_code_of<jaus::report_identification>: return step.template operator()<jaus::report_identification>();
    case jaus::command_code_of<jaus::report_configuration>: return step.template operator()<jaus::report_configuration>();
    case jaus::command_code_of<jaus::report_subsystem_list>: return step.template operator()<jaus::report_subsystem_list>();
    case jaus::command_code_of<jaus::report_services>: return step.template operator()<jaus::report_services>();
    case jaus::command_code_of<jaus::report_payload_interface>: return step.template operator()<jaus::report_payload_interface>();
    case jaus::command_code_of<jaus::report_payload_data_element>: return step.template operator()<jaus::report_payload_data_element>();
    case jaus::command_code_of<jaus::report_spooling_preference>: return step.template operator()<jaus::report_spooling_preference>();
    case jaus::command_code_of<jaus::report_mission_status>: return step.template operator()<jaus::report_mission_status>();
    default: return false;
    }
}
// clang-format on

} // namespace hand_written
