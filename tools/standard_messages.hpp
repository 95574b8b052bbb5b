// All messages of the standard as objects of a slave, compiled once: with 158 layouts it takes the compiler long.
#pragma once
#include <jauscat/bridge/object_list.hpp>

#include <span>

/// A subobject for each message, under the seed table.
std::span<const jauscat::bridging::sub_object> standard_messages();
