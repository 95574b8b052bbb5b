// All services of the set environment_sensing, and the list of their messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/environment_sensing/analog_video.hpp>
#include <jauscat/schema/sae/environment_sensing/digital_audio_output.hpp>
#include <jauscat/schema/sae/environment_sensing/digital_resource_discovery.hpp>
#include <jauscat/schema/sae/environment_sensing/digital_video.hpp>
#include <jauscat/schema/sae/environment_sensing/force_torque_sensor.hpp>
#include <jauscat/schema/sae/environment_sensing/range_sensor.hpp>
#include <jauscat/schema/sae/environment_sensing/still_image.hpp>
#include <jauscat/schema/sae/environment_sensing/video_illuminator.hpp>
#include <jauscat/schema/sae/environment_sensing/visual_sensor.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::environment_sensing {

/// Each message once, by its ID.
using messages = jaus::message_list<
    confirm_sensor_configuration,
    set_range_sensor_configuration,
    set_visual_sensor_configuration,
    set_digital_video_sensor_configuration,
    control_digital_video_sensor_stream,
    set_analog_video_sensor_configuration,
    set_still_image_sensor_configuration,
    register_digital_resource_endpoint,
    remove_digital_resource_endpoint,
    confirm_digital_resource_endpoint,
    control_digital_video_sensor_recording,
    set_digital_audio_output_source,
    set_video_illuminator_configuration,
    query_range_sensor_capabilities,
    query_range_sensor_configuration,
    query_range_sensor_data,
    query_range_sensor_compressed_data,
    query_sensor_geometric_properties,
    query_visual_sensor_capabilities,
    query_visual_sensor_configuration,
    query_digital_video_sensor_configuration,
    query_visual_sensor_capabilities_ext,
    query_force_torque_capabilities,
    query_force_torque,
    query_analog_video_sensor_capabilities,
    query_analog_video_sensor_configuration,
    query_still_image_sensor_capabilities,
    query_still_image_sensor_configuration,
    query_digital_resource_endpoint,
    query_digital_audio_output_source,
    query_digital_audio_output_capabilities,
    query_video_illuminator_configuration,
    query_video_illuminator_capabilities,
    query_still_image_data_ext,
    query_digital_video_sensor_capabilities_ext,
    query_digital_video_sensor_status,
    report_range_sensor_capabilities,
    report_range_sensor_configuration,
    report_range_sensor_data,
    report_range_sensor_compressed_data,
    report_sensor_geometric_properties,
    report_visual_sensor_capabilities,
    report_visual_sensor_configuration,
    report_digital_video_sensor_configuration,
    report_visual_sensor_capabilities_ext,
    report_force_torque_capabilities,
    report_force_torque,
    report_analog_video_sensor_capabilities,
    report_analog_video_sensor_configuration,
    report_still_image_sensor_capabilities,
    report_still_image_sensor_configuration,
    report_digital_resource_endpoint,
    report_digital_audio_output_source,
    report_digital_audio_output_capabilities,
    report_video_illuminator_configuration,
    report_video_illuminator_capabilities,
    report_still_image_data_ext,
    report_digital_video_sensor_capabilities_ext,
    report_digital_video_sensor_status>;

} // namespace jauscat::sae::environment_sensing
