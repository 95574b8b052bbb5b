// Finding the route to a JAUS address among 250 subsystems of 254 nodes: address_map against std::unordered_map, whose
// keys are packed addresses and which is asked once for each pattern of named levels, as the map does.
#include "pair.hpp"
#include <jauscat/jaus/routing/router.hpp>

#include <array>
#include <bit>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;

constexpr std::size_t item_count = 65536;
constexpr unsigned subsystem_count = 250, node_count = 254;

jaus::address make(unsigned subsystem, unsigned node, unsigned component = 0, unsigned instance = 0) {
    const auto id = [](unsigned n) { return static_cast<std::uint8_t>(n); };
    return {id(instance), id(component), id(node), id(subsystem)};
}

constexpr std::uint32_t packed(const jaus::address& a) { return std::bit_cast<std::uint32_t>(a); }
constexpr std::uint32_t of_node = packed({0, 0, 255, 255}), of_component = packed({0, 255, 255, 255}),
                        of_subsystem = packed({0, 0, 0, 255});

/// The same entries in both.
struct both_maps {
    std::vector<jaus::address_place<jaus::route_entry>> places =
        std::vector<jaus::address_place<jaus::route_entry>>(131072);
    jaus::address_map<jaus::route_entry> ours{places};
    std::unordered_map<std::uint32_t, jaus::route_entry> theirs{};
    std::vector<std::uint32_t> patterns{};

    bool add(const jaus::address& to, std::uint16_t number) {
        theirs.emplace(packed(to), jaus::route_entry{number});
        return ours.insert(to, {number}) == jaus::inserted::ok;
    }
};

int by_address_map(const both_maps& maps, const jaus::address& to) {
    const auto* const found = maps.ours.find(to);
    return found == nullptr ? -1 : found->value.number;
}
int by_unordered_map(const both_maps& maps, const jaus::address& to) {
    for (const std::uint32_t pattern : maps.patterns)
        if (const auto found = maps.theirs.find(packed(to) & pattern); found != maps.theirs.end())
            return found->second.number;
    return -1;
}

bool add(const std::string& name, const both_maps& maps, const std::vector<jaus::address>& wanted) {
    bool agree = maps.ours.longest_probe() < 20;
    for (const auto& to : wanted) agree = agree && by_address_map(maps, to) == by_unordered_map(maps, to);
    const std::span all{wanted};
    bench::pair(
        "look-up among " + std::to_string(maps.ours.size()) + " entries, " + name + " (unordered_map)", all,
        [&maps](const jaus::address& to) { return by_address_map(maps, to); }, all,
        [&maps](const jaus::address& to) { return by_unordered_map(maps, to); });
    return agree;
}

/// The router of node 251.1 with a route to each of the others.
struct whole_router {
    std::vector<jaus::address_place<jaus::route_entry>> routes =
        std::vector<jaus::address_place<jaus::route_entry>>(131072);
    std::vector<jaus::hop_state> hops = std::vector<jaus::hop_state>(subsystem_count * node_count);
    std::array<jaus::node_component, 1> components{};
    jaus::routing_table table{251, 1, routes, hops, components};
    jaus::router router{table};
};

} // namespace

bool bench::add_route_benchmarks() {
    static both_maps by_node, by_three;
    static whole_router whole;
    static std::vector<jaus::address> wanted, mixed;
    std::mt19937 random{4};
    const auto id = [&](unsigned most) { return 1 + static_cast<unsigned>(random() % most); };
    bool all_added = whole.table.add_component(33, 1, 0) == jaus::added::ok;
    for (unsigned s = 1; s <= subsystem_count; ++s) {
        all_added = all_added && by_three.add(make(s, 0), static_cast<std::uint16_t>(s));
        for (unsigned n = 1; n <= node_count; ++n) {
            const auto number = static_cast<std::uint16_t>((s - 1) * node_count + n - 1);
            all_added = all_added && by_node.add(make(s, n), number) &&
                        whole.table.add_route(make(s, n), number) == jaus::added::ok;
            // Two thirds of the nodes, a component of every tenth of them.
            if (n % 3 != 0) all_added = all_added && by_three.add(make(s, n), number);
            if (n % 30 == 1) all_added = all_added && by_three.add(make(s, n, 33), number);
        }
    }
    by_node.patterns = {of_node};
    by_three.patterns = {of_component, of_node, of_subsystem};
    for (std::size_t i = 0; i != item_count; ++i) {
        wanted.push_back(make(id(subsystem_count), id(node_count), 33, 1));
        mixed.push_back(make(id(254), id(254), id(40), 1));
    }
    const bool agree = add("one pattern", by_node, wanted) && add("three patterns", by_three, mixed);

    const std::span all{std::as_const(wanted)};
    bench::pair(
        "routing among 63500 entries, one pattern (unordered_map, look-up alone)", all,
        [](const jaus::address& to) {
            int went = -1;
            whole.router.route(
                {.destination = to, .source = {1, 33, 1, 251}}, jaus::here, [](std::uint16_t, const jaus::address&) {},
                [&](jaus::hop by) { went = by; });
            return went;
        },
        all, [](const jaus::address& to) { return by_unordered_map(by_node, to); });
    return all_added && agree;
}
