// What the threads of a program say: whole lines, those of one thread at a time.
#pragma once
#include "support/colour.hpp"
#include "support/log.hpp"
#include <jauscat/net/now.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace example {

/// Writes lines, each with its end, that no other thread's come between.
inline void write_lines(const std::string& lines) {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock{one_at_a_time};
    std::cout << lines;
}

/// Writes an event; `text`: its lines for an operator, each with its end.
inline void write_event(event_kind kind, const event_members& members, const std::string& text) {
    write_lines(log_lines(kind, members, text));
}

/// Limits the events that peers cause a program to write: 20 a second of each cause, 100 at once.
class event_limit {
  public:
    /// The number of events of this cause that were left out before this one; nothing where the cause is at its limit.
    std::optional<std::uint64_t> admit(std::string cause) {
        if (causes_.size() == most && !causes_.contains(cause)) cause.clear();
        auto& [bucket, left_out] = causes_[cause];
        if (bucket.take(limit, jauscat::net::now())) return std::exchange(left_out, 0);
        ++left_out;
        return std::nullopt;
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

/// Writes an event as write_event does, if the cause is not at its limit; says whether it was written.
inline bool write_limited(const std::string& cause, event_kind kind, const event_members& members,
                          const std::string& text) {
    static std::mutex one_at_a_time;
    static event_limit limit;
    const std::scoped_lock lock{one_at_a_time};
    const auto left_out = limit.admit(cause);
    if (left_out) write_lines(log_lines(kind, members, text, *left_out));
    return left_out.has_value();
}

/// Gets the lines that say what is wrong; set while the program has one thread. `line` is without colours.
inline std::function<void(bool is_bad, const std::string& line)>& on_fault() {
    static std::function<void(bool, const std::string&)> listener;
    return listener;
}
inline void tell_fault(bool is_bad, const std::string& line) {
    if (on_fault()) on_fault()(is_bad, line);
}

/// Writes lines that begin with a name.
class speaker {
  public:
    /// `about`: members of each event.
    explicit speaker(std::string name, event_members about = {}) : name_{std::move(name)}, about_{std::move(about)} {}

    /// `more`: lines that belong below, each with its end.
    void operator()(event_kind kind, const event_members& members, const std::string& line,
                    const std::string& more = {}) const {
        write(kind, members, line, more);
    }
    /// What one waits for, and what one has to look at.
    void good(event_kind kind, const event_members& members, const std::string& line) const {
        (*this)(kind, members, example::good(line));
    }
    void bad(event_kind kind, const event_members& members, const std::string& line) const {
        if (write(kind, members, example::bad(line))) tell_fault(true, name_ + ": " + line);
    }
    /// What may be wrong.
    void warn(event_kind kind, const event_members& members, const std::string& line) const {
        if (write(kind, members, line)) tell_fault(false, name_ + ": " + line);
    }
    /// Members of each event.
    [[nodiscard]] const event_members& about() const noexcept { return about_; }

  private:
    bool write(event_kind kind, const event_members& members, const std::string& line,
               const std::string& more = {}) const {
        return write_limited(cause_of(line), kind, about_ + members, name_ + ": " + line + "\n" + more);
    }
    /// Lines with the same first word, numbers aside, have the same cause.
    [[nodiscard]] std::string cause_of(const std::string& line) const {
        auto word = line.substr(0, line.find(' '));
        std::erase_if(word, [](char c) { return c >= '0' && c <= '9'; });
        return name_ + ": " + word;
    }

    std::string name_;
    event_members about_;
};

} // namespace example
