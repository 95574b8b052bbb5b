// Drives of a bus in units of an application, in front of emulated ones.
#include "app/emulated_joint.hpp"
#include "support/catch.hpp"
#include "support/until.hpp"
#include <jauscat/app/drive.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using boost::system::error_code;
using cia402::axis_state;
using cia402::mode;
namespace asio = boost::asio;

namespace {

constexpr auto csp = mode::cyclic_synchronous_position, csv = mode::cyclic_synchronous_velocity;
constexpr std::uint16_t over_current = cia402::error_codes::over_current;
const std::vector<ethercat::slave_description> two{cia402::drive_description<>, cia402::drive_description<>};

/// Radians: 10,000 increments each.
drive_options radians() {
    return {.increments = 10'000,
            .max_velocity = 20,
            .acceleration = 200,
            .min_position = -3.0,
            .max_position = 3.0,
            .operate = {.period = 2ms, .watchdog = 2s, .timeout = 1s}};
}

struct bench {
    explicit bench(const std::vector<ethercat::slave_description>& drives = two, bool thread = false)
        : ring{drives},
          bus{std::in_place, context, ring.where(),
              bus_options{.frame_timeout = jauscat::test::frame_timeout,
                          .thread = thread,
                          .log = [this](std::string_view line) { lines.emplace_back(line); }}} {
        REQUIRE_FALSE(outcome([&](auto done) { bus->async_start(done); }));
    }
    [[nodiscard]] drive at(std::uint16_t position, const drive_options& options = radians()) {
        return {bus->slave({.position = position}), options};
    }
    error_code outcome(auto start) {
        std::optional<error_code> error;
        start([&](error_code why) { error = why; });
        REQUIRE(until([&] { return error.has_value(); }));
        return *error;
    }
    error_code operate(drive& which) {
        return outcome([&](auto done) { which.async_operate(done); });
    }
    error_code enable(drive& which, mode in = csp) {
        return outcome([&](auto done) { which.async_enable(in, done); });
    }
    [[nodiscard]] bool until(auto done) {
        for (const auto begun = net::now(); !done(); context.restart(), context.run_for(2ms))
            if (net::now() - begun > support::wait_limit) return false;
        return true;
    }
    [[nodiscard]] cia402::drive_values values(std::size_t i) {
        return ring.with(i, [](auto& each) { return each.axis().values; });
    }

    jauscat::test::drive_bus ring;
    asio::io_context context{};
    std::vector<std::string> lines{};
    std::optional<jauscat::bus> bus;
};

} // namespace

TEST_CASE("drives move to positions in units of the application") {
    bench b{two, GENERATE(false, true)};
    auto left = b.at(0), right = b.at(1);
    CHECK(left.feedback().state == axis_state::unknown);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.operate(right));
    REQUIRE_FALSE(b.enable(left));
    REQUIRE_FALSE(b.enable(right));
    CHECK(left.feedback().mode == csp);
    std::optional<error_code> there;
    right.async_move_to(-0.5, [&](error_code why) { there = why; });
    CHECK_FALSE(b.outcome([&](auto done) { left.async_move_to(1.25, done); }));
    REQUIRE(b.until([&] { return there.has_value(); }));
    CHECK_FALSE(*there);
    CHECK(std::abs(left.feedback().position - 1.25) < 0.01);
    CHECK(std::abs(b.values(0).position_actual - 12'500) < 100);
    CHECK(std::abs(b.values(1).position_actual + 5000) < 100);
    CHECK(left.feedback().is_current);
    CHECK_FALSE(left.feedback().is_limited);
    CHECK_FALSE(b.outcome([&](auto done) { left.async_move_to(9, done); })); // to the limit
    CHECK(left.feedback().is_limited);
    CHECK(std::abs(left.feedback().position - 3) < 0.01);
    CHECK_FALSE(b.outcome([&](auto done) { left.async_disable(done); }));
    CHECK(left.feedback().state == axis_state::disabled);
    CHECK(right.feedback().state == axis_state::enabled);
    CHECK(b.outcome([&](auto done) { left.async_move_to(0, done); }) == cia402::axis_errc::not_enabled);
}

TEST_CASE("a drive follows targets of each cycle, and its objects are where it maps them") {
    auto turned = radians();
    turned.increments = -10'000;
    auto drive_of_another_kind = cia402::drive_description<>;
    drive_of_another_kind.outputs = jauscat::test::other_drive_outputs;
    std::atomic<bool> runs{}; // the bus calls until it ends
    bench b{{drive_of_another_kind}};
    auto wheel = b.at(0, turned);
    b.bus->every_cycle([&runs, wheel] {
        if (runs) static_cast<void>(wheel.run_at(2));
    });
    REQUIRE_FALSE(b.operate(wheel));
    REQUIRE_FALSE(b.enable(wheel, csv));
    CHECK(wheel.move_to(1) == cia402::axis_errc::wrong_mode);
    CHECK(wheel.run_at(std::nan("")) == boost::system::errc::invalid_argument);
    runs = true;
    REQUIRE(b.until([&] { return std::abs(wheel.feedback().velocity - 2) < 0.1; }));
    CHECK(b.values(0).velocity_actual < 0);
    runs = false;
    CHECK_FALSE(b.outcome([&](auto done) { wheel.async_run_at(0, done); }));
    wheel.halt(true);
    CHECK(wheel.feedback().state == axis_state::enabled);
}

TEST_CASE("a fault of a drive ends its operation with the drive's code, until it is reset") {
    bench b;
    auto left = b.at(0);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.enable(left));
    std::optional<error_code> ended;
    left.async_move_to(3, [&](error_code why) { ended = why; });
    b.ring.set_fault(0, over_current);
    REQUIRE(b.until([&] { return ended.has_value(); }));
    CHECK(*ended == cia402::axis_errc::drive_fault);
    CHECK(ended->message() == "slave 0 (Emulated CiA 402 drive): drive fault: see its error code (603Fh): 2310h "
                              "(continuous over current, device output side)");
    CHECK(left.feedback().error.drive_code == over_current);
    CHECK(b.enable(left) == cia402::axis_errc::has_failed);
    b.ring.set_fault(0, 0);
    CHECK_FALSE(b.outcome([&](auto done) { left.async_reset(done); }));
    CHECK(left.feedback().state == axis_state::disabled);
    REQUIRE_FALSE(b.enable(left));
    CHECK_FALSE(b.outcome([&](auto done) { left.async_move_to(0.1, done); }));
}

TEST_CASE("an operation of a motor that does not get to its target ends with an error, and the axis stays enabled") {
    const auto in = GENERATE(values({csp, csv, mode::profile_position, mode::profile_velocity}));
    CAPTURE(static_cast<int>(in));
    bench b;
    auto patient = radians();
    patient.settling_time = 100ms;
    auto left = b.at(0, patient);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.enable(left, in));
    b.ring.with(0, [](auto& each) { each.axis().disturbed.blocked = true; });
    const bool is_position = in == csp || in == mode::profile_position;
    const auto begin = [&](auto done) {
        if (is_position)
            left.async_move_to(0.5, done);
        else
            left.async_run_at(1, done);
    };
    const auto why = b.outcome(begin);
    CHECK(why == cia402::axis_errc::not_reached);
    CHECK(why.message() == "slave 0 (Emulated CiA 402 drive): the motor does not reach the target");
    CHECK_FALSE(left.feedback().is_target_reached);
    CHECK(left.feedback().state == axis_state::enabled);
    b.ring.with(0, [](auto& each) { each.axis().disturbed.blocked = false; });
    CHECK_FALSE(b.outcome(begin));
    CHECK(left.feedback().is_target_reached);
    const auto is = left.feedback();
    CHECK(std::abs(is_position ? is.position - 0.5 : is.velocity - 1) < 0.3);
}

TEST_CASE("a drive works with the objects that its master has mapped") {
    bench b;
    const auto slave = b.bus->slave({.position = 1});
    const auto write = [&](std::uint16_t index, unsigned subindex, auto value) {
        return b.outcome(
            [&](auto done) { slave.async_write(index, static_cast<std::uint8_t>(subindex), value, done); });
    };
    const auto write_all = [&](std::uint16_t index, const auto& values) {
        REQUIRE_FALSE(write(index, 0, std::uint8_t{}));
        for (unsigned i = 0; i != values.size(); ++i) REQUIRE_FALSE(write(index, i + 1, values[i]));
        REQUIRE_FALSE(write(index, 0, static_cast<std::uint8_t>(values.size())));
    };
    using numbers = std::vector<std::uint32_t>;
    using words = std::vector<std::uint16_t>;
    CHECK(write(0x1601, 1, std::uint32_t{0x60600008}) == error_code{}); // an empty one
    CHECK(write(0x1600, 1, std::uint32_t{0x60600008}) == ethercat::abort_code::subindex_0_not_zero);
    write_all(0x1601, numbers{0x60600008, 0x60400010});
    write_all(0x1602, numbers{0x60FF0020});
    write_all(0x1A03, numbers{0x606C0020, 0x60410010, 0x60610008});
    write_all(0x1C12, words{0x1602, 0x1601});
    write_all(0x1C13, words{0x1A03});
    auto wheel = b.at(1);
    REQUIRE_FALSE(b.operate(wheel));
    b.ring.with(1, [](auto& each) {
        CHECK(each.slave.outputs().size() == 7);
        CHECK(each.slave.inputs().size() == 7);
    });
    REQUIRE_FALSE(b.enable(wheel, csv));
    CHECK_FALSE(b.outcome([&](auto done) { wheel.async_run_at(2, done); }));
    CHECK(std::abs(b.values(1).velocity_actual - 20'000) < 1000);
    CHECK(write(0x1C12, 0, std::uint8_t{}) == ethercat::abort_code::device_state);
}

TEST_CASE("a drive homes, pushes with a torque and stops quickly") {
    bench b;
    auto left = b.at(0);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.enable(left, mode::homing));
    REQUIRE_FALSE(b.outcome([&](auto done) { left.async_home(done); }));
    CHECK(left.axis().is_homed());
    CHECK(left.move_to(1) == cia402::axis_errc::wrong_mode);
    REQUIRE_FALSE(b.enable(left, mode::cyclic_synchronous_torque));
    CHECK_FALSE(left.push_with(50));
    REQUIRE(b.until([&] { return left.feedback().torque > 40 && left.feedback().velocity > 0.1; }));
    CHECK(left.push_with(std::numeric_limits<double>::quiet_NaN()).failed());
    REQUIRE_FALSE(b.outcome([&](auto done) { left.async_quick_stop(done); }));
    CHECK(left.feedback().state == axis_state::disabled);
    CHECK(std::abs(b.values(0).velocity_actual) <= 10);
    CHECK(left.push_with(50) == cia402::axis_errc::not_enabled);
}

TEST_CASE("the next operation replaces the one that waits, and a lost drive ends it") {
    bench b;
    auto left = b.at(0);
    CHECK(b.enable(left) == bus_errc::needs_cycles);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.enable(left));
    std::optional<error_code> first, second;
    left.async_move_to(3, [&](error_code why) { first = why; });
    left.async_move_to(-3, [&](error_code why) { second = why; });
    REQUIRE(b.until([&] { return first.has_value(); }));
    CHECK(*first == asio::error::operation_aborted);
    b.ring.with(0, [](auto& each) { each.slave.power_on(); });
    REQUIRE(b.until([&] { return second.has_value(); }));
    CHECK(*second == cia402::axis_errc::inputs_lost);
    CHECK(b.enable(left) == bus_errc::needs_cycles);
    // The bus brings it to PRE-OP again; the program decides the rest.
    REQUIRE(b.until(
        [&] { return b.ring.with(0, [](auto& each) { return each.slave.state(); }) == ethercat::al_state::pre_op; }));
    REQUIRE_FALSE(b.operate(left));
    CHECK(b.enable(left).failed()); // the drive has noticed it, too: 7500h
    REQUIRE_FALSE(b.outcome([&](auto done) { left.async_reset(done); }));
    REQUIRE_FALSE(b.enable(left));
}

TEST_CASE("a drive that does not map its mode gets it by SDO, each time that it changes") {
    auto plain = cia402::drive_description<>;
    plain.outputs = jauscat::test::outputs_without_mode;
    bench b{{plain}};
    auto left = b.at(0);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.enable(left, csv));
    CHECK(b.values(0).mode_of_operation == static_cast<std::int8_t>(csv));
    CHECK_FALSE(b.outcome([&](auto done) { left.async_run_at(1, done); }));
    REQUIRE_FALSE(b.enable(left, csp));
    CHECK(b.values(0).mode_of_operation == static_cast<std::int8_t>(csp));
    CHECK_FALSE(b.outcome([&](auto done) { left.async_move_to(0.5, done); }));
    CHECK(std::abs(b.values(0).position_actual - 5000) < 250);
}

TEST_CASE("a drive without an object that a mode needs is refused by name") {
    static constexpr auto few = [] {
        auto entries = cia402::drive_outputs<>;
        entries[4].index = 0x2000; // in place of the target velocity
        return entries;
    }();
    auto other = cia402::drive_description<>;
    other.outputs = few;
    bench b{{other}};
    auto wheel = b.at(0);
    REQUIRE_FALSE(b.operate(wheel));
    const auto error = b.enable(wheel, csv);
    CHECK(error == bus_errc::not_configurable);
    CHECK(error.message() == "slave 0 (Emulated CiA 402 drive): its process data do not have 0x60FF (Target velocity), "
                             "which mode 9 needs");
    CHECK_FALSE(b.enable(wheel, csp));
}

TEST_CASE("the end of a bus brings its drives to rest by a quick stop") {
    bench b{two, GENERATE(false, true)};
    auto left = b.at(0), right = b.at(1);
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.operate(right));
    REQUIRE_FALSE(b.enable(left, csv));
    REQUIRE_FALSE(b.outcome([&](auto done) { left.async_run_at(5, done); }));
    const auto before = b.values(0);
    REQUIRE(before.velocity_actual > 40'000);
    SECTION("by its end") { b.bus.reset(); }
    SECTION("by stop") { b.bus->stop(); }
    CHECK(std::abs(b.values(0).velocity_actual) <= 10);
    CHECK(cia402::state_of(b.values(0).statusword) == cia402::state::switch_on_disabled);
    CHECK(left.feedback().error.code == cia402::axis_errc::inputs_lost);
}

TEST_CASE("a function of each cycle that throws brings drives to rest by a quick stop") {
    std::atomic<bool> throws{};
    bench b;
    auto left = b.at(0);
    b.bus->every_cycle([&throws] {
        if (throws) throw std::runtime_error{"no value"};
    });
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.enable(left, csv));
    REQUIRE_FALSE(b.outcome([&](auto done) { left.async_run_at(5, done); }));
    throws = true;
    REQUIRE(b.until([&] { return left.feedback().state == axis_state::disabled; }));
    CHECK(std::abs(b.values(0).velocity_actual) <= 10);
    const auto said =
        std::ranges::count_if(b.lines, [](const auto& line) { return line.find("no value") != line.npos; });
    CHECK(said == 1);
}

TEST_CASE("options of a drive out of range are refused") {
    bench b;
    const auto refused = [&](auto change) {
        auto options = radians();
        change(options);
        CHECK_THROWS_AS(b.at(0, options), std::invalid_argument);
    };
    refused([](auto& o) { o.increments = 0; });
    refused([](auto& o) { o.increments = std::numeric_limits<double>::infinity(); });
    refused([](auto& o) { o.velocity_units = -1; });
    refused([](auto& o) { o.torque_units = 0; });
    refused([](auto& o) { o.max_velocity = 0; });
    refused([](auto& o) { o.acceleration = -1; });
    refused([](auto& o) { o.deceleration = -1; });
    refused([](auto& o) { o.max_torque = -1; });
    refused([](auto& o) { o.min_position = 4; });
    refused([](auto& o) { o.position_window = -1; });
    refused([](auto& o) { o.velocity_window = std::numeric_limits<double>::quiet_NaN(); });
    refused([](auto& o) { o.settling_time = 0s; });
    refused([](auto& o) { o.axis = 8; });
    refused([](auto& o) { o.operate.period = 333us; });
}

namespace {

/// A drive with two axes.
struct emulated_pair {
    cia402::emulated_drive<2> drive{};
    ethercat::standard_objects objects{cia402::drive_description<2>, drive};
    ethercat::slave slave{cia402::drive_description<2>, objects};

    static bool has_clock() { return false; }
    void work(std::span<std::byte>, time_point now) { on_time(now); }
    void on_time(time_point now) {
        slave.work();
        slave.on_time(now);
        drive.work(slave, now);
    }
};

struct pair_bus : jauscat::test::basic_emulated_bus<emulated_pair> {
    pair_bus() : basic_emulated_bus{[](auto& made) { made.emplace_back(); }} {}
};

} // namespace

TEST_CASE("the axes of one drive are taken to OP together, and move on their own") {
    pair_bus ring;
    asio::io_context context;
    jauscat::bus bus{
        context, ring.where(), {.frame_timeout = jauscat::test::frame_timeout, .log = [](std::string_view line) {
                                    UNSCOPED_INFO(line);
                                }}};
    const auto run = [&](auto start) {
        std::optional<error_code> error;
        start([&](error_code why) { error = why; });
        REQUIRE(support::until(context, [&] { return error.has_value(); }));
        return *error;
    };
    REQUIRE_FALSE(run([&](auto done) { bus.async_start(done); }));
    auto options = radians();
    drive first{bus.slave({.position = 0}), options};
    options.axis = 1;
    drive second{bus.slave({.position = 0}), options};
    REQUIRE_FALSE(run([&](auto done) { first.async_operate(done); }));
    REQUIRE_FALSE(run([&](auto done) { first.async_enable(csp, done); }));
    REQUIRE_FALSE(run([&](auto done) { second.async_operate(done); }));
    CHECK(first.feedback().state == axis_state::enabled); // the slave has stayed in OP
    REQUIRE_FALSE(run([&](auto done) { second.async_enable(csp, done); }));
    REQUIRE_FALSE(run([&](auto done) { second.async_move_to(0.5, done); }));
    REQUIRE_FALSE(run([&](auto done) { first.async_operate(done); })); // it is
    CHECK(first.feedback().state == axis_state::enabled);
    CHECK(std::abs(second.feedback().position - 0.5) < 0.01);
    CHECK(std::abs(first.feedback().position) < 0.01);
    for (const std::size_t i : {0u, 1u})
        CHECK(ring.with(0, [&](auto& each) { return each.drive.axes[i].values.interpolation_time; }) == 2);
}
