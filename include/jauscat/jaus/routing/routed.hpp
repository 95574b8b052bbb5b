// Routing types: hops, and the result of routing a message.
#pragma once
#include <cstdint>
#include <string_view>

namespace jauscat::jaus {

/// A peer that messages are exchanged with, or a multicast group: a small number to which the program gives a meaning,
/// such as the index of a UDP endpoint.
using hop = std::uint16_t;

/// The hop of messages sent by components of this program.
inline constexpr hop here = 0xFFFF;
/// The hop of messages from an unknown peer. It has the rights of another subsystem.
inline constexpr hop unknown_hop = 0xFFFE;

/// Kind of a hop, by the innermost of the addresses routed to it.
enum class hop_kind : std::uint8_t {
    unused,    ///< no address leads to it
    subsystem, ///< only addresses of other subsystems
    node,      ///< a node of the own subsystem, and all that is reached through it
    component, ///< a component of the own node, in another program
    manager,   ///< the program that has the own node's node manager: this program has a few of the node's components
};

/// Result of adding a route or a component.
enum class added : std::uint8_t {
    ok,
    full,            ///< the memory for routes or components is full
    duplicate,       ///< there is an entry with exactly this address
    invalid_address, ///< a component must have IDs of 1 to 254
    invalid_hop,     ///< not a number below the number of places for hops
};

/// The result in one line, for configuration errors.
[[nodiscard]] constexpr std::string_view describe(added what) noexcept {
    switch (what) {
    case added::ok: return "ok";
    case added::full: return "too many routes or components for the memory given";
    case added::duplicate: return "there is an entry with this address already";
    case added::invalid_address: return "component and instance IDs are 1 to 254";
    case added::invalid_hop: return "no such hop";
    }
    return "unknown";
}

/// Result of routing. From `no_such_component` on the message was dropped; log it.
enum class routed : std::uint8_t {
    ok,                  ///< delivered or forwarded
    no_receiver,         ///< to all of a kind, and there is none here or beyond
    no_such_component,   ///< to this node, which has no such component
    no_route,            ///< no entry covers the destination, or only one that leads out of the subsystem again
    would_return,        ///< the route leads back to the sender of the message
    between_subsystems,  ///< from another subsystem to another subsystem: none forwards for others
    not_the_relay,       ///< from a node to another node, and this is not the primary node that forwards such
    invalid_destination, ///< an octet of the destination is 0
    invalid_source,      ///< an octet of the source is 0 or 255
    source_is_local,     ///< the source is of this node, or of this subsystem, and the message comes from outside
    source_is_elsewhere, ///< from a component of this node, with the source of another
};

/// The result in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(routed what) noexcept {
    switch (what) {
    case routed::ok: return "ok";
    case routed::no_receiver: return "no receiver: nothing here matches the broadcast address";
    case routed::no_such_component: return "unroutable: this node has no such component";
    case routed::no_route: return "unroutable: no route to the destination is known";
    case routed::would_return: return "unroutable: the route to the destination leads back to the sender";
    case routed::between_subsystems: return "unroutable: messages between other subsystems are not forwarded";
    case routed::not_the_relay: return "unroutable: only the primary node forwards from node to node";
    case routed::invalid_destination: return "unroutable: an octet of the destination ID is 0";
    case routed::invalid_source: return "refused: an octet of the source ID is 0 or 255";
    case routed::source_is_local: return "refused: the source claims to be local, and the message comes from outside";
    case routed::source_is_elsewhere: return "refused: a component of this node uses the source ID of another";
    }
    return "unknown";
}

/// Result of routing, and number of receivers.
struct routing {
    routed outcome{};           ///< where it went, or why nowhere
    std::uint16_t components{}; ///< of this program
    std::uint16_t hops{};       ///< other programs

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return outcome == routed::ok; }
};

} // namespace jauscat::jaus
