// Dynamic configuration subgroup of RA 3.3 part 3: identification, configuration, subsystems, services.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Whose identification is meant. Other values are reserved.
enum class query_type : std::uint8_t {
    system_identification = 1,
    subsystem_identification = 2,
    node_identification = 3,
    component_identification = 4,
};

/// Query Identification: asks for Report Identification.
/// Code 2B00h, query class, 1 byte.
struct query_identification {
    static constexpr std::uint16_t command_code = 0x2B00;
    jaus::query_type query_type{}; ///< whose identification
    friend constexpr bool operator==(const query_identification&, const query_identification&) = default;
};

/// Whose configuration is meant. Other values are reserved; some peers name 1 system, 4 component, 5 instance.
enum class query_field : std::uint8_t {
    subsystem_configuration = 2,
    node_configuration = 3,
};

/// Query Configuration: asks for Report Configuration.
/// Code 2B01h, query class, 1 byte.
struct query_configuration {
    static constexpr std::uint16_t command_code = 0x2B01;
    jaus::query_field query_field{}; ///< whose configuration
    friend constexpr bool operator==(const query_configuration&, const query_configuration&) = default;
};

/// Query Subsystem List: asks for Report Subsystem List.
/// Code 2B02h, query class, no body.
struct query_subsystem_list {
    static constexpr std::uint16_t command_code = 0x2B02;
    friend constexpr bool operator==(const query_subsystem_list&, const query_subsystem_list&) = default;
};

/// Query Services: asks for Report Services.
/// Code 2B03h, query class, no body.
struct query_services {
    static constexpr std::uint16_t command_code = 0x2B03;
    friend constexpr bool operator==(const query_services&, const query_services&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::query_identification> {
    using T = jaus::query_identification;
    using type = layout<field<&T::query_type, enumeration<jaus::query_type, u8>>>;
};

template <> struct wire::schema<jaus::query_configuration> {
    using T = jaus::query_configuration;
    using type = layout<field<&T::query_field, enumeration<jaus::query_field, u8>>>;
};

template <> struct wire::schema<jaus::query_subsystem_list> { using type = layout<>; };

template <> struct wire::schema<jaus::query_services> { using type = layout<>; };

} // namespace jauscat
