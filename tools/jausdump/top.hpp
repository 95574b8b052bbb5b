// Shows the table of messages: on a terminal as they arrive, else as lines.
#pragma once
#include "dump.hpp"
#include "top_table.hpp"

#include <memory>

namespace jausdump {

struct top_options {
    top_order order{};
    bool live{};                        ///< messages of a port, else of a capture
    bool as_json{};                     ///< lines of JSON, also on a terminal
    std::optional<double> interval_s{}; ///< between two tables; empty: 0.5 s on a terminal, else at the end alone
};

class top {
  public:
    explicit top(top_options how);
    ~top();
    top(const top&) = delete;
    top& operator=(const top&) = delete;

    /// Takes each message.
    void follow(options& how);
    /// Reads keys, and shows the table when it is time; to be called often. Returns true when the user wants the end.
    bool tick();
    /// Gives the terminal back, and prints the last table.
    void finish();

  private:
    class screen;
    using clock = std::chrono::steady_clock;

    void print() const;
    void draw();
    void on_keys(std::string_view keys);
    void set_next();
    [[nodiscard]] top_table::time now() const;

    top_options how_;
    top_table table_;
    std::unique_ptr<screen> screen_; ///< empty: lines
    std::size_t first_row_{};
    bool is_ended_{};
    clock::time_point next_{}; ///< the table is shown
};

} // namespace jausdump
