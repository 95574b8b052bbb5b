// The slave at the other end of the cable, with an actuator that notes when it gets a command.
#pragma once

#include "report.hpp"
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/ethercat/slave/image_entries.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

#include <atomic>
#include <thread>

namespace wire_bench {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace translation = jauscat::translation;

inline constexpr std::uint16_t station = 2;
inline constexpr std::uint8_t component = 33;

using efforts_by_cycle =
    bridging::image_exchange<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;

/// Takes every object that is written, and the efforts in its process data. Runs until it is destroyed.
class slave_end {
  public:
    slave_end(int processor, nanoseconds busy_poll)
        : thread_{[this, processor, busy_poll] {
              pin(processor);
              link_.busy_poll(busy_poll);
              std::array<std::byte, ethercat::max_frame_size> buffer{};
              while (!stop_) {
                  const auto size = link_.receive(buffer, std::chrono::milliseconds{20});
                  if (size == 0) continue;
                  const auto frame = std::span{buffer}.first(size);
                  slave_.process(frame);
                  static_cast<void>(link_.send(frame)); // a lost reply counts as a lost frame
                  if (slave_.take_outputs()) obey();
              }
          }} {}
    ~slave_end() {
        stop_ = true;
        thread_.join();
    }
    slave_end(const slave_end&) = delete;
    slave_end& operator=(const slave_end&) = delete;

    /// How many commands the actuator has got, and when it got the last one.
    [[nodiscard]] unsigned commands() const noexcept { return commands_.load(std::memory_order_acquire); }
    [[nodiscard]] std::chrono::steady_clock::time_point last_command() const noexcept { return last_command_; }

    // What the slave writes to: models object_source.
    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = ethercat::abort_code::no_object};
    }
    ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        note_command();
        return ethercat::abort_code::none;
    }

  private:
    using image = translation::wrench_effort_image;

    void note_command() noexcept {
        last_command_ = std::chrono::steady_clock::now();
        commands_.store(commands_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    }
    void obey() noexcept {
        const auto count = efforts_by_cycle::given(slave_.outputs());
        if (count == taken_) return;
        note_command();
        taken_ = count;
        static_cast<void>(jauscat::wire::encode(image{.command_count = count}, slave_.inputs()));
    }

    static constexpr ethercat::slave_description description_{
        .vendor = 0x4A430000,
        .product = 0x0021,
        .outputs = ethercat::image_entries<image, ethercat::image_objects::outputs>,
        .inputs = ethercat::image_entries<image, ethercat::image_objects::inputs>};
    ethercat::standard_objects objects_{description_, *this};
    ethercat::slave slave_{description_, objects_};
    jauscat::net::raw_link link_{"jc1"};
    std::uint16_t taken_{};
    std::atomic<std::chrono::steady_clock::time_point> last_command_{};
    std::atomic<unsigned> commands_{};
    std::atomic<bool> stop_{};
    std::thread thread_;
};

} // namespace wire_bench
