// The messages of the standard's subgroups, each compiled in a source of its own.
#pragma once
#include <jauscat/catalogue/of.hpp>

namespace jauscat::catalogue {

const list& core();
const list& event();
const list& communications();
const list& platform();
const list& manipulator();
const list& environment_sensor();
const list& world_model();
const list& dynamic_configuration();
const list& payload();
const list& planning();

} // namespace jauscat::catalogue
