// Event subgroup of RA 3.3 part 3: reports on change or in periods.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/typed_value.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// What triggers an event.
enum class event_type : std::uint8_t {
    periodic = 0,
    every_change = 1,
    first_change = 2,
    first_change_in_and_out_of_boundary = 3,
    periodic_without_repeat = 4, ///< also called replacement
    one_time_on_demand = 5,
};

/// How the value of a field is compared with the limits of an event.
enum class event_boundary : std::uint8_t {
    equal = 0,
    not_equal = 1,
    inside_inclusive = 2,
    inside_exclusive = 3,
    outside_inclusive = 4,
    outside_exclusive = 5,
    greater_than_or_equal = 6,
    strictly_greater_than = 7,
    less_than_or_equal = 8,
    strictly_less_than = 9,
};

/// Create Event: asks for a report whenever something happens.
/// Code 01F0h, command class, 5 bytes or more.
struct create_event {
    std::uint8_t local_request_id{};                      ///< the requester's own number
    std::uint16_t message_code{};                         ///< command code of the report
    jaus::event_type event_type{};                        ///< what triggers the report
    std::optional<jaus::event_boundary> event_boundary{}; ///< how the limits are compared
    std::optional<std::uint8_t> limit_data_field{}; ///< number of the field in the report that the limits apply to
    std::optional<typed_value> lower_limit{};       ///< of the field
    std::optional<typed_value> upper_limit{};       ///< of the field
    std::optional<typed_value> state_limit{};       ///< of a field that is a state
    std::optional<double> requested_minimum_periodic_rate{}; ///< hertz, 0 to 1092
    std::optional<double> requested_periodic_rate{};         ///< hertz, 0 to 1092
    std::optional<wire::blob> query_message_body{};          ///< of the query for the report, without a header
    friend constexpr bool operator==(const create_event&, const create_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x01F0;
        using T = create_event;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                field<&T::message_code, u16le>,
                field<&T::event_type, enumeration<jaus::event_type, u8>>,
                field<&T::event_boundary, enumeration<jaus::event_boundary, u8>>,
                field<&T::limit_data_field, u8>,
                nested<&T::lower_limit>,
                nested<&T::upper_limit>,
                nested<&T::state_limit>,
                field<&T::requested_minimum_periodic_rate, scaled<u16le, update_rate>>,
                field<&T::requested_periodic_rate, scaled<u16le, update_rate>>,
                bytes<&T::query_message_body, count<"query_message_size", u32le>>>>;
    };
};

/// Update Event: changes an event that has been created.
/// Code 01F1h, command class, 6 bytes or more.
struct update_event {
    std::uint8_t local_request_id{};                      ///< the requester's own number
    std::uint16_t message_code{};                         ///< command code of the report
    jaus::event_type event_type{};                        ///< what triggers the report
    std::optional<jaus::event_boundary> event_boundary{}; ///< how the limits are compared
    std::optional<std::uint8_t> limit_data_field{}; ///< number of the field in the report that the limits apply to
    std::optional<typed_value> lower_limit{};       ///< of the field
    std::optional<typed_value> upper_limit{};       ///< of the field
    std::optional<typed_value> state_limit{};       ///< of a field that is a state
    std::optional<double> requested_minimum_periodic_rate{}; ///< hertz, 0 to 1092
    std::optional<double> requested_periodic_rate{};         ///< hertz, 0 to 1092
    std::uint8_t event_id{};                                 ///< the event, as the confirmation numbered it
    std::optional<wire::blob> query_message_body{};          ///< of the query for the report, without a header
    friend constexpr bool operator==(const update_event&, const update_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x01F1;
        using T = update_event;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                field<&T::message_code, u16le>,
                field<&T::event_type, enumeration<jaus::event_type, u8>>,
                field<&T::event_boundary, enumeration<jaus::event_boundary, u8>>,
                field<&T::limit_data_field, u8>,
                nested<&T::lower_limit>,
                nested<&T::upper_limit>,
                nested<&T::state_limit>,
                field<&T::requested_minimum_periodic_rate, scaled<u16le, update_rate>>,
                field<&T::requested_periodic_rate, scaled<u16le, update_rate>>,
                field<&T::event_id, u8>,
                bytes<&T::query_message_body, count<"query_message_size", u32le>>>>;
    };
};

/// Cancel Event: ends an event, or the events of a report.
/// Code 01F2h, command class, 2 to 5 bytes.
struct cancel_event {
    std::uint8_t local_request_id{};             ///< the requester's own number
    std::optional<std::uint16_t> message_code{}; ///< command code of the report
    std::optional<std::uint8_t> event_id{};      ///< the event, as the confirmation numbered it
    friend constexpr bool operator==(const cancel_event&, const cancel_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x01F2;
        using T = cancel_event;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                field<&T::message_code, u16le>,
                field<&T::event_id, u8>>>;
    };
};

/// Response Code of the event messages. Successful is sure; sources disagree on the numbers of the other values.
enum class event_response : std::uint8_t {
    successful = 0,
    periodic_events_not_supported = 1,
    change_based_events_not_supported = 2,
    connection_refused = 3,
    invalid_event_setup = 4,
    message_not_supported = 5,
    error_invalid_event_id_for_update_request = 6,
};

/// Confirm Event Request: answers Create Event and Update Event where the event is set up.
/// Code 01F3h, command class, 6 to 8 bytes.
struct confirm_event_request {
    std::uint8_t local_request_id{};                 ///< as in the request
    std::uint16_t message_code{};                    ///< command code of the report
    std::uint8_t event_id{};                         ///< the number of the event
    std::optional<double> confirmed_periodic_rate{}; ///< hertz, 0 to 1092
    event_response response_code{};                  ///< successful, or a restriction
    friend constexpr bool operator==(const confirm_event_request&, const confirm_event_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x01F3;
        using T = confirm_event_request;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                field<&T::message_code, u16le>,
                field<&T::event_id, u8>,
                field<&T::confirmed_periodic_rate, scaled<u16le, update_rate>>,
                field<&T::response_code, enumeration<event_response, u8>>>>;
    };
};

/// Reject Event Request: answers a request for an event that cannot be met.
/// Code 01F4h, command class, 3 bytes or more. The text goes to the end of the body; some peers add a zero, some fill
/// it.
struct reject_event_request {
    std::uint8_t local_request_id{};                 ///< as in the request
    event_response response_code{};                  ///< the reason
    std::optional<std::string_view> error_message{}; ///< the reason in words
    friend constexpr bool operator==(const reject_event_request&, const reject_event_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x01F4;
        using T = reject_event_request;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                field<&T::response_code, enumeration<event_response, u8>>,
                string<&T::error_message, rest>>>;
    };
};

/// Query Events: asks for Report Events.
/// Code 21F0h, query class, 1 to 5 bytes.
struct query_events {
    std::optional<std::uint16_t> message_code{};  ///< only events of this report
    std::optional<jaus::event_type> event_type{}; ///< only events of this type
    std::optional<std::uint8_t> event_id{};       ///< only this event
    friend constexpr bool operator==(const query_events&, const query_events&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x21F0;
        using report = struct report_events;
        using T = query_events;
        using type = layout<
            lenient_presence<u8,
                field<&T::message_code, u16le>,
                field<&T::event_type, enumeration<jaus::event_type, u8>>,
                field<&T::event_id, u8>>>;
    };
};

/// An event in Report Events. 4 bytes or more.
struct reported_event {
    std::uint16_t message_code{};                         ///< command code of the report
    jaus::event_type event_type{};                        ///< what triggers the report
    std::optional<jaus::event_boundary> event_boundary{}; ///< how the limits are compared
    std::optional<std::uint8_t> limit_data_field{}; ///< number of the field in the report that the limits apply to
    std::optional<typed_value> lower_limit{};       ///< of the field
    std::optional<typed_value> upper_limit{};       ///< of the field
    std::optional<typed_value> state_limit{};       ///< of a field that is a state
    std::optional<std::uint8_t> event_id{};         ///< the event, as the confirmation numbered it
    std::optional<wire::blob> query_message{};      ///< of the query for the report; some peers put its header in front
    friend constexpr bool operator==(const reported_event&, const reported_event&) = default;

    struct schema : wire::items {
        using T = reported_event;
        using type = layout<
            lenient_presence<u8,
                field<&T::message_code, u16le>,
                field<&T::event_type, enumeration<jaus::event_type, u8>>,
                field<&T::event_boundary, enumeration<jaus::event_boundary, u8>>,
                field<&T::limit_data_field, u8>,
                nested<&T::lower_limit>,
                nested<&T::upper_limit>,
                nested<&T::state_limit>,
                field<&T::event_id, u8>,
                bytes<&T::query_message, count<"query_message_size", u32le>>>>;
    };
};

/// Report Events: the events that are set up.
/// Code 41F0h, inform class, 1 byte or more.
struct report_events {
    wire::list<reported_event> event{}; ///< up to 255
    friend constexpr bool operator==(const report_events&, const report_events&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x41F0;
        using query = query_events;
        using T = report_events;
        using type = layout<repeated<&T::event, count<"number_of_events", u8>>>;
    };
};

/// Event: the report that an event triggered.
/// Code 41F1h, inform class, 8 bytes or more.
struct event {
    std::uint8_t event_id{};              ///< the event, as the confirmation numbered it
    std::uint16_t message_code{};         ///< command code of the report
    std::uint8_t event_sequence_number{}; ///< counts occurrences, wraps
    wire::blob report_message_body{};     ///< the report without a header
    friend constexpr bool operator==(const event&, const event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x41F1;
        using T = event;
        using type = layout<
            field<&T::event_id, u8>,
            field<&T::message_code, u16le>,
            field<&T::event_sequence_number, u8>,
            bytes<&T::report_message_body, count<"report_message_size", u32le>>>;
    };
};

/// The messages of the subgroup, by command code.
using event_subgroup = message_list<
    create_event,
    update_event,
    cancel_event,
    confirm_event_request,
    reject_event_request,
    query_events,
    report_events,
    event>;

} // namespace jauscat::jaus
