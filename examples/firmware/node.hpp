// The interface between a node program and the board. The node with JausCat and the one written by hand use the same
// board, so that they can be compared.
//
// The node connects an operator to an EtherCAT master card. On the line `jaus` it receives JAUS messages; it
//   - obeys Set Wrench Effort: keeps the efforts, and hands the SDO download packet of the message to the card;
//   - hands every other message of RA 3.3 that it has no handler for to the card in the same way;
//   - answers Query Wrench Effort and Query Component Status, whose secondary status counts refused messages;
//   - acknowledges, positively or negatively, where the sender asks for it;
//   - ignores messages to others.
#pragma once
#include <jauscat/base/time.hpp>

#include <chrono>
#include <cstddef>
#include <span>

namespace firmware {

using namespace std::chrono_literals;

/// The node's JAUS ID: subsystem 2, node 2, component 33 (Primitive Driver), instance 1.
inline constexpr unsigned own_subsystem = 2, own_node = 2, own_component = 33, own_instance = 1;
/// Most bytes of body that it takes.
inline constexpr std::size_t largest_body = 256;
/// Silence after which an incomplete message is dropped.
inline constexpr auto idle = 500ms;

/// The board's serial lines.
enum class line { jaus, card };

/// Of the board: sends bytes, and returns when the line has accepted them.
void send(line to, std::span<const std::byte> bytes) noexcept;

/// Of the node: bytes that arrived on the line `jaus`.
void on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) noexcept;
/// Of the node: called at least every millisecond while nothing arrives.
void on_time(jauscat::time_point now) noexcept;

} // namespace firmware
