// Core subgroup of RA 3.3 part 3: authority, state, emergency, service connections, control, time.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/time_stamp.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Set Component Authority: sets the authority of the receiving component.
/// Code 0001h, command class, 1 byte.
struct set_component_authority {
    std::uint8_t authority_code{}; ///< 0 lowest to 255 highest
    friend constexpr bool operator==(const set_component_authority&, const set_component_authority&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0001;
        using T = set_component_authority;
        using type = layout<field<&T::authority_code, u8>>;
    };
};

/// Shutdown: ends the receiving component's work and frees what it holds.
/// Code 0002h, command class, no body.
struct shutdown {
    friend constexpr bool operator==(const shutdown&, const shutdown&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0002;
        using type = layout<>;
    };
};

/// Standby: takes the receiving component to its standby state.
/// Code 0003h, command class, no body.
struct standby {
    friend constexpr bool operator==(const standby&, const standby&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0003;
        using type = layout<>;
    };
};

/// Resume: takes the receiving component from standby back to its ready state.
/// Code 0004h, command class, no body.
struct resume {
    friend constexpr bool operator==(const resume&, const resume&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0004;
        using type = layout<>;
    };
};

/// Reset: restarts the receiving component.
/// Code 0005h, command class, no body.
struct reset {
    friend constexpr bool operator==(const reset&, const reset&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0005;
        using type = layout<>;
    };
};

/// Emergency Code of Set Emergency, by bit.
enum class set_emergency_code : std::uint16_t {
    transition_to_emergency = 0, ///< go to the emergency state
};

/// Set Emergency: notifies the receiving component of an emergency.
/// Code 0006h, command class, 2 bytes.
struct set_emergency {
    wire::bit_set<set_emergency_code> emergency_code{}; ///< bits 1 to 15 are unassigned, sent as zero
    friend constexpr bool operator==(const set_emergency&, const set_emergency&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0006;
        using T = set_emergency;
        using type = layout<field<&T::emergency_code, bit_set_codec<set_emergency_code, u16le>>>;
    };
};

/// Emergency Code of Clear Emergency, by bit.
enum class clear_emergency_code : std::uint16_t {
    clear_emergency = 0, ///< leave the emergency state
};

/// Clear Emergency: ends an emergency that the sender has set.
/// Code 0007h, command class, 2 bytes.
struct clear_emergency {
    wire::bit_set<clear_emergency_code> emergency_code{}; ///< bits 1 to 15 are unassigned, sent as zero
    friend constexpr bool operator==(const clear_emergency&, const clear_emergency&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0007;
        using T = clear_emergency;
        using type = layout<field<&T::emergency_code, bit_set_codec<clear_emergency_code, u16le>>>;
    };
};

/// Create Service Connection: asks for a report to be sent periodically.
/// Code 0008h, command class, 8 bytes.
struct create_service_connection {
    std::uint16_t command_code{};              ///< the connected report
    double requested_periodic_update_rate{};   ///< hertz, 0 to 1092
    std::uint32_t requested_presence_vector{}; ///< wanted fields; shorter vectors are in the low bits
    friend constexpr bool operator==(const create_service_connection&, const create_service_connection&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0008;
        using T = create_service_connection;
        using type = layout<
            field<&T::command_code, u16le>,
            field<&T::requested_periodic_update_rate, scaled<u16le, update_rate>>,
            field<&T::requested_presence_vector, u32le>>;
    };
};

/// Response Code of Confirm Service Connection.
enum class service_connection_response : std::uint8_t {
    connection_created = 0,
    node_does_not_support_service_connections = 1,
    component_does_not_support_service_connections = 2,
    insufficient_authority = 3,
    connection_refused = 4,
    invalid_service_connection_parameters = 5,
    command_not_supported = 6,
};

/// Confirm Service Connection: answers Create Service Connection.
/// Code 0009h, command class, 6 bytes.
struct confirm_service_connection {
    std::uint16_t command_code{};                ///< the connected report
    std::uint8_t instance_id{};                  ///< the number of the new connection
    double confirmed_periodic_update_rate{};     ///< hertz, 0 to 1092
    service_connection_response response_code{}; ///< created, or why not
    friend constexpr bool operator==(const confirm_service_connection&, const confirm_service_connection&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0009;
        using T = confirm_service_connection;
        using type = layout<
            field<&T::command_code, u16le>,
            field<&T::instance_id, u8>,
            field<&T::confirmed_periodic_update_rate, scaled<u16le, update_rate>>,
            field<&T::response_code, enumeration<service_connection_response, u8>>>;
    };
};

/// Activate Service Connection: makes a suspended connection send again.
/// Code 000Ah, command class, 3 bytes.
struct activate_service_connection {
    std::uint16_t command_code{}; ///< the connected report
    std::uint8_t instance_id{};   ///< the service connection, as the confirmation numbered it
    friend constexpr bool operator==(const activate_service_connection&, const activate_service_connection&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x000A;
        using T = activate_service_connection;
        using type = layout<
            field<&T::command_code, u16le>,
            field<&T::instance_id, u8>>;
    };
};

/// Suspend Service Connection: makes a connection pause.
/// Code 000Bh, command class, 3 bytes.
struct suspend_service_connection {
    std::uint16_t command_code{}; ///< the connected report
    std::uint8_t instance_id{};   ///< the service connection, as the confirmation numbered it
    friend constexpr bool operator==(const suspend_service_connection&, const suspend_service_connection&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x000B;
        using T = suspend_service_connection;
        using type = layout<
            field<&T::command_code, u16le>,
            field<&T::instance_id, u8>>;
    };
};

/// Terminate Service Connection: ends a connection.
/// Code 000Ch, command class, 3 bytes.
struct terminate_service_connection {
    std::uint16_t command_code{}; ///< the connected report
    std::uint8_t instance_id{};   ///< the service connection, as the confirmation numbered it
    friend constexpr bool operator==(const terminate_service_connection&,
                                     const terminate_service_connection&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x000C;
        using T = terminate_service_connection;
        using type = layout<
            field<&T::command_code, u16le>,
            field<&T::instance_id, u8>>;
    };
};

/// Request Component Control: asks for sole control of the receiving component.
/// Code 000Dh, command class, 1 byte.
struct request_component_control {
    std::uint8_t authority_code{}; ///< the sender's; 0 lowest to 255 highest
    friend constexpr bool operator==(const request_component_control&, const request_component_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x000D;
        using T = request_component_control;
        using type = layout<field<&T::authority_code, u8>>;
    };
};

/// Release Component Control: ends the control of the sender.
/// Code 000Eh, command class, no body.
struct release_component_control {
    friend constexpr bool operator==(const release_component_control&, const release_component_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x000E;
        using type = layout<>;
    };
};

/// Response Code of Confirm Component Control.
enum class component_control_response : std::uint8_t {
    control_accepted = 0,
    uninterruptible_control_not_supported = 1,
    control_not_accepted = 2,
};

/// Confirm Component Control: answers Request Component Control.
/// Code 000Fh, command class, 1 byte.
struct confirm_component_control {
    component_control_response response_code{}; ///< granted, or why not
    friend constexpr bool operator==(const confirm_component_control&, const confirm_component_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x000F;
        using T = confirm_component_control;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::response_code, 2>,
                reserved<6>>>;
    };
};

/// Reject Component Control: notifies a component that it does not, or no longer, control the sender.
/// Code 0010h, command class, no body.
struct reject_component_control {
    friend constexpr bool operator==(const reject_component_control&, const reject_component_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0010;
        using type = layout<>;
    };
};

/// Set Time: sets the receiving component's clock.
/// Code 0011h, command class, 1 to 7 bytes.
struct set_time {
    std::optional<jaus::time_stamp> time_stamp{}; ///< time of day, day of the month
    std::optional<jaus::date_stamp> date_stamp{}; ///< day, month, year
    friend constexpr bool operator==(const set_time&, const set_time&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0011;
        using T = set_time;
        using type = layout<
            lenient_presence<u8,
                nested<&T::time_stamp>,
                nested<&T::date_stamp>>>;
    };
};

/// Query Component Authority: asks for Report Component Authority.
/// Code 2001h, query class, no body.
struct query_component_authority {
    friend constexpr bool operator==(const query_component_authority&, const query_component_authority&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2001;
        using report = struct report_component_authority;
        using type = layout<>;
    };
};

/// Query Component Status: asks for Report Component Status.
/// Code 2002h, query class, no body.
struct query_component_status {
    friend constexpr bool operator==(const query_component_status&, const query_component_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2002;
        using report = struct report_component_status;
        using type = layout<>;
    };
};

/// Query Component Control: asks for Report Component Control.
/// Code 200Dh, query class, no body.
struct query_component_control {
    friend constexpr bool operator==(const query_component_control&, const query_component_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x200D;
        using report = struct report_component_control;
        using type = layout<>;
    };
};

/// Query Time: asks for Report Time.
/// Code 2011h, query class, 1 byte.
struct query_time {
    std::uint8_t presence_vector{}; ///< the requested fields of Report Time
    friend constexpr bool operator==(const query_time&, const query_time&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2011;
        using report = struct report_time;
        using T = query_time;
        using type = layout<field<&T::presence_vector, u8>>;
    };
};

/// Report Component Authority: the authority that the component acts with.
/// Code 4001h, inform class, 1 byte.
struct report_component_authority {
    std::uint8_t authority_code{}; ///< 0 lowest to 255 highest
    friend constexpr bool operator==(const report_component_authority&, const report_component_authority&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4001;
        using query = query_component_authority;
        using T = report_component_authority;
        using type = layout<field<&T::authority_code, u8>>;
    };
};

/// Primary Status Code of Report Component Status. Other values are not assigned.
enum class primary_status_code : std::uint8_t {
    initialize = 0,
    ready = 1,
    standby = 2,
    shutdown = 3,
    failure = 4,
    emergency = 5,
};

/// Report Component Status: the state that the component is in.
/// Code 4002h, inform class, 5 bytes.
struct report_component_status {
    jaus::primary_status_code primary_status_code{}; ///< the component's state
    std::uint32_t secondary_status_code{};           ///< 32 bits of the component's own meaning
    friend constexpr bool operator==(const report_component_status&, const report_component_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4002;
        using query = query_component_status;
        using T = report_component_status;
        using type = layout<
            field<&T::primary_status_code, enumeration<jaus::primary_status_code, u8>>,
            field<&T::secondary_status_code, u32le>>;
    };
};

/// Report Component Control: the controller of the component; all zero if there is none.
/// Code 400Dh, inform class, 5 bytes. The address begins with the subsystem, unlike the header's.
struct report_component_control {
    std::uint8_t subsystem_id{};   ///< of the controlling component
    std::uint8_t node_id{};        ///< of the controlling component
    std::uint8_t component_id{};   ///< of the controlling component
    std::uint8_t instance_id{};    ///< of the controlling component
    std::uint8_t authority_code{}; ///< the controlling component's; 0 lowest to 255 highest
    friend constexpr bool operator==(const report_component_control&, const report_component_control&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x400D;
        using query = query_component_control;
        using T = report_component_control;
        using type = layout<
            field<&T::subsystem_id, u8>,
            field<&T::node_id, u8>,
            field<&T::component_id, u8>,
            field<&T::instance_id, u8>,
            field<&T::authority_code, u8>>;
    };
};

/// Report Time: the component's clock.
/// Code 4011h, inform class, 1 to 7 bytes.
struct report_time {
    std::optional<jaus::time_stamp> time_stamp{}; ///< time of day, day of the month
    std::optional<jaus::date_stamp> date_stamp{}; ///< day, month, year
    friend constexpr bool operator==(const report_time&, const report_time&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4011;
        using query = query_time;
        using T = report_time;
        using type = layout<
            lenient_presence<u8,
                nested<&T::time_stamp>,
                nested<&T::date_stamp>>>;
    };
};

/// The messages of the subgroup, by command code.
using core_subgroup = message_list<
    set_component_authority,
    shutdown,
    standby,
    resume,
    reset,
    set_emergency,
    clear_emergency,
    create_service_connection,
    confirm_service_connection,
    activate_service_connection,
    suspend_service_connection,
    terminate_service_connection,
    request_component_control,
    release_component_control,
    confirm_component_control,
    reject_component_control,
    set_time,
    query_component_authority,
    query_component_status,
    query_component_control,
    query_time,
    report_component_authority,
    report_component_status,
    report_component_control,
    report_time>;

} // namespace jauscat::jaus
