// JAUS names and whole messages as text.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/message_name.hpp>

#include <string>
#include <utility>

namespace jauscat::text {

/// `2.1.33.1`: subsystem, node, component, instance.
[[nodiscard]] inline std::string to_text(const jaus::address& id) {
    return std::to_string(id.subsystem) + "." + std::to_string(id.node) + "." + std::to_string(id.component) + "." +
           std::to_string(id.instance);
}

/// `Set Wrench Effort, 36 bytes, 1.1.32.1 -> 2.1.33.1, sequence 34`.
[[nodiscard]] inline std::string summary(const jaus::header& head, std::string name) {
    std::string text = std::move(name);
    if (head.ack_nak == jaus::ack_nak::ack) text += " (ACK)";
    if (head.ack_nak == jaus::ack_nak::nak) text += " (NAK)";
    return text + ", " + std::to_string(jaus::header_size + head.data_size) + " bytes, " + to_text(head.source) +
           " -> " + to_text(head.destination) + ", sequence " + std::to_string(head.sequence_number);
}
/// The same with the standard's name.
[[nodiscard]] inline std::string summary(const jaus::header& head) {
    return summary(head, message_name(head.command_code));
}

/// Which field and byte of a body are at fault, if it is that of one of `Messages` and does not decode; else empty.
template <jaus::coded_message... Messages>
[[nodiscard]] std::string why_malformed(std::uint16_t command_code, std::span<const std::byte> body,
                                        jaus::message_list<Messages...>) {
    wire::diagnosis why{};
    static_cast<void>(
        (... || (jaus::command_code_of<Messages> == command_code && (why = wire::diagnose<Messages>(body), true))));
    return why.error == wire::errc::ok ? std::string{} : to_text(why);
}

/// A line for each field of the header, and the lines of `annotate_body(command_code, body)`; where these are none, the
/// body in hex.
[[nodiscard]] std::string annotate_message(std::span<const std::byte> bytes, auto&& annotate_body) {
    jaus::header head{};
    std::string text = annotate<jaus::header>(bytes);
    if (!wire::decode_prefix(head, bytes)) return text;
    const auto body = bytes.subspan(jaus::header_size);
    if (body.empty() && jaus::is_acknowledgement(head)) return text;
    const std::string lines = annotate_body(head.command_code, body);
    return text + (lines.empty() ? hex_dump(body, "  ", jaus::header_size) : lines);
}

/// A line for each field of the header and of the body, if one of `Messages` has its command code; a hex dump else.
template <jaus::coded_message... Messages>
[[nodiscard]] std::string annotate_message(std::span<const std::byte> bytes, jaus::message_list<Messages...>) {
    return annotate_message(bytes, [](std::uint16_t command_code, std::span<const std::byte> body) {
        std::string lines;
        static_cast<void>((... || (jaus::command_code_of<Messages> == command_code &&
                                   (lines = annotate<Messages>(body, jaus::header_size), true))));
        return lines;
    });
}

} // namespace jauscat::text
