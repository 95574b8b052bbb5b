// Slaves in OP whose process data an application exchanges itself.
#include "app/emulated_bus.hpp"
#include "support/catch.hpp"
#include "support/until.hpp"
#include <jauscat/app/bus.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using boost::system::error_code;
namespace asio = boost::asio;

namespace {

using jauscat::test::emulated_bus;

constexpr ethercat::pdo_entry told{.index = 0x7000, .subindex = 1, .bits = 16, .name = "told"};
constexpr ethercat::pdo_entry actual{.index = 0x6000, .subindex = 1, .bits = 16, .name = "actual"};

/// Two drives that repeat their outputs as inputs in OP, and a slave without process data.
struct bench {
    explicit bench(bool thread = false)
        : bench{thread,
                {{.product = 1, .name = "left", .outputs = {&told, 1}, .inputs = {&actual, 1}},
                 {.product = 2, .name = "right", .outputs = {&told, 1}, .inputs = {&actual, 1}},
                 {.product = 3}}} {
        REQUIRE_FALSE(start());
    }
    /// It is not started.
    bench(bool thread, const std::vector<ethercat::slave_description>& slaves,
          bus_options options = {.check_interval = 20ms})
        : ring{slaves} {
        for (std::size_t i = 0; i != slaves.size(); ++i)
            ring.with(i, [](auto& each) {
                if (each.description.outputs.empty()) return;
                each.application = [](ethercat::slave& device) {
                    device.take_outputs();
                    std::ranges::copy(device.outputs(), device.inputs().begin());
                };
            });
        options.frame_timeout = jauscat::test::frame_timeout;
        options.thread = thread;
        options.log = [this](std::string_view line) { lines.emplace_back(line); };
        bus.emplace(context, ring.where(), options);
        bus->when_lost([this](const slave_info& who, error_code why) { lost.emplace_back(who.position, why); });
        bus->when_found([this](const slave_info& who) { found.push_back(who.position); });
    }
    error_code start() {
        return outcome([&](auto done) { bus->async_start(done); });
    }
    /// Starts an operation and waits for its outcome.
    error_code outcome(auto start) {
        std::optional<error_code> error;
        start([&](error_code why) { error = why; });
        REQUIRE(support::until(context, [&] { return error.has_value(); }));
        return *error;
    }
    error_code operate(const slave& of,
                       const operate_options& options = {.period = 5ms, .watchdog = 1s, .timeout = 500ms}) {
        return outcome([&](auto done) { of.async_operate(options, done); });
    }
    error_code change(const slave& of, ethercat::al_state goal) {
        return outcome([&](auto done) { of.async_change(goal, done); });
    }
    /// What the slave has as its outputs.
    unsigned output(std::size_t i) {
        unsigned value{};
        ring.with(i, [&](auto& each) { value = std::to_integer<unsigned>(each.slave.outputs()[0]); });
        return value;
    }
    ethercat::al_state state(std::size_t i) {
        ethercat::al_state now{};
        ring.with(i, [&](auto& each) { now = each.slave.state(); });
        return now;
    }
    /// A bus with a thread wakes nobody here.
    bool until(auto done) {
        for (const auto begun = net::now(); !done(); context.restart(), context.run_for(2ms))
            if (net::now() - begun > support::wait_limit) return false;
        return true;
    }

    emulated_bus ring;
    asio::io_context context{};
    std::vector<std::string> lines{};
    std::vector<std::pair<std::uint16_t, error_code>> lost{};
    std::vector<std::uint16_t> found{};
    std::optional<jauscat::bus> bus{};
};

} // namespace

TEST_CASE("an application exchanges process data with a slave in OP, and ends at rest") {
    const bool thread = GENERATE(false, true);
    std::atomic<unsigned> cycles{}, seen{}; // outlive the bus, as all that every_cycle refers to
    bench b{thread};
    const auto left = b.bus->slave({.name = "left"});
    CHECK_FALSE(left.is_operating());
    CHECK(left.outputs().empty());
    b.bus->every_cycle([&cycles, &seen, left] {
        if (!left.is_operating()) return;
        ++cycles;
        left.outputs()[0] = std::byte{42};
        seen = std::to_integer<unsigned>(left.inputs()[0]);
    });
    REQUIRE_FALSE(b.operate(left));
    CHECK(left.is_operating());
    CHECK(left.info().is_served);
    REQUIRE(b.until([&] { return seen == 42; }));
    CHECK(cycles > 1);
    CHECK(b.state(0) == ethercat::al_state::op);
    CHECK(b.state(1) == ethercat::al_state::pre_op);
    // Objects of the slave are still read.
    std::optional<std::uint32_t> product;
    left.async_read<std::uint32_t>(0x1018, 2, [&](error_code, std::uint32_t value) { product = value; });
    REQUIRE(b.until([&] { return product.has_value(); }));
    CHECK(*product == 1);

    SECTION("by a change of its state") {
        CHECK_FALSE(b.change(left, ethercat::al_state::pre_op));
        CHECK_FALSE(left.is_operating());
        REQUIRE_FALSE(b.operate(left)); // and again
        REQUIRE(b.until([&] { return seen == 42; }));
        CHECK_FALSE(b.change(left, ethercat::al_state::safe_op));
        CHECK(b.output(0) == 0);
        CHECK(b.state(0) == ethercat::al_state::safe_op);
    }
    SECTION("by the end of the bus") {
        b.bus.reset();
        CHECK(b.output(0) == 0);
        CHECK(b.state(0) == ethercat::al_state::pre_op);
    }
    SECTION("by a stop of the bus") {
        b.bus->stop();
        CHECK(b.output(0) == 0);
        CHECK(b.state(0) == ethercat::al_state::pre_op);
    }
    for (const auto& line : b.lines) UNSCOPED_INFO(line);
    CHECK(b.lost.empty());
}

TEST_CASE("several slaves are operated in one cycle") {
    bench b;
    const auto left = b.bus->slave({.position = 0}), right = b.bus->slave({.position = 1});
    b.bus->every_cycle([left, right] {
        if (!left.is_operating() || !right.is_operating()) return;
        left.outputs()[0] = std::byte{1};
        right.outputs()[0] = std::byte(std::to_integer<unsigned>(left.inputs()[0]) + 1);
    });
    REQUIRE_FALSE(b.operate(left, {.period = 20ms, .watchdog = 1s, .timeout = 500ms}));
    REQUIRE_FALSE(b.operate(right));
    REQUIRE(b.until([&] { return b.output(1) == 2; }));
    CHECK(b.outcome([&](auto done) { left.async_operate({}, done); }) == bus_errc::served);
    CHECK_FALSE(b.change(left, ethercat::al_state::pre_op));
    CHECK(b.output(0) == 0);
    CHECK(right.is_operating());
    CHECK(b.output(1) != 0);
}

TEST_CASE("a slave that leaves its operation is reported, and comes to OP only if it is told") {
    const bool thread = GENERATE(false, true);
    bench b{thread};
    const auto left = b.bus->slave({.position = 0}), right = b.bus->slave({.position = 1});
    b.bus->every_cycle([left, right] {
        for (const auto& each : {left, right})
            if (each.is_operating()) each.outputs()[0] = std::byte{7};
    });
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.operate(right));
    REQUIRE(b.until([&] { return b.output(0) == 7 && b.output(1) == 7; }));
    SECTION("it is reset") {
        b.ring.with(0, [](auto& each) { each.slave.power_on(); });
        REQUIRE(b.until([&] { return b.lost.size() == 1; }));
        CHECK(b.lost[0] == std::pair{std::uint16_t{0}, error_code{bus_errc::slave_lost}});
        CHECK(right.is_operating());
    }
    SECTION("another master takes it to INIT") {
        b.ring.with(0, [](auto& each) {
            std::array<std::byte, ethercat::max_frame_size> frame{};
            ethercat::frame_builder builder{frame};
            builder.add(ethercat::command::bwr, 0, 0x0120, ethercat::al_control{.state = ethercat::al_state::init});
            each.slave.process(*builder.finish());
        });
        REQUIRE(b.until([&] { return b.lost.size() == 1; }));
        CHECK(b.lost[0].second == bus_errc::left_state);
        CHECK(b.lost[0].second.message() == "left OP: INIT");
        CHECK(std::ranges::any_of(
            b.lines, [](const auto& line) { return line.ends_with(": slave 0 (left) is lost: left OP: INIT"); }));
    }
    SECTION("no frame returns") {
        const auto begun = net::now();
        b.ring.is_silent = true;
        REQUIRE(b.until([&] { return b.lost.size() == 3; }));
        CHECK(net::now() - begun < 2s);
        CHECK_FALSE(right.is_operating());
        b.ring.is_silent = false;
    }
    CHECK_FALSE(left.is_operating());
    CHECK(left.outputs().empty());
    REQUIRE(b.until([&] { return b.found.size() == b.lost.size(); }));
    CHECK_FALSE(left.is_operating());
    REQUIRE(b.until([&] { return b.state(0) != ethercat::al_state::op; }));
    REQUIRE_FALSE(b.operate(left));
    REQUIRE(b.until([&] { return b.output(0) == 7; }));
}

TEST_CASE("a callback that throws brings all slaves in operation to rest") {
    bool throws = false;
    bench b;
    const auto left = b.bus->slave({.position = 0});
    b.bus->every_cycle([&throws, left] {
        if (throws) throw std::runtime_error{"no value"};
        if (left.is_operating()) left.outputs()[0] = std::byte{7};
    });
    REQUIRE_FALSE(b.operate(left));
    REQUIRE(b.until([&] { return b.output(0) == 7; }));
    throws = true;
    REQUIRE(b.until([&] { return b.state(0) == ethercat::al_state::pre_op; }));
    CHECK(b.output(0) == 0);
    CHECK(std::ranges::any_of(b.lines, [](const auto& line) { return line.find("no value") != line.npos; }));
}

TEST_CASE("a slave without a clock is not operated with SYNC signals") {
    bench b;
    const auto left = b.bus->slave({.position = 0});
    operate_options options{.period = 5ms, .watchdog = 1s, .timeout = 500ms};
    options.sync = ethercat::sync_settings{.assign_activate = 0x0300};
    CHECK(b.operate(left, options) == bus_errc::not_synchronized);
    REQUIRE(b.until([&] { return b.state(0) == ethercat::al_state::pre_op; }));
    REQUIRE_FALSE(b.operate(left));
}

TEST_CASE("slaves with SYNC signals reach OP in real time, and end at rest") {
    const bool thread = GENERATE(false, true);
    ethercat::slave_description drive{.product = 1,
                                      .outputs = {&told, 1},
                                      .inputs = {&actual, 1},
                                      .synchronization = true,
                                      .clock = ethercat::clock_width::bits_64,
                                      .needs_sync = true}; // else no SAFE-OP; before the first SYNC0 no OP
    ethercat::slave_description plain{.product = 3};
    auto narrow = drive;
    narrow.clock = ethercat::clock_width::bits_32;
    bench b{thread, {drive, plain, narrow}};
    b.ring.with(0, [](auto& each) { each.slave.set_clock_error({.drift = 90'000, .start = 1'000'000'000}); });
    b.ring.with(2, [](auto& each) { each.slave.set_clock_error({.drift = -70'000, .start = 3'000'000'000}); });
    REQUIRE_FALSE(b.start());
    const std::array drives{b.bus->slave({.position = 0}), b.bus->slave({.position = 2})};
    b.bus->every_cycle([drives] {
        for (const auto& each : drives)
            if (each.is_operating()) each.outputs()[0] = std::byte{42};
    });
    operate_options options{.period = 5ms, .watchdog = 2s, .timeout = 1s};
    options.sync = ethercat::sync_settings{.assign_activate = 0x0300};
    std::array<std::optional<error_code>, 2> reached{};
    for (std::size_t i = 0; i != 2; ++i)
        drives[i].async_operate(options, [&reached, i](error_code why) { reached[i] = why; });
    REQUIRE(b.until([&] { return reached[0] && reached[1]; }));
    for (const auto& line : b.lines) UNSCOPED_INFO(line);
    CHECK_FALSE(*reached[0]);
    CHECK_FALSE(*reached[1]);
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
        const auto signals = [&] {
            std::uint64_t count{};
            b.ring.with(i, [&](auto& each) { count = each.slave.sync0_count(); });
            return count;
        };
        CHECK(b.state(i) == ethercat::al_state::op);
        b.ring.with(i, [](auto& each) {
            CHECK(each.slave.clock().activation().on);
            CHECK(each.slave.clock().activation().sync0);
            CHECK(each.slave.synchronization().type == ethercat::sync_type::sync0);
            CHECK(each.slave.synchronization().sync0_cycle == 5'000'000);
        });
        REQUIRE(b.until([&, before = signals()] { return signals() > before + 20; }));
        REQUIRE(b.until([&] { return b.output(i) == 42; }));
    }
    CHECK(b.state(1) == ethercat::al_state::pre_op);
    std::array<std::uint64_t, 2> times{};
    const auto now = net::now() + 10ms; // both have the same one
    b.ring.with(0, [&](auto& each) { times[0] = each.slave.clock().system_time(now) & 0xFFFF'FFFF; });
    b.ring.with(2, [&](auto& each) { times[1] = each.slave.clock().system_time(now) & 0xFFFF'FFFF; });
    CHECK(std::abs(static_cast<std::int32_t>(static_cast<std::uint32_t>(times[0] - times[1]))) < 1'000);

    b.bus->stop();
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
        CHECK(b.output(i) == 0);
        CHECK(b.state(i) == ethercat::al_state::pre_op);
    }
    CHECK(b.lost.empty());
}

TEST_CASE("an operation that cannot be is refused") {
    bench b;
    const auto left = b.bus->slave({.position = 0});
    const auto ignore = [](error_code) {};
    CHECK_THROWS_AS(left.async_operate({.period = 0ms}, ignore), std::invalid_argument);
    CHECK_THROWS_AS(left.async_operate({.period = 5ms, .watchdog = 9ms}, ignore), std::invalid_argument);
    CHECK_THROWS_AS(left.async_operate({.period = 5ms, .watchdog = 7s}, ignore), std::invalid_argument);
    CHECK_THROWS_AS(left.async_operate({.period = 5ms, .timeout = 9ms}, ignore), std::invalid_argument);
    CHECK(b.operate(b.bus->slave({.position = 5})) == bus_errc::no_such_slave);
    CHECK(b.change(left, ethercat::al_state::op) == bus_errc::needs_cycles);
    // Aborted before it is in OP.
    std::optional<error_code> error;
    left.async_operate({.period = 5ms}, [&](error_code why) { error = why; });
    b.bus->stop();
    REQUIRE(b.until([&] { return error.has_value(); }));
    CHECK(*error == boost::asio::error::operation_aborted);
}

TEST_CASE("a function of each cycle knows whether inputs are current, and is called while no slave is in operation") {
    const bool thread = GENERATE(false, true);
    std::atomic<unsigned> cycles{}, current{}, old{};
    std::atomic<duration::rep> oldest{};
    std::atomic<bool> is_cut{};
    bench b{thread};
    const auto left = b.bus->slave({.name = "left"});
    CHECK_FALSE(left.has_current_inputs());
    CHECK(left.input_age() == duration::max());
    b.ring.on_way_back([&](std::span<std::byte> frame) { // a frame that is not one is lost
        if (is_cut) std::ranges::fill(frame, std::byte{});
    });
    b.bus->every_cycle([&, left] {
        ++cycles;
        if (!left.is_operating()) return;
        ++(left.has_current_inputs() ? current : old);
        oldest = std::max(oldest.load(), left.input_age().count());
    });
    CHECK(cycles == 0); // there is no period yet
    REQUIRE_FALSE(b.operate(left));
    REQUIRE(b.until([&] { return current > 2; }));
    is_cut = true;
    const unsigned before = old;
    REQUIRE(b.until([&] { return old > before + 3; }));
    CHECK(oldest > std::chrono::nanoseconds{10ms}.count());
    REQUIRE(b.until([&] { return b.lost.size() == 1; })); // by the time-out
    CHECK_FALSE(left.is_operating());
    for (unsigned until = cycles + 5; cycles < until;) REQUIRE(b.until([&] { return cycles >= until; }));
    const auto seen = b.bus->statistics();
    CHECK(seen.lost > 3);
    is_cut = false;
    REQUIRE(b.until([&] { return b.found.size() == 1; }));
    REQUIRE_FALSE(b.operate(left));
    const unsigned known = current;
    REQUIRE(b.until([&] { return current > known; }));
    b.bus->stop();
    const unsigned last = cycles;
    b.context.restart();
    b.context.run_for(20ms);
    CHECK(cycles == last);
}

TEST_CASE("a bus counts its cycles and measures their times") {
    bench b;
    CHECK(b.bus->statistics().cycles == 0);
    const auto left = b.bus->slave({.name = "left"});
    REQUIRE_FALSE(b.operate(left));
    REQUIRE_FALSE(b.operate(b.bus->slave({.name = "right"})));
    REQUIRE(b.until([&] { return b.bus->statistics().working_counter == 6; }));
    const auto seen = b.bus->statistics();
    CHECK(seen.expected_working_counter == 6);
    CHECK(seen.cycles > 1);
    CHECK(seen.round_trip > duration{});
    CHECK(seen.longest_round_trip >= seen.round_trip);
    CHECK(seen.longest_late >= seen.late);
    CHECK(seen.late >= duration{});
    CHECK(seen.foreign_frames == 0);
    // A slave that takes no part.
    b.ring.with(1, [](auto& each) { each.slave.power_on(); });
    REQUIRE(b.until([&] { return b.bus->statistics().incomplete > seen.incomplete; }));
    b.bus->stop();
    CHECK(b.bus->statistics().cycles == 0);
}

TEST_CASE("a bus does not reset slaves in OP that are not its own, unless it takes them over") {
    const bool has_names = GENERATE(false, true);
    bench b;
    REQUIRE_FALSE(b.operate(b.bus->slave({.name = "left"})));
    bus_options options{.log = [](std::string_view) {}};
    if (has_names) options.slaves = {{.name = "one", .position = 0, .product = 1}};
    asio::io_context context;
    const auto outcome = [&](jauscat::bus& of) {
        std::optional<error_code> error;
        of.async_start([&](error_code why) { error = why; });
        REQUIRE(support::until(context, [&] { return error.has_value(); }));
        return *error;
    };
    jauscat::bus careful{context, b.ring.where(), options};
    CHECK(outcome(careful) == bus_errc::in_use);
    CHECK(b.state(0) == ethercat::al_state::op);
    CHECK(careful.slaves().empty());
    options.takes_over = true;
    jauscat::bus bold{context, b.ring.where(), options};
    CHECK_FALSE(outcome(bold));
    CHECK(b.state(0) == ethercat::al_state::pre_op);
    CHECK_FALSE(outcome(careful)); // none is in OP any more
}

TEST_CASE("many slaves are found and taken to OP in about as many frames as the jobs for all of them take") {
    constexpr std::uint16_t count = 40; // sanitizers take 10 ms for a frame through 60
    std::vector<ethercat::slave_description> slaves;
    for (unsigned i = 0; i != count; ++i)
        slaves.push_back({.product = i + 1, .name = "drive", .outputs = {&told, 1}, .inputs = {&actual, 1}});
    const auto by_jobs = [&] {
        emulated_bus ring{slaves};
        const auto link = net::open_link(ring.where());
        const auto master = std::make_unique<ethercat::master_for<count>>(
            ethercat::master_config{.frame_timeout = jauscat::test::frame_timeout, .mailbox_timeout = 60s});
        const auto run = [&](const auto& job) { REQUIRE(net::run(*link, *master, job)); };
        run(ethercat::scan{});
        std::vector<ethercat::bring_up_place> up;
        std::vector<ethercat::upload_place> names;
        std::vector<ethercat::configure_place> configured;
        std::vector<ethercat::state_place> changed;
        std::vector<std::array<std::byte, 16>> memory(count);
        for (std::uint16_t i = 0; i != count; ++i) {
            const auto station = static_cast<std::uint16_t>(i + 1);
            up.emplace_back(ethercat::bring_up{i, station});
            names.emplace_back(ethercat::upload{station, ethercat::standard_indices::device_name, 0, memory[i]});
            configured.emplace_back(station);
            changed.emplace_back(station);
        }
        run(ethercat::bring_up_all{up});
        run(ethercat::upload_all{names});
        run(ethercat::configure_all{configured});
        run(ethercat::change_states{changed, ethercat::al_state::safe_op});
        return ring.frames();
    }();
    const bool thread = GENERATE(false, true);
    bench b{thread, slaves, {.timeout = 60s, .check_interval = {}}}; // no frames but those of the way to OP
    REQUIRE_FALSE(b.start());
    for (const auto& each : b.bus->slaves()) CHECK(each.name == "drive");
    std::size_t running = 0;
    // No frame passes meanwhile: a thread of the bus begins with one slave at most, and then has all others.
    b.ring.with(0, [&](auto&) {
        for (std::uint16_t i = 0; i != count; ++i)
            b.bus->slave({.position = i})
                .async_operate({.period = 500ms, .watchdog = 6s, .timeout = 60s}, [&](error_code why) {
                    CHECK_FALSE(why);
                    ++running;
                });
    });
    REQUIRE(b.until([&] { return running == count; }));
    CHECK(b.ring.frames() < by_jobs * 3 / 2); // one by one it takes ten times as many
}

TEST_CASE("one of several slaves that does not take a state does not keep the others from it") {
    bench b;
    b.ring.with(1, [](auto& each) { each.hangs = true; });
    std::vector<std::pair<int, error_code>> outcomes;
    for (const std::uint16_t i : std::array<std::uint16_t, 4>{0, 1, 2, 0})
        b.bus->slave({.position = i}).async_change(ethercat::al_state::init, [&outcomes, i](error_code why) {
            outcomes.emplace_back(i, why);
        });
    REQUIRE(b.until([&] { return outcomes.size() == 4; }));
    for (const auto& [position, why] : outcomes) CHECK(why.failed() == (position == 1));
    CHECK(b.state(0) == ethercat::al_state::init);
    CHECK(b.state(2) == ethercat::al_state::init);
}
