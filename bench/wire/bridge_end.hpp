// A bridge with a component for each of several slaves, on the interface jc0. Messages are acknowledged when the
// slave's mailbox has confirmed them.
#pragma once

#include "master_end.hpp"
#include <jauscat/bridge/ring.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

namespace wire_bench {

namespace bridging = jauscat::bridging;
namespace jaus = jauscat::jaus;

class bridge_end {
  public:
    bridge_end(std::size_t slaves, nanoseconds busy_poll) : link_{busy_poll}, acknowledged_(slaves) {
        for (std::size_t i = 0; i != slaves; ++i) {
            const auto station = static_cast<std::uint16_t>(first_station + i);
            const bridging::slave_identity identity{.subsystem = 1, .station = station};
            exchanges_.emplace_back(identity);
            fronts_.emplace_back(
                bridging::slave_options{.position = static_cast<std::uint16_t>(i), .identity = identity},
                exchanges_.back(), options_, memories_.emplace_back(), bridging::observer{});
            units_.emplace_back(address_of(i), fronts_.back());
            if (!bus_.add(fronts_.back())) throw std::runtime_error{"more slaves than the bridge has memory for"};
        }
        run_until(std::chrono::seconds{20}, "the slaves are not ready", [&] {
            return std::ranges::all_of(units_, [](const auto& each) {
                return each.state() == jaus::primary_status_code::ready && each.stops().settled();
            });
        });
    }

    /// A Set Wrench Effort to each slave: to all at once, or to one after the other. Until all are acknowledged.
    void command_all(measured& into, bool at_once) {
        const auto cpu = cpu_time();
        link_.sent = {};
        ++sequence_number_;
        acknowledged_.assign(units_.size(), false);
        const auto begun = jauscat::net::now();
        if (at_once) {
            for (std::size_t i = 0; i != units_.size(); ++i) command(i);
            wait_for(units_.size());
        } else {
            for (std::size_t i = 0; i != units_.size(); ++i) {
                command(i);
                wait_for(i + 1);
            }
        }
        into.times.add(jauscat::net::now() - begun);
        into.cpu += cpu_time() - cpu;
        into.sent.frames += link_.sent.frames;
        into.sent.bytes += link_.sent.bytes;
        into.sent.wire += link_.sent.wire;
        // A component remembers each acknowledged message for 2 s, and takes no more from one sender than half of its
        // memory holds: 2048 in 2 s.
        constexpr std::chrono::microseconds pause{1'200};
        drive_until(begun + pause, [] { return false; });
    }

  private:
    static constexpr std::size_t first_station = 2;
    static constexpr jaus::address operator_unit{.instance = 1, .component = 32, .node = 1, .subsystem = 2};

    static jaus::address address_of(std::size_t i) {
        return {.instance = 1, .component = 33, .node = static_cast<std::uint8_t>(first_station + i), .subsystem = 1};
    }
    void command(std::size_t i) {
        const jaus::header head{.ack_nak = jaus::ack_nak::request,
                                .command_code = jaus::command_code_of<jaus::set_wrench_effort>,
                                .destination = address_of(i),
                                .source = operator_unit,
                                .sequence_number = sequence_number_};
        std::array<std::byte, 64> room{};
        const auto body = jauscat::wire::encode(
            jaus::set_wrench_effort{.propulsive_linear_effort_x = 1, .resistive_linear_effort_x = 2}, room);
        const auto now = jauscat::net::now();
        units_[i].on_message(head, *body, now, out_,
                             [](const jaus::header&, auto) { return jaus::message_outcome::unhandled; });
        bus_.on_time(now, out_);
    }
    void wait_for(std::size_t answers) {
        run_until(std::chrono::seconds{2}, "a command was not acknowledged",
                  [&] { return static_cast<std::size_t>(std::ranges::count(acknowledged_, true)) == answers; });
    }
    void run_until(nanoseconds limit, const char* otherwise, auto&& done) {
        if (!drive_until(jauscat::net::now() + limit, done)) throw std::runtime_error{otherwise};
    }
    // False: not by then.
    bool drive_until(jauscat::time_point end, auto&& done) {
        while (!done()) {
            auto now = jauscat::net::now();
            if (now >= end) return false;
            while (const auto size = bus_.next_frame(buffer_, now))
                if (!link_.send(std::span{buffer_}.first(size))) bus_.not_sent();
            auto wake = std::min(end, bus_.next_event().value_or(end));
            for (const auto& each : units_) wake = std::min(wake, each.next_event().value_or(end));
            const auto wait = wake > now ? wake - now : nanoseconds{}; // the earliest event is time_point::min()
            const auto received = link_.receive(buffer_, wait);
            now = jauscat::net::now();
            if (received != 0) bus_.on_frame(std::span{buffer_}.first(received), now, out_);
            for (auto& each : units_) each.on_time(now, out_);
            bus_.on_time(now, out_);
        }
        return true;
    }
    void take(std::span<const std::byte> message) {
        const auto head = jaus::split(message).header;
        if (head.ack_nak != jaus::ack_nak::ack || head.sequence_number != sequence_number_) return;
        const auto from = std::size_t{head.source.node} - first_station;
        if (from < acknowledged_.size()) acknowledged_[from] = true;
    }
    struct sink {
        bridge_end& mine;
        void operator()(std::span<const std::byte> message) const { mine.take(message); }
    };

    bridging::bridge_options options_ = bridging::at_rest_within(bridging::at_rest_by_mailbox);
    counting_link link_;
    std::array<std::byte, ethercat::max_frame_size> buffer_{};
    std::deque<bridging::order_memory<16, 256>> memories_{};
    std::deque<bridging::exchange_under<jauscat::translation::self_contained_table>> exchanges_{};
    std::deque<bridging::slave_front> fronts_{};
    std::deque<bridging::component> units_{};
    bridging::ring_for<8, 64> bus_{options_};
    std::uint16_t sequence_number_{};
    std::vector<bool> acknowledged_;
    sink sink_{*this};
    jaus::message_sink out_{sink_};
};

} // namespace wire_bench
