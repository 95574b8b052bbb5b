// From an operator's joint message to the target of each of six drives: the operator, the arm's node and its bus, and
// six emulated drives, all in this program, by UDP on loopback. Prints Markdown. scripts/measure joints runs it.
#include "measuring.hpp"
#include <jauscat/app.hpp>
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;
namespace jaus = jauscat::jaus;
namespace cia402 = jauscat::cia402;
namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

constexpr std::size_t joints = 6;
constexpr double increments_per_radian = 10'000;
using nanoseconds = std::chrono::nanoseconds;

/// Six drives on a ring, in a thread: when each got the target that is waited for.
class drive_ring {
  public:
    drive_ring() : thread_{[this] { serve(); }} {}
    ~drive_ring() {
        stop_ = true;
        thread_.join();
    }
    drive_ring(const drive_ring&) = delete;
    drive_ring& operator=(const drive_ring&) = delete;

    [[nodiscard]] std::string where() const { return "udp:127.0.0.1:" + std::to_string(port_); }
    void wait_for(std::int32_t target) {
        for (auto& each : arrivals_) each = 0;
        target_ = target;
    }
    /// Since the epoch of the clock; 0: it has not got it.
    [[nodiscard]] nanoseconds arrival(std::size_t drive) const { return nanoseconds{arrivals_[drive].load()}; }

  private:
    struct device {
        device() = default;
        device(const device&) = delete;
        device& operator=(const device&) = delete;

        cia402::emulated_drive<> drive{};
        ethercat::standard_objects objects{cia402::drive_description<>, drive};
        ethercat::slave slave{cia402::drive_description<>, objects};
    };

    void serve() {
        std::array<device, joints> ring{};
        for (auto& each : ring) each.slave.set_downstream(&each != &ring.back());
        std::array<std::byte, ethercat::max_frame_size> buffer{};
        while (!stop_) {
            const auto frame = std::span{buffer}.first(link_.receive(buffer, 1ms));
            for (std::size_t i = 0; i != joints; ++i) {
                auto& each = ring[i];
                if (!frame.empty()) each.slave.process(frame);
                const auto now = net::now();
                each.slave.on_time(now);
                each.drive.work(each.slave, now);
                const auto target = each.drive.axes[0].values.target_velocity;
                if (std::abs(target - target_.load()) <= 1 && arrivals_[i] == 0)
                    arrivals_[i] = nanoseconds{now.time_since_epoch()}.count();
            }
            if (!frame.empty()) static_cast<void>(link_.send(frame));
        }
    }

    net::udp_link link_{net::udp_link::serve(0, "127.0.0.1")};
    std::uint16_t port_{link_.port()};
    std::atomic<std::int32_t> target_{-1'000'000};
    std::array<std::atomic<std::int64_t>, joints> arrivals_{};
    std::atomic<bool> stop_{};
    std::thread thread_;
};

/// A system of the configuration, on a port that was free.
std::string system(const char* name, const char* id, const asio::ip::udp::socket& free) {
    return "<system><name>" + std::string{name} + "</name><jausip>" + id + "</jausip><ip>127.0.0.1</ip><port>" +
           std::to_string(free.local_endpoint().port()) + "</port></system>\n";
}
std::string configuration() {
    asio::io_context context;
    const asio::ip::udp::endpoint any{asio::ip::address_v4::loopback(), 0};
    const asio::ip::udp::socket first{context, any}, second{context, any};
    return "<jausconfig>\n<thissystem>operator</thissystem>\n" + system("operator", "1.1.0.0", first) +
           system("arm", "2.1.0.0", second) + "</jausconfig>\n";
}

std::array<jauscat::bridging::joint_options, joints> arm_joints() {
    std::array<jauscat::bridging::joint_options, joints> made{};
    for (std::size_t i = 0; i != joints; ++i)
        made[i] = {.slave = i,
                   .places = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs),
                   .axis = {.acceleration = 1e9, .deceleration = 1e9}, // the target itself in the first cycle
                   .scale = {.increments_per_radian = increments_per_radian}};
    return made;
}

/// Times from the message for each drive, and for the operator's acknowledgement.
struct times {
    std::array<std::vector<nanoseconds>, joints + 1> since{};
};

asio::awaitable<void> measure(jauscat::component& unit, drive_ring& drives, times& all, std::size_t count,
                              std::chrono::milliseconds period) {
    const jaus::address arm{.instance = 1, .component = 54, .node = 1, .subsystem = 2};
    asio::steady_timer timer{co_await asio::this_coro::executor};
    const auto wait = [&timer](auto time) {
        timer.expires_after(time);
        return timer.async_wait(asio::use_awaitable);
    };
    const auto turn = [](double rate) {
        return jaus::basic_set_joint_velocities<joints>{.joint_velocity = {rate, rate, rate, rate, rate, rate}};
    };
    std::mt19937 random{1};
    // Until the arm is ready and obeys.
    co_await wait(1s);
    auto control = co_await unit.async_control(arm, {.authority = 100});
    for (bool obeys = false; !obeys; co_await wait(100ms)) {
        try {
            co_await control.async_send(turn(1));
            obeys = true;
        } catch (const boost::system::system_error&) {}
    }
    for (std::size_t i = 0; i != count; ++i) {
        co_await wait(period * 3 + std::chrono::microseconds{random() % 5000}); // at any time of the cycle
        const double rate = i % 2 == 0 ? 1.5 : 1.0;
        const auto message = turn(rate);
        drives.wait_for(static_cast<std::int32_t>(rate * increments_per_radian));
        const auto begun = net::now();
        co_await control.async_send(message);
        all.since[joints].push_back(net::now() - begun);
        for (std::size_t drive = 0; drive != joints; ++drive) {
            const auto at = drives.arrival(drive);
            if (at == nanoseconds{}) throw std::runtime_error{"acknowledged before a drive had its target"};
            all.since[drive].push_back(at - nanoseconds{begun.time_since_epoch()});
        }
    }
}

double percentile(std::vector<nanoseconds>& sorted, std::size_t percent) {
    return measuring::us(sorted[std::min(sorted.size() - 1, sorted.size() * percent / 100)]);
}

void run(std::size_t count, std::chrono::milliseconds period) {
    const auto systems = configuration();
    drive_ring drives;
    asio::io_context arm_context;
    jauscat::node arm{arm_context, {.config_text = systems, .this_system = "arm", .log = [](std::string_view) {}}};
    jauscat::bus bus{arm_context, drives.where(), {.thread = true}};
    jauscat::bridge bridge{arm, bus, jauscat::translation::seed_table{}, {.at_rest_within = 200ms, .period = period}};
    std::vector<jauscat::slave> slaves;
    for (std::uint16_t position = 0; position != joints; ++position)
        slaves.push_back(bus.slave({.position = position}));
    bridge.serve({.component = 54}, slaves, std::make_unique<jauscat::bridging::joint_part<joints>>(arm_joints()));
    arm.start();
    std::thread arm_thread{[&] { arm_context.run(); }};

    times all;
    std::exception_ptr problem;
    {
        asio::io_context context;
        jauscat::node node{context,
                           {.config_text = systems, .this_system = "operator", .log = [](std::string_view) {}}};
        jauscat::component unit{node, {.id = 32, .name = "operator"}};
        unit.ready();
        node.start();
        asio::co_spawn(context, measure(unit, drives, all, count, period), [&](const std::exception_ptr& error) {
            problem = error;
            node.stop();
            context.stop();
        });
        context.run();
    }
    asio::post(arm_context, [&] {
        arm.stop();
        arm_context.stop(); // a bus keeps it running
    });
    arm_thread.join();
    if (problem) std::rethrow_exception(problem);
    for (std::size_t i = 0; i != all.since.size(); ++i) {
        auto& each = all.since[i];
        std::ranges::sort(each);
        const auto name = i == joints ? std::string{"acknowledgement"} : "drive " + std::to_string(i + 1);
        std::printf("| %d ms | %s | %.0f | %.0f | %.0f |\n", static_cast<int>(period.count()), name.c_str(),
                    percentile(each, 50), percentile(each, 99), measuring::us(each.back()));
    }
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) try {
    const auto count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000;
    if (argc > 2 || count == 0) return std::fputs("joints_bench [MESSAGES]\n", stderr), 2;
    std::puts("| period | to | p50 us | p99 us | max us |\n| ---: | --- | ---: | ---: | ---: |");
    for (const auto period : {1ms, 5ms}) run(count, period);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "joints_bench: %s\n", error.what());
    return 1;
}
