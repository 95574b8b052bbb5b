// What the threads of a program say: whole lines, those of one thread at a time.
#pragma once
#include "support/colour.hpp"
#include <jauscat/net/rate_limit.hpp>

#include <chrono>
#include <cstdint>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace example {

/// Writes lines, each with its end, that no other thread's come between.
inline void write_lines(const std::string& lines) {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock{one_at_a_time};
    std::cout << lines;
}

/// Limits the lines that peers cause a program to write: 20 entries a second of each cause, 100 at once.
class line_limit {
  public:
    /// The lines to write, with the number of those that were left out in front; empty where the cause is at its limit.
    std::string operator()(std::string cause, const std::string& lines) {
        if (causes_.size() == most && !causes_.contains(cause)) cause.clear();
        auto& [bucket, left_out] = causes_[cause];
        if (!bucket.take(limit, std::chrono::steady_clock::now().time_since_epoch())) {
            ++left_out;
            return {};
        }
        const auto count = std::exchange(left_out, 0);
        return count == 0 ? lines : "(" + std::to_string(count) + " such were left out)\n" + lines;
    }

  private:
    static constexpr jauscat::net::rate limit{.per_second = 20, .burst = 100};
    static constexpr std::size_t most = 512;
    struct state {
        jauscat::net::token_bucket bucket{};
        std::uint64_t left_out{};
    };
    std::map<std::string, state> causes_{};
};

/// Writes lines as write_lines does, if the cause is not at its limit.
inline void write_limited(const std::string& cause, const std::string& lines) {
    static std::mutex one_at_a_time;
    static line_limit limit;
    const std::scoped_lock lock{one_at_a_time};
    if (const auto shown = limit(cause, lines); !shown.empty()) write_lines(shown);
}

/// Says lines that begin with a name.
class speaker {
  public:
    explicit speaker(std::string name) : name_{std::move(name)} {}

    /// `more`: lines that belong below, each with its end.
    void operator()(const std::string& line, const std::string& more = {}) const {
        write_limited(cause_of(line), name_ + ": " + line + "\n" + more);
    }
    /// What one waits for, and what one has to look at.
    void good(const std::string& line) const { (*this)(example::good(line)); }
    void bad(const std::string& line) const { (*this)(example::bad(line)); }

  private:
    /// Lines with the same first word, numbers aside, have the same cause.
    [[nodiscard]] std::string cause_of(const std::string& line) const {
        auto word = line.substr(0, line.find(' '));
        std::erase_if(word, [](char c) { return c >= '0' && c <= '9'; });
        return name_ + ": " + word;
    }

    std::string name_;
};

} // namespace example
