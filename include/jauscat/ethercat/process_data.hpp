// The cyclic exchange of process data: one frame a cycle carries the outputs of all slaves out and their inputs back.
#pragma once

#include <jauscat/ethercat/activity.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/outstanding_frame.hpp>
#include <jauscat/ethercat/process_image.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// What the cycles have come to, in frames.
struct process_statistics {
    std::uint64_t sent{};
    std::uint64_t complete{};   ///< every slave took part
    std::uint64_t incomplete{}; ///< came back with a smaller or larger working counter: inputs are the ones before
    std::uint64_t lost{};       ///< did not come back before the next cycle
};

/// Sends the process image when a cycle is due; a frame that is not back by then is lost, and the next one goes all the
/// same: the freshest outputs count. Runs beside a master on the same link: give each frame that arrives to `on_frame`
/// first, and to the master if it was not taken.
class process_data {
  public:
    process_data() noexcept = default;
    /// The slaves' places, as `configure` has left them. All outputs are 0.
    explicit process_data(std::span<const slave_record> slaves) noexcept : image_{process_image::of(slaves)} {
        for (const auto& slave : slaves)
            if (slave.process_data.input_size != 0 && places_ != inputs_.size())
                inputs_[places_++] = {slave.process_data.input_address, slave.process_data.input_size};
    }

    /// Where each slave's data lie.
    [[nodiscard]] const process_image& image() const noexcept { return image_; }
    /// Outputs of a slave: what is written here goes out with the next cycle.
    [[nodiscard]] std::span<std::byte> outputs(const slave_record& slave) noexcept {
        return part(slave.process_data.output_address, slave.process_data.output_size);
    }
    /// Inputs of a slave, as the last complete cycle brought them.
    [[nodiscard]] std::span<const std::byte> inputs(const slave_record& slave) const noexcept {
        const auto& [address, size] = input_place{slave.process_data.input_address, slave.process_data.input_size};
        return holds(address, size) ? std::span{bytes_}.subspan(address, size) : std::span<const std::byte>{};
    }

    /// A cycle is due: writes its frame to `out`, which holds 1514 bytes, and returns its size; 0 where there are no
    /// process data.
    std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept {
        if (outstanding_.waits()) {
            ++statistics_.lost;
            is_complete_ = false;
        }
        outstanding_.forget();
        if (image_.size == 0) return 0;
        frame_builder frame{out, ++index_};
        const auto data = std::span<const std::byte>{bytes_}.first(image_.size);
        if (image_.no_lrw) {
            frame.add(command::lwr, 0, 0, data);
            frame.add(command::lrd, 0, 0, image_.size);
        } else {
            frame.add(command::lrw, 0, 0, data);
        }
        const auto size = frame.finish();
        if (!size) return 0;
        outstanding_.sent(out.first(size.size()), now);
        ++statistics_.sent;
        return size.size();
    }

    /// Takes a frame that arrived. False if it is none of ours: it may be the master's.
    bool on_frame(std::span<const std::byte> frame) noexcept {
        frame_view view;
        if (!view.parse(frame)) return false;
        const auto datagrams = outstanding_.waits() ? outstanding_.match(view) : replies{};
        if (datagrams.empty()) return outstanding_.may_be_own(view);
        outstanding_.forget();
        working_counter_ = datagrams.back().working_counter;
        bool complete = working_counter_ == (image_.no_lrw ? image_.read : image_.read_write);
        if (image_.no_lrw) complete = complete && datagrams.front().working_counter == image_.write;
        ++(complete ? statistics_.complete : statistics_.incomplete);
        is_complete_ = complete;
        if (complete)
            for (const auto& [address, size] : std::span{inputs_}.first(places_))
                std::ranges::copy(datagrams.back().data.subspan(address, size), part(address, size).begin());
        return true;
    }

    /// The cycle's frame is not back yet.
    [[nodiscard]] bool waits() const noexcept { return outstanding_.waits(); }
    /// Every slave took part in the last cycle: its frame came back, with the working counter that it has to have.
    [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }
    /// Of the last frame that came back.
    [[nodiscard]] std::uint16_t working_counter() const noexcept { return working_counter_; }
    [[nodiscard]] const process_statistics& statistics() const noexcept { return statistics_; }

  private:
    struct input_place {
        std::uint32_t address{};
        std::uint16_t size{};
    };

    [[nodiscard]] bool holds(std::uint32_t address, std::size_t size) const noexcept {
        return size <= image_.size && address <= image_.size - size;
    }
    [[nodiscard]] std::span<std::byte> part(std::uint32_t address, std::size_t size) noexcept {
        return holds(address, size) ? std::span{bytes_}.subspan(address, size) : std::span<std::byte>{};
    }

    process_image image_{};
    std::array<std::byte, max_process_image> bytes_{};
    std::array<input_place, slave_capacity> inputs_{};
    std::size_t places_{};
    outstanding_frame outstanding_{};
    std::uint8_t index_{};
    std::uint16_t working_counter_{};
    bool is_complete_{};
    process_statistics statistics_{};
};

} // namespace jauscat::ethercat
