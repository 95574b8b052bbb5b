// Rate-limited log, so that unsolicited traffic cannot flood it.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>

namespace jauscat::net {

/// Limits the lines of each cause; the next line of a cause states the number of suppressed lines. A cause is a place
/// in the code that logs: its type of the function that makes the text.
class limited_log {
  public:
    /// Receives a line without its end.
    using handler = std::function<void(std::string_view line)>;

    /// `write` may be empty. `limit` applies to each cause.
    explicit limited_log(handler write, const rate& limit = {.per_second = 20, .burst = 100})
        : write_{std::move(write)}, limit_{limit} {}

    /// `text()` makes the line; it is not called for a suppressed line.
    template <class Text> void operator()(time_point now, Text&& text) {
        if (write_ && admits(typeid(Text), now)) write_(text());
    }

  private:
    bool admits(std::type_index place, time_point now) {
        auto& of_cause = causes_[place];
        if (!of_cause.bucket.take(limit_, now)) {
            ++of_cause.left_out;
            return false;
        }
        if (const auto count = std::exchange(of_cause.left_out, 0); count != 0)
            write_(std::to_string(count) + " lines such as the next were left out");
        return true;
    }

    struct cause {
        token_bucket bucket{};
        std::uint64_t left_out{}; ///< lines since the last one that was written
    };
    handler write_;
    rate limit_;
    std::map<std::type_index, cause> causes_{}; ///< one for each place in the code
};

} // namespace jauscat::net
