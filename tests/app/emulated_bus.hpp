// Emulated slaves behind EtherCAT in UDP or on an interface, in a thread: for tests of programs with a bus. They can be
// made to fail.
#pragma once

#include "../../tools/arrival_time.hpp"
#include "ethercat/described_objects.hpp"
#include "ethercat/objects.hpp"
#include <jauscat/ethercat/link.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/slave_tree.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace jauscat::test {

/// For `bus_options`: longer than a busy machine keeps the thread of the slaves waiting.
inline constexpr std::chrono::milliseconds frame_timeout{100};

/// A slave with objects of its own.
struct emulated_slave {
    emulated_slave(const ethercat::slave_description& d, bool is_described)
        : description{d},
          slave{description,
                is_described ? ethercat::object_dictionary{described} : ethercat::object_dictionary{all},
                {.transfer_memory = segments}} {}
    emulated_slave(const emulated_slave&) = delete;
    emulated_slave& operator=(const emulated_slave&) = delete;

    /// After each frame that reaches it.
    void work(std::span<std::byte>, time_point) {
        if (!hangs) slave.work();
        if (!hangs && application) application(slave);
    }
    void on_time(time_point now) { slave.on_time(now); }
    [[nodiscard]] bool has_clock() const { return description.clock != ethercat::clock_width::no_clock; }

    ethercat::slave_description description;
    objects own{};
    described_objects other{};
    ethercat::standard_objects all{description, own};
    ethercat::standard_objects described{description, other};
    std::array<std::byte, 2048> segments{};
    ethercat::slave slave;
    std::function<void(ethercat::slave&)> application{};
    bool hangs{}; ///< its application: the controller alone works
};

/// Slaves behind a link, in a thread, until it is destroyed. Change them by `with` alone. Slaves with distributed
/// clocks have cables of 200 ns. A `Slave` has a member `slave`, `has_clock()`, `work(frame, now)` after each frame
/// that reaches it, and `on_time(now)`.
template <class Slave> class basic_emulated_bus {
  public:
    ~basic_emulated_bus() {
        stop_ = true;
        thread_.join();
    }
    basic_emulated_bus(const basic_emulated_bus&) = delete;
    basic_emulated_bus& operator=(const basic_emulated_bus&) = delete;

    /// For a bus.
    [[nodiscard]] const std::string& where() const { return where_; }

    /// No frame returns.
    std::atomic<bool> is_silent{};
    /// What returns is no answer.
    std::atomic<bool> is_garbage{};
    /// Frames pass only so many slaves: the cable behind them is out.
    void cut_behind(std::size_t slaves) { reach_ = slaves; }
    /// These slaves alone are on the cable, in this order.
    void connect(std::vector<std::size_t> order) {
        const std::lock_guard lock{mutex_};
        order_ = std::move(order);
        reach_ = order_.size();
    }
    /// Changes each frame that returns.
    void on_way_back(std::function<void(std::span<std::byte>)> change) {
        const std::lock_guard lock{mutex_};
        on_way_back_ = std::move(change);
    }
    [[nodiscard]] unsigned frames() const noexcept { return frames_; }

    auto with(std::size_t i, auto&& f) {
        const std::lock_guard lock{mutex_};
        return f(slaves_.at(i));
    }
    /// `f(std::deque<Slave>&)`.
    auto with_all(auto&& f) {
        const std::lock_guard lock{mutex_};
        return f(slaves_);
    }

  protected:
    /// A link, and where a bus finds it.
    struct slaves_end {
        std::unique_ptr<net::any_link> link;
        std::string where;
    };
    static slaves_end udp_end() {
        auto link = net::udp_link::serve(0, "127.0.0.1");
        auto where = "udp:127.0.0.1:" + std::to_string(link.port());
        return {std::make_unique<net::held_link<net::udp_link>>(std::move(link)), std::move(where)};
    }
    /// `fill(std::deque<Slave>&)` makes the slaves.
    explicit basic_emulated_bus(auto&& fill, slaves_end end = udp_end())
        : link_{std::move(end.link)}, where_{std::move(end.where)} {
        fill(slaves_);
        for (std::size_t i = 0; i != slaves_.size(); ++i) order_.push_back(i);
        reach_ = slaves_.size();
        static_cast<void>(arrival_time(link_->native_handle()));
        thread_ = std::thread{[this] { serve(); }};
    }

  private:
    void serve() {
        std::array<std::byte, ethercat::max_frame_size> buffer{};
        while (!stop_) {
            // Frames that wait came before now: the slaves' clocks do not pass them.
            const auto size = link_->receive(buffer, std::chrono::milliseconds{is_idle_ ? 2 : 0});
            const auto at = size != 0 ? arrival_time(link_->native_handle()) : net::now();
            is_idle_ = size == 0;
            const std::lock_guard lock{mutex_};
            if (size != 0) {
                ++frames_;
                pass(std::span{buffer}.first(size), at);
            }
            for (auto& each : slaves_) {
                each.slave.pass_time(at);
                each.on_time(net::now());
            }
        }
    }
    void pass(std::span<std::byte> frame, time_point at) {
        const std::size_t reached = reach_;
        const bool have_clocks = std::ranges::any_of(slaves_, [](const Slave& each) { return each.has_clock(); });
        if (have_clocks) {
            std::vector<ethercat::wired_slave> wires;
            for (std::size_t i = 0; i != reached; ++i)
                wires.push_back({.device = &slaves_[order_[i]].slave,
                                 .parent = i == 0 ? 0 : i - 1,
                                 .cable = std::chrono::nanoseconds{200}});
            ethercat::slave_tree{wires, std::chrono::nanoseconds{300}}.pass(frame, at);
        }
        for (std::size_t i = 0; i != reached; ++i) {
            auto& each = slaves_[order_[i]];
            if (!have_clocks) each.slave.pass(frame);
            each.work(frame, net::now());
        }
        if (on_way_back_) on_way_back_(frame);
        if (is_garbage)
            for (auto& each : frame.subspan(std::min<std::size_t>(frame.size(), 16))) each ^= std::byte{0x5A};
        if (!is_silent) static_cast<void>(link_->send(frame));
    }

    std::unique_ptr<net::any_link> link_;
    std::string where_;
    std::mutex mutex_{};
    std::deque<Slave> slaves_{};
    std::function<void(std::span<std::byte>)> on_way_back_{};
    std::vector<std::size_t> order_{};
    std::atomic<std::size_t> reach_{};
    std::atomic<unsigned> frames_{};
    std::atomic<bool> stop_{};
    bool is_idle_{true};
    std::thread thread_{};
};

/// Makes slaves of their descriptions.
inline auto filled_with(const std::vector<ethercat::slave_description>& slaves, bool are_described) {
    return [&slaves, are_described](std::deque<emulated_slave>& made) {
        for (const auto& each : slaves) made.emplace_back(each, are_described);
    };
}

/// Slaves with objects of their own.
class emulated_bus : public basic_emulated_bus<emulated_slave> {
  public:
    using bytes = std::vector<std::byte>;

    explicit emulated_bus(const std::vector<ethercat::slave_description>& slaves, bool are_described = false)
        : basic_emulated_bus{filled_with(slaves, are_described)} {}
    /// At the end `interface` of a cable with the other end `where`.
    emulated_bus(const std::vector<ethercat::slave_description>& slaves, const std::string& interface,
                 std::string where)
        : basic_emulated_bus{filled_with(slaves, false), slaves_end{net::open_link(interface), std::move(where)}} {}
};

} // namespace jauscat::test
