// A message's bytes with the fields they carry, a line each: what an operator reads when something is wrong.
//
//     0012  ff 3f        propulsive_linear_effort_x = 49.998474 % (raw 16383)
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/text/diagnosis_text.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::text {

/// A field's path in the message, such as `joint[0].joint_effort`, and its value.
struct annotated_field {
    std::string path{}, value{};
};
/// Consecutive bytes: those of one field, or of the bit-fields of one integer.
struct annotated_part {
    std::size_t offset{}, size{};
    std::vector<annotated_field> fields{};
};
/// The parts of a message in wire order; none where it does not decode, which `fault` explains.
struct annotation {
    std::vector<annotated_part> parts{};
    wire::diagnosis fault{};
};

inline namespace JAUSCAT_WAY {
/// The parts of a message or structure that was decoded from `bytes`.
[[nodiscard]] JAUSCAT_DECL annotation annotated(const structure& type, const void* object,
                                                std::span<const std::byte> bytes);
/// A line for each part of `bytes`: offset (counted from `first_offset`), bytes, names, values. Bytes that do not
/// decode are shown in hex, with the reason.
[[nodiscard]] JAUSCAT_DECL std::string to_text(const annotation& told, std::span<const std::byte> bytes,
                                               std::size_t first_offset = 0, std::string_view indent = "  ");
} // namespace JAUSCAT_WAY

/// The parts of a `T` at the front of `bytes`.
template <wire::message T> [[nodiscard]] annotation annotated(std::span<const std::byte> bytes) {
    for (std::size_t size = wire::needs_memory<T> ? 256 + 16 * bytes.size() : 0;; size *= 2) {
        std::vector<std::byte> lists(size);
        wire::arena memory{lists};
        T message{};
        const auto taken = wire::decode_prefix(message, bytes, memory, wire::tolerate_values);
        if (taken) return annotated(describe<T>(), &message, bytes);
        if (taken.error() != wire::errc::arena_full) return {.fault = wire::diagnose<T>(bytes)};
    }
}

/// Decodes a `T` from the front of `bytes` and prints a line for each field.
template <wire::message T>
[[nodiscard]] std::string annotate(std::span<const std::byte> bytes, std::size_t first_offset = 0,
                                   std::string_view indent = "  ") {
    return to_text(annotated<T>(bytes), bytes, first_offset, indent);
}

} // namespace jauscat::text

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/text/impl/annotate.ipp>
#endif
