// Operations that are cancelled through their cancellation slot, which Boost 1.77 and later has.
#include "app/cancellation_slots.hpp"
#include "two_nodes.hpp"
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <chrono>
#include <memory>
#include <optional>

#if BOOST_VERSION >= 107700
namespace {

using namespace app_test;
namespace asio = boost::asio;

/// The robot's node starts after the cancellation, so that it answers what is repeated.
struct operator_of_a_late_robot : operator_and_robot {
    asio::cancellation_signal signal{};
    std::optional<error_code> error{};
    int commands{}, reports{}, taken{};

    operator_of_a_late_robot() {
        driver.on([this](const jaus::set_wrench_effort&) { ++commands; });
        driver.reports([this] {
            ++reports;
            return jaus::report_wrench_effort{};
        });
        driver.when_controlled([this](const std::optional<jaus::address>& by) { taken += by ? 1 : 0; });
        driver.ready();
        mine.start();
        unit.ready();
    }
    auto token() {
        return asio::bind_cancellation_slot(signal.slot(), [this](error_code what, auto&&...) { error = what; });
    }
    void wait(std::chrono::milliseconds time) {
        bool over = false;
        asio::steady_timer timer{context, time};
        timer.async_wait([&](error_code) { over = true; });
        REQUIRE(until([&] { return over; }));
    }
    jauscat::control take_control() {
        bool held = false;
        jauscat::control control;
        unit.async_control(arm, {}, [&](error_code why, jauscat::control is) {
            held = !why;
            control = std::move(is);
        });
        REQUIRE(until([&] { return held; }));
        return control;
    }
    void cancel_and_start_robot() {
        bool begun = false;
        asio::post(context, [&] { begun = true; }); // behind the operation
        REQUIRE(until([&] { return begun; }));
        CHECK_FALSE(error);
        signal.emit(asio::cancellation_type::all);
        REQUIRE(until([&] { return error.has_value(); }));
        CHECK(*error == asio::error::operation_aborted);
        robots.start();
        wait(std::chrono::milliseconds{600}); // more than two intervals of the retry policy
    }
};

TEST_CASE("a cancelled request for control is not repeated") {
    operator_of_a_late_robot test;
    test.unit.async_control(test.arm, {}, test.token());
    test.cancel_and_start_robot();
    CHECK(test.taken == 0);
}

TEST_CASE("control that is confirmed after the cancellation of its request is released") {
    operator_of_a_late_robot test;
    test.robots.start();
    test.unit.async_control(test.arm, {.renewal = {}}, test.token());
    asio::post(test.context, [&] { test.signal.emit(asio::cancellation_type::all); }); // its request is sent
    REQUIRE(test.until([&] { return test.error && test.taken == 1 && !test.driver.controller(); }));
    CHECK(*test.error == asio::error::operation_aborted);
    CHECK(test.taken == 1);

    auto control = test.take_control();
    test.wait(std::chrono::milliseconds{300}); // no repeat of the first release ends it
    CHECK(test.driver.controller() == test.unit.address());
    CHECK(test.taken == 2);
}

TEST_CASE("a cancelled service connection sends no reports") {
    operator_of_a_late_robot test;
    test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 100}, test.token());
    test.cancel_and_start_robot();
    CHECK(test.reports == 0);
}

TEST_CASE("a service connection that is confirmed after its cancellation is ended") {
    operator_of_a_late_robot test;
    test.robots.start();
    test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 100}, test.token());
    asio::post(test.context, [&] { test.signal.emit(asio::cancellation_type::all); }); // its request is sent
    REQUIRE(test.until([&] { return test.error.has_value(); }));
    test.wait(std::chrono::milliseconds{600});
    const int at_the_end = test.reports;
    test.wait(std::chrono::milliseconds{100});
    CHECK(test.reports == at_the_end);
}

TEST_CASE("an event that is confirmed after its cancellation is ended") {
    operator_of_a_late_robot test;
    test.unit.async_event<jaus::report_wrench_effort>(
        test.arm, {.event_type = jaus::event_type::periodic, .requested_periodic_rate = 100}, test.token());
    test.cancel_and_start_robot(); // its ID is known when it is confirmed
    const int at_the_end = test.reports;
    test.wait(std::chrono::milliseconds{100});
    CHECK(test.reports == at_the_end);
}

TEST_CASE("a cancelled command is not repeated") {
    operator_of_a_late_robot test;
    test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 5}, test.token());
    test.cancel_and_start_robot();
    CHECK(test.commands == 0);
}

TEST_CASE("a cancelled question is not repeated") {
    operator_of_a_late_robot test;
    const bool acknowledged = GENERATE(true, false);
    test.unit.async_ask(test.arm, jaus::query_wrench_effort{}, {.acknowledged = acknowledged}, test.token());
    test.cancel_and_start_robot();
    CHECK(test.reports == 0);
}

TEST_CASE("the wait for the next report is cancelled, and the report after it is kept for the next wait") {
    operator_of_a_late_robot test;
    test.robots.start();
    jauscat::subscription<jaus::report_wrench_effort> efforts;
    test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 10}, [&](error_code, auto is) {
        efforts = std::move(is);
        efforts.async_next(test.token());
        test.signal.emit(asio::cancellation_type::all);
    });
    REQUIRE(test.until([&] { return test.error.has_value(); }));
    CHECK(*test.error == asio::error::operation_aborted);
    bool next = false;
    efforts.async_next([&](error_code error, const jaus::report_wrench_effort&) { next = !error; });
    CHECK(test.until([&] { return next; }));
}

TEST_CASE("a cancelled wait for the loss of control leaves control as it is") {
    operator_of_a_late_robot test;
    test.robots.start();
    jauscat::control control;
    test.unit.async_control(test.arm, {}, [&](error_code, jauscat::control is) {
        control = std::move(is);
        control.async_lost(test.token());
        test.signal.emit(asio::cancellation_type::all);
    });
    REQUIRE(test.until([&] { return test.error.has_value(); }));
    CHECK(*test.error == asio::error::operation_aborted);
    CHECK(control.is_held());
}

TEST_CASE("a search for components is cancelled") {
    operator_of_a_late_robot test;
    test.unit.async_find({.timeout = std::chrono::hours{1}}, test.token());
    test.signal.emit(asio::cancellation_type::all); // before the own node manager answers
    REQUIRE(test.until([&] { return test.error.has_value(); }));
    CHECK(*test.error == asio::error::operation_aborted);
}

TEST_CASE("a command under control and a release are cancelled, and control is over") {
    operator_of_a_late_robot test;
    test.robots.start();
    auto control = test.take_control();
    test.robots.stop();
    SECTION("the command") { control.async_send(jaus::set_wrench_effort{}, test.token()); }
    SECTION("the release") { control.async_release(test.token()); }
    test.cancel_and_start_robot();
    CHECK(test.commands == 0);
    CHECK_FALSE(test.driver.controller());
}

TEST_CASE("a cancellation after the end of an operation, of its node and of its context does nothing") {
    auto signal = std::make_unique<asio::cancellation_signal>();
    {
        operator_of_a_late_robot test;
        test.robots.start();
        std::optional<error_code> error;
        test.unit.async_send(test.arm, jaus::standby{},
                             asio::bind_cancellation_slot(signal->slot(), [&](error_code what) { error = what; }));
        REQUIRE(test.until([&] { return error.has_value(); }));
        CHECK(*error == error_code{});
        signal->emit(asio::cancellation_type::all);
        test.wait(std::chrono::milliseconds{1});
    }
    signal->emit(asio::cancellation_type::all);
}

} // namespace
#endif
