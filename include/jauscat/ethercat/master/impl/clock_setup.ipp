// The functions of clock_setup.
#pragma once
#include <jauscat/ethercat/master/clock_setup.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void clock_setup::request(frame_builder& frame) const noexcept {
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

JAUSCAT_FUNCTION progress clock_setup::reply(replies datagrams, time_point now, const master_config&) noexcept {
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

JAUSCAT_FUNCTION std::span<clock_record> clock_setup::batch() const noexcept {
    const auto left = slaves_.subspan(std::min(first_, slaves_.size()));
    const std::size_t each = step_ == step::check ? 1 : 3;
    return left.first(std::min(left.size(), datagrams_per_frame / each));
}

JAUSCAT_FUNCTION std::size_t clock_setup::count(const clock_record& slave) const noexcept {
    switch (step_) {
    case step::look: return slave.runs ? 2 : 3;
    case step::write: return slave.runs ? 1 : 3;
    case step::check: return 1;
    default: return 3;
    }
}

JAUSCAT_FUNCTION void clock_setup::request(frame_builder& frame, const clock_record& slave) const noexcept {
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

JAUSCAT_FUNCTION master_result<> clock_setup::take(clock_record& slave, replies datagrams) noexcept {
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

JAUSCAT_FUNCTION progress clock_setup::step_done() noexcept {
    switch (step_) {
    case step::look: return go(step::latch);
    case step::read: return compute();
    case step::write: return drift(options_.drift_frames);
    default: return checked();
    }
}

JAUSCAT_FUNCTION progress clock_setup::compute() noexcept {
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

JAUSCAT_FUNCTION std::uint64_t clock_setup::time_of_latch() const noexcept {
    const auto first = std::ranges::find_if(slaves_, [](const auto& each) { return each.has_clock() && each.runs; });
    if (first == slaves_.end()) return latched_;
    const auto time = first->processing_time + static_cast<std::uint64_t>(first->offset) - first->delay;
    return first->width == clock_width::bits_64 ? time : extend_time(static_cast<std::uint32_t>(time), latched_);
}

JAUSCAT_FUNCTION progress clock_setup::drift(unsigned frames) noexcept {
    drift_left_ = frames;
    return go(frames != 0 ? step::drift : step::check);
}

JAUSCAT_FUNCTION progress clock_setup::drifted(const datagram_view& back) noexcept {
    if (back.working_counter == 0) return fail({.code = master_errc::working_counter});
    network_.working_counter = back.working_counter;
    const auto time = back.value(esc_registers::dc_system_time).value;
    reference_time_ = reference().width == clock_width::bits_64
                          ? time
                          : extend_time(static_cast<std::uint32_t>(time), reference_time_);
    return --drift_left_ != 0 ? progress::send : go(step::check);
}

JAUSCAT_FUNCTION progress clock_setup::checked() noexcept {
    if (network_.difference <= options_.limit) return progress::done;
    if (repeats_++ != options_.repeats) return drift(std::max(options_.drift_frames / 10, 1u));
    const auto worst = std::ranges::max_element(slaves_, {}, [this](const clock_record& slave) {
        return &slave == &reference() || !slave.has_clock() ? 0 : slave.difference.magnitude;
    });
    return fail(
        {.code = master_errc::clock_unsettled, .station = worst->station, .nanoseconds = worst->difference.magnitude});
}

JAUSCAT_FUNCTION progress clock_setup::go(step next) noexcept {
    step_ = next;
    first_ = 0;
    network_.difference = 0;
    return progress::send;
}

JAUSCAT_FUNCTION progress clock_setup::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

JAUSCAT_FUNCTION progress clock_setup::fail_at(std::uint16_t station) noexcept {
    auto error = result_.error();
    error.station = station;
    return fail(error);
}

} // namespace jauscat::ethercat
