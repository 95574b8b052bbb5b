// Errors of the operations of a bus, as error codes.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/cia402/axis_errc.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/coe.hpp>

#include <boost/system/error_code.hpp>

#include <cstdint>
#include <string_view>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// Why an operation of a bus failed. The message of the error names the slave and the object. Other errors of such
/// operations:
/// - an ethercat::abort_code: the slave has aborted the transfer of an object;
/// - an ethercat::al_status_code: the slave has refused a state;
/// - boost::asio::error::operation_aborted: it was cancelled, or the bus has ended.
enum class bus_errc : std::uint8_t {
    ok,
    not_started,     ///< the slaves are not known: async_start has not succeeded
    no_reply,        ///< no frame returns: cable, interface, power
    not_sent,        ///< the interface takes no frames
    no_slaves,       ///< frames return, but no slave has taken part
    in_use,          ///< a slave is in OP, which another master may control
    no_such_slave,   ///< no slave is as required
    ambiguous,       ///< several slaves are as required
    too_many_slaves, ///< the bus has more than 256
    wrong_slave,     ///< another slave than before, or than required, is at the position
    missing_slave,   ///< the named slave is not on the bus
    doubled_slave,   ///< several slaves are as the options say of the named one
    swapped_slave,   ///< the named slave is at another place, or another named one is at its place
    foreign_slave,   ///< another device is in the place of the named slave
    slave_lost,      ///< the slave does not answer to its address: it was reset, or a cable behind another slave is out
    no_objects,      ///< the slave has no CoE mailbox
    not_taken,       ///< the slave does not read its mailbox
    no_answer,       ///< the slave has taken the request and does not answer: it may have executed it
    refused,         ///< the slave refused the mailbox message, the transfer or the state, without a known reason
    malformed_answer,  ///< the slave does not follow the protocol
    wrong_size,        ///< the object is not as large as the type that was to be read
    too_large,         ///< the object is larger than 65,536 bytes
    left_state,        ///< the slave has left its state, without a reason: another master, or the slave itself
    state_not_reached, ///< the slave has not reached the state in time
    not_configurable,  ///< the slave's process data or its SII cannot be used
    not_synchronized,  ///< the slave's clock cannot be set up, or does not follow the reference clock
    needs_cycles,      ///< OP needs the cyclic exchange, which async_operate and bridges have
    served,            ///< a bridge serves the slave, or it is in operation
    timed_out,         ///< not done within the time that it may take
    stopped,           ///< it has kept a slave from stopping, and was cancelled: repeat it
};

/// The error in one line.
[[nodiscard]] constexpr std::string_view describe(bus_errc error) noexcept {
    switch (error) {
    case bus_errc::ok: return "ok";
    case bus_errc::not_started: return "the slaves are not known: start the bus";
    case bus_errc::no_reply: return "no frame returns: check cable, interface and that a slave is running";
    case bus_errc::not_sent: return "the link takes no frames: check that the interface is up";
    case bus_errc::no_slaves: return "no slave takes part: check cable and power";
    case bus_errc::in_use:
        return "a slave is in OP: another master seems to control it; stop that one, or start with takes_over";
    case bus_errc::no_such_slave: return "no slave is as required: check position, alias, name and identity";
    case bus_errc::ambiguous: return "several slaves are as required: name one by its position or its alias";
    case bus_errc::too_many_slaves: return "a bus has at most 256 slaves";
    case bus_errc::wrong_slave: return "another slave than the required one is at the position: check order and wiring";
    case bus_errc::missing_slave: return "the slave is missing: check cabling, power and its alias";
    case bus_errc::doubled_slave:
        return "several slaves have its alias, identification or identity: change it in all but one";
    case bus_errc::swapped_slave: return "the slave is at another place: exchange the cables, or correct the position";
    case bus_errc::foreign_slave:
        return "another device is in the place of the slave: check vendor, product, revision, serial";
    case bus_errc::slave_lost: return "the slave does not answer to its address: check its power and its cables";
    case bus_errc::no_objects: return "the slave has no CoE mailbox, and so no objects";
    case bus_errc::not_taken: return "the slave does not read its mailbox: check that it is in PRE-OP or higher";
    case bus_errc::no_answer: return "the slave has taken the request and does not answer";
    case bus_errc::refused: return "refused by the slave";
    case bus_errc::malformed_answer: return "the slave does not follow the protocol";
    case bus_errc::wrong_size: return "the object has another size than the type that was to be read";
    case bus_errc::too_large: return "the object has more than 65536 bytes";
    case bus_errc::left_state: return "the slave has left its state: check for another master";
    case bus_errc::state_not_reached: return "the slave has not reached the state in time";
    case bus_errc::not_configurable: return "the slave's process data or its SII cannot be used";
    case bus_errc::not_synchronized:
        return "the slave's distributed clock cannot be used: check that it has one, and the cables' order";
    case bus_errc::needs_cycles: return "OP needs the cyclic exchange: use async_operate";
    case bus_errc::served: return "the slave is in operation, or a bridge serves it and controls its states";
    case bus_errc::timed_out: return "not done in time";
    case bus_errc::stopped: return "cancelled in favour of a stop order: repeat it";
    }
    return "unknown error";
}

/// The categories of these errors, of abort codes, and of AL status codes.
[[nodiscard]] JAUSCAT_DECL const boost::system::error_category& bus_category() noexcept;
[[nodiscard]] JAUSCAT_DECL const boost::system::error_category& abort_category() noexcept;
[[nodiscard]] JAUSCAT_DECL const boost::system::error_category& al_status_category() noexcept;
/// Of cia402::axis_errc.
[[nodiscard]] JAUSCAT_DECL const boost::system::error_category& axis_category() noexcept;

[[nodiscard]] inline boost::system::error_code make_error_code(bus_errc error) noexcept {
    return {static_cast<int>(error), bus_category()};
}

} // namespace JAUSCAT_WAY

namespace ethercat {

[[nodiscard]] inline boost::system::error_code make_error_code(abort_code code) noexcept {
    return {static_cast<int>(code), abort_category()};
}
[[nodiscard]] inline boost::system::error_code make_error_code(al_status_code code) noexcept {
    return {static_cast<int>(code), al_status_category()};
}

} // namespace ethercat

namespace cia402 {

[[nodiscard]] inline boost::system::error_code make_error_code(axis_errc code) noexcept {
    return {static_cast<int>(code), axis_category()};
}

} // namespace cia402
} // namespace jauscat

namespace boost::system {
template <> struct is_error_code_enum<jauscat::bus_errc> : std::true_type {};
template <> struct is_error_code_enum<jauscat::ethercat::abort_code> : std::true_type {};
template <> struct is_error_code_enum<jauscat::ethercat::al_status_code> : std::true_type {};
template <> struct is_error_code_enum<jauscat::cia402::axis_errc> : std::true_type {};
} // namespace boost::system

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/bus_error.ipp>
#endif
