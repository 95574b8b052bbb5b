// A log that others cannot flood: what strangers cause is told, but not a line for each of their datagrams.
#pragma once

#include <jauscat/net/rate_limit.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace jauscat::net {

/// Lines of text for a person, so many each second; the next line says how many were left out.
class limited_log {
  public:
    /// Takes a line, without its end.
    using handler = std::function<void(std::string_view line)>;
    using time = token_bucket::time;

    /// Writes through `write`, which may be empty, no more lines than `limit` permits.
    explicit limited_log(handler write, const rate& limit = {.per_second = 20, .burst = 100})
        : write_{std::move(write)}, limit_{limit} {}

    /// `text()` makes the line; it is not called for one that is left out.
    void operator()(time now, auto&& text) {
        if (!write_) return;
        if (!bucket_.take(limit_, now)) {
            ++left_out_;
            return;
        }
        if (const auto count = std::exchange(left_out_, 0); count != 0)
            write_(std::to_string(count) + " lines were left out");
        write_(std::string{text()});
    }

  private:
    handler write_;
    rate limit_;
    token_bucket bucket_{};
    std::uint64_t left_out_{}; ///< lines, since the last one that was written
};

} // namespace jauscat::net
