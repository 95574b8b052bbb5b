// The functions of slave_tree.
#pragma once
#include <jauscat/ethercat/slave/slave_tree.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave_tree::slave_tree(std::span<wired_slave> slaves, duration through) noexcept
    : slaves_{slaves}, through_{through} {
    for (auto& each : slaves)
        for (std::size_t port = 1; port != 4; ++port) each.device->set_connected(port, false);
    for (auto& each : slaves.subspan(slaves.empty() ? 0 : 1))
        slaves[each.parent].device->set_connected(each.parent_port, true);
}

JAUSCAT_FUNCTION time_point slave_tree::process(std::span<std::byte> frame, time_point now) noexcept {
    const auto back = pass(frame, now);
    for (auto& each : slaves_) each.device->work();
    return back;
}

JAUSCAT_FUNCTION time_point slave_tree::pass(std::span<std::byte> frame, time_point now) noexcept {
    for (std::size_t i = 0; i != slaves_.size(); ++i) {
        if (i != 0) now = climb(i - 1, slaves_[i].parent, now);
        now += slaves_[i].cable;
        slaves_[i].device->pass(frame, now);
        now += through_;
    }
    if (slaves_.empty()) return now;
    return climb(slaves_.size() - 1, 0, now) + slaves_.front().cable;
}

JAUSCAT_FUNCTION time_point slave_tree::climb(std::size_t from, std::size_t to, time_point now) noexcept {
    for (; from != to && from != 0; from = slaves_[from].parent) {
        const auto& child = slaves_[from];
        now += child.cable;
        slaves_[child.parent].device->frame_returned(child.parent_port, now);
        now += through_;
    }
    return now;
}

} // namespace jauscat::ethercat
