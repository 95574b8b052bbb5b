// Decodes a body from its command code and bytes to fields, for any message of the standard.
#pragma once
#include "payloads.hpp"
#include "record.hpp"
#include <jauscat/wire/diagnose.hpp>

namespace jausdump {

/// Spaces in front of all lines below a message's own.
inline constexpr std::size_t text_indent = 9;

/// A decoded body.
struct decoded_body {
    wire::diagnosis fault{};          ///< why it did not decode
    json presence_vector{};           ///< as text; null where the message has none
    json fields{};                    ///< null where it did not decode
    std::string text{};               ///< the fields, a line each
    std::vector<std::byte> encoded{}; ///< the decoded values, encoded again
};

/// What the decoder is to do beside decoding.
struct decoding {
    const jaus::header& head;
    payload_directory& payloads;
    bool learn_payloads{}; ///< from reports that pass
    bool text{};           ///< make text, else JSON
};

using body_decoder = decoded_body (*)(std::span<const std::byte> body, const decoding&);

/// nullptr for a command code that is no message of the class: commands 0000h to 1FFFh, queries 2000h to 3FFFh, informs
/// 4000h to 5FFFh.
body_decoder find_command_decoder(std::uint16_t command_code);
body_decoder find_query_decoder(std::uint16_t command_code);
body_decoder find_inform_decoder(std::uint16_t command_code);

/// nullptr for a command code that the standard does not have.
inline body_decoder find_decoder(std::uint16_t command_code) {
    if (command_code < 0x2000) return find_command_decoder(command_code);
    if (command_code < 0x4000) return find_query_decoder(command_code);
    return find_inform_decoder(command_code);
}

} // namespace jausdump
