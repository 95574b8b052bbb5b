// Text form of numbers, bytes, data types and SyncManager uses in ESI files.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/schema/ethercat/data_types.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// `#x1A`: a number in the schema's type HexDecValue, with at least `digits` digits.
JAUSCAT_DECL std::string hex_number(std::uint32_t value, std::size_t digits = 1);

/// The value of `#x1A` or `26`, if it is at most `max`.
[[nodiscard]] JAUSCAT_DECL std::optional<std::uint32_t> parse_number(std::string_view text,
                                                                     std::uint32_t max = 0xFFFFFFFF);

/// `text` without white space at its ends.
[[nodiscard]] JAUSCAT_DECL std::string_view trimmed(std::string_view text);

/// `text` without any white space.
[[nodiscard]] JAUSCAT_DECL std::string without_space(std::string_view text);

/// As `parse_number`, of other ways to write a number, too: `0x1A`, `#X1A`, and with white space in it.
[[nodiscard]] JAUSCAT_DECL std::optional<std::uint32_t> parse_number_liberally(std::string_view text,
                                                                               std::uint32_t max = 0xFFFFFFFF);

/// The value of `-26` or `26`, if it is `min` to `max`.
[[nodiscard]] JAUSCAT_DECL std::optional<std::int32_t> parse_integer(std::string_view text, std::int32_t min,
                                                                     std::int32_t max);

/// `true`, `false`, `1` or `0`.
[[nodiscard]] JAUSCAT_DECL std::optional<bool> parse_boolean(std::string_view text);

/// Two digits for each byte, without separators.
JAUSCAT_DECL std::string hex_bytes(std::span<const std::byte> bytes);

/// The reverse of `hex_bytes`, also with white space between the bytes; nothing for any other text.
[[nodiscard]] JAUSCAT_DECL std::optional<std::vector<std::byte>> parse_bytes(std::string_view text);

/// Base types of ETG.1020 with a fixed size, in bits.
inline constexpr std::array<std::pair<std::string_view, std::uint32_t>, 39> sized_types{
    {{"BOOL", 1},   {"BIT1", 1},   {"BIT2", 2},   {"BIT3", 3},    {"BIT4", 4},      {"BIT5", 5},      {"BIT6", 6},
     {"BIT7", 7},   {"BIT8", 8},   {"BIT9", 9},   {"BIT10", 10},  {"BIT11", 11},    {"BIT12", 12},    {"BIT13", 13},
     {"BIT14", 14}, {"BIT15", 15}, {"BIT16", 16}, {"BITARR8", 8}, {"BITARR16", 16}, {"BITARR32", 32}, {"BYTE", 8},
     {"SINT", 8},   {"USINT", 8},  {"INT", 16},   {"UINT", 16},   {"WORD", 16},     {"INT24", 24},    {"UINT24", 24},
     {"DINT", 32},  {"UDINT", 32}, {"DWORD", 32}, {"REAL", 32},   {"INT40", 40},    {"UINT40", 40},   {"LINT", 64},
     {"ULINT", 64}, {"LWORD", 64}, {"LREAL", 64}, {"GUID", 128}}};

/// Names of the data types of PDO entries (ETG.1000.6).
inline constexpr std::array<std::pair<std::uint16_t, std::string_view>, 19> data_type_names{
    {{ethercat::data_types::boolean, "BOOL"},
     {ethercat::data_types::integer8, "SINT"},
     {ethercat::data_types::integer16, "INT"},
     {ethercat::data_types::integer32, "DINT"},
     {ethercat::data_types::integer64, "LINT"},
     {ethercat::data_types::unsigned8, "USINT"},
     {ethercat::data_types::unsigned16, "UINT"},
     {ethercat::data_types::unsigned32, "UDINT"},
     {ethercat::data_types::unsigned64, "ULINT"},
     {ethercat::data_types::real32, "REAL"},
     {ethercat::data_types::real64, "LREAL"},
     {ethercat::data_types::bit1, "BIT1"},
     {ethercat::data_types::bit1 + 1, "BIT2"},
     {ethercat::data_types::bit1 + 2, "BIT3"},
     {ethercat::data_types::bit1 + 3, "BIT4"},
     {ethercat::data_types::bit1 + 4, "BIT5"},
     {ethercat::data_types::bit1 + 5, "BIT6"},
     {ethercat::data_types::bit1 + 6, "BIT7"},
     {ethercat::data_types::bit1 + 7, "BIT8"}}};

/// The name of a data type, or empty.
JAUSCAT_DECL std::string_view data_type_name(std::uint16_t type);
/// The data type of that name, or 0.
JAUSCAT_DECL std::uint16_t parse_data_type(std::string_view text);

/// The base type of this number of bytes.
JAUSCAT_DECL std::string octet_string_type(std::size_t bytes);
/// The base type of this number of characters.
JAUSCAT_DECL std::string string_type(std::size_t characters);

/// The value of a number as text (`#x1A`, `26`, `-26`, `0.5`) in a base type with a fixed size, little-endian; nothing
/// for another type, or for a value that does not fit.
[[nodiscard]] JAUSCAT_DECL std::optional<std::vector<std::byte>> parse_value(std::string_view text,
                                                                             std::string_view type);

/// Size in bits of a base type: one of `sized_types`, STRING(n), VISIBLE_STRING(n), UNICODE_STRING(n), OCTET_STRING(n),
/// ARRAY [0..n] OF one of `sized_types`.
[[nodiscard]] JAUSCAT_DECL std::optional<std::uint32_t> bits_of(std::string_view type);

/// Whether it is STRING(n) or VISIBLE_STRING(n).
[[nodiscard]] JAUSCAT_DECL bool is_string_type(std::string_view type);

/// The `size` low bytes of a value, the lowest first.
[[nodiscard]] JAUSCAT_DECL std::vector<std::byte> little_endian(std::uint64_t value, std::size_t size);

/// Content of an Sm element, by use.
inline constexpr std::array<std::pair<ethercat::sii_sync_manager_use, std::string_view>, 4> sync_manager_uses{
    {{ethercat::sii_sync_manager_use::mailbox_out, "MBoxOut"},
     {ethercat::sii_sync_manager_use::mailbox_in, "MBoxIn"},
     {ethercat::sii_sync_manager_use::outputs, "Outputs"},
     {ethercat::sii_sync_manager_use::inputs, "Inputs"}}};

/// The use in an element Sm.
[[nodiscard]] JAUSCAT_DECL std::optional<ethercat::sii_sync_manager_use> parse_sync_manager_use(std::string_view text);

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/text_values.ipp>
#endif
