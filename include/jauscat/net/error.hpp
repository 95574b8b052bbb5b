// Errors of network operations: a code to branch on, the reason of the layer below, and a line for the operator.
#pragma once

#include <jauscat/base/result.hpp>

#include <cerrno>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

namespace jauscat::net {

enum class errc : std::uint8_t {
    ok,
    not_running,     ///< the node is not started, or stopped
    not_encodable,   ///< a value of the body does not encode; `reason` is a wire::errc
    invalid_message, ///< header and body are no message; `reason` is a jaus::errc, or a wire::errc without a header
    queue_full,      ///< too many bytes wait to be sent
    unroutable,      ///< no route to the destination; in a node `reason` is a jaus::routed
    empty_message,   ///< nothing to send
    too_large,       ///< larger than a datagram
    back_pressure,   ///< the network takes less than is sent; `reason` is the system's
    not_sent,        ///< the network refuses the datagram; `reason` is the system's
    privileges_kept, ///< privileges cannot be dropped; `reason` is the system's, if it gives one
    invalid_address, ///< opening: no IP address, or no multicast group
    address_in_use,  ///< opening: another socket has the port; `reason` is the system's
    unknown_address, ///< opening: this machine does not have the address; `reason` is the system's
    not_permitted,   ///< opening: a privilege is missing; `reason` is the system's
    no_interface,    ///< opening: this machine does not have the interface; `reason` is the system's, if it gives one
    interface_down,  ///< opening: the interface is down
    not_ethernet,    ///< opening: the interface is of another kind
    unreachable,     ///< opening: no route to the host or group, or no such host; `reason` is the system's
    not_opened,      ///< opening: the system refuses for another reason; `reason` is the system's
};

/// The error in one line. `error::message` says more.
[[nodiscard]] constexpr std::string_view describe(errc code) noexcept {
    switch (code) {
    case errc::ok: return "ok";
    case errc::not_running: return "the node is not running";
    case errc::not_encodable: return "a value of the body does not encode";
    case errc::invalid_message: return "header and body are no message";
    case errc::queue_full: return "too many bytes wait to be sent";
    case errc::unroutable: return "no route to the destination";
    case errc::empty_message: return "an empty message is not sent";
    case errc::too_large: return "the message does not fit a datagram";
    case errc::back_pressure: return "the network takes less than is sent";
    case errc::not_sent: return "the network refuses the datagram";
    case errc::privileges_kept: return "privileges cannot be dropped";
    case errc::invalid_address: return "not an IP address, or not a multicast group";
    case errc::address_in_use: return "another socket has the port";
    case errc::unknown_address: return "this machine does not have the address";
    case errc::not_permitted: return "a privilege is missing";
    case errc::no_interface: return "this machine does not have the interface";
    case errc::interface_down: return "the interface is down";
    case errc::not_ethernet: return "the interface is not an Ethernet interface";
    case errc::unreachable: return "no route to the host or group, or no such host";
    case errc::not_opened: return "the system refuses the socket";
    }
    return "unknown error";
}

namespace detail {
template <class Enumeration> class enumeration_category final : public std::error_category {
  public:
    [[nodiscard]] const char* name() const noexcept override { return "jauscat"; }
    [[nodiscard]] std::string message(int code) const override {
        return std::string{describe(static_cast<Enumeration>(code))};
    }
};
} // namespace detail

/// An error of a layer below, such as a wire::errc, with the type that it has there: error codes of different
/// enumerations are never equal. `describe(code)` is its message.
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] std::error_code reason_of(Enumeration code) noexcept {
    static const detail::enumeration_category<Enumeration> category;
    return {static_cast<int>(code), category};
}

/// Why a network operation or the opening of a socket failed.
struct error {
    errc code{};
    std::error_code reason{}; ///< of the layer below: of the system, or by `reason_of`; none for most codes
    std::string message{};    ///< what happened and, where it helps, what to do: a line for the operator

    friend bool operator==(const error&, const error&) = default;
};

/// A message does not encode; `why` is a wire::errc.
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] error not_encodable(Enumeration why) {
    return {.code = errc::not_encodable, .reason = reason_of(why), .message = std::string{describe(why)}};
}

/// The line for the operator.
[[nodiscard]] inline std::string_view describe(const error& why) noexcept { return why.message; }

/// The last error of the system, as the reason of an error.
[[nodiscard]] inline std::error_code last_system_error() noexcept { return {errno, std::generic_category()}; }

} // namespace jauscat::net
