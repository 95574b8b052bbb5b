// Judges nodes by what the simulated network lets through: who must be known and who must be lost, which reports and
// broadcasts must arrive, and which values are old.
#pragma once

#include "simulation/process.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

/// The value of a report: of a later life of its provider, or with a higher count, it is newer.
struct reported_value {
    std::uint32_t life{}, count{};
    friend constexpr auto operator<=>(const reported_value&, const reported_value&) = default;
};

/// How reports come to a consumer.
enum class report_way : std::uint8_t { connection, periodic_event, change_event };

class node_judge {
  public:
    /// The time after which a silent node or consumer is lost: the default of the library's nodes.
    static constexpr time timeout = std::chrono::seconds{3};

    node_judge(world& w, const network& n) : world_{w}, network_{n} {}
    /// The next node; its number is its port.
    void add(const process& program) { nodes_.push_back({.program = &program}); }
    /// Its number in the story.
    [[nodiscard]] std::uint8_t number_of(std::size_t node) const { return nodes_[node].program->number(); }
    /// The ports that messages pass between two nodes, both included. In the other direction they pass the same.
    void connect(std::vector<std::uint8_t> path);

    /// A program begins, and knows nothing of an earlier life.
    void starts(std::size_t node);
    /// Whether a node has another one in its list of living nodes, at this time.
    void sees(std::size_t observer, std::size_t peer, bool is_present);

    void changes(std::size_t provider, reported_value value);
    void requests(std::size_t consumer, std::size_t provider, report_way way, time period);
    void sends_report(std::size_t provider, std::size_t consumer);
    void gets_report(std::size_t consumer, report_way way, reported_value value);
    /// Whether the consumers have what they ought to have, at this time.
    void check_reports();

    void broadcasts(std::size_t sender, std::uint32_t number);
    void gets_broadcast(std::size_t receiver, std::size_t sender, std::uint32_t number);
    void check_broadcasts();

    /// A clock of JAUS time is set to `value`, or reports it, both at the node's local time.
    void sets_time(std::size_t node, time value);
    void reports_time(std::size_t node, time value);

  private:
    struct subscription {
        std::size_t provider{};
        time period{}; ///< 0: there is none
        time got_at{};
    };
    struct change {
        time at{};
        reported_value value{};
    };
    struct node_account {
        const process* program{};
        std::array<subscription, 3> subscriptions{}; ///< by report_way
        std::deque<change> changes{};                ///< the last ones, the newest in front
        std::optional<time> clock{};                 ///< JAUS time at local time 0
    };
    struct broadcast {
        std::size_t sender{};
        std::uint32_t number{};
        time at{};
        std::vector<unsigned> got{}; ///< how often, by node
    };

    [[nodiscard]] const std::vector<std::uint8_t>& path(std::size_t from, std::size_t to) const;
    /// Since when nothing that `from` sends gets to `to`; what was on its way has arrived.
    [[nodiscard]] std::optional<time> deaf_since(std::size_t from, std::size_t to) const;
    /// Since when all that one of them sends gets to the other in time.
    [[nodiscard]] std::optional<time> quiet_since(std::size_t a, std::size_t b) const;
    void check_subscription(std::size_t consumer, report_way way);
    void breaks(contract point, std::size_t node, std::size_t other, std::string expected, std::string found);

    world& world_;
    const network& network_;
    std::vector<node_account> nodes_{};
    std::vector<std::vector<std::uint8_t>> paths_{};
    std::deque<broadcast> broadcasts_{};
};

} // namespace simulation
