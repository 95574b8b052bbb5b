// Networks of nodes that route for each other: whatever they look like, every message arrives once at each addressee
// and nowhere else, and none circulates.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/routing/node_manager.hpp>
#include <jauscat/jaus/routing/router.hpp>

#include <deque>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
using jaus::added;
using jaus::hop;

constexpr jaus::address make(unsigned subsystem, unsigned node, unsigned component = 0, unsigned instance = 0) {
    const auto id = [](unsigned n) { return static_cast<std::uint8_t>(n); };
    return {id(instance), id(component), id(node), id(subsystem)};
}

/// A program with a few components of one node; its hops are other programs, or groups of them.
struct program {
    std::uint8_t subsystem{}, node{};
    std::array<jaus::address_place<jaus::route_entry>, 64> routes{};
    std::array<jaus::hop_state, 40> hops{};
    std::array<jaus::node_component, 8> places{};
    jaus::routing_table table{subsystem, node, routes, hops, places};
    jaus::router router{table};
    std::vector<jaus::address> components{}; ///< by number

    program(unsigned s, unsigned n, unsigned primary)
        : subsystem{static_cast<std::uint8_t>(s)},
          node{static_cast<std::uint8_t>(n)},
          router{table, static_cast<std::uint8_t>(primary)} {}
    void add(unsigned component, unsigned instance) {
        const auto whole = make(subsystem, node, component, instance);
        REQUIRE(table.add_component(whole.component, whole.instance, static_cast<std::uint16_t>(components.size())) ==
                added::ok);
        components.push_back(whole);
    }
    void lead(const jaus::address& to, std::size_t by) {
        REQUIRE(table.add_route(to, static_cast<hop>(by)) == added::ok);
    }
};

constexpr unsigned subsystems = 4, nodes = 4;
constexpr std::array<jaus::address, 3> components_of_node{make(0, 0, 1, 1), make(0, 0, 33, 1), make(0, 0, 33, 2)};
constexpr std::size_t group_hops = 32; // programs are hops 0 to 31, groups come behind

bool is_named(const jaus::address& to, const jaus::address& one) {
    const auto level = [](std::uint8_t a, std::uint8_t b) { return a == 255 || a == b; };
    return level(to.subsystem, one.subsystem) && level(to.node, one.node) && level(to.component, one.component) &&
           level(to.instance, one.instance);
}

struct network {
    std::vector<std::unique_ptr<program>> programs{};
    std::vector<std::vector<std::size_t>> groups{}; ///< members of each
    std::array<unsigned, subsystems + 1> primary{}; ///< of each subsystem, from 1; 0: none
    std::size_t steps{};                            ///< datagrams that the last message took

    [[nodiscard]] std::size_t manager(unsigned s, unsigned n) const { return (s - 1) * nodes + n - 1; }

    /// Who gets the message of a component, as often as they get it.
    std::vector<jaus::address> send(const jaus::address& source, const jaus::address& to) {
        struct datagram {
            std::size_t program;
            hop from;
        };
        std::vector<jaus::address> got;
        std::deque<datagram> under_way;
        for (std::size_t p = 0; p != programs.size(); ++p)
            if (std::ranges::find(programs[p]->components, source) != programs[p]->components.end())
                under_way.push_back({p, jaus::here});
        REQUIRE(under_way.size() == 1);
        for (steps = 0; !under_way.empty(); ++steps) {
            if (steps == 10'000) return got; // it circulates
            const std::size_t at = under_way.front().program;
            const hop from = under_way.front().from;
            under_way.pop_front();
            auto& p = *programs[at];
            p.router.route(
                {.destination = to, .source = source}, from,
                [&](std::uint16_t number, const jaus::address& whole) {
                    if (p.components[number] == whole) got.push_back(whole);
                },
                [&](hop h) {
                    if (h < group_hops) {
                        under_way.push_back({h, static_cast<hop>(at)});
                        return;
                    }
                    for (const std::size_t member : groups[h - group_hops]) {
                        if (member == at) continue;
                        // Who is no neighbour comes from the group.
                        const bool known = programs[member]->hops[at].kind != jaus::hop_kind::unused;
                        under_way.push_back({member, known ? static_cast<hop>(at) : h});
                    }
                });
        }
        return got;
    }
};

class builder {
  public:
    explicit builder(unsigned seed) : random_{seed} {
        for (unsigned s = 1; s <= subsystems; ++s) net_.primary[s] = one_in(4) ? 0 : 1 + below(nodes);
        for (unsigned s = 1; s <= subsystems; ++s)
            for (unsigned n = 1; n <= nodes; ++n)
                net_.programs.push_back(std::make_unique<program>(s, n, net_.primary[s]));
    }

    /// Ways as the router wants them, in any of the forms it allows.
    network sound() {
        add_components();
        if (one_in(2)) add_group_between();
        for (unsigned s = 1; s <= subsystems; ++s) add_ways_within(s);
        for (unsigned s = 1; s <= subsystems; ++s)
            for (unsigned n = 1; n <= nodes; ++n) add_ways_out(s, n);
        return std::move(net_);
    }
    /// Ways to anybody by anybody. Only that hops are what the tables take them for holds.
    network senseless() {
        add_components();
        for (auto& p : net_.programs) {
            if (p->table.manager()) continue;
            for (unsigned s = 0; s <= subsystems; ++s)
                for (unsigned n = 0; n <= nodes; ++n) {
                    if (one_in(3) || (s == p->subsystem && (n == 0 || n == p->node))) continue;
                    for (int tries = 0; tries != 20; ++tries) {
                        const std::size_t other = below(subsystems * nodes);
                        const auto& q = *net_.programs[other];
                        if (&q == p.get() || (s == p->subsystem && q.subsystem != s) ||
                            (s != p->subsystem && q.subsystem != p->subsystem && one_in(2)))
                            continue;
                        p->lead(make(s, n), other);
                        break;
                    }
                }
            // Every neighbour in the own subsystem is known as such.
            for (unsigned n = 1; n <= nodes; ++n)
                if (n != p->node &&
                    p->table.kind_of(static_cast<hop>(net_.manager(p->subsystem, n))) != jaus::hop_kind::node)
                    p->lead(make(p->subsystem, n, 77), net_.manager(p->subsystem, n));
        }
        return std::move(net_);
    }

  private:
    unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
    bool one_in(unsigned n) { return below(n) == 0; }
    program& at(unsigned s, unsigned n) { return *net_.programs[net_.manager(s, n)]; }

    // Some components live in a program of their own, below that of the node manager.
    void add_components() {
        for (unsigned s = 1; s <= subsystems; ++s)
            for (unsigned n = 1; n <= nodes; ++n) {
                program* below_it = nullptr;
                for (const auto& c : components_of_node) {
                    if (c.component == 1 || !one_in(4)) {
                        at(s, n).add(c.component, c.instance);
                        continue;
                    }
                    if (below_it == nullptr && net_.programs.size() < group_hops) {
                        net_.programs.push_back(std::make_unique<program>(s, n, net_.primary[s]));
                        below_it = net_.programs.back().get();
                        below_it->lead(make(s, n), net_.manager(s, n));
                        if (one_in(2)) below_it->lead(make(s, 0), net_.manager(s, n));
                        below_it->lead(make(0, 0), net_.manager(s, n));
                    }
                    if (below_it == nullptr) {
                        at(s, n).add(c.component, c.instance);
                        continue;
                    }
                    below_it->add(c.component, c.instance);
                    at(s, n).lead(make(s, n, c.component, c.instance), net_.programs.size() - 1);
                }
            }
    }
    // Heard by the primaries, and by all nodes of subsystems without, which send to each other by it too.
    void add_group_between() {
        auto& members = net_.groups.emplace_back();
        for (unsigned s = 1; s <= subsystems; ++s)
            for (unsigned n = 1; n <= nodes; ++n) {
                if (net_.primary[s] != 0 && net_.primary[s] != n) continue;
                at(s, n).lead(make(255, 255), group_hops);
                if (net_.primary[s] == 0) at(s, n).lead(make(s, 255), group_hops);
                members.push_back(net_.manager(s, n));
            }
    }
    void add_ways_within(unsigned s) {
        const unsigned primary = net_.primary[s];
        const bool star = primary != 0 && one_in(2);
        std::array<std::array<bool, nodes + 1>, nodes + 1> direct{}; // what links there are, both routes
        for (unsigned n = 1; n <= nodes; ++n)
            for (unsigned other = 1; other != n; ++other)
                direct[n][other] = direct[other][n] =
                    primary == 0 || n == primary || other == primary || (!star && one_in(2));
        for (unsigned n = 1; n <= nodes; ++n) {
            if (star && n != primary && one_in(2)) {
                at(s, n).lead(make(s, 0), net_.manager(s, primary));
                continue;
            }
            for (unsigned other = 1; other <= nodes; ++other)
                if (other != n) at(s, n).lead(make(s, other), net_.manager(s, direct[n][other] ? other : primary));
        }
        if (primary == 0 || star || !one_in(3)) return;
        // A group of the subsystem's nodes.
        for (unsigned n = 1; n <= nodes; ++n) at(s, n).lead(make(s, 255), group_hops + net_.groups.size());
        auto& members = net_.groups.emplace_back();
        for (unsigned n = 1; n <= nodes; ++n) members.push_back(net_.manager(s, n));
    }
    void add_ways_out(unsigned s, unsigned n) {
        const unsigned primary = net_.primary[s];
        const bool leaves_it = primary != 0 && n != primary;
        if (leaves_it && one_in(3)) return at(s, n).lead(make(0, 0), net_.manager(s, primary));
        for (unsigned other = 1; other <= subsystems; ++other) {
            if (other == s) continue;
            if (leaves_it && one_in(2)) {
                at(s, n).lead(make(other, 0), net_.manager(s, primary));
                continue;
            }
            const unsigned entrance = net_.primary[other];
            if (entrance != 0) at(s, n).lead(make(other, 0), net_.manager(other, entrance));
            for (unsigned m = 1; m <= nodes; ++m)
                if (entrance == 0 || one_in(3)) at(s, n).lead(make(other, m), net_.manager(other, m));
        }
    }

    std::mt19937 random_;
    network net_{};
};

std::vector<jaus::address> everybody() {
    std::vector<jaus::address> all;
    for (unsigned s = 1; s <= subsystems; ++s)
        for (unsigned n = 1; n <= nodes; ++n)
            for (const auto& c : components_of_node) all.push_back(make(s, n, c.component, c.instance));
    return all;
}

std::string text(const jaus::address& a) {
    return std::to_string(a.subsystem) + "." + std::to_string(a.node) + "." + std::to_string(a.component) + "." +
           std::to_string(a.instance);
}
std::string text(const std::vector<jaus::address>& all) {
    std::vector<std::string> names;
    for (const auto& a : all) names.push_back(text(a));
    std::ranges::sort(names);
    std::string joined;
    for (const auto& name : names) joined += name + " ";
    return joined;
}

/// Every destination with a 255 in it.
std::vector<jaus::address> all_broadcasts() {
    std::vector<jaus::address> all;
    for (const unsigned s : {1U, 2U, 3U, 4U, 255U})
        for (const unsigned n : {1U, 2U, 3U, 4U, 255U})
            for (const unsigned c : {1U, 33U, 255U})
                for (const unsigned i : {1U, 2U, 255U})
                    if (s == 255 || n == 255 || c == 255 || i == 255) all.push_back(make(s, n, c, i));
    return all;
}

/// The node manager of a program in a network.
struct watcher {
    explicit watcher(const jaus::address& self) : manager{self, description, {places, lists, report}} {}

    std::array<jaus::configured_component, 2> others{{{33, 1}, {33, 2}}};
    jaus::node_description description{.components = others};
    std::array<jaus::liveness_table::place, 64> places{};
    std::array<std::byte, 1000> lists{}, report{};
    jaus::node_manager manager;
    bool runs = true;
};

/// A network with a node manager on each node, and time.
struct living_network {
    explicit living_network(network n) : net{std::move(n)} {
        for (unsigned s = 1; s <= subsystems; ++s)
            for (unsigned n1 = 1; n1 <= nodes; ++n1) watchers.push_back(std::make_unique<watcher>(make(s, n1, 1, 1)));
    }
    void run_until(support::instant end) {
        const auto out = [this](std::span<const std::byte> m) { under_way.emplace_back(m.begin(), m.end()); };
        for (; now < end.at; now += std::chrono::milliseconds{100}) {
            for (auto& w : watchers)
                if (w->runs) w->manager.on_time(now, out);
            for (; !under_way.empty(); under_way.pop_front()) {
                const auto message = jaus::split(under_way.front());
                REQUIRE(message);
                for (const auto& who : net.send(message.header.source, message.header.destination)) {
                    auto& w = *watchers[net.manager(who.subsystem, who.node)];
                    if (!w.runs || who.component != 1) continue;
                    REQUIRE(w.manager.on_message(message.header, message.body, now, out) ==
                            jaus::message_outcome::handled);
                }
            }
        }
    }
    network net;
    std::vector<std::unique_ptr<watcher>> watchers{};
    std::deque<std::vector<std::byte>> under_way{};
    jauscat::time_point now{};
};

} // namespace

TEST_CASE("in every network each message to one component arrives there once") {
    const auto all = everybody();
    for (unsigned seed = 1; seed != 100; ++seed) {
        auto net = builder{seed}.sound();
        std::string wrong;
        for (const auto& source : all)
            for (const auto& to : all) {
                const auto got = net.send(source, to);
                if (got != std::vector{to}) wrong = text(source) + " to " + text(to) + ": " + text(got);
                if (net.steps > 8) wrong = text(source) + " to " + text(to) + " takes a long way";
            }
        INFO("network " << seed);
        REQUIRE(wrong == "");
    }
}

TEST_CASE("in every network each broadcast arrives once at all its destinations except its sender") {
    const auto all = everybody();
    const auto broadcasts = all_broadcasts();
    for (unsigned seed = 1; seed != 100; ++seed) {
        auto net = builder{seed}.sound();
        std::string wrong;
        for (std::size_t i = seed % 8; i < all.size(); i += 8)
            for (const auto& to : broadcasts) {
                std::vector<jaus::address> named;
                for (const auto& one : all)
                    if (is_named(to, one) && one != all[i]) named.push_back(one);
                const auto got = text(net.send(all[i], to));
                if (got != text(named)) wrong = text(all[i]) + " to " + text(to) + ": " + got + " not " + text(named);
            }
        INFO("network " << seed);
        REQUIRE(wrong == "");
    }
}

TEST_CASE("with wrong routes messages can be lost but never circulate or reach a wrong destination") {
    const auto all = everybody();
    const auto broadcasts = all_broadcasts();
    std::size_t arrived = 0, longest = 0;
    for (unsigned seed = 1; seed != 100; ++seed) {
        auto net = builder{seed}.senseless();
        bool right = true;
        const auto check = [&](const jaus::address& source, const jaus::address& to) {
            const auto got = net.send(source, to);
            for (const auto& one : got) right = right && is_named(to, one);
            arrived += got.size();
            longest = std::max(longest, net.steps);
            right = right && net.steps < 1000;
        };
        for (const auto& source : all)
            for (const auto& to : all) check(source, to);
        for (std::size_t i = seed % 12; i < all.size(); i += 12)
            for (const auto& to : broadcasts) check(all[i], to);
        INFO("network " << seed << ", longest " << longest);
        REQUIRE(right);
    }
    REQUIRE(arrived > 100'000);
}

TEST_CASE("the node managers of a network discover each other and detect leaving and returning nodes") {
    using namespace std::chrono_literals;
    for (unsigned seed = 1; seed != 20; ++seed) {
        living_network living{builder{seed}.sound()};
        auto& watchers = living.watchers;
        const std::size_t who = seed % watchers.size();
        const auto gone = make(static_cast<unsigned>(who / nodes + 1), static_cast<unsigned>(who % nodes + 1), 1, 1);
        // All other nodes, and two more components on each of those in the own subsystem.
        const auto check = [&](bool there) {
            for (std::size_t i = 0; i != watchers.size(); ++i) {
                if (i == who) continue;
                const auto& present = watchers[i]->manager.present();
                const std::size_t of_gone = there ? 0 : i / nodes == who / nodes ? 3 : 1;
                REQUIRE(present.size() == subsystems * nodes - 1 + 2 * (nodes - 1) - of_gone);
                REQUIRE((present.find(gone) != nullptr) == there);
            }
        };
        living.run_until(2s);
        check(true);
        watchers[who]->runs = false;
        living.run_until(3s);
        check(true);
        living.run_until(6s);
        check(false);
        watchers[who]->runs = true;
        living.run_until(60s);
        check(true);
    }
}
