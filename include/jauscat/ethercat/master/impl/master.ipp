// The functions of master.
#pragma once
#include <jauscat/ethercat/master/master.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void master::reset(const master_config& config) noexcept {
    frames_ = frame_traffic{config};
    ring_.slaves.clear();
    machine_ = {};
    runs_ = false;
    error_ = {};
}

JAUSCAT_FUNCTION void master::cancel(master_errc error) noexcept {
    if (idle()) return;
    master_error ended{.code = error};
    with_machine([&](auto& machine) { ended = machine.cancel(ended); });
    finish(ended);
}

JAUSCAT_FUNCTION bool master::withdraw(master_errc error) noexcept {
    if (idle() || frames_.waits()) return false;
    bool has_asked = true;
    with_machine([&](auto& machine) {
        if constexpr (requires { machine.has_asked(); }) has_asked = machine.has_asked();
    });
    if (!has_asked) cancel(error);
    return !has_asked;
}

JAUSCAT_FUNCTION bool master::lend(std::uint16_t station, master& other) noexcept {
    auto* const slave = ring_.slaves.find(station);
    if (slave == nullptr) return false;
    other.ring_.slaves.clear();
    other.ring_.slaves.add(*slave);
    slave->is_lent = true;
    return true;
}

JAUSCAT_FUNCTION void master::take_back(const master& other) noexcept {
    for (const auto& each : other.slaves())
        if (auto* const slave = ring_.slaves.find(each.station); slave != nullptr && slave->is_lent)
            slave->return_mailbox(each);
}

JAUSCAT_FUNCTION bool master::set_timeouts(std::uint16_t station, const slave_timeouts& timeouts) noexcept {
    auto* const slave = ring_.slaves.find(station);
    if (slave != nullptr) slave->timeouts = timeouts;
    return slave != nullptr;
}

JAUSCAT_FUNCTION void master::clear_emergencies(std::uint16_t station) noexcept {
    if (auto* const slave = ring_.slaves.find(station)) slave->emergencies.clear();
}

JAUSCAT_FUNCTION std::size_t master::next_frame(std::span<std::byte> out, time_point now) noexcept {
    if (idle() || !frames_.may_send(now)) return 0;
    frame_builder frame{out, frames_.next_index()};
    with_machine([&](auto& machine) { machine.request(frame); });
    const auto finished = frame.finish();
    if (!finished) {
        cancel(master_errc::no_space);
        return 0;
    }
    frames_.sent(*finished, now);
    return finished->size();
}

JAUSCAT_FUNCTION bool master::on_frame(std::span<const std::byte> frame, time_point now) noexcept {
    const bool was_taken = take(frame, now);
    if (!was_taken) frames_.ignore(frame);
    return was_taken;
}

JAUSCAT_FUNCTION bool master::take(std::span<const std::byte> frame, time_point now) noexcept {
    bool was_refused = false;
    if (!idle()) with_machine([&](auto& machine) { was_refused = machine.was_refused(); });
    const auto datagrams = frames_.take(frame, was_refused);
    if (datagrams.empty()) return false;
    const auto& config = frames_.config();
    progress next{};
    with_machine([&](auto& machine) { next = machine.reply(datagrams, now, config); });
    if (next == progress::wait) frames_.wait_until(saturating_add(now, config.poll_interval));
    if (next == progress::done) with_machine([&](auto& machine) { finish(machine.complete(ring_)); });
    return true;
}

JAUSCAT_FUNCTION void master::on_time(time_point now) noexcept {
    if (!frames_.is_late(now)) return;
    bool repeats = false;
    with_machine([&](auto& machine) { repeats = machine.is_repeatable(); });
    if (!frames_.lose(repeats)) return cancel(master_errc::no_reply);
    with_machine([](auto& machine) { machine.lost(); });
}

JAUSCAT_FUNCTION std::optional<time_point> master::next_event() const noexcept {
    if (idle()) return std::nullopt;
    return frames_.next_event();
}

JAUSCAT_FUNCTION void master::finish(const master_error& error) noexcept {
    error_ = error;
    runs_ = false;
    frames_.give_up();
}

} // namespace jauscat::ethercat
