// Errors and results of the master.
#pragma once

#include <jauscat/ethercat/code_texts.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace jauscat::ethercat {

/// Each comment says what `outcome::detail` holds, if anything.
enum class master_errc : std::uint8_t {
    ok,
    busy,              ///< another job runs: this one was not started
    not_sent,          ///< the link did not take a frame
    no_reply,          ///< frames do not come back
    timeout,           ///< the caller's deadline passed
    no_slave,          ///< no slave at that position; detail: number of slaves found
    wrong_station,     ///< no slave has that station address; detail: the address
    duplicate_station, ///< several slaves answer to one address; detail: how many
    working_counter,   ///< the slave did not execute a command; detail: the working counter
    sii_busy,          ///< the SII memory did not get ready
    sii_error,         ///< the SII memory did not execute a read; detail: word address
    sii_malformed,     ///< the categories of the SII do not end, or a length is not true; detail: word address
    wrong_identity,    ///< the slave is not the one that was expected; detail: its product code
    no_mailbox,        ///< the slave has no mailbox a master could use
    no_coe,            ///< the slave's mailbox carries no CoE
    al_error,          ///< the slave refused a state; detail: al_status_code
    state_timeout,     ///< the slave did not reach a state; detail: the state it is in
    too_many_slaves,   ///< the master has no room for another slave
    no_fmmu,           ///< the slave has fewer FMMUs than it has process data; detail: how many
    too_many_managers, ///< more than four SyncManagers carry process data
    image_full,        ///< the process image has no room for the slave's data; detail: their bytes
    watchdog_range,    ///< a watchdog time that the registers cannot express
    watchdog_not_kept, ///< the slave does not keep its watchdog's settings; detail: 0400h, and 0420h in the upper half
    not_configured,    ///< the slave's process data and watchdog are not set: OP is not asked for
    mailbox_full,      ///< the slave does not take its mail
    mailbox_timeout,   ///< the slave took the request and did not answer
    mailbox_error,     ///< the slave refused the message; detail: mailbox_error_code
    unexpected_reply,  ///< the answer was to something else; detail: its SDO command byte's specifier
    sdo_abort,         ///< the slave aborted the transfer; detail: abort_code, 0 where it gave none
    clear_refused,     ///< the slave refused a 0 in subindex 0, which was to come first; detail: abort_code
    toggle_bit,        ///< the answer to a segment is not the one that is due
    size_mismatch,     ///< more or less data than the slave announced, or not `upload_options::size`; detail: announced
    data_too_long,     ///< the data do not fit the buffer; detail: bytes that fit
    fragment_missing,  ///< a part of an answer in fragments did not come; detail: how many should have been left
    no_space,          ///< the frame buffer is smaller than 1514 bytes
};

/// The error in one line: what happened and what to do.
[[nodiscard]] constexpr std::string_view describe(master_errc error) noexcept {
    switch (error) {
    case master_errc::ok: return "ok";
    case master_errc::busy: return "the master is busy with another job: run that to its end, then start again";
    case master_errc::not_sent: return "the link did not take a frame: check that the interface is up";
    case master_errc::no_reply: return "frames do not come back: check cable, interface and that a slave is running";
    case master_errc::timeout: return "the deadline passed before the work was done: allow more time";
    case master_errc::no_slave: return "no slave at this position: check position, cabling and power";
    case master_errc::wrong_station: return "no slave has this station address: bring it up first";
    case master_errc::duplicate_station: return "several slaves answer to this station address: choose another one";
    case master_errc::working_counter: return "the slave did not execute a command: it was reset, bring it up again";
    case master_errc::sii_busy: return "the slave's SII memory stays busy: power-cycle the slave";
    case master_errc::sii_error: return "the slave's SII memory cannot be read: check its EEPROM";
    case master_errc::sii_malformed: return "the slave's SII describes no end: check its EEPROM";
    case master_errc::wrong_identity: return "the slave is not the one that was expected: check order and wiring";
    case master_errc::no_mailbox: return "the SII describes no usable mailbox: this slave cannot take SDOs";
    case master_errc::no_coe: return "the slave's mailbox does not carry CoE: this slave cannot take SDOs";
    case master_errc::al_error: return "the slave refused the state: see its AL status code";
    case master_errc::state_timeout: return "the slave did not reach the state in time: allow more time or reset it";
    case master_errc::too_many_slaves:
        return "the master has room for 16 slaves: leave one out or raise slave_capacity";
    case master_errc::no_fmmu: return "the slave has too few FMMUs for its process data: it cannot be mapped";
    case master_errc::too_many_managers: return "the slave spreads its process data over more than four SyncManagers";
    case master_errc::image_full: return "the process data do not fit one frame: map fewer PDOs";
    case master_errc::watchdog_range: return "the watchdog time is out of range: give 0.1 ms to 6553.5 ms";
    case master_errc::watchdog_not_kept: return "the slave does not keep its watchdog's settings: it must not go to OP";
    case master_errc::not_configured: return "the slave's watchdog is not set: configure the slave before OP";
    case master_errc::mailbox_full: return "the slave does not take its mail: it hangs or is not in PRE-OP";
    case master_errc::mailbox_timeout: return "the slave took the request and did not answer: allow more time";
    case master_errc::mailbox_error: return "the slave refused the mailbox message: see the mailbox error code";
    case master_errc::unexpected_reply: return "the slave answered something else: it does not follow the protocol";
    case master_errc::sdo_abort: return "the slave aborted the transfer: see the abort code";
    case master_errc::clear_refused: return "the slave refused a 0 in subindex 0: see the abort code, or do not ask it";
    case master_errc::toggle_bit: return "the answer to a segment is not the one that is due: transfer again";
    case master_errc::size_mismatch: return "the size announced and the data received differ: do not use the data";
    case master_errc::data_too_long: return "the object does not fit the buffer: give a larger one";
    case master_errc::fragment_missing: return "a part of the slave's answer is missing: ask again";
    case master_errc::no_space: return "the frame buffer is too small: give 1514 bytes";
    }
    return "unknown error";
}

/// Result of a job of the master.
struct [[nodiscard]] outcome {
    master_errc error{};
    std::uint32_t detail{}; ///< see master_errc; of a datagram without error, its working counter
    std::size_t size{};     ///< upload, list, description: bytes received; scan: slaves

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == master_errc::ok; }
    friend constexpr bool operator==(const outcome&, const outcome&) = default;
};

/// The reason given by the slave; empty if there is none.
[[nodiscard]] constexpr std::string_view describe_detail(const outcome& result) noexcept {
    switch (result.error) {
    case master_errc::al_error: return describe(static_cast<al_status_code>(result.detail));
    case master_errc::mailbox_error: return describe(static_cast<mailbox_error_code>(result.detail));
    case master_errc::clear_refused:
    case master_errc::sdo_abort:
        return result.detail == 0 ? "the slave gave no abort code" : describe(static_cast<abort_code>(result.detail));
    default: return {};
    }
}

} // namespace jauscat::ethercat
