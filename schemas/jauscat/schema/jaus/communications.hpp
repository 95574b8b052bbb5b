// Communications subgroup of RA 3.3 part 3: data links, heartbeat.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// State of a data link. Other values are not assigned.
enum class data_link_state : std::uint8_t {
    off = 0,
    on = 1,
    standby = 2,
    loss_of_command = 3, ///< not known to every peer
};

/// Set Data Link State: switches the receiving component's data link.
/// Code 0200h, command class, 1 byte. Some peers call it Set Data Link Status.
struct set_data_link_state {
    data_link_state state{}; ///< the wanted state
    friend constexpr bool operator==(const set_data_link_state&, const set_data_link_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0200;
        using T = set_data_link_state;
        using type = layout<field<&T::state, enumeration<data_link_state, u8>>>;
    };
};

/// Set Data Link Select: selects the data link to be used.
/// Code 0201h, command class, 1 byte.
struct set_data_link_select {
    std::uint8_t data_link_id{}; ///< which data link
    friend constexpr bool operator==(const set_data_link_select&, const set_data_link_select&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0201;
        using T = set_data_link_select;
        using type = layout<field<&T::data_link_id, u8>>;
    };
};

/// Set Selected Data Link State: switches one of several data links.
/// Code 0202h, command class, 2 bytes.
struct set_selected_data_link_state {
    std::uint8_t data_link_id{}; ///< which data link
    data_link_state state{};     ///< the wanted state
    friend constexpr bool operator==(const set_selected_data_link_state&,
                                     const set_selected_data_link_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0202;
        using T = set_selected_data_link_state;
        using type = layout<
            field<&T::data_link_id, u8>,
            field<&T::state, enumeration<data_link_state, u8>>>;
    };
};

/// Query Data Link Status: asks for Report Data Link Status.
/// Code 2200h, query class, 1 byte.
struct query_data_link_status {
    std::uint8_t data_link_id{}; ///< which data link
    friend constexpr bool operator==(const query_data_link_status&, const query_data_link_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2200;
        using report = struct report_data_link_status;
        using T = query_data_link_status;
        using type = layout<field<&T::data_link_id, u8>>;
    };
};

/// Query Selected Data Link Status: asks for Report Selected Data Link Status.
/// Code 2201h, query class, no body.
struct query_selected_data_link_status {
    friend constexpr bool operator==(const query_selected_data_link_status&,
                                     const query_selected_data_link_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2201;
        using report = struct report_selected_data_link_status;
        using type = layout<>;
    };
};

/// Query Heartbeat Pulse: asks for Report Heartbeat Pulse.
/// Code 2202h, query class, no body.
struct query_heartbeat_pulse {
    friend constexpr bool operator==(const query_heartbeat_pulse&, const query_heartbeat_pulse&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2202;
        using report = struct report_heartbeat_pulse;
        using type = layout<>;
    };
};

/// Report Data Link Status: the state of a data link.
/// Code 4200h, inform class, 2 bytes.
struct report_data_link_status {
    std::uint8_t data_link_id{}; ///< which data link
    data_link_state state{};     ///< the state it is in
    friend constexpr bool operator==(const report_data_link_status&, const report_data_link_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4200;
        using query = query_data_link_status;
        using T = report_data_link_status;
        using type = layout<
            field<&T::data_link_id, u8>,
            field<&T::state, enumeration<data_link_state, u8>>>;
    };
};

/// Report Selected Data Link Status: which data link is in use.
/// Code 4201h, inform class, 1 byte.
struct report_selected_data_link_status {
    std::uint8_t data_link_id{}; ///< the selected data link
    friend constexpr bool operator==(const report_selected_data_link_status&,
                                     const report_selected_data_link_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4201;
        using query = query_selected_data_link_status;
        using T = report_selected_data_link_status;
        using type = layout<field<&T::data_link_id, u8>>;
    };
};

/// Report Heartbeat Pulse: the sender is alive; sent once a second.
/// Code 4202h, inform class, no body.
struct report_heartbeat_pulse {
    friend constexpr bool operator==(const report_heartbeat_pulse&, const report_heartbeat_pulse&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4202;
        using query = query_heartbeat_pulse;
        using type = layout<>;
    };
};

/// The messages of the subgroup, by command code.
using communications_subgroup = message_list<
    set_data_link_state,
    set_data_link_select,
    set_selected_data_link_state,
    query_data_link_status,
    query_selected_data_link_status,
    query_heartbeat_pulse,
    report_data_link_status,
    report_selected_data_link_status,
    report_heartbeat_pulse>;

} // namespace jauscat::jaus
