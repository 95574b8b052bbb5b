// A message on its way to a slave, by each mapping table: packet, object, frames, and the message again.
#pragma once
#include "web/form.hpp"
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/decode.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace page {

enum class generation : std::uint8_t { ra, sae };
/// "ra" or "sae".
inline generation generation_of(const std::string& text) { return text == "sae" ? generation::sae : generation::ra; }

/// Adds {"offset", "size", "place", "fields": [{"path", "value"}]} for each part.
void append_parts(json& to, const std::vector<jauscat::text::annotated_part>& parts, std::size_t first_offset,
                  const std::string& place);
/// The parts of a `T` at the front of `bytes`; none where these are too few.
template <class T> std::vector<jauscat::text::annotated_part> parts_of(std::span<const std::byte> bytes) {
    T value{};
    if (!jauscat::wire::decode_prefix(value, bytes)) return {};
    return jauscat::text::annotated(jauscat::text::describe<T>(), &value, bytes).parts;
}

/// The tables of a generation: [{"table", "base", "name"}].
json tables();
/// The stages of a message by a table of `tables`. `parts` are those of the message: a part of a stage that holds the
/// same has "from", its place among them.
json stages(std::span<const std::byte> message, const json& parts, const std::string& table, std::uint32_t base);
/// The message of a packet, by a table: {"hex", "generation"} or {"error"}.
json message_of_packet(std::span<const std::byte> packet, const std::string& table, std::uint32_t base);

} // namespace page
