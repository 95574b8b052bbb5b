// Dynamic configuration subgroup of RA 3.3 part 3: identification, configuration, subsystems, services.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Level to be identified. Other values are reserved.
enum class query_type : std::uint8_t {
    system_identification = 1,
    subsystem_identification = 2,
    node_identification = 3,
    component_identification = 4,
};

/// Query Identification: asks for Report Identification.
/// Code 2B00h, query class, 1 byte.
struct query_identification {
    jaus::query_type query_type{}; ///< level to be identified
    friend constexpr bool operator==(const query_identification&, const query_identification&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2B00;
        using report = struct report_identification;
        using T = query_identification;
        using type = layout<field<&T::query_type, enumeration<jaus::query_type, u8>>>;
    };
};

/// Level of the configuration. Other values are reserved; some peers name 1 system, 4 component, 5 instance.
enum class query_field : std::uint8_t {
    subsystem_configuration = 2,
    node_configuration = 3,
};

/// Query Configuration: asks for Report Configuration.
/// Code 2B01h, query class, 1 byte.
struct query_configuration {
    jaus::query_field query_field{}; ///< level of the configuration
    friend constexpr bool operator==(const query_configuration&, const query_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2B01;
        using report = struct report_configuration;
        using T = query_configuration;
        using type = layout<field<&T::query_field, enumeration<jaus::query_field, u8>>>;
    };
};

/// Query Subsystem List: asks for Report Subsystem List.
/// Code 2B02h, query class, no body.
struct query_subsystem_list {
    friend constexpr bool operator==(const query_subsystem_list&, const query_subsystem_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2B02;
        using report = struct report_subsystem_list;
        using type = layout<>;
    };
};

/// Query Services: asks for Report Services.
/// Code 2B03h, query class, no body.
struct query_services {
    friend constexpr bool operator==(const query_services&, const query_services&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2B03;
        using report = struct report_services;
        using type = layout<>;
    };
};

/// Report Identification: what the system, subsystem, node or component is called.
/// Code 4B00h, inform class, 84 bytes. Peers may send a shorter text without the fill.
/// Types: 10001 vehicle, 20001 operator control unit, 30001 other subsystem, 40001 node, 50001 payload, 60001
/// component.
struct report_identification {
    jaus::query_type query_type{};     ///< level to be identified
    std::uint8_t authority_code{};     ///< 0 lowest to 255 highest
    std::uint16_t type{};              ///< kind of the named thing
    std::string_view identification{}; ///< up to 80 characters
    friend constexpr bool operator==(const report_identification&, const report_identification&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4B00;
        using query = query_identification;
        using T = report_identification;
        using type = layout<
            field<&T::query_type, enumeration<jaus::query_type, u8>>,
            field<&T::authority_code, u8>,
            field<&T::type, u16le>,
            string<&T::identification, fixed_or_rest<80>>>;
    };
};

/// A component in Report Configuration. 2 bytes.
struct configured_component {
    std::uint8_t component_id{}; ///< 1 to 254
    std::uint8_t instance_id{};  ///< 1 to 254
    friend constexpr bool operator==(const configured_component&, const configured_component&) = default;

    struct schema : wire::items {
        using T = configured_component;
        using type = layout<
            field<&T::component_id, u8>,
            field<&T::instance_id, u8>>;
    };
};

/// A node in Report Configuration. 2 bytes or more.
struct configured_node {
    std::uint8_t node_id{};                       ///< 1 to 254
    wire::list<configured_component> component{}; ///< up to 255
    friend constexpr bool operator==(const configured_node&, const configured_node&) = default;

    struct schema : wire::items {
        using T = configured_node;
        using type = layout<
            field<&T::node_id, u8>,
            repeated<&T::component, count<"number_of_components", u8>>>;
    };
};

/// Report Configuration: the nodes and components of a subsystem, or the components of a node.
/// Code 4B01h, inform class, 1 byte or more.
struct report_configuration {
    wire::list<configured_node> node{}; ///< up to 255
    friend constexpr bool operator==(const report_configuration&, const report_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4B01;
        using query = query_configuration;
        using T = report_configuration;
        using type = layout<repeated<&T::node, count<"number_of_nodes", u8>>>;
    };
};

/// A subsystem in Report Subsystem List. 4 bytes. It begins with the subsystem, unlike an address in the header.
struct listed_subsystem {
    std::uint8_t subsystem_id{}; ///< 1 to 254
    std::uint8_t node_id{};      ///< 1 to 254
    std::uint8_t component_id{}; ///< 1 to 254
    std::uint8_t instance_id{};  ///< 1 to 254
    friend constexpr bool operator==(const listed_subsystem&, const listed_subsystem&) = default;

    struct schema : wire::items {
        using T = listed_subsystem;
        using type = layout<
            field<&T::subsystem_id, u8>,
            field<&T::node_id, u8>,
            field<&T::component_id, u8>,
            field<&T::instance_id, u8>>;
    };
};

/// Report Subsystem List: the known subsystems, each by the address of a component.
/// Code 4B02h, inform class, 1 byte or more.
struct report_subsystem_list {
    wire::list<listed_subsystem> subsystem{}; ///< up to 255
    friend constexpr bool operator==(const report_subsystem_list&, const report_subsystem_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4B02;
        using query = query_subsystem_list;
        using T = report_subsystem_list;
        using type = layout<repeated<&T::subsystem, count<"number_of_subsystems", u8>>>;
    };
};

/// A message of a service. 6 bytes.
struct supported_message {
    std::uint16_t command_code{};              ///< which message
    std::uint32_t supported_presence_vector{}; ///< the supported fields; shorter vectors are in the low bits
    friend constexpr bool operator==(const supported_message&, const supported_message&) = default;

    struct schema : wire::items {
        using T = supported_message;
        using type = layout<
            field<&T::command_code, u16le>,
            field<&T::supported_presence_vector, u32le>>;
    };
};

/// A service in Report Services. 4 bytes or more.
struct offered_service {
    std::uint16_t service_type{};                   ///< a component ID, or 0 for the core service of each component
    wire::list<supported_message> input_message{};  ///< what it takes; up to 255
    wire::list<supported_message> output_message{}; ///< what it sends; up to 255
    friend constexpr bool operator==(const offered_service&, const offered_service&) = default;

    struct schema : wire::items {
        using T = offered_service;
        using type = layout<
            field<&T::service_type, u16le>,
            repeated<&T::input_message, count<"number_of_input_messages", u8>>,
            repeated<&T::output_message, count<"number_of_output_messages", u8>>>;
    };
};

/// Report Services: the services of a component and their messages.
/// Code 4B03h, inform class, 1 byte or more.
struct report_services {
    wire::list<offered_service> service{}; ///< up to 255
    friend constexpr bool operator==(const report_services&, const report_services&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4B03;
        using query = query_services;
        using T = report_services;
        using type = layout<repeated<&T::service, count<"number_of_services", u8>>>;
    };
};

/// The messages of the subgroup, by command code.
using dynamic_configuration_subgroup = message_list<
    query_identification,
    query_configuration,
    query_subsystem_list,
    query_services,
    report_identification,
    report_configuration,
    report_subsystem_list,
    report_services>;

} // namespace jauscat::jaus
