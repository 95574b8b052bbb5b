// The messages that the operator control unit sends by name and shows field by field: those of the arm, and those of
// every component's core that have to do with control and state.
#pragma once
#include "support/robot_messages.hpp"

namespace ocu {

template <class... First, class... Second>
jauscat::jaus::message_list<First..., Second...> joined(jauscat::jaus::message_list<First...>,
                                                        jauscat::jaus::message_list<Second...>);

using control_messages =
    jauscat::jaus::message_list<jauscat::jaus::shutdown, jauscat::jaus::standby, jauscat::jaus::resume,
                                jauscat::jaus::reset, jauscat::jaus::request_component_control,
                                jauscat::jaus::release_component_control, jauscat::jaus::confirm_component_control,
                                jauscat::jaus::reject_component_control, jauscat::jaus::query_component_authority,
                                jauscat::jaus::query_component_control, jauscat::jaus::report_component_authority,
                                jauscat::jaus::report_component_control>;

using operator_messages = decltype(joined(robot_messages{}, control_messages{}));

} // namespace ocu
