// The functions of ring_clocks.
#pragma once
#include <jauscat/bridge/ring_clocks.hpp>

namespace jauscat::bridging {

JAUSCAT_FUNCTION void ring_clocks::use(const ethercat::clock_network& network, std::uint64_t system_time,
                                       duration period) noexcept {
    std::ranges::copy(chosen(), used_.begin());
    used_count_ = next_count_;
    network_ = network;
    if (cycle_ && std::ranges::any_of(records(), &ethercat::clock_record::runs))
        cycle_->set_slaves(records(), network_);
    else
        begin(system_time, period);
}

JAUSCAT_FUNCTION void ring_clocks::set_period(duration period) noexcept {
    if (!cycle_ || period == period_) return;
    if (period == duration{}) return stop();
    const auto reference = cycle_->reference();
    begin(cycle_->reference_time(), period);
    cycle_->set_reference(reference);
}

JAUSCAT_FUNCTION void ring_clocks::leave_out(std::uint16_t station) noexcept {
    if (station != 0 && !is_left_out(station)) left_out_[left_out_count_++ % left_out_.size()] = station;
}

JAUSCAT_FUNCTION void ring_clocks::leave_out_none() noexcept {
    left_out_ = {};
    left_out_count_ = 0;
}

JAUSCAT_FUNCTION ethercat::clock_record* ring_clocks::find(std::uint16_t station) const noexcept {
    const auto found = std::ranges::find(records(), station, &ethercat::clock_record::station);
    return found == records().end() ? nullptr : &*found;
}

JAUSCAT_FUNCTION void ring_clocks::lost(std::uint16_t station) noexcept {
    if (cycle_ && !cycle_->is_lost() && records()[cycle_->reference()].station == station) cycle_->replace_reference();
}

JAUSCAT_FUNCTION std::size_t ring_clocks::next_frame(std::span<std::byte> frame, time_point now,
                                                     duration late) noexcept {
    if (!cycle_ || !std::exchange(is_due_, false)) return 0;
    return cycle_->next_frame(frame, now, late);
}

JAUSCAT_FUNCTION void ring_clocks::begin(std::uint64_t system_time, duration period) noexcept {
    period_ = period;
    cycle_.emplace(records(), network_, system_time,
                   ethercat::clock_watch_options{.control = ethercat::cycle_control_options::of_period(period)});
}

JAUSCAT_FUNCTION bool ring_clocks::is_left_out(std::uint16_t station) const noexcept {
    return std::ranges::find(left_out_, station) != left_out_.end();
}

} // namespace jauscat::bridging
