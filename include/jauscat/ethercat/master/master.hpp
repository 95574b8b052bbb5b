// An EtherCAT master without I/O: frames out, frames and time in. Brings slaves up and through their states, transfers
// SDOs, asks for objects, sets up process data, one job at a time. `jauscat/net/link/run_master.hpp` drives it over a
// link; anything else that can send and receive frames may too. The cyclic exchange is process_data's.
#pragma once

#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/bring_up.hpp>
#include <jauscat/ethercat/master/datagram_exchange.hpp>
#include <jauscat/ethercat/master/frame_traffic.hpp>
#include <jauscat/ethercat/master/mailbox_exchange.hpp>
#include <jauscat/ethercat/master/process_setup.hpp>
#include <jauscat/ethercat/master/ring_scan.hpp>
#include <jauscat/ethercat/master/sdo_information.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/master/slave_check.hpp>
#include <jauscat/ethercat/master/slave_list.hpp>
#include <jauscat/ethercat/master/state_change.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// Start a job; then, until `idle()`: send what `next_frame` gives, pass what arrives to `on_frame`, and call `on_time`
/// at `next_event()`. `result()` says how the job ended. Not copied while one runs. Every function that starts a job
/// returns false while another one runs, whose result is not its own; what it is given by reference or as a span stays
/// in place until the job is done. Beside the errors named there, each job can end with those of the link: not_sent,
/// no_reply, timeout, no_space.
class master {
  public:
    /// Idle, and without slaves.
    explicit master(const master_config& config = {}) noexcept : frames_{config} {}

    /// Counts the slaves of the ring, `result().size`, takes them to INIT, and takes station addresses, SyncManagers
    /// and FMMUs away that an earlier master has left. Forgets all slaves. Errors: working_counter, state_timeout.
    [[nodiscard]] bool scan() noexcept {
        if (!begin(job::scan)) return false;
        slaves_.clear();
        away_.clear();
        scan_ = {};
        return true;
    }

    /// Brings the slave at `position` (0 is the first in the ring) to PRE-OP under the address `station`: for the
    /// tables of this library, its JAUS node. Errors: no_slave, wrong_station, duplicate_station, working_counter,
    /// sii_busy, sii_error, wrong_identity, no_mailbox, al_error, state_timeout, too_many_slaves.
    [[nodiscard]] bool bring_up(std::uint16_t position, std::uint16_t station,
                                const identity_check& expected = {}) noexcept {
        if (!begin(job::bring_up)) return false;
        const auto* before = slaves_.find(station);
        const bool is_ours = before != nullptr && before->position != position; // another slave is to have it
        if (before == nullptr) before = away_.find(station);
        before_ = before != nullptr ? *before : slave_record{};
        slaves_.remove(position, station);
        away_.remove(position, station);
        if (before_.station == station && !away_.full()) away_.add(before_);
        bring_up_ = ethercat::bring_up{position, station, expected, !is_ours};
        if (slaves_.full()) finish({.error = master_errc::too_many_slaves});
        return true;
    }

    /// Finds out what process data a slave in PRE-OP has and sets its SyncManagers and FMMUs up. Its place in the
    /// process image is then in its record. If it has outputs, it will leave OP when it gets none for the time
    /// `watchdog`. Errors: those of `upload` and of SII reads, sii_malformed, no_fmmu, too_many_managers, image_full,
    /// watchdog_range, watchdog_not_kept.
    [[nodiscard]] bool configure(std::uint16_t station, std::chrono::nanoseconds watchdog = default_watchdog) noexcept {
        if (!begin(job::configure)) return false;
        if (!choose(station)) return true;
        slave_->watchdog = {};
        auto image = slaves_.image_without(*slave_);
        image.size = std::max(image.size, away_.image_without(*slave_).size);
        setup_ = process_setup{*slave_, image, watchdog, frames_.config().logical_base};
        if (watchdog_units(watchdog) == 0) finish({.error = master_errc::watchdog_range});
        return true;
    }

    /// Takes a slave to another state, step by step. OP needs the cyclic exchange to be running. Errors: wrong_station,
    /// duplicate_station, working_counter, al_error, state_timeout; not_configured if OP is the goal and `configure`
    /// has not been done since the slave was brought up.
    [[nodiscard]] bool change_state(std::uint16_t station, al_state goal) noexcept {
        if (!begin(job::change_state)) return false;
        if (!choose(station)) return true;
        if (!is_known(goal))
            finish(
                {.error = master_errc::al_error, .detail = static_cast<std::uint32_t>(al_status_code::unknown_state)});
        else if (goal == al_state::op && slave_->watchdog == slave_->watchdog.zero())
            finish({.error = master_errc::not_configured});
        change_ = state_change{station, goal};
        slave_->drained = false;
        return true;
    }

    /// Reads a slave's AL status and whether its mailbox is full, in one frame, into its record. Errors: wrong_station,
    /// duplicate_station, working_counter (no slave has the address).
    [[nodiscard]] bool check(std::uint16_t station) noexcept {
        if (!begin(job::check)) return false;
        if (!choose(station)) return true;
        slave_->al = {};
        slave_->mail_waits = false;
        check_ = slave_check{*slave_};
        return true;
    }

    /// Writes `data`, of any size, to an object: in segments if they do not fit the mailbox. Errors: wrong_station,
    /// no_coe, mailbox_full, mailbox_timeout, mailbox_error, clear_refused, sdo_abort, toggle_bit, unexpected_reply,
    /// working_counter. After an error other than sdo_abort and clear_refused the object may have been written.
    [[nodiscard]] bool download(std::uint16_t station, std::uint16_t index, std::uint8_t subindex,
                                std::span<const std::byte> data, const download_options& options = {}) noexcept {
        return transfer(station, sdo_transfer::download(index, subindex, data, options));
    }

    /// Reads an object into `into`; `result().size` then says how many bytes. After an error what `into` holds is not
    /// to be used. Errors: those of `download`, size_mismatch, data_too_long.
    [[nodiscard]] bool upload(std::uint16_t station, std::uint16_t index, std::uint8_t subindex,
                              std::span<std::byte> into, const upload_options& options = {}) noexcept {
        return transfer(station, sdo_transfer::upload(index, subindex, into, options));
    }

    /// The indices of the slave's objects to `into`, 2 bytes each, `result().size` bytes in all. Errors: those of
    /// `upload`, fragment_missing.
    [[nodiscard]] bool list_objects(std::uint16_t station, object_list_type list, std::span<std::byte> into) noexcept {
        return ask(station, sdo_information::list(list, into));
    }
    /// Reads the description of an object: object_answer and name, to `into`. Errors: as above.
    [[nodiscard]] bool describe_object(std::uint16_t station, std::uint16_t index, std::span<std::byte> into) noexcept {
        return ask(station, sdo_information::object(index, into));
    }
    /// Reads the description of an entry: entry_answer, the values selected by `value_info`, and name, to `into`.
    /// Errors: as above.
    [[nodiscard]] bool describe_entry(std::uint16_t station, std::uint16_t index, std::uint8_t subindex,
                                      std::uint8_t value_info, std::span<std::byte> into) noexcept {
        return ask(station, sdo_information::entry({index, subindex, value_info}, into));
    }

    /// Takes what waits in the slave's mailbox: its emergencies are in its record then. Errors: wrong_station,
    /// no_mailbox, no_coe, mailbox_full (there is always more).
    [[nodiscard]] bool collect_emergencies(std::uint16_t station) noexcept {
        if (!begin(job::collect)) return false;
        if (choose(station, true)) exchange_ = mailbox_exchange::collect();
        return true;
    }

    /// Sends one datagram; what comes back is in `data` then, and `result().detail` is its working counter.
    [[nodiscard]] bool exchange(command cmd, std::uint16_t adp, std::uint16_t ado, std::span<std::byte> data) noexcept {
        if (!begin(job::datagram)) return false;
        datagram_ = datagram_exchange{cmd, adp, ado, data};
        return true;
    }

    /// Gives the job up with `error`: its deadline has passed, or the link does not take frames. A transfer that the
    /// slave has open is aborted before the next one.
    void cancel(master_errc error) noexcept {
        if (idle()) return;
        if (uses_mailbox()) exchange_.abandon(*slave_);
        if (job_ == job::sdo && transfer_.is_open()) slave_->unfinished = transfer_.abort_message();
        finish(job_ == job::abort ? ended_ : outcome{.error = error});
    }

    /// Whether no job runs, so that one may be started.
    [[nodiscard]] bool idle() const noexcept { return job_ == job::none; }
    /// Result of the last job.
    [[nodiscard]] const outcome& result() const noexcept { return result_; }
    [[nodiscard]] std::span<const slave_record> slaves() const noexcept { return slaves_.all(); }
    /// The record of a slave; none if it has not been brought up.
    [[nodiscard]] const slave_record* find(std::uint16_t station) const noexcept { return slaves_.find(station); }
    /// Forgets a slave's emergencies.
    void clear_emergencies(std::uint16_t station) noexcept {
        if (auto* const slave = slaves_.find(station)) slave->emergencies.clear();
    }
    [[nodiscard]] const master_statistics& statistics() const noexcept { return frames_.statistics(); }

    /// Writes the next frame to `out`, which holds 1514 bytes, and returns its size; 0 when there is nothing to send
    /// now.
    std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept {
        if (idle() || !frames_.may_send(now)) return 0;
        frame_builder frame{out, frames_.next_index()};
        if (uses_mailbox())
            with_protocol([&](auto& protocol) { exchange_.request(frame, *slave_, protocol); });
        else
            with_steps([&](auto& steps) { steps.request(frame); });
        const auto size = frame.finish();
        if (!size) {
            cancel(master_errc::no_space);
            return 0;
        }
        frames_.sent(out.first(size.size()), now);
        return size.size();
    }

    /// Takes a frame that arrived. False if it was not the reply that is waited for: it then changed nothing.
    bool on_frame(std::span<const std::byte> frame, time_point now) noexcept {
        const auto datagrams = frames_.take(frame, uses_mailbox() && exchange_.was_refused());
        if (datagrams.empty()) return false;
        const auto& config = frames_.config();
        progress next{};
        if (uses_mailbox()) {
            with_protocol(
                [&](auto& protocol) { next = exchange_.reply(datagrams.front(), now, config, *slave_, protocol); });
        } else {
            with_steps([&](auto& steps) { next = steps.reply(datagrams, now, config); });
        }
        if (next == progress::wait) frames_.wait_until(now + config.poll_interval);
        if (next == progress::done) complete();
        if (job_ == job::configure && setup_.wants_upload()) {
            configuring_ = true;
            start(setup_.upload());
        }
        return true;
    }

    /// Time has passed: a frame that is not back after `frame_timeout` is lost and asked for again, then given up.
    void on_time(time_point now) noexcept {
        if (!frames_.is_late(now)) return;
        const bool repeats = job_ != job::datagram && (!uses_mailbox() || exchange_.is_repeatable());
        if (!frames_.lose(repeats)) return cancel(master_errc::no_reply);
        if (uses_mailbox()) exchange_.lost(*slave_);
    }

    /// When `on_time` or `next_frame` will next have something to do, if no frame arrives first; none while idle.
    [[nodiscard]] std::optional<time_point> next_event() const noexcept {
        if (idle()) return std::nullopt;
        return frames_.next_event();
    }

  private:
    enum class job : std::uint8_t {
        none,
        scan,
        bring_up,
        configure,
        change_state,
        check,
        datagram,
        // The steps from here on use the mailbox.
        collect,
        information,
        sdo,
        abort_earlier, // a transfer given up before stands in the way of the next
        abort,         // the transfer has failed, and the slave is told so
    };
    [[nodiscard]] bool uses_mailbox() const noexcept { return job_ >= job::collect; }

    bool begin(job what) noexcept {
        if (!idle()) return false;
        job_ = what;
        result_ = {};
        configuring_ = false;
        frames_.begin();
        return true;
    }

    /// The slave that the job is about. False where the job has ended because there is none.
    bool choose(std::uint16_t station, bool mailbox = false) noexcept {
        slave_ = slaves_.find(station);
        if (slave_ == nullptr)
            finish({.error = master_errc::wrong_station, .detail = station});
        else if (mailbox && slave_->mailbox.receive_size == 0)
            finish({.error = master_errc::no_mailbox});
        else if (mailbox && !slave_->mailbox.coe)
            finish({.error = master_errc::no_coe});
        return !idle();
    }

    bool transfer(std::uint16_t station, const sdo_transfer& transfer) noexcept {
        if (!begin(job::sdo)) return false;
        if (choose(station, true)) start(transfer);
        return true;
    }
    void start(const sdo_transfer& transfer) noexcept {
        transfer_ = transfer;
        transfer_.use_mailbox(slave_->mailbox.receive_size);
        start_in_turn(job::sdo);
    }
    bool ask(std::uint16_t station, const sdo_information& question) noexcept {
        if (!begin(job::information)) return false;
        information_ = question;
        if (choose(station, true)) start_in_turn(job::information);
        return true;
    }
    void start_in_turn(job what) noexcept {
        after_abort_ = what;
        start(slave_->unfinished ? job::abort_earlier : what);
    }

    // The next message of a mailbox job, or an abort.
    void start(job what) noexcept {
        auto& slave = *slave_;
        job_ = what;
        if (what == job::abort || what == job::abort_earlier) abort_ = sdo_transfer::abort(*slave.unfinished);
        exchange_ = mailbox_exchange{slave};
    }

    void with_protocol(auto&& use) noexcept {
        if (job_ == job::information)
            use(information_);
        else
            use(job_ == job::sdo ? transfer_ : abort_);
    }
    void with_steps(auto&& use) noexcept {
        switch (job_) {
        case job::scan: return use(scan_);
        case job::bring_up: return use(bring_up_);
        case job::configure: return use(setup_);
        case job::change_state: return use(change_);
        case job::check: return use(check_);
        default: return use(datagram_);
        }
    }

    void complete() noexcept {
        switch (job_) {
        case job::bring_up: return bring_up_complete();
        case job::configure: return configured();
        case job::check: return checked();
        case job::sdo:
        case job::abort_earlier:
        case job::abort: return message_complete();
        case job::collect:
        case job::information: return finish(exchange_.result());
        default: return with_steps([this](auto& steps) { finish(steps.result()); });
        }
    }

    void message_complete() noexcept {
        const auto result = exchange_.result();
        auto& unfinished = slave_->unfinished;
        if (job_ == job::sdo) {
            if (result && !transfer_.finished()) return start(job::sdo);
            ended_ = result;
            if (!transfer_.is_open()) return transfer_complete();
            unfinished = transfer_.abort_message();
            // To a slave that is not reachable, or whose mailbox is full, the abort is sent before the next transfer.
            const bool reachable =
                result.error != master_errc::working_counter && result.error != master_errc::mailbox_full;
            return reachable ? start(job::abort) : transfer_complete();
        }
        if (result) unfinished.reset();
        if (job_ == job::abort) return transfer_complete();
        if (result) return start(after_abort_);
        ended_ = result;
        transfer_complete();
    }

    void transfer_complete() noexcept {
        if (!configuring_) return finish(ended_);
        job_ = job::configure;
        if (setup_.uploaded(ended_) == progress::done) configured();
    }

    void configured() noexcept {
        if (setup_.result()) {
            slave_->process_data = setup_.place();
            slave_->watchdog = setup_.watchdog();
        }
        finish(setup_.result());
    }
    void checked() noexcept {
        slave_->al = check_.al();
        slave_->mail_waits = check_.mail_waits();
        finish(check_.result());
    }
    void bring_up_complete() noexcept {
        finish(bring_up_.result());
        if (!result_) return;
        auto slave = bring_up_.slave();
        slave.process_data = before_.process_data; // it keeps its place in the image
        slave.unfinished = before_.unfinished;     // a change of state does not end it in every slave
        slave.last_counter = before_.last_counter; // some slaves keep it, and drop a message with the same one
        away_.remove(slave.position, slave.station);
        slaves_.add(slave);
    }

    void finish(const outcome& result) noexcept {
        result_ = result;
        job_ = job::none;
        frames_.give_up();
    }

    frame_traffic frames_;
    slave_list slaves_{};
    slave_list away_{}; // could not be brought up again: what it does with its place in the image is not known

    job job_{};
    outcome result_{};
    ring_scan scan_{};
    ethercat::bring_up bring_up_{};
    slave_record before_{}; // of the slave that is brought up
    process_setup setup_{};
    state_change change_{};
    slave_check check_{};
    datagram_exchange datagram_{};

    slave_record* slave_{}; // whose mailbox or state it is
    mailbox_exchange exchange_{};
    sdo_information information_{};
    sdo_transfer transfer_{};
    sdo_transfer abort_{};
    job after_abort_{};  // what an earlier transfer's abort stands in the way of
    outcome ended_{};    // how the transfer ended that is being aborted
    bool configuring_{}; // the transfer is a part of `configure`
};

} // namespace jauscat::ethercat
