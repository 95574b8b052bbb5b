// Liveness 1.1, urn:jaus:jss:core:Liveness.
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

/// QueryHeartbeatPulse: ID 2202h, input of Liveness.
struct query_heartbeat_pulse {
    friend constexpr bool operator==(const query_heartbeat_pulse&, const query_heartbeat_pulse&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2202;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportHeartbeatPulse: ID 4202h, output of Liveness.
struct report_heartbeat_pulse {
    friend constexpr bool operator==(const report_heartbeat_pulse&, const report_heartbeat_pulse&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4202;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

namespace services {

/// Liveness: what it is called, and its messages.
struct liveness {
    static constexpr std::string_view name = "Liveness";
    static constexpr std::string_view uri = "urn:jaus:jss:core:Liveness";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_heartbeat_pulse>;
    using outputs = jaus::message_list<report_heartbeat_pulse>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
