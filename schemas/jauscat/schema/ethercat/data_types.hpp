// What the values of objects are, in SDO information, in the SII and in ESI files. ETG.1000.6, table 64.
#pragma once

#include <cstdint>

namespace jauscat::ethercat {

/// The data types of the objects and entries that this library has to do with.
namespace data_types {
inline constexpr std::uint16_t boolean = 0x0001;
inline constexpr std::uint16_t integer8 = 0x0002;
inline constexpr std::uint16_t integer16 = 0x0003;
inline constexpr std::uint16_t integer32 = 0x0004;
inline constexpr std::uint16_t unsigned8 = 0x0005;
inline constexpr std::uint16_t unsigned16 = 0x0006;
inline constexpr std::uint16_t unsigned32 = 0x0007;
inline constexpr std::uint16_t real32 = 0x0008;
inline constexpr std::uint16_t visible_string = 0x0009;
inline constexpr std::uint16_t real64 = 0x0011;
inline constexpr std::uint16_t integer64 = 0x0015;
inline constexpr std::uint16_t unsigned64 = 0x001B;
inline constexpr std::uint16_t pdo_mapping = 0x0021;     ///< the record of a PDO mapping object
inline constexpr std::uint16_t identity = 0x0023;        ///< the record of object 1018h
inline constexpr std::uint16_t synchronization = 0x0029; ///< the record of objects 1C32h and 1C33h
inline constexpr std::uint16_t bit1 = 0x0030;            ///< BIT1; those of 2 to 8 bits follow
} // namespace data_types

} // namespace jauscat::ethercat
