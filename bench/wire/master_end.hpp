// A master for many slaves on the interface jc0: bring-up and cycles, with the frames that they take.
#pragma once

#include "bare_socket.hpp"
#include "report.hpp"
#include "slave_process.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/net/link/cycle_runner.hpp>
#include <jauscat/net/link/run_master.hpp>

namespace wire_bench {

using jauscat::net::cycle_order;

/// Frames, their bytes, and the time that these take at 100 Mbit/s with preamble, check sequence and gap.
struct traffic {
    std::uint64_t frames{};
    std::uint64_t bytes{};
    nanoseconds wire{};

    void add(std::size_t size) noexcept {
        constexpr std::size_t around = 24;
        constexpr nanoseconds each_byte{80};
        const auto padded = std::max(size, ethercat::min_frame_size);
        ++frames;
        bytes += padded;
        wire += each_byte * static_cast<std::int64_t>(padded + around);
    }
};

/// Counts the frames that go out. Models the link concept.
class counting_link {
  public:
    explicit counting_link(nanoseconds busy_poll) { link_.busy_poll(busy_poll); }
    bool send(std::span<const std::byte> frame) {
        sent.add(frame.size());
        return link_.send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, nanoseconds timeout) { return link_.receive(buffer, timeout); }

    traffic sent{};

  private:
    jauscat::net::raw_link link_{"jc0"};
};

/// Something that is done several times.
struct measured {
    jauscat::net::latency_histogram times{};
    traffic sent{};
    nanoseconds cpu{}; ///< of this thread

    [[nodiscard]] double each(auto sum) const { return static_cast<double>(sum) / static_cast<double>(times.count()); }
};

class master_end {
  public:
    master_end(std::size_t slaves, nanoseconds busy_poll) : link_{busy_poll}, records_(slaves), slots_(slaves) {
        for (std::size_t i = 0; i != slaves; ++i) {
            const auto station = static_cast<std::uint16_t>(i + 1);
            ups_.emplace_back(ethercat::bring_up{.position = static_cast<std::uint16_t>(i), .station = station});
            configures_.emplace_back(station);
            states_.emplace_back(station);
        }
    }

    /// From a scan on.
    void to_pre_op(measured& into) {
        measure(into, [&] {
            master_.reset();
            run(ethercat::scan{}, "scan");
            run(ethercat::bring_up_all{ups_}, "bring-up");
        });
    }
    /// With the process data set up.
    void to_safe_op(measured& into) {
        measure(into, [&] {
            run(ethercat::configure_all{configures_}, "configuration");
            run(ethercat::change_states{states_, ethercat::al_state::safe_op}, "SAFE-OP");
        });
    }

    /// Time on the wire of a cycle's frames.
    nanoseconds wire_time(bool watched) {
        traffic all;
        std::array<std::byte, ethercat::max_frame_size> frame{};
        auto& data = new_process_data(watched);
        data.begin_cycle();
        while (const auto size = data.next_frame(frame, jauscat::net::now())) all.add(size);
        return all.wire;
    }

    struct cycle_result {
        jauscat::net::latency_histogram late{}; ///< start after the due time
        jauscat::net::latency_histogram back{}; ///< all inputs, after the due time
        traffic sent{};
        std::uint64_t cycles{}, lost{}, incomplete{}, overruns{};
        nanoseconds cpu{}; ///< of this thread
    };
    /// Takes the slaves from SAFE-OP to OP, and exchanges process data.
    cycle_result cycle(nanoseconds period, bool watched, nanoseconds time, cycle_order order = {}) {
        auto& data = new_process_data(watched);
        jauscat::net::cycle_runner<counting_link> cycles{link_, data, master_, {.period = period, .order = order}};
        if (const auto up = cycles.run_job(
                ethercat::change_states{states_, ethercat::al_state::op}, std::chrono::seconds{5}, [] {},
                [](const auto&) {});
            !up)
            fail("OP", up.error());
        for (const auto end = jauscat::net::now() + std::chrono::milliseconds{100}; jauscat::net::now() < end;)
            cycles.run([] {});
        cycle_result all;
        const auto before = data.statistics();
        const auto overruns = cycles.overruns();
        link_.sent = {};
        const auto cpu = cpu_time();
        for (const auto end = jauscat::net::now() + time; jauscat::net::now() < end;) {
            const auto report = cycles.run([] {});
            all.late.add(report.late);
            if (report.round_trip != nanoseconds{}) all.back.add(report.late + report.round_trip);
        }
        const auto& after = data.statistics();
        all.cpu = cpu_time() - cpu;
        all.sent = link_.sent;
        all.cycles = after.sent - before.sent;
        all.lost = after.lost - before.lost;
        all.incomplete = after.incomplete - before.incomplete;
        all.overruns = cycles.overruns() - overruns;
        return all;
    }

    /// The same with the last cycle's frame, by hand: a prepared frame, a packet socket and a clock. Slaves are in OP.
    cycle_result cycle_by_hand(nanoseconds period, nanoseconds time, cycle_order order) {
        std::array<std::byte, ethercat::max_frame_size> frame{}, back{};
        data_->begin_cycle();
        const auto bytes = std::span{frame}.first(data_->next_frame(frame, jauscat::net::now()));
        const bool receives_first = order == cycle_order::receive_first;
        const bare_socket socket{"jc0", {.filter = true}};
        cycle_result all;
        timespec due{};
        ::clock_gettime(CLOCK_MONOTONIC, &due);
        const auto cpu = cpu_time();
        for (const auto end = jauscat::net::now() + time; jauscat::net::now() < end; ++all.cycles) {
            due.tv_nsec += static_cast<long>(period.count());
            if (due.tv_nsec >= 1'000'000'000) due = {due.tv_sec + 1, due.tv_nsec - 1'000'000'000};
            ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
            if (receives_first && all.cycles != 0 && socket.receive_waiting(back) == 0) ++all.lost;
            socket.send(bytes);
            if (!receives_first && socket.receive(back) == 0) ++all.lost;
        }
        all.cpu = cpu_time() - cpu;
        return all;
    }

  private:
    ethercat::process_data& new_process_data(bool watched) {
        image_.assign(ethercat::process_image::of(master_.slaves()).size, std::byte{});
        data_.emplace(slots_, image_).set_slaves(master_.slaves(), {.watch_slaves = watched});
        return *data_;
    }
    void measure(measured& into, auto&& work) {
        const auto cpu = cpu_time();
        link_.sent = {};
        const auto begun = jauscat::net::now();
        work();
        into.times.add(jauscat::net::now() - begun);
        into.cpu += cpu_time() - cpu;
        into.sent.frames += link_.sent.frames;
        into.sent.bytes += link_.sent.bytes;
        into.sent.wire += link_.sent.wire;
    }
    template <class Job> void run(const Job& job, const char* what) {
        const auto result = jauscat::net::run(link_, master_, job);
        if (!result) fail(what, result.error());
        if (*result != records_.size())
            throw std::runtime_error{std::string{what} + ": " + std::to_string(*result) + " of " +
                                     std::to_string(records_.size()) + " slaves"};
    }
    [[noreturn]] static void fail(const char* what, const ethercat::master_error& error) {
        throw std::runtime_error{std::string{what} + ": " + std::string{describe(error)}};
    }

    counting_link link_;
    std::vector<ethercat::slave_record> records_;
    ethercat::master master_{records_};
    std::vector<ethercat::process_slot> slots_;
    std::vector<std::byte> image_{};
    std::optional<ethercat::process_data> data_{};
    std::vector<ethercat::bring_up_place> ups_{};
    std::vector<ethercat::configure_place> configures_{};
    std::vector<ethercat::state_place> states_{};
};

} // namespace wire_bench
