// Types of the values of objects: their names, text to bytes and back.
#pragma once
#include "ecat/ring.hpp"
#include "ecat/value.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ecat {

enum class value_kind : std::uint8_t { boolean, signed_number, unsigned_number, real, characters, octets };

struct object_type {
    std::uint16_t code{};    ///< ETG.1000.6, table 64
    std::string_view name{}; ///< INTEGER16
    std::string_view word{}; ///< i16: for --type
    value_kind kind{};
    unsigned bits{}; ///< 0: any
};

/// By the code of SDO information, the SII and ESI files; nullptr if it has no value of its own, such as a record.
[[nodiscard]] const object_type* type_of(std::uint16_t code);
/// By the word of --type or the name; throws `usage_error`.
[[nodiscard]] const object_type& type_named(std::string_view name);
/// For a value of so many bits whose type is not known: an unsigned number, or bytes.
[[nodiscard]] const object_type& guessed_type(std::size_t bits);
/// `INTEGER16`, or `0x1234`.
[[nodiscard]] std::string type_text(std::uint16_t code);

/// The value of data in a type; as bytes where their size is not the type's.
[[nodiscard]] value to_value(const object_type& type, const bytes& data);
/// Throws `usage_error` if the text is no value of the type or out of its range.
[[nodiscard]] bytes to_bytes(const object_type& type, const std::string& text);
/// Throws `usage_error` if the value is below the minimum or above the maximum; empty ones are no limit.
void check_limits(const object_type& type, const bytes& data, const bytes& minimum, const bytes& maximum);

/// `0x6041:0`, `0x1018:0-4`
struct object_range {
    std::uint16_t index{};
    std::uint8_t first{};
    std::uint8_t last{};
};
/// Throws `usage_error`.
[[nodiscard]] object_range parse_range(const std::string& text);
/// `0x6041:00`
[[nodiscard]] std::string place_text(std::uint16_t index, std::uint8_t subindex);
/// A decimal number, or a hexadecimal one with 0x; none if it is neither or above `most`.
[[nodiscard]] std::optional<std::uint64_t> parse_number(std::string_view text, std::uint64_t most);

} // namespace ecat
