// The functions of clock_topology.
#pragma once
#include <jauscat/ethercat/master/clock_topology.hpp>

namespace jauscat::ethercat::detail {

JAUSCAT_CONSTEXPR std::size_t open_before(const clock_record& slave, std::size_t place) noexcept {
    while (place-- != 1)
        if (slave.open[port_order[place]]) return port_order[place];
    return 0;
}

JAUSCAT_CONSTEXPR std::size_t place_of(std::size_t port) noexcept {
    constexpr std::array<std::size_t, 4> places{0, 2, 3, 1};
    return places[port];
}

JAUSCAT_CONSTEXPR std::uint32_t loop_time(const clock_record& slave) noexcept {
    return slave.received[open_before(slave, port_order.size())] - slave.received[0];
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR std::size_t reference_clock(std::span<const clock_record> slaves) noexcept {
    std::size_t first = 0;
    while (first != slaves.size() && !slaves[first].has_clock()) ++first;
    return first;
}

JAUSCAT_CONSTEXPR master_result<> find_parents(std::span<clock_record> slaves) noexcept {
    const auto take_port = [](clock_record& slave, std::array<bool, 4>& taken) -> std::uint8_t {
        for (const auto port : std::span{detail::port_order}.subspan(1)) {
            if (!slave.open[port] || taken[port]) continue;
            taken[port] = true;
            return port;
        }
        return 0;
    };
    // Ports up to that of a slave's last child are taken.
    const auto taken_of = [&](std::size_t of, std::size_t until) {
        std::array<bool, 4> taken{};
        for (std::size_t i = of + 1; i < until; ++i)
            if (slaves[i].parent == of) taken[slaves[i].parent_port] = true;
        return taken;
    };
    for (std::size_t i = 0; i != slaves.size(); ++i) {
        auto& slave = slaves[i];
        slave.parent = clock_record::no_parent;
        slave.parent_port = 0;
        if (i == 0) continue;
        std::size_t candidate = i - 1;
        for (;;) {
            auto taken = taken_of(candidate, i);
            if (const auto port = take_port(slaves[candidate], taken); port != 0) {
                slave.parent = static_cast<std::uint16_t>(candidate);
                slave.parent_port = port;
                break;
            }
            if (slaves[candidate].parent == clock_record::no_parent)
                return master_error{.code = master_errc::clock_topology, .station = slave.station};
            candidate = slaves[candidate].parent;
        }
    }
    return {};
}

JAUSCAT_CONSTEXPR master_result<> find_delays(std::span<clock_record> slaves,
                                              const clock_delay_options& options) noexcept {
    const auto reference = reference_clock(slaves);
    for (std::size_t i = 0; i != slaves.size(); ++i) {
        auto& slave = slaves[i];
        slave.delay = 0;
        if (!slave.has_clock() || i == reference) continue;
        const clock_record* below = &slave; // the child, at the ancestor, of the branch that this slave is in
        std::size_t ancestor = slave.parent;
        while (ancestor != clock_record::no_parent && !slaves[ancestor].has_clock()) {
            if (slaves[ancestor].open_ports() > 2) ancestor = clock_record::no_parent;
            if (ancestor == clock_record::no_parent) break;
            below = &slaves[ancestor];
            ancestor = below->parent;
        }
        if (ancestor == clock_record::no_parent)
            return master_error{.code = master_errc::clock_topology, .station = slave.station};
        const auto& from = slaves[ancestor];
        const auto before = detail::open_before(from, detail::place_of(below->parent_port));
        const std::uint32_t loop = from.received[below->parent_port] - from.received[before];
        // A frame leaves the ancestor's first branch through its processing unit, and comes back past this slave's. In
        // a later branch, and at the end of a line, it is the other way round.
        const bool first_branch = before == 0, is_end = slave.open_ports() == 1;
        const std::int32_t unequal = (first_branch ? 1 : 0) - (is_end ? 1 : 0);
        const auto both_ways =
            static_cast<std::int32_t>(loop - detail::loop_time(slave)) + unequal * options.processing_difference;
        // Clocks of coarse steps may measure a short cable as slightly below 0.
        constexpr std::int32_t coarse = 200;
        const auto cable = both_ways < 0 && both_ways > -coarse ? 0u : static_cast<std::uint32_t>(both_ways) / 2;
        if (cable > options.longest_cable)
            return master_error{.code = master_errc::clock_delay, .station = slave.station, .nanoseconds = cable};
        slave.delay = from.delay + (from.received[before] - from.received[0]) + cable;
    }
    return {};
}

JAUSCAT_CONSTEXPR std::uint64_t extend_time(std::uint32_t low, std::uint64_t estimate) noexcept {
    const auto ahead = static_cast<std::int32_t>(low - static_cast<std::uint32_t>(estimate));
    return estimate + static_cast<std::uint64_t>(std::int64_t{ahead});
}

} // namespace jauscat::ethercat
