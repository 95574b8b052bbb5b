// The time of each message as it is shown: of the day, or in seconds since an earlier message.
#pragma once
#include <chrono>
#include <optional>

namespace jausdump {

enum class time_display { absolute, relative, delta, none };

/// The time of one message.
struct time_stamp {
    time_display display{};
    std::optional<std::chrono::nanoseconds> value{}; ///< absolute: since 1970, UTC; else since the earlier message
};

/// Takes the times of all messages that are shown, in their order.
class time_stamps {
  public:
    explicit time_stamps(time_display display = {}) : display_{display} {}

    /// The next message has this time; empty: it has none.
    time_stamp next(std::optional<std::chrono::nanoseconds> time) {
        if (!time || display_ == time_display::none) return {.display = display_};
        if (display_ == time_display::absolute) return {.display = display_, .value = time};
        const auto reference = reference_.value_or(*time);
        if (!reference_ || display_ == time_display::delta) reference_ = time;
        return {.display = display_, .value = *time - reference};
    }

  private:
    time_display display_;
    std::optional<std::chrono::nanoseconds> reference_{};
};

} // namespace jausdump
