// The master's jobs as types: what a job needs, and what it gives. clock_jobs.hpp has those for distributed clocks.
#pragma once

#include <jauscat/ethercat/master/clock_jobs.hpp>
#include <jauscat/ethercat/master/mailbox_session.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/ethercat/master/object_descriptions.hpp>
#include <jauscat/ethercat/master/parallel_steps.hpp>
#include <jauscat/ethercat/master/position_check.hpp>
#include <jauscat/ethercat/master/sdo_options.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/master/sii_name.hpp>
#include <jauscat/ethercat/master/slave_bring_up.hpp>
#include <jauscat/ethercat/master/slave_identification.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/ethercat/master/slave_setup.hpp>
#include <jauscat/ethercat/master/state_change.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>
#include <jauscat/schema/ethercat/watchdog.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

// Spans and what they refer to stay in place until the job is done. Beside the errors named here, each job can end with
// those of the link: not_sent, no_reply, timeout, no_space.

/// Counts the slaves of the ring, takes them to INIT, and takes station addresses, SyncManagers and FMMUs away that an
/// earlier master has left. Forgets all slaves. Gives the number of slaves. Errors: working_counter, state_timeout.
struct scan {
    using result_type = master_result<std::size_t>;
};

/// Brings the slave at `position` to PRE-OP under the address `station`. Gives its record. Errors: no_slave,
/// wrong_station, duplicate_station, working_counter, sii_busy, sii_error, wrong_identity, no_mailbox, al_error,
/// state_timeout, too_many_slaves.
struct bring_up {
    std::uint16_t position{};  ///< 0 is the first in the ring
    std::uint16_t station{};   ///< for the tables of this library, its JAUS node
    identity_check identity{}; ///< the required identity
    using result_type = master_result<slave_record>;
};

/// One of the slaves of bring_up_all: the slave, why it was not brought up, and memory.
struct bring_up_place : parallel_place<slave_bring_up> {
    bring_up slave{};

    bring_up_place() noexcept = default;
    explicit bring_up_place(const bring_up& wanted) noexcept : slave{wanted} {}
};

/// Brings many slaves to PRE-OP at once: each frame has datagrams for as many of them as fit. Each place has the error
/// of its slave, as of `bring_up`, which does not stop the others; `duplicate_station` where an earlier place has its
/// station or position. Gives the number of slaves in PRE-OP; their records
/// are the master's.
struct bring_up_all {
    std::span<bring_up_place> places{};
    using result_type = master_result<std::size_t>;
};

/// Reads by what a slave can be recognised; `device_id`: also its explicit device identification, for which a slave
/// that has none is waited for, sii_timeout long. The slave's state does not change. Errors: wrong_station,
/// duplicate_station, working_counter, sii_busy, sii_error.
struct identify {
    std::uint16_t station{};
    bool device_id{};
    using result_type = master_result<slave_identity>;
};

/// One of the slaves of identify_all: its station address, what was read, why it was not, and memory.
struct identify_place : parallel_place<slave_identification> {
    std::uint16_t station{};
    slave_identity is{};

    identify_place() noexcept = default;
    explicit identify_place(std::uint16_t of) noexcept : station{of} {}
};

/// The same for many slaves at once. Gives the number of slaves without an error.
struct identify_all {
    std::span<identify_place> places{};
    bool device_id{};
    using result_type = master_result<std::size_t>;
};

/// One of the slaves of read_names: its station address, its name, why that was not read, and memory.
struct name_place : parallel_place<sii_name> {
    std::uint16_t station{};
    sii_text name{};

    name_place() noexcept = default;
    explicit name_place(std::uint16_t of) noexcept : station{of} {}
};

/// Reads the names of many slaves from their SIIs at once; object 1008h has the one that CoE gives. Each place has the
/// error of its slave: wrong_station, duplicate_station, working_counter, sii_busy, sii_error, sii_malformed. Gives the
/// number of slaves without an error.
struct read_names {
    std::span<name_place> places{};
    using result_type = master_result<std::size_t>;
};

/// What locate_slaves has found.
struct located_slaves {
    std::size_t slaves{};               ///< in the ring
    std::size_t known{};                ///< those that the master has brought up
    std::span<std::uint16_t> unknown{}; ///< positions of the others, as many as fit
};

/// Finds out which slaves have come or gone, without changing anything in them. The records of those that are up get
/// their positions, those that are not in the ring `slave_record::no_position`. `into` has memory for the positions of
/// slaves that the master does not know: bring those up. Errors: working_counter (a slave has come or gone meanwhile).
struct locate_slaves {
    std::span<std::uint16_t> into{};
    using result_type = master_result<located_slaves>;
};

/// One of the slaves of check_positions: its station address, whether it is not at its place, and memory.
struct position_place : parallel_place<position_check> {
    std::uint16_t station{};

    position_place() noexcept = default;
    explicit position_place(std::uint16_t of) noexcept : station{of} {}
};

/// Looks whether slaves are at their positions still: each place has the error `wrong_station` where its slave is not.
/// Gives the number of those that are.
struct check_positions {
    std::span<position_place> places{};
    using result_type = master_result<std::size_t>;
};

/// Finds out what process data a slave in PRE-OP has and sets its SyncManagers and FMMUs up. Gives its place in the
/// process image, which is then in its record. Errors: those of `upload` and of SII reads, sii_malformed, no_fmmu,
/// too_many_managers, too_many_entries, image_full, watchdog_range, watchdog_not_kept.
struct configure {
    std::uint16_t station{};
    /// If it has outputs, the slave will leave OP when it gets none for this time.
    std::chrono::nanoseconds watchdog = default_watchdog;
    std::span<process_object> objects{}; ///< get their places in the process data
    using result_type = master_result<process_place>;
};

/// One of the slaves of configure_all: its station address, why it was not configured, and memory.
struct configure_place : parallel_place<slave_setup> {
    std::uint16_t station{};
    std::span<process_object> objects{}; ///< as in `configure`

    configure_place() noexcept = default;
    explicit configure_place(std::uint16_t of, std::span<process_object> looked_for = {}) noexcept
        : station{of}, objects{looked_for} {}
};

/// Sets the process data of many slaves up at once, as `configure` does with one. Each place has the error of its
/// slave, which does not stop the others; places in the process image are in the slaves' records. Gives the number of
/// slaves without an error. Where frames may be copied, one slave is done after the other.
struct configure_all {
    std::span<configure_place> places{};
    std::chrono::nanoseconds watchdog = default_watchdog;
    using result_type = master_result<std::size_t>;
};

/// Takes a slave to another state, step by step. OP needs the cyclic exchange to be running. Errors: wrong_station,
/// duplicate_station, working_counter, al_error, state_timeout; not_configured if OP is the goal and `configure` has
/// not been done since the slave was brought up.
struct change_state {
    std::uint16_t station{};
    al_state goal{};
    using result_type = master_result<>;
};

/// One of the slaves of change_states: its station address, why it did not take the state, and memory.
struct state_place : parallel_place<state_change> {
    std::uint16_t station{};

    state_place() noexcept = default;
    explicit state_place(std::uint16_t of) noexcept : station{of} {}
};

/// Takes many slaves to another state at once, as `change_state` does with one. Each place has the error of its slave,
/// which does not stop the others. Gives the number of slaves that have reached the state.
struct change_states {
    std::span<state_place> places{};
    al_state goal{};
    using result_type = master_result<std::size_t>;
};

/// Reads a slave's AL status and whether its mailbox is full, in one frame, into its record. Gives the AL status.
/// Errors: wrong_station, duplicate_station, working_counter (no slave has the address).
struct check {
    std::uint16_t station{};
    using result_type = master_result<al_status>;
};

/// Writes `data`, of any size, to an object: in segments if they do not fit the mailbox. Errors: wrong_station, no_coe,
/// mailbox_full, mailbox_timeout, mailbox_error, clear_refused, sdo_abort, toggle_bit, unexpected_reply,
/// working_counter. After an error other than sdo_abort and clear_refused the object may have been written.
struct download {
    std::uint16_t station{};
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::span<const std::byte> data{};
    download_options options{};
    using result_type = master_result<>;
};

/// Changes of state before which start-up objects are written, as ESI files name them.
enum class state_transition : std::uint8_t {
    init_to_pre_op,    ///< IP; written in PRE-OP, where the mailbox works
    pre_op_to_safe_op, ///< PS; written before `configure`, which reads the PDOs that they change
    safe_op_to_op,     ///< SO
    op_to_safe_op,     ///< OS
    safe_op_to_pre_op, ///< SP
};

/// A start-up object. `data` stay in place until the job is done.
struct init_command {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::span<const std::byte> data{};
    state_transition transition = state_transition::pre_op_to_safe_op;
    download_options options{};
};

/// Writes the start-up objects of one transition, in their order. Gives the number of those written. Errors: those of
/// `download`; master_error::command says which one has failed, and those behind it are not written.
struct run_init_commands {
    std::uint16_t station{};
    std::span<const init_command> commands{};
    state_transition transition = state_transition::pre_op_to_safe_op;
    using result_type = master_result<std::size_t>;
};

/// Reads an object. Gives the front of `into` that has been filled; after an error what `into` holds is not to be used.
/// Errors: those of `download`, size_mismatch, data_too_long.
struct upload {
    std::uint16_t station{};
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::span<std::byte> into{};
    upload_options options{};
    using result_type = master_result<std::span<std::byte>>;
};

/// One of the objects of upload_all, its value, why it was not read, and memory.
struct upload_place : parallel_place<mailbox_session<sdo_transfer>> {
    upload object{};
    std::size_t size{}; ///< bytes at the front of `object.into`

    upload_place() noexcept = default;
    explicit upload_place(const upload& wanted) noexcept : object{wanted} {}
};

/// Reads objects of many slaves at once, one of each slave. Each place has the error of its slave, as of `upload`,
/// which does not stop the others; `busy` where an earlier place has its slave. Gives the number of slaves without an
/// error. Where frames may be copied, one slave is read after the other.
struct upload_all {
    std::span<upload_place> places{};
    using result_type = master_result<std::size_t>;
};

/// Reads the indices of a slave's objects to `into`, 2 bytes each. Errors: those of `upload`, fragment_missing,
/// too_many_fragments.
struct list_objects {
    std::uint16_t station{};
    object_list_type list = object_list_type::all;
    std::span<std::byte> into{};
    using result_type = master_result<object_indices>;
};

/// Reads the description of an object to `into`. Errors: as above.
struct describe_object {
    std::uint16_t station{};
    std::uint16_t index{};
    std::span<std::byte> into{};
    using result_type = master_result<object_description>;
};

/// Reads the description of an entry to `into`. Errors: as above.
struct describe_entry {
    std::uint16_t station{};
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::uint8_t value_info{}; ///< the values that are asked for: see entry_query
    std::span<std::byte> into{};
    using result_type = master_result<entry_description>;
};

/// Takes what waits in the slave's mailbox: its emergencies are in its record then. Errors: wrong_station, no_mailbox,
/// no_coe, mailbox_full (there is always more).
struct collect_emergencies {
    std::uint16_t station{};
    using result_type = master_result<>;
};

/// Sends one datagram; what comes back is in `data` then. Gives its working counter.
struct exchange_datagram {
    command cmd{};
    std::uint16_t adp{};
    std::uint16_t ado{};
    std::span<std::byte> data{};
    using result_type = master_result<std::uint16_t>;
};

} // namespace jauscat::ethercat
