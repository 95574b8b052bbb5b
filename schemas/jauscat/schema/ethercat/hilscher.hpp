// Packets of the Hilscher EtherCAT master's API (netX, cifX cards; V2/V3): the common packet header and the SDO
// services; hilscher_info.hpp and hilscher_state.hpp have the other services. netX Dual-Port Memory Interface manual;
// EtherCAT Master V3/V4 Protocol API manual. Little endian, no padding.
#pragma once
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::hilscher {

/// ulCmd: the service of a packet. An answer is its request plus 1.
enum class packet_command : std::uint32_t {
    get_slave_handles_req = 0x2F08,
    get_slave_handles_cnf = 0x2F09,
    od_create_object_req = 0x6A80,
    od_create_object_cnf = 0x6A81,
    od_create_subobject_req = 0x6A82,
    od_create_subobject_cnf = 0x6A83,
    sdo_upload_req = 0x00650006,
    sdo_upload_cnf = 0x00650007,
    sdo_download_req = 0x00650008,
    sdo_download_cnf = 0x00650009,
    get_od_list_req = 0x0065000A,
    get_od_list_cnf = 0x0065000B,
    get_object_description_req = 0x00650018,
    get_object_description_cnf = 0x00650019,
    get_entry_description_req = 0x0065001A,
    get_entry_description_cnf = 0x0065001B,
    read_emergencies_req = 0x0065001C,
    read_emergencies_cnf = 0x0065001D,
    start_bus_scan_req = 0x00650020,
    start_bus_scan_cnf = 0x00650021,
    get_bus_scan_info_req = 0x00650022,
    get_bus_scan_info_cnf = 0x00650023,
    get_state_req = 0x00650046,
    get_state_cnf = 0x00650047,
    set_state_req = 0x00650048,
    set_state_cnf = 0x00650049,
};

/// ulSta of a confirmation: the result. EtherCAT Master Protocol API, status codes; other values are possible.
enum class packet_status : std::uint32_t {
    ok = 0,
    fail = 0xC0000001,
    out_of_memory = 0xC0000003,
    unknown_command = 0xC0000004,
    unknown_destination = 0xC0000005,
    unknown_destination_id = 0xC0000006,
    invalid_packet_length = 0xC0000007,
    invalid_extension = 0xC0000008,
    invalid_parameter = 0xC0000009,
    unknown_handle = 0xC000000E,
    command_invalid = 0xC0650001,
    no_link = 0xC0650002,
    critical_error_state = 0xC065000A,
    wrong_internal_state = 0xC065000D,
    coe_invalid_slave_id = 0xC065000F,
    coe_no_resource = 0xC0650010,
    coe_internal_error = 0xC0650011,
    coe_invalid_index = 0xC0650012,
    coe_invalid_communication_state = 0xC0650013,
    coe_frame_lost = 0xC0650014,
    coe_timeout = 0xC0650015,
    coe_slave_not_addressable = 0xC0650016,
    coe_invalid_list_type = 0xC0650017,
    coe_slave_response_too_big = 0xC0650018,
    coe_invalid_access_bit_mask = 0xC0650019,
    coe_working_counter_error = 0xC065001A,
    service_in_use = 0xC065001B,
    invalid_communication_state = 0xC065001C,
    coe_invalid_access = 0xC0650022,
    coe_no_mailbox_support = 0xC0650023,
    coe_no_coe_support = 0xC0650024,
    sdo_abort_toggle = 0xC0650027,
    sdo_abort_timeout = 0xC0650028,
    sdo_abort_command_specifier = 0xC0650029,
    sdo_abort_block_size = 0xC065002A,
    sdo_abort_sequence_number = 0xC065002B,
    sdo_abort_crc = 0xC065002C,
    sdo_abort_memory = 0xC065002D,
    sdo_abort_access = 0xC065002E,
    sdo_abort_write_only = 0xC065002F,
    sdo_abort_read_only = 0xC0650030,
    sdo_abort_no_object = 0xC0650031,
    sdo_abort_pdo_mapping = 0xC0650032,
    sdo_abort_pdo_length = 0xC0650033,
    sdo_abort_parameter_incompatible = 0xC0650034,
    sdo_abort_internal_incompatible = 0xC0650035,
    sdo_abort_hardware = 0xC0650036,
    sdo_abort_data_size = 0xC0650037,
    sdo_abort_data_too_long = 0xC0650038,
    sdo_abort_data_too_short = 0xC0650039,
    sdo_abort_no_subindex = 0xC065003A,
    sdo_abort_value_range = 0xC065003B,
    sdo_abort_value_too_high = 0xC065003C,
    sdo_abort_value_too_low = 0xC065003D,
    sdo_abort_max_below_min = 0xC065003E,
    sdo_abort_general = 0xC065003F,
    sdo_abort_transfer = 0xC0650040,
    sdo_abort_local_control = 0xC0650041,
    sdo_abort_device_state = 0xC0650042,
    sdo_abort_no_dictionary = 0xC0650043,
    sdo_abort_unknown = 0xC0650044, ///< any abort code that this list lacks
    state_change_busy = 0xC0650075,
    invalid_target_phase = 0xC0650076, ///< no such state
};

/// The header of every packet, 40 bytes. An answer keeps all of it but ulSta, ulCmd and ulLen.
struct packet_header {
    std::uint32_t ul_dest{};    ///< receiver: 0x20 for the channel in use
    std::uint32_t ul_src{};     ///< sender, returned untouched
    std::uint32_t ul_dest_id{}; ///< secondary receiver reference
    std::uint32_t ul_src_id{};  ///< secondary sender reference, returned untouched
    std::uint32_t ul_len{};     ///< bytes of body, 0 to 1556 (before 2011-09: 1560)
    std::uint32_t ul_id{};      ///< packet number of the sender's choice, returned untouched
    packet_status ul_sta{};     ///< result, in an answer; 0 in a request
    packet_command ul_cmd{};    ///< requested information
    std::uint32_t ul_ext{};     ///< place in a sequence: 0x80 first, 0xC0 middle, 0x40 last, 0x200 will be retried
    std::uint32_t ul_rout{};    ///< 0; firmware internal
    friend constexpr bool operator==(const packet_header&, const packet_header&) = default;

    struct schema : wire::items {
        using T = packet_header;
        using type = layout<
            field<&T::ul_dest, u32le>,
            field<&T::ul_src, u32le>,
            field<&T::ul_dest_id, u32le>,
            field<&T::ul_src_id, u32le>,
            field<&T::ul_len, u32le>,
            field<&T::ul_id, u32le>,
            field<&T::ul_sta, enumeration<packet_status, u32le>>,
            field<&T::ul_cmd, enumeration<packet_command, u32le>>,
            field<&T::ul_ext, u32le>,
            field<&T::ul_rout, u32le>>;
    };
};

/// ETHERCAT_MASTER_PACKET_SDO_DOWNLOAD_REQ_T without its data: 56 bytes, then abSdoData with ulDataCnt bytes.
/// ulCmd 0x00650008, ulLen 16 + n.
struct sdo_download_request {
    packet_header head{.ul_cmd = packet_command::sdo_download_req};
    std::uint32_t ul_node_id{};   ///< fixed station address of the slave
    std::uint32_t ul_index{};     ///< object index, 0 to 0xFFFF
    std::uint32_t ul_sub_index{}; ///< subindex, 0 to 255
    std::uint32_t ul_data_cnt{};  ///< n, bytes of abSdoData
    friend constexpr bool operator==(const sdo_download_request&, const sdo_download_request&) = default;

    struct schema : wire::items {
        using T = sdo_download_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>,
            field<&T::ul_sub_index, u32le>,
            field<&T::ul_data_cnt, u32le>>;
    };
};

/// Answer to a download: 40 bytes. ulCmd 0x00650009, ulLen 0; the result is ulSta.
struct sdo_download_confirmation {
    packet_header head{.ul_cmd = packet_command::sdo_download_cnf};
    friend constexpr bool operator==(const sdo_download_confirmation&, const sdo_download_confirmation&) = default;

    struct schema : wire::items {
        using T = sdo_download_confirmation;
        using type = layout<nested<&T::head>>;
    };
};

/// Request to read an object: 52 bytes. ulCmd 0x00650006, ulLen 12.
struct sdo_upload_request {
    packet_header head{.ul_len = 12, .ul_cmd = packet_command::sdo_upload_req};
    std::uint32_t ul_node_id{};   ///< fixed station address of the slave
    std::uint32_t ul_index{};     ///< object index, 0 to 0xFFFF
    std::uint32_t ul_sub_index{}; ///< subindex, 0 to 255
    friend constexpr bool operator==(const sdo_upload_request&, const sdo_upload_request&) = default;

    struct schema : wire::items {
        using T = sdo_upload_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>,
            field<&T::ul_sub_index, u32le>>;
    };
};

/// Answer to an upload without its data: 56 bytes, then abSdoData. ulCmd 0x00650007, ulLen 16 + n. An answer with an
/// error in ulSta has ulLen 12 and ends after ulSubIndex.
struct sdo_upload_confirmation {
    packet_header head{.ul_cmd = packet_command::sdo_upload_cnf};
    std::uint32_t ul_node_id{};   ///< as in the request
    std::uint32_t ul_index{};     ///< as in the request
    std::uint32_t ul_sub_index{}; ///< as in the request
    std::uint32_t ul_data_cnt{};  ///< n, bytes of abSdoData
    friend constexpr bool operator==(const sdo_upload_confirmation&, const sdo_upload_confirmation&) = default;

    struct schema : wire::items {
        using T = sdo_upload_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>,
            field<&T::ul_sub_index, u32le>,
            field<&T::ul_data_cnt, u32le>>;
    };
};

/// Most bytes of body.
inline constexpr std::size_t max_packet_body = 1556;
/// Most bytes of abSdoData: the body's 1556 less 16.
inline constexpr std::size_t max_sdo_data = max_packet_body - 16;
/// The same for cards from before 2011-09: the body's 1560 less 16.
inline constexpr std::size_t max_sdo_data_before_2011_09 = 1544;

} // namespace jauscat::hilscher
