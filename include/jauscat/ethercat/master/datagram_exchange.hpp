// Exchange of one datagram given by the caller.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>

#include <algorithm>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// State machine of one step: the data go out and come back into the same place, which stays until it is done.
class datagram_exchange {
  public:
    datagram_exchange() noexcept = default;
    /// `data` is sent, and overwritten with the reply.
    datagram_exchange(command cmd, std::uint16_t adp, std::uint16_t ado, std::span<std::byte> data) noexcept
        : cmd_{cmd}, adp_{adp}, ado_{ado}, data_{data} {}

    [[nodiscard]] static constexpr master_result<> result() noexcept { return {}; }
    [[nodiscard]] std::uint16_t working_counter() const noexcept { return working_counter_; }

    void request(frame_builder& frame) const noexcept {
        frame.add(cmd_, adp_, ado_, std::span<const std::byte>{data_});
    }
    progress reply(replies datagrams, time_point, const master_config&) noexcept {
        const auto& back = datagrams.front();
        std::ranges::copy(back.data, data_.begin());
        working_counter_ = back.working_counter;
        return progress::done;
    }

  private:
    command cmd_{};
    std::uint16_t adp_{}, ado_{};
    std::span<std::byte> data_{};
    std::uint16_t working_counter_{};
};

} // namespace jauscat::ethercat
