// The functions of sync_setup.
#pragma once
#include <jauscat/ethercat/master/sync_setup.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION sync_setup::sync_setup(const start_sync& job) noexcept
    : slaves_{job.slaves},
      reference_{reference_clock(job.slaves)},
      time_{job.system_time},
      lead_{static_cast<std::uint64_t>(std::max(job.lead, job.lead.zero()).count())} {}

JAUSCAT_FUNCTION void sync_setup::request(frame_builder& frame) const noexcept {
    if (step_ != step::write) return frame.read(slaves_[reference_].station, esc_registers::dc_system_time);
    for (const auto& slave : slaves_.subspan(first_, last() - first_))
        if (takes_part(slave)) request(frame, slave);
}

JAUSCAT_FUNCTION progress sync_setup::reply(replies datagrams, time_point, const master_config&) noexcept {
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

JAUSCAT_FUNCTION bool sync_setup::takes_part(const clock_record& slave) noexcept {
    return slave.has_clock() && slave.sync.assign_activate != 0;
}

JAUSCAT_FUNCTION std::size_t sync_setup::last() const noexcept {
    std::size_t end = first_;
    for (std::size_t count = 0; end != slaves_.size(); ++end)
        if (takes_part(slaves_[end]) && ++count == 4) break;
    return end;
}

JAUSCAT_FUNCTION void sync_setup::request(frame_builder& frame, const clock_record& slave) noexcept {
    const auto station = slave.station;
    const auto assign = slave.sync.assign_activate;
    frame.write(station, esc_registers::dc_activation, {});
    if (slave.width == clock_width::bits_64)
        frame.write(station, esc_registers::dc_start_time, {slave.start_time});
    else
        frame.write(station, low_half(esc_registers::dc_start_time), {static_cast<std::uint32_t>(slave.start_time)});
    frame.write(station, esc_registers::dc_sync0_cycle, {slave.sync.sync0_cycle});
    frame.write(station, esc_registers::dc_sync1_cycle, {slave.sync.sync1_delay});
    if ((assign & 0xFF) != 0) return frame.write(station, esc_registers::dc_assign_activate, {assign});
    const std::array on{static_cast<std::byte>(assign >> 8)};
    frame.add(command::fpwr, station, esc_registers::dc_activation.address, on);
}

JAUSCAT_FUNCTION void sync_setup::take_time(const datagram_view& back) noexcept {
    const auto time = back.value(esc_registers::dc_system_time).value;
    const bool is_wide = slaves_[reference_].width == clock_width::bits_64;
    time_ = is_wide ? time : extend_time(static_cast<std::uint32_t>(time), time_);
}

JAUSCAT_FUNCTION progress sync_setup::late() noexcept {
    if (++attempts_ == max_attempts) {
        result_ = master_error{.code = master_errc::sync_late};
        return progress::done;
    }
    lead_ = lead_ * 2 + 1'000'000;
    return go(step::read);
}

JAUSCAT_FUNCTION progress sync_setup::go(step next) noexcept {
    step_ = next;
    first_ = 0;
    return progress::send;
}

} // namespace jauscat::ethercat
