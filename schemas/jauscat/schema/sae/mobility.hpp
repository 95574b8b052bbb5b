// All services of the set mobility, and the list of their messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/mobility/acceleration_state_sensor.hpp>
#include <jauscat/schema/sae/mobility/global_loiter_driver.hpp>
#include <jauscat/schema/sae/mobility/global_operating_zone.hpp>
#include <jauscat/schema/sae/mobility/global_path_segment_driver.hpp>
#include <jauscat/schema/sae/mobility/global_pose_sensor.hpp>
#include <jauscat/schema/sae/mobility/global_vector_driver.hpp>
#include <jauscat/schema/sae/mobility/global_waypoint_driver.hpp>
#include <jauscat/schema/sae/mobility/global_waypoint_list_driver.hpp>
#include <jauscat/schema/sae/mobility/gps_fix.hpp>
#include <jauscat/schema/sae/mobility/inertial_sensor_control.hpp>
#include <jauscat/schema/sae/mobility/local_loiter_driver.hpp>
#include <jauscat/schema/sae/mobility/local_operating_zone.hpp>
#include <jauscat/schema/sae/mobility/local_path_segment_driver.hpp>
#include <jauscat/schema/sae/mobility/local_vector_driver.hpp>
#include <jauscat/schema/sae/mobility/local_waypoint_driver.hpp>
#include <jauscat/schema/sae/mobility/primitive_driver.hpp>
#include <jauscat/schema/sae/mobility/velocity_state_sensor.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::mobility {

/// Each message once, by its ID.
using messages = jaus::message_list<
    set_global_pose,
    set_wrench_effort,
    set_global_vector,
    set_local_vector,
    set_travel_speed,
    set_global_waypoint,
    set_local_waypoint,
    set_geomagnetic_property,
    execute_list,
    delete_zone,
    set_global_operating_zone,
    set_global_loiter,
    set_local_loiter,
    set_local_operating_zone,
    request_gps_fix,
    inertial_sensor_control,
    set_global_pose_ext,
    set_global_vector_ext,
    set_local_vector_ext,
    set_travel_speed_ext,
    set_global_waypoint_ext,
    set_local_waypoint_ext,
    execute_list_ext,
    query_global_pose,
    query_velocity_state,
    query_wrench_effort,
    query_global_vector,
    query_local_vector,
    query_travel_speed,
    query_global_waypoint,
    query_local_waypoint,
    query_global_path_segment,
    query_local_path_segment,
    query_geomagnetic_property,
    query_acceleration_state,
    query_active_element,
    query_global_operating_zone,
    query_excursion,
    query_global_loiter,
    query_local_loiter,
    query_local_operating_zone,
    query_gps_fix,
    query_inertial_sensor_status,
    query_global_pose_ext,
    query_velocity_state_ext,
    query_global_vector_ext,
    query_local_vector_ext,
    query_travel_speed_ext,
    query_global_waypoint_ext,
    query_local_waypoint_ext,
    query_global_path_segment_ext,
    query_local_path_segment_ext,
    query_acceleration_state_ext,
    report_global_pose,
    report_velocity_state,
    report_wrench_effort,
    report_global_vector,
    report_local_vector,
    report_travel_speed,
    report_global_waypoint,
    report_local_waypoint,
    report_global_path_segment,
    report_local_path_segment,
    report_geomagnetic_property,
    report_acceleration_state,
    report_active_element,
    report_global_operating_zone,
    report_excursion,
    report_global_loiter,
    report_local_loiter,
    report_local_operating_zone,
    report_gps_fix,
    report_inertial_sensor_status,
    report_global_pose_ext,
    report_velocity_state_ext,
    report_global_vector_ext,
    report_local_vector_ext,
    report_travel_speed_ext,
    report_global_waypoint_ext,
    report_local_waypoint_ext,
    report_global_path_segment_ext,
    report_local_path_segment_ext,
    report_acceleration_state_ext>;

} // namespace jauscat::sae::mobility
