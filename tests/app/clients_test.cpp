#include "two_nodes.hpp"
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

#include <optional>

namespace {

using namespace app_test;

#ifdef BOOST_ASIO_HAS_CO_AWAIT

struct driver_and_operator : operator_and_robot {
    jaus::report_wrench_effort effort{};
    int stopped{};
    bool done{};

    driver_and_operator() {
        driver.on([this](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
        driver.reports([this] { return effort; });
        driver.when_stopped([this] { ++stopped; });
        driver.ready();
        start();
    }
    /// Runs the coroutine to its end.
    void run(auto coroutine) {
        std::exception_ptr problem;
        boost::asio::co_spawn(context, coroutine, [&](std::exception_ptr thrown) {
            problem = thrown;
            done = true;
        });
        REQUIRE(until([&] { return done; }));
        if (problem) std::rethrow_exception(problem);
    }
};

TEST_CASE("an operator takes control, commands, asks, and receives reports in a coroutine") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto control = co_await test.unit.async_control(test.arm, {.authority = 100});
        CHECK(control.is_held());
        CHECK(test.driver.controller() == test.unit.address());
        co_await control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50});
        const auto report = co_await test.unit.async_ask(test.arm, jaus::query_wrench_effort{0xFFFF});
        CHECK(report.propulsive_linear_effort_x == Approx(50).margin(0.01));
        auto efforts = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 100});
        for (int i = 0; i != 3; ++i) {
            const auto next = co_await efforts.async_next();
            CHECK(next.propulsive_linear_effort_x == Approx(50).margin(0.01));
        }
        CHECK(test.stopped == 0);
    });
    CHECK(test.until([&] { return !test.driver.controller(); })); // the end of the scope has released it
    CHECK(test.stopped == 1);
}

TEST_CASE("events of every change come once for each change") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto events = co_await test.unit.async_event<jaus::report_wrench_effort>(
            test.arm, jaus::create_event{.event_type = jaus::event_type::every_change});
        for (const double x : {10.0, 20.0, 30.0}) {
            co_await test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = x});
            const auto next = co_await events.async_next();
            CHECK(next.propulsive_linear_effort_x == Approx(x).margin(0.01));
        }
        test.effort.propulsive_linear_effort_x = 40;
        test.driver.changed();
        const auto next = co_await events.async_next();
        CHECK(next.propulsive_linear_effort_x == Approx(40).margin(0.01));
    });
}

TEST_CASE("control that another component takes over is lost, and a command by it is refused before it is sent") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto control = co_await test.unit.async_control(test.arm, {.authority = 100});
        auto second = co_await test.robot_unit.async_control(test.arm, {.authority = 200});
        error_code why;
        co_await control.async_lost(boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::control_lost);
        CHECK(test.stopped == 1);
        CHECK_FALSE(control.is_held());
        co_await control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50},
                                    boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::control_lost);
        CHECK(test.effort == jaus::report_wrench_effort{});
        auto third = co_await test.unit.async_control(
            test.arm, {.authority = 150}, boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::control_refused);
        CHECK_FALSE(third.is_held());
    });
}

TEST_CASE("control is requested once at a time") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto control = co_await test.unit.async_control(test.arm, {});
        error_code why;
        auto again = co_await test.unit.async_control(test.arm, {},
                                                      boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::already_asked);
        control.release();
        control = co_await test.unit.async_control(test.arm, {});
        CHECK(control.is_held());
    });
}

TEST_CASE("a subscription says once that its provider is silent, and goes on when that is back") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto efforts = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 50});
        static_cast<void>(co_await efforts.async_next());
        test.robots.stop();
        error_code why;
        do {
            co_await efforts.async_next(boost::asio::redirect_error(boost::asio::use_awaitable, why));
        } while (!why);
        CHECK(why == jauscat::node_errc::silent);
        test.robots.start();
        static_cast<void>(co_await efforts.async_next());
    });
}

TEST_CASE("a report is subscribed to once, and again when that has ended") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        error_code why;
        auto efforts = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 50});
        auto again = co_await test.unit.async_connect<jaus::report_wrench_effort>(
            test.arm, {.rate = 50}, boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::already_asked);
        auto unknown = co_await test.unit.async_connect<jaus::report_global_pose>(
            test.arm, {.rate = 50}, boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::connection_refused);
        efforts.end();
        efforts = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 50});
        static_cast<void>(co_await efforts.async_next());
    });
}

TEST_CASE("messages with lists and large messages are sent and received as typed values") {
    driver_and_operator test{no_start};
    std::vector<jaus::feature_class_metadata> received;
    std::string long_text(20'000, 'x');
    jaus::report_image picture{};
    const std::vector<std::byte> pixels(100'000, std::byte{7});
    picture.image_data = pixels;
    std::size_t taken{};
    test.driver.on([&](const jaus::report_image& image) { taken = image.image_data.size(); });
    test.driver.reports([&] { return picture; });
    test.start();
    test.run([&]() -> boost::asio::awaitable<void> {
        co_await test.unit.async_send(test.arm, picture);
        CHECK(taken == pixels.size());
        const auto back = co_await test.unit.async_ask(test.arm, jaus::query_image{});
        CHECK(back.image_data.size() == pixels.size());
    });
}

#endif

} // namespace
