// One translation unit that encodes and decodes the messages of one subgroup, platform: its compile time is one of the
// measures.
#include "encode_decode.hpp"
#include <jauscat/schema/jaus/platform.hpp>

using namespace jauscat::jaus;

bool one_subgroup(std::span<std::byte> bytes, jauscat::wire::arena& memory) {
    return bench::all<set_velocity_state, set_wrench_effort, set_discrete_devices, set_global_vector, set_local_vector,
                      set_travel_speed, set_global_waypoint, set_local_waypoint, set_global_path_segment,
                      set_local_path_segment, query_platform_specifications, query_platform_operational_data,
                      query_global_pose, query_local_pose, query_velocity_state, query_wrench_effort,
                      query_discrete_devices, query_global_vector, query_local_vector, query_travel_speed,
                      query_waypoint_count, query_global_waypoint, query_local_waypoint, query_path_segment_count,
                      query_global_path_segment, query_local_path_segment, report_platform_specifications,
                      report_platform_operational_data, report_global_pose, report_local_pose, report_velocity_state,
                      report_wrench_effort, report_discrete_devices, report_global_vector, report_local_vector,
                      report_travel_speed, report_waypoint_count, report_global_waypoint, report_local_waypoint,
                      report_path_segment_count, report_global_path_segment, report_local_path_segment>(bytes, memory);
}
