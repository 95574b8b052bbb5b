// One of the JAUS messages, chosen by the input.
#pragma once
#include "target.hpp"
#include <jauscat/schema/jaus/messages.hpp>

namespace fuzz {

/// Calls `call.operator()<T>()` with the message type whose command code is `code`, if there is one.
template <class... Messages>
void with_message(std::uint16_t code, jauscat::jaus::message_list<Messages...>, auto&& call) {
    static_cast<void>((... || (Messages::command_code == code && (call.template operator()<Messages>(), true))));
}

/// An input is a command code (little-endian) and a body: calls `call.operator()<T>(body)`.
void with_body(std::span<const std::byte> input, auto&& call) {
    input_reader in{input};
    const auto code = in.take<jauscat::wire::u16le>();
    const bytes body = copy_of(in.rest());
    with_message(code, jauscat::jaus::messages{}, [&]<class T>() { call.template operator()<T>(body); });
}

} // namespace fuzz
