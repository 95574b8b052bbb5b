#include "two_nodes.hpp"
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/large_data/large_data_sender.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>
#include <jauscat/schema/jaus/environment_sensor.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_future.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace app_test;

#ifdef BOOST_ASIO_HAS_CO_AWAIT

struct driver_and_operator : operator_and_robot {
    jaus::report_wrench_effort effort{};
    int stopped{};
    bool done{};

    driver_and_operator() {
        serve();
        start();
    }
    struct not_started {};
    explicit driver_and_operator(not_started) { serve(); }

    void serve() {
        driver.on([this](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
        driver.reports([this] { return effort; });
        driver.when_stopped([this] { ++stopped; });
        driver.ready();
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

/// The next report. On a busy machine a provider is silent for three periods now and then.
template <class Report> boost::asio::awaitable<Report> next_report(jauscat::subscription<Report>& stream) {
    for (;;) {
        error_code why;
        const auto report = co_await stream.async_next(boost::asio::redirect_error(boost::asio::use_awaitable, why));
        if (!why) co_return report;
        if (why != jauscat::node_errc::silent) throw boost::system::system_error{why};
    }
}

/// Takes what a subscription has until it fails.
boost::asio::awaitable<error_code> next_error(auto& stream) {
    error_code why;
    do {
        co_await stream.async_next(boost::asio::redirect_error(boost::asio::use_awaitable, why));
    } while (!why);
    co_return why;
}

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
        CHECK(efforts.rate() == Approx(100).margin(0.02)); // as it was confirmed
        for (const double rate : {0.0, -1.0, 1092.1, std::numeric_limits<double>::quiet_NaN()}) {
            error_code wrong;
            co_await test.unit.async_connect<jaus::report_global_pose>(
                test.arm, {.rate = rate}, boost::asio::redirect_error(boost::asio::use_awaitable, wrong));
            CHECK(wrong == jauscat::node_errc::rate_out_of_range);
        }
        for (int i = 0; i != 3; ++i) {
            const auto next = co_await next_report(efforts);
            CHECK(next.propulsive_linear_effort_x == Approx(50).margin(0.01));
        }
        CHECK(test.stopped == 0);
    });
    CHECK(test.until([&] { return !test.driver.controller(); })); // the end of the scope has released it
    CHECK(test.stopped == 1);
}

TEST_CASE("core reports are subscribed to at any component, an operator's as well") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto states = co_await test.unit.async_connect<jaus::report_component_status>(test.arm, {.rate = 50});
        const auto state = co_await next_report(states);
        CHECK(state.primary_status_code == jaus::primary_status_code::ready);
        auto controllers = co_await test.unit.async_event<jaus::report_component_control>(
            test.arm, jaus::create_event{.event_type = jaus::event_type::every_change});
        auto control = co_await test.unit.async_control(test.arm, {.authority = 100});
        const auto by = co_await next_report(controllers);
        CHECK(by.component_id == test.unit.address().component);
        CHECK(by.authority_code == 100);
        // The robot's driver asks the operator, as some robots do before they obey it.
        auto others =
            co_await test.driver.async_connect<jaus::report_component_status>(test.unit.address(), {.rate = 50});
        const auto other = co_await next_report(others);
        CHECK(other.primary_status_code == jaus::primary_status_code::ready);
        const auto once = jaus::create_event{.event_type = jaus::event_type::one_time_on_demand};
        auto names = co_await test.driver.async_event<jaus::report_identification>(test.unit.address(), once);
        const auto name = co_await names.async_next();
        CHECK(name->identification == "operator");
        auto services = co_await test.driver.async_event<jaus::report_services>(test.unit.address(), once);
        const auto offered = co_await services.async_next();
        CHECK(offered->service.size() == 2);
        co_await test.driver.async_send(test.unit.address(), jaus::set_time{.time_stamp = jaus::time_stamp{}});
        auto times = co_await test.driver.async_connect<jaus::report_time>(test.unit.address(),
                                                                           {.rate = 50, .presence_vector = 1});
        const auto time = co_await next_report(times);
        CHECK(time.time_stamp);
        CHECK_FALSE(time.date_stamp);
    });
}

TEST_CASE("events of every change come once for each change") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto events = co_await test.unit.async_event<jaus::report_wrench_effort>(
            test.arm, jaus::create_event{.event_type = jaus::event_type::every_change});
        for (const double x : {10.0, 20.0, 30.0}) {
            co_await test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = x});
            const auto next = co_await next_report(events);
            CHECK(next.propulsive_linear_effort_x == Approx(x).margin(0.01));
        }
        test.effort.propulsive_linear_effort_x = 40;
        test.driver.changed();
        const auto next = co_await next_report(events);
        CHECK(next.propulsive_linear_effort_x == Approx(40).margin(0.01));
    });
}

TEST_CASE("control that another component takes over is lost, and a command by it is refused before it is sent") {
    driver_and_operator test{driver_and_operator::not_started{}};
    jauscat::component other{test.mine, {.id = 40, .name = "another operator"}};
    test.start();
    test.run([&]() -> boost::asio::awaitable<void> {
        auto control = co_await test.unit.async_control(test.arm, {.authority = 100});
        auto second = co_await other.async_control(test.arm, {.authority = 200});
        error_code why;
        co_await control.async_lost(boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::control_lost);
        CHECK(test.stopped == 1);
        CHECK_FALSE(control.is_held());
        co_await control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50},
                                    boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == jauscat::node_errc::control_lost);
        CHECK(test.effort == jaus::report_wrench_effort{});
        auto third = co_await test.unit.async_control(test.arm, {.authority = 150},
                                                      boost::asio::redirect_error(boost::asio::use_awaitable, why));
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
        static_cast<void>(co_await next_report(efforts));
        test.robots.stop();
        const auto why = co_await next_error(efforts);
        CHECK(why == jauscat::node_errc::silent);
        test.robots.start();
        static_cast<void>(co_await next_report(efforts));
    });
}

TEST_CASE("a subscription keeps the newest reports, and counts those that it drops") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto efforts =
            co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 200, .max_waiting = 2});
        CHECK(efforts.dropped() == 0);
        boost::asio::steady_timer timer{test.context};
        while (efforts.dropped() < 3) {
            timer.expires_after(std::chrono::milliseconds{5});
            co_await timer.async_wait(boost::asio::use_awaitable);
        }
        const auto dropped = efforts.dropped();
        static_cast<void>(co_await next_report(efforts));
        static_cast<void>(co_await next_report(efforts));
        static_cast<void>(co_await next_report(efforts));
        CHECK(efforts.dropped() == dropped);
    });
    CHECK(jauscat::subscription<jaus::report_wrench_effort>{}.dropped() == 0);
}

TEST_CASE("a subscription to an event says once that its provider is silent") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto efforts = co_await test.unit.async_event<jaus::report_wrench_effort>(
            test.arm, jaus::create_event{.event_type = jaus::event_type::periodic, .requested_periodic_rate = 50});
        static_cast<void>(co_await next_report(efforts));
        test.robots.stop();
        const auto why = co_await next_error(efforts);
        CHECK(why == jauscat::node_errc::silent);
    });
}

TEST_CASE("an event that comes once leaves its place to the next") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        const jaus::create_event once{.event_type = jaus::event_type::one_time_on_demand};
        auto first = co_await test.unit.async_event<jaus::report_wrench_effort>(test.arm, once);
        static_cast<void>(co_await next_report(first));
        error_code why;
        co_await first.async_next(boost::asio::redirect_error(boost::asio::use_awaitable, why));
        CHECK(why == boost::asio::error::operation_aborted);
        auto second = co_await test.unit.async_event<jaus::report_wrench_effort>(test.arm, once);
        first.end(); // not the second
        static_cast<void>(co_await next_report(second));
    });
}

TEST_CASE("a subscription of before a restart of the node leaves later ones alone") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        auto before = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 50});
        test.mine.stop();
        test.mine.start();
        test.unit.ready();
        const auto why = co_await next_error(before);
        CHECK(why == boost::asio::error::operation_aborted);
        auto after = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 50});
        before.end();
        for (int i = 0; i != 10; ++i) static_cast<void>(co_await next_report(after));
    });
}

TEST_CASE("a rate that no message can say is not encodable") {
    driver_and_operator test;
    constexpr double none = 0, huge = std::numeric_limits<double>::infinity();
    for (const double rate : {none, -1.0, 1e-300, 5000.0, huge, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(rate);
        error_code connected, requested;
        int ended = 0;
        test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = rate}, [&](error_code why, auto&&) {
            connected = why;
            ++ended;
        });
        test.unit.async_event<jaus::report_wrench_effort>(
            test.arm, {.event_type = jaus::event_type::periodic, .requested_periodic_rate = rate},
            [&](error_code why, auto&&) {
                requested = why;
                ++ended;
            });
        REQUIRE(test.until([&] { return ended == 2; }));
        CHECK(connected == jauscat::node_errc::rate_out_of_range);
        // The nearest step of a small rate is 0, which the provider refuses.
        const bool is_small = rate >= 0 && rate < 0.001;
        CHECK(requested == (is_small ? jauscat::node_errc::connection_refused : jauscat::node_errc::not_encodable));
    }
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
        static_cast<void>(co_await next_report(efforts));
    });
}

TEST_CASE("messages with lists and large messages are sent and received as typed values") {
    driver_and_operator test{driver_and_operator::not_started{}};
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
        CHECK(std::ranges::equal(back->image_data, pixels));
        const auto name = co_await test.unit.async_ask(
            test.arm, jaus::query_identification{jaus::query_type::component_identification});
        CHECK(name->identification == "Primitive Driver");
        const auto services = co_await test.unit.async_ask(test.arm, jaus::query_services{});
        REQUIRE(services->service.size() == 2);
        const auto& own = services->service[1];
        const auto has = [](const auto& list, std::uint16_t code) {
            return std::ranges::any_of(list, [&](const auto& one) { return one.command_code == code; });
        };
        CHECK(has(own.input_message, jaus::command_code_of<jaus::set_wrench_effort>));
        CHECK(has(own.input_message, jaus::command_code_of<jaus::query_image>));
        CHECK(has(own.output_message, jaus::command_code_of<jaus::report_image>));
        CHECK(has(own.input_message, jaus::command_code_of<jaus::create_service_connection>));
    });
}

TEST_CASE("components are found by their ID, name and messages, on all nodes that are heard") {
    driver_and_operator test{driver_and_operator::not_started{}};
    jauscat::component camera{test.robots, {.id = 37, .name = "front camera"}};
    std::vector<jaus::address> appeared, disappeared;
    test.mine.when_appeared([&](const jaus::address& who) { appeared.push_back(who); });
    test.mine.when_disappeared([&](const jaus::address& who) { disappeared.push_back(who); });
    test.start();
    const auto has = [](const auto& list, const jaus::address& who) {
        return std::ranges::find(list, who) != list.end();
    };
    REQUIRE(test.until([&] { return has(appeared, test.robots.manager()); }));
    test.run([&]() -> boost::asio::awaitable<void> {
        auto found = co_await test.unit.async_find({.component = 33, .count = 1});
        CHECK(found.size() == 1);
        CHECK((!found.empty() && found[0].address == test.arm && found[0].identification == "Primitive Driver"));
        found = co_await test.unit.async_find({.name = "camera", .count = 1});
        CHECK((found.size() == 1 && found[0].address == camera.address()));
        found =
            co_await test.unit.async_find({.command_code = jaus::command_code_of<jaus::set_wrench_effort>, .count = 1});
        CHECK((found.size() == 1 && found[0].address == test.arm));
        found = co_await test.unit.async_find({.component = 99, .timeout = std::chrono::milliseconds{50}});
        CHECK(found.empty());
    });
    test.robots.stop();
    CHECK(test.until([&] { return has(disappeared, test.robots.manager()); }));
}

TEST_CASE("a search finds who appears while it goes on, and ends at its count") {
    two_nodes test;
    jauscat::node mine{test.context, test.options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    mine.start();
    unit.ready();
    std::optional<std::vector<jauscat::found_component>> found;
    unit.async_find({.component = 33, .timeout = std::chrono::hours{1}, .count = 1},
                    [&](error_code error, std::vector<jauscat::found_component> all) {
                        CHECK(!error);
                        found = std::move(all);
                    });
    bool is_asked = false;
    boost::asio::post(test.context, [&] { is_asked = true; });
    REQUIRE(test.until([&] { return is_asked; })); // nobody is there
    CHECK(!found);
    jauscat::node robot{test.context, test.options("robot")};
    jauscat::component driver{robot, {.id = 33, .name = "Primitive Driver"}};
    robot.start();
    driver.ready();
    REQUIRE(test.until([&] { return found.has_value(); }));
    REQUIRE(found->size() == 1);
    CHECK(found->front().address == driver.address());
    CHECK(found->front().identification == "Primitive Driver");
}

/// A peer that is no node: each message that comes goes to `on_message`.
class scripted_peer {
  public:
    scripted_peer(boost::asio::io_context& context, const std::array<std::uint16_t, 2>& ports)
        : to_{boost::asio::ip::address_v4::loopback(), ports[0]},
          socket_{context, {boost::asio::ip::address_v4::loopback(), ports[1]}} {
        receive();
    }
    scripted_peer(const scripted_peer&) = delete;
    scripted_peer& operator=(const scripted_peer&) = delete;
    virtual ~scripted_peer() = default;

  protected:
    void put(std::span<const std::byte> message) {
        socket_.send_to(boost::asio::buffer(message.data(), message.size()), to_);
    }
    /// Of a small body.
    void put(const jaus::header& head, const auto& body) {
        std::array<std::byte, 200> memory{};
        put(*jaus::make_message(head, body, memory));
    }

  private:
    virtual void on_message(const jaus::header& head) = 0;
    void receive() {
        socket_.async_receive(boost::asio::buffer(in_), [this](error_code error, std::size_t size) {
            if (error) return;
            on_message(jaus::split(std::span{in_}.first(size)).header);
            receive();
        });
    }

    boost::asio::ip::udp::endpoint to_;
    boost::asio::ip::udp::socket socket_;
    std::array<std::byte, 5000> in_{};
};

/// The component 2.1.35.1 of a node whose node manager says nothing. It says what it is, and not what it can do.
class peer_without_manager final : public scripted_peer {
  public:
    peer_without_manager(boost::asio::io_context& context, const std::array<std::uint16_t, 2>& ports)
        : scripted_peer{context, ports} {
        put({.destination = {255, 255, 255, 255}, .source = self}, jaus::report_heartbeat_pulse{});
    }
    static constexpr jaus::address self{1, 35, 1, 2};

  private:
    void on_message(const jaus::header& head) override {
        if (head.command_code == jaus::command_code_of<jaus::query_identification> && head.destination == self)
            put({.destination = head.source, .source = self, .sequence_number = head.sequence_number},
                jaus::report_identification{jaus::query_type::component_identification, 0, 60001, "communicator"});
    }
};

TEST_CASE("a component is found that is heard itself, without a node manager") {
    two_nodes test;
    jauscat::node mine{test.context, test.options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    mine.start();
    unit.ready();
    const peer_without_manager peer{test.context, test.ports};
    std::optional<std::vector<jauscat::found_component>> found;
    unit.async_find({.component = 35, .timeout = std::chrono::hours{1}, .count = 1},
                    [&](error_code error, std::vector<jauscat::found_component> all) {
                        CHECK(!error);
                        found = std::move(all);
                    });
    REQUIRE(test.until([&] { return found.has_value(); }));
    REQUIRE(found->size() == 1);
    CHECK(found->front().address == peer_without_manager::self);
    CHECK(found->front().identification == "communicator");
}

/// Each operation of a component is under way.
struct pending_operations : driver_and_operator {
    std::vector<error_code> errors{};
    std::optional<jauscat::component> other{std::in_place, mine, jauscat::component_options{.id = 41}};
    jauscat::control control{};
    jauscat::subscription<jaus::report_wrench_effort> efforts{};
    std::optional<error_code> found{}; // the search may end by itself
    static constexpr std::size_t count = 7;

    pending_operations() : driver_and_operator{not_started{}} {
        start();
        run([&]() -> boost::asio::awaitable<void> {
            control = co_await other->async_control(arm, {});
            efforts = co_await other->async_connect<jaus::report_wrench_effort>(arm, {.rate = 1});
            co_await next_report(efforts);
        });
        const auto note = [&](error_code error, auto&&...) { errors.push_back(error); };
        auto nobody = arm;
        nobody.component = 99;
        other->async_send(nobody, jaus::standby{}, note);
        other->async_ask(nobody, jaus::query_global_pose{}, note);
        other->async_control(nobody, {}, note);
        other->async_connect<jaus::report_global_pose>(nobody, {}, note);
        other->async_event<jaus::report_global_pose>(nobody, {.event_type = jaus::event_type::every_change}, note);
        other->async_find({.timeout = std::chrono::hours{1}}, [&](error_code error, auto&&) { found = error; });
        efforts.async_next(note);
        control.async_lost(note);
        bool begun = false;
        boost::asio::post(context, [&] { begun = true; }); // behind them
        REQUIRE(until([&] { return begun; }));
        CHECK(errors.empty());
    }
    bool are_aborted() {
        return until([&] { return errors.size() == count && found.has_value(); }) &&
               std::ranges::all_of(errors, [](error_code e) { return e == boost::asio::error::operation_aborted; });
    }
};

/// The node manager 2.1.1.1 of a program that reports 254 nodes of 254 components, and answers no other question.
class boastful_peer final : public scripted_peer {
  public:
    boastful_peer(boost::asio::io_context& context, const std::array<std::uint16_t, 2>& ports)
        : scripted_peer{context, ports}, timer_{context} {
        put({.destination = {1, 1, 1, 1}, .source = self}, jaus::report_heartbeat_pulse{});
    }
    unsigned asked{}; ///< questions of components

  private:
    static constexpr jaus::address self{1, 1, 1, 2};
    void on_message(const jaus::header& head) override {
        if (head.destination != self) ++asked;
        if (head.command_code != jaus::command_code_of<jaus::query_configuration> || head.source.component != 32)
            return;
        std::vector<jaus::configured_component> components;
        for (std::uint8_t i = 1; i != 255; ++i) components.push_back({i, 1});
        std::vector<jaus::configured_node> nodes;
        for (std::uint8_t i = 1; i != 255; ++i) nodes.push_back({.node_id = i, .component = components});
        const auto written = jauscat::wire::encode(jaus::report_configuration{.node = nodes}, body_);
        REQUIRE(written);
        report_.emplace(jaus::header{.command_code = jaus::command_code_of<jaus::report_configuration>,
                                     .destination = head.source,
                                     .source = self},
                        *written, packet_);
        next();
    }
    void next() { // the socket of the node has no room for all
        if (!report_->next([&](std::span<const std::byte> message) { put(message); })) return;
        timer_.expires_after(std::chrono::milliseconds{1});
        timer_.async_wait([this](error_code error) {
            if (!error) next();
        });
    }

    boost::asio::steady_timer timer_;
    std::array<std::byte, jaus::header_size + jaus::max_body_size> packet_{};
    std::vector<std::byte> body_ = std::vector<std::byte>(200'000);
    std::optional<jaus::large_data_sender> report_{};
};

TEST_CASE("a peer that reports very many components is asked for a few at a time") {
    two_nodes test;
    jauscat::node mine{test.context, test.options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    mine.start();
    unit.ready();
    boastful_peer peer{test.context, test.ports};
    bool is_there = false;
    mine.when_appeared([&](const jaus::address& who) { is_there = is_there || who.subsystem == 2; });
    REQUIRE(test.until([&] { return is_there; }));
    std::optional<std::size_t> found;
    unit.async_find({}, [&](error_code error, const std::vector<jauscat::found_component>& all) {
        CHECK(!error);
        found = all.size();
    });
    REQUIRE(test.until([&] { return found.has_value(); }));
    CHECK(*found == 1); // the node manager of this one
    CHECK(test.has_logged("2.1.1.1 reports 64516 components: only 1024 are asked"));
    CHECK(peer.asked < 500); // two questions of 16 components, with their repeats; 129,032 in all
}

TEST_CASE("all operations end with operation_aborted") {
    pending_operations test;
    SECTION("when their component goes away") { test.other.reset(); }
    SECTION("when their node stops") { test.mine.stop(); }
    SECTION("by cancel, which leaves control and subscriptions as they are") {
        test.other->cancel();
        CHECK(test.are_aborted());
        CHECK(test.control.is_held());
        test.done = false;
        test.run([&]() -> boost::asio::awaitable<void> {
            co_await test.control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50});
            co_await next_report(test.efforts);
        });
        CHECK(test.errors.size() == test.count);
        return;
    }
    CHECK(test.are_aborted());
    CHECK(test.found == error_code{boost::asio::error::operation_aborted});
    CHECK_FALSE(test.control.is_held());
}

TEST_CASE("handles say that they have ended") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        error_code why;
        auto into = boost::asio::redirect_error(boost::asio::use_awaitable, why);
        auto control = co_await test.unit.async_control(test.arm, {});
        auto efforts = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 100});
        CHECK(efforts);
        efforts.end();
        CHECK_FALSE(efforts);
        co_await efforts.async_next(into);
        CHECK(why == boost::asio::error::operation_aborted);
        auto moved = std::move(efforts);
        CHECK_FALSE(moved);
        control.release();
        CHECK_FALSE(control.is_held());
        CHECK(control.of() == test.arm);
        co_await control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 5}, into);
        CHECK(why == jauscat::node_errc::control_lost);
        co_await control.async_lost(into);
        CHECK(why == jauscat::node_errc::control_lost);
        co_await control.async_release(into);
        CHECK(why == jauscat::node_errc::control_lost);
    });
}

TEST_CASE("the outcome of a large message that was cancelled is not that of the next one") {
    operator_and_robot test;
    int taken = 0;
    test.driver.on([&](const jaus::report_image& image) {
        ++taken;
        return image.image_data.size() == 100'000 ? jaus::message_outcome::handled : jaus::message_outcome::refused;
    });
    test.driver.ready();
    test.start();
    const std::vector<std::byte> small(50'000), large(100'000);
    std::vector<error_code> errors;
    const auto note = [&](error_code error) { errors.push_back(error); };
    test.unit.async_send(test.arm, jaus::report_image{.image_data = small}, note);
    bool begun = false;
    boost::asio::post(test.context, [&] { begun = true; });
    REQUIRE(test.until([&] { return begun; }));
    test.unit.cancel();
    REQUIRE(test.until([&] { return errors.size() == 1; }));
    CHECK(errors[0] == boost::asio::error::operation_aborted);
    test.unit.async_send(test.arm, jaus::report_image{.image_data = large}, note);
    REQUIRE(test.until([&] { return errors.size() == 2; }));
    CHECK(errors[1] == error_code{});
}

TEST_CASE("operations that have not begun end with operation_aborted when their component goes away") {
    operator_and_robot test;
    test.driver.ready();
    std::vector<error_code> errors;
    const auto note = [&](error_code error, auto&&...) { errors.push_back(error); };
    std::optional<jauscat::component> unit{std::in_place, test.mine, jauscat::component_options{.id = 41}};
    test.start();
    auto nobody = test.arm;
    nobody.component = 99;
    unit->async_send(nobody, jaus::standby{}, note);
    unit->async_find({}, note);
    unit.reset();
    REQUIRE(test.until([&] { return errors.size() == 2; }));
    CHECK(std::ranges::all_of(errors, [](error_code e) { return e == boost::asio::error::operation_aborted; }));
}

TEST_CASE("handles that outlive component, node and context do no harm") {
    jauscat::control control;
    jauscat::subscription<jaus::report_wrench_effort> stream;
    auto context = std::make_unique<boost::asio::io_context>();
    {
        driver_and_operator test;
        test.run([&]() -> boost::asio::awaitable<void> {
            control = co_await test.unit.async_control(test.arm, {});
            stream = co_await test.unit.async_connect<jaus::report_wrench_effort>(test.arm, {.rate = 100});
        });
        test.robots.stop();
        test.mine.stop();
        CHECK_FALSE(control.is_held());
    }
}

TEST_CASE("a component and handles that outlive their node, and its io_context, do no harm") {
    two_nodes test;
    jauscat::node robots{test.context, test.options("robot")};
    jauscat::component driver{robots, {.id = 33}};
    driver.reports([] { return jaus::report_wrench_effort{}; });
    robots.start();
    driver.ready();
    auto mine = std::make_unique<jauscat::node>(test.options("operator")); // with an io_context of its own
    auto unit = std::make_unique<jauscat::component>(*mine, jauscat::component_options{.id = 32});
    mine->start();
    unit->ready();
    jauscat::control control;
    jauscat::subscription<jaus::report_wrench_effort> stream;
    bool has_stream = false;
    unit->async_control(driver.address(), {}, [&](error_code, jauscat::control made) { control = std::move(made); });
    unit->async_connect<jaus::report_wrench_effort>(driver.address(), {.rate = 100}, [&](error_code error, auto made) {
        has_stream = !error;
        stream = std::move(made);
    });
    REQUIRE(test.until([&] {
        mine->context().poll();
        return control.is_held() && has_stream;
    }));
    mine.reset();
    CHECK_FALSE(control.is_held());
    CHECK(unit->state() == jaus::primary_status_code::initialize);
    unit->ready();
    unit->changed();
    unit->reject_control();
    unit->fail("nobody hears it");
    unit->cancel();
    CHECK(unit->send(driver.address(), jaus::standby{}).error().code == jauscat::net::errc::not_running);
    unit->async_send(driver.address(), jaus::standby{}, [](error_code) {});
    stream.async_next([](error_code, const jaus::report_wrench_effort&) {});
    stream.end();
    control.release();
    if (GENERATE(true, false)) unit.reset();
}

TEST_CASE("operations that never begin are destroyed with their context") {
    auto alive = std::make_shared<int>();
    {
        operator_and_robot test;
        test.unit.async_send(test.arm, jaus::standby{}, [alive](error_code) {});
        test.unit.async_ask(test.arm, jaus::query_component_status{}, [alive](error_code, auto&&) {});
    }
    CHECK(alive.use_count() == 1);
}

TEST_CASE(
    "commands that are awaited one after the other are all acknowledged, as many as the receiver has places for") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        for (int i = 0; i != 1500; ++i)
            co_await test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = i % 100});
    });
    CHECK(test.effort.propulsive_linear_effort_x.has_value());
}

TEST_CASE("a receiver says which option its memory of commands has") {
    two_nodes test;
    jauscat::node mine{test.context, test.options("operator")}, robots{test.context, test.options("robot")};
    jauscat::component unit{mine, {.id = 32}}, driver{robots, {.id = 33, .remembered = 8}};
    driver.on([](const jaus::set_wrench_effort&) {});
    robots.start();
    mine.start();
    driver.ready();
    int acknowledged = 0;
    for (int i = 0; i != 5; ++i)
        unit.async_send(driver.address(), jaus::set_wrench_effort{.propulsive_linear_effort_x = i},
                        [&](error_code error) { acknowledged += !error; });
    REQUIRE(test.until(
        [&] { return test.has_logged("no place left to remember what was acknowledged (option remembered)"); }));
    CHECK(acknowledged <= 4);
}

/// The component 2.1.33.1, which answers questions as the test says.
class answering_peer final : public scripted_peer {
  public:
    using scripted_peer::scripted_peer;
    static constexpr jaus::address self{1, 33, 1, 2};
    std::function<void(const jaus::header& question)> on_question{};

    void answer(jaus::header question, std::uint16_t number, double value) {
        question.sequence_number = number;
        put(jaus::answer_to(question, self), jaus::report_wrench_effort{.propulsive_linear_effort_x = value});
    }

  private:
    void on_message(const jaus::header& head) override {
        if (head.command_code != jaus::command_code_of<jaus::query_wrench_effort>) return;
        if (head.ack_nak == jaus::ack_nak::request)
            static_cast<void>(jaus::acknowledge(head, self, jaus::ack_nak::ack,
                                                [this](std::span<const std::byte> message) { put(message); }));
        if (std::exchange(last_, head.sequence_number) != head.sequence_number) on_question(head);
    }

    std::optional<std::uint16_t> last_{};
};

/// Questions one after the other, and what came of them: a value, or -1.
struct asker : two_nodes {
    jauscat::node mine{context, options("operator")};
    jauscat::component unit{mine, {.id = 32}};
    answering_peer peer{context, ports};
    std::vector<double> values{};
    bool is_acknowledged{};

    explicit asker(bool acknowledged) : is_acknowledged{acknowledged} {
        mine.start();
        unit.ready();
    }
    double ask() {
        const auto before = values.size();
        unit.async_ask(answering_peer::self, jaus::query_wrench_effort{.presence_vector = 1},
                       {.timeout = std::chrono::milliseconds{100}, .acknowledged = is_acknowledged},
                       [&](error_code error, const jaus::report_wrench_effort& report) {
                           values.push_back(error ? -1 : report.propulsive_linear_effort_x.value_or(-1));
                       });
        REQUIRE(until([&] { return values.size() > before; }));
        return values.back();
    }
};

TEST_CASE("a late answer is not that of the next question") {
    asker test{GENERATE(false, true)};
    std::vector<jaus::header> asked;
    test.peer.on_question = [&](const jaus::header& question) {
        asked.push_back(question);
        if (asked.size() == 1) return; // its answer is late
        test.peer.answer(question, asked.front().sequence_number, 10);
        test.peer.answer(question, question.sequence_number, 20);
        test.peer.answer(question, question.sequence_number, 20); // a copy
    };
    CHECK(test.ask() == -1);
    for (int i = 0; i != 5; ++i) CHECK(test.ask() == Approx(20).margin(0.1));
}

TEST_CASE("answers of a component that numbers them otherwise belong to the first question") {
    asker test{GENERATE(false, true)};
    const bool restarts = GENERATE(false, true); // as a program that has numbered them right
    std::uint16_t own = GENERATE(std::uint16_t{0}, std::uint16_t{1000});
    int asked = 0;
    test.peer.on_question = [&](const jaus::header& question) {
        if (restarts && ++asked < 3) return test.peer.answer(question, question.sequence_number, 30);
        test.peer.answer(question, own, 30);
        if (own != 0) ++own;
    };
    int without = 0;
    for (int i = 0; i != 10; ++i) without += test.ask() < 0;
    CHECK(without <= 3);
    CHECK(test.values.back() == Approx(30).margin(0.1));
}

TEST_CASE("large commands of one code keep their order, and each has its own outcome") {
    operator_and_robot test;
    std::string arrived;
    const auto second = GENERATE('A', 'C'); // 'A': the receiver would take it as a repeat of the first for 2 s
    test.driver.on([&](const jaus::report_image& image) {
        arrived += static_cast<char>(image.image_data[0]);
        return arrived.back() == 'B' ? jaus::message_outcome::refused : jaus::message_outcome::handled;
    });
    test.driver.ready();
    test.start();
    std::string outcomes;
    const auto send = [&](char which, std::size_t size) {
        const std::vector<std::byte> pixels(size, static_cast<std::byte>(which));
        test.unit.async_send(test.arm, jaus::report_image{.image_data = pixels}, [&outcomes, which](error_code error) {
            outcomes += which;
            outcomes += error == jauscat::node_errc::refused ? '-' : error ? '?' : '+';
        });
    };
    send('A', 9000);
    send(second, 9000);
    send('B', 9000);
    send('D', 100);
    REQUIRE(test.until([&] { return outcomes.size() == 8; }));
    std::erase(arrived, 'D'); // small ones do not wait for large ones
    CHECK(arrived == std::string{'A', second, 'B'});
    CHECK(outcomes.find("D+") != std::string::npos);
    outcomes.erase(outcomes.find("D+"), 2);
    CHECK(outcomes == std::string{'A', '+', second, '+', 'B', '-'});
}

TEST_CASE("a large message to a system that nobody knows is unroutable at once") {
    operator_and_robot test;
    test.driver.ready();
    test.start();
    const std::vector<std::byte> pixels(9000);
    auto nobody = test.arm;
    nobody.subsystem = 77;
    std::optional<error_code> found;
    std::size_t lines = 0;
    test.unit.async_send(nobody, jaus::report_image{.image_data = pixels}, [&](error_code error) {
        found = error;
        lines = test.log.size();
    });
    REQUIRE(test.until([&] { return found.has_value(); }));
    CHECK(*found == jauscat::node_errc::unroutable);
    CHECK(lines == 1);
    CHECK(test.has_logged("Report Image to 77.1.33.1 is not sent"));
}

TEST_CASE("each error of an operation is told apart") {
    driver_and_operator test;
    test.run([&]() -> boost::asio::awaitable<void> {
        using jauscat::node_errc;
        error_code why;
        auto into = boost::asio::redirect_error(boost::asio::use_awaitable, why);
        const jaus::set_wrench_effort command{.propulsive_linear_effort_x = 5};
        co_await test.unit.async_send(test.arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 1000}, into);
        CHECK(why == node_errc::not_encodable);
        CHECK(why.message().starts_with("Set Wrench Effort: propulsive_linear_effort_x: out of range: "));
        auto all = test.arm;
        all.instance = 255;
        co_await test.unit.async_send(all, command, into);
        CHECK(why == node_errc::not_one_address);
        auto elsewhere = test.arm;
        elsewhere.subsystem = 77;
        co_await test.unit.async_send(elsewhere, command, into);
        CHECK(why == node_errc::unroutable);
        CHECK(test.has_logged("Set Wrench Effort to 77.1.33.1 is not sent"));
        auto nobody = test.arm;
        nobody.component = 99;
        co_await test.unit.async_send(nobody, command, into);
        CHECK(why == node_errc::no_answer);
        co_await test.unit.async_ask(nobody, jaus::query_component_status{}, {.timeout = std::chrono::milliseconds{20}},
                                     into);
        CHECK(why == node_errc::no_answer);
        co_await test.unit.async_ask(test.arm, jaus::query_global_pose{0xFFFF}, into);
        CHECK(why == node_errc::refused);
        co_await test.unit.async_ask(test.arm, jaus::query_global_pose{0xFFFF},
                                     {.timeout = std::chrono::milliseconds{20}, .acknowledged = false}, into);
        CHECK(why == node_errc::no_answer);
        co_await test.unit.async_ask(test.arm, jaus::query_component_status{}, {.acknowledged = false}, into);
        CHECK(why == error_code{});
        test.mine.stop();
        co_await test.unit.async_send(test.arm, command, into);
        CHECK(why == node_errc::not_running);
        CHECK(why.message() == "the node is not running");
        CHECK(std::string{why.category().name()} == "jauscat.node");
    });
}

#endif

TEST_CASE("a thread starts operations, and waits for each by a future") {
    operator_and_robot test;
    int commands = 0;
    test.driver.on([&](const jaus::set_wrench_effort&) { ++commands; });
    test.driver.ready();
    test.start();
    std::atomic<bool> is_over{};
    std::exception_ptr problem;
    jaus::report_component_status status{};
    std::jthread other{[&] {
        try {
            using boost::asio::use_future;
            status = test.unit.async_ask(test.arm, jaus::query_component_status{}, use_future).get();
            auto control = test.unit.async_control(test.arm, {}, use_future).get();
            control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 5}, use_future).get();
        } catch (...) {
            problem = std::current_exception();
        }
        is_over = true;
    }};
    REQUIRE(test.until([&] { return is_over.load(); }));
    CHECK(problem == nullptr);
    CHECK(status.primary_status_code == jaus::primary_status_code::ready);
    CHECK(commands == 1);
    CHECK(test.until([&] { return !test.driver.controller(); })); // released by the thread
}

TEST_CASE("futures have the results of operations") {
    operator_and_robot test;
    test.driver.ready();
    test.start();
    auto status = test.unit.async_ask(test.arm, jaus::query_component_status{}, boost::asio::use_future);
    auto sent = test.unit.async_send(test.arm, jaus::standby{}, boost::asio::use_future);
    REQUIRE(test.until([&] { return sent.wait_for(std::chrono::seconds{0}) == std::future_status::ready; }));
    CHECK(status.get().primary_status_code == jaus::primary_status_code::ready);
    CHECK_NOTHROW(sent.get());
}

} // namespace
