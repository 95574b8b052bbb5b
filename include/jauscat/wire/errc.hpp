// Errors of the codec.
#pragma once
#include <cstdint>
#include <string_view>

namespace jauscat::wire {

/// `ok` is zero, as in every error enumeration of this library.
enum class errc : std::uint8_t {
    ok,
    truncated,            ///< the bytes end before the layout does
    trailing_bytes,       ///< bytes are left after the last field
    no_space,             ///< the output span is smaller than the encoded message
    out_of_range,         ///< a value outside its limits, not a number, or wider than its bit-field
    unknown_presence_bit, ///< a presence vector announces a field that its layout does not have
    count_above_capacity, ///< more elements than the list holds, or than its count can say
    count_mismatch,       ///< a count that stands elsewhere in the message differs from the number of elements
    unknown_tag,          ///< no layout for this tag or type code, or the value is of another type
    presence_mismatch,    ///< a member is there although its flag is not set, or the other way round
    too_deep,             ///< a tree has more levels than its layout allows
    arena_full,           ///< the memory for lists is used up
    too_long,             ///< more than 2^24 - 1 bytes
    outside_value_set,    ///< a value that the standard does not define; the bytes are those of a message
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(errc error) noexcept {
    switch (error) {
    case errc::ok: return "ok";
    case errc::truncated: return "truncated: the bytes end before the last field";
    case errc::trailing_bytes: return "trailing bytes after the last field";
    case errc::no_space: return "no space: the output buffer is too small";
    case errc::out_of_range: return "out of range: a value exceeds the limits or the width of its field";
    case errc::unknown_presence_bit: return "unknown presence bit: the presence vector announces an undefined field";
    case errc::count_above_capacity: return "count above capacity: more elements than the list or its count can hold";
    case errc::count_mismatch: return "count mismatch: the count differs from the number of elements";
    case errc::unknown_tag: return "unknown tag: no layout for this type code, or the value is of another type";
    case errc::presence_mismatch: return "presence mismatch: a member and the flag that announces it disagree";
    case errc::too_deep: return "too deep: the tree has more levels than its layout allows";
    case errc::arena_full: return "arena full: the memory given for lists is used up";
    case errc::outside_value_set: return "outside value set: the standard does not define this value";
    case errc::too_long: return "too long: more than 16 MiB";
    }
    return "unknown error";
}

} // namespace jauscat::wire
