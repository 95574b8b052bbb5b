#include "two_nodes.hpp"
#include <jauscat/net/open_error.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace app_test;
using state = jaus::primary_status_code;

/// The outcome of an operation, when it is there.
struct outcome {
    std::optional<error_code> error{};
    auto operator()() {
        return [this](error_code what, auto&&...) { error = what; };
    }
};

struct primitive_driver : operator_and_robot {
    jaus::report_wrench_effort effort{};
    int stopped{}, began{};

    primitive_driver() {
        driver.on([this](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
        driver.reports([this] { return effort; });
        driver.when_stopped([this] {
            effort = {};
            ++stopped;
        });
        driver.when_ready([this] { ++began; });
        driver.ready();
        start();
    }
    error_code send(const auto& message) {
        outcome of;
        unit.async_send(arm, message, of());
        REQUIRE(until([&] { return of.error.has_value(); }));
        return *of.error;
    }
};

TEST_CASE("a component of fifteen lines takes commands and answers queries with the fields that are asked for") {
    primitive_driver test;
    CHECK(test.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50, .resistive_linear_effort_x = 10}) ==
          error_code{});
    CHECK(test.effort.propulsive_linear_effort_x == Approx(50).margin(0.01));

    std::optional<jaus::report_wrench_effort> report;
    test.unit.async_ask(test.arm, jaus::query_wrench_effort{0x0001},
                        [&](error_code error, const jaus::report_wrench_effort& is) {
                            CHECK(error == error_code{});
                            report = is;
                        });
    REQUIRE(test.until([&] { return report.has_value(); }));
    CHECK(report->propulsive_linear_effort_x == Approx(50).margin(0.01));
    CHECK_FALSE(report->resistive_linear_effort_x.has_value());
}

TEST_CASE("a component is stopped by every state but Ready, and obeys again when it is Ready") {
    primitive_driver test;
    const jaus::set_wrench_effort command{.propulsive_linear_effort_x = 50};
    CHECK(test.send(command) == error_code{});
    CHECK(test.stopped == 0);
    CHECK(test.send(jaus::standby{}) == error_code{});
    CHECK(test.stopped == 1);
    CHECK(test.effort == jaus::report_wrench_effort{});
    CHECK(test.send(command) == jauscat::node_errc::refused);
    CHECK(test.send(jaus::resume{}) == error_code{});
    CHECK(test.began == 2);
    CHECK(test.send(command) == error_code{});
    CHECK(test.send(jaus::reset{}) == error_code{});
    CHECK(test.stopped == 2);
    CHECK(test.driver.state() == state::ready);
}

TEST_CASE("a component is stopped when a sender that moves it without control is lost, not while that lives") {
    primitive_driver test;
    const jaus::set_wrench_effort command{.propulsive_linear_effort_x = 50};
    CHECK(test.send(command) == error_code{});
    boost::asio::steady_timer pause{test.context, std::chrono::milliseconds{1200}};
    bool is_over = false;
    pause.async_wait([&](error_code) { is_over = true; });
    REQUIRE(test.until([&] { return is_over; })); // it sends nothing but heartbeats
    CHECK(test.stopped == 0);
    CHECK(test.effort != jaus::report_wrench_effort{});
    test.mine.stop();
    REQUIRE(test.until([&] { return test.stopped == 1; }));
    CHECK(test.effort == jaus::report_wrench_effort{});
    CHECK(test.driver.state() == state::ready);
    CHECK(test.has_logged("1.1.32.1, the sender of its last motion command, is lost"));
    test.mine.start();
    test.unit.ready();
    CHECK(test.send(command) == error_code{});
    test.mine.stop();
    REQUIRE(test.until([&] { return test.stopped == 2; }));
}

TEST_CASE("the end of the node stops its components") {
    primitive_driver test;
    test.robots.stop();
    CHECK(test.stopped == 1);
}

TEST_CASE("an exception of a handler is logged with its message, and stops the component but not the node") {
    int stopped = 0; // outlives the component, whose end calls when_stopped
    operator_and_robot test;
    test.driver.on([&](const jaus::set_wrench_effort&) { throw std::runtime_error{"the motor is gone"}; });
    test.driver.when_stopped([&] { ++stopped; });
    test.driver.ready();
    test.start();
    outcome of;
    test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 5}, of());
    REQUIRE(test.until([&] { return of.error.has_value(); }));
    CHECK(*of.error == jauscat::node_errc::refused);
    CHECK(stopped == 1);
    CHECK(test.driver.state() == state::failure);
    CHECK(test.has_logged("Set Wrench Effort: the motor is gone"));
    std::optional<jaus::report_component_status> status;
    test.unit.async_ask(test.arm, jaus::query_component_status{},
                        [&](error_code, const jaus::report_component_status& is) { status = is; });
    REQUIRE(test.until([&] { return status.has_value(); }));
    CHECK(status->primary_status_code == state::failure);
    test.driver.ready();
    CHECK(test.driver.state() == state::ready);
}

TEST_CASE("an exception of any function of the application brings the component to Failure before it obeys again") {
    int commands = 0, stopped = 0;
    bool throws = false;
    const auto fault = [&] {
        if (throws) throw std::runtime_error{"the battery is gone"};
    };
    operator_and_robot test;
    test.driver.on([&](const jaus::set_wrench_effort&) { ++commands; });
    test.driver.when_stopped([&] { ++stopped; });
    SECTION("when_ready") { test.driver.when_ready(fault); }
    SECTION("when_controlled") {
        test.driver.when_controlled([&](const std::optional<jaus::address>&) { fault(); });
    }
    SECTION("every") { test.driver.every(std::chrono::milliseconds{1}, fault); }
    SECTION("a report") {
        test.driver.reports([&] {
            fault();
            return jaus::report_wrench_effort{};
        });
    }
    test.driver.ready();
    test.start();
    bool has_event = false, has_control = false;
    jauscat::subscription<jaus::report_wrench_effort> events;
    jauscat::control control;
    test.unit.async_event<jaus::report_wrench_effort>(
        test.arm, jaus::create_event{.event_type = jaus::event_type::every_change},
        [&](error_code, jauscat::subscription<jaus::report_wrench_effort> made) {
            events = std::move(made);
            has_event = true;
        });
    REQUIRE(test.until([&] { return has_event; }));
    throws = true;
    test.driver.changed();
    outcome reset;
    test.unit.async_send(test.arm, jaus::reset{}, reset());
    REQUIRE(test.until([&] { return reset.error.has_value(); }));
    test.unit.async_control(test.arm, {}, [&](error_code, jauscat::control made) {
        control = std::move(made);
        has_control = true;
    });
    REQUIRE(test.until([&] { return has_control && test.driver.state() == state::failure; }));
    CHECK(stopped > 0);
    CHECK(test.has_logged("the battery is gone"));
    outcome of;
    test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 5}, of());
    REQUIRE(test.until([&] { return of.error.has_value(); }));
    CHECK(*of.error == jauscat::node_errc::refused);
    CHECK(commands == 0);
}

TEST_CASE("a component that fails when it becomes Ready does not obey the next command") {
    int commands = 0;
    operator_and_robot test;
    test.driver.on([&](const jaus::set_wrench_effort&) { ++commands; });
    test.driver.when_ready([] { throw std::runtime_error{"the brake is closed"}; });
    test.start();
    test.driver.ready();
    CHECK(test.driver.state() == state::failure);
    test.driver.when_ready([] {});
    test.driver.ready();
    CHECK(test.driver.state() == state::ready);
}

TEST_CASE("when_stopped may fail its component, in an emergency, too") {
    int stopped = 0, emergencies = 0;
    operator_and_robot test;
    const auto fails = GENERATE(true, false);
    test.driver.when_stopped([&] {
        ++stopped;
        if (!fails) throw std::runtime_error{"the brake does not close"};
        test.driver.fail("the brake does not close");
    });
    test.driver.when_emergency([&](bool begins) { emergencies += begins ? 1 : 0; });
    test.driver.ready();
    test.start();
    outcome of;
    test.unit.async_send(test.arm, jaus::set_emergency{}, of());
    REQUIRE(test.until([&] { return of.error.has_value(); }));
    CHECK(test.driver.state() == state::emergency);
    CHECK(emergencies == 1);
    CHECK(stopped == 2); // by the emergency, and by the failure
    CHECK(test.has_logged("the brake does not close"));
    test.robots.stop();
    CHECK(stopped == 3);
}

TEST_CASE("when_stopped may stop its node, which stops once") {
    int stopped = 0;
    operator_and_robot test;
    test.driver.when_stopped([&] {
        ++stopped;
        test.robots.stop();
    });
    test.driver.ready();
    test.start();
    SECTION("at its end") { test.robots.stop(); }
    SECTION("at a failure") { test.driver.fail("no power"); }
    CHECK(stopped > 0);
    CHECK(stopped <= 2);
    outcome of;
    test.unit.async_send(test.arm, jaus::standby{}, of());
    REQUIRE(test.until([&] { return of.error.has_value(); }));
    CHECK(*of.error == jauscat::node_errc::no_answer);
}

TEST_CASE("a component may end in its own functions") {
    two_nodes test;
    jauscat::node mine{test.context, test.options("operator")}, robots{test.context, test.options("robot")};
    jauscat::component unit{mine, {.id = 32}};
    std::optional<jauscat::component> driver{std::in_place, robots, jauscat::component_options{.id = 33}};
    const auto arm = driver->address();
    const std::string still_there = "a text that is too long to be kept in the string";
    std::string seen;
    const auto end = [&, text = still_there] {
        driver.reset();
        seen = text; // of a function that still exists
    };
    bool by_message = true;
    SECTION("when_ready") {
        driver->when_ready(end);
        by_message = false;
    }
    SECTION("when_stopped") { driver->when_stopped(end); }
    SECTION("when_controlled") {
        driver->when_controlled([=](const std::optional<jaus::address>&) { end(); });
    }
    SECTION("a handler") {
        driver->on([=](const jaus::set_wrench_effort&) { end(); });
    }
    robots.start();
    mine.start();
    driver->ready();
    outcome of;
    if (by_message) {
        unit.async_control(arm, {}, [](error_code, jauscat::control) {});
        unit.async_send(arm, jaus::set_wrench_effort{}, of());
        unit.async_send(arm, jaus::standby{}, of());
    }
    REQUIRE(test.until([&] { return !seen.empty(); }));
    CHECK(seen == still_there);
    CHECK_FALSE(driver.has_value());
}

TEST_CASE("what when_stopped changes is reported at once") {
    jaus::report_wrench_effort effort{};
    operator_and_robot test;
    jauscat::component watcher{test.robots, {.id = 40}};
    test.driver.on([&](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
    test.driver.reports([&] { return effort; });
    test.driver.when_stopped([&] { effort = {.propulsive_linear_effort_x = 0}; });
    test.driver.ready();
    test.start();
    jauscat::subscription<jaus::report_wrench_effort> events;
    watcher.async_event<jaus::report_wrench_effort>(
        test.arm, jaus::create_event{.event_type = jaus::event_type::every_change},
        [&](error_code why, jauscat::subscription<jaus::report_wrench_effort> made) {
            CHECK(why == error_code{});
            events = std::move(made);
        });
    REQUIRE(test.until([&] { return static_cast<bool>(events); }));
    const auto next = [&] {
        std::optional<double> x;
        events.async_next([&](error_code why, const jaus::report_wrench_effort& is) {
            CHECK(why == error_code{});
            x = is.propulsive_linear_effort_x.value_or(-1);
        });
        REQUIRE(test.until([&] { return x.has_value(); }));
        return *x;
    };
    outcome of; // control without heartbeats
    test.unit.async_send(test.arm, jaus::request_component_control{.authority_code = 200}, of());
    REQUIRE(test.until([&] { return test.driver.controller().has_value(); }));
    outcome commanded;
    test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 50}, commanded());
    CHECK(next() == Approx(50).margin(0.01));
    SECTION("when its controller is silent") { test.mine.stop(); }
    SECTION("when it rejects its controller") { test.driver.reject_control(); }
    SECTION("when it fails") { test.driver.fail("no power"); }
    CHECK(next() == Approx(0).margin(0.01));
}

/// Values that the subscriber of an event gets while the effort becomes 5, 11, 12, 9, 20 %. Each of `expected` is
/// waited for before the next change, because changes within a millisecond are reported once.
std::vector<int> values_of(const jaus::create_event& trigger, const std::vector<int>& expected) {
    jaus::report_wrench_effort effort{.propulsive_linear_effort_x = 0};
    operator_and_robot test;
    test.driver.reports([&] { return effort; });
    test.driver.ready();
    test.start();
    jauscat::subscription<jaus::report_wrench_effort> events;
    std::vector<int> values;
    std::function<void()> next = [&] {
        events.async_next([&](error_code why, const jaus::report_wrench_effort& is) {
            if (why == jauscat::node_errc::silent) return next(); // for three periods, on a busy machine
            if (why) return;
            values.push_back(static_cast<int>(std::lround(is.propulsive_linear_effort_x.value())));
            next();
        });
    };
    std::optional<error_code> made;
    test.unit.async_event<jaus::report_wrench_effort>(
        test.arm, trigger, [&](error_code why, jauscat::subscription<jaus::report_wrench_effort> is) {
            made = why;
            events = std::move(is);
            next();
        });
    REQUIRE(test.until([&] { return made.has_value(); }));
    CHECK(*made == error_code{});
    const auto ask = [&] { // its answer comes behind the events before it
        std::optional<error_code> answered;
        test.unit.async_ask(test.arm, jaus::query_wrench_effort{},
                            [&](error_code why, const jaus::report_wrench_effort&) { answered = why; });
        REQUIRE(test.until([&] { return answered.has_value(); }));
    };
    for (const int x : {5, 11, 12, 9, 20}) {
        effort.propulsive_linear_effort_x = x;
        test.driver.changed();
        ask();
        if (std::ranges::count(expected, x) != 0)
            REQUIRE(test.until([&] { return !values.empty() && values.back() == x; }));
    }
    if (trigger.event_type == jaus::event_type::periodic)
        REQUIRE(test.until([&] { return values.size() >= 3 && values[values.size() - 3] == 20; }));
    return values;
}

TEST_CASE("events of each kind, also with limits, are served by a function of the report") {
    using jaus::event_boundary;
    using jaus::event_type;
    const jaus::typed_value ten{.data_type = jaus::data_type::long_float, .value = 10.0};
    const std::uint8_t field = 2;
    const auto check = [](const jaus::create_event& trigger, const std::vector<int>& expected) {
        CHECK(values_of(trigger, expected) == expected);
    };
    check({.event_type = event_type::every_change}, {5, 11, 12, 9, 20});
    check({.event_type = event_type::first_change}, {5});
    check({.event_type = event_type::one_time_on_demand}, {0});
    check({.event_type = event_type::every_change,
           .event_boundary = event_boundary::strictly_greater_than,
           .limit_data_field = field,
           .lower_limit = ten},
          {11, 12, 20});
    check({.event_type = event_type::first_change_in_and_out_of_boundary,
           .event_boundary = event_boundary::strictly_greater_than,
           .limit_data_field = field,
           .lower_limit = ten},
          {11, 9, 20});
    const std::vector all{5, 11, 12, 9, 20};
    const auto periodic = values_of({.event_type = event_type::periodic, .requested_periodic_rate = 200.0}, all);
    CHECK(std::ranges::count(periodic, 20) >= 3);
    const auto once =
        values_of({.event_type = event_type::periodic_without_repeat, .requested_periodic_rate = 200.0}, all);
    for (const int x : all) CHECK(std::ranges::count(once, x) == 1);
}

TEST_CASE("a report may need its query, or be missing for now") {
    operator_and_robot test;
    std::optional<jaus::report_wrench_effort> effort;
    test.driver.reports([&] { return effort; });
    test.driver.reports([](const jaus::query_travel_speed&) { return jaus::report_travel_speed{.desired_speed = 5}; });
    test.driver.ready();
    test.start();
    std::optional<error_code> error;
    const auto ask = [&](const auto& query) {
        error.reset();
        test.unit.async_ask(test.arm, query, [&](error_code why, const auto&) { error = why; });
        REQUIRE(test.until([&] { return error.has_value(); }));
        return *error;
    };
    CHECK(ask(jaus::query_travel_speed{}) == error_code{});
    CHECK(ask(jaus::query_wrench_effort{0x0001}) == jauscat::node_errc::refused);
    effort.emplace();
    CHECK(ask(jaus::query_wrench_effort{0x0001}) == error_code{});
}

TEST_CASE("the options of a component say when it obeys, and whom") {
    two_nodes test;
    jauscat::node mine{test.context, test.options("operator")}, robots{test.context, test.options("robot")};
    constexpr auto move = jaus::command_code_of<jaus::set_wrench_effort>;
    const auto harmless_code = std::uint16_t{0xD001}, private_code = std::uint16_t{0xD002};
    jauscat::component unit{mine, {.id = 32}}, other{mine, {.id = 35}};
    jauscat::component driver{robots, {.id = 33, .obeys_only_when_ready = false}},
        strict{robots, {.id = 34, .harmless = {harmless_code}}},
        controlled{robots, {.id = 36, .without_control = jaus::motion_without_control::refused}};
    std::vector<std::uint16_t> taken;
    const auto note = [&](const jaus::header& head, std::span<const std::byte>) {
        taken.push_back(head.command_code);
        return jaus::message_outcome::handled;
    };
    driver.on_others(note);
    strict.on_others(note);
    controlled.on_others(note);
    robots.start();
    mine.start();
    const auto send = [&](jauscat::component& from, const jaus::address& to, std::uint16_t code) {
        outcome of;
        const std::array<std::byte, 2> nothing{};
        from.async_send(to, code, nothing, of());
        REQUIRE(test.until([&] { return of.error.has_value(); }));
        return *of.error;
    };
    CHECK(driver.state() == state::initialize);
    CHECK(send(unit, driver.address(), move) == error_code{});
    CHECK(send(unit, strict.address(), move) == jauscat::node_errc::refused);
    CHECK(send(unit, strict.address(), private_code) == jauscat::node_errc::refused);
    CHECK(send(unit, strict.address(), harmless_code) == error_code{});
    strict.ready();
    jauscat::control control;
    unit.async_control(strict.address(), {}, [&](error_code, jauscat::control made) { control = std::move(made); });
    REQUIRE(test.until([&] { return control.is_held(); }));
    CHECK(send(other, strict.address(), private_code) == jauscat::node_errc::refused);
    CHECK(send(other, strict.address(), harmless_code) == error_code{});
    CHECK(send(unit, strict.address(), private_code) == error_code{});
    CHECK(taken == std::vector<std::uint16_t>{move, harmless_code, harmless_code, private_code});
    controlled.ready();
    CHECK(send(unit, controlled.address(), move) == jauscat::node_errc::refused);
    jauscat::control second;
    unit.async_control(controlled.address(), {}, [&](error_code, jauscat::control made) { second = std::move(made); });
    REQUIRE(test.until([&] { return second.is_held(); }));
    CHECK(send(unit, controlled.address(), move) == error_code{});
}

TEST_CASE("each instance of a component takes its own messages") {
    std::vector<int> taken;
    operator_and_robot test;
    jauscat::component second{test.robots, {.id = 33, .instance = 2}};
    test.driver.on([&](const jaus::set_wrench_effort&) { taken.push_back(1); });
    second.on([&](const jaus::set_wrench_effort&) { taken.push_back(2); });
    test.driver.ready();
    second.ready();
    test.start();
    for (const auto& to : {second.address(), test.driver.address()}) {
        outcome of;
        test.unit.async_send(to, jaus::set_wrench_effort{.propulsive_linear_effort_x = 1}, of());
        REQUIRE(test.until([&] { return of.error.has_value(); }));
        CHECK(*of.error == error_code{});
    }
    CHECK(taken == std::vector{2, 1});
}

TEST_CASE("run returns after stop, also in a context with other work, and runs again") {
    two_nodes test;
    boost::asio::steady_timer other{test.context, std::chrono::hours{1}};
    bool is_own = false;
    SECTION("of the program") {
        other.async_wait([](error_code) {});
    }
    SECTION("of the node") { is_own = true; }
    std::optional<jauscat::node> node;
    if (is_own)
        node.emplace(test.options("robot"));
    else
        node.emplace(test.context, test.options("robot"));
    int calls = 0;
    jauscat::component driver{*node, {.id = 33}};
    driver.every(std::chrono::milliseconds{1}, [&] {
        ++calls;
        node->stop();
    });
    for (int i = 1; i != 4; ++i) {
        CHECK(node->run() == EXIT_SUCCESS);
        CHECK(calls == i);
    }
}

TEST_CASE("periodic functions are called while the node runs, and not after its end") {
    operator_and_robot test;
    int calls = 0;
    test.driver.every(std::chrono::milliseconds{2}, [&] { ++calls; });
    test.start();
    REQUIRE(test.until([&] { return calls == 5; }));
    test.robots.stop();
    const int at_the_end = calls;
    outcome of; // an event after the end
    test.unit.async_send(test.arm, jaus::standby{}, of());
    REQUIRE(test.until([&] { return of.error.has_value(); }));
    CHECK(*of.error == jauscat::node_errc::no_answer);
    CHECK(calls == at_the_end);
}

TEST_CASE("a periodic function of the longest period is called once") {
    operator_and_robot test;
    int calls = 0, others = 0;
    test.driver.every(jauscat::duration::max(), [&] { ++calls; });
    test.driver.every(std::chrono::milliseconds{1}, [&] { ++others; });
    test.start();
    REQUIRE(test.until([&] { return others == 20; }));
    CHECK(calls == 1);
}

TEST_CASE("a timeout below 0 is over at once") {
    operator_and_robot test;
    test.mine.start();
    test.unit.ready();
    for (const auto timeout : {jauscat::duration{-1}, jauscat::duration::min()}) {
        outcome of;
        test.unit.async_ask(test.arm, jaus::query_wrench_effort{}, {.timeout = timeout, .acknowledged = false}, of());
        REQUIRE(test.until([&] { return of.error.has_value(); }));
        CHECK(*of.error == jauscat::node_errc::no_answer);
    }
}

TEST_CASE("components cannot have the same ID, a wrong one, or come too late") {
    operator_and_robot test;
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 33}}), std::invalid_argument);
    CHECK_THROWS_WITH((jauscat::component{test.robots, {.id = 33}}),
                      Catch::Contains("2.1.33.1") && Catch::Contains("another ID or instance"));
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 0}}), std::invalid_argument);
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 1}}), std::invalid_argument);
    CHECK_NOTHROW((jauscat::component{test.robots, {.id = 33, .instance = 2}}));
    test.start();
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 34}}), std::logic_error);
    CHECK_THROWS_AS(test.driver.every(std::chrono::seconds{1}, [] {}), std::logic_error);
    CHECK_THROWS_AS(test.driver.on([](const jaus::set_wrench_effort&) {}), std::logic_error);
}

TEST_CASE("a message has one handler") {
    operator_and_robot test;
    test.driver.on([](const jaus::set_wrench_effort&) {}, [](const jaus::set_travel_speed&) {});
    CHECK_THROWS_AS(test.driver.on([](const jaus::set_wrench_effort&) {}), std::logic_error);
    test.driver.reports([] { return jaus::report_wrench_effort{}; });
    CHECK_THROWS_AS(test.driver.reports([] { return jaus::report_wrench_effort{}; }), std::logic_error);
    CHECK_THROWS_AS(test.driver.on([](const jaus::query_wrench_effort&) {}), std::logic_error);
}

TEST_CASE("only a node with the option primary relays between the nodes of its subsystem") {
    const auto ports = support::free_ports<3>();
    const auto system = [&](const std::string& name, const std::string& id, std::size_t at) {
        return "<system><name>" + name + "</name><jausip>" + id + "</jausip><ip>127.0.0.1</ip><port>" +
               std::to_string(ports[at]) + "</port></system>";
    };
    // Nodes 2 and 3 know each other by the way through node 1 only.
    const auto first = system("first", "5.1.0.0", 0), second = system("second", "5.2.0.0", 1),
               third = system("third", "5.3.0.0", 2), through_first = system("first", "5.0.0.0", 0);
    for (const std::uint8_t primary : {std::uint8_t{1}, std::uint8_t{0}}) {
        boost::asio::io_context context;
        std::vector<std::string> log;
        const auto options = [&](const std::string& name, const std::string& systems) {
            return jauscat::node_options{.config_text =
                                             "<jausconfig thissystem='" + name + "'>" + systems + "</jausconfig>",
                                         .this_system = name,
                                         .primary = primary,
                                         .log = [&](std::string_view line) { log.emplace_back(line); }};
        };
        jauscat::node one{context, options("first", first + second + third)},
            two{context, options("second", second + through_first)},
            three{context, options("third", third + through_first)};
        jauscat::component unit{two, {.id = 32}}, driver{three, {.id = 33}};
        driver.ready();
        one.start();
        two.start();
        three.start();
        outcome of;
        unit.async_send(driver.address(), jaus::standby{}, of());
        REQUIRE(support::until(context, [&] { return of.error.has_value(); }));
        CHECK((*of.error == error_code{}) == (primary == 1));
        const bool is_refused = std::ranges::any_of(log, [](const std::string& line) {
            return line.find("only the primary node forwards from node to node") != std::string::npos;
        });
        CHECK(is_refused == (primary == 0));
    }
}

TEST_CASE("a node with an unusable configuration or port says what is wrong") {
    two_nodes test;
    CHECK_THROWS_WITH((jauscat::node{test.context, {.config = "missing.xml"}}), Catch::Contains("missing.xml"));
    auto options = test.options("nobody");
    CHECK_THROWS_WITH((jauscat::node{test.context, options}), Catch::Contains("nobody"));
    jauscat::node first{test.context, test.options("robot")}, second{test.context, test.options("robot")};
    first.start();
    CHECK_THROWS_WITH(second.start(), Catch::Contains(std::to_string(test.ports[1])));
}

TEST_CASE("callbacks may replace themselves while they are called") {
    const std::array<long, 8> big{1, 2, 3, 4, 5, 6, 7, 8}; // of a function that must outlive its call
    long first = 0, second = 0;                            // used until the end of the component
    operator_and_robot test;
    test.driver.when_stopped([&, big] {
        test.driver.when_stopped([&] { ++second; });
        first += big[7];
    });
    test.driver.when_ready([&, big] {
        test.driver.when_ready([&] { ++second; });
        first += big[7];
    });
    test.driver.when_emergency([&, big](bool) {
        test.driver.when_emergency([&](bool) { ++second; });
        first += big[7];
    });
    test.driver.when_controlled([&, big](const std::optional<jaus::address>&) {
        test.driver.when_controlled([&](const std::optional<jaus::address>&) { ++second; });
        first += big[7];
    });
    test.driver.on_others([&, big](const jaus::header&, auto) {
        test.driver.on_others([&](const jaus::header&, auto) { return jaus::message_outcome::refused; });
        first += big[7];
        return jaus::message_outcome::handled;
    });
    test.start();
    test.driver.ready();
    const auto send = [&](const auto& message) {
        outcome of;
        test.unit.async_send(test.arm, message, of());
        REQUIRE(test.until([&] { return of.error.has_value(); }));
        return *of.error;
    };
    CHECK(send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 1}) == error_code{});
    CHECK(send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 2}) == jauscat::node_errc::refused);
    CHECK(send(jaus::request_component_control{10}) == error_code{});
    CHECK(send(jaus::release_component_control{}) == error_code{});
    CHECK(send(jaus::set_emergency{{jaus::set_emergency_code::transition_to_emergency}}) == error_code{});
    CHECK(send(jaus::clear_emergency{{jaus::clear_emergency_code::clear_emergency}}) == error_code{});
    CHECK(first == 5 * 8);
    CHECK(second >= 3);
}

TEST_CASE("a second start of a node is refused, and leaves it as it is") {
    primitive_driver test;
    CHECK_THROWS_WITH(test.robots.start(), "the node is running");
    CHECK(test.driver.state() == state::ready);
    CHECK(test.stopped == 0);
    CHECK(test.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50}) == error_code{});
    CHECK(test.effort.propulsive_linear_effort_x == Approx(50).margin(0.01));
}

TEST_CASE("a node is stopped by a function that it calls, and started again after that") {
    const auto by = GENERATE(std::string_view{"handler"}, "when_stopped", "when_ready", "periodic");
    CAPTURE(by);
    int restarts = 0, efforts = 0; // these are used until the end of the component
    std::string refusal;
    std::function<void(std::string_view)> restart;
    operator_and_robot test;
    restart = [&](std::string_view from) {
        if (from != by || restarts != 0) return;
        ++restarts;
        test.robots.stop();
        try {
            test.robots.start();
        } catch (const std::logic_error& e) {
            refusal = e.what();
        }
        boost::asio::post(test.context, [&] {
            test.robots.start();
            ++restarts;
        });
    };
    const std::array<long, 8> big{1, 2, 3, 4, 5, 6, 7, 8}; // of a function that must outlive its call
    test.driver.on([&, big](const jaus::set_wrench_effort&) {
        restart("handler");
        efforts += static_cast<int>(big[0]);
    });
    test.driver.when_stopped([&, big] {
        restart("when_stopped");
        efforts += static_cast<int>(big[0]) - 1;
    });
    test.driver.when_ready([&] { restart("when_ready"); });
    test.driver.every(std::chrono::milliseconds{5}, [&] { restart("periodic"); });
    test.start();
    test.driver.ready();
    if (by == "when_stopped") test.driver.fail("test");
    if (by == "handler")
        test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 1}, [](error_code) {});
    REQUIRE(test.until([&] { return restarts == 2; }));
    CHECK(refusal == "a node is not started by a function that it calls: post the start");
    test.driver.ready();
    efforts = 0;
    outcome of;
    REQUIRE(test.until([&] {
        if (efforts == 0 && (!of.error || *of.error)) {
            of.error.reset();
            test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 2}, of());
        }
        return efforts != 0;
    }));
}

TEST_CASE("a node runs in a context that has run out of work before") {
    two_nodes test;
    test.context.run();
    REQUIRE(test.context.stopped());
    jauscat::node node{test.context, test.options("robot")};
    jauscat::component driver{node, {.id = 33}};
    int calls = 0;
    driver.every(std::chrono::milliseconds{1}, [&] {
        if (++calls == 3) node.stop();
    });
    CHECK(node.run() == 0);
    CHECK(calls == 3);
}

TEST_CASE("a node whose port is in use does not begin") {
    two_nodes test;
    jauscat::node first{test.context, test.options("robot")};
    first.start();
    jauscat::node second{test.context, test.options("robot")};
    int ready = 0, stopped = 0;
    jauscat::component driver{second, {.id = 33}};
    driver.when_ready([&] { ++ready; });
    driver.when_stopped([&] { ++stopped; });
    driver.ready();
    CHECK_THROWS_AS(second.start(), jauscat::net::open_error);
    CHECK(ready == 0);
    first.stop();
    second.start();
    CHECK(test.until([&] { return ready == 1; }));
}

TEST_CASE("a component outside of its system's jausip is refused at the start") {
    two_nodes test;
    auto options = test.options("robot");
    const auto narrow = options.config_text.find("2.0.0.0");
    options.config_text.replace(narrow, 7, "2.1.33.0");
    jauscat::node robot{test.context, options};
    jauscat::component driver{robot, {.id = 33}};
    jauscat::component camera{robot, {.id = 37}};
    CHECK_THROWS_WITH(robot.start(),
                      "the component 2.1.37.1 is outside of the jausip 2.1.33.0 of its system \"robot\": "
                      "no message would come to it");
}

} // namespace
