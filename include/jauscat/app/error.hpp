// Errors of asynchronous operations, as error codes.
#pragma once
#include <jauscat/base/compilation.hpp>

#include <boost/system/error_code.hpp>

#include <cstdint>
#include <string_view>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// Why an operation of a component failed. One that was cancelled, or whose component or node has ended, has
/// boost::asio::error::operation_aborted.
enum class node_errc : std::uint8_t {
    ok,
    not_running,        ///< the node is not started, or stopped
    not_encodable,      ///< a value of the message is outside the limits of its field
    not_a_query,        ///< no report answers the command code
    not_one_address,    ///< an octet of the destination is 0 or 255: no single component would answer
    unroutable,         ///< the configuration has no system for the destination
    queue_full,         ///< too many messages wait to be sent or acknowledged: send it again later
    refused,            ///< NAK: the receiver has not executed it
    no_answer,          ///< no answer to any attempt: a command may have been executed
    malformed_answer,   ///< the answer does not decode
    control_refused,    ///< another component of at least this authority has control
    control_lost,       ///< control was taken over, has expired or is released
    already_asked,      ///< control of this component is held or requested already
    connection_refused, ///< the provider refuses the service connection, or the event
    silent,             ///< no report for three periods; the connection is requested again
    rate_out_of_range,  ///< a connection's rate is not above 0 and up to 1092 hertz
};

/// The error in one line.
[[nodiscard]] constexpr std::string_view describe(node_errc error) noexcept {
    switch (error) {
    case node_errc::ok: return "ok";
    case node_errc::not_running: return "the node is not running";
    case node_errc::not_encodable: return "a value of the message is outside the limits of its field";
    case node_errc::not_a_query: return "no report answers this command code";
    case node_errc::not_one_address: return "the destination names no single component";
    case node_errc::unroutable: return "the configuration has no system for the destination";
    case node_errc::queue_full: return "too many messages wait to be sent or acknowledged";
    case node_errc::refused: return "refused by the receiver (NAK)";
    case node_errc::no_answer: return "no answer in time";
    case node_errc::malformed_answer: return "the answer does not decode";
    case node_errc::control_refused: return "control is refused: another component has it";
    case node_errc::control_lost: return "control is lost";
    case node_errc::already_asked: return "control is held or requested already";
    case node_errc::connection_refused: return "the provider refuses the connection";
    case node_errc::silent: return "the provider is silent";
    case node_errc::rate_out_of_range: return "the rate is not above 0 and up to 1092 hertz";
    }
    return "unknown error";
}

/// The category of these errors.
[[nodiscard]] JAUSCAT_DECL const boost::system::error_category& node_category() noexcept;
[[nodiscard]] inline boost::system::error_code make_error_code(node_errc error) noexcept {
    return {static_cast<int>(error), node_category()};
}

} // namespace JAUSCAT_WAY
} // namespace jauscat

namespace boost::system {
template <> struct is_error_code_enum<jauscat::node_errc> : std::true_type {};
} // namespace boost::system

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/error.ipp>
#endif
