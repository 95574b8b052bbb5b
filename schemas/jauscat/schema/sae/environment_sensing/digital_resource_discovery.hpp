// DigitalResourceDiscovery 2.0, urn:jaus:jss:environmentSensing:DigitalResourceDiscovery.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/environment_sensing/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::environment_sensing {

/// QueryDigitalResourceEndpoint: ID 2816h, input of DigitalResourceDiscovery.
struct query_digital_resource_endpoint {
    friend constexpr bool operator==(
        const query_digital_resource_endpoint&,
        const query_digital_resource_endpoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2816;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Record RequestIDRec.
struct digital_resource_discovery_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const digital_resource_discovery_request_id_rec&,
        const digital_resource_discovery_request_id_rec&) = default;

    struct schema : wire::items {
        using T = digital_resource_discovery_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of ServerType.
enum class server_type : std::uint8_t {
    rtsp = 0,
    mpeg2_ts = 1,
    ftp = 2,
    sftp = 3,
    ftp_over_ssh = 4,
    http = 5,
    https = 6,
    scp = 7,
    ccsi = 8,
};

/// Bits of JAUS_ID.
struct jaus_id {
    std::uint8_t component_id{};  ///< 0 to 255
    std::uint8_t node_id{};       ///< 0 to 255
    std::uint16_t subsystem_id{}; ///< 0 to 65535
    friend constexpr bool operator==(const jaus_id&, const jaus_id&) = default;

    struct schema : wire::items {
        using T = jaus_id;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::component_id, 8>,
                bit_field<&T::node_id, 8>,
                bit_field<&T::subsystem_id, 16>>>;
    };
};

/// Record DigitalResourceEndpointRec.
struct digital_resource_endpoint_rec {
    environment_sensing::server_type server_type{}; ///< 9 to 200, 201 to 255
    std::string_view server_url{};                  ///< up to 255 characters
    std::optional<environment_sensing::jaus_id> jaus_id{};
    std::optional<std::uint16_t> resource_id{};
    friend constexpr bool operator==(
        const digital_resource_endpoint_rec&,
        const digital_resource_endpoint_rec&) = default;

    struct schema : wire::items {
        using T = digital_resource_endpoint_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::server_type, enumeration<environment_sensing::server_type, u8>>,
                string<&T::server_url, count<"server_url_size", u8>>,
                nested<&T::jaus_id>,
                field<&T::resource_id, u16le>>>;
    };
};

/// RegisterDigitalResourceEndpoint: ID 0808h, command, input of DigitalResourceDiscovery.
struct register_digital_resource_endpoint {
    digital_resource_discovery_request_id_rec request_id_rec{};
    environment_sensing::digital_resource_endpoint_rec digital_resource_endpoint_rec{};
    friend constexpr bool operator==(
        const register_digital_resource_endpoint&,
        const register_digital_resource_endpoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0808;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = register_digital_resource_endpoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            nested<&T::digital_resource_endpoint_rec>>;
    };
};

/// RemoveDigitalResourceEndpoint: ID 0809h, command, input of DigitalResourceDiscovery.
struct remove_digital_resource_endpoint {
    std::uint8_t id{};
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const remove_digital_resource_endpoint&,
        const remove_digital_resource_endpoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0809;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = remove_digital_resource_endpoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::id, u8>,
            field<&T::request_id, u8>>;
    };
};

/// ReportDigitalResourceEndpoint: ID 4816h, output of DigitalResourceDiscovery.
struct report_digital_resource_endpoint {
    wire::list<digital_resource_endpoint_rec> digital_resource_endpoint_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_digital_resource_endpoint&,
        const report_digital_resource_endpoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4816;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_digital_resource_endpoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::digital_resource_endpoint_list, count<"number_of_digital_resource_endpoint_list", u8>>>;
    };
};

/// ConfirmDigitalResourceEndpoint: ID 080Ah, output of DigitalResourceDiscovery.
struct confirm_digital_resource_endpoint {
    std::uint8_t id{};
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const confirm_digital_resource_endpoint&,
        const confirm_digital_resource_endpoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x080A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = confirm_digital_resource_endpoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::id, u8>,
            field<&T::request_id, u8>>;
    };
};

namespace services {

/// DigitalResourceDiscovery: what it is called, and its messages.
struct digital_resource_discovery {
    static constexpr std::string_view name = "DigitalResourceDiscovery";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:DigitalResourceDiscovery";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        query_digital_resource_endpoint,
        register_digital_resource_endpoint,
        remove_digital_resource_endpoint>;
    using outputs = jaus::message_list<report_digital_resource_endpoint, confirm_digital_resource_endpoint>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
