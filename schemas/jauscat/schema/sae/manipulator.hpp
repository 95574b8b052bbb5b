// All services of the set manipulator, and the list of their messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_actuator_force_torque_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_end_effector_pose_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_end_effector_pose_list_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_end_effector_pose_sensor.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_end_effector_velocity_state_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_end_effector_velocity_state_sensor.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_joint_force_torque_sensor.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_joint_position_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_joint_position_list_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_joint_velocity_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_joint_velocity_sensor.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_list_driver.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_specification_service.hpp>
#include <jauscat/schema/sae/manipulator/pan_tilt_joint_position_driver.hpp>
#include <jauscat/schema/sae/manipulator/pan_tilt_joint_position_sensor.hpp>
#include <jauscat/schema/sae/manipulator/pan_tilt_joint_velocity_sensor.hpp>
#include <jauscat/schema/sae/manipulator/pan_tilt_motion_profile_service.hpp>
#include <jauscat/schema/sae/manipulator/pan_tilt_specification_service.hpp>
#include <jauscat/schema/sae/manipulator/primitive_manipulator.hpp>
#include <jauscat/schema/sae/manipulator/primitive_pan_tilt.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::manipulator {

/// Each message once, by its ID.
using messages = jaus::message_list<
    set_joint_effort,
    set_joint_positions,
    set_joint_velocity,
    set_end_effector_pose,
    set_end_effector_velocity_state,
    set_actuator_force_torques,
    execute_list,
    set_pan_tilt_joint_effort,
    set_pan_tilt_joint_positions,
    set_pan_tilt_motion_profile,
    query_manipulator_specifications,
    query_joint_effort,
    query_joint_velocity,
    query_joint_force_torques,
    query_commanded_joint_positions,
    query_commanded_end_effector_pose,
    query_commanded_joint_velocity,
    query_commanded_end_effector_velocity_state,
    query_commanded_actuator_force_torques,
    query_end_effector_pose,
    query_end_effector_velocity_state,
    query_active_element,
    query_pan_tilt_specifications,
    query_pan_tilt_joint_effort,
    query_pan_tilt_joint_positions,
    query_pan_tilt_joint_velocity,
    query_pan_tilt_motion_profile,
    query_commanded_pan_tilt_joint_positions,
    report_manipulator_specifications,
    report_joint_effort,
    report_joint_velocity,
    report_joint_force_torques,
    report_commanded_joint_positions,
    report_commanded_end_effector_pose,
    report_commanded_joint_velocity,
    report_commanded_end_effector_velocity_state,
    report_commanded_actuator_force_torques,
    report_end_effector_pose,
    report_end_effector_velocity_state,
    report_active_element,
    report_pan_tilt_specifications,
    report_pan_tilt_joint_effort,
    report_pan_tilt_joint_positions,
    report_pan_tilt_joint_velocity,
    report_pan_tilt_motion_profile,
    report_commanded_pan_tilt_joint_positions>;

} // namespace jauscat::sae::manipulator
