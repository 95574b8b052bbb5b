// Every message of RA 3.3 and the experimental 0404h, as a list of types.
#pragma once
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>
#include <jauscat/schema/jaus/environment_sensor.hpp>
#include <jauscat/schema/jaus/event.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/payload.hpp>
#include <jauscat/schema/jaus/planning.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/jaus/world_model.hpp>

namespace jauscat::jaus {

/// All of them, by subgroup.
using messages = joined_lists<core_subgroup, event_subgroup, communications_subgroup, platform_subgroup,
                              manipulator_subgroup, environment_sensor_subgroup, world_model_subgroup,
                              dynamic_configuration_subgroup, payload_subgroup, planning_subgroup>;

} // namespace jauscat::jaus
