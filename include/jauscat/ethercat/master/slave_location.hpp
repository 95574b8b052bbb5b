// Finds the slaves of a ring by their station addresses, without changing anything in them.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/frame_traffic.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return. One frame to count, and
/// one for each 63 slaves, which counts again: positions tell nothing if a slave has come or gone since.
class slave_location {
  public:
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    /// Slaves in the ring.
    [[nodiscard]] std::uint16_t slaves() const noexcept { return slaves_; }

    void request(frame_builder& frame) const noexcept {
        frame.add(command::brd, 0, esc_registers::type.address, std::size_t{1});
        const auto end = std::min<std::size_t>(slaves_, next_ + frame_traffic::max_datagrams - 1);
        for (auto position = next_; position != end; ++position)
            frame.add(command::aprd, static_cast<std::uint16_t>(-static_cast<int>(position)),
                      esc_registers::station_address.address, wire::max_size<esc_word>);
    }
    /// Calls `found(position, station)` for each slave.
    template <class Found> progress reply(replies datagrams, Found&& found) noexcept {
        const auto counted = datagrams.front().working_counter;
        if (!is_counted_) {
            is_counted_ = true;
            slaves_ = counted;
            return slaves_ == 0 ? progress::done : progress::send;
        }
        const auto stations = datagrams.subspan(1);
        result_ = counted == slaves_ ? executed_by_one(stations)
                                     : master_error{.code = master_errc::working_counter, .working_counter = counted};
        if (!result_) return progress::done;
        for (const auto& each : stations)
            found(static_cast<std::uint16_t>(next_++), each.value(esc_registers::station_address).value);
        return next_ == slaves_ ? progress::done : progress::send;
    }

  private:
    bool is_counted_{};
    std::uint16_t slaves_{};
    std::size_t next_{}; // position
    master_result<> result_{};
};

} // namespace jauscat::ethercat
