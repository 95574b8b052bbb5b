// The functions of clock_cycle.
#pragma once
#include <jauscat/ethercat/master/clock_cycle.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION clock_cycle::clock_cycle(std::span<const clock_record> slaves, const clock_network& network,
                                          std::uint64_t system_time, const clock_watch_options& options) noexcept
    : slaves_{slaves},
      reference_{reference_clock(slaves)},
      options_{options},
      control_{options.control},
      time_{system_time},
      expected_counter_{network.working_counter} {}

JAUSCAT_FUNCTION std::size_t clock_cycle::next_frame(std::span<std::byte> out, time_point now, duration late) noexcept {
    late_ = late;
    if (outstanding_.waits()) ++statistics_.lost;
    outstanding_.forget();
    has_time_ = returned_ = false;
    estimate(now);
    if (is_lost()) return 0;
    frame_builder frame{out, ++index_};
    // Slaves that the reference clock's time does not reach take the estimate instead.
    frame.add(command::frmw, slaves_[reference_].station, esc_registers::dc_system_time.address, dc_time{sent_time()});
    frame.read_all(esc_registers::dc_difference);
    const auto finished = frame.finish();
    if (!finished) return 0;
    outstanding_.sent(*finished, now);
    ++statistics_.sent;
    return finished->size();
}

JAUSCAT_FUNCTION bool clock_cycle::on_frame(std::span<const std::byte> frame) noexcept {
    frame_view view;
    if (!view.parse(frame) || !begins_as_ours(view)) return false;
    const auto datagrams = outstanding_.waits() ? outstanding_.match(view) : replies{};
    if (datagrams.empty()) return outstanding_.may_be_own(view);
    returned_ = true;
    working_counter_ = datagrams[0].working_counter;
    take_time(datagrams[0].value(esc_registers::dc_system_time).value);
    if (datagrams[1].working_counter != 0) judge(datagrams[1].value(esc_registers::dc_difference).magnitude);
    return true;
}

JAUSCAT_FUNCTION duration clock_cycle::end_cycle() noexcept {
    if (returned_ && !has_time_) silent();
    if (has_time_) silent_ = 0;
    return has_time_ ? control_.on_time(time_, late_) : control_.on_missing();
}

JAUSCAT_FUNCTION void clock_cycle::set_slaves(std::span<const clock_record> slaves,
                                              const clock_network& network) noexcept {
    slaves_ = slaves;
    expected_counter_ = network.working_counter;
    set_reference(reference_clock(slaves));
}

JAUSCAT_FUNCTION void clock_cycle::set_reference(std::size_t place) noexcept {
    reference_ = place;
    silent_ = 0;
}

JAUSCAT_FUNCTION void clock_cycle::replace_reference() noexcept {
    silent_ = 0;
    ++reference_;
    while (reference_ != slaves_.size() && !slaves_[reference_].has_clock()) ++reference_;
    if (!is_lost()) ++statistics_.takeovers;
}

JAUSCAT_FUNCTION bool clock_cycle::begins_as_ours(const frame_view& frame) noexcept {
    const auto first = frame.begin();
    return (*first).header.cmd == command::frmw && (*first).header.more;
}

JAUSCAT_FUNCTION void clock_cycle::estimate(time_point now) noexcept {
    const std::int64_t passed = estimates_ ? (now - estimated_at_).count() : 0;
    time_ += static_cast<std::uint64_t>(passed - passed / 1'000 * control_.drift() / 1'000'000);
    estimated_at_ = now;
    estimates_ = true;
}

JAUSCAT_FUNCTION void clock_cycle::take_time(std::uint64_t time) noexcept {
    if (time == sent_time()) return;
    has_time_ = true;
    const bool is_wide = slaves_[reference_].width == clock_width::bits_64;
    time_ = is_wide ? time : extend_time(static_cast<std::uint32_t>(time), time_);
}

JAUSCAT_FUNCTION void clock_cycle::judge(std::uint32_t difference) noexcept {
    difference_ = difference;
    above_ = difference > options_.warning_limit ? above_ + 1 : 0;
    agreement_ = difference > options_.error_limit   ? clock_agreement::error
                 : above_ >= options_.warning_cycles ? clock_agreement::warning
                                                     : clock_agreement::good;
}

JAUSCAT_FUNCTION void clock_cycle::silent() noexcept {
    ++statistics_.unanswered;
    if (++silent_ >= options_.silent_cycles) replace_reference();
}

} // namespace jauscat::ethercat
