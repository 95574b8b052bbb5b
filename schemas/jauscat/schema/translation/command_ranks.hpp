// The list of command codes whose order gives the subindex.
#pragma once
#include <jauscat/schema/jaus/catalog.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace jauscat::translation {

/// RA 3.3 in the order of `jaus::catalog`: ranks 1 to 157 by ascending code, then the experimental 0404h with 158.
inline constexpr auto ra_command_codes = [] {
    std::array<std::uint16_t, jaus::catalog.size()> codes{};
    for (std::size_t i = 0; i != codes.size(); ++i) codes[i] = jaus::catalog[i].command_code;
    return codes;
}();

} // namespace jauscat::translation
