// A table of messages by name and sender: how many, how often, the newest value.
#pragma once
#include "printer.hpp"

#include <deque>
#include <map>

namespace jausdump {

enum class top_order { code, message, source, count, rate, age };

/// What a row shows: columns are cut to `width` characters, unless it is 0.
struct top_style {
    std::size_t width{};
    palette colours{};
    /// Changed bytes are shown in reverse, else with * behind them.
    [[nodiscard]] bool has_colours() const { return *colours.end != '\0'; }
};

class top_table {
  public:
    using time = std::chrono::nanoseconds; ///< since 1970, UTC

    /// `live`: rates are those of the last messages, and a byte is marked for 2 seconds after it has changed. Else
    /// rates are those of all messages, and every byte is marked that has ever changed.
    explicit top_table(bool live) : live_{live} {}

    void add(const record& message);
    [[nodiscard]] std::size_t messages() const { return messages_; }
    [[nodiscard]] std::size_t rows() const { return rows_.size(); }
    /// Time of the newest message; 0: none has a time.
    [[nodiscard]] time newest() const { return newest_; }

    /// The heading, then `count` lines from row `begin` on. Ages count to `now`.
    [[nodiscard]] std::vector<std::string> lines(time now, top_order order, const top_style& style,
                                                 std::size_t begin = 0, std::size_t count = SIZE_MAX) const;
    /// A JSON object in a line for each row.
    [[nodiscard]] std::string json_lines(time now, top_order order) const;

  private:
    struct row {
        std::string code{}, name{}, source{};
        std::array<std::uint16_t, 4> id{}; ///< of the source
        bool is_sae{};
        std::size_t count{}, size{};
        std::optional<time> first{}, last{};
        std::deque<time> recent{};
        std::vector<std::byte> bytes{};                ///< the first of the newest body
        std::vector<std::optional<time>> changed_at{}; ///< of each of them; empty: never
    };
    [[nodiscard]] std::vector<const row*> sorted(time now, top_order order) const;
    [[nodiscard]] std::optional<double> rate_of(const row& one, time now) const;
    [[nodiscard]] bool is_marked(const row& one, std::size_t byte, time now) const;
    /// Of the columns that follow the window.
    struct widths {
        std::size_t name{}, source{};
    };
    static widths widths_for(const std::vector<const row*>& all, const top_style& style);
    [[nodiscard]] std::string line_of(const row& one, time now, const top_style& style, const widths& width) const;

    bool live_;
    std::map<std::array<std::string, 3>, row> rows_{}; ///< by code, name and source
    std::size_t messages_{};
    time newest_{};
};

} // namespace jausdump
