// Packets that create the objects of a Hilscher EtherCAT slave: Object Dictionary V3 (ODV3), the services of the slave
// stack V4. Little endian, no padding.
//
// The slave stack V2/V3 of 2011 has ECAT_OD_CREATE_OBJECT_REQ_T and ECAT_OD_CREATE_SUBOBJECT_REQ_T for this. Their
// layout and command codes are not publicly documented, so they are not here: these are their documented successors.
#pragma once
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/wire/schema.hpp>

#include <optional>
#include <string_view>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::hilscher {

/// bObjectCode.
enum class od_object_code : std::uint8_t {
    domain = 2,
    deftype = 5,
    defstruct = 6,
    variable = 7,
    array = 8,
    record = 9
};

/// usDatatype: those of these objects. ETG.1020.
enum class od_data_type : std::uint16_t { none = 0, unsigned8 = 0x0005, octet_string = 0x000A };

/// usAccessFlags of an object, bit numbers.
enum class od_object_flag : std::uint16_t {
    write_0_first = 9,      ///< subindex 0 must be 0 while another subindex is written
    create_subindex_0 = 10, ///< the stack makes subindex 0
    force_indexed = 11,
    rx_pdo_mappable = 12,
    tx_pdo_mappable = 13,
    backup = 14,
    settings = 15,
};

/// usAccessRights of a subobject: which of the slave's states allow what, bit numbers.
enum class od_access : std::uint16_t {
    read_pre_op = 0,
    read_safe_op = 1,
    read_operational = 2,
    write_pre_op = 3,
    write_safe_op = 4,
    write_operational = 5,
    mappable_in_rx_pdo = 6,
    mappable_in_tx_pdo = 7,
    backup = 8,
    settings = 9,
    read_init = 14,
    write_init = 15,
};

/// bIndicationFlags: accesses reported to the application, bit numbers.
enum class od_indication : std::uint8_t {
    on_read = 0,
    on_write = 1,
    on_undefined_subobject = 2,      ///< an object's only
    on_undefined_subobject_info = 3, ///< an object's only
};

/// Create object request: 60 bytes, then abData with ulTotalDataBytes bytes. ulCmd 0x6A80, ulLen 20 + n, n at most
/// 1024.
struct od_create_object_request {
    packet_header head{.ul_cmd = packet_command::od_create_object_req};
    std::uint16_t us_index{};                          ///< object index
    std::uint8_t b_max_num_of_sub_objs{};              ///< highest subindex
    od_object_code b_object_code{};                    ///< what kind of object
    wire::bit_set<od_object_flag> us_access_flags{};   ///< how the object may be accessed
    bool has_name{};                                   ///< bValueInfo 0x01
    bool has_initial{};                                ///< bValueInfo 0x02
    bool is_virtual{};                                 ///< bValueInfo 0x04: the application keeps the value
    bool has_unit{};                                   ///< bValueInfo 0x08
    bool has_default{};                                ///< bValueInfo 0x10
    bool has_minimum{};                                ///< bValueInfo 0x20
    bool has_maximum{};                                ///< bValueInfo 0x40
    bool variable_size{};                              ///< bValueInfo 0x80: a value may be shorter than ulMaxFieldUnits
    wire::bit_set<od_indication> b_indication_flags{}; ///< which accesses the application hears of
    od_data_type us_datatype{};                        ///< of a simple variable; else none
    wire::bit_set<od_access> us_access_rights{};       ///< simple variables only
    std::uint32_t ul_max_field_units{};                ///< elements, bytes of a string; simple variables only
    std::uint32_t ul_total_data_bytes{};               ///< n, bytes of abData over all fragments
    std::optional<std::uint32_t> unit{};               ///< of the value, as in ETG.1004
    std::optional<std::string_view> name{};            ///< for people
    std::optional<wire::blob> minimum{};               ///< of the value, as it travels
    std::optional<wire::blob> maximum{};               ///< of the value, as it travels
    std::optional<wire::blob> initial{};               ///< the value at the start, as it travels
    std::optional<wire::blob> default_{};              ///< the value by default, as it travels

    struct schema : wire::items {
        using T = od_create_object_request;
        using type = layout<
            nested<&T::head>,
            field<&T::us_index, u16le>,
            field<&T::b_max_num_of_sub_objs, u8>,
            field<&T::b_object_code, enumeration<od_object_code, u8>>,
            field<&T::us_access_flags, bit_set_codec<od_object_flag, u16le>>,
            bit_fields<u8,
                bit_field<&T::has_name, 1>,
                bit_field<&T::has_initial, 1>,
                bit_field<&T::is_virtual, 1>,
                bit_field<&T::has_unit, 1>,
                bit_field<&T::has_default, 1>,
                bit_field<&T::has_minimum, 1>,
                bit_field<&T::has_maximum, 1>,
                bit_field<&T::variable_size, 1>>,
            field<&T::b_indication_flags, bit_set_codec<od_indication, u8>>,
            field<&T::us_datatype, enumeration<od_data_type, u16le>>,
            field<&T::us_access_rights, bit_set_codec<od_access, u16le>>,
            field<&T::ul_max_field_units, u32le>,
            field<&T::ul_total_data_bytes, u32le>,
            gated_by<&T::has_unit, field<&T::unit, u32le>>,
            gated_by<&T::has_name, string<&T::name, count<"name_length", u32le>>>,
            gated_by<&T::has_minimum, bytes<&T::minimum, count<"minimum_length", u32le>>>,
            gated_by<&T::has_maximum, bytes<&T::maximum, count<"maximum_length", u32le>>>,
            gated_by<&T::has_initial, bytes<&T::initial, count<"initial_length", u32le>>>,
            gated_by<&T::has_default, bytes<&T::default_, count<"default_length", u32le>>>>;
    };
};

/// Answer to it: 42 bytes. ulCmd 0x6A81, ulLen 2; the result is ulSta.
struct od_create_object_confirmation {
    packet_header head{.ul_len = 2, .ul_cmd = packet_command::od_create_object_cnf};
    std::uint16_t us_index{}; ///< as in the request

    struct schema : wire::items {
        using T = od_create_object_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::us_index, u16le>>;
    };
};

/// Create subobject request: 57 bytes, then abData with ulTotalDataBytes bytes. ulCmd 0x6A82, ulLen 17 + n.
struct od_create_subobject_request {
    packet_header head{.ul_cmd = packet_command::od_create_subobject_req};
    std::uint16_t us_index{};                          ///< object index
    std::uint8_t b_sub_index{};                        ///< subindex
    bool has_name{};                                   ///< bValueInfo, as of an object
    bool has_initial{};                                ///< 0x02
    bool is_virtual{};                                 ///< 0x04
    bool has_unit{};                                   ///< 0x08
    bool has_default{};                                ///< 0x10
    bool has_minimum{};                                ///< 0x20
    bool has_maximum{};                                ///< 0x40
    bool variable_size{};                              ///< 0x80
    wire::bit_set<od_indication> b_indication_flags{}; ///< which accesses the application hears of
    wire::bit_set<od_access> us_access_rights{};       ///< permitted accesses, by state
    od_data_type us_datatype{};                        ///< of its value
    std::uint32_t ul_max_field_units{};                ///< elements, bytes of a string
    std::uint32_t ul_total_data_bytes{};               ///< n, bytes of abData over all fragments
    std::optional<std::uint32_t> unit{};               ///< of the value, as in ETG.1004
    std::optional<std::string_view> name{};            ///< for people
    std::optional<wire::blob> minimum{};               ///< of the value, as it travels
    std::optional<wire::blob> maximum{};               ///< of the value, as it travels
    std::optional<wire::blob> initial{};               ///< the value at the start, as it travels
    std::optional<wire::blob> default_{};              ///< the value by default, as it travels

    struct schema : wire::items {
        using T = od_create_subobject_request;
        using type = layout<
            nested<&T::head>,
            field<&T::us_index, u16le>,
            field<&T::b_sub_index, u8>,
            bit_fields<u8,
                bit_field<&T::has_name, 1>,
                bit_field<&T::has_initial, 1>,
                bit_field<&T::is_virtual, 1>,
                bit_field<&T::has_unit, 1>,
                bit_field<&T::has_default, 1>,
                bit_field<&T::has_minimum, 1>,
                bit_field<&T::has_maximum, 1>,
                bit_field<&T::variable_size, 1>>,
            field<&T::b_indication_flags, bit_set_codec<od_indication, u8>>,
            field<&T::us_access_rights, bit_set_codec<od_access, u16le>>,
            field<&T::us_datatype, enumeration<od_data_type, u16le>>,
            field<&T::ul_max_field_units, u32le>,
            field<&T::ul_total_data_bytes, u32le>,
            gated_by<&T::has_unit, field<&T::unit, u32le>>,
            gated_by<&T::has_name, string<&T::name, count<"name_length", u32le>>>,
            gated_by<&T::has_minimum, bytes<&T::minimum, count<"minimum_length", u32le>>>,
            gated_by<&T::has_maximum, bytes<&T::maximum, count<"maximum_length", u32le>>>,
            gated_by<&T::has_initial, bytes<&T::initial, count<"initial_length", u32le>>>,
            gated_by<&T::has_default, bytes<&T::default_, count<"default_length", u32le>>>>;
    };
};

/// Answer to it: 43 bytes. ulCmd 0x6A83, ulLen 3; the result is ulSta.
struct od_create_subobject_confirmation {
    packet_header head{.ul_len = 3, .ul_cmd = packet_command::od_create_subobject_cnf};
    std::uint16_t us_index{};   ///< as in the request
    std::uint8_t b_sub_index{}; ///< as in the request

    struct schema : wire::items {
        using T = od_create_subobject_confirmation;
        using type = layout<
            nested<&T::head>,
            field<&T::us_index, u16le>,
            field<&T::b_sub_index, u8>>;
    };
};

/// Most bytes of abData in one packet.
inline constexpr std::size_t max_od_data = 1024;

/// ulSta of these confirmations; other values are possible.
enum class od_status : std::uint32_t {
    ok = 0,
    application_not_registered = 0xC09B8003,
    object_exists = 0xC09B8013,
    subobject_exists = 0xC09B8014,
    not_owner = 0xC09B8015,
    too_many_subobjects = 0xC09B8016,
    creation_incomplete = 0xC09B801C,
    wrong_total_data_bytes = 0xC09B801D, ///< ulTotalDataBytes and ulLen disagree
};

} // namespace jauscat::hilscher
