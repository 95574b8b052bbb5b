// Discovery 1.1, urn:jaus:jss:core:Discovery.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/core/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::core {

/// Values of QueryType.
enum class query_identification_query_type : std::uint8_t {
    reserved = 0,
    system_identification = 1,
    subsystem_identification = 2,
    node_identification = 3,
    component_identification = 4,
};

/// QueryIdentification: ID 2B00h, input of Discovery.
struct query_identification {
    query_identification_query_type query_type{}; ///< 5 to 255
    friend constexpr bool operator==(const query_identification&, const query_identification&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2B00;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_identification;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::query_type, enumeration<query_identification_query_type, u8>>>;
    };
};

/// Values of QueryType.
enum class query_configuration_query_type : std::uint8_t {
    reserved_0 = 0, ///< Reserved
    reserved_1 = 1, ///< Reserved
    subsystem_identification = 2,
    node_identification = 3,
};

/// QueryConfiguration: ID 2B01h, input of Discovery.
struct query_configuration {
    query_configuration_query_type query_type{}; ///< 4 to 255
    friend constexpr bool operator==(const query_configuration&, const query_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2B01;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::query_type, enumeration<query_configuration_query_type, u8>>>;
    };
};

/// QuerySubsystemList: ID 2B02h, input of Discovery.
struct query_subsystem_list {
    friend constexpr bool operator==(const query_subsystem_list&, const query_subsystem_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2B02;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Values of NodeID.
enum class node_id : std::uint8_t {
    reserved = 0,
    all_nodes_in_the_subsystem = 255,
};

/// Record NodeRec.
struct query_services_node_rec {
    core::node_id node_id{}; ///< 1 to 254
    friend constexpr bool operator==(const query_services_node_rec&, const query_services_node_rec&) = default;

    struct schema : wire::items {
        using T = query_services_node_rec;
        using type = layout<field<&T::node_id, enumeration<core::node_id, u8>>>;
    };
};

/// Values of ComponentID.
enum class component_id : std::uint8_t {
    reserved = 0,
    all_components_in_the_subsystem = 255,
};

/// Record ComponentRec.
struct query_services_component_rec {
    core::component_id component_id{}; ///< 1 to 254
    friend constexpr bool operator==(
        const query_services_component_rec&,
        const query_services_component_rec&) = default;

    struct schema : wire::items {
        using T = query_services_component_rec;
        using type = layout<field<&T::component_id, enumeration<core::component_id, u8>>>;
    };
};

/// Sequence NodeSeq.
struct query_services_node_seq {
    query_services_node_rec node_rec{};
    wire::list<query_services_component_rec> component_list{}; ///< 1 to 255 elements
    friend constexpr bool operator==(const query_services_node_seq&, const query_services_node_seq&) = default;

    struct schema : wire::items {
        using T = query_services_node_seq;
        using type = layout<
            nested<&T::node_rec>,
            repeated<&T::component_list, count_between<"number_of_component_list", u8, 1, 255>>>;
    };
};

/// QueryServices: ID 2B03h, input of Discovery.
struct query_services {
    wire::list<query_services_node_seq> node_list{}; ///< 1 to 255 elements
    friend constexpr bool operator==(const query_services&, const query_services&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2B03;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_services;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::node_list, count_between<"number_of_node_list", u8, 1, 255>>>;
    };
};

/// Values of SubsystemID.
enum class subsystem_id : std::uint16_t {
    reserved = 0,
    all_subsystems_in_the_system = 65535,
};

/// Record SubsystemRec.
struct query_service_list_subsystem_rec {
    core::subsystem_id subsystem_id{}; ///< 1 to 65534
    friend constexpr bool operator==(
        const query_service_list_subsystem_rec&,
        const query_service_list_subsystem_rec&) = default;

    struct schema : wire::items {
        using T = query_service_list_subsystem_rec;
        using type = layout<field<&T::subsystem_id, enumeration<core::subsystem_id, u16le>>>;
    };
};

/// Record NodeRec.
struct query_service_list_node_rec {
    core::node_id node_id{}; ///< 1 to 254
    friend constexpr bool operator==(const query_service_list_node_rec&, const query_service_list_node_rec&) = default;

    struct schema : wire::items {
        using T = query_service_list_node_rec;
        using type = layout<field<&T::node_id, enumeration<core::node_id, u8>>>;
    };
};

/// Record ComponentRec.
struct query_service_list_component_rec {
    core::component_id component_id{};               ///< 1 to 254
    std::optional<std::string_view> search_filter{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const query_service_list_component_rec&,
        const query_service_list_component_rec&) = default;

    struct schema : wire::items {
        using T = query_service_list_component_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::component_id, enumeration<core::component_id, u8>>,
                string<&T::search_filter, count<"search_filter_size", u8>>>>;
    };
};

/// Sequence NodeSeq.
struct query_service_list_node_seq {
    query_service_list_node_rec node_rec{};
    wire::list<query_service_list_component_rec> component_list{}; ///< 1 to 255 elements
    friend constexpr bool operator==(const query_service_list_node_seq&, const query_service_list_node_seq&) = default;

    struct schema : wire::items {
        using T = query_service_list_node_seq;
        using type = layout<
            nested<&T::node_rec>,
            repeated<&T::component_list, count_between<"number_of_component_list", u8, 1, 255>>>;
    };
};

/// Sequence SubsystemSeq.
struct query_service_list_subsystem_seq {
    query_service_list_subsystem_rec subsystem_rec{};
    wire::list<query_service_list_node_seq> node_list{}; ///< 1 to 255 elements
    friend constexpr bool operator==(
        const query_service_list_subsystem_seq&,
        const query_service_list_subsystem_seq&) = default;

    struct schema : wire::items {
        using T = query_service_list_subsystem_seq;
        using type = layout<
            nested<&T::subsystem_rec>,
            repeated<&T::node_list, count_between<"number_of_node_list", u8, 1, 255>>>;
    };
};

/// QueryServiceList: ID 2B04h, input of Discovery.
struct query_service_list {
    wire::list<query_service_list_subsystem_seq> subsystem_list{}; ///< 1 to 65535 elements
    friend constexpr bool operator==(const query_service_list&, const query_service_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2B04;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_service_list;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::subsystem_list, count_between<"number_of_subsystem_list", u16le, 1, 65535>>>;
    };
};

/// Record ServiceRec.
struct service_rec {
    std::string_view uri{}; ///< up to 255 characters
    std::uint8_t major_version_number{};
    std::uint8_t minor_version_number{};
    friend constexpr bool operator==(const service_rec&, const service_rec&) = default;

    struct schema : wire::items {
        using T = service_rec;
        using type = layout<
            string<&T::uri, count<"uri_size", u8>>,
            field<&T::major_version_number, u8>,
            field<&T::minor_version_number, u8>>;
    };
};

/// RegisterServices: ID 0B00h, command, input of Discovery.
struct register_services {
    wire::list<service_rec> service_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const register_services&, const register_services&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0B00;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = register_services;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::service_list, count<"number_of_service_list", u8>>>;
    };
};

/// Values of QueryType.
enum class report_identification_query_type : std::uint8_t {
    reserved = 0,
    system_identification = 1,
    subsystem_identification = 2,
    node_identification = 3,
    component_identification = 4,
};

/// Values of Type.
enum class type : std::uint16_t {
    reserved = 0,
    vehicle = 10001,
    ocu = 20001,
    other_subsystem = 30001,
    node = 40001,
    payload = 50001,
    component = 60001,
};

/// ReportIdentification: ID 4B00h, output of Discovery.
struct report_identification {
    report_identification_query_type query_type{}; ///< 5 to 255
    /// 10002 to 20000, 20002 to 30000, 30002 to 40000, 40002 to 50000, 50002 to 60000, 60002 to 65535
    core::type type{};
    std::string_view identification{};             ///< up to 255 characters
    friend constexpr bool operator==(const report_identification&, const report_identification&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4B00;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_identification;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::query_type, enumeration<report_identification_query_type, u8>>,
            field<&T::type, in_value_set<enumeration<core::type, u16le>, between<10001, 65535>, one_of<0>>>,
            string<&T::identification, count<"identification_size", u8>>>;
    };
};

/// Record NodeRec.
struct report_configuration_node_rec {
    std::uint8_t node_id{};
    friend constexpr bool operator==(
        const report_configuration_node_rec&,
        const report_configuration_node_rec&) = default;

    struct schema : wire::items {
        using T = report_configuration_node_rec;
        using type = layout<field<&T::node_id, u8>>;
    };
};

/// Record ComponentRec.
struct report_configuration_component_rec {
    std::uint8_t component_id{};
    std::uint8_t instance_id{};
    friend constexpr bool operator==(
        const report_configuration_component_rec&,
        const report_configuration_component_rec&) = default;

    struct schema : wire::items {
        using T = report_configuration_component_rec;
        using type = layout<
            field<&T::component_id, u8>,
            field<&T::instance_id, u8>>;
    };
};

/// Sequence NodeSeq.
struct report_configuration_node_seq {
    report_configuration_node_rec node_rec{};
    wire::list<report_configuration_component_rec> component_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_configuration_node_seq&,
        const report_configuration_node_seq&) = default;

    struct schema : wire::items {
        using T = report_configuration_node_seq;
        using type = layout<
            nested<&T::node_rec>,
            repeated<&T::component_list, count<"number_of_component_list", u8>>>;
    };
};

/// ReportConfiguration: ID 4B01h, output of Discovery.
struct report_configuration {
    wire::list<report_configuration_node_seq> node_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_configuration&, const report_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4B01;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::node_list, count<"number_of_node_list", u8>>>;
    };
};

/// Record SubsystemRec.
struct report_subsystem_list_subsystem_rec {
    std::uint16_t subsystem_id{};
    std::uint8_t node_id{};
    std::uint8_t component_id{};
    friend constexpr bool operator==(
        const report_subsystem_list_subsystem_rec&,
        const report_subsystem_list_subsystem_rec&) = default;

    struct schema : wire::items {
        using T = report_subsystem_list_subsystem_rec;
        using type = layout<
            field<&T::subsystem_id, u16le>,
            field<&T::node_id, u8>,
            field<&T::component_id, u8>>;
    };
};

/// ReportSubsystemList: ID 4B02h, output of Discovery.
struct report_subsystem_list {
    wire::list<report_subsystem_list_subsystem_rec> subsystem_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_subsystem_list&, const report_subsystem_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4B02;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_subsystem_list;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::subsystem_list, count<"number_of_subsystem_list", u8>>>;
    };
};

/// Record NodeRec.
struct report_services_node_rec {
    std::uint8_t node_id{};
    friend constexpr bool operator==(const report_services_node_rec&, const report_services_node_rec&) = default;

    struct schema : wire::items {
        using T = report_services_node_rec;
        using type = layout<field<&T::node_id, u8>>;
    };
};

/// Record ComponentRec.
struct report_services_component_rec {
    std::uint8_t component_id{};
    std::uint8_t instance_id{};
    friend constexpr bool operator==(
        const report_services_component_rec&,
        const report_services_component_rec&) = default;

    struct schema : wire::items {
        using T = report_services_component_rec;
        using type = layout<
            field<&T::component_id, u8>,
            field<&T::instance_id, u8>>;
    };
};

/// Sequence ComponentSeq.
struct component_seq {
    report_services_component_rec component_rec{};
    wire::list<service_rec> service_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const component_seq&, const component_seq&) = default;

    struct schema : wire::items {
        using T = component_seq;
        using type = layout<
            nested<&T::component_rec>,
            repeated<&T::service_list, count<"number_of_service_list", u8>>>;
    };
};

/// Sequence NodeSeq.
struct report_services_node_seq {
    report_services_node_rec node_rec{};
    wire::list<component_seq> component_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_services_node_seq&, const report_services_node_seq&) = default;

    struct schema : wire::items {
        using T = report_services_node_seq;
        using type = layout<
            nested<&T::node_rec>,
            repeated<&T::component_list, count<"number_of_component_list", u8>>>;
    };
};

/// ReportServices: ID 4B03h, output of Discovery.
struct report_services {
    wire::list<report_services_node_seq> node_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_services&, const report_services&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4B03;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_services;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::node_list, count<"number_of_node_list", u8>>>;
    };
};

/// Record SubsystemRec.
struct report_service_list_subsystem_rec {
    std::uint16_t subsystem_id{};
    friend constexpr bool operator==(
        const report_service_list_subsystem_rec&,
        const report_service_list_subsystem_rec&) = default;

    struct schema : wire::items {
        using T = report_service_list_subsystem_rec;
        using type = layout<field<&T::subsystem_id, u16le>>;
    };
};

/// Record NodeRec.
struct report_service_list_node_rec {
    std::uint8_t node_id{};
    friend constexpr bool operator==(
        const report_service_list_node_rec&,
        const report_service_list_node_rec&) = default;

    struct schema : wire::items {
        using T = report_service_list_node_rec;
        using type = layout<field<&T::node_id, u8>>;
    };
};

/// Sequence NodeSeq.
struct report_service_list_node_seq {
    report_service_list_node_rec node_rec{};
    wire::list<component_seq> component_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_service_list_node_seq&,
        const report_service_list_node_seq&) = default;

    struct schema : wire::items {
        using T = report_service_list_node_seq;
        using type = layout<
            nested<&T::node_rec>,
            repeated<&T::component_list, count<"number_of_component_list", u8>>>;
    };
};

/// Sequence SubsystemSeq.
struct report_service_list_subsystem_seq {
    report_service_list_subsystem_rec subsystem_rec{};
    wire::list<report_service_list_node_seq> node_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_service_list_subsystem_seq&,
        const report_service_list_subsystem_seq&) = default;

    struct schema : wire::items {
        using T = report_service_list_subsystem_seq;
        using type = layout<
            nested<&T::subsystem_rec>,
            repeated<&T::node_list, count<"number_of_node_list", u8>>>;
    };
};

/// ReportServiceList: ID 4B04h, output of Discovery.
struct report_service_list {
    wire::list<report_service_list_subsystem_seq> subsystem_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const report_service_list&, const report_service_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4B04;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_service_list;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::subsystem_list, count<"number_of_subsystem_list", u16le>>>;
    };
};

namespace services {

/// Discovery: what it is called, and its messages.
struct discovery {
    static constexpr std::string_view name = "Discovery";
    static constexpr std::string_view uri = "urn:jaus:jss:core:Discovery";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        query_identification,
        query_configuration,
        query_subsystem_list,
        query_services,
        query_service_list,
        register_services>;
    using outputs = jaus::message_list<
        report_identification,
        report_configuration,
        report_subsystem_list,
        report_services,
        report_service_list>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
