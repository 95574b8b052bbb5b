#include "simulation/node_judge.hpp"

#include <algorithm>

namespace simulation {
namespace {

using std::chrono::milliseconds, std::chrono::seconds;

constexpr time slack = milliseconds{150};
constexpr time of_heartbeat = milliseconds{1500}; // one a second
constexpr time to_arrive = milliseconds{20};      // through all nodes of an undisturbed path

std::string in_ms(time t) { return std::to_string(t / milliseconds{1}) + " ms"; }
std::string text(const reported_value& value) {
    return std::to_string(value.count) + " of life " + std::to_string(value.life);
}
const char* name_of(report_way way) {
    switch (way) {
    case report_way::connection: return "reports of its service connection";
    case report_way::periodic_event: return "its periodic events";
    default: return "its events of changes";
    }
}

// After a disturbance. A stale connection is requested again each second, and up to 32 reports of a provider that
// counts anew are taken for old ones.
time time_to_return(time period) { return node_judge::timeout + seconds{2} + slack + 36 * period; }

} // namespace

void node_judge::connect(std::vector<std::uint8_t> path) {
    paths_.push_back(path);
    std::ranges::reverse(path);
    paths_.push_back(std::move(path));
}

const std::vector<std::uint8_t>& node_judge::path(std::size_t from, std::size_t to) const {
    return *std::ranges::find_if(paths_, [&](const auto& one) { return one.front() == from && one.back() == to; });
}

std::optional<time> node_judge::deaf_since(std::size_t from, std::size_t to) const {
    const auto& way = path(from, to);
    std::optional<time> first;
    const auto consider = [&](const std::optional<time>& since) {
        if (since && (!first || *since < *first)) first = since;
    };
    for (std::size_t i = 0; i + 1 != way.size(); ++i) {
        consider(nodes_[way[i]].program->silent_since());
        consider(network_.cut_since(way[i], way[i + 1]));
    }
    if (!first) return first;
    // What a program on the way has kept while it was suspended, it passes on when it goes on.
    for (std::size_t i = 1; i != way.size(); ++i) first = std::max(*first, nodes_[way[i]].program->jumped_at());
    return *first + static_cast<std::int64_t>(way.size() - 1) * network::longest_delay;
}

std::optional<time> node_judge::quiet_since(std::size_t a, std::size_t b) const {
    const auto& way = path(a, b);
    time last{};
    for (std::size_t i = 0; i != way.size(); ++i) {
        const auto& program = *nodes_[way[i]].program;
        if (!program.running()) return std::nullopt;
        last = std::max(last, program.jumped_at());
        if (i + 1 == way.size()) break;
        if (network_.cut_since(way[i], way[i + 1]) || network_.cut_since(way[i + 1], way[i])) return std::nullopt;
        last = std::max(last, network_.disturbed_at(way[i], way[i + 1]));
    }
    return last;
}

void node_judge::starts(std::size_t node) {
    auto& one = nodes_[node];
    one.changes.clear();
    one.clock.reset();
}

// ---------------------------------------------------------------------------------------------------- liveness

void node_judge::sees(std::size_t observer, std::size_t peer, bool is_present) {
    if (const auto since = deaf_since(peer, observer); since && world_.now() - *since > timeout) {
        world_.compares(comparison::silent_node_lost);
        if (is_present && world_.now() - *since > timeout + slack)
            breaks(contract::s8, observer, peer, "a node that is silent for " + in_ms(timeout) + " is lost",
                   "it is there, " + in_ms(world_.now() - *since) + " after the last heartbeat could arrive");
    }
    const auto since = quiet_since(peer, observer);
    if (!since || world_.now() - *since < of_heartbeat) return;
    world_.compares(comparison::heard_node_known);
    if (!is_present)
        breaks(contract::availability, observer, peer, "a node whose heartbeats arrive is known",
               "it is not, and nothing was lost for " + in_ms(world_.now() - *since));
}

// ---------------------------------------------------------------------------------------------------- reports

void node_judge::changes(std::size_t provider, reported_value value) {
    auto& kept = nodes_[provider].changes;
    kept.push_front({world_.now(), value});
    if (kept.size() > 64) kept.pop_back();
}

void node_judge::requests(std::size_t consumer, std::size_t provider, report_way way, time period) {
    auto& one = nodes_[consumer].subscriptions[static_cast<std::size_t>(way)];
    one.provider = provider;
    one.period = period;
}

void node_judge::sends_report(std::size_t provider, std::size_t consumer) {
    const auto since = deaf_since(consumer, provider);
    if (!since) return;
    world_.compares(comparison::lost_consumer_dropped);
    if (world_.now() - *since > timeout + slack)
        breaks(contract::s8, provider, consumer, "the reports for a consumer end when it is lost",
               "one was sent " + in_ms(world_.now() - *since) + " after its last message could arrive");
}

void node_judge::gets_report(std::size_t consumer, report_way way, reported_value value) {
    auto& one = nodes_[consumer].subscriptions[static_cast<std::size_t>(way)];
    one.got_at = world_.now();
    const auto since = quiet_since(consumer, one.provider);
    if (!since || world_.now() - *since < timeout) return;
    const auto& kept = nodes_[one.provider].changes;
    const auto found = std::ranges::find(kept, value, &change::value);
    if (found == kept.end() || found == kept.begin()) {
        if (found != kept.end() || kept.size() < 64) world_.compares(comparison::report_current);
        if (found == kept.end() && kept.size() < 64 && !kept.empty())
            breaks(contract::s7, consumer, one.provider, "a value that its provider has had",
                   "the value " + text(value));
        return;
    }
    world_.compares(comparison::report_current);
    const time replaced_at = std::prev(found)->at;
    if (world_.now() - replaced_at > to_arrive)
        breaks(contract::s4, consumer, one.provider, "the present value of the provider",
               "the value " + text(value) + ", which was replaced " + in_ms(world_.now() - replaced_at) + " ago");
}

void node_judge::check_subscription(std::size_t consumer, report_way way) {
    const auto& one = nodes_[consumer].subscriptions[static_cast<std::size_t>(way)];
    if (one.period == time{}) return;
    const auto since = quiet_since(consumer, one.provider);
    if (!since || world_.now() - *since < time_to_return(one.period)) return;
    world_.compares(comparison::reports_come);
    if (world_.now() - one.got_at > 3 * one.period + slack)
        breaks(contract::availability, consumer, one.provider,
               std::string{"a consumer gets "} + name_of(way) + ", also after its provider was lost",
               "none for " + in_ms(world_.now() - one.got_at) + ", and nothing was lost for " +
                   in_ms(world_.now() - *since));
}

// Events on change are left out: after a restart of the provider, one of another requester may have the same ID, and
// Report Events does not say whose it is.
void node_judge::check_reports() {
    for (std::size_t i = 0; i != nodes_.size(); ++i)
        for (const auto way : {report_way::connection, report_way::periodic_event}) check_subscription(i, way);
}

// ---------------------------------------------------------------------------------------------------- broadcasts

void node_judge::broadcasts(std::size_t sender, std::uint32_t number) {
    broadcasts_.push_back({sender, number, world_.now(), std::vector<unsigned>(nodes_.size())});
}

void node_judge::gets_broadcast(std::size_t receiver, std::size_t sender, std::uint32_t number) {
    if (receiver == sender)
        return breaks(contract::s1, receiver, sender, "the sender of a broadcast does not get it",
                      "it has got number " + std::to_string(number));
    const auto found = std::ranges::find_if(
        broadcasts_, [&](const broadcast& one) { return one.sender == sender && one.number == number; });
    if (found == broadcasts_.end()) return;
    const auto since = quiet_since(sender, receiver);
    if (++found->got[receiver] > 1 && since && *since < found->at)
        breaks(contract::s1, receiver, sender, "a broadcast arrives once",
               "number " + std::to_string(number) + " has come again, " + in_ms(world_.now() - found->at) +
                   " after it was sent");
}

void node_judge::check_broadcasts() {
    while (!broadcasts_.empty() && world_.now() - broadcasts_.front().at > to_arrive) {
        const auto one = std::move(broadcasts_.front());
        broadcasts_.pop_front();
        for (std::size_t i = 0; i != nodes_.size(); ++i) {
            if (i == one.sender) continue;
            const auto since = quiet_since(one.sender, i);
            if (!since || *since >= one.at) continue;
            world_.compares(comparison::broadcast_arrives);
            if (one.got[i] == 0)
                breaks(contract::s1, i, one.sender, "a broadcast of which nothing was lost arrives",
                       "number " + std::to_string(one.number) + " has not, " + in_ms(world_.now() - one.at) + " later");
        }
    }
}

// ---------------------------------------------------------------------------------------------------- JAUS time

void node_judge::sets_time(std::size_t node, time value) { nodes_[node].clock = value - nodes_[node].program->local(); }

void node_judge::reports_time(std::size_t node, time value) {
    const auto& one = nodes_[node];
    if (!one.clock) return;
    world_.compares(comparison::time_reported);
    const time expected = *one.clock + one.program->local();
    if (value > expected || expected - value >= milliseconds{1})
        breaks(contract::s4, node, node, "the time that was set, and what has passed since: " + in_ms(expected),
               "reported: " + in_ms(value));
}

void node_judge::breaks(contract point, std::size_t node, std::size_t other, std::string expected, std::string found) {
    world_.breaks({.point = point,
                   .who = nodes_[node].program->number(),
                   .whom = nodes_[other].program->number(),
                   .expected = std::move(expected),
                   .found = std::move(found)});
}

} // namespace simulation
