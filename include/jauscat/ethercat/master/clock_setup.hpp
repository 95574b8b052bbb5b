// Sets distributed clocks up: open ports, receive times, delays, offsets, restart of the control, drift.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/clock_jobs.hpp>
#include <jauscat/ethercat/master/clock_topology.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return and moves on. For n
/// slaves about 0.7 n frames, and those that carry the reference time.
class clock_setup {
  public:
    clock_setup() noexcept = default;
    explicit clock_setup(const set_up_clocks& job) noexcept
        : slaves_{job.slaves}, options_{job.options}, begun_{job.system_time} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    [[nodiscard]] const clock_network& network() const noexcept { return network_; }

    void request(frame_builder& frame) const noexcept {
        switch (step_) {
        case step::latch: return frame.add(command::bwr, 0, esc_registers::dc_receive_times.address, dc_time_32{});
        case step::drift: // a slave that the reference clock's time does not reach takes the last one
            return frame.add(command::frmw, network_.reference, esc_registers::dc_system_time.address,
                             dc_time{reference_time_});
        case step::look:
        case step::read:
        case step::write:
        case step::check: break;
        }
        for (const auto& slave : batch()) request(frame, slave);
    }

    progress reply(replies datagrams, time_point now, const master_config&) noexcept {
        if (!has_begun_) begun_at_ = now;
        has_begun_ = true;
        if (step_ == step::latch) {
            latched_ = begun_ + static_cast<std::uint64_t>((now - begun_at_).count());
            return go(step::read);
        }
        if (step_ == step::drift) return drifted(datagrams.front());
        for (auto& slave : batch()) {
            if (result_ = take(slave, datagrams); !result_) return fail_at(slave.station);
            datagrams = datagrams.subspan(count(slave));
        }
        first_ += batch().size();
        return first_ < slaves_.size() ? progress::send : step_done();
    }

  private:
    enum class step : std::uint8_t { look, latch, read, write, drift, check };

    static constexpr std::size_t datagrams_per_frame = 15;

    // The slaves of the present frame.
    [[nodiscard]] std::span<clock_record> batch() const noexcept {
        const auto left = slaves_.subspan(std::min(first_, slaves_.size()));
        const std::size_t each = step_ == step::check ? 1 : 3;
        return left.first(std::min(left.size(), datagrams_per_frame / each));
    }

    // A slave has as many datagrams in each frame of a step.
    [[nodiscard]] std::size_t count(const clock_record& slave) const noexcept {
        switch (step_) {
        case step::look: return slave.runs ? 2 : 3;
        case step::write: return slave.runs ? 1 : 3;
        case step::check: return 1;
        default: return 3;
        }
    }
    void request(frame_builder& frame, const clock_record& slave) const noexcept {
        const auto station = slave.station;
        switch (step_) {
        case step::look:
            frame.read(station, esc_registers::description);
            frame.read(station, esc_registers::dl_status);
            if (!slave.runs) frame.write(station, esc_registers::dc_activation, {});
            break;
        case step::read:
            frame.read(station, esc_registers::dc_receive_times);
            frame.read(station, esc_registers::dc_processing_time);
            frame.read(station, esc_registers::dc_offset);
            break;
        case step::write:
            frame.write(station, esc_registers::dc_delay, {slave.delay});
            if (slave.runs) break;
            if (slave.width == clock_width::bits_64)
                frame.write(station, esc_registers::dc_offset, {slave.offset});
            else
                frame.write(station, low_half(esc_registers::dc_offset), {static_cast<std::uint32_t>(slave.offset)});
            frame.write(station, esc_registers::dc_speed_start, {speed_start});
            break;
        default: frame.read(station, esc_registers::dc_difference);
        }
    }
    master_result<> take(clock_record& slave, replies datagrams) noexcept {
        const auto own = datagrams.first(count(slave));
        if (step_ == step::look) {
            if (const auto executed = executed_by_one(own.first(2)); !executed) return executed;
            const auto features = own[0].value(esc_registers::description);
            slave.width = !features.dc     ? clock_width::no_clock
                          : features.dc_64 ? clock_width::bits_64
                                           : clock_width::bits_32;
            const auto ports = own[1].value(esc_registers::dl_status).ports();
            std::ranges::transform(ports, slave.open.begin(), [](const dl_port& port) { return port.is_open(); });
            return {};
        }
        if (!slave.has_clock()) return {};
        const auto executed = executed_by_one(own);
        if (step_ == step::read) {
            if (own[0].working_counter == 0) { // it says that it has a clock, and has none
                slave.width = clock_width::no_clock;
                return {};
            }
            slave.received = own[0].value(esc_registers::dc_receive_times).ports;
            slave.processing_time = own[1].value(esc_registers::dc_processing_time).value;
            slave.offset = own[2].value(esc_registers::dc_offset).value;
            if (slave.width == clock_width::bits_32) slave.processing_time &= 0xFFFFFFFF;
        }
        if (step_ == step::check) {
            slave.difference = own[0].value(esc_registers::dc_difference);
            if (&slave != &reference()) network_.difference = std::max(network_.difference, slave.difference.magnitude);
        }
        return executed;
    }

    progress step_done() noexcept {
        switch (step_) {
        case step::look: return go(step::latch);
        case step::read: return compute();
        case step::write: return drift(options_.drift_frames);
        default: return checked();
        }
    }

    [[nodiscard]] clock_record& reference() const noexcept { return slaves_[reference_]; }

    progress compute() noexcept {
        reference_ = reference_clock(slaves_);
        if (reference_ == slaves_.size()) return fail({.code = master_errc::no_clock});
        if (result_ = find_parents(slaves_); !result_) return progress::done;
        if (result_ = find_delays(slaves_, options_.delay); !result_) return progress::done;
        const auto time = time_of_latch();
        reference_time_ = time;
        network_ = {.reference = reference().station, .reference_width = reference().width};
        for (auto& slave : slaves_) {
            if (!slave.has_clock()) continue;
            ++network_.clocks;
            if (!slave.runs) slave.offset = static_cast<std::int64_t>(time + slave.delay - slave.processing_time);
        }
        return go(step::write);
    }

    // Time of the reference clock when the frame passed it: that of the clocks that run, the master's if none does.
    [[nodiscard]] std::uint64_t time_of_latch() const noexcept {
        const auto first =
            std::ranges::find_if(slaves_, [](const auto& each) { return each.has_clock() && each.runs; });
        if (first == slaves_.end()) return latched_;
        const auto time = first->processing_time + static_cast<std::uint64_t>(first->offset) - first->delay;
        return first->width == clock_width::bits_64 ? time : extend_time(static_cast<std::uint32_t>(time), latched_);
    }

    progress drift(unsigned frames) noexcept {
        drift_left_ = frames;
        return go(frames != 0 ? step::drift : step::check);
    }
    progress drifted(const datagram_view& back) noexcept {
        if (back.working_counter == 0) return fail({.code = master_errc::working_counter});
        network_.working_counter = back.working_counter;
        const auto time = back.value(esc_registers::dc_system_time).value;
        reference_time_ = reference().width == clock_width::bits_64
                              ? time
                              : extend_time(static_cast<std::uint32_t>(time), reference_time_);
        return --drift_left_ != 0 ? progress::send : go(step::check);
    }
    progress checked() noexcept {
        if (network_.difference <= options_.limit) return progress::done;
        if (repeats_++ != options_.repeats) return drift(std::max(options_.drift_frames / 10, 1u));
        const auto worst = std::ranges::max_element(slaves_, {}, [this](const clock_record& slave) {
            return &slave == &reference() || !slave.has_clock() ? 0 : slave.difference.magnitude;
        });
        return fail({.code = master_errc::clock_unsettled,
                     .station = worst->station,
                     .nanoseconds = worst->difference.magnitude});
    }

    progress go(step next) noexcept {
        step_ = next;
        first_ = 0;
        network_.difference = 0;
        return progress::send;
    }
    progress fail(const master_error& error) noexcept {
        result_ = error;
        return progress::done;
    }

    progress fail_at(std::uint16_t station) noexcept {
        auto error = result_.error();
        error.station = station;
        return fail(error);
    }

    static constexpr std::uint16_t speed_start = 0x1000;

    std::span<clock_record> slaves_{};
    clock_options options_{};
    step step_{};
    std::size_t first_{}; // of the present frame
    std::size_t reference_{};
    bool has_begun_{};
    std::uint64_t begun_{}; // system time at begun_at_
    time_point begun_at_{};
    std::uint64_t latched_{};        // system time of the frame that passed all slaves
    std::uint64_t reference_time_{}; // as it was last seen
    unsigned drift_left_{};
    unsigned repeats_{};
    clock_network network_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
