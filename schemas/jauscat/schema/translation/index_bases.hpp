// Where the objects of component 0 may lie; component n has the index base + n. Which to choose:
//
//   base          indices       area of EtherCAT's dictionary (ETG.1000.6)
//   6900 decimal  1AF4h-1BF3h   TxPDO mapping, 1A00h-1BFFh
//   2000h         2000h-20FFh   manufacturer specific, 2000h-5FFFh
//   6900h         6900h-69FFh   device profile, 6000h-9FFFh
//
// An entry of a PDO mapping object is by definition a UNSIGNED32 that says what is mapped. Many slaves therefore refuse
// the seed's indices: with abort 06010003h until subindex 0 is 0 (the master can write it first), with 06020000h where
// they have no such object, with 06070010h for data that are not 4 bytes. The emulated slaves here take them. For other
// slaves choose 2000h, which is free for whatever a manufacturer likes; 6900h is for those who read the seed's number
// as hexadecimal, and fits slaves without a device profile there.
#pragma once
#include <cstdint>

namespace jauscat::translation {

/// The seed's, decimal: the default.
inline constexpr std::uint32_t seed_index_base = 6900;
/// The start of the manufacturer-specific area: the place for private objects.
inline constexpr std::uint32_t manufacturer_index_base = 0x2000;
/// The seed's number read as hexadecimal, in the device profile area.
inline constexpr std::uint32_t profile_index_base = 0x6900;

} // namespace jauscat::translation
