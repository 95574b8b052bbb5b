// Payload subgroup of RA 3.3 part 3: a payload describes its own commands and measurements, then exchanges their
// values.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Query Payload Interface. Code 2D00h, query class, no body.
struct query_payload_interface {
    static constexpr std::uint16_t command_code = 0x2D00;
    friend constexpr bool operator==(const query_payload_interface&, const query_payload_interface&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::query_payload_interface> { using type = layout<>; };

} // namespace jauscat
