// What the threads of a program say: whole lines, those of one thread at a time.
#pragma once
#include "support/colour.hpp"

#include <iostream>
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

/// Says lines that begin with a name.
class speaker {
  public:
    explicit speaker(std::string name) : name_{std::move(name)} {}

    /// `more`: lines that belong below, each with its end.
    void operator()(const std::string& line, const std::string& more = {}) const {
        write_lines(name_ + ": " + line + "\n" + more);
    }
    /// What one waits for, and what one has to look at.
    void good(const std::string& line) const { (*this)(example::good(line)); }
    void bad(const std::string& line) const { (*this)(example::bad(line)); }

  private:
    std::string name_;
};

} // namespace example
