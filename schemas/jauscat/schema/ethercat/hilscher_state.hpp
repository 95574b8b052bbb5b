// Packets of the Hilscher EtherCAT master's API (V2/V3) about the bus as a whole: its state, what a scan finds, the
// slaves' handles and their emergencies. Little endian, no padding.
//
// The manual gives these confirmations no form for errors: with one in ulSta they end with the header, ulLen 0.
#pragma once
#include <jauscat/schema/ethercat/hilscher.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::hilscher {

/// A state of the bus; the numbers are those of AL status.
enum class bus_state : std::uint16_t { unknown = 0, init = 1, pre_op = 2, boot = 3, safe_op = 4, op = 8 };

/// Set EtherCAT state request: 42 bytes. ulCmd 0x00650048, ulLen 2.
struct set_state_request {
    packet_header head{.ul_len = 2, .ul_cmd = packet_command::set_state_req};
    bus_state us_new_ec_state{}; ///< INIT, PRE-OP, SAFE-OP or OP
    friend constexpr bool operator==(const set_state_request&, const set_state_request&) = default;

    struct schema : wire::items {
        using T = set_state_request;
        using type = layout<
            nested<&T::head>,
            field<&T::us_new_ec_state, enumeration<bus_state, u16le>>>;
    };
};

/// Answer to it: 40 bytes. ulCmd 0x00650049, ulLen 0; the result is ulSta.
struct set_state_confirmation {
    packet_header head{.ul_cmd = packet_command::set_state_cnf};
    friend constexpr bool operator==(const set_state_confirmation&, const set_state_confirmation&) = default;

    struct schema : wire::items {
        using T = set_state_confirmation;
        using type = layout<nested<&T::head>>;
    };
};

/// Get EtherCAT state request: 40 bytes. ulCmd 0x00650046, ulLen 0.
struct get_state_request {
    packet_header head{.ul_cmd = packet_command::get_state_req};
    friend constexpr bool operator==(const get_state_request&, const get_state_request&) = default;

    struct schema : wire::items {
        using T = get_state_request;
        using type = layout<nested<&T::head>>;
    };
};

/// Answer to it: 42 bytes. ulCmd 0x00650047, ulLen 2.
struct get_state_confirmation {
    packet_header head{.ul_len = 2, .ul_cmd = packet_command::get_state_cnf};
    bus_state us_current_ec_state{}; ///< `unknown` before there is a bus
    friend constexpr bool operator==(const get_state_confirmation&, const get_state_confirmation&) = default;

    struct schema : wire::items {
        using T = get_state_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::us_current_ec_state, enumeration<bus_state, u16le>>>;
    };
};

/// Start bus scan request: 44 bytes. ulCmd 0x00650020, ulLen 4; a manual prints 0.
struct start_bus_scan_request {
    packet_header head{.ul_len = 4, .ul_cmd = packet_command::start_bus_scan_req};
    std::uint32_t ul_timeout{}; ///< milliseconds
    friend constexpr bool operator==(const start_bus_scan_request&, const start_bus_scan_request&) = default;

    struct schema : wire::items {
        using T = start_bus_scan_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_timeout, u32le>>;
    };
};

/// Answer to it: 44 bytes. ulCmd 0x00650021, ulLen 4.
struct start_bus_scan_confirmation {
    packet_header head{.ul_len = 4, .ul_cmd = packet_command::start_bus_scan_cnf};
    std::uint32_t ul_found_slaves{}; ///< slaves in the ring
    friend constexpr bool operator==(const start_bus_scan_confirmation&, const start_bus_scan_confirmation&) = default;

    struct schema : wire::items {
        using T = start_bus_scan_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_found_slaves, u32le>>;
    };
};

/// Get bus scan info request: 42 bytes. ulCmd 0x00650022, ulLen 2.
struct get_bus_scan_info_request {
    packet_header head{.ul_len = 2, .ul_cmd = packet_command::get_bus_scan_info_req};
    std::uint16_t us_auto_inc_addr{}; ///< 0 the first slave, 0xFFFF the second, 0xFFFE the third
    friend constexpr bool operator==(const get_bus_scan_info_request&, const get_bus_scan_info_request&) = default;

    struct schema : wire::items {
        using T = get_bus_scan_info_request;
        using type = layout<
            nested<&T::head>,
            field<&T::us_auto_inc_addr, u16le>>;
    };
};

/// Answer to it: 60 bytes. ulCmd 0x00650023, ulLen 20. The fields' names are the project's own.
struct get_bus_scan_info_confirmation {
    packet_header head{.ul_len = 20, .ul_cmd = packet_command::get_bus_scan_info_cnf};
    std::uint32_t ul_vendor_id{};       ///< of the slave's identity, object 1018h:1
    std::uint32_t ul_product_code{};    ///< object 1018h:2
    std::uint32_t ul_revision_number{}; ///< object 1018h:3
    std::uint32_t ul_serial_number{};   ///< object 1018h:4
    std::uint32_t ul_port_state{};      ///< DL status of the slave
    friend constexpr bool operator==(const get_bus_scan_info_confirmation&,
                                     const get_bus_scan_info_confirmation&) = default;

    struct schema : wire::items {
        using T = get_bus_scan_info_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_vendor_id, u32le>,
            field<&T::ul_product_code, u32le>,
            field<&T::ul_revision_number, u32le>,
            field<&T::ul_serial_number, u32le>,
            field<&T::ul_port_state, u32le>>;
    };
};

/// Which slaves a list of handles names.
enum class handle_list : std::uint32_t { configured = 1, active = 2, faulted = 3 };

/// Get slave handles request: 44 bytes. ulCmd 0x2F08, ulLen 4.
struct get_slave_handles_request {
    packet_header head{.ul_len = 4, .ul_cmd = packet_command::get_slave_handles_req};
    handle_list ul_param{}; ///< which slaves
    friend constexpr bool operator==(const get_slave_handles_request&, const get_slave_handles_request&) = default;

    struct schema : wire::items {
        using T = get_slave_handles_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_param, enumeration<handle_list, u32le>>>;
    };
};

/// Answer to it without the handles: 44 bytes, then the handles, 4 bytes each. ulCmd 0x2F09, ulLen 4 + 4n.
struct get_slave_handles_confirmation {
    packet_header head{.ul_cmd = packet_command::get_slave_handles_cnf};
    handle_list ul_param{}; ///< as in the request
    friend constexpr bool operator==(const get_slave_handles_confirmation&,
                                     const get_slave_handles_confirmation&) = default;

    struct schema : wire::items {
        using T = get_slave_handles_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_param, enumeration<handle_list, u32le>>>;
    };
};

/// A handle in the list of get_slave_handles_confirmation, 4 bytes.
struct slave_handle {
    std::uint32_t ul_handle{}; ///< the slave's station address in this library's answers
    friend constexpr bool operator==(const slave_handle&, const slave_handle&) = default;

    struct schema : wire::items {
        using T = slave_handle;
        using type = layout<field<&T::ul_handle, u32le>>;
    };
};

/// Read emergencies request: 48 bytes. ulCmd 0x0065001C, ulLen 8.
struct read_emergencies_request {
    packet_header head{.ul_len = 8, .ul_cmd = packet_command::read_emergencies_req};
    std::uint32_t ul_slave_handle{};    ///< from get_slave_handles, not the station address
    std::uint32_t f_delete_emergency{}; ///< not 0: forget them afterwards
    friend constexpr bool operator==(const read_emergencies_request&, const read_emergencies_request&) = default;

    struct schema : wire::items {
        using T = read_emergencies_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_slave_handle, u32le>,
            field<&T::f_delete_emergency, u32le>>;
    };
};

/// Answer to it without the emergencies: 52 bytes, then atEmergenyBuffer with five ethercat::coe_emergency of 8 bytes,
/// zeros where there are fewer. ulCmd 0x0065001D, ulLen 52; a manual prints 108.
struct read_emergencies_confirmation {
    packet_header head{.ul_len = 52, .ul_cmd = packet_command::read_emergencies_cnf};
    std::uint32_t ul_slave_handle{};    ///< as in the request
    std::uint32_t f_delete_emergency{}; ///< as in the request
    std::uint32_t f_overflow_occured{}; ///< 1: some were dropped
    friend constexpr bool operator==(const read_emergencies_confirmation&,
                                     const read_emergencies_confirmation&) = default;

    struct schema : wire::items {
        using T = read_emergencies_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_slave_handle, u32le>,
            field<&T::f_delete_emergency, u32le>,
            field<&T::f_overflow_occured, u32le>>;
    };
};
/// Records in atEmergenyBuffer.
inline constexpr std::size_t emergency_buffer_records = 5;

} // namespace jauscat::hilscher
