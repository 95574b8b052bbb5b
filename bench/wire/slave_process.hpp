// A chain of emulated slaves at the other end of the cable, in a process of its own.
#pragma once

#include "../measuring.hpp"
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/slave_tree.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/now.hpp>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace wire_bench {

namespace ethercat = jauscat::ethercat;
using nanoseconds = std::chrono::nanoseconds;

struct chain_options {
    std::size_t slaves{1};
    std::size_t bytes{8}; ///< of outputs, and of inputs, of each slave
    /// The application of the first slave runs once in this time, those behind it each 2 % more seldom; 0: after each
    /// frame.
    nanoseconds application{};
    nanoseconds busy_poll{}; ///< of the link
    int processor{-1};       ///< of the process; negative: any
};

/// Slaves on the interface jc1 until it is destroyed. Their objects take every write.
class slave_process {
  public:
    /// Returns when the slaves are there. The program has one thread.
    explicit slave_process(const chain_options& options) {
        void* const memory = ::mmap(nullptr, sizeof(shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::runtime_error{"no shared memory"};
        shared_ = new (memory) shared{};
        const auto parent = ::getpid();
        child_ = ::fork();
        if (child_ < 0) throw std::runtime_error{"no process for the slaves"};
        if (child_ == 0) ::_exit(run(options, parent, *shared_));
        while (!shared_->is_ready) {
            if (::waitpid(child_, nullptr, WNOHANG) != 0) throw std::runtime_error{"the slaves did not start"};
            ::usleep(1000);
        }
    }
    ~slave_process() {
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
        ::munmap(shared_, sizeof(shared));
    }
    slave_process(const slave_process&) = delete;
    slave_process& operator=(const slave_process&) = delete;

    /// Time that the slaves have spent on a processor.
    [[nodiscard]] nanoseconds cpu_time() const noexcept { return nanoseconds{shared_->cpu}; }

  private:
    struct shared {
        std::atomic<bool> is_ready{};
        std::atomic<std::int64_t> cpu{};
    };
    struct accepting_objects {
        ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
            return {.error = ethercat::abort_code::no_object};
        }
        ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
            return ethercat::abort_code::none;
        }
    };
    struct device {
        device(const ethercat::slave_description& description, accepting_objects& below)
            : objects{description, below}, slave{description, objects} {}
        ethercat::standard_objects objects;
        ethercat::slave slave;
        jauscat::time_point next_work{};
        nanoseconds period{};
    };

    static int run(const chain_options& options, pid_t parent, shared& with) noexcept {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) return 1;
        for (const int each : {SIGINT, SIGTERM}) std::signal(each, SIG_IGN); // the parent ends this
        try {
            serve(options, with);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "slaves on jc1: %s\n", error.what());
        }
        return 1;
    }
    [[noreturn]] static void serve(const chain_options& options, shared& with) {
        measuring::pin(options.processor);
        std::vector<ethercat::pdo_entry> outputs, inputs;
        for (std::size_t i = 0; i != options.bytes; ++i) {
            const auto subindex = static_cast<std::uint8_t>(i + 1);
            outputs.push_back({.index = 0x7000, .subindex = subindex, .bits = 8, .data_type = 5, .name = "output"});
            inputs.push_back({.index = 0x6000, .subindex = subindex, .bits = 8, .data_type = 5, .name = "input"});
        }
        const ethercat::slave_description description{
            .vendor = 0x4A430000, .product = 0x0021, .outputs = outputs, .inputs = inputs};
        accepting_objects objects;
        std::deque<device> devices;
        std::vector<ethercat::wired_slave> wires;
        for (std::size_t i = 0; i != options.slaves; ++i) {
            auto& added = devices.emplace_back(description, objects);
            added.period = options.application + options.application / 50 * static_cast<int>(i);
            wires.push_back({.device = &added.slave, .parent = i == 0 ? 0 : i - 1});
        }
        ethercat::slave_tree tree{wires};
        jauscat::net::raw_link link{"jc1"};
        link.busy_poll(options.busy_poll);
        with.is_ready = true;
        const auto longest = options.application == nanoseconds{} ? std::chrono::milliseconds{20} : nanoseconds{50'000};
        for (std::array<std::byte, ethercat::max_frame_size> buffer{};;) {
            const auto size = link.receive(buffer, longest);
            if (size != 0) {
                const auto frame = std::span{buffer}.first(size);
                static_cast<void>(tree.pass(frame, jauscat::net::now()));
                static_cast<void>(link.send(frame)); // a lost reply counts as a lost frame
            }
            const auto now = jauscat::net::now();
            for (auto& each : devices) {
                if (now < each.next_work) continue;
                each.slave.work();
                each.next_work = std::max(each.next_work + each.period, now);
            }
            with.cpu = measuring::cpu_time().count();
        }
    }

    shared* shared_{};
    pid_t child_{};
};

} // namespace wire_bench
