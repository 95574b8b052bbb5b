// What the subindices of PDO mapping objects (1600h to 17FFh, 1A00h to 1BFFh) hold. ETG.1000.6, clause 5.6.7.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// One mapped object, 4 bytes: as a number index << 16 | subindex << 8 | bits.
struct pdo_mapping {
    std::uint8_t bits{};     ///< of its value
    std::uint8_t subindex{}; ///< of the object
    std::uint16_t index{};   ///< 0: a gap

    struct schema : wire::items {
        using T = pdo_mapping;
        using type = layout<
            field<&T::bits, u8>,
            field<&T::subindex, u8>,
            field<&T::index, u16le>>;
    };
};

} // namespace jauscat::ethercat
