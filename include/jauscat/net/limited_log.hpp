// Rate-limited log, so that unsolicited traffic cannot flood it.
#pragma once

#include <jauscat/net/rate_limit.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>

namespace jauscat::net {

/// Lines of text for a person, so many each second of each cause; the next line of a cause says how many of it were
/// left out. A cause is a place in the code that logs: each has a function of its own that makes the text.
class limited_log {
  public:
    /// Takes a line, without its end.
    using handler = std::function<void(std::string_view line)>;
    using time = token_bucket::time;

    /// Writes through `write`, which may be empty, no more lines of a cause than `limit` permits.
    explicit limited_log(handler write, const rate& limit = {.per_second = 20, .burst = 100})
        : write_{std::move(write)}, limit_{limit} {}

    /// `text()` makes the line; it is not called for one that is left out.
    template <class Text> void operator()(time now, Text&& text) {
        if (!write_) return;
        auto& of_cause = causes_[std::type_index{typeid(Text)}];
        if (!of_cause.bucket.take(limit_, now)) {
            ++of_cause.left_out;
            return;
        }
        if (const auto count = std::exchange(of_cause.left_out, 0); count != 0)
            write_(std::to_string(count) + " lines such as the next were left out");
        write_(std::string{text()});
    }

  private:
    struct cause {
        token_bucket bucket{};
        std::uint64_t left_out{}; ///< lines, since the last one that was written
    };
    handler write_;
    rate limit_;
    std::map<std::type_index, cause> causes_{}; ///< as many as there are places in the code
};

} // namespace jauscat::net
