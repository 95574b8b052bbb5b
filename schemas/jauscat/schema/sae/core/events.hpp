// Events 1.1, urn:jaus:jss:core:Events.
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

/// Values of EventType.
enum class event_type : std::uint8_t {
    periodic_sc = 0, ///< Periodic (SC)
    every_change = 1,
};

/// CreateEvent: ID 01F0h, command, input of Events.
struct create_event {
    std::uint8_t request_id{};
    core::event_type event_type{};
    double requested_periodic_rate{};       ///< hertz, 0 to 1092
    wire::embedded_message query_message{}; ///< JAUS MESSAGE, 2 to 2147483647 octets
    friend constexpr bool operator==(const create_event&, const create_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F0;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = create_event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::event_type, in_value_set<enumeration<core::event_type, u8>, between<0, 1>>>,
            field<&T::requested_periodic_rate, scaled<u16le, hertz_0_to_1092>>,
            embedded<&T::query_message, count_between<"query_message_size", u32le, 2, 2147483647>>>;
    };
};

/// CreateCommandEvent: ID 01F6h, command, input of Events.
struct create_command_event {
    std::uint8_t request_id{};
    std::uint32_t maximum_allowed_duration{}; ///< second
    wire::embedded_message command_message{}; ///< JAUS MESSAGE, 2 to 2147483647 octets
    friend constexpr bool operator==(const create_command_event&, const create_command_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F6;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = create_command_event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::maximum_allowed_duration, in_units<u32le, second>>,
            embedded<&T::command_message, count_between<"command_message_size", u32le, 2, 2147483647>>>;
    };
};

/// UpdateEvent: ID 01F1h, command, input of Events.
struct update_event {
    std::uint8_t request_id{};
    core::event_type event_type{};
    double requested_periodic_rate{};       ///< hertz, 0 to 1092
    std::uint8_t event_id{};
    wire::embedded_message query_message{}; ///< JAUS MESSAGE, 2 to 2147483647 octets
    friend constexpr bool operator==(const update_event&, const update_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F1;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = update_event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::event_type, in_value_set<enumeration<core::event_type, u8>, between<0, 1>>>,
            field<&T::requested_periodic_rate, scaled<u16le, hertz_0_to_1092>>,
            field<&T::event_id, u8>,
            embedded<&T::query_message, count_between<"query_message_size", u32le, 2, 2147483647>>>;
    };
};

/// CancelEvent: ID 01F2h, command, input of Events.
struct cancel_event {
    std::uint8_t request_id{};
    std::uint8_t event_id{};
    friend constexpr bool operator==(const cancel_event&, const cancel_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F2;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = cancel_event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::event_id, u8>>;
    };
};

/// Record MessageIDRec.
struct message_id_rec {
    std::uint16_t message_code{};
    friend constexpr bool operator==(const message_id_rec&, const message_id_rec&) = default;

    struct schema : wire::items {
        using T = message_id_rec;
        using type = layout<field<&T::message_code, u16le>>;
    };
};

/// Record EventTypeRec.
struct event_type_rec {
    core::event_type event_type{};
    friend constexpr bool operator==(const event_type_rec&, const event_type_rec&) = default;

    struct schema : wire::items {
        using T = event_type_rec;
        using type = layout<field<&T::event_type, in_value_set<enumeration<core::event_type, u8>, between<0, 1>>>>;
    };
};

/// Record EventIDRec.
struct event_id_rec {
    std::uint8_t event_id{};
    friend constexpr bool operator==(const event_id_rec&, const event_id_rec&) = default;

    struct schema : wire::items {
        using T = event_id_rec;
        using type = layout<field<&T::event_id, u8>>;
    };
};

/// Record AllEventsRec.
struct all_events_rec {
    std::uint8_t all_events{}; ///< 0
    friend constexpr bool operator==(const all_events_rec&, const all_events_rec&) = default;

    struct schema : wire::items {
        using T = all_events_rec;
        using type = layout<field<&T::all_events, in_value_set<u8, one_of<0>>>>;
    };
};

/// QueryEvents: ID 21F0h, input of Events.
struct query_events {
    std::variant<message_id_rec, event_type_rec, event_id_rec, all_events_rec> query_events_var{};
    friend constexpr bool operator==(const query_events&, const query_events&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x21F0;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_events;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            variant<&T::query_events_var, u8>>;
    };
};

/// QueryEventTimeout: ID 21F2h, input of Events.
struct query_event_timeout {
    friend constexpr bool operator==(const query_event_timeout&, const query_event_timeout&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x21F2;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ConfirmEventRequest: ID 01F3h, output of Events.
struct confirm_event_request {
    std::uint8_t request_id{};
    std::uint8_t event_id{};
    double confirmed_periodic_rate{}; ///< hertz, 0 to 1092
    friend constexpr bool operator==(const confirm_event_request&, const confirm_event_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F3;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = confirm_event_request;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::event_id, u8>,
            field<&T::confirmed_periodic_rate, scaled<u16le, hertz_0_to_1092>>>;
    };
};

/// Values of ResponseCode.
enum class events_response_code : std::uint8_t {
    periodic_events_not_supported = 1,
    change_based_events_not_supported = 2,
    connection_refused = 3,
    invalid_event_setup = 4,
    message_not_supported = 5,
    error_invalid_event_id_for_update_event_request = 6, ///< error, invalid event ID for update event request
};

/// RejectEventRequest: ID 01F4h, output of Events.
struct reject_event_request {
    std::uint8_t request_id{};
    std::optional<events_response_code> response_code{};
    std::optional<std::string_view> error_message{}; ///< up to 80 characters
    friend constexpr bool operator==(const reject_event_request&, const reject_event_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F4;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = reject_event_request;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::request_id, u8>,
                field<&T::response_code, in_value_set<enumeration<events_response_code, u8>, between<1, 6>>>,
                string<&T::error_message, fixed<80>>>>;
    };
};

/// Record ReportEventRec.
struct report_event_rec {
    core::event_type event_type{};
    std::uint8_t event_id{};
    wire::embedded_message query_message{}; ///< JAUS MESSAGE, 2 to 2147483647 octets
    friend constexpr bool operator==(const report_event_rec&, const report_event_rec&) = default;

    struct schema : wire::items {
        using T = report_event_rec;
        using type = layout<
            field<&T::event_type, in_value_set<enumeration<core::event_type, u8>, between<0, 1>>>,
            field<&T::event_id, u8>,
            embedded<&T::query_message, count_between<"query_message_size", u32le, 2, 2147483647>>>;
    };
};

/// ReportEvents: ID 41F0h, output of Events.
struct report_events {
    wire::list<report_event_rec> event_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_events&, const report_events&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x41F0;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_events;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::event_list, count<"number_of_event_list", u8>>>;
    };
};

/// Event: ID 41F1h, output of Events.
struct event {
    std::uint8_t event_id{};
    std::uint8_t sequence_number{};
    wire::embedded_message report_message{}; ///< JAUS MESSAGE, 2 to 2147483647 octets
    friend constexpr bool operator==(const event&, const event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x41F1;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::event_id, u8>,
            field<&T::sequence_number, u8>,
            embedded<&T::report_message, count_between<"report_message_size", u32le, 2, 2147483647>>>;
    };
};

/// Values of CommandResult.
enum class command_result : std::uint8_t {
    successful = 0,
    unsuccessful = 1,
};

/// CommandEvent: ID 41F6h, output of Events.
struct command_event {
    std::uint8_t event_id{};
    core::command_result command_result{};
    friend constexpr bool operator==(const command_event&, const command_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x41F6;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = command_event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::event_id, u8>,
            field<&T::command_result, in_value_set<enumeration<core::command_result, u8>, between<0, 1>>>>;
    };
};

/// ReportEventTimeout: ID 41F2h, output of Events.
struct report_event_timeout {
    core::timeout timeout{}; ///< minute, 1 to 255
    friend constexpr bool operator==(const report_event_timeout&, const report_event_timeout&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x41F2;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_event_timeout;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::timeout, enumeration<core::timeout, u8>>>;
    };
};

namespace services {

/// Events: what it is called, and its messages.
struct events {
    static constexpr std::string_view name = "Events";
    static constexpr std::string_view uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Transport";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        create_event,
        create_command_event,
        update_event,
        cancel_event,
        query_events,
        query_event_timeout>;
    using outputs = jaus::message_list<
        confirm_event_request,
        reject_event_request,
        report_events,
        event,
        command_event,
        report_event_timeout>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
