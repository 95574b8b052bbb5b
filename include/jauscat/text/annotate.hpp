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

inline namespace JAUSCAT_WAY {
/// A line for each field of a message or structure that was decoded from `bytes`: offset (counted from `first_offset`),
/// bytes, name, value.
[[nodiscard]] JAUSCAT_DECL std::string annotate(const structure& type, const void* object,
                                                std::span<const std::byte> bytes, std::size_t first_offset = 0,
                                                std::string_view indent = "  ");
/// Bytes that do not decode: in hex, with the reason.
[[nodiscard]] JAUSCAT_DECL std::string annotate(const wire::diagnosis& why, std::span<const std::byte> bytes,
                                                std::size_t first_offset = 0, std::string_view indent = "  ");
} // namespace JAUSCAT_WAY

/// Decodes a `T` from the front of `bytes` and annotates it.
template <wire::message T>
[[nodiscard]] std::string annotate(std::span<const std::byte> bytes, std::size_t first_offset = 0,
                                   std::string_view indent = "  ") {
    for (std::size_t size = wire::needs_memory<T> ? 256 + 16 * bytes.size() : 0;; size *= 2) {
        std::vector<std::byte> lists(size);
        wire::arena memory{lists};
        T message{};
        const auto taken = wire::decode_prefix(message, bytes, memory, wire::tolerate_values);
        if (taken) return annotate(describe<T>(), &message, bytes, first_offset, indent);
        if (taken.error() != wire::errc::arena_full)
            return annotate(wire::diagnose<T>(bytes), bytes, first_offset, indent);
    }
}

} // namespace jauscat::text

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/text/impl/annotate.ipp>
#endif
