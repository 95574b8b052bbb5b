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
    wire::diagnosis fault{};                   ///< why it did not decode
    json presence_vector{};                    ///< as text; null where the message has none
    json fields{};                             ///< null where it did not decode
    std::string text{};                        ///< the fields, a line each
    std::vector<std::byte> encoded{};          ///< the decoded values, encoded again
    std::vector<std::string> outside_values{}; ///< fields with values that the standard does not define
};

/// What the decoder is to do beside decoding.
struct decoding {
    const jaus::header& head;
    payload_directory& payloads;
    bool learn_payloads{}; ///< from reports that pass
    bool text{};           ///< make text, else JSON
};

/// Whether the message of the command code is among example::known_messages.
bool is_known(std::uint16_t command_code);
/// Decodes the body, `bytes`, of a message whose command code is known.
decoded_body decode_body(std::span<const std::byte> bytes, const decoding& how);

} // namespace jausdump
