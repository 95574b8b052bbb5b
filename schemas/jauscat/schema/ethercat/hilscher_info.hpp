// Packets of the Hilscher EtherCAT master's API (V2/V3) that ask for what a slave's dictionary holds: lists of objects,
// descriptions of objects and of entries. Little endian, no padding.
//
// A confirmation with an error in ulSta ends with the fields that repeat the request's: its ulLen is then 8, or 12
// after an entry description request.
#pragma once
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::hilscher {

/// ulListType: which objects a list names.
enum class packet_list_type : std::uint32_t {
    all = 1,
    rx_pdo = 2, ///< can be mapped into outputs
    tx_pdo = 3, ///< can be mapped into inputs
    backup = 4,
    start_up = 5,
};

/// Get OD list request: 48 bytes. ulCmd 0x0065000A, ulLen 8.
struct get_od_list_request {
    packet_header head{.ul_len = 8, .ul_cmd = packet_command::get_od_list_req};
    std::uint32_t ul_node_id{};      ///< fixed station address of the slave
    packet_list_type ul_list_type{}; ///< which objects
    friend constexpr bool operator==(const get_od_list_request&, const get_od_list_request&) = default;

    struct schema : wire::items {
        using T = get_od_list_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_list_type, enumeration<packet_list_type, u32le>>>;
    };
};

/// Answer to it without its indices: 52 bytes, then ausObjectList with ulDataCnt indices of 2 bytes. ulCmd 0x0065000B,
/// ulLen 12 + 2n.
struct get_od_list_confirmation {
    packet_header head{.ul_cmd = packet_command::get_od_list_cnf};
    std::uint32_t ul_node_id{};      ///< as in the request
    packet_list_type ul_list_type{}; ///< as in the request
    std::uint32_t ul_data_cnt{};     ///< n, indices in ausObjectList, 0 to 772
    friend constexpr bool operator==(const get_od_list_confirmation&, const get_od_list_confirmation&) = default;

    struct schema : wire::items {
        using T = get_od_list_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_list_type, enumeration<packet_list_type, u32le>>,
            field<&T::ul_data_cnt, u32le>>;
    };
};

/// Get object description request: 48 bytes. ulCmd 0x00650018, ulLen 8; a manual prints 16.
struct get_object_description_request {
    packet_header head{.ul_len = 8, .ul_cmd = packet_command::get_object_description_req};
    std::uint32_t ul_node_id{}; ///< fixed station address of the slave
    std::uint32_t ul_index{};   ///< object index, 0 to 0xFFFF
    friend constexpr bool operator==(const get_object_description_request&,
                                     const get_object_description_request&) = default;

    struct schema : wire::items {
        using T = get_object_description_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>>;
    };
};

/// Answer to it without the name: 68 bytes, then abObjName with ulObNameLen bytes and no zero behind. ulCmd 0x00650019,
/// ulLen 28 + n.
struct get_object_description_confirmation {
    packet_header head{.ul_cmd = packet_command::get_object_description_cnf};
    std::uint32_t ul_node_id{};           ///< as in the request
    std::uint32_t ul_index{};             ///< as in the request
    std::uint32_t ul_data_type{};         ///< CoE data type, 0 to 0x0FFF
    std::uint32_t ul_obj_code{};          ///< ethercat::object_code
    std::uint32_t ul_obj_category{};      ///< the four bits above the object code in the slave's answer
    std::uint32_t ul_max_num_sub_index{}; ///< highest subindex, 0 to 255
    std::uint32_t ul_ob_name_len{};       ///< n, bytes of abObjName, 0 to 1528
    friend constexpr bool operator==(const get_object_description_confirmation&,
                                     const get_object_description_confirmation&) = default;

    struct schema : wire::items {
        using T = get_object_description_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>,
            field<&T::ul_data_type, u32le>,
            field<&T::ul_obj_code, u32le>,
            field<&T::ul_obj_category, u32le>,
            field<&T::ul_max_num_sub_index, u32le>,
            field<&T::ul_ob_name_len, u32le>>;
    };
};

/// Get entry description request: 56 bytes. ulCmd 0x0065001A, ulLen 16.
struct get_entry_description_request {
    packet_header head{.ul_len = 16, .ul_cmd = packet_command::get_entry_description_req};
    std::uint32_t ul_node_id{};         ///< fixed station address of the slave
    std::uint32_t ul_index{};           ///< object index, 0 to 0xFFFF
    std::uint32_t ul_sub_index{};       ///< subindex, 0 to 255
    std::uint32_t ul_access_bit_mask{}; ///< bits of ethercat::entry_query::value_info, 0 to 0x7F
    friend constexpr bool operator==(const get_entry_description_request&,
                                     const get_entry_description_request&) = default;

    struct schema : wire::items {
        using T = get_entry_description_request;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>,
            field<&T::ul_sub_index, u32le>,
            field<&T::ul_access_bit_mask, u32le>>;
    };
};

/// Answer to it without the values: 84 bytes, then abObjData with ulDataLen bytes: default value, minimum and maximum
/// as far as ulValueInfo has them, and the entry's name. ulCmd 0x0065001B, ulLen 44 + n.
struct get_entry_description_confirmation {
    packet_header head{.ul_cmd = packet_command::get_entry_description_cnf};
    std::uint32_t ul_node_id{};            ///< as in the request
    std::uint32_t ul_index{};              ///< as in the request
    std::uint32_t ul_sub_index{};          ///< as in the request
    std::uint32_t ul_value_info{};         ///< bits of the mask: what is there
    std::uint32_t ul_data_type{};          ///< CoE data type
    std::uint32_t ul_bit_len{};            ///< size of the entry in bits
    ethercat::entry_access ul_ob_access{}; ///< the slave's 16 bits; the 16 above them are 0
    std::uint32_t f_rx_pdo_mapping{};      ///< 1: can be mapped into outputs
    std::uint32_t f_tx_pdo_mapping{};      ///< 1: can be mapped into inputs
    std::uint32_t ul_unit_type{};          ///< unit; 0 where ulValueInfo has none
    std::uint32_t ul_data_len{};           ///< n, bytes of abObjData, 0 to 1512

    struct schema : wire::items {
        using T = get_entry_description_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::ul_node_id, u32le>,
            field<&T::ul_index, u32le>,
            field<&T::ul_sub_index, u32le>,
            field<&T::ul_value_info, u32le>,
            field<&T::ul_data_type, u32le>,
            field<&T::ul_bit_len, u32le>,
            nested<&T::ul_ob_access>,
            bit_fields<u16le, reserved<16>>,
            field<&T::f_rx_pdo_mapping, u32le>,
            field<&T::f_tx_pdo_mapping, u32le>,
            field<&T::ul_unit_type, u32le>,
            field<&T::ul_data_len, u32le>>;
    };
};

/// The unit in a slave's entry description, in front of the values; 4 bytes.
struct entry_unit {
    std::uint32_t ul_unit_type{}; ///< as reported by the slave

    struct schema : wire::items {
        using T = entry_unit;
        using type = layout<field<&T::ul_unit_type, u32le>>;
    };
};

} // namespace jauscat::hilscher
