// AccessControl 1.1, urn:jaus:jss:core:AccessControl.
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

/// RequestControl: ID 000Dh, command, input of AccessControl.
struct request_control {
    std::uint8_t authority_code{}; ///< 0 to 255
    friend constexpr bool operator==(const request_control&, const request_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x000D;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = request_control;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::authority_code, u8>>;
    };
};

/// ReleaseControl: ID 000Eh, command, input of AccessControl.
struct release_control {
    friend constexpr bool operator==(const release_control&, const release_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x000E;
        static constexpr bool is_command = true, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// QueryControl: ID 200Dh, input of AccessControl.
struct query_control {
    friend constexpr bool operator==(const query_control&, const query_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x200D;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// QueryAuthority: ID 2001h, input of AccessControl.
struct query_authority {
    friend constexpr bool operator==(const query_authority&, const query_authority&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2001;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// SetAuthority: ID 0001h, command, input of AccessControl.
struct set_authority {
    std::uint8_t authority_code{}; ///< 0 to 255
    friend constexpr bool operator==(const set_authority&, const set_authority&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0001;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_authority;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::authority_code, u8>>;
    };
};

/// QueryTimeout: ID 2003h, input of AccessControl.
struct query_timeout {
    friend constexpr bool operator==(const query_timeout&, const query_timeout&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2003;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportControl: ID 400Dh, output of AccessControl.
struct report_control {
    std::uint16_t subsystem_id{};
    std::uint8_t node_id{};
    std::uint8_t component_id{};
    std::uint8_t authority_code{}; ///< 0 to 255
    friend constexpr bool operator==(const report_control&, const report_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x400D;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_control;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::subsystem_id, u16le>,
            field<&T::node_id, u8>,
            field<&T::component_id, u8>,
            field<&T::authority_code, u8>>;
    };
};

/// Values of ResponseCode.
enum class reject_control_response_code : std::uint8_t {
    control_released = 0,
    not_available = 1,
};

/// RejectControl: ID 0010h, output of AccessControl.
struct reject_control {
    reject_control_response_code response_code{};
    friend constexpr bool operator==(const reject_control&, const reject_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0010;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = reject_control;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::response_code, in_value_set<enumeration<reject_control_response_code, u8>, between<0, 1>>>>;
    };
};

/// Values of ResponseCode.
enum class confirm_control_response_code : std::uint8_t {
    control_accepted = 0,
    not_available = 1,
    insufficient_authority = 2,
};

/// ConfirmControl: ID 000Fh, output of AccessControl.
struct confirm_control {
    confirm_control_response_code response_code{};
    friend constexpr bool operator==(const confirm_control&, const confirm_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x000F;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = confirm_control;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::response_code, in_value_set<enumeration<confirm_control_response_code, u8>, between<0, 2>>>>;
    };
};

/// ReportAuthority: ID 4001h, output of AccessControl.
struct report_authority {
    std::uint8_t authority_code{}; ///< 0 to 255
    friend constexpr bool operator==(const report_authority&, const report_authority&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4001;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_authority;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::authority_code, u8>>;
    };
};

/// ReportTimeout: ID 4003h, output of AccessControl.
struct report_timeout {
    core::timeout timeout{}; ///< second, 1 to 255
    friend constexpr bool operator==(const report_timeout&, const report_timeout&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4003;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_timeout;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::timeout, enumeration<core::timeout, u8>>>;
    };
};

namespace services {

/// AccessControl: what it is called, and its messages.
struct access_control {
    static constexpr std::string_view name = "AccessControl";
    static constexpr std::string_view uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        request_control,
        release_control,
        query_control,
        query_authority,
        set_authority,
        query_timeout>;
    using outputs = jaus::message_list<
        report_control,
        reject_control,
        confirm_control,
        report_authority,
        report_timeout>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
