// The list of command codes; the position in it is the subindex.
#pragma once
#include <jauscat/schema/jaus/catalog.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace jauscat::translation {

/// RA 3.3 in the order of `jaus::catalog`, and behind it a user's own messages by their command codes: ranks 1 to 157
/// by ascending code, 158 for the experimental 0404h, 159 to 254 for `Private`, in the order given. A rank is part of
/// what crosses the wire: append, never insert.
template <std::uint16_t... Private>
inline constexpr auto ra_command_codes_and = [] {
    std::array<std::uint16_t, jaus::catalog.size() + sizeof...(Private)> ranked{};
    std::size_t rank = 0;
    for (const auto& message : jaus::catalog) ranked[rank++] = message.command_code;
    ((ranked[rank++] = Private), ...);
    return ranked;
}();

/// RA 3.3 alone.
inline constexpr auto ra_command_codes = ra_command_codes_and<>;

} // namespace jauscat::translation
