// Communications subgroup of RA 3.3 part 3.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Report Heartbeat Pulse: the sender is alive; sent once a second. Code 4202h, inform class, no body.
struct report_heartbeat_pulse {
    static constexpr std::uint16_t command_code = 0x4202;
    friend constexpr bool operator==(const report_heartbeat_pulse&, const report_heartbeat_pulse&) = default;
};

} // namespace jauscat::jaus

namespace jauscat {

template <> struct wire::schema<jaus::report_heartbeat_pulse> { using type = layout<>; };

} // namespace jauscat
