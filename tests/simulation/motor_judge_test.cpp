// The judge of motors finds what a motor must not do, and nothing else.
#include "simulation/motor_judge.hpp"
#include "simulation/simulation.hpp"
#include "support/catch.hpp"

using namespace simulation;
using namespace std::chrono_literals;

namespace {

using jauscat::cia402::mode;
using jauscat::cia402::state;

constexpr joint_limits limits{
    .velocity = 10'000, .acceleration = 200'000, .min_position = -20'000, .max_position = 20'000};
constexpr motor_sample enabled{
    .state = state::operation_enabled, .mode = mode::cyclic_synchronous_position, .is_operational = true};

/// Samples each millisecond; what the judge finds in the last one.
template <class Change> bool last_breaks(int count, motor_sample each, Change change) {
    motor_judge judge{limits};
    bool found = false;
    for (int i = 0; i != count; ++i) {
        each.at = i * 1ms;
        change(each, i);
        const auto breach = judge.look(each);
        if (i + 1 != count) REQUIRE_FALSE(breach);
        found = breach.has_value();
    }
    return found;
}

} // namespace

TEST_CASE("a motor above its highest velocity is found, one that overshoots a little is not") {
    for (const double sign : {-1.0, 1.0}) {
        REQUIRE_FALSE(last_breaks(1, enabled, [&](motor_sample& one, int) { one.velocity = sign * 11'000; }));
        REQUIRE(last_breaks(1, enabled, [&](motor_sample& one, int) { one.velocity = sign * 12'000; }));
    }
}

TEST_CASE("a motor beyond its position limits and the way to brake is found") {
    for (const double sign : {-1.0, 1.0}) {
        REQUIRE_FALSE(last_breaks(1, enabled, [&](motor_sample& one, int) { one.position = sign * 20'700; }));
        REQUIRE(last_breaks(1, enabled, [&](motor_sample& one, int) { one.position = sign * 20'800; }));
    }
}

TEST_CASE("a drive that is switched off or leaves OP while its motor turns is found") {
    auto turning = enabled;
    turning.velocity = 500;
    const auto off = [](motor_sample& one, int i) {
        if (i == 2) one.state = state::switch_on_disabled;
    };
    const auto leaves_op = [](motor_sample& one, int i) { one.is_operational = i != 2; };
    REQUIRE(last_breaks(3, turning, off));
    REQUIRE(last_breaks(3, turning, leaves_op));
    REQUIRE_FALSE(last_breaks(3, enabled, off));
    REQUIRE_FALSE(last_breaks(3, enabled, leaves_op));
    turning.is_disturbed = true; // the drive does it by itself
    REQUIRE_FALSE(last_breaks(3, turning, off));
}

TEST_CASE("a drive moves to an increment while it is switched on: 10 ms later it must not be switched off in motion") {
    const auto breaks_off_at = [](int off) {
        return last_breaks(off + 1, enabled, [=](motor_sample& one, int i) {
            const bool has_power = i >= 2 && i != off;
            one.state = has_power ? state::operation_enabled : state::switched_on;
            one.velocity = i >= 2 ? 500 : 0;
        });
    };
    REQUIRE_FALSE(breaks_off_at(10));
    REQUIRE(breaks_off_at(11));

    motor_judge judge{limits};
    auto one = enabled;
    REQUIRE_FALSE(judge.look(one));
    REQUIRE_FALSE(judge.is_settling(0ms)); // it was on before
    one.state = state::switched_on;
    one.at = 1ms;
    REQUIRE_FALSE(judge.look(one));
    one.state = state::operation_enabled;
    one.at = 2ms;
    REQUIRE_FALSE(judge.look(one));
    REQUIRE(judge.is_settling(11ms));
    REQUIRE_FALSE(judge.is_settling(12ms));
}

TEST_CASE("two profile steps in one cycle are found") {
    REQUIRE_FALSE(last_breaks(9, enabled, [](motor_sample& one, int) { one.target_position += 10; }));
    REQUIRE(last_breaks(9, enabled, [](motor_sample& one, int i) { one.target_position += i == 8 ? 19 : 10; }));
}

TEST_CASE("a velocity that changes faster than the ramp is found") {
    REQUIRE_FALSE(last_breaks(51, enabled, [](motor_sample& one, int i) { one.velocity = i * 200; }));
    REQUIRE(last_breaks(51, enabled, [](motor_sample& one, int i) { one.velocity = -9'000 + i * 360; }));
}

TEST_CASE("the moment in which a motor waits for its second set-point between two modes counts for no ramp") {
    const auto drive = [](int changed_back_at, int per_ms) {
        return last_breaks(200, enabled, [&](motor_sample& one, int i) {
            const bool is_position = i >= 100 && i < changed_back_at;
            one.mode = is_position ? mode::cyclic_synchronous_position : mode::cyclic_synchronous_velocity;
            one.velocity = i >= 100 && i < 103 ? 0 : 9'000;
            if (i > 150) one.velocity -= per_ms * (i - 150);
        });
    };
    REQUIRE_FALSE(drive(102, 0));
    REQUIRE_FALSE(drive(103, 200));
    REQUIRE_FALSE(drive(110, 0));
    REQUIRE_FALSE(drive(130, 0));
}

TEST_CASE("a velocity that changes too fast is found, too, after the mode has changed for a moment") {
    REQUIRE(last_breaks(151, enabled, [&](motor_sample& one, int i) {
        one.mode = i >= 100 && i < 103 ? mode::cyclic_synchronous_position : mode::cyclic_synchronous_velocity;
        one.velocity = i < 103 ? -9'000 : -9'000 + (i - 102) * 360;
    }));
}

TEST_CASE("a run of joints goes on until its end, and keeps the contract") {
    for (std::uint64_t seed = 0; seed != 16; ++seed) {
        INFO(seed);
        const auto result = run({.seed = seed, .length = 20s, .system = system_kind::joints});
        REQUIRE_FALSE(result.broken);
        REQUIRE(result.steps >= static_cast<std::uint64_t>(result.length / 600us));
    }
}

TEST_CASE("a run of joints replays exactly, and any seed may choose joints") {
    const settings what{.seed = 6, .length = 8s, .system = system_kind::joints};
    const auto first = run(what), again = run(what);
    REQUIRE(first.steps > 1000);
    REQUIRE(first.steps == again.steps);
    REQUIRE(first.digest == again.digest);
    REQUIRE(first.digest != run({.seed = 14, .length = 8s, .system = system_kind::joints}).digest);
    REQUIRE(first.broken.has_value() == again.broken.has_value());
    unsigned joints = 0;
    for (std::uint64_t seed = 0; seed != 64; ++seed)
        joints += run({.seed = seed, .length = 1ms}).system == system_kind::joints;
    REQUIRE(joints > 0);
    REQUIRE(joints < 32);
}
