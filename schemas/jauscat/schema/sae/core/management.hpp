// Management 1.1, urn:jaus:jss:core:Management.
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

/// Shutdown: ID 0002h, command, input of Management.
struct shutdown {
    friend constexpr bool operator==(const shutdown&, const shutdown&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0002;
        static constexpr bool is_command = true, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Standby: ID 0003h, command, input of Management.
struct standby {
    friend constexpr bool operator==(const standby&, const standby&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0003;
        static constexpr bool is_command = true, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Resume: ID 0004h, command, input of Management.
struct resume {
    friend constexpr bool operator==(const resume&, const resume&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0004;
        static constexpr bool is_command = true, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Reset: ID 0005h, command, input of Management.
struct reset {
    friend constexpr bool operator==(const reset&, const reset&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0005;
        static constexpr bool is_command = true, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Values of EmergencyCode.
enum class emergency_code : std::uint16_t {
    stop = 1,
};

/// SetEmergency: ID 0006h, command, input of Management.
struct set_emergency {
    core::emergency_code emergency_code{};
    friend constexpr bool operator==(const set_emergency&, const set_emergency&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0006;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_emergency;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::emergency_code, in_value_set<enumeration<core::emergency_code, u16le>, one_of<1>>>>;
    };
};

/// ClearEmergency: ID 0007h, command, input of Management.
struct clear_emergency {
    core::emergency_code emergency_code{};
    friend constexpr bool operator==(const clear_emergency&, const clear_emergency&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0007;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = clear_emergency;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::emergency_code, in_value_set<enumeration<core::emergency_code, u16le>, one_of<1>>>>;
    };
};

/// QueryStatus: ID 2002h, input of Management.
struct query_status {
    friend constexpr bool operator==(const query_status&, const query_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2002;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Values of Status.
enum class status : std::uint8_t {
    initialize = 0,
    ready = 1,
    standby = 2,
    shutdown = 3,
    failure = 4,
    emergency = 5,
};

/// ReportStatus: ID 4002h, output of Management.
struct report_status {
    core::status status{};
    std::uint32_t reserved{};
    friend constexpr bool operator==(const report_status&, const report_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4002;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_status;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::status, in_value_set<enumeration<core::status, u8>, between<0, 5>>>,
            field<&T::reserved, u32le>>;
    };
};

namespace services {

/// Management: what it is called, and its messages.
struct management {
    static constexpr std::string_view name = "Management";
    static constexpr std::string_view uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<shutdown, standby, resume, reset, set_emergency, clear_emergency, query_status>;
    using outputs = jaus::message_list<report_status>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
