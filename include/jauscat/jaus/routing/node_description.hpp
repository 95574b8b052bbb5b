// Description and options of a node manager.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/routing/liveness_table.hpp>

namespace jauscat::jaus {

/// Service of a node manager; the service type is its component ID.
namespace node_manager_messages {
inline constexpr std::array<supported_message, 7> input{
    {{0x2202}, {0x2B00}, {0x2B01}, {0x2B02}, {0x2B03}, {0x4202}, {0x4B01}}};
inline constexpr std::array<supported_message, 6> output{{{0x2B01}, {0x4202}, {0x4B00}, {0x4B01}, {0x4B02}, {0x4B03}}};
inline constexpr std::array<offered_service, 1> services{{{1, input, output}}};
} // namespace node_manager_messages

/// Types of subsystems in Report Identification.
enum class subsystem_type : std::uint16_t { vehicle = 10001, operator_control_unit = 20001, other = 30001 };

/// Identifications of system, subsystem and node.
struct node_description {
    identity system{}; ///< identification of the system
    identity subsystem{.type = 30001};
    identity node{.type = 40001};
    identity manager{.type = 60001}; ///< of the node manager itself
    std::span<const offered_service> services = node_manager_messages::services;
    std::span<const configured_component> components{}; ///< known from the start, beside the node manager
};

struct node_manager_options {
    heartbeat beat = heartbeat_to_all(); ///< destination and interval
    /// A component that sends no heartbeat for so long is gone; with a node manager goes what it reported.
    duration timeout{std::chrono::seconds{3}};
    /// Interval of queries to the other nodes of the subsystem for their components; 0: only when a node appears.
    duration survey{std::chrono::seconds{10}};
    hook<void(const address&)> appeared{};    ///< a component is new
    hook<void(const address&)> disappeared{}; ///< a component is gone
};

/// The caller's memory. None of it may be shared.
struct node_manager_memory {
    std::span<liveness_table::place> presences{}; ///< for all components heard of; see liveness_table
    std::span<std::byte> lists{}; ///< 8 bytes for each of them and of the node's own, 32 for each node of the subsystem
    std::span<std::byte> report{}; ///< the longest report; see answer
};

} // namespace jauscat::jaus
