// What each public function does in each state of its object. Run under the address sanitizer, too.
#include "app/emulated_bus.hpp"
#include "two_nodes.hpp"
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <boost/asio/bind_executor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/use_future.hpp>

#include <chrono>
#include <csignal>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace app_test;
using namespace std::chrono_literals;
using wrench = jaus::report_wrench_effort;
using stream = jauscat::subscription<wrench>;

/// What a call has done: "done", the message of an error or of an exception, or a value as text.
template <class F> std::string done_by(F call) {
    try {
        call();
        return "done";
    } catch (const std::exception& e) {
        return e.what();
    }
}

/// A row of a table: a function, and its results in the states of the table's columns.
template <class Bench> struct row {
    std::string_view function;
    std::function<std::string(Bench&)> call;
    std::vector<std::string_view> results;
};

/// An operation whose result is waited for when the state has been left.
constexpr std::string_view begun = "begun";
constexpr std::string_view good = "Success";
constexpr std::string_view aborted = "Operation canceled";
constexpr std::string_view not_running = "the node is not running";
constexpr std::string_view no_control = "control is lost";

/// An operator whose handles may outlive what they belong to, and a robot that works.
struct operator_bench : two_nodes {
    explicit operator_bench(bool own_context = false)
        : has_own_context{own_context},
          mine{own_context ? std::make_unique<jauscat::node>(options("operator"))
                           : std::make_unique<jauscat::node>(context, options("operator"))} {
        driver.on([](const jaus::set_wrench_effort&) {});
        driver.reports([] { return wrench{.propulsive_linear_effort_x = 5}; });
        robots.start();
        driver.ready();
    }
    bool has_own_context;
    std::optional<std::string> result{};
    std::unique_ptr<jauscat::node> mine;
    std::unique_ptr<jauscat::component> unit =
        std::make_unique<jauscat::component>(*mine, jauscat::component_options{.id = 32});
    jauscat::node robots{context, options("robot")};
    jauscat::component driver{robots, {.id = 33}};
    jaus::address arm = driver.address();
    jauscat::control control{};
    stream reports{};

    /// A completion token that keeps the result; called in the test's io_context.
    auto kept() {
        return boost::asio::bind_executor(context, [this](error_code error, auto&&...) { result = error.message(); });
    }
    bool until(const std::function<bool()>& done) {
        return two_nodes::until([&] {
            if (has_own_context && mine) mine->context().poll();
            if (!done()) boost::asio::post(context, [] {}); // asks again at once
            return done();
        });
    }
    std::string begin(auto start) {
        result.reset();
        start(kept());
        return std::string{begun};
    }
    void run() {
        mine->start();
        unit->ready();
        std::optional<error_code> has_control, has_reports;
        unit->async_control(arm, {}, [&](error_code error, jauscat::control made) {
            has_control = error;
            control = std::move(made);
        });
        unit->async_connect<wrench>(arm, {.rate = 100}, [&](error_code error, stream made) {
            has_reports = error;
            reports = std::move(made);
        });
        REQUIRE(until([&] { return has_control && has_reports; }));
        REQUIRE_FALSE(*has_control);
        REQUIRE_FALSE(*has_reports);
    }
    /// What `call` returns; of an operation, its result.
    std::string outcome(std::string what) {
        if (what != begun) return what;
        REQUIRE(until([&] { return result.has_value(); }));
        return *result;
    }
    /// The same while the node stops.
    std::string outcome_while_stopping(const std::function<std::string()>& call) {
        std::optional<std::string> what;
        unit->when_stopped([&] {
            if (!what) what = call();
        });
        mine->stop();
        REQUIRE(what);
        return outcome(*what);
    }
};

void check(std::string_view function, std::string_view state, const std::string& what, std::string_view expected) {
    CAPTURE(function, state);
    CHECK(what == expected);
}

jaus::set_wrench_effort some_effort() { return {.propulsive_linear_effort_x = 10}; }

} // namespace

TEST_CASE("each function of a component has a defined result in each of its states") {
    using bench = operator_bench;
    constexpr std::string_view too_late = "handlers are given before the node starts";
    const auto text_of = [](jaus::primary_status_code state) {
        return state == jaus::primary_status_code::ready ? "ready" : "initialize";
    };
    const std::vector<row<bench>> table{
        // new, running, while it is stopped, stopped, its node has ended
        {"on",
         [](bench& b) { return done_by([&] { b.unit->on([](const jaus::set_travel_speed&) {}); }); },
         {"done", too_late, too_late, "done", "done"}},
        {"on_others",
         [](bench& b) {
             return done_by([&] { b.unit->on_others([](auto&, auto) { return jaus::message_outcome::handled; }); });
         },
         {"done", "done", "done", "done", "done"}},
        {"reports",
         [](bench& b) { return done_by([&] { b.unit->reports([] { return wrench{}; }); }); },
         {"done", "reports are given before the node starts", "reports are given before the node starts", "done",
          "done"}},
        {"changed",
         [](bench& b) { return done_by([&] { b.unit->changed(); }); },
         {"done", "done", "done", "done", "done"}},
        {"when_stopped",
         [](bench& b) { return done_by([&] { b.unit->when_stopped([] {}); }); },
         {"done", "done", "done", "done", "done"}},
        {"when_ready",
         [](bench& b) { return done_by([&] { b.unit->when_ready([] {}); }); },
         {"done", "done", "done", "done", "done"}},
        {"when_emergency",
         [](bench& b) { return done_by([&] { b.unit->when_emergency([](bool) {}); }); },
         {"done", "done", "done", "done", "done"}},
        {"when_controlled",
         [](bench& b) { return done_by([&] { b.unit->when_controlled([](auto&) {}); }); },
         {"done", "done", "done", "done", "done"}},
        {"every",
         [](bench& b) { return done_by([&] { b.unit->every(1s, [] {}); }); },
         {"done", "periodic functions are given before the node starts",
          "periodic functions are given before the node starts", "done", "done"}},
        {"ready", [](bench& b) { return done_by([&] { b.unit->ready(); }); }, {"done", "done", "done", "done", "done"}},
        {"fail",
         [](bench& b) { return done_by([&] { b.unit->fail("test"); }); },
         {"done", "done", "done", "done", "done"}},
        {"reject_control",
         [](bench& b) { return done_by([&] { b.unit->reject_control(); }); },
         {"done", "done", "done", "done", "done"}},
        {"state",
         [&](bench& b) { return std::string{text_of(b.unit->state())}; },
         {"initialize", "ready", "ready", "initialize", "initialize"}},
        {"controller",
         [](bench& b) { return std::string{b.unit->controller() ? "one" : "none"}; },
         {"none", "none", "none", "none", "none"}},
        {"address",
         [](bench& b) { return std::string{b.unit->address() == jaus::address{1, 32, 1, 1} ? "its own" : "another"}; },
         {"its own", "its own", "its own", "its own", "its own"}},
        {"send",
         [](bench& b) {
             const auto sent = b.unit->send(b.arm, some_effort());
             return std::string{sent                                                   ? "done"
                                : sent.error().code == jauscat::net::errc::not_running ? "not running"
                                                                                       : "?"};
         },
         {"not running", "done", "done", "not running", "not running"}},
        {"async_send",
         [](bench& b) { return b.begin([&](auto done) { b.unit->async_send(b.arm, some_effort(), done); }); },
         {not_running, good, not_running, not_running, not_running}},
        {"async_ask",
         [](bench& b) {
             return b.begin(
                 [&](auto done) { b.unit->async_ask(b.arm, jaus::query_wrench_effort{.presence_vector = 1}, done); });
         },
         {not_running, good, not_running, not_running, not_running}},
        {"async_control",
         [](bench& b) { return b.begin([&](auto done) { b.unit->async_control(b.robots.manager(), {}, done); }); },
         {not_running, good, not_running, not_running, not_running}},
        {"async_connect",
         [](bench& b) {
             b.reports.end();
             return b.begin([&](auto done) { b.unit->async_connect<wrench>(b.arm, {}, done); });
         },
         {not_running, good, not_running, not_running, not_running}},
        {"async_event",
         [](bench& b) {
             return b.begin([&](auto done) {
                 b.unit->async_event<wrench>(b.arm, {.event_type = jaus::event_type::every_change}, done);
             });
         },
         {not_running, good, not_running, not_running, not_running}},
        {"async_find",
         [](bench& b) { return b.begin([&](auto done) { b.unit->async_find({.timeout = 50ms}, done); }); },
         {not_running, good, not_running, not_running, not_running}},
        {"cancel",
         [](bench& b) { return done_by([&] { b.unit->cancel(); }); },
         {"done", "done", "done", "done", "done"}},
        {"its end",
         [](bench& b) { return done_by([&] { b.unit.reset(); }); },
         {"done", "done", "done", "done", "done"}},
        {"another one with its ID",
         [](bench& b) {
             if (b.mine == nullptr) return std::string{"none"};
             b.unit.reset();
             return done_by(
                 [&] { b.unit = std::make_unique<jauscat::component>(*b.mine, jauscat::component_options{.id = 32}); });
         },
         {"done", "the component 1.1.32.1 is made after the start of its node",
          "the component 1.1.32.1 is made after the start of its node", "done", "none"}},
    };
    for (const auto& each : table) {
        {
            bench b;
            check(each.function, "new", b.outcome(each.call(b)), each.results.at(0));
        }
        {
            bench b;
            b.run();
            check(each.function, "running", b.outcome(each.call(b)), each.results.at(1));
        }
        {
            bench b;
            b.run();
            check(each.function, "while it is stopped", b.outcome_while_stopping([&] { return each.call(b); }),
                  each.results.at(2));
        }
        {
            bench b;
            b.run();
            b.mine->stop();
            check(each.function, "stopped", b.outcome(each.call(b)), each.results.at(3));
        }
        {
            bench b;
            b.run();
            b.mine.reset();
            check(each.function, "its node has ended", b.outcome(each.call(b)), each.results.at(4));
        }
    }
}

TEST_CASE("each function of a control and of a subscription has a defined result in each of its states") {
    using bench = operator_bench;
    const std::vector<row<bench>> table{
        // in use, never made, moved from, while the node stops, after that, and without component, node, and both
        {"control::async_send",
         [](bench& b) { return b.begin([&](auto done) { b.control.async_send(some_effort(), done); }); },
         {good, no_control, no_control, not_running, not_running, aborted, not_running, aborted}},
        {"control::async_release",
         [](bench& b) { return b.begin([&](auto done) { b.control.async_release(done); }); },
         {good, no_control, no_control, not_running, not_running, aborted, not_running, aborted}},
        {"control::async_lost",
         [](bench& b) {
             return b.begin([&](auto done) {
                 b.control.async_lost(done);
                 b.control.release();
             });
         },
         {aborted, no_control, no_control, no_control, no_control, no_control, no_control, no_control}},
        {"control::is_held",
         [](bench& b) { return std::string{b.control.is_held() ? "held" : "not held"}; },
         {"held", "not held", "not held", "held", "not held", "not held", "not held", "not held"}},
        {"control::of",
         [](bench& b) {
             return std::string{b.control.of() == b.arm ? "it" : b.control.of() == jaus::address{} ? "nobody" : "?"};
         },
         {"it", "nobody", "nobody", "it", "it", "it", "it", "it"}},
        {"control::release",
         [](bench& b) { return done_by([&] { b.control.release(); }); },
         {"done", "done", "done", "done", "done", "done", "done", "done"}},
        {"the end of a control",
         [](bench& b) { return done_by([&] { b.control = {}; }); },
         {"done", "done", "done", "done", "done", "done", "done", "done"}},
        {"subscription::async_next",
         [](bench& b) { return b.begin([&](auto done) { b.reports.async_next(done); }); },
         {good, aborted, aborted, aborted, aborted, aborted, aborted, aborted}},
        {"subscription::dropped",
         [](bench& b) { return std::to_string(b.reports.dropped()); },
         {"0", "0", "0", "0", "0", "0", "0", "0"}},
        {"subscription::end",
         [](bench& b) { return done_by([&] { b.reports.end(); }); },
         {"done", "done", "done", "done", "done", "done", "done", "done"}},
        {"the end of a subscription",
         [](bench& b) { return done_by([&] { b.reports = {}; }); },
         {"done", "done", "done", "done", "done", "done", "done", "done"}},
    };
    const bool has_own_context = GENERATE(false, true);
    CAPTURE(has_own_context);
    for (const auto& each : table) {
        const auto in_state = [&](std::string_view state, std::size_t column, auto enter) {
            bench b{has_own_context};
            b.run();
            enter(b);
            check(each.function, state, b.outcome(each.call(b)), each.results.at(column));
        };
        in_state("in use", 0, [](bench&) {});
        in_state("never made", 1, [](bench& b) {
            b.control = {};
            b.reports = {};
        });
        in_state("moved from", 2, [kept = std::pair<jauscat::control, stream>{}](bench& b) mutable {
            kept.first = std::move(b.control);
            kept.second = std::move(b.reports);
        });
        {
            bench b{has_own_context};
            b.run();
            check(each.function, "while the node stops", b.outcome_while_stopping([&] { return each.call(b); }),
                  each.results.at(3));
        }
        in_state("stopped", 4, [](bench& b) { b.mine->stop(); });
        in_state("without component", 5, [](bench& b) { b.unit.reset(); });
        in_state("without node", 6, [](bench& b) { b.mine.reset(); });
        in_state("without both", 7, [](bench& b) {
            b.unit.reset();
            b.mine.reset();
        });
    }
}

TEST_CASE("each function of a node has a defined result in each of its states") {
    struct bench : two_nodes {
        std::unique_ptr<jauscat::node> mine = std::make_unique<jauscat::node>(context, options("operator"));
        jauscat::component unit{*mine, {.id = 32}};
    };
    constexpr std::string_view runs = "the node is running";
    const auto run = [](bench& b) {
        // It works until the next turn.
        boost::asio::post(b.context, [&] { b.mine->stop(); });
        const int code = b.mine->run();
        return code == 0 ? std::string{"0"} : b.log.back();
    };
    const std::vector<row<bench>> table{
        // new, running, in a function that it calls while it stops, stopped
        {"run", run, {"0", runs, runs, "0"}},
        {"start", [](bench& b) { return done_by([&] { b.mine->start(); }); }, {"done", runs, runs, "done"}},
        {"stop", [](bench& b) { return done_by([&] { b.mine->stop(); }); }, {"done", "done", "done", "done"}},
        {"context",
         [](bench& b) { return std::string{&b.mine->context() == &b.context ? "that of the program" : "?"}; },
         {"that of the program", "that of the program", "that of the program", "that of the program"}},
        {"manager",
         [](bench& b) { return std::string{b.mine->manager() == jaus::address{1, 1, 1, 1} ? "1.1.1.1" : "?"}; },
         {"1.1.1.1", "1.1.1.1", "1.1.1.1", "1.1.1.1"}},
        {"counts", [](bench& b) { return std::to_string(b.mine->counts().received); }, {"0", "0", "0", "0"}},
        {"when_appeared",
         [](bench& b) { return done_by([&] { b.mine->when_appeared([](auto&) {}); }); },
         {"done", "done", "done", "done"}},
        {"when_disappeared",
         [](bench& b) { return done_by([&] { b.mine->when_disappeared([](auto&) {}); }); },
         {"done", "done", "done", "done"}},
        {"lose",
         [](bench& b) { return done_by([&] { b.mine->lose({1, 33, 1, 2}); }); },
         {"done", "done", "done", "done"}},
        {"its end", [](bench& b) { return done_by([&] { b.mine.reset(); }); }, {"done", "done", "", "done"}},
    };
    for (const auto& each : table) {
        {
            bench b;
            check(each.function, "new", each.call(b), each.results.at(0));
        }
        {
            bench b;
            b.mine->start();
            check(each.function, "running", each.call(b), each.results.at(1));
            CHECK((b.mine == nullptr || each.function == "stop" || b.unit.send({1, 33, 1, 2}, some_effort())));
        }
        if (const auto expected = each.results.at(2); !expected.empty()) {
            bench b;
            std::string what;
            b.unit.when_stopped([&] {
                if (what.empty()) what = each.call(b);
            });
            b.mine->start();
            b.unit.ready();
            b.mine->stop();
            check(each.function, "while it stops", what, expected);
        }
        {
            bench b;
            b.mine->start();
            b.mine->stop();
            check(each.function, "stopped", each.call(b), each.results.at(3));
        }
    }
}

TEST_CASE("a component made anew with the ID of one that has ended takes its place") {
    operator_bench b;
    b.run();
    int first = 0, second = 0;
    b.robots.stop();
    auto driver = std::make_unique<jauscat::component>(b.robots, jauscat::component_options{.id = 34});
    driver->on([&](const jaus::set_wrench_effort&) { ++first; });
    b.robots.start();
    driver->ready();
    const auto to = driver->address();
    driver.reset(); // also while the node works
    CHECK(b.outcome(b.begin([&](auto done) { b.unit->async_send(to, some_effort(), done); })) != good);
    b.robots.stop();
    driver = std::make_unique<jauscat::component>(b.robots, jauscat::component_options{.id = 34});
    driver->on([&](const jaus::set_wrench_effort&) { ++second; });
    b.robots.start();
    driver->ready();
    REQUIRE(b.until([&] { // the nodes find each other again
        return b.outcome(b.begin([&](auto done) { b.unit->async_send(to, some_effort(), done); })) == good;
    }));
    CHECK(first == 0);
    CHECK(second > 0);
}

TEST_CASE("an operation that another thread starts while the node ends, or after that, ends") {
    const bool is_program_context = GENERATE(false, true);
    CAPTURE(is_program_context);
    two_nodes test;
    auto options = test.options("operator");
    options.log = [](std::string_view) {};
    auto mine = is_program_context ? std::make_unique<jauscat::node>(test.context, options)
                                   : std::make_unique<jauscat::node>(options);
    jauscat::component unit{*mine, {.id = 32}};
    unit.ready();
    std::promise<void> asked;
    int aborted_ones = 0;
    std::thread other{[&] {
        for (int i = 0;; ++i) {
            if (i == 1) asked.set_value();
            try {
                unit.async_ask(jaus::address{1, 33, 1, 2}, jaus::query_wrench_effort{.presence_vector = 1},
                               jauscat::ask_options{.timeout = 10ms}, boost::asio::use_future)
                    .get();
            } catch (const boost::system::system_error& e) {
                if (e.code() == jauscat::node_errc::not_running) return;
                aborted_ones += e.code() == boost::asio::error::operation_aborted;
            }
        }
    }};
    std::thread ending{[&] {
        asked.get_future().wait();
        boost::asio::post(mine->context(), [&] { mine->stop(); });
    }};
    CHECK(mine->run() == 0);
    other.join();
    ending.join();
    CHECK(aborted_ones <= 1);
    auto late = unit.async_send(jaus::address{1, 33, 1, 2}, some_effort(), boost::asio::use_future);
    CHECK_THROWS_WITH(late.get(), Catch::Contains(std::string{not_running}));
    mine.reset();
    late = unit.async_send(jaus::address{1, 33, 1, 2}, some_effort(), boost::asio::use_future);
    CHECK_THROWS_WITH(late.get(), Catch::Contains(std::string{not_running}));
}

TEST_CASE("a handler of what run has aborted may stop the node again, or its io_context") {
    const bool stops_context = GENERATE(false, true);
    two_nodes test;
    jauscat::node mine{test.options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    int aborted_ones = 0;
    for (int i = 0; i != 2; ++i)
        unit.async_send({1, 33, 1, 2}, some_effort(), [&](error_code error) {
            aborted_ones += error == boost::asio::error::operation_aborted;
            stops_context ? mine.context().stop() : mine.stop();
        });
    boost::asio::post(mine.context(), [&] { boost::asio::post(mine.context(), [&] { mine.stop(); }); });
    CHECK(mine.run() == 0);
    CHECK(aborted_ones == (stops_context ? 1 : 2));
}

TEST_CASE("run goes on where a handler has stopped the node, and a posted function starts it again") {
    two_nodes test;
    jauscat::node mine{test.options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    int starts = 0, readies = 0;
    unit.when_ready([&] { ++readies; });
    unit.ready();
    boost::asio::post(mine.context(), [&] {
        mine.stop();
        boost::asio::post(mine.context(), [&] {
            mine.start();
            ++starts;
            boost::asio::post(mine.context(), [&] { std::raise(SIGTERM); });
        });
    });
    CHECK(mine.run() == 0);
    CHECK(starts == 1);
    CHECK(readies == 2);
    CHECK(unit.state() == jaus::primary_status_code::initialize);
}

TEST_CASE("the handlers of what run has aborted are called before it returns") {
    two_nodes test;
    jauscat::node mine{test.options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    std::optional<error_code> sent, later;
    unit.async_send({1, 33, 1, 2}, some_effort(), [&](error_code error) {
        sent = error;
        unit.async_send({1, 33, 1, 2}, some_effort(), [&](error_code why) { later = why; });
    });
    boost::asio::post(mine.context(), [&] { boost::asio::post(mine.context(), [&] { mine.stop(); }); });
    CHECK(mine.run() == 0);
    CHECK(sent == error_code{boost::asio::error::operation_aborted});
    CHECK_FALSE(later);
    boost::asio::post(mine.context(), [&] { mine.stop(); });
    CHECK(mine.run() == 0); // again
    CHECK(later == error_code{jauscat::node_errc::not_running});
}

namespace {

/// A bus with one emulated slave, a robot and its bridge, each of which may end before the others.
struct robot_bench : two_nodes {
    jauscat::test::emulated_bus ring{{{.vendor = 7, .product = 1, .name = "arm"}}};
    std::optional<std::string> result{};
    std::unique_ptr<jauscat::bus> bus = std::make_unique<jauscat::bus>(
        context, ring.where(),
        jauscat::bus_options{.frame_timeout = jauscat::test::frame_timeout, .log = [](std::string_view) {}});
    std::unique_ptr<jauscat::node> robot = std::make_unique<jauscat::node>(context, options("robot"));
    std::unique_ptr<jauscat::bridge> bridge =
        std::make_unique<jauscat::bridge>(*robot, *bus, jauscat::translation::seed_table{});
    jauscat::slave arm = bus->slave({.position = 0});

    robot_bench() {
        ring.with(0, [](auto& each) { each.own.add(0x2001, 1, 2); });
    }
    std::string begin(auto start) {
        result.reset();
        start([this](error_code error, auto&&...) {
            const auto text = error.message(); // with the slave and the object in front
            result = text.starts_with("slave 0") ? text.substr(text.find(": ") + 2) : text;
        });
        return std::string{begun};
    }
    std::string outcome(std::string what) {
        if (what != begun) return what;
        REQUIRE(until([&] { return result.has_value(); }));
        return *result;
    }
    void run() {
        REQUIRE(outcome(begin([&](auto done) { bus->async_start(done); })) == good);
    }
};

} // namespace

TEST_CASE("each function of a bus and of its slaves has a defined result in each of its states") {
    using bench = robot_bench;
    constexpr std::string_view refused = "refused by the slave"; // which has no descriptions
    constexpr std::string_view not_started = "the slaves are not known: start the bus";
    const std::vector<row<bench>> table{
        // new, started, stopped, and of slaves: without their bus, moved from
        {"async_start",
         [](bench& b) { return b.begin([&](auto done) { b.bus->async_start(done); }); },
         {good, good, good}},
        {"slave",
         [](bench& b) { return done_by([&] { static_cast<void>(b.bus->slave({.position = 0})); }); },
         {"done", "done", "done"}},
        {"slaves", [](bench& b) { return std::to_string(b.bus->slaves().size()); }, {"0", "1", "0"}},
        {"cancel", [](bench& b) { return done_by([&] { b.bus->cancel(); }); }, {"done", "done", "done"}},
        {"stop", [](bench& b) { return done_by([&] { b.bus->stop(); }); }, {"done", "done", "done"}},
        {"callbacks",
         [](bench& b) {
             return done_by([&] {
                 b.bus->every_cycle([] {});
                 b.bus->when_lost([](auto&, auto) {});
                 b.bus->when_found([](auto&) {});
                 b.bus->when_changed([](auto&, auto&) {});
                 b.bus->when_emergency([](auto&, auto&) {});
             });
         },
         {"done", "done", "done"}},
        {"context",
         [](bench& b) { return std::string{&b.bus->context() == &b.context ? "that of the program" : "?"}; },
         {"that of the program", "that of the program", "that of the program"}},
        {"async_read",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_read<std::uint16_t>(0x2001, 1, done); }); },
         {not_started, good, not_started, aborted, good}},
        {"async_write",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_write(0x2001, 1, std::uint16_t{1}, done); }); },
         {not_started, good, not_started, aborted, good}},
        {"async_list_objects",
         [](bench& b) {
             return b.begin(
                 [&](auto done) { b.arm.async_list_objects(jauscat::ethercat::object_list_type::all, done); });
         },
         {not_started, refused, not_started, aborted, refused}},
        {"async_describe",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_describe(0x2001, done); }); },
         {not_started, refused, not_started, aborted, refused}},
        {"async_describe_entry",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_describe_entry(0x2001, 1, done); }); },
         {not_started, refused, not_started, aborted, refused}},
        {"async_state",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_state(done); }); },
         {not_started, good, not_started, aborted, good}},
        {"async_error_counters",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_error_counters(done); }); },
         {not_started, good, not_started, aborted, good}},
        {"async_change",
         [](bench& b) {
             return b.begin([&](auto done) { b.arm.async_change(jauscat::ethercat::al_state::init, done); });
         },
         {not_started, good, not_started, aborted, good}},
        {"async_operate",
         [](bench& b) { return b.begin([&](auto done) { b.arm.async_operate({}, done); }); },
         {not_started, good, not_started, aborted, good}},
        {"is_operating, inputs and outputs",
         [](bench& b) {
             return std::string{b.arm.is_operating() || !b.arm.inputs().empty() || !b.arm.outputs().empty() ? "?"
                                                                                                            : "none"};
         },
         {"none", "none", "none", "none", "none"}},
        {"info",
         [](bench& b) {
             error_code why;
             static_cast<void>(b.arm.info(why));
             CHECK(done_by([&] { static_cast<void>(b.arm.info()); }).starts_with(why ? why.message() : "done"));
             return why ? why.message() : "done";
         },
         {not_started, "done", not_started, not_started, "done"}},
        {"choice", [](bench& b) { return std::to_string(*b.arm.choice().position); }, {"0", "0", "0", "0", "0"}},
        {"its end", [](bench& b) { return done_by([&] { b.bus.reset(); }); }, {"done", "done", "done", "done"}},
    };
    for (const auto& each : table) {
        const auto in_state = [&](std::string_view state, std::size_t column, const auto& enter) {
            if (column >= each.results.size()) return;
            bench b;
            enter(b);
            check(each.function, state, b.outcome(each.call(b)), each.results[column]);
        };
        in_state("new", 0, [](bench&) {});
        in_state("started", 1, [](bench& b) { b.run(); });
        in_state("stopped", 2, [](bench& b) {
            b.run();
            b.bus->stop();
        });
        in_state("without its bus", 3, [](bench& b) {
            b.run();
            b.bus.reset();
        });
        in_state("moved from", 4, [&](bench& b) {
            b.run();
            // NOLINTNEXTLINE(performance-move-const-arg): it is a copy
            static_cast<void>(jauscat::slave{std::move(b.arm)});
        });
    }
}

TEST_CASE("each function of a bridge has a defined result in each of its states") {
    using bench = robot_bench;
    const auto yes_no = [](bool value) { return std::string{value ? "yes" : "no"}; };
    const std::vector<row<bench>> table{
        // new, its node runs, its node is stopped, has ended, its bus has ended; all on one bridge, in this order
        {"serve",
         [](bench& b) { return done_by([&] { b.bridge->serve({.component = 34}, b.arm); }); },
         {"done", "the component 2.1.34.1 is served after the start of its node", "done", "bridge: its node has ended",
          "the component 2.1.34.1 is served after the start of its node"}},
        {"callbacks",
         [](bench& b) {
             return done_by([&] {
                 b.bridge->when_up([](auto&) {});
                 b.bridge->when_lost([](auto&, auto) {});
                 b.bridge->when_changed([](auto&, auto) {});
                 b.bridge->when_at_rest([](auto&) {});
                 b.bridge->when_emergency([](auto&, auto&) {});
                 b.bridge->when_faulted([](auto&, auto&) {});
                 b.bridge->when_fault_ended([](auto&) {});
             });
         },
         {"done", "done", "done", "done", "done"}},
        // The slave has no objects for messages: it confirms no stop order.
        {"at_rest", [&](bench& b) { return yes_no(b.bridge->at_rest()); }, {"yes", "no", "no", "no", "no"}},
        {"is_up", [&](bench& b) { return yes_no(b.bridge->is_up()); }, {"no", "yes", "no", "no", "no"}},
        {"its end",
         [](bench& b) {
             return done_by([&] {
                 b.bridge.reset();
                 b.context.poll();
             });
         },
         {"done", "done", "done", "done", "done"}},
        {"a start of its node after its end",
         [](bench& b) {
             b.bridge.reset();
             if (b.robot == nullptr) return std::string{"none"};
             return done_by([&] { b.robot->start(); });
         },
         {"done", "the node is running", "done", "none", "the node is running"}},
    };
    const auto in_state = [&](std::string_view state, std::size_t column, const auto& enter) {
        bench b;
        b.bridge->serve({.component = 33}, b.arm);
        enter(b);
        for (const auto& each : table) check(each.function, state, each.call(b), each.results.at(column));
    };
    const auto run = [](bench& b) {
        b.robot->start();
        REQUIRE(b.until([&] { return b.bridge->is_up(); }));
    };
    in_state("new", 0, [](bench&) {});
    in_state("its node runs", 1, run);
    in_state("its node is stopped", 2, [&](bench& b) {
        run(b);
        b.robot->stop();
    });
    in_state("its node has ended", 3, [&](bench& b) {
        run(b);
        b.robot.reset();
    });
    in_state("its bus has ended", 4, [&](bench& b) {
        run(b);
        b.bus.reset();
    });
}
