// All services of the set ugv, and the list of their messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ugv/ackermann_driver.hpp>
#include <jauscat/schema/sae/ugv/illumination_service.hpp>
#include <jauscat/schema/sae/ugv/odometry_service.hpp>
#include <jauscat/schema/sae/ugv/parking_brake_driver.hpp>
#include <jauscat/schema/sae/ugv/platform_specifications_service.hpp>
#include <jauscat/schema/sae/ugv/power_plant_manager.hpp>
#include <jauscat/schema/sae/ugv/skid_steer_driver.hpp>
#include <jauscat/schema/sae/ugv/stabilizer_driver.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::ugv {

/// Each message once, by its ID.
using messages = jaus::message_list<
    set_ackermann_configuration,
    set_skid_steer_effort,
    set_stabilizer_effort,
    set_stabilizer_position,
    set_power_plant_configuration,
    set_parking_brake,
    set_illumination_state,
    reset_odometry,
    query_ackermann_configuration,
    query_skid_steer_effort,
    query_platform_specifications,
    query_stabilizer_effort,
    query_stabilizer_position,
    query_stabilizer_capabilities,
    query_power_plant_configuration,
    query_power_plant_capabilities,
    query_power_plant_status,
    query_parking_brake,
    query_illumination_state,
    query_illumination_configuration,
    query_odometry,
    report_ackermann_configuration,
    report_skid_steer_effort,
    report_platform_specifications,
    report_stabilizer_effort,
    report_stabilizer_position,
    report_stabilizer_capabilities,
    report_power_plant_configuration,
    report_power_plant_capabilities,
    report_power_plant_status,
    report_parking_brake,
    report_illumination_state,
    report_illumination_configuration,
    report_odometry>;

} // namespace jauscat::sae::ugv
