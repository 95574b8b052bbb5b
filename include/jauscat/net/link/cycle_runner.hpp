// Exchanges process data over a link in cycles, on this thread, and runs a master's job in the rest of each period.
#pragma once

#include <jauscat/ethercat/link.hpp>
#include <jauscat/ethercat/master/clock_cycle.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/net/link/cycle_timer.hpp>
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::net {

/// What a cycle does first.
enum class cycle_order : std::uint8_t {
    /// Sends, and waits for the return: inputs are as new as they can be, and the thread wakes up twice in a cycle.
    send_first,
    /// Receives what the cycle before has sent, and then sends: the thread wakes up once, which takes less processor
    /// time; inputs are one period old when the outputs that follow from them go.
    receive_first,
};

struct cycle_report {
    duration late{}; ///< start of the cycle after its due time
    /// From sending the process data to the return of the last frame; only if `back`, and in the order `send_first`.
    duration round_trip{};
    bool sent{}; ///< the link accepted every frame
    bool back{}; ///< every frame returned before the next cycle was due; in the order `receive_first` of the one before
};

/// Period and timing of the cycles.
struct cycle_config {
    duration period{std::chrono::milliseconds{1}}; ///< of one cycle
    /// Part of each wait in which the thread polls the clock: see cycle_timer.
    duration spin{};
    /// In the last part of a cycle, 1 / `reserve` of it, the master sends no frame, because it would delay the next
    /// cycle's.
    unsigned reserve{4};
    /// After this part of a cycle, 1 / `loss_fraction` of it, the master no longer waits for process data that have not
    /// returned: they are probably lost.
    unsigned loss_fraction{2};
    cycle_order order{};
};

/// Between cycles the master is free for a new job. `Link` models ethercat::link.
template <class Link> class cycle_runner {
  public:
    /// The arguments must outlive this.
    cycle_runner(Link& link, ethercat::process_data& data, ethercat::master& master,
                 const cycle_config& config = {}) noexcept
        : link_{link}, data_{data}, master_{master}, config_{config}, timer_{config.period, config.spin} {
        ethercat::require_link<Link>();
    }

    /// From now on each cycle sends the clocks' frame first, and the cycles follow the reference clock; nullptr: no
    /// longer. Its period is that of the cycles. `clocks` outlives this.
    void set_clocks(ethercat::clock_cycle* clocks) noexcept { clocks_ = clocks; }

    /// Waits for the next cycle, calls `prepare()`, which writes the outputs, and sends them at once. Then receives
    /// frames until the process data have returned and the master is idle, at most until the end of the cycle. The
    /// master sends when no process data are outstanding, or when they count as lost. In the order `receive_first` it
    /// receives before it calls `prepare()`, and returns when the process data are sent and the master is idle.
    template <class Prepare> cycle_report run(Prepare&& prepare) {
        cycle_report report{.late = timer_.wait()};
        const auto start = timer_.due(), end = start + config_.period;
        const auto masters_turn = start + config_.period / std::max(config_.loss_fraction, 1u);
        const bool receives_first = config_.order == cycle_order::receive_first;
        if (receives_first) {
            receive_waiting();
            end_cycle(report);
        }
        prepare();
        begun_ = now();
        is_back_ = false;
        send_clocks();
        is_sent_ = report.sent = send_process_data();
        settle();
        // A thread that was preempted until the end of the cycle still processes received frames, up to a limit.
        // Process data count as lost only if no frame has arrived by the master's turn: a link may hold one at a time.
        bool none_arrived = false;
        for (unsigned late_frames = 0; (!receives_first && is_outstanding()) || !master_.idle();) {
            const auto at = now();
            const bool over = at >= end;
            if (over && (receives_first || !is_outstanding() || ++late_frames == max_late_frames)) break;
            const bool works = !is_outstanding() || (none_arrived && !over);
            const auto wake = std::min(end, works ? work(at, end) : masters_turn);
            if (!receive(std::max(wake - now(), duration{}))) {
                none_arrived = at >= masters_turn;
                if (over) break;
            }
        }
        if (!receives_first) end_cycle(report);
        return report;
    }

    /// Runs cycles until the master has done `job`, at most for `limit` (duration::max(): without limit).
    /// `each(report)` is called after every cycle. Returns the job's result; `busy` if another one runs, which is not
    /// affected.
    template <ethercat::master_job Job, class Prepare, class Each>
    typename Job::result_type run_job(const Job& job, duration limit, Prepare&& prepare, Each&& each) {
        if (const auto started = master_.start(job); !started) return started.error();
        static_cast<void>(run_job(limit, prepare, each));
        return master_.template result<Job>();
    }
    /// The same for the running job: ok, or why it has failed.
    template <class Prepare, class Each>
    ethercat::master_result<> run_job(duration limit, Prepare&& prepare, Each&& each) {
        const deadline end{now(), limit};
        while (!master_.idle()) {
            if (end.is_reached(now())) master_.cancel(ethercat::master_errc::timeout);
            each(run(prepare));
        }
        return master_.error();
    }

    /// Cycles that were skipped because an earlier one took too long.
    [[nodiscard]] std::uint64_t overruns() const noexcept { return timer_.overruns(); }

  private:
    static constexpr unsigned max_late_frames = 16;

    // Frames are outstanding.
    [[nodiscard]] bool is_outstanding() const noexcept {
        return (is_sent_ && !is_back_) || (clocks_ != nullptr && clocks_->waits());
    }
    void settle() {
        if (!is_sent_ || is_back_ || data_.waits()) return;
        is_back_ = true;
        round_trip_ = now() - begun_;
    }
    bool receive(duration timeout) {
        const auto size = link_.receive(received_, timeout);
        if (size == 0) return false;
        take(std::span{received_}.first(size));
        settle();
        return true;
    }
    // What the cycle before has sent; others may be among it.
    void receive_waiting() {
        for (unsigned others = 0; is_outstanding() && others != max_late_frames; ++others)
            if (!receive(duration{})) return;
    }
    void end_cycle(cycle_report& report) {
        report.back = is_back_;
        if (is_back_ && config_.order == cycle_order::send_first) report.round_trip = round_trip_;
        if (clocks_ != nullptr) timer_.shift(clocks_->end_cycle());
    }

    // All frames of a cycle, back to back. A link that holds one frame at a time accepts the next one when that has
    // been received. Whether all were accepted.
    bool send_process_data() {
        bool is_sent = false, is_refused = false;
        data_.begin_cycle();
        while (const auto size = data_.next_frame(frame_, now())) {
            const auto frame = std::span{frame_}.first(size);
            is_sent = true;
            is_refused = !send(frame) || is_refused;
        }
        return is_sent && !is_refused;
    }
    bool send(std::span<const std::byte> frame) {
        if (link_.send(frame)) return true;
        while (const auto received = link_.receive(received_, duration{})) take(std::span{received_}.first(received));
        return link_.send(frame);
    }
    // A link that refuses the frame loses it, as a wire does.
    void send_clocks() {
        if (clocks_ == nullptr) return;
        const auto at = now();
        const auto size = clocks_->next_frame(frame_, at, at - timer_.due());
        if (size != 0) static_cast<void>(send(std::span{frame_}.first(size)));
    }
    void take(std::span<const std::byte> frame) {
        if (clocks_ != nullptr && clocks_->on_frame(frame)) return;
        if (!data_.on_frame(frame)) master_.on_frame(frame, now());
    }

    // Lets the master send or time out; returns the time of its next event.
    time_point work(time_point at, time_point end) noexcept {
        master_.on_time(at);
        if (end - at > config_.period / std::max(config_.reserve, 1u)) {
            const auto size = master_.next_frame(frame_, at);
            if (size != 0 && !link_.send(std::span{frame_}.first(size)))
                master_.cancel(ethercat::master_errc::not_sent);
        }
        const auto event = master_.next_event();
        return event && *event > at ? *event : end;
    }

    Link& link_;
    ethercat::process_data& data_;
    ethercat::master& master_;
    ethercat::clock_cycle* clocks_{};
    cycle_config config_;
    cycle_timer timer_;
    time_point begun_{}; // the process data of this cycle, or the one before, were sent
    duration round_trip_{};
    bool is_sent_{}, is_back_{};
    std::array<std::byte, ethercat::max_frame_size> frame_{}; // to be sent
    std::array<std::byte, ethercat::max_frame_size> received_{};
};

} // namespace jauscat::net
