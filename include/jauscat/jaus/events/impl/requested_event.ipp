// The functions of requested_event.
#pragma once
#include <jauscat/jaus/events/requested_event.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR update_event as_update(const create_event& m, std::uint8_t event_id) noexcept {
    return {.local_request_id = m.local_request_id,
            .message_code = m.message_code,
            .event_type = m.event_type,
            .event_boundary = m.event_boundary,
            .limit_data_field = m.limit_data_field,
            .lower_limit = m.lower_limit,
            .upper_limit = m.upper_limit,
            .state_limit = m.state_limit,
            .requested_minimum_periodic_rate = m.requested_minimum_periodic_rate,
            .requested_periodic_rate = m.requested_periodic_rate,
            .event_id = event_id,
            .query_message_body = m.query_message_body};
}

} // namespace jauscat::jaus
