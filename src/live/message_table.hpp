// The newest message of each kind, as JSON.
#pragma once
#include <jauscat/net/live/live_server.hpp>

#include <array>
#include <chrono>
#include <compare>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace jauscat::net::live {

/// Rows by generation, way, source, destination and code, and whether it is an acknowledgement. Only the newest message
/// of a row is decoded, and only when an update is due.
class message_table {
  public:
    /// `begin`: time 0 of what is shown.
    message_table(const catalogue::list* messages, const catalogue::list* sae_messages, time_point begin)
        : messages_{messages}, sae_messages_{sae_messages}, begin_{begin} {}

    /// Updates begin again after a pause.
    void resume();
    void add(const net::detail::live_sample& sample);
    /// The end of an update: decodes what has changed.
    void end_update();
    /// The rows that have changed since the update `seen`, as a JSON array; empty where there are none. A row
    /// whose units have changed brings them.
    [[nodiscard]] std::string rows_since(std::uint64_t seen) const;
    /// The number of updates.
    [[nodiscard]] std::uint64_t update() const noexcept { return update_; }
    /// Samples that found no row.
    [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

  private:
    static constexpr std::size_t rate_updates = 20; ///< a rate is that of so many updates

    struct key {
        std::uint64_t from{}, to{};
        std::uint16_t code{};
        std::uint8_t way{};
        std::uint8_t acknowledgement{}; ///< 0 of other messages, also where one is wanted
        bool is_sae{};
        friend auto operator<=>(const key&, const key&) = default; // NOLINT: <=> has a 0
    };
    struct row {
        net::detail::live_sample newest{};
        std::size_t id{};
        std::uint64_t count{};
        std::array<std::uint64_t, rate_updates> counts{}; ///< at the last updates, by their number
        std::uint64_t changed{}, units_changed{};         ///< the updates that they have changed in last
        bool is_changed{};
        bool has_rate{};
        double rate{};                 ///< as it was shown last
        std::string message{}, text{}; ///< of the newest message, and of the row, as JSON without its braces
        nlohmann::ordered_json units = nlohmann::ordered_json::object(); ///< of all its messages
    };
    void write(const key& of, row& one) const;
    void decode(const key& of, row& one) const;

    const catalogue::list* messages_;
    const catalogue::list* sae_messages_;
    time_point begin_;
    std::map<key, row> rows_{};
    std::vector<row*> by_id_{};
    std::array<duration, rate_updates> times_{}; ///< of the last updates
    std::uint64_t update_{};
    std::uint64_t lost_{};
};

} // namespace jauscat::net::live
