#include "two_nodes.hpp"
#include <jauscat/schema/jaus/platform.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
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

TEST_CASE("components cannot have the same ID, a wrong one, or come too late") {
    operator_and_robot test;
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 33}}), std::invalid_argument);
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 0}}), std::invalid_argument);
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 1}}), std::invalid_argument);
    CHECK_NOTHROW((jauscat::component{test.robots, {.id = 33, .instance = 2}}));
    test.start();
    CHECK_THROWS_AS((jauscat::component{test.robots, {.id = 34}}), std::logic_error);
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

} // namespace
