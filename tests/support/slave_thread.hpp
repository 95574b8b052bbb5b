// Emulated slaves at the other end of a cable: a thread that passes the frames of an interface through them.
#pragma once

#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/net/link/raw_link.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace jauscat::test {

/// Runs until it is destroyed. Slaves are touched by the thread alone meanwhile.
class slave_thread {
  public:
    using bytes = std::vector<std::byte>;

    /// `on_way_back` may change a frame before it goes back, or lose it by emptying it.
    slave_thread(const std::string& interface, std::span<ethercat::slave> slaves,
                 std::function<void(bytes&)> on_way_back = {})
        : link_{interface}, slaves_{slaves}, on_way_back_{std::move(on_way_back)}, thread_{[this] { serve(); }} {}
    ~slave_thread() {
        stop_ = true;
        thread_.join();
    }

    slave_thread(const slave_thread&) = delete;
    slave_thread& operator=(const slave_thread&) = delete;

    /// How many frames have come.
    [[nodiscard]] unsigned frames() const noexcept { return frames_; }

  private:
    void serve() {
        std::array<std::byte, ethercat::max_frame_size> buffer{};
        while (!stop_) {
            const auto size = link_.receive(buffer, std::chrono::milliseconds{20});
            if (size == 0) continue;
            ++frames_;
            const auto frame = std::span{buffer}.first(size);
            for (auto& slave : slaves_) slave.process(frame);
            bytes back(frame.begin(), frame.end());
            if (on_way_back_) on_way_back_(back);
            if (!back.empty()) static_cast<void>(link_.send(back)); // the cable may be out
        }
    }

    net::raw_link link_;
    std::span<ethercat::slave> slaves_;
    std::function<void(bytes&)> on_way_back_;
    std::atomic<unsigned> frames_{};
    std::atomic<bool> stop_{};
    std::thread thread_;
};

} // namespace jauscat::test
