// What the source files of the message classes have in common.
#pragma once
#include "message_kinds.hpp"
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/wire/encode.hpp>

template <class Message>
jauscat::result<std::vector<std::byte>, std::string> body_from_words(std::span<const std::string> words) {
    std::vector<std::byte> lists(std::size_t{1} << 16U);
    jauscat::wire::arena memory{lists};
    Message message{};
    if (const auto filled = jauscat::text::from_words(words, message, memory); !filled) return filled.error().message;
    std::vector<std::byte> body(std::size_t{1} << 16U);
    const auto encoded = jauscat::wire::encode(message, body);
    if (!encoded) return std::string{jauscat::wire::describe(encoded.error())};
    body.resize(encoded->size());
    return body;
}

template <class Message> std::string body_to_text(std::span<const std::byte> body, std::size_t first_offset) {
    return jauscat::text::annotate<Message>(body, first_offset);
}

template <class Message> std::string fault_of_body(std::span<const std::byte> body) {
    const auto why = jauscat::wire::diagnose<Message>(body);
    return why.error == jauscat::wire::errc::ok ? std::string{} : jauscat::text::to_text(why);
}

/// Those with codes from `First` to `Last`.
template <std::uint16_t First, std::uint16_t Last, class... Messages>
std::vector<message_kind> kinds_of(jauscat::jaus::message_list<Messages...>) {
    std::vector<message_kind> made;
    const auto add = [&]<class Message>() {
        if constexpr (jauscat::jaus::command_code_of<Message> >= First &&
                      jauscat::jaus::command_code_of<Message> <= Last)
            made.push_back({jauscat::jaus::command_code_of<Message>, &body_from_words<Message>, &body_to_text<Message>,
                            &fault_of_body<Message>});
    };
    (add.template operator()<Messages>(), ...);
    return made;
}
