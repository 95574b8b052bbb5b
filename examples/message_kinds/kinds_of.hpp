// What the source files of the message classes have in common: all that is compiled for each message.
#pragma once
#include "message_kinds.hpp"
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/wire/encode.hpp>

template <class Message> message_kind kind_of() {
    namespace wire = jauscat::wire;
    using bytes = std::span<const std::byte>;
    return {
        .command_code = jauscat::jaus::command_code_of<Message>,
        .fields = &jauscat::text::describe<Message>(),
        .make =
            [] {
                return message_kind::object{new Message{}, [](void* value) { delete static_cast<Message*>(value); }};
            },
        .decode = [](void* value, bytes body,
                     wire::arena& memory) { return wire::decode(*static_cast<Message*>(value), body, memory); },
        .encode = [](const void* value) -> jauscat::result<std::vector<std::byte>, wire::errc> {
            const auto& message = *static_cast<const Message*>(value);
            std::vector<std::byte> body(wire::encoded_size(message));
            if (const auto written = wire::encode(message, body); !written) return written.error();
            return body;
        },
        .diagnose = [](bytes body) { return wire::diagnose<Message>(body); },
        .annotate = [](bytes body,
                       std::size_t first_offset) { return jauscat::text::annotate<Message>(body, first_offset); },
    };
}

/// Those with codes from `First` to `Last`.
template <std::uint16_t First, std::uint16_t Last, class... Messages>
std::vector<message_kind> kinds_of(jauscat::jaus::message_list<Messages...>) {
    std::vector<message_kind> made;
    const auto add = [&]<class Message>() {
        if constexpr (jauscat::jaus::command_code_of<Message> >= First &&
                      jauscat::jaus::command_code_of<Message> <= Last)
            made.push_back(kind_of<Message>());
    };
    (add.template operator()<Messages>(), ...);
    return made;
}
