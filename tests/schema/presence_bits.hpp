// Presence bits that stand for no field, set as some peers set them.
#pragma once
#include <jauscat/text/structure.hpp>

#include <span>

namespace support {

/// Sets them in the body of a message with `fields`; false: its vector has none, or it has no vector.
inline bool set_bits_without_field(std::span<std::byte> body, const jauscat::text::structure& fields) {
    using jauscat::text::member;
    if (fields.members.empty() || fields.members[0].what != member::role::presence_vector) return false;
    const auto bits = fields.members[0].least * 8;
    for (std::size_t bit = fields.members[0].used_bits; bit != bits; ++bit) body[bit / 8] |= std::byte{1} << (bit % 8);
    return fields.members[0].used_bits != bits;
}

} // namespace support
