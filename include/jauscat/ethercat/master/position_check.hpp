// Looks whether the slave at a position has a station address.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine of one step. Error: wrong_station.
class position_check {
  public:
    static constexpr std::size_t request_size() noexcept { return datagram_overhead + wire::max_size<esc_word>; }
    static constexpr std::size_t request_datagrams() noexcept { return 1; }

    position_check() noexcept = default;
    position_check(std::uint16_t position, std::uint16_t station) noexcept : position_{position}, station_{station} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    void request(frame_builder& frame) const noexcept {
        frame.add(command::aprd, static_cast<std::uint16_t>(-position_), esc_registers::station_address.address,
                  wire::max_size<esc_word>);
    }
    progress reply(replies datagrams, time_point, const master_config&) noexcept {
        const auto& datagram = datagrams.front();
        if (datagram.working_counter != 1 || datagram.value(esc_registers::station_address).value != station_)
            result_ = master_error{.code = master_errc::wrong_station, .station = station_};
        return progress::done;
    }

  private:
    std::uint16_t position_{}, station_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
