// Event subgroup of RA 3.3 part 3: reports on change or in periods.
#pragma once
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

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

/// Cancel Event: ends an event, or the events of a report.
/// Code 01F2h, command class, 2 to 5 bytes.
struct cancel_event {
    static constexpr std::uint16_t command_code = 0x01F2;
    std::uint8_t local_request_id{};             ///< the requester's own number
    std::optional<std::uint16_t> message_code{}; ///< command code of the report
    std::optional<std::uint8_t> event_id{};      ///< the event, as the confirmation numbered it
    friend constexpr bool operator==(const cancel_event&, const cancel_event&) = default;
};

/// Response Code of the event messages. Successful is sure; sources disagree on the numbers of the other values.
enum class event_response : std::uint8_t {
    successful = 0,
    periodic_events_not_supported = 1,
    change_based_events_not_supported = 2,
    connection_refused = 3,
    invalid_event_setup = 4,
    message_not_supported = 5,
    invalid_event_id_for_update_request = 6,
};

/// Confirm Event Request: answers Create Event and Update Event where the event is set up.
/// Code 01F3h, command class, 6 to 8 bytes.
struct confirm_event_request {
    static constexpr std::uint16_t command_code = 0x01F3;
    std::uint8_t local_request_id{};                 ///< as in the request
    std::uint16_t message_code{};                    ///< command code of the report
    std::uint8_t event_id{};                         ///< the number of the event
    std::optional<double> confirmed_periodic_rate{}; ///< hertz, 0 to 1092
    event_response response_code{};                  ///< successful, or a restriction
    friend constexpr bool operator==(const confirm_event_request&, const confirm_event_request&) = default;
};

/// Query Events: asks for Report Events.
/// Code 21F0h, query class, 1 to 5 bytes.
struct query_events {
    static constexpr std::uint16_t command_code = 0x21F0;
    std::optional<std::uint16_t> message_code{};  ///< only events of this report
    std::optional<jaus::event_type> event_type{}; ///< only events of this type
    std::optional<std::uint8_t> event_id{};       ///< only this event
    friend constexpr bool operator==(const query_events&, const query_events&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::cancel_event> {
    using T = jaus::cancel_event;
    using type = layout<
        presence<u8,
            field<&T::local_request_id, u8>,
            field<&T::message_code, u16le>,
            field<&T::event_id, u8>>>;
};

template <> struct wire::schema<jaus::confirm_event_request> {
    using T = jaus::confirm_event_request;
    using type = layout<
        presence<u8,
            field<&T::local_request_id, u8>,
            field<&T::message_code, u16le>,
            field<&T::event_id, u8>,
            field<&T::confirmed_periodic_rate, scaled<u16le, jaus::update_rate>>,
            field<&T::response_code, enumeration<jaus::event_response, u8>>>>;
};

template <> struct wire::schema<jaus::query_events> {
    using T = jaus::query_events;
    using type = layout<
        presence<u8,
            field<&T::message_code, u16le>,
            field<&T::event_type, enumeration<jaus::event_type, u8>>,
            field<&T::event_id, u8>>>;
};

} // namespace jauscat
