// Why the program ends early, and its exit codes.
#pragma once
#include <stdexcept>

namespace ecat {

enum exit_code : int {
    success = 0,
    failed = 1,        ///< the link, a slave or a file; or a comparison found differences
    wrong_usage = 2,   ///< the command line is wrong
    bus_in_use = 3,    ///< another master seems to use the bus: nothing was changed
    not_confirmed = 4, ///< a write was not permitted: neither --yes nor a yes on the terminal
};

struct failure : std::runtime_error {
    explicit failure(const std::string& what, exit_code code = failed) : std::runtime_error{what}, code_{code} {}
    [[nodiscard]] exit_code code() const noexcept { return code_; }

  private:
    exit_code code_;
};

/// A wrong command line.
struct usage_error : failure {
    explicit usage_error(const std::string& what) : failure{what, wrong_usage} {}
};

/// Ctrl-C or SIGTERM has been received.
[[nodiscard]] bool stop_requested() noexcept;

} // namespace ecat
