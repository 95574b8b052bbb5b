// Messages of both generations: what their bytes mean, and bytes of values.
#pragma once
#include "web/stages.hpp"
#include <jauscat/catalogue/entry.hpp>

namespace page {

/// Every message of both generations.
json all_messages();
/// The forms of header and body of the message with a code.
json forms(generation of, std::uint16_t code);
/// The message of `header`, `fields` and, of SAE, `sequence_number`: {"hex"} or {"error", "field"}.
json made_of(const json& request);
/// The parts of a message, its fields and the error where it does not decode. A payload of SAE has no header.
json taken_apart(std::span<const std::byte> message, generation of, bool is_payload);

} // namespace page
