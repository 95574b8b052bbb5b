// An EtherCAT master without I/O: frames out, frames and time in. Brings slaves up to PRE-OP and transfers SDOs, one
// job at a time. `jauscat/net/run_master.hpp` drives it over a link; anything else that can send and receive frames may
// too.
#pragma once

#include <jauscat/ethercat/activity.hpp>
#include <jauscat/ethercat/bring_up.hpp>
#include <jauscat/ethercat/mailbox_exchange.hpp>
#include <jauscat/ethercat/outstanding_frame.hpp>
#include <jauscat/ethercat/sdo_transfer.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// What a master has seen on its link, in frames.
struct master_statistics {
    std::uint64_t sent{};
    std::uint64_t received{}; ///< replies that were waited for
    std::uint64_t lost{};     ///< replies that did not come in time
    std::uint64_t ignored{};  ///< late, duplicate and foreign frames
};

/// Start a job with `bring_up`, `download` or `upload`; then, until `idle()`: send what `next_frame` gives, pass what
/// arrives to `on_frame`, and call `on_time` at `next_event()`. `result()` says how the job ended.
class master {
  public:
    static constexpr std::size_t slave_capacity = 16;

    explicit master(const master_config& config = {}) noexcept : config_{config} {}

    /// Starts to bring the slave at `position` (0 is the first in the ring) to PRE-OP under the address `station`.
    /// False while another job runs. Errors: no_slave, wrong_station, duplicate_station, working_counter, sii_busy,
    /// sii_error, no_mailbox, no_coe, al_error, state_timeout, too_many_slaves, and those of the link.
    bool bring_up(std::uint16_t position, std::uint16_t station) noexcept {
        if (!begin()) return false;
        const auto replaced = [&](const slave_record& s) { return s.position == position || s.station == station; };
        const auto others = known();
        const auto known_before = std::ranges::find(others, station, &slave_record::station);
        unfinished_ = known_before == others.end() ? std::nullopt : known_before->unfinished;
        slave_count_ =
            static_cast<std::size_t>(std::remove_if(others.begin(), others.end(), replaced) - others.begin());
        if (slave_count_ == slave_capacity) {
            finish({.error = master_errc::too_many_slaves});
        } else {
            bring_up_ = ethercat::bring_up{position, station};
            job_ = job::bring_up;
        }
        return true;
    }

    /// Starts to write `data`, of any size, to an object of the slave `station`: in segments if they do not fit its
    /// mailbox. `data` stay in place until the job is done. False while another job runs. Errors: wrong_station,
    /// mailbox_full, mailbox_timeout, mailbox_error, clear_refused, sdo_abort, toggle_bit, unexpected_reply,
    /// working_counter, and those of the link. After an error other than sdo_abort and clear_refused the object may
    /// have been written.
    bool download(std::uint16_t station, std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data,
                  const download_options& options = {}) noexcept {
        return transfer(station, sdo_transfer::download(index, subindex, data, options));
    }

    /// Starts to read an object of the slave `station` into `into`; `result().size` then says how many bytes. `into`
    /// stays in place until the job is done. False while another job runs.
    /// After an error what `into` holds is not to be used. Errors: those of `download`, size_mismatch, data_too_long.
    bool upload(std::uint16_t station, std::uint16_t index, std::uint8_t subindex, std::span<std::byte> into) noexcept {
        return transfer(station, sdo_transfer::upload(index, subindex, into));
    }

    /// Gives the job up with `error`: its deadline has passed, or the link does not take frames. A transfer that the
    /// slave has open is aborted before the next one.
    void cancel(master_errc error) noexcept {
        if (idle()) return;
        if (job_ == job::sdo) {
            mailbox_exchange::abandon(slaves_[slave_]);
            if (transfer_.is_open()) slaves_[slave_].unfinished = transfer_.abort_message();
        }
        finish(job_ == job::abort ? ended_ : outcome{.error = error});
    }

    [[nodiscard]] bool idle() const noexcept { return job_ == job::none; }
    /// How the last job ended.
    [[nodiscard]] const outcome& result() const noexcept { return result_; }
    /// The slaves that have been brought up.
    [[nodiscard]] std::span<const slave_record> slaves() const noexcept {
        return std::span{slaves_}.first(slave_count_);
    }
    /// The last emergency that a slave sent during the last transfer.
    [[nodiscard]] const std::optional<coe_emergency>& emergency() const noexcept { return transfer_.emergency(); }
    [[nodiscard]] const master_statistics& statistics() const noexcept { return statistics_; }

    /// Writes the next frame to `out`, which holds 1514 bytes, and returns its size; 0 when there is nothing to send
    /// now.
    std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept {
        if (idle() || outstanding_.waits() || now < not_before_) return 0;
        frame_builder frame{out, ++index_};
        if (job_ == job::bring_up)
            bring_up_.request(frame);
        else
            exchange_.request(frame, slaves_[slave_], message());
        const auto size = frame.finish();
        if (!size) {
            cancel(master_errc::no_space);
            return 0;
        }
        outstanding_.sent(out.first(size.size()), now);
        ++statistics_.sent;
        return size.size();
    }

    /// Takes a frame that arrived. False if it was not the reply that is waited for: it then changed nothing.
    bool on_frame(std::span<const std::byte> frame, time_point now) noexcept {
        frame_view view;
        const auto datagrams = outstanding_.waits() && view.parse(frame) ? outstanding_.match(view) : replies{};
        if (datagrams.empty()) {
            ++statistics_.ignored;
            return false;
        }
        ++statistics_.received;
        outstanding_.forget();
        losses_ = 0;
        const auto next = job_ == job::bring_up
                              ? bring_up_.reply(datagrams, now, config_)
                              : exchange_.reply(datagrams.front(), now, config_, slaves_[slave_], message());
        if (next == progress::wait) not_before_ = now + config_.poll_interval;
        if (next == progress::done) complete();
        return true;
    }

    /// Time has passed: a frame that is not back after `frame_timeout` is lost and asked for again, then given up.
    void on_time(time_point now) noexcept {
        if (!outstanding_.waits() || now - outstanding_.sent_at() < config_.frame_timeout) return;
        outstanding_.forget();
        ++statistics_.lost;
        if (++losses_ > config_.retries) {
            cancel(master_errc::no_reply);
        } else if (job_ != job::bring_up) {
            exchange_.lost(slaves_[slave_]);
        }
    }

    /// When `on_time` or `next_frame` will next have something to do, if no frame arrives first; none while idle.
    [[nodiscard]] std::optional<time_point> next_event() const noexcept {
        if (idle()) return std::nullopt;
        return outstanding_.waits() ? outstanding_.sent_at() + config_.frame_timeout : not_before_;
    }

  private:
    enum class job : std::uint8_t {
        none,
        bring_up,
        abort_earlier, // a transfer given up before stands in the way of the next
        sdo,
        abort, // the transfer has failed, and the slave is told so
    };

    [[nodiscard]] std::span<slave_record> known() noexcept { return std::span{slaves_}.first(slave_count_); }

    bool begin() noexcept {
        if (!idle()) return false;
        result_ = {};
        losses_ = 0;
        return true;
    }

    bool transfer(std::uint16_t station, const sdo_transfer& transfer) noexcept {
        if (!begin()) return false;
        transfer_ = transfer;
        const auto slave = std::ranges::find(known(), station, &slave_record::station);
        if (slave == known().end()) {
            finish({.error = master_errc::wrong_station, .detail = station});
        } else {
            slave_ = static_cast<std::size_t>(slave - known().begin());
            transfer_.use_mailbox(slave->mailbox.receive_size);
            start(slave->unfinished ? job::abort_earlier : job::sdo);
        }
        return true;
    }

    // The next message of a transfer, or an abort.
    void start(job what) noexcept {
        auto& slave = slaves_[slave_];
        job_ = what;
        if (what != job::sdo) abort_ = sdo_transfer::abort(*slave.unfinished);
        exchange_ = mailbox_exchange{slave};
    }
    [[nodiscard]] sdo_transfer& message() noexcept { return job_ == job::sdo ? transfer_ : abort_; }

    void complete() noexcept {
        if (job_ == job::bring_up) return bring_up_complete();
        const auto result = exchange_.result();
        auto& unfinished = slaves_[slave_].unfinished;
        if (job_ == job::sdo) {
            if (result && !transfer_.finished()) return start(job::sdo);
            ended_ = result;
            if (!transfer_.is_open()) return finish(ended_);
            unfinished = transfer_.abort_message();
            // A slave that was reset, or takes no mail, is told so before the next transfer.
            const bool reachable =
                result.error != master_errc::working_counter && result.error != master_errc::mailbox_full;
            return reachable ? start(job::abort) : finish(ended_);
        }
        if (result) unfinished.reset();
        if (job_ == job::abort) return finish(ended_);
        return result ? start(job::sdo) : finish(result);
    }

    void bring_up_complete() noexcept {
        finish(bring_up_.result());
        if (!result_) return;
        slaves_[slave_count_] = bring_up_.slave();
        slaves_[slave_count_++].unfinished = unfinished_; // a change of state does not end it in every slave
    }

    void finish(const outcome& result) noexcept {
        result_ = result;
        job_ = job::none;
        not_before_ = time_point::min();
        outstanding_.forget();
    }

    master_config config_;
    std::array<slave_record, slave_capacity> slaves_{};
    std::size_t slave_count_{};

    job job_{};
    ethercat::bring_up bring_up_{};
    std::size_t slave_{}; // whose transfer it is
    sdo_transfer transfer_{};
    sdo_transfer abort_{};
    mailbox_exchange exchange_{};
    outcome ended_{};                       // how the transfer ended that is being aborted
    std::optional<sdo_abort> unfinished_{}; // of the slave that is brought up
    outcome result_{};

    outstanding_frame outstanding_{};
    std::uint8_t index_{};
    unsigned losses_{}; // in a row
    time_point not_before_ = time_point::min();
    master_statistics statistics_{};
};

} // namespace jauscat::ethercat
