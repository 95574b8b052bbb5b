// The simulation itself: a seed is the whole run, faults strike, a violation becomes a story.
#include "simulation/joint_system.hpp"
#include "simulation/memory_watch.hpp"
#include "simulation/messages.hpp"
#include "simulation/simulation.hpp"
#include "simulation/world.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <numeric>

using namespace simulation;
using namespace std::chrono_literals;

TEST_CASE("a seed replays exactly, and another seed gives another run") {
    const settings what{.seed = 7, .length = 20s};
    const auto first = run(what), again = run(what);
    REQUIRE(first.steps > 1000);
    REQUIRE(first.digest == again.digest);
    REQUIRE(first.steps == again.steps);
    REQUIRE(first.faults == again.faults);
    REQUIRE(run({.seed = 8, .length = 20s}).digest != first.digest);
}

TEST_CASE("a run leaves no state for the next") {
    const settings what{.seed = 9, .length = 5s};
    const auto first = run(what);
    static_cast<void>(run({.seed = 10, .length = 5s}));
    REQUIRE(run(what).digest == first.digest);
}

TEST_CASE("without faults none occurs, and the contract holds") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto result = run({.seed = seed, .length = 30s, .faults = 0});
        REQUIRE_FALSE(result.broken);
        // Programs that number everything 0 or mix kinds are no fault that can be switched off while they run.
        REQUIRE(result.faults[static_cast<std::size_t>(fault::datagram_lost)] == 0);
        REQUIRE(result.faults[static_cast<std::size_t>(fault::process_killed)] == 0);
    }
}

TEST_CASE("switching one kind of fault off does not change the probability of the others") {
    fault_source all{generator{5}, every_fault}, fewer{generator{5}, every_fault & ~only(fault::datagram_lost)};
    for (int i = 0; i != 10'000; ++i) {
        static_cast<void>(all.strikes(fault::datagram_lost, 100'000));
        static_cast<void>(fewer.strikes(fault::datagram_lost, 100'000));
        REQUIRE(all.strikes(fault::datagram_doubled, 100'000) == fewer.strikes(fault::datagram_doubled, 100'000));
    }
    REQUIRE(fewer.counts()[static_cast<std::size_t>(fault::datagram_lost)] == 0);
}

TEST_CASE("the velocity of each joint says which command it is of") {
    for (const command_number command : {1U, 2U, 1990U, 3999U})
        for (std::size_t joint = 0; joint != most_joints; ++joint) {
            REQUIRE(command_of_velocity(velocity_of(command, joint), joint) == command);
            REQUIRE(command_of_velocity(velocity_of(command, joint), joint + 2) != command);
            REQUIRE_FALSE(command_of_velocity(velocity_of(command, joint) + 2, joint));
        }
    REQUIRE_FALSE(command_of_velocity(0, 0));
}

TEST_CASE("each kind of fault occurs in rings of drives and arms") {
    fault_counts sum{};
    for (std::uint64_t seed = 1; seed != 9; ++seed) {
        const auto result = run({.seed = seed, .length = 30s, .system = system_kind::robot});
        REQUIRE_FALSE(result.broken);
        for (std::size_t i = 0; i != fault_count; ++i) sum[i] += result.faults[i];
    }
    for (std::size_t i = 0; i != fault_count; ++i) {
        if (fault_names[i].starts_with("joint-") || fault_names[i] == name_of(fault::wall_clock_back)) continue;
        INFO(fault_names[i]);
        CHECK(sum[i] != 0);
    }
}

TEST_CASE("each kind of fault of joints occurs, and each check of them compares something") {
    run_result sum{};
    for (std::uint64_t seed = 0; seed != joint_trial_turn; ++seed) {
        const auto result = run({.seed = seed, .length = 30s, .system = system_kind::joints});
        REQUIRE_FALSE(result.broken);
        for (std::size_t i = 0; i != fault_count; ++i) sum.faults[i] += result.faults[i];
        for (std::size_t i = 0; i != sum.compared.size(); ++i) sum.compared[i] += result.compared[i];
    }
    for (std::size_t i = 0; i != fault_count; ++i) {
        INFO(fault_names[i]);
        CHECK((sum.faults[i] != 0) == fault_names[i].starts_with("joint-"));
    }
    for (auto i = static_cast<std::size_t>(comparison::motor_limits);
         i <= static_cast<std::size_t>(comparison::following_told); ++i) {
        INFO(comparison_names[i]);
        CHECK(sum.compared[i] != 0);
    }
}

TEST_CASE("each check of what a bridge tells compares something") {
    comparison_counts sum{};
    for (std::uint64_t seed = 1; seed != 9; ++seed) {
        const auto result = run({.seed = seed, .length = 20s, .system = system_kind::robot});
        REQUIRE_FALSE(result.broken);
        for (std::size_t i = 0; i != sum.size(); ++i) sum[i] += result.compared[i];
    }
    for (auto i = static_cast<std::size_t>(comparison::turn_idle); i != sum.size(); ++i) {
        INFO(comparison_names[i]);
        CHECK(sum[i] != 0);
    }
}

TEST_CASE("an application beside the bridge gets the answers of its own transfers") {
    for (const auto system : {system_kind::mailbox, system_kind::cyclic, system_kind::robot}) {
        const auto result = run({.seed = 7, .length = 20s, .system = system});
        CHECK_FALSE(result.broken);
        CHECK(result.compared[static_cast<std::size_t>(comparison::direct_upload)] > 10);
        CHECK(result.compared[static_cast<std::size_t>(comparison::direct_download)] > 10);
    }
}

TEST_CASE("events of one instant are executed in the order in which they were added") {
    struct listener final : actor {
        std::vector<std::uint32_t> heard{};
        void on_event(std::uint8_t, std::uint32_t argument) override { heard.push_back(argument); }
    } who;
    world w{1};
    for (std::uint32_t i = 0; i != 100; ++i) w.at(simulation::time{i % 3}, who, 0, i);
    w.run(simulation::time{10});
    std::vector<std::uint32_t> expected(100);
    std::iota(expected.begin(), expected.end(), 0U);
    std::ranges::stable_sort(expected, {}, [](std::uint32_t i) { return i % 3; });
    REQUIRE(who.heard == expected);
}

TEST_CASE("growing memory violates the contract, reused memory does not") {
    struct user final : actor {
        bool keeps{};
        std::vector<std::vector<std::byte>> held{};
        void on_event(std::uint8_t, std::uint32_t) override {
            held.emplace_back(std::size_t{1} << 20U);
            if (!keeps && held.size() > 4) held.clear();
        }
    };
    for (const bool keeps : {false, true}) {
        world w{1};
        user who;
        who.keeps = keeps;
        memory_watch watch{w};
        w.check = [&] { watch.look(); };
        for (int i = 0; i != 120; ++i) w.at(std::chrono::seconds{i}, who, 0);
        w.run(2min);
        REQUIRE(w.broken().has_value() == keeps);
        if (keeps) REQUIRE(w.broken()->point == contract::memory);
    }
}

TEST_CASE("a story says what was queued, merged and dropped, and which stops it requires") {
    const std::vector<std::string> names{"network", "arm", "operator", "slave"};
    const auto text = [&](happening one) { return text_of(one, names); };
    const happening effort{.who = 1, .whom = 2, .code = 0x0405, .number = 8, .message = 3};
    const auto of_effort = [&](deed what, command_number command, const char* why) {
        auto made = effort;
        made.what = what;
        made.value = command;
        made.why = why;
        return made;
    };
    const std::string message = "Set Wrench Effort 0405h, number 8 (message 3)";
    CHECK(text(of_effort(deed::gets, 17, "")) == "arm gets from operator: " + message + ", command 17");
    CHECK(text(of_effort(deed::queues, 0, "")) == "arm keeps for later: " + message);
    CHECK(text(of_effort(deed::merges, 17, "")) ==
          "arm merges with the command before, which its slave has not confirmed: " + message + ", command 17");
    CHECK(text(of_effort(deed::drops, 17, "a newer command has replaced it")) ==
          "arm does not execute of operator: " + message + ", command 17: a newer command has replaced it");
    CHECK(text({.what = deed::owes_stop, .who = 1, .number = 1, .why = "its slave is lost"}) ==
          "arm requires Set Emergency, because its slave is lost");
    CHECK(text({.what = deed::stop_refused, .who = 1, .value = 3}) == "arm: its slave refuses rest, attempt 3");
    CHECK(text({.what = deed::loses_slave, .who = 1, .whom = 3, .why = "it does not answer"}) ==
          "arm counts slave as lost, because it does not answer");
    CHECK(text({.what = deed::hears_of, .who = 1, .value = 0x02010000}) == "arm is told that 2.1.0.0 is there");
    CHECK(text({.what = deed::begins_transfer, .who = 1, .whom = 3, .number = 2, .value = 9, .why = "reads"}) ==
          "arm: transfer 9 of its application reads subindex 2 of slave");
    CHECK(text({.what = deed::ends_transfer, .who = 1, .whom = 3, .value = 9, .why = "is given up"}) ==
          "arm: transfer 9 of its application, to slave, is given up");
    CHECK(text({.what = deed::connects, .who = 1, .whom = 2, .value = 3}) ==
          "arm: its connection to operator is stale: requested again");
    CHECK(text({.what = deed::ignores_report, .who = 1, .whom = 2, .number = 7}) ==
          "arm ignores report 7 of operator, because it has a newer one");
}

TEST_CASE("a violation is reported with the expected and the found value, and the lines that lead to it") {
    run_result result{
        .broken =
            violation{.point = contract::s2, .at = 2s, .who = 1, .message = 3, .expected = "rest", .found = "motion"},
        .names = {"network", "robot", "operator", "stranger"}};
    result.story = {
        {.at = 1s, .what = deed::dies, .who = 3},
        {.at = 1s, .what = deed::sends, .who = 2, .whom = 1, .code = 0x0003, .number = 8, .message = 3},
        {.at = 1s,
         .what = deed::drops,
         .who = 1,
         .whom = 2,
         .code = 0x0003,
         .number = 8,
         .message = 3,
         .why = "a newer command of the same sender has replaced it"},
        {.at = 2s, .what = deed::acknowledges, .who = 1, .whom = 2, .code = 0x0003, .number = 8, .message = 3}};
    const auto text = story_text({.seed = 4711}, result);
    REQUIRE(text == R"(S2: stop orders come first, and are repeated until they are confirmed
  seed      4711, at robot
  expected  rest
  found     motion
      1.0000 s  operator sends to robot: Standby 0003h, number 8 (message 3)
      1.0000 s  robot does not execute of operator: Standby 0003h, number 8 (message 3): a newer command of the same sender has replaced it
      2.0000 s  robot acknowledges to operator: Standby 0003h, number 8 (message 3)
)");
}
