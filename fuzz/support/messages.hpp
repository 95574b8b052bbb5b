// One of the JAUS messages, chosen by the input.
#pragma once
#include "target.hpp"
#include <jauscat/schema/jaus/messages.hpp>

namespace fuzz {

/// A message or two for each kind of item and combination of them. Fuzz targets whose work is the same for all messages
/// of a kind take these, so that they compile in a minute.
// clang-format off
using one_of_each_kind = jauscat::jaus::message_list<
    jauscat::jaus::set_emergency,                         // flags
    jauscat::jaus::confirm_component_control,             // bit-fields, reserved bits
    jauscat::jaus::create_event,                          // values of a selected type, counted bytes
    jauscat::jaus::reject_event_request,                  // string to the end
    jauscat::jaus::set_wrench_effort,                     // presence vector, scaled fields
    jauscat::jaus::set_joint_efforts,                     // list of values
    jauscat::jaus::set_joint_motion,                      // lists counted from outside
    jauscat::jaus::create_vector_knowledge_store_objects, // flags that announce members of elements
    jauscat::jaus::spool_mission,                         // tree
    jauscat::jaus::query_component_status,                // no body
    jauscat::jaus::query_vector_knowledge_store_objects,  // elements that may be empty
    jauscat::jaus::report_global_pose,                    // presence vector of any bits, time stamp
    jauscat::jaus::report_manipulator_specifications,     // count of one more than there are
    jauscat::jaus::report_camera_pose,                    // string of fixed size
    jauscat::jaus::report_image,                          // bytes to the end
    jauscat::jaus::report_identification,                 // string of fixed size or to the end
    jauscat::jaus::report_services,                       // lists of lists
    jauscat::jaus::report_payload_interface>;             // strings to a zero, counted strings
// clang-format on

/// Calls `call.operator()<T>()` with the message type whose command code is `code`, if there is one.
template <class... Messages>
void with_message(std::uint16_t code, jauscat::jaus::message_list<Messages...>, auto&& call) {
    static_cast<void>(
        (... || (jauscat::jaus::command_code_of<Messages> == code && (call.template operator()<Messages>(), true))));
}

/// An input is a command code (little-endian) and a body: calls `call.operator()<T>(body)` with one of `messages`.
void with_body(std::span<const std::byte> input, auto messages, auto&& call) {
    input_reader in{input};
    const auto code = in.take<jauscat::wire::u16le>();
    const byte_vector body = copy_of(in.rest());
    with_message(code, messages, [&]<class T>() { call.template operator()<T>(body); });
}

} // namespace fuzz
