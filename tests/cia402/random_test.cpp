// An axis and a drive under random requests, faults and losses: what has no torque is not told to move.
#include "support/catch.hpp"
#include <jauscat/ethercat/cia402/emulated_drive.hpp>

#include <cstdint>
#include <deque>
#include <random>

using namespace jauscat;
using namespace jauscat::cia402;
using namespace std::chrono_literals;

namespace {

constexpr axis_options options{.min_position = -50'000,
                               .max_position = 50'000,
                               .max_velocity = 30'000,
                               .acceleration = 300'000,
                               .deceleration = 300'000,
                               .max_torque = 200};

constexpr bool enables(std::uint16_t controlword) { return (controlword & 0x8F) == 0x0F; }

void check(axis& a) {
    const auto& t = a.targets();
    REQUIRE(std::abs(t.velocity) <= 100'000); // as fast as it moves, after a change of the mode
    REQUIRE(std::abs(int{t.torque}) <= options.max_torque);
    if (a.drive_state() != state::operation_enabled || !enables(t.controlword)) {
        REQUIRE(t.torque == 0);
        if (a.drive_state() != state::operation_enabled) REQUIRE(t.velocity == 0);
    }
    if (a.state() == axis_state::failed) REQUIRE(!a.run_at(0).has_value());
}

} // namespace

TEST_CASE("whatever a drive says, an axis has no target without torque, and comes to rest after a failure") {
    std::mt19937 random{402};
    const auto pick = [&random](unsigned below) { return static_cast<unsigned>(random() % below); };
    axis_places places = places_of(cyclic_outputs, cyclic_inputs);
    for (int run = 0; run != 40; ++run) {
        emulated_drive<> drive;
        axis mine{options};
        std::array<std::byte, 14> outputs{};
        std::array<std::byte, 16> inputs{};
        time_point now{};
        bool has_op = true;
        std::deque<axis_feedback> late(pick(4)); // its status comes some cycles later
        std::uint16_t last_word{};
        for (int i = 0; i != 5000; ++i) {
            switch (pick(200)) {
            case 0:
            case 1:
            case 2: static_cast<void>(mine.enable()); break;
            case 3: mine.disable(); break;
            case 4: mine.quick_stop(); break;
            case 5: mine.halt(pick(2) == 0); break;
            case 6:
            case 7: mine.reset(); break;
            case 8: mine.set_mode(static_cast<mode>(pick(11))); break;
            case 9:
            case 10:
            case 11: static_cast<void>(mine.move_to(static_cast<int>(pick(200'000)) - 100'000)); break;
            case 12:
            case 13:
            case 14: static_cast<void>(mine.run_at(static_cast<int>(pick(200'000)) - 100'000)); break;
            case 15: static_cast<void>(mine.push_with(static_cast<std::int16_t>(pick(2000)))); break;
            case 16:
                drive.axes[0].disturbed.fault = pick(20) == 0 ? error_codes::over_current : error_codes::none;
                break;
            case 17: drive.axes[0].disturbed.no_voltage = pick(10) == 0; break;
            case 18: has_op = pick(10) != 0; break;
            case 19: static_cast<void>(mine.home()); break;
            default: break;
            }
            now += 1ms;
            if (has_op) drive.take(outputs);
            drive.axes[0].on_time(now, has_op);
            drive.give(inputs);
            auto feedback = places.load(inputs);
            if (pick(500) == 0) feedback.statusword = static_cast<std::uint16_t>(random());
            late.push_back(feedback);
            feedback = late.front();
            late.pop_front();
            if (has_op)
                mine.on_cycle(feedback, now);
            else
                mine.on_lost();
            places.store(mine.targets(), outputs);
            check(mine);
            const bool is_wanted = mine.state() == axis_state::enabling || mine.state() == axis_state::enabled;
            if (!is_wanted && !enables(last_word)) REQUIRE_FALSE(enables(mine.targets().controlword));
            last_word = mine.targets().controlword;
        }
        // A drive that obeys brings an axis that has failed, or is told to, to rest.
        drive.axes[0].disturbed = {};
        mine.disable();
        for (int i = 0; i != 6000; ++i) {
            now += 1ms;
            drive.take(outputs);
            drive.axes[0].on_time(now, true);
            drive.give(inputs);
            places.store(mine.on_cycle(places.load(inputs), now), outputs);
        }
        CHECK(std::abs(drive.axes[0].velocity()) < 100);
        CHECK(drive.axes[0].state() != state::operation_enabled);
    }
}
