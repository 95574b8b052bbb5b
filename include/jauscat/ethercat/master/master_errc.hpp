// Errors and results of the master.
#pragma once

#include <jauscat/base/result.hpp>
#include <jauscat/ethercat/code_texts.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace jauscat::ethercat {

/// Each comment names the members of master_error that hold more, if any. `configure` and init commands also name the
/// object of a transfer that has failed.
enum class master_errc : std::uint8_t {
    ok,
    busy,              ///< another job runs: this one was not started
    not_sent,          ///< the link did not take a frame
    no_reply,          ///< frames do not come back
    timeout,           ///< the caller's deadline passed
    no_slave,          ///< no slave at that position; slaves
    wrong_station,     ///< no slave has that station address; station
    duplicate_station, ///< several slaves answer to one address; working_counter
    working_counter,   ///< the slave did not execute a command; working_counter
    sii_busy,          ///< the SII memory did not get ready
    sii_error,         ///< the SII memory did not execute a read; sii_word
    sii_malformed,     ///< the categories of the SII do not end, or a length is not true; sii_word
    wrong_identity,    ///< the slave is not the one that was expected; product
    no_mailbox,        ///< the slave has no mailbox a master could use
    no_coe,            ///< the slave's mailbox carries no CoE
    al_error,          ///< the slave refused a state; al_status
    state_timeout,     ///< the slave did not reach a state; state
    too_many_slaves,   ///< more slaves than the master has memory for
    no_fmmu,           ///< the slave has fewer FMMUs than it has process data; fmmus
    too_many_managers, ///< more than 14 SyncManagers carry process data
    wrong_mapping,     ///< an object is not where the program has it; index, bits, first_bit, found_bits, found_at
    no_direction,      ///< nothing says whether a SyncManager's process data are outputs or inputs; sync_manager
    too_many_entries,  ///< more PDOs and entries than `max_process_objects`
    image_full,        ///< the slave's process data are larger than one frame carries; bytes
    watchdog_range,    ///< a watchdog time that the registers cannot express
    watchdog_not_kept, ///< the slave does not keep its watchdog's settings; watchdog_divider, watchdog_units
    object_not_kept,   ///< a start-up object of a process part reads back differently; command
    not_configured,    ///< the slave's process data and watchdog are not set: OP is not requested
    mailbox_full,      ///< the slave does not read its mailbox
    mailbox_timeout,   ///< the slave took the request and did not answer
    mailbox_error,     ///< the slave refused the message; mailbox
    unexpected_reply,  ///< the answer was to something else; specifier
    sdo_abort,         ///< the slave aborted the transfer; abort, none where it gave no code
    clear_refused,     ///< the slave refused a 0 in subindex 0, which was to come first; abort
    toggle_bit,        ///< the answer to a segment is not the one that is due
    size_mismatch,    ///< more or less data than the slave announced, or not `upload_options::size`; bytes, found_bytes
    data_too_long,    ///< the data do not fit the buffer; bytes, found_bytes
    fragment_missing, ///< a part of an answer in fragments did not come; fragments
    too_many_fragments, ///< more fragments than the buffer can need; fragments
    no_clock,           ///< no slave has a distributed clock
    clock_topology,  ///< the open ports and the order of the slaves make no tree with a clock at each branch; station
    clock_delay,     ///< the delay to the slave cannot be true; station, nanoseconds
    clock_unsettled, ///< the slave's clock does not follow the reference clock; station, nanoseconds
    sync_late,       ///< the signals were switched on only after the time at which they were to start
    no_space,        ///< the frame buffer is smaller than 1514 bytes
};

/// The error in one line: what happened and what to do.
[[nodiscard]] constexpr std::string_view describe(master_errc error) noexcept {
    switch (error) {
    case master_errc::ok: return "ok";
    case master_errc::busy: return "the master is busy with another job: run that to its end, then start again";
    case master_errc::not_sent: return "the link did not take a frame: check that the interface is up";
    case master_errc::no_reply: return "frames do not return: check cable, interface and that a slave is running";
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
    case master_errc::too_many_slaves: return "the master has no memory for another slave: give it more records";
    case master_errc::no_fmmu: return "the slave has too few FMMUs for its process data: it cannot be mapped";
    case master_errc::too_many_managers: return "the slave spreads its process data over more than 14 SyncManagers";
    case master_errc::wrong_mapping:
        return "the slave's process data do not have it where the program does: change the mapping or the program";
    case master_errc::no_direction:
        return "nothing says whether a SyncManager's process data are outputs or inputs: check the slave's SII";
    case master_errc::too_many_entries:
        return "the slave's process data have more than 4096 PDOs and entries: map fewer, or check the slave";
    case master_errc::image_full: return "the slave's process data do not fit one frame: map fewer PDOs";
    case master_errc::watchdog_range: return "the watchdog time is out of range: give 0.1 ms to 6553.5 ms";
    case master_errc::object_not_kept: return "the slave does not keep a start-up object: see its range in the slave";
    case master_errc::watchdog_not_kept: return "the slave does not keep its watchdog's settings: it must not go to OP";
    case master_errc::not_configured: return "the slave's watchdog is not set: configure the slave before OP";
    case master_errc::mailbox_full:
        return "mailbox full: the slave is not reading it; check that it is in PRE-OP or higher";
    case master_errc::mailbox_timeout: return "the slave took the request and did not answer: allow more time";
    case master_errc::mailbox_error: return "the slave refused the mailbox message: see the mailbox error code";
    case master_errc::unexpected_reply: return "the slave answered something else: it does not follow the protocol";
    case master_errc::sdo_abort: return "the slave aborted the transfer: see the abort code";
    case master_errc::clear_refused: return "the slave refused a 0 in subindex 0: see the abort code, or do not ask it";
    case master_errc::toggle_bit: return "the answer to a segment is not the one that is due: transfer again";
    case master_errc::size_mismatch: return "the size announced and the data received differ: do not use the data";
    case master_errc::data_too_long: return "the object does not fit the buffer: give a larger one";
    case master_errc::fragment_missing: return "a part of the slave's answer is missing: ask again";
    case master_errc::too_many_fragments:
        return "the slave announces more fragments than its answer can have: it does not follow the protocol";
    case master_errc::no_clock: return "no slave has a distributed clock: run without one";
    case master_errc::clock_topology:
        return "the slave's place in the tree is not known: check IN and OUT, and that slaves with branches have "
               "clocks";
    case master_errc::clock_delay: return "the delay to the slave is not plausible: check IN and OUT of its cables";
    case master_errc::clock_unsettled: return "the slave's clock stays off the reference: allow more frames";
    case master_errc::sync_late: return "the start time passed before SYNC was on: allow more lead";
    case master_errc::no_space: return "the frame buffer is too small: give 1514 bytes";
    }
    return "unknown error";
}

/// An error of the master, and what it is about. Only the members that master_errc names for the code have a value, and
/// `command` where an init command or start-up object has failed.
struct master_error {
    master_errc code{};
    al_state state{};                 ///< the state that the slave is in
    sdo_specifier specifier{};        ///< of the answer
    mailbox_error_code mailbox{};     ///< the slave's reason
    al_status_code al_status{};       ///< the slave's reason
    std::uint16_t station{};          ///< station address that no slave has, or of the slave with the clock
    std::uint16_t working_counter{};  ///< of the command: how many slaves have executed it
    std::uint16_t slaves{};           ///< slaves in the ring
    std::uint16_t command{};          ///< index of the init command
    std::uint16_t index{};            ///< the object; 0: the error is about none
    std::uint8_t subindex{};          ///< of it
    std::uint8_t bits{};              ///< of the object, as the program has it
    std::uint8_t found_bits{};        ///< in the process data; 0: they do not have it
    std::uint16_t first_bit{};        ///< in the outputs or inputs, as the program has it
    std::uint16_t found_at{};         ///< first bit there
    std::uint16_t fmmus{};            ///< FMMUs that the process data need
    std::uint8_t sync_manager{};      ///< number of the SyncManager
    std::uint16_t watchdog_divider{}; ///< that the slave has
    std::uint16_t watchdog_units{};   ///< that the slave has
    abort_code abort{};               ///< the slave's reason
    std::uint32_t product{};          ///< product code of the slave
    std::uint32_t sii_word{};         ///< word address in the SII
    std::uint32_t bytes{}; ///< image_full: of the process data; size_mismatch: expected; data_too_long: of the buffer
    std::uint32_t found_bytes{}; ///< of the object, or as many of it as have come
    std::uint32_t nanoseconds{}; ///< clock_delay: of the cable; clock_unsettled: from the reference clock
    std::uint32_t fragments{};   ///< that should have been left; too_many_fragments: that are left

    friend constexpr bool operator==(const master_error&, const master_error&) = default;
};

/// The error in one line: what happened and what to do.
[[nodiscard]] constexpr std::string_view describe(const master_error& error) noexcept { return describe(error.code); }

/// The reason given by the slave; empty if there is none.
[[nodiscard]] constexpr std::string_view describe_reason(const master_error& error) noexcept {
    switch (error.code) {
    case master_errc::al_error: return describe(error.al_status);
    case master_errc::mailbox_error: return describe(error.mailbox);
    case master_errc::clear_refused:
    case master_errc::sdo_abort:
        return error.abort == abort_code::none ? "the slave gave no abort code" : describe(error.abort);
    default: return {};
    }
}
/// The code of the reason given by the slave; 0 if there is none.
[[nodiscard]] constexpr std::uint32_t reason_code(const master_error& error) noexcept {
    switch (error.code) {
    case master_errc::al_error: return static_cast<std::uint32_t>(error.al_status);
    case master_errc::mailbox_error: return static_cast<std::uint32_t>(error.mailbox);
    case master_errc::clear_refused:
    case master_errc::sdo_abort: return static_cast<std::uint32_t>(error.abort);
    default: return 0;
    }
}

/// What a job, or a step of it, gives, or why it gives nothing.
template <class T = void> using master_result = result<T, master_error>;

} // namespace jauscat::ethercat
