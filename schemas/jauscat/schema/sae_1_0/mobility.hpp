// All services of the set mobility, and the list of their messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae_1_0/mobility/local_vector_driver.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae_1_0::mobility {

/// Each message once, by its ID.
using messages = jaus::message_list<set_local_vector, report_local_vector>;

} // namespace jauscat::sae_1_0::mobility
