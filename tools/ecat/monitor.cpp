// monitor: frames, working counters, error counters of ports.
#include "ecat/arguments.hpp"
#include "ecat/value.hpp"
#include <jauscat/net/link/latency_histogram.hpp>
#include <jauscat/net/now.hpp>

#include <array>
#include <iostream>
#include <memory>

namespace ecat {

namespace registers = ethercat::esc_registers;
using ethercat::command;
using std::chrono::microseconds;

namespace {

struct slave_ports {
    std::uint16_t position{};
    std::uint8_t ports{};
    jauscat::ethercat::error_counters before{};
    jauscat::ethercat::error_counters after{};
};

bool has_port(const slave_ports& slave, unsigned port) { return (slave.ports >> 2 * port & 3) != 0; }

unsigned grown(const slave_ports& slave, unsigned port) {
    unsigned sum = 0;
    const auto add = [&](unsigned before, unsigned after) {
        sum += after >= before ? after - before : after; // cleared meanwhile
    };
    const auto &before = slave.before, &after = slave.after;
    add(before.ports[port].invalid_frames, after.ports[port].invalid_frames);
    add(before.ports[port].receive_errors, after.ports[port].receive_errors);
    add(before.forwarded_errors[port], after.forwarded_errors[port]);
    add(before.lost_links[port], after.lost_links[port]);
    return sum;
}

struct measurement {
    jauscat::net::latency_histogram round_trip{};
    std::uint64_t frames{}, lost{}, incomplete{};
    std::uint16_t least{0xFFFF}; ///< working counter
};

double in_us(std::chrono::nanoseconds time) { return std::chrono::duration<double, std::micro>{time}.count(); }

list histogram_of(const measurement& all) {
    list made;
    all.round_trip.for_each_bucket([&](auto from, auto below, std::uint64_t count) {
        made.emplace_back(record{{"from_us", in_us(from)}, {"below_us", in_us(below)}, {"frames", count}});
    });
    return made;
}

} // namespace

int monitor(const arguments& given) {
    ring on{given.link};
    on.guard();
    const auto slaves = on.slaves();
    std::vector<slave_ports> ports;
    for (std::uint16_t i = 0; i != slaves; ++i) {
        ports.push_back({.position = i, .ports = on.read(i, registers::description).ports});
        ports.back().before = on.read(i, registers::error_counters);
    }

    const auto period = given.period == given.period.zero() ? microseconds{1000} : given.period;
    const auto all = std::make_unique<measurement>();
    const auto lost_before = on.lost;
    const auto begun = jauscat::net::now();
    const auto end = begun + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                 std::chrono::duration<double>{given.seconds.value_or(1e8)});
    {
        progress_line progress;
        for (auto due = begun; !stop_requested() && due < end; due = std::max(due + period, jauscat::net::now())) {
            sleep_until(due);
            datagram one{command::brd, 0, registers::al_status.address, bytes(2)};
            const auto sent = jauscat::net::now();
            ++all->frames;
            if (on.try_exchange({&one, 1}, on.options().frame_timeout)) {
                all->round_trip.add(jauscat::net::now() - sent);
                all->least = std::min(all->least, one.working_counter);
                if (one.working_counter != slaves) ++all->incomplete;
            }
            all->lost = on.lost - lost_before;
            progress.show(std::to_string(all->frames) + " frames, " + std::to_string(all->lost) + " lost, " +
                          std::to_string(all->incomplete) + " with another working counter than " +
                          std::to_string(slaves) + " (Ctrl-C ends)");
        }
    }
    const auto seconds = std::chrono::duration<double>{jauscat::net::now() - begun}.count();

    bool is_fine = all->lost == 0 && all->incomplete == 0 && all->round_trip.count() != 0;
    std::vector<record> rows;
    list port_list;
    for (auto& each : ports) {
        std::array read{read_of(each.position, registers::error_counters.address, registers::error_counters.size)};
        if (!on.try_exchange(read, on.options().frame_timeout) || read[0].working_counter != 1) {
            note(on.name_of(each.position) + ": its error counters cannot be read at the end: it does not answer");
            is_fine = false;
            continue;
        }
        static_cast<void>(jauscat::wire::decode(each.after, read[0].data)); // of its size
        for (unsigned port = 0; port != 4; ++port) {
            if (!has_port(each, port)) continue;
            const auto more = grown(each, port);
            if (more != 0) is_fine = false;
            rows.push_back({{"position", each.position},
                            {"port", port},
                            {"invalid_frames", each.after.ports[port].invalid_frames},
                            {"receive_errors", each.after.ports[port].receive_errors},
                            {"forwarded_errors", each.after.forwarded_errors[port]},
                            {"lost_links", each.after.lost_links[port]},
                            {"processing_errors", each.after.processing_errors},
                            {"pdi_errors", each.after.pdi_errors},
                            {"new", more}});
            port_list.emplace_back(rows.back());
        }
    }
    const auto& times = all->round_trip;
    if (given.is_json) {
        print_json(list{record{
            {"seconds", seconds},
            {"frames", all->frames},
            {"lost", all->lost},
            {"foreign", on.foreign},
            {"slaves", slaves},
            {"working_counter_least", times.count() != 0 ? value{all->least} : value{}},
            {"working_counter_wrong", all->incomplete},
            {"round_trip_us", record{{"min", in_us(times.min())},
                                     {"p50", in_us(times.quantile(0.5))},
                                     {"p99", in_us(times.quantile(0.99))},
                                     {"max", in_us(times.max())}}},
            {"histogram", histogram_of(*all)},
            {"ports", port_list},
        }});
        return is_fine ? success : failed;
    }
    std::cout << "frames            " << all->frames << " in " << seconds << " s\n"
              << "lost              " << all->lost << "\n"
              << "foreign           " << on.foreign << "\n"
              << "working counter   " << slaves << " expected, least "
              << (times.count() != 0 ? std::to_string(all->least) : "-") << ", another one in " << all->incomplete
              << " frames\n"
              << "round trip        min " << in_us(times.min()) << " us, p50 " << in_us(times.quantile(0.5))
              << " us, p99 " << in_us(times.quantile(0.99)) << " us, max " << in_us(times.max()) << " us\n\n";
    times.print(std::cout);
    std::cout << "\n";
    print_table(rows);
    return is_fine ? success : failed;
}

} // namespace ecat
