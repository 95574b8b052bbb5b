// SDO information: what objects a slave has, and what they are. ETG.1000.6, clause 5.6.3.
#pragma once

#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/wire/schema.hpp>

#include <cstddef>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// Service of an SDO information message.
enum class sdo_information_opcode : std::uint8_t {
    list_request = 1,
    list_response = 2,
    object_request = 3,
    object_response = 4,
    entry_request = 5,
    entry_response = 6,
    error = 7, ///< an abort code of 4 bytes follows
};

/// First 4 bytes of an SDO information message, after the CoE header.
struct sdo_information_header {
    sdo_information_opcode opcode{}; ///< request or answer of which kind
    bool incomplete{};               ///< more fragments follow
    std::uint16_t fragments_left{};  ///< how many

    struct schema : wire::items {
        using T = sdo_information_header;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::opcode, 7>,
                bit_field<&T::incomplete, 1>>,
            bit_fields<u8, reserved<8>>,
            field<&T::fragments_left, u16le>>;
    };
};

/// Follows the header if the slave refuses to answer, 4 bytes.
struct sdo_information_error {
    abort_code code{}; ///< why

    struct schema : wire::items {
        using T = sdo_information_error;
        using type = layout<field<&T::code, enumeration<abort_code, u32le>>>;
    };
};

/// Which objects a list names.
enum class object_list_type : std::uint16_t {
    lengths = 0, ///< how many objects the lists 1 to 5 name: five numbers of 2 bytes
    all = 1,
    rx_pdo = 2, ///< that can be mapped into outputs
    tx_pdo = 3, ///< that can be mapped into inputs
    backup = 4,
    settings = 5,
};

/// List request, and the first 2 bytes of its response; in the first fragment the indices follow, 2 bytes each.
struct object_list {
    object_list_type type{}; ///< which objects

    struct schema : wire::items {
        using T = object_list;
        using type = layout<field<&T::type, enumeration<object_list_type, u16le>>>;
    };
};

/// What an object is made of.
enum class object_code : std::uint8_t { variable = 7, array = 8, record = 9 };

/// Object description request, 2 bytes.
struct object_query {
    std::uint16_t index{}; ///< of the object

    struct schema : wire::items {
        using T = object_query;
        using type = layout<field<&T::index, u16le>>;
    };
};

/// Object description response, 6 bytes; the object's name follows.
struct object_answer {
    std::uint16_t index{};           ///< of the object
    std::uint16_t data_type{};       ///< of a variable's value, of an array's elements
    std::uint8_t highest_subindex{}; ///< of the object
    object_code code{};              ///< variable, array or record

    struct schema : wire::items {
        using T = object_answer;
        using type = layout<
            field<&T::index, u16le>,
            field<&T::data_type, u16le>,
            field<&T::highest_subindex, u8>,
            field<&T::code, enumeration<object_code, u8>>>;
    };
};

/// Entry description request, 4 bytes.
struct entry_query {
    std::uint16_t index{};     ///< of the object
    std::uint8_t subindex{};   ///< of the entry
    std::uint8_t value_info{}; ///< bits: 0 access, 1 category, 2 PDO mapping, 3 unit, 4 default, 5 minimum, 6 maximum

    struct schema : wire::items {
        using T = entry_query;
        using type = layout<
            field<&T::index, u16le>,
            field<&T::subindex, u8>,
            field<&T::value_info, u8>>;
    };
};

/// Permitted accesses to an entry, by state.
struct entry_access {
    bool read_pre_op{};   ///< may be read in PRE-OP
    bool read_safe_op{};  ///< may be read in SAFE-OP
    bool read_op{};       ///< may be read in OP
    bool write_pre_op{};  ///< may be written in PRE-OP
    bool write_safe_op{}; ///< may be written in SAFE-OP
    bool write_op{};      ///< may be written in OP
    bool rx_pdo{};        ///< can be mapped into outputs
    bool tx_pdo{};        ///< can be mapped into inputs
    bool backup{};        ///< is kept by the backup of a device that gets replaced
    bool setting{};       ///< is one of the device's settings

    struct schema : wire::items {
        using T = entry_access;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::read_pre_op, 1>,
                bit_field<&T::read_safe_op, 1>,
                bit_field<&T::read_op, 1>,
                bit_field<&T::write_pre_op, 1>,
                bit_field<&T::write_safe_op, 1>,
                bit_field<&T::write_op, 1>,
                bit_field<&T::rx_pdo, 1>,
                bit_field<&T::tx_pdo, 1>,
                bit_field<&T::backup, 1>,
                bit_field<&T::setting, 1>,
                reserved<6>>>;
    };
};

/// Entry description response, 10 bytes; the values that `value_info` names follow, and then the entry's name.
struct entry_answer {
    std::uint16_t index{};     ///< of the object
    std::uint8_t subindex{};   ///< of the entry
    std::uint8_t value_info{}; ///< which values are there
    std::uint16_t data_type{}; ///< of its value, as in ETG.1000.6
    std::uint16_t bits{};      ///< size of the entry
    entry_access access{};     ///< permitted accesses, by state

    struct schema : wire::items {
        using T = entry_answer;
        using type = layout<
            field<&T::index, u16le>,
            field<&T::subindex, u8>,
            field<&T::value_info, u8>,
            field<&T::data_type, u16le>,
            field<&T::bits, u16le>,
            nested<&T::access>>;
    };
};

} // namespace jauscat::ethercat
