// A timer that wakes a node at the earliest due time of its parts.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/net/detail/handler_memory.hpp>

#include <boost/asio/steady_timer.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace jauscat::net::detail {

/// Waking early is cheaper than moving a timer, so it is only moved to earlier times.
class wake_timer {
  public:
    wake_timer(boost::asio::io_context& context, std::function<void()> wake)
        : timer_{context}, wake_{std::move(wake)} {}

    /// Wakes at `at`, or sooner.
    void arm(time_point at) {
        if (armed_at_ && *armed_at_ <= at) return;
        armed_at_ = at;
        using clock = boost::asio::steady_timer::clock_type;
        timer_.expires_at(clock::time_point{std::chrono::duration_cast<clock::duration>(at.time_since_epoch())});
        timer_.async_wait(
            remembered_handler{[this, turn = std::weak_ptr<char>{turn_}](boost::system::error_code error) {
                                   if (error || turn.expired()) return;
                                   armed_at_.reset();
                                   wake_();
                               },
                               memory_});
    }
    /// No wake-up afterwards, even if one was queued.
    void cancel() {
        timer_.cancel();
        armed_at_.reset();
        turn_ = std::make_shared<char>();
    }

  private:
    boost::asio::steady_timer timer_;
    std::function<void()> wake_;
    std::optional<time_point> armed_at_{};
    std::shared_ptr<handler_memory> memory_{std::make_shared<handler_memory>()};
    std::shared_ptr<char> turn_{std::make_shared<char>()};
};

} // namespace jauscat::net::detail
