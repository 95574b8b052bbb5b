// Core subgroup of RA 3.3 part 3: authority, emergency, component status.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Set Component Authority: sets the authority of the receiving component.
/// Code 0001h, command class, 1 byte.
struct set_component_authority {
    static constexpr std::uint16_t command_code = 0x0001;
    std::uint8_t authority_code{}; ///< 0 lowest to 255 highest
    friend constexpr bool operator==(const set_component_authority&, const set_component_authority&) = default;
};

/// Set Emergency: tells the receiving component of an emergency.
/// Code 0006h, command class, 2 bytes. Only bit 0 is assigned; the other bits pass through.
struct set_emergency {
    static constexpr std::uint16_t command_code = 0x0006;
    bool transition_to_emergency{};  ///< bit 0: go to the emergency state
    std::uint16_t unassigned_bits{}; ///< bits 1 to 15, sent as zero
    friend constexpr bool operator==(const set_emergency&, const set_emergency&) = default;
};

/// Clear Emergency: ends an emergency that the sender has set.
/// Code 0007h, command class, 2 bytes. Only bit 0 is assigned; the other bits pass through.
struct clear_emergency {
    static constexpr std::uint16_t command_code = 0x0007;
    bool clear_emergency_condition{}; ///< bit 0: clear the emergency
    std::uint16_t unassigned_bits{};  ///< bits 1 to 15, sent as zero
    friend constexpr bool operator==(const clear_emergency&, const clear_emergency&) = default;
};

/// Query Component Status. Code 2002h, query class, no body.
struct query_component_status {
    static constexpr std::uint16_t command_code = 0x2002;
    friend constexpr bool operator==(const query_component_status&, const query_component_status&) = default;
};

/// Primary Status Code of Report Component Status. Other values are not assigned.
enum class primary_status_code : std::uint8_t {
    initialize = 0,
    ready = 1,
    standby = 2,
    shutdown = 3,
    failure = 4,
    emergency = 5,
};

/// Report Component Status. Code 4002h, inform class, 5 bytes.
struct report_component_status {
    static constexpr std::uint16_t command_code = 0x4002;
    jaus::primary_status_code primary_status_code{}; ///< the component's state
    std::uint32_t secondary_status_code{};           ///< 32 bits of the component's own meaning
    friend constexpr bool operator==(const report_component_status&, const report_component_status&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::set_component_authority> {
    using T = jaus::set_component_authority;
    using type = layout<field<&T::authority_code, u8>>;
};

template <> struct wire::schema<jaus::set_emergency> {
    using T = jaus::set_emergency;
    using type = layout<
        bits<u16le,
            bit<&T::transition_to_emergency, 1>,
            bit<&T::unassigned_bits, 15>>>;
};

template <> struct wire::schema<jaus::clear_emergency> {
    using T = jaus::clear_emergency;
    using type = layout<
        bits<u16le,
            bit<&T::clear_emergency_condition, 1>,
            bit<&T::unassigned_bits, 15>>>;
};

template <> struct wire::schema<jaus::query_component_status> { using type = layout<>; };

template <> struct wire::schema<jaus::report_component_status> {
    using T = jaus::report_component_status;
    using type = layout<
        field<&T::primary_status_code, enumeration<jaus::primary_status_code, u8>>,
        field<&T::secondary_status_code, u32le>>;
};

} // namespace jauscat
