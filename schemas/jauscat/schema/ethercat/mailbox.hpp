// The mailbox header and its error reply. ETG.1000.4, clause 5.6.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <cstddef>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

inline constexpr std::size_t min_mailbox_size = 24;   ///< bytes: sufficient for any SDO response
inline constexpr std::size_t max_mailbox_size = 1486; ///< bytes: what one datagram carries

/// The protocol that a mailbox message carries.
enum class mailbox_type : std::uint8_t { error = 0, aoe = 1, eoe = 2, coe = 3, foe = 4, soe = 5, voe = 15 };

/// Mailbox header, 6 bytes.
struct mailbox_header {
    std::uint16_t length{};  ///< bytes that follow this header
    std::uint16_t address{}; ///< station address of a routed message's other end; 0 from a master
    std::uint8_t channel{};  ///< 0
    std::uint8_t priority{}; ///< 0 (lowest) to 3
    mailbox_type type{};     ///< protocol of what follows
    std::uint8_t counter{};  ///< 1 to 7, another one for each new message; 0: not used

    struct schema : wire::items {
        using T = mailbox_header;
        using type = layout<
            field<&T::length, u16le>,
            field<&T::address, u16le>,
            bit_fields<u8,
                bit_field<&T::channel, 6>,
                bit_field<&T::priority, 2>>,
            bit_fields<u8,
                bit_field<&T::type, 4>,
                bit_field<&T::counter, 3>,
                reserved<1>>>;
    };
};

/// Why a slave refused a mailbox message.
enum class mailbox_error_code : std::uint16_t {
    none = 0,
    syntax = 1,
    unsupported_protocol = 2,
    invalid_channel = 3,
    service_not_supported = 4,
    invalid_header = 5,
    size_too_short = 6,
    no_more_memory = 7,
    invalid_size = 8,
    service_in_work = 9,
};

/// Body of a message of type error, 4 bytes.
struct mailbox_error_reply {
    std::uint16_t type{}; ///< 1
    mailbox_error_code code{};

    struct schema : wire::items {
        using T = mailbox_error_reply;
        using type = layout<
            field<&T::type, u16le>,
            field<&T::code, enumeration<mailbox_error_code, u16le>>>;
    };
};

} // namespace jauscat::ethercat
