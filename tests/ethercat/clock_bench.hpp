// A master and a tree of emulated slaves with clocks that drift, in simulated time.
#pragma once

#include "ethercat/objects.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/slave_tree.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace jauscat::test {

/// One slave of a bench and its place in the tree.
struct bench_slave {
    ethercat::clock_width width = ethercat::clock_width::bits_64;
    std::size_t parent{}; ///< place; the first slave has none
    std::size_t parent_port{1};
    duration cable{100};
    ethercat::clock_error error{};
};

/// Slaves in a line; their clocks drift by up to 100 ppm, start anywhere, and are read in steps of `step` ns.
inline std::vector<bench_slave> line_of(std::size_t count, std::uint32_t seed, std::uint32_t step = 1) {
    std::mt19937 random{seed};
    std::uniform_int_distribution<std::int32_t> drift{-100'000, 100'000};
    std::uniform_int_distribution<std::int64_t> cable{50, 700};
    std::uniform_int_distribution<std::uint64_t> start{};
    std::vector<bench_slave> slaves(count);
    for (std::size_t i = 0; i != count; ++i)
        slaves[i] = {.parent = i == 0 ? 0 : i - 1,
                     .cable = duration{cable(random)},
                     .error = {.drift = drift(random), .start = start(random) >> 2, .step = step}};
    return slaves;
}

/// Slave `n`, from 0, has the station address 1001h + n.
class clock_bench {
  public:
    static constexpr std::uint64_t epoch = 800'000'000'000'000'000; ///< system time of the master at the start

    explicit clock_bench(std::span<const bench_slave> slaves, duration through = duration{300},
                         ethercat::slave_description description = {.vendor = 1}) {
        for (const auto& each : slaves) {
            description.clock = each.width;
            dictionaries_.emplace_back(description, objects_);
            auto& device = devices_.emplace_back(description, dictionaries_.back());
            device.set_clock_error(each.error);
            wires_.push_back(
                {.device = &device, .parent = each.parent, .parent_port = each.parent_port, .cable = each.cable});
        }
        tree_.emplace_back(wires_, through);
        clocks.resize(slaves.size());
        for (std::size_t i = 0; i != slaves.size(); ++i) {
            clocks[i].station = station(i);
            ethercat::frame_builder frame{buffer_};
            frame.add(ethercat::command::apwr, static_cast<std::uint16_t>(-static_cast<int>(i)), 0x0010,
                      ethercat::esc_word{station(i)});
            send(*frame.finish());
        }
    }

    static std::uint16_t station(std::size_t place) { return static_cast<std::uint16_t>(0x1001 + place); }

    /// The system time of the master.
    [[nodiscard]] std::uint64_t system_time() const {
        return epoch + static_cast<std::uint64_t>(now.time_since_epoch().count());
    }

    /// Sends a frame and waits until it is back.
    void send(std::span<std::byte> frame) { now = tree_.front().process(frame, now) + gap; }

    /// Runs a job to its end.
    template <class Job> typename Job::result_type run(const Job& job) {
        if (const auto started = master.start(job); !started) return started.error();
        while (!master.idle()) {
            master.on_time(now);
            if (const auto size = master.next_frame(buffer_, now); size != 0) {
                const auto frame = std::span{buffer_}.first(size);
                send(frame);
                master.on_frame(frame, now);
            } else {
                now = std::max(now + duration{1}, *master.next_event());
            }
        }
        return master.result<Job>();
    }
    ethercat::master_result<ethercat::clock_network> set_up(const ethercat::clock_options& options = {}) {
        return run(ethercat::set_up_clocks{.slaves = clocks, .system_time = system_time(), .options = options});
    }

    /// Brings the time of the slave with this address to all others. Gives the working counter.
    std::uint16_t distribute(std::uint16_t reference) {
        ethercat::frame_builder frame{buffer_};
        frame.add(ethercat::command::frmw, reference, 0x0910, ethercat::dc_time{system_time()});
        const auto bytes = *frame.finish();
        send(bytes);
        ethercat::frame_view view;
        return view.parse(bytes) ? (*view.begin()).working_counter : std::uint16_t{};
    }

    [[nodiscard]] ethercat::slave& device(std::size_t place) { return devices_[place]; }

    /// The difference of a slave's system time from that of another, at one instant.
    [[nodiscard]] std::int64_t difference(std::size_t place, std::size_t from = 0) const {
        const auto at = now + duration{1'000};
        const auto time = devices_[place].clock().system_time(at), other = devices_[from].clock().system_time(at);
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(time - other));
    }
    /// The largest difference between any two slaves with a clock, from place `first` on, at one instant.
    [[nodiscard]] std::int64_t spread(std::size_t first = 0) const {
        std::int64_t low = 0, high = 0;
        first += ethercat::reference_clock(std::span{clocks}.subspan(first));
        for (std::size_t i = first; i != clocks.size(); ++i) {
            if (!clocks[i].has_clock()) continue;
            low = std::min(low, difference(i, first));
            high = std::max(high, difference(i, first));
        }
        return high - low;
    }

    time_point now{};
    duration gap{std::chrono::microseconds{20}}; ///< between a frame's return and the next one
    ethercat::master_for<64> master{};
    std::vector<ethercat::clock_record> clocks{};

  private:
    objects objects_{};
    std::deque<ethercat::standard_objects> dictionaries_{};
    std::deque<ethercat::slave> devices_{};
    std::vector<ethercat::wired_slave> wires_{};
    std::vector<ethercat::slave_tree> tree_{}; // one
    std::array<std::byte, ethercat::max_frame_size> buffer_{};
};

} // namespace jauscat::test
