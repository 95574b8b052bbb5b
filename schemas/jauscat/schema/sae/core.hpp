// All services of the set core, and the list of their messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/core/access_control.hpp>
#include <jauscat/schema/sae/core/discovery.hpp>
#include <jauscat/schema/sae/core/events.hpp>
#include <jauscat/schema/sae/core/list_manager.hpp>
#include <jauscat/schema/sae/core/liveness.hpp>
#include <jauscat/schema/sae/core/management.hpp>
#include <jauscat/schema/sae/core/transport.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::core {

/// Each message once, by its ID.
using messages = jaus::message_list<
    set_authority,
    shutdown,
    standby,
    resume,
    reset,
    set_emergency,
    clear_emergency,
    request_control,
    release_control,
    confirm_control,
    reject_control,
    create_event,
    update_event,
    cancel_event,
    confirm_event_request,
    reject_event_request,
    create_command_event,
    set_element,
    delete_element,
    confirm_element_request,
    reject_element_request,
    register_services,
    query_authority,
    query_status,
    query_timeout,
    query_control,
    query_events,
    query_event_timeout,
    query_heartbeat_pulse,
    query_element,
    query_element_list,
    query_element_count,
    query_identification,
    query_configuration,
    query_subsystem_list,
    query_services,
    query_service_list,
    report_authority,
    report_status,
    report_timeout,
    report_control,
    report_events,
    event,
    report_event_timeout,
    command_event,
    report_heartbeat_pulse,
    report_element,
    report_element_list,
    report_element_count,
    report_identification,
    report_configuration,
    report_subsystem_list,
    report_services,
    report_service_list>;

} // namespace jauscat::sae::core
