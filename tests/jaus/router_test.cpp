// The router of one node: who gets a message, and what is refused.
#include "support/catch.hpp"
#include <jauscat/jaus/routing/router.hpp>

#include <string>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
using jaus::added;
using jaus::hop;
using jaus::routed;

constexpr jaus::address make(std::uint8_t subsystem, std::uint8_t node, std::uint8_t component, std::uint8_t instance) {
    return {.instance = instance, .component = component, .node = node, .subsystem = subsystem};
}

/// Node 1.2 with the components 1.1, 33.1 (number 0, 1) and 34.1 in another program (hop 0); nodes 1.1 and 1.3 (hops 1
/// and 2), subsystem 2 (hop 3) and 3 (hop 4), one node of which is known by itself (hop 5).
struct node {
    std::array<jaus::address_place<jaus::route_entry>, 32> routes{};
    std::array<jaus::hop_state, 10> hops{};
    std::array<jaus::node_component, 6> components{};
    jaus::routing_table table{1, 2, routes, hops, components};
    jaus::router router;

    explicit node(std::uint8_t primary = 0) : router{table, primary} {
        REQUIRE(table.add_component(1, 1, 0) == added::ok);
        REQUIRE(table.add_component(33, 1, 1) == added::ok);
        REQUIRE(table.add_route(make(1, 2, 34, 0), 0) == added::ok);
        REQUIRE(table.add_route(make(1, 1, 0, 0), 1) == added::ok);
        REQUIRE(table.add_route(make(1, 3, 0, 0), 2) == added::ok);
        REQUIRE(table.add_route(make(2, 0, 0, 0), 3) == added::ok);
        REQUIRE(table.add_route(make(3, 0, 0, 0), 4) == added::ok);
        REQUIRE(table.add_route(make(3, 7, 0, 0), 5) == added::ok);
    }

    routed outcome{};
    std::string who{}; ///< c and a component's number, h and a hop's, sorted

    node& hear(const jaus::address& to, const jaus::address& source, hop from) {
        std::vector<std::string> all;
        const auto result = router.route(
            {.destination = to, .source = source}, from,
            [&](std::uint16_t number, const jaus::address& whole) {
                REQUIRE(table.next_hop(whole) == jaus::here);
                all.push_back("c" + std::to_string(number));
            },
            [&](hop h) { all.push_back("h" + std::to_string(h)); });
        REQUIRE(all.size() == result.components + result.hops);
        std::ranges::sort(all);
        who.clear();
        for (const auto& one : all) who += one + " ";
        outcome = result.outcome;
        return *this;
    }
    void expect(routed what, const std::string& whom = "") const {
        REQUIRE(std::string{describe(outcome)} == std::string{describe(what)});
        REQUIRE(who == whom);
    }
};

constexpr auto own = make(1, 2, 33, 1), neighbour = make(1, 1, 33, 1), stranger = make(2, 1, 33, 1);

} // namespace

TEST_CASE("a message to one component is delivered there and nowhere else") {
    node n;
    n.hear(make(1, 2, 33, 1), stranger, 3).expect(routed::ok, "c1 ");
    n.hear(make(1, 2, 1, 1), own, jaus::here).expect(routed::ok, "c0 ");
    n.hear(make(1, 2, 34, 9), stranger, 3).expect(routed::ok, "h0 ");
    n.hear(make(1, 3, 33, 1), own, jaus::here).expect(routed::ok, "h2 ");
    n.hear(make(2, 3, 33, 1), own, jaus::here).expect(routed::ok, "h3 ");
    n.hear(make(3, 6, 33, 1), own, jaus::here).expect(routed::ok, "h4 ");
    n.hear(make(3, 7, 33, 1), own, jaus::here).expect(routed::ok, "h5 ");
    n.hear(make(1, 3, 33, 1), make(1, 2, 34, 5), 0).expect(routed::ok, "h2 ");
    REQUIRE(n.table.next_hop(make(3, 7, 1, 1)) == hop{5});
    REQUIRE(n.table.next_hop(own) == jaus::here);
    REQUIRE_FALSE(n.table.next_hop(make(9, 7, 1, 1)));
}

TEST_CASE("a message that cannot be routed has a reason") {
    node n;
    n.hear(make(1, 2, 35, 1), own, jaus::here).expect(routed::no_such_component);
    n.hear(make(1, 2, 33, 2), stranger, 3).expect(routed::no_such_component);
    n.hear(make(1, 9, 33, 1), own, jaus::here).expect(routed::no_route);
    n.hear(make(9, 1, 33, 1), own, jaus::here).expect(routed::no_route);
    n.hear(make(9, 255, 33, 1), own, jaus::here).expect(routed::no_route);
    n.hear(make(1, 2, 34, 1), make(1, 2, 34, 2), 0).expect(routed::would_return);
    n.hear(make(3, 1, 33, 1), stranger, 3).expect(routed::between_subsystems);
    n.hear(make(3, 255, 33, 1), stranger, 3).expect(routed::between_subsystems);
    n.hear(make(3, 1, 33, 1), stranger, 1).expect(routed::between_subsystems);
    n.hear(make(1, 3, 33, 1), neighbour, 1).expect(routed::not_the_relay);
    n.hear(make(2, 255, 33, 1), neighbour, 1).expect(routed::not_the_relay);
    n.hear(make(1, 2, 77, 255), own, jaus::here).expect(routed::no_receiver);
    for (const auto& invalid : {make(0, 2, 33, 1), make(1, 0, 33, 1), make(1, 2, 0, 1), make(1, 2, 33, 0)})
        n.hear(invalid, own, jaus::here).expect(routed::invalid_destination);
    for (const auto& invalid : {make(0, 2, 33, 1), make(1, 255, 33, 1), make(1, 2, 255, 1), make(1, 2, 33, 255)})
        n.hear(own, invalid, 3).expect(routed::invalid_source);
}

TEST_CASE("a local source from outside is refused") {
    node n;
    for (const hop from : {hop{1}, hop{3}, hop{4}, jaus::unknown_hop, hop{9}}) {
        n.hear(make(1, 2, 1, 1), own, from).expect(routed::source_is_local);
        n.hear(make(255, 255, 1, 1), own, from).expect(routed::source_is_local);
    }
    n.hear(make(1, 2, 1, 1), neighbour, 3).expect(routed::source_is_local);
    n.hear(make(1, 2, 1, 1), neighbour, jaus::unknown_hop).expect(routed::source_is_local);
    n.hear(make(1, 2, 1, 1), neighbour, 1).expect(routed::ok, "c0 ");
    n.hear(make(1, 2, 1, 1), stranger, jaus::unknown_hop).expect(routed::ok, "c0 ");
}

TEST_CASE("a component of the node cannot send as another") {
    node n;
    n.hear(make(2, 1, 1, 1), make(1, 2, 34, 1), 0).expect(routed::ok, "h3 ");
    n.hear(make(2, 1, 1, 1), make(1, 2, 33, 1), 0).expect(routed::source_is_local);
    n.hear(make(2, 1, 1, 1), make(1, 2, 35, 1), 0).expect(routed::source_is_elsewhere);
    n.hear(make(2, 1, 1, 1), stranger, 0).expect(routed::source_is_elsewhere);
    n.hear(make(2, 1, 1, 1), stranger, jaus::here).expect(routed::source_is_elsewhere);
}

TEST_CASE("a broadcast is sent to all its destinations, except its sender") {
    node n;
    n.hear(make(255, 255, 255, 255), own, jaus::here).expect(routed::ok, "c0 h0 h1 h2 h3 h4 ");
    n.hear(make(255, 255, 1, 1), own, jaus::here).expect(routed::ok, "c0 h1 h2 h3 h4 ");
    n.hear(make(1, 255, 33, 255), own, jaus::here).expect(routed::ok, "h1 h2 ");
    n.hear(make(1, 2, 255, 1), own, jaus::here).expect(routed::ok, "c0 h0 ");
    n.hear(make(2, 255, 33, 1), own, jaus::here).expect(routed::ok, "h3 ");
    n.hear(make(255, 3, 33, 1), own, jaus::here).expect(routed::ok, "h2 h3 h4 ");
    n.hear(make(255, 255, 34, 255), make(1, 2, 34, 1), 0).expect(routed::ok, "h1 h2 h3 h4 ");
}

TEST_CASE("only the primary forwards broadcasts") {
    constexpr auto all = make(255, 255, 255, 255);
    node none{0}, other{1}, primary{2};
    none.hear(all, stranger, 3).expect(routed::ok, "c0 c1 h0 ");
    none.hear(all, neighbour, 1).expect(routed::ok, "c0 c1 h0 ");
    other.hear(all, stranger, 3).expect(routed::ok, "c0 c1 h0 ");
    other.hear(all, neighbour, 1).expect(routed::ok, "c0 c1 h0 ");
    other.hear(all, own, jaus::here).expect(routed::ok, "c0 h0 h1 ");
    primary.hear(all, stranger, 3).expect(routed::ok, "c0 c1 h0 h1 h2 ");
    primary.hear(all, stranger, 1).expect(routed::ok, "c0 c1 h0 ");
    primary.hear(all, neighbour, 1).expect(routed::ok, "c0 c1 h0 h2 h3 h4 ");
    primary.hear(all, own, jaus::here).expect(routed::ok, "c0 h0 h1 h2 h3 h4 ");
    primary.hear(make(1, 3, 33, 1), neighbour, 1).expect(routed::ok, "h2 ");
}

TEST_CASE("a multicast group replaces unicast routes, except for peers outside of the group") {
    node n{2};
    REQUIRE(n.table.add_route(make(255, 255, 0, 0), 6) == added::ok);
    n.hear(make(255, 255, 1, 1), own, jaus::here).expect(routed::ok, "c0 h1 h2 h6 ");
    n.hear(make(2, 255, 1, 1), own, jaus::here).expect(routed::ok, "h3 ");
    n.table.keep_outside_groups(4);
    n.hear(make(255, 255, 1, 1), own, jaus::here).expect(routed::ok, "c0 h1 h2 h4 h6 ");
    REQUIRE(n.table.add_route(make(1, 255, 0, 0), 7) == added::ok);
    n.hear(make(255, 255, 1, 1), own, jaus::here).expect(routed::ok, "c0 h4 h6 h7 ");
    n.hear(make(255, 255, 1, 1), neighbour, 1).expect(routed::ok, "c0 h4 h6 ");
    n.hear(make(255, 255, 1, 1), stranger, 3).expect(routed::ok, "c0 h7 ");
    // From a node that is known by the group alone: the other nodes have received it, too.
    n.hear(make(255, 255, 1, 1), make(1, 9, 33, 1), 7).expect(routed::ok, "c0 h4 h6 ");
}

TEST_CASE("a node with a primary sends broadcasts to the group of its subsystem, and those for others to the primary") {
    node n{1};
    REQUIRE(n.table.add_route(make(1, 255, 0, 0), 7) == added::ok);
    n.hear(make(1, 255, 33, 1), own, jaus::here).expect(routed::ok, "h7 ");
    n.hear(make(2, 255, 33, 1), own, jaus::here).expect(routed::ok, "h1 ");
}

TEST_CASE("a broadcast takes the route to a whole node, not those to its components") {
    node n;
    REQUIRE(n.table.add_route(make(1, 3, 33, 0), 8) == added::ok);
    n.hear(make(1, 255, 33, 1), own, jaus::here).expect(routed::ok, "h1 h2 ");
    n.hear(make(1, 3, 33, 1), own, jaus::here).expect(routed::ok, "h8 ");
}

TEST_CASE("of two routes to the same parts of a subsystem a broadcast takes the wider one") {
    const bool is_any_node = GENERATE(false, true), is_any_component = GENERATE(false, true),
               is_any_instance = GENERATE(false, true);
    const jaus::address narrow = make(4, 3, 33, 1);
    auto wide = narrow;
    if (is_any_node) wide.node = 0;
    if (is_any_component) wide.component = 0;
    if (is_any_instance) wide.instance = 0;
    if (wide == narrow) return;
    node n;
    REQUIRE(n.table.add_route(narrow, 8) == added::ok);
    REQUIRE(n.table.add_route(wide, 9) == added::ok);
    n.hear(make(4, 255, 255, 255), own, jaus::here).expect(routed::ok, "h9 ");
}

TEST_CASE("a multicast group of one component gets messages to that component only") {
    node n{2};
    REQUIRE(n.table.add_route(make(255, 255, 33, 0), 6) == added::ok);
    n.hear(make(255, 255, 33, 1), own, jaus::here).expect(routed::ok, "h1 h2 h6 ");
    n.hear(make(255, 255, 255, 255), own, jaus::here).expect(routed::ok, "c0 h0 h1 h2 h3 h4 ");
}

TEST_CASE("a broadcast by way of a primary without a route is reported, and delivered in the node") {
    node n{9};
    n.hear(make(255, 255, 255, 255), own, jaus::here).expect(routed::no_route, "c0 h0 ");
}

TEST_CASE("a broadcast ends among several nodes that are all configured as primary") {
    // Nodes 1 to 3 are told to be the primary, 4 knows 1 as such. Each has a route to each other node by its number.
    struct member {
        std::array<jaus::address_place<jaus::route_entry>, 16> routes{};
        std::array<jaus::hop_state, 6> hops{};
        std::array<jaus::node_component, 1> components{};
        jaus::routing_table table;
        jaus::router router;
        explicit member(std::uint8_t id)
            : table{1, id, routes, hops, components}, router{table, static_cast<std::uint8_t>(id == 4 ? 1 : id)} {
            REQUIRE(table.add_component(33, 1, 0) == added::ok);
            for (std::uint8_t other = 1; other != 5; ++other)
                if (other != id) REQUIRE(table.add_route(make(1, other, 0, 0), other) == added::ok);
            REQUIRE(table.add_route(make(2, 0, 0, 0), 5) == added::ok);
        }
    };
    std::array<member, 4> all{member{1}, member{2}, member{3}, member{4}};
    std::array<int, 6> got{};
    struct datagram {
        hop to, from;
    };
    std::vector<datagram> under_way{};
    const jaus::header head{.destination = make(255, 255, 33, 1), .source = make(1, 4, 33, 1)};
    const auto route = [&](hop at, hop from) {
        all[at - 1U].router.route(
            head, from, [&](auto, auto&&) { ++got[at]; }, [&](hop by) { under_way.push_back({by, at}); });
    };
    route(4, jaus::here);
    std::size_t sent = 0;
    for (; !under_way.empty() && sent < 100; ++sent) {
        const auto one = under_way.front();
        under_way.erase(under_way.begin());
        one.to == 5 ? void(++got[5]) : route(one.to, one.from);
    }
    REQUIRE(sent == 4);
    REQUIRE(got == std::array{0, 1, 1, 1, 0, 1});
}

TEST_CASE("the route to all other subsystems is used where there is no other") {
    node n;
    REQUIRE(n.table.add_route(make(0, 0, 0, 0), 8) == added::ok);
    n.hear(make(9, 1, 1, 1), own, jaus::here).expect(routed::ok, "h8 ");
    n.hear(make(9, 255, 1, 1), own, jaus::here).expect(routed::ok, "h8 ");
    n.hear(make(2, 255, 1, 1), own, jaus::here).expect(routed::ok, "h3 ");
    n.hear(make(255, 255, 1, 1), own, jaus::here).expect(routed::ok, "c0 h1 h2 h3 h4 h8 ");
    n.hear(make(1, 9, 1, 1), stranger, 3).expect(routed::no_route);
}

TEST_CASE("a program below the node manager sends everything to it") {
    std::array<jaus::address_place<jaus::route_entry>, 8> routes{};
    std::array<jaus::hop_state, 2> hops{};
    std::array<jaus::node_component, 2> components{};
    jaus::routing_table table{1, 2, routes, hops, components};
    jaus::router router{table, 1};
    REQUIRE(table.add_component(34, 1, 7) == added::ok);
    REQUIRE(table.add_route(make(1, 2, 0, 0), 0) == added::ok);
    REQUIRE(table.add_route(make(0, 0, 0, 0), 0) == added::ok);
    const auto route = [&](const jaus::address& to, const jaus::address& source, hop from) {
        std::string who;
        const auto result = router.route(
            {.destination = to, .source = source}, from,
            [&](std::uint16_t number, const jaus::address&) { who += "c" + std::to_string(number); },
            [&](hop h) { who += "h" + std::to_string(h); });
        return result ? who : std::string{describe(result.outcome)};
    };
    const auto me = make(1, 2, 34, 1);
    REQUIRE(route(make(1, 2, 33, 1), me, jaus::here) == "h0");
    REQUIRE(route(make(2, 2, 33, 1), me, jaus::here) == "h0");
    REQUIRE(route(make(255, 255, 255, 255), me, jaus::here) == "h0");
    REQUIRE(route(make(1, 2, 255, 1), me, jaus::here) == "h0");
    REQUIRE(route(make(255, 255, 255, 255), make(2, 1, 1, 1), 0) == "c7");
    REQUIRE(route(make(1, 2, 34, 1), make(1, 2, 33, 1), 0) == "c7");
    REQUIRE(route(make(1, 2, 34, 1), me, 0) == describe(routed::source_is_local));
    REQUIRE(route(make(1, 2, 35, 1), make(2, 1, 1, 1), 0) == describe(routed::would_return));
}

TEST_CASE("invalid entries, and entries beyond the capacity, are refused") {
    std::array<jaus::address_place<jaus::route_entry>, 4> routes{};
    std::array<jaus::hop_state, 1> hops{};
    std::array<jaus::node_component, 1> components{};
    jaus::routing_table table{1, 2, routes, hops, components};
    REQUIRE(table.add_component(0, 1, 7) == added::invalid_address);
    REQUIRE(table.add_component(33, 255, 7) == added::invalid_address);
    REQUIRE(table.add_component(33, 1, 7) == added::ok);
    REQUIRE(table.add_component(34, 1, 7) == added::full);
    REQUIRE(table.add_route(make(2, 0, 0, 0), 1) == added::invalid_hop);
    REQUIRE(table.add_route(make(2, 0, 0, 0), 0) == added::ok);
    REQUIRE(table.add_route(make(2, 0, 0, 0), 0) == added::duplicate);
    REQUIRE(table.add_route(make(3, 0, 0, 0), 0) == added::ok);
    REQUIRE(table.add_route(make(4, 0, 0, 0), 0) == added::full);
}
