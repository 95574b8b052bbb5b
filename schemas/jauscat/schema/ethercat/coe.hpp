// CANopen over EtherCAT: SDO transfers, aborts and emergencies. ETG.1000.6, clause 5.6.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// What a CoE message is.
enum class coe_service : std::uint8_t {
    emergency = 1,
    sdo_request = 2,
    sdo_response = 3,
    tx_pdo = 4,
    rx_pdo = 5,
    tx_pdo_remote_request = 6,
    rx_pdo_remote_request = 7,
    sdo_information = 8,
};

/// CoE header, 2 bytes, after the mailbox header.
struct coe_header {
    std::uint16_t number{}; ///< 0 but for PDO services
    coe_service service{};  ///< what follows

    struct schema : wire::items {
        using T = coe_header;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::number, 9>,
                reserved<3>,
                bit_field<&T::service, 4>>>;
    };
};

/// Command specifier. Requests and responses use the same values for different things.
enum class sdo_specifier : std::uint8_t {
    download_segment_request = 0,
    download_request = 1,
    upload_request = 2,
    upload_segment_request = 3,
    abort = 4,
    upload_segment_response = 0,
    download_segment_response = 1,
    upload_response = 2,
    download_response = 3,
};

/// First 4 bytes of an initiate request, of its response, and of an abort.
struct sdo_header {
    bool size_indicated{};     ///< expedited: `unused` counts; normal: the size is there
    bool expedited{};          ///< the data are the 4 bytes that follow
    std::uint8_t unused{};     ///< expedited: how many of the 4 bytes are not data
    bool complete_access{};    ///< all entries of the object at once
    sdo_specifier specifier{}; ///< what it asks for or answers
    std::uint16_t index{};     ///< of the object
    std::uint8_t subindex{};   ///< of the entry

    struct schema : wire::items {
        using T = sdo_header;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::size_indicated, 1>,
                bit_field<&T::expedited, 1>,
                bit_field<&T::unused, 2>,
                bit_field<&T::complete_access, 1>,
                bit_field<&T::specifier, 3>>,
            field<&T::index, u16le>,
            field<&T::subindex, u8>>;
    };
};

/// Initiate download request or upload response with 1 to 4 bytes of data, 8 bytes.
struct sdo_expedited {
    sdo_header header{};             ///< with `expedited`
    std::array<std::byte, 4> data{}; ///< up to 4 bytes, from the first on

    struct schema : wire::items {
        using T = sdo_expedited;
        using type = layout<
            nested<&T::header>,
            field<&T::data, octets<4>>>;
    };
};

/// Initiate download request or upload response of any size, 8 bytes and the data behind them.
/// With size 0 and no data: upload request, download response.
struct sdo_normal {
    sdo_header header{};  ///< without `expedited`
    std::uint32_t size{}; ///< bytes of the whole transfer; if more than fit, segments follow

    struct schema : wire::items {
        using T = sdo_normal;
        using type = layout<
            nested<&T::header>,
            field<&T::size, u32le>>;
    };
};

/// First byte of a download segment request, of an upload segment response, and of their answers.
struct sdo_segment_header {
    bool last{};               ///< no segment follows
    std::uint8_t unused{};     ///< how many of the first 7 data bytes are not data
    bool toggle{};             ///< false in the first segment, then alternating
    sdo_specifier specifier{}; ///< what it asks for or answers

    struct schema : wire::items {
        using T = sdo_segment_header;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::last, 1>,
                bit_field<&T::unused, 3>,
                bit_field<&T::toggle, 1>,
                bit_field<&T::specifier, 3>>>;
    };
};

/// Why an SDO transfer was aborted. Other values occur: they pass through.
enum class abort_code : std::uint32_t {
    none = 0,
    toggle_bit = 0x05030000,
    timeout = 0x05040000,
    command_specifier = 0x05040001,
    block_size = 0x05040002,
    sequence_number = 0x05040003,
    crc = 0x05040004,
    out_of_memory = 0x05040005,
    unsupported_access = 0x06010000,
    write_only = 0x06010001,
    read_only = 0x06010002,
    subindex_0_not_zero = 0x06010003,
    complete_access = 0x06010004,
    exceeds_mailbox = 0x06010005,
    mapped_to_rx_pdo = 0x06010006,
    no_object = 0x06020000,
    not_mappable = 0x06040041,
    pdo_length = 0x06040042,
    parameter_incompatible = 0x06040043,
    device_incompatible = 0x06040047,
    hardware = 0x06060000,
    length_mismatch = 0x06070010,
    length_too_high = 0x06070012,
    length_too_low = 0x06070013,
    no_subindex = 0x06090011,
    value_range = 0x06090030,
    value_too_high = 0x06090031,
    value_too_low = 0x06090032,
    module_list = 0x06090033,
    max_below_min = 0x06090036,
    resource = 0x060A0023,
    general = 0x08000000,
    cannot_store = 0x08000020,
    local_control = 0x08000021,
    device_state = 0x08000022,
    no_dictionary = 0x08000023,
    no_data = 0x08000024,
};

/// Abort of a transfer by either side, 8 bytes. A slave sends it with service sdo_request.
struct sdo_abort {
    sdo_header header{}; ///< names the object
    abort_code code{};

    struct schema : wire::items {
        using T = sdo_abort;
        using type = layout<
            nested<&T::header>,
            field<&T::code, enumeration<abort_code, u32le>>>;
    };
};

/// Emergency, sent by a slave unasked, 8 bytes.
struct coe_emergency {
    std::uint16_t error_code{};      ///< what happened, in CANopen's numbers; 0: all is well again
    std::uint8_t error_register{};   ///< object 1001h
    std::array<std::byte, 5> data{}; ///< the vendor's own

    struct schema : wire::items {
        using T = coe_emergency;
        using type = layout<
            field<&T::error_code, u16le>,
            field<&T::error_register, u8>,
            field<&T::data, octets<5>>>;
    };
};

} // namespace jauscat::ethercat
