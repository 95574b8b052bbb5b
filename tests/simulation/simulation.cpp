#include "simulation/simulation.hpp"

#include "simulation/bridge_program.hpp"
#include "simulation/dictionary_judge.hpp"
#include "simulation/inspector.hpp"
#include "simulation/joint_system.hpp"
#include "simulation/memory_watch.hpp"
#include "simulation/node_system.hpp"
#include "simulation/operators.hpp"
#include "simulation/robot.hpp"

#include <cstdio>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>

namespace simulation {
namespace {

constexpr jaus::address subsystem(std::uint8_t id) { return {0, 0, 0, id}; }
constexpr jaus::address component_of(std::uint8_t id, std::uint8_t component) { return {1, component, 1, id}; }

/// In half of the runs a second foreign operator has the address of the first one but for its instance, its node or its
/// subsystem.
std::optional<jaus::address> twin_of_foreign(world& w) {
    auto random = w.stream(1001);
    if (random.below(2) == 0) return std::nullopt;
    auto made = component_of(5, 32);
    switch (random.below(3)) {
    case 0: made.instance = 2; break;
    case 1: made.node = 2; break;
    default: made.subsystem = 6;
    }
    return made;
}

/// In a part of the runs, none of seeds.txt, somebody sends what operators seldom send.
bool has_inspector(std::uint64_t seed) {
    constexpr std::array<std::uint64_t, 6> with{3, 5, 9, 12, 14, 15};
    return std::ranges::find(with, seed % 16) != with.end();
}
place place_of_inspector() { return {"inspector", {0, 32, 1, 7}}; }

/// Robots that are JAUS components themselves, and operators of both kinds.
class jaus_system {
  public:
    jaus_system(world& w, const settings& what) : world_{w}, network_{w}, model_{w, network_} {
        auto random = w.stream(1000);
        // A program that is one component has no node manager; others have one.
        const auto at = [&](const char* name, std::uint8_t id, std::uint8_t component) {
            const bool has_manager = random.below(4) != 0;
            places_.push_back({name, has_manager ? subsystem(id) : jaus::address{0, component, 1, id}});
        };
        // Where a robot has two actuators, its place has both.
        at("robot a", 2, 33);
        at("robot b", 3, 33);
        // Memory for sets of more than 256 packets takes long to get, so only a part of the runs has it.
        const bool has_long_data = w.stream(1005).below(3) == 0;
        if (has_long_data)
            for (auto& each : places_) each.large_data_memory = std::size_t{10} << 20U;
        at("operator a", 1, 32);
        at("operator b", 4, 32);
        const auto twin = twin_of_foreign(w);
        if (twin) places_.back() = {"twin operator", *twin};
        places_.push_back({"foreign operator", {0, 32, 1, 5}});
        if (has_inspector(what.seed)) places_.push_back(place_of_inspector());
        for (const std::size_t i : {0U, 1U}) {
            auto made = std::make_unique<robot>(world_, network_, model_, places_, i);
            instances_[i] = made->instances();
            processes_.push_back(std::move(made));
        }
        const auto some_robot = [&] { return static_cast<std::uint8_t>(2 + random.below(2)); };
        auto random_instance = w.stream(1004);
        const auto unit_of = [&](std::uint8_t id) {
            auto made = component_of(id, 33);
            made.instance = static_cast<std::uint8_t>(1 + random_instance.below(instances_[id - 2U]));
            return target_unit{made};
        };
        add<operator_program>(2U, unit_of(some_robot()), has_long_data);
        const auto robot_of_b = some_robot();
        const auto robot_of_foreign = some_robot();
        const auto unit_of_foreign = unit_of(robot_of_foreign);
        const auto add_foreign = [&](const jaus::address& self, std::size_t place) {
            processes_.push_back(std::make_unique<foreign_operator>(w, network_, model_, self, unit_of_foreign,
                                                                    static_cast<std::uint8_t>(robot_of_foreign - 2),
                                                                    places_[place].name));
        };
        if (twin)
            add_foreign(*twin, 3);
        else
            add<operator_program>(3U, unit_of(robot_of_b), has_long_data);
        add_foreign(component_of(5, 32), 4);
        if (has_inspector(what.seed))
            processes_.push_back(std::make_unique<inspector>(w, network_, model_, component_of(7, 32), unit_of_foreign,
                                                             static_cast<std::uint8_t>(robot_of_foreign - 2),
                                                             *processes_[robot_of_foreign - 2U], component_of(1, 32),
                                                             std::uint8_t{2}));
        network_.start();
        for (auto& one : processes_)
            if ((what.absent >> one->number() & 1U) == 0) one->start();
        w.check = [this, has_long_data] {
            // Of some hundred packets one is always lost otherwise, so that no long set would have to arrive.
            if (has_long_data) network_.set_calm(world_.now() / std::chrono::seconds{1} % 30 >= 20);
            model_.check();
            for (auto& each : processes_) each->check();
            memory_.look();
        };
    }

  private:
    template <class Program, class... More> void add(std::size_t place, More... more) {
        processes_.push_back(std::make_unique<Program>(world_, network_, model_, places_, place, more...));
    }
    world& world_;
    network network_;
    model model_;
    std::vector<place> places_{};
    std::vector<std::unique_ptr<process>> processes_{};
    std::array<std::size_t, 2> instances_{}; ///< of each robot's actuators
    memory_watch memory_{world_};
};

using units = std::vector<unit_settings>;

/// Four slaves, a component each.
units make_arms(system_kind kind, generator& random) {
    units made;
    for (std::size_t i = 0; i != 4; ++i) {
        const bool either = random.below(2) == 0;
        made.push_back(
            {.slaves = {i}, .cyclic = kind == system_kind::cyclic || (kind == system_kind::mixed && either)});
    }
    const bool are_all_cyclic = std::ranges::all_of(made, &unit_settings::cyclic);
    for (auto& each : made) each.limit = are_all_cyclic ? bridging::at_rest_in_cycles : bridging::at_rest_by_mailbox;
    return made;
}

/// 2 to 8 slaves: arms of 1 to 6 drives with one axis, or up to 4 with two, which lie on the ring one after the other
/// or in between others; in a robot also other arms.
units make_drives(system_kind kind, generator& random) {
    const std::size_t count = 2 + random.below(7);
    std::vector<std::size_t> free(count);
    std::iota(free.begin(), free.end(), std::size_t{});
    if (random.below(3) == 0)
        for (std::size_t i = count; i > 1; --i) std::swap(free[i - 1], free[random.below(i)]);
    units made;
    while (!free.empty()) {
        const bool is_drive = kind != system_kind::robot || made.empty() || random.below(2) == 0;
        constexpr std::array<std::size_t, 5> sizes{1, 2, 3, 4, 6};
        auto size = is_drive ? sizes[random.below(sizes.size())] : 1;
        if (size > free.size()) size = 1;
        unit_settings one{.slaves = {free.begin(), free.begin() + static_cast<std::ptrdiff_t>(size)},
                          .cyclic = is_drive || random.below(2) == 0,
                          .axes = is_drive ? 1 + std::size_t{size <= 4 && random.below(3) == 0} : 0};
        one.limit = one.cyclic ? bridging::at_rest_in_cycles : bridging::at_rest_by_mailbox;
        free.erase(free.begin(), free.begin() + static_cast<std::ptrdiff_t>(size));
        made.push_back(std::move(one));
    }
    return made;
}

/// A bridge with a ring, and operators of both kinds.
class bridge_system {
  public:
    bridge_system(world& w, const settings& what, system_kind kind)
        : network_{w},
          wire_{w,
                [this](std::size_t i, std::size_t axis, command_number command) {
                    if (bridge_) bridge_->moved(i, axis, command);
                },
                has_drives(kind)},
          model_{w, network_} {
        auto random = w.stream(1000);
        bridge_settings made{.units = has_drives(kind) ? make_drives(kind, random) : make_arms(kind, random)};
        if (has_drives(kind)) {
            constexpr std::array periods{5, 10, 20};
            made.period = std::chrono::milliseconds{periods[random.below(periods.size())]};
            made.checks_serials = true;
            made.has_clocks = kind == system_kind::clocks;
            if (made.has_clocks) made.period = std::chrono::milliseconds{2 + 3 * random.below(2)};
        }
        made.is_shared = what.seed % 8 == 7;
        if (has_inspector(what.seed)) { // none of seeds.txt
            auto random_ring = w.stream(1012);
            constexpr std::array<std::size_t, 4> lanes{1, 2, 3, bridge_settings::most_lanes};
            made.lanes = lanes[random_ring.below(lanes.size())];
            made.is_one_by_one = random_ring.below(3) == 0;
        }
        add_slaves(made, random, w.stream(1014));
        for (const auto& each : made.units) {
            const auto node = station_of(each.slaves.front());
            places_.push_back({"node of arm " + std::to_string(places_.size()), {0, 0, node, arm_unit::subsystem}});
        }
        places_.push_back({"operator a", subsystem(1)});
        const auto twin = twin_of_foreign(w);
        places_.push_back(twin ? place{"twin operator", *twin} : place{"operator b", subsystem(4)});
        places_.push_back({"foreign operator", {0, 32, 1, 5}});
        if (has_inspector(what.seed)) places_.push_back(place_of_inspector());
        bridge_ = std::make_unique<bridge_program>(w, network_, model_, places_, wire_, made);
        const auto arm = [&] { return static_cast<std::uint8_t>(random.below(made.units.size())); };
        const auto unit = [&](std::uint8_t i) {
            const auto node = station_of(made.units[i].slaves.front());
            return target_unit{{1, 33, node, arm_unit::subsystem}, made.units[i].joints()};
        };
        const auto of_a = arm(), of_b = arm(), of_foreign = arm();
        const auto add_operator = [&](std::size_t i, std::uint8_t of) {
            operators_.push_back(
                std::make_unique<operator_program>(w, network_, model_, places_, made.units.size() + i, unit(of)));
        };
        const auto add_foreign = [&](const jaus::address& self, const std::string& name) {
            operators_.push_back(
                std::make_unique<foreign_operator>(w, network_, model_, self, unit(of_foreign), of_foreign, name));
        };
        add_operator(0, of_a);
        if (twin)
            add_foreign(*twin, "twin operator");
        else
            add_operator(1, of_b);
        add_foreign(component_of(5, 32), "foreign operator");
        if (has_inspector(what.seed))
            operators_.push_back(std::make_unique<inspector>(w, network_, model_, component_of(7, 32), unit(of_foreign),
                                                             of_foreign, *bridge_, component_of(1, 32),
                                                             static_cast<std::uint8_t>(made.units.size())));
        dictionary_.emplace(w);
        wire_.start(*bridge_);
        network_.start();
        bridge_->start();
        dictionary_->start();
        for (auto& one : operators_)
            if ((what.absent >> one->number() & 1U) == 0) one->start();
        w.check = [this] {
            model_.check();
            bridge_->check();
            for (auto& each : operators_) each->check();
            memory_->look();
        };
        memory_.emplace(w);
    }

  private:
    [[nodiscard]] static bool has_drives(system_kind kind) {
        return kind == system_kind::drives || kind == system_kind::robot || kind == system_kind::clocks;
    }
    /// Off by up to 100 ppm.
    [[nodiscard]] static ethercat::clock_error some_clock(generator& random) {
        return {.drift = static_cast<std::int32_t>(random.below(200'001)) - 100'000, .start = random.next() >> 2};
    }
    [[nodiscard]] static std::uint8_t station_of(std::size_t slave) { return static_cast<std::uint8_t>(2 + slave); }
    void add_slaves(const bridge_settings& what, generator& random, generator random_arm) {
        const auto& all = what.units;
        const auto count = std::accumulate(all.begin(), all.end(), std::size_t{},
                                           [](std::size_t sum, const auto& each) { return sum + each.slaves.size(); });
        // Frames for which an answer is late, so that one may come after its transfer was given up.
        const auto answer_delay = what.is_shared ? static_cast<std::uint32_t>(random.below(5)) : 0;
        for (std::size_t i = 0; i != count; ++i) {
            const auto whose = std::ranges::find_if(
                all, [i](const unit_settings& each) { return std::ranges::count(each.slaves, i) != 0; });
            const auto place = std::ranges::find(whose->slaves, i) - whose->slaves.begin();
            if (whose->axes == 0)
                wire_.add_arm("arm " + std::to_string(i), station_of(i), whose->cyclic,
                              {.answer_delay = answer_delay, .knows_emergencies = random_arm.below(8) != 0});
            else
                wire_.add_drive("drive " + std::to_string(i), station_of(i), whose->axes,
                                static_cast<std::size_t>(place) * whose->axes,
                                what.has_clocks ? std::optional{some_clock(random)} : std::nullopt);
        }
    }

    network network_;
    ring wire_;
    model model_;
    std::vector<place> places_{};
    std::unique_ptr<bridge_program> bridge_{};
    std::vector<std::unique_ptr<process>> operators_{};
    std::optional<dictionary_judge> dictionary_{};
    std::optional<memory_watch> memory_{};
};

bool is_chatter(deed what) {
    return what == deed::sends || what == deed::gets || what == deed::loses || what == deed::doubles ||
           what == deed::delays || what == deed::hears_acknowledged || what == deed::hears_refused ||
           what == deed::hears_nothing || what == deed::acknowledges || what == deed::refuses || what == deed::drops ||
           what == deed::queues || what == deed::merges;
}

} // namespace

namespace {
constexpr std::array<std::string_view, 1 + system_count> system_names{"any",    "jaus",  "mailbox", "cyclic", "mixed",
                                                                      "drives", "robot", "clocks",  "nodes",  "joints"};
}

std::string_view name_of(system_kind kind) { return system_names[static_cast<std::size_t>(kind)]; }

std::optional<system_kind> system_of(const std::string& name) {
    const auto found = std::ranges::find(system_names, name);
    if (found == system_names.end()) return std::nullopt;
    return static_cast<system_kind>(found - system_names.begin());
}

run_result run(const settings& what) {
    world w{what.seed, what.faults};
    w.trace = what.trace;
    run_result result{};
    auto kind = what.system;
    if (kind == system_kind::any) kind = static_cast<system_kind>(1 + w.stream(2000).below(system_count));
    if (kind == system_kind::jaus) {
        const jaus_system system{w, what};
        w.run(what.length);
    } else if (kind == system_kind::nodes) {
        const auto system = make_node_system(w, what.absent);
        w.run(what.length);
    } else if (kind == system_kind::joints) {
        const auto trial = joint_trial_of(what.seed);
        const auto kind_of_trial = fault_of_trial(trial);
        const bool is_allowed = !kind_of_trial || w.faults.allows(*kind_of_trial);
        const auto system = make_joint_system(w, is_allowed ? trial : joint_trial::plain);
        w.run(what.length);
    } else {
        const bridge_system system{w, what, kind};
        w.run(what.length);
    }
    result.system = kind;
    result.broken = w.broken();
    result.length = w.now();
    result.steps = w.steps();
    result.digest = w.told.digest();
    result.faults = w.faults.counts();
    result.compared = w.compared();
    result.names = w.names();
    if (result.broken) result.story = w.told.last();
    return result;
}

settings shrink(const settings& what, const violation& broken) {
    settings best = what;
    best.length = broken.at;
    const auto still = [&](const settings& trial) {
        const auto again = run(trial);
        return again.broken && again.broken->point == broken.point && again.broken->expected == broken.expected;
    };
    // What is left out changes the rest a bit: the fault may come later than it did.
    best.length = std::max<time>(2 * broken.at, std::chrono::seconds{60});
    for (std::uint32_t number = 1; number != 16; ++number) {
        settings trial = best;
        trial.absent |= std::uint32_t{1} << number;
        if (number != broken.who && still(trial)) best = trial;
    }
    for (std::size_t i = 0; i != fault_count; ++i) {
        settings trial = best;
        trial.faults &= ~only(static_cast<fault>(i));
        if (still(trial)) best = trial;
    }
    return best;
}

namespace {

/// Messages on which the events turn: the one concerned, and those that changed something where it went wrong.
std::set<std::uint32_t> messages_that_matter(const run_result& result, auto&& concerns) {
    const auto& v = *result.broken;
    std::set<std::uint32_t> found{v.message};
    for (const auto& one : result.story) {
        const bool is_recent = one.at + std::chrono::seconds{1} > v.at;
        if (concerns(one) && (one.what == deed::enters_state || one.what == deed::controlled_by ||
                              (one.what == deed::executes && is_recent)))
            found.insert(one.message);
    }
    found.erase(0);
    return found;
}

std::vector<happening> what_matters(const run_result& result) {
    const auto& v = *result.broken;
    const auto concerns = [&](const happening& one) {
        return one.who == v.who || (v.whom != 0 && (one.who == v.whom || one.whom == v.whom));
    };
    const auto messages = messages_that_matter(result, concerns);
    std::vector<happening> lines;
    for (const auto& one : result.story) {
        const bool is_of_message = is_chatter(one.what) && (one.message != 0 || one.value == 0);
        if (is_of_message ? messages.count(one.message) != 0 : concerns(one)) lines.push_back(one);
    }
    constexpr std::ptrdiff_t most = 40;
    if (std::ssize(lines) > most) lines.erase(lines.begin(), lines.end() - most);
    return lines;
}

} // namespace

std::string story_text(const settings& what, const run_result& result, bool whole) {
    if (!result.broken) return "seed " + std::to_string(what.seed) + ": nothing is wrong\n";
    const auto& v = *result.broken;
    std::ostringstream text;
    text << name_of(v.point) << "\n  seed      " << what.seed << ", at " << result.names[v.who] << "\n  expected  "
         << v.expected << "\n  found     " << v.found << "\n";
    for (const auto& one : whole ? result.story : what_matters(result)) text << line_of(one, result.names) << '\n';
    return text.str();
}

} // namespace simulation
