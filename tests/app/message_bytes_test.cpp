// Messages as bytes, for programs that take any: sent, asked, received, explained. Release of control.
#include "two_nodes.hpp"
#include <jauscat/schema/jaus/platform.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace {

using namespace app_test;
using jauscat::node_errc;
using body_bytes = std::vector<std::byte>;

template <class T> body_bytes body_of(const T& message) {
    body_bytes body(jauscat::wire::encoded_size(message));
    body.resize(jauscat::wire::encode(message, body)->size());
    return body;
}
constexpr auto set_effort = jaus::command_code_of<jaus::set_wrench_effort>;
const body_bytes half = body_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50});

struct driver_of_bytes : operator_and_robot {
    jaus::report_wrench_effort effort{};
    std::optional<error_code> error{};
    body_bytes report{};
    jauscat::control control{};

    /// Without `serves`, the test gives handlers and starts the nodes.
    explicit driver_of_bytes(bool serves = true) {
        driver.on([this](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
        driver.reports([this] { return effort; });
        driver.ready();
        if (serves) start();
    }
    /// The error of the operation that `begin` starts.
    error_code error_of(auto begin) {
        error.reset();
        begin([this](error_code what) { error = what; });
        REQUIRE(until([&] { return error.has_value(); }));
        return *error;
    }
    error_code send(std::uint16_t code, const body_bytes& body) {
        return error_of([&](auto done) { unit.async_send(arm, code, body, done); });
    }
    error_code ask(std::uint16_t code, const body_bytes& body, const jauscat::ask_options& options = {}) {
        return error_of([&](auto done) {
            unit.async_ask(arm, code, body, options, [this, done](error_code what, body_bytes answer) {
                report = std::move(answer);
                done(what);
            });
        });
    }
    error_code take_control(jauscat::component& by, jauscat::control& made) {
        return error_of([&](auto done) {
            by.async_control(arm, {.authority = std::uint8_t(&by == &unit ? 100 : 200)},
                             [&made, done](error_code what, jauscat::control held) {
                                 made = std::move(held);
                                 done(what);
                             });
        });
    }
};

} // namespace

TEST_CASE("a command is sent, and a query asked, by command code and body") {
    driver_of_bytes test;
    CHECK(test.send(set_effort, half) == error_code{});
    CHECK(test.effort.propulsive_linear_effort_x == Approx(50).margin(0.01));
    const auto query = body_of(jaus::query_wrench_effort{0x0001});
    for (const bool acknowledged : {true, false}) {
        CHECK(test.ask(jaus::command_code_of<jaus::query_wrench_effort>, query, {.acknowledged = acknowledged}) ==
              error_code{});
        CHECK(test.report == half); // both have the same layout
    }
    CHECK(test.send(set_effort, {std::byte{0xFF}}) == node_errc::refused);
}

TEST_CASE("a command code that no report answers cannot be asked") {
    driver_of_bytes test;
    CHECK(test.ask(set_effort, half) == node_errc::not_a_query);
    CHECK(test.effort == jaus::report_wrench_effort{});
}

TEST_CASE("a command as bytes is sent under control, and is not sent when that is released") {
    driver_of_bytes test;
    REQUIRE(test.take_control(test.unit, test.control) == error_code{});
    const auto send = [&](auto done) { test.control.async_send(set_effort, half, done); };
    CHECK(test.error_of(send) == error_code{});
    CHECK(test.effort.propulsive_linear_effort_x == Approx(50).margin(0.01));
    test.effort = {};
    CHECK(test.error_of([&](auto done) { test.control.async_release(done); }) == error_code{});
    CHECK(test.error_of(send) == node_errc::control_lost);
    CHECK(test.effort == jaus::report_wrench_effort{});
}

TEST_CASE("a command whose acknowledgement is awaited ends with control_lost when control is rejected or released") {
    driver_of_bytes test;
    REQUIRE(test.take_control(test.unit, test.control) == error_code{});
    std::optional<error_code> sent, lost;
    test.control.async_lost([&](error_code what) { lost = what; });
    SECTION("rejected") {
        test.control.async_send(set_effort, half, [&](error_code what) { sent = what; });
        boost::asio::post(test.context, [&] { test.driver.reject_control(); }); // before the command arrives
    }
    SECTION("released") {
        test.control.async_send(set_effort, half, [&](error_code what) { sent = what; });
        test.control.release();
    }
    REQUIRE(test.until([&] { return sent.has_value() && lost.has_value(); }));
    CHECK(*sent == node_errc::control_lost);
}

TEST_CASE("a release of control completes when the component has acknowledged it") {
    driver_of_bytes test;
    REQUIRE(test.take_control(test.unit, test.control) == error_code{});
    std::optional<error_code> lost;
    test.control.async_lost([&](error_code what) { lost = what; });
    const auto release = [&](auto done) { test.control.async_release(done); };
    CHECK(test.error_of(release) == error_code{});
    CHECK_FALSE(test.driver.controller());
    CHECK_FALSE(test.control.is_held());
    REQUIRE(test.until([&] { return lost.has_value(); }));
    CHECK(*lost == boost::asio::error::operation_aborted);
    CHECK(test.error_of(release) == node_errc::control_lost);
}

TEST_CASE("a release of control that nobody acknowledges ends without an answer") {
    driver_of_bytes test;
    REQUIRE(test.take_control(test.unit, test.control) == error_code{});
    test.robots.stop();
    CHECK(test.error_of([&](auto done) { test.control.async_release(done); }) == node_errc::no_answer);
}

TEST_CASE("a release of control that is followed by a request for it is aborted, or acknowledged before") {
    driver_of_bytes test;
    REQUIRE(test.take_control(test.unit, test.control) == error_code{});
    std::optional<error_code> released;
    test.control.async_release([&](error_code what) { released = what; });
    jauscat::control again;
    CHECK(test.take_control(test.unit, again) == error_code{});
    REQUIRE(test.until([&] { return released.has_value(); }));
    CHECK((*released == error_code{} || *released == boost::asio::error::operation_aborted));
    CHECK(again.is_held());
}

TEST_CASE("messages without a handler are given to on_others, which says what becomes of them") {
    driver_of_bytes test{false};
    std::vector<std::uint16_t> others;
    test.driver.on_others([&](const jaus::header& head, jauscat::app::bytes) {
        others.push_back(head.command_code);
        return head.command_code == set_effort + 1 ? jaus::message_outcome::unhandled : jaus::message_outcome::handled;
    });
    test.start();
    const auto report = jaus::command_code_of<jaus::report_wrench_effort>;
    CHECK(test.send(set_effort, half) == error_code{});
    CHECK(test.send(report, half) == error_code{});
    CHECK(test.send(set_effort + 1, half) == node_errc::refused);
    CHECK(others == std::vector<std::uint16_t>{report, set_effort + 1});
}

TEST_CASE("a malformed message is logged with the explanation of the program") {
    two_nodes test;
    auto options = test.options("robot");
    bool explains = true;
    options.explain_malformed = [&](std::uint16_t code, jauscat::app::bytes body) {
        const bool is_it = explains && code == set_effort && body.size() == 3;
        return is_it ? std::string{"propulsive_linear_effort_x is cut"} : std::string{};
    };
    jauscat::node mine{test.context, test.options("operator")}, robots{test.context, options};
    jauscat::component unit{mine, {.id = 32}}, driver{robots, {.id = 33}};
    driver.on([](const jaus::set_wrench_effort&) {});
    driver.ready();
    robots.start();
    mine.start();
    const auto send = [&] {
        std::optional<error_code> error;
        unit.async_send(driver.address(), set_effort, body_bytes{std::byte{1}, std::byte{0}, std::byte{7}},
                        [&](error_code what) { error = what; });
        REQUIRE(test.until([&] { return error.has_value(); }));
        CHECK(*error == node_errc::refused);
    };
    send();
    CHECK(test.has_logged("propulsive_linear_effort_x is cut"));
    test.log.clear();
    explains = false; // then the error alone
    send();
    CHECK(test.has_logged(std::string{jauscat::wire::describe(jauscat::wire::errc::truncated)}));
    CHECK_FALSE(test.has_logged("propulsive_linear_effort_x is cut"));
}

TEST_CASE("a node counts its datagrams, and shares its port with another program that does, too") {
    two_nodes test;
    auto options = test.options("robot");
    options.reuse_address = true;
    jauscat::node mine{test.context, test.options("operator")}, robots{test.context, options},
        same{test.context, options};
    CHECK(robots.counts() == jauscat::net::udp_counters{});
    jauscat::component driver{robots, {.id = 33}};
    robots.start();
    CHECK_NOTHROW(same.start());
    same.stop();
    mine.start();
    CHECK(test.until([&] { return robots.counts().received != 0 && mine.counts().sent != 0; })); // heartbeats
}
