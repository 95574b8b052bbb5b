// Switches the SYNC signals of slaves on, at start times that fit together.
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

/// The system time of the first SYNC0: not before `earliest`, a multiple of the period since 2000, plus the shift.
[[nodiscard]] constexpr std::uint64_t sync_start(std::uint64_t earliest, const sync_settings& sync) noexcept {
    const auto period = std::max<std::uint64_t>(sync.period(), 1);
    const auto shift = static_cast<std::uint64_t>(sync.shift.count());
    return (earliest - shift + period - 1) / period * period + shift;
}

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return and moves on. One frame
/// for each three slaves, and two.
class sync_setup {
  public:
    sync_setup() noexcept = default;
    explicit sync_setup(const start_sync& job) noexcept
        : slaves_{job.slaves},
          reference_{reference_clock(job.slaves)},
          time_{job.system_time},
          lead_{static_cast<std::uint64_t>(std::max(job.lead, job.lead.zero()).count())} {}

    [[nodiscard]] bool has_reference() const noexcept { return reference_ != slaves_.size(); }
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    [[nodiscard]] std::uint64_t start() const noexcept { return start_; }

    void request(frame_builder& frame) const noexcept {
        if (step_ != step::write) return frame.read(slaves_[reference_].station, esc_registers::dc_system_time);
        for (const auto& slave : slaves_.subspan(first_, last() - first_))
            if (takes_part(slave)) request(frame, slave);
    }

    progress reply(replies datagrams, time_point, const master_config&) noexcept {
        if (result_ = executed_by_one(datagrams); !result_) return progress::done;
        if (step_ == step::write) {
            first_ = last();
            return first_ < slaves_.size() ? progress::send : go(step::verify);
        }
        take_time(datagrams.front());
        if (step_ == step::verify) return time_ < start_ ? progress::done : late();
        start_ = ~std::uint64_t{0};
        for (auto& slave : slaves_) {
            if (!takes_part(slave)) continue;
            slave.start_time = sync_start(time_ + lead_, slave.sync);
            start_ = std::min(start_, slave.start_time);
        }
        return start_ == ~std::uint64_t{0} ? progress::done : go(step::write);
    }

  private:
    enum class step : std::uint8_t { read, write, verify };

    [[nodiscard]] static bool takes_part(const clock_record& slave) noexcept {
        return slave.has_clock() && slave.sync.assign_activate != 0;
    }
    // Behind the slaves of the present frame, which holds three that take part.
    [[nodiscard]] std::size_t last() const noexcept {
        std::size_t end = first_;
        for (std::size_t count = 0; end != slaves_.size(); ++end)
            if (takes_part(slaves_[end]) && ++count == 4) break;
        return end;
    }

    // The start time comes before the activation, which is in the same frame. The owner of the units is written only
    // where the slave is to have some of them: there are slaves that do not like it.
    static void request(frame_builder& frame, const clock_record& slave) noexcept {
        const auto station = slave.station;
        const auto assign = slave.sync.assign_activate;
        frame.write(station, esc_registers::dc_activation, {});
        if (slave.width == clock_width::bits_64)
            frame.write(station, esc_registers::dc_start_time, {slave.start_time});
        else
            frame.write(station, low_half(esc_registers::dc_start_time),
                        {static_cast<std::uint32_t>(slave.start_time)});
        frame.write(station, esc_registers::dc_sync0_cycle, {slave.sync.sync0_cycle});
        frame.write(station, esc_registers::dc_sync1_cycle, {slave.sync.sync1_delay});
        if ((assign & 0xFF) != 0) return frame.write(station, esc_registers::dc_assign_activate, {assign});
        const std::array on{static_cast<std::byte>(assign >> 8)};
        frame.add(command::fpwr, station, esc_registers::dc_activation.address, on);
    }

    void take_time(const datagram_view& back) noexcept {
        const auto time = back.value(esc_registers::dc_system_time).value;
        const bool is_wide = slaves_[reference_].width == clock_width::bits_64;
        time_ = is_wide ? time : extend_time(static_cast<std::uint32_t>(time), time_);
    }
    // Once more, with more time.
    progress late() noexcept {
        if (++attempts_ == max_attempts) {
            result_ = master_error{.code = master_errc::sync_late};
            return progress::done;
        }
        lead_ = lead_ * 2 + 1'000'000;
        return go(step::read);
    }
    progress go(step next) noexcept {
        step_ = next;
        first_ = 0;
        return progress::send;
    }

    static constexpr unsigned max_attempts = 4;

    std::span<clock_record> slaves_{};
    std::size_t reference_{};
    step step_{};
    std::size_t first_{}; // of the present frame
    std::uint64_t time_{};
    std::uint64_t lead_{};
    std::uint64_t start_{};
    unsigned attempts_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
