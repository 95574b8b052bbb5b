// Messages with a schema of the application's own, in the range that RA 3.3 leaves to them.
#include "two_nodes.hpp"
#include <jauscat/schema/jaus/dynamic_configuration.hpp>
#include <jauscat/schema/jaus/types.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace gripper {

namespace jaus = jauscat::jaus;
/// Code D101h.
struct set_gripper {
    std::uint8_t finger{};
    std::optional<double> force{}; ///< percent

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<field<&T::finger, u8>, presence<u8, field<&T::force, scaled<u8, jaus::percent>>>>;
    };
};

/// Code D102h.
struct query_gripper {
    std::uint8_t presence_vector{};

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD102;
        using report = struct report_gripper;
        using T = query_gripper;
        using type = layout<field<&T::presence_vector, u8>>;
    };
};

/// Code D103h.
struct report_gripper {
    std::optional<double> force{};   ///< percent
    std::optional<double> opening{}; ///< percent
    friend constexpr bool operator==(const report_gripper&, const report_gripper&) = default;

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD103;
        using query = query_gripper;
        using T = report_gripper;
        using type = layout<
            presence<u8, field<&T::force, scaled<u8, jaus::percent>>, field<&T::opening, scaled<u8, jaus::percent>>>>;
    };
};

/// Code D104h: its answer is a Report Gripper, too.
struct calibrate_gripper {
    std::uint8_t finger{};

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD104;
        using report = struct report_gripper;
        using T = calibrate_gripper;
        using type = layout<field<&T::finger, u8>>;
    };
};

} // namespace gripper
// [schema]
// [schema end]

namespace {

using namespace app_test;
using gripper::report_gripper;
using gripper::set_gripper;

struct gripper_and_operator : operator_and_robot {
    report_gripper state{.force = 0, .opening = 100};
    std::vector<jaus::header> heads{};

    gripper_and_operator() {
        // [component]
        driver.on([this](const set_gripper& told, const jaus::header& head) {
            if (told.force) state.force = told.force;
            heads.push_back(head);
        });
        driver.on([](const gripper::calibrate_gripper& told) { return report_gripper{.force = told.finger}; });
        driver.reports([this] { return state; });
        // [component end]
        driver.ready();
        robots.start();
        mine.start();
    }
    error_code send(const auto& message) {
        std::optional<error_code> error;
        unit.async_send(arm, message, [&](error_code what) { error = what; });
        REQUIRE(until([&] { return error.has_value(); }));
        return *error;
    }
    std::optional<report_gripper> ask(const auto& query) {
        std::optional<error_code> error;
        report_gripper report{};
        unit.async_ask(arm, query, [&](error_code what, const report_gripper& is) {
            error = what;
            report = is;
        });
        REQUIRE(until([&] { return error.has_value(); }));
        CHECK(*error == error_code{});
        return *error ? std::nullopt : std::optional{report};
    }
};

TEST_CASE("a private command is sent once or until it is acknowledged, and says that it is experimental") {
    gripper_and_operator test;
    test.unit.ready();
    CHECK(test.send(set_gripper{.finger = 1, .force = 60}) == error_code{});
    CHECK(test.state.force == Approx(60));
    REQUIRE(test.unit.send(test.arm, set_gripper{.finger = 1, .force = 20}));
    REQUIRE(test.until([&] { return test.heads.size() == 2; }));
    CHECK(test.state.force == Approx(20));
    CHECK(std::ranges::all_of(test.heads, &jaus::header::experimental));
}

TEST_CASE("a private query is answered with the fields that it asks for") {
    gripper_and_operator test;
    test.unit.ready();
    const auto all = test.ask(gripper::query_gripper{0x03});
    REQUIRE(all);
    CHECK(all->force == Approx(0));
    CHECK(all->opening == Approx(100));
    const auto opening = test.ask(gripper::query_gripper{0x02});
    REQUIRE(opening);
    CHECK_FALSE(opening->force.has_value());
    const auto calibrated = test.ask(gripper::calibrate_gripper{5});
    REQUIRE(calibrated);
    CHECK(calibrated->force == Approx(5).margin(0.2));
}

TEST_CASE("a private command is refused by a component that is not Ready, and its private reports are not") {
    gripper_and_operator test; // the operator's component is in Initialize
    CHECK(test.send(jaus::standby{}) == error_code{});
    CHECK(test.send(set_gripper{.finger = 1, .force = 60}) == jauscat::node_errc::refused);
    CHECK(test.state.force == 0);
    const auto report = test.ask(gripper::query_gripper{0x02});
    REQUIRE(report);
    CHECK(report->opening == Approx(100));
}

TEST_CASE("private reports come in service connections and events") {
    gripper_and_operator test;
    int connected = 0, changed = 0;
    jauscat::subscription<report_gripper> periodic, changes;
    test.unit.async_connect<report_gripper>(test.arm, {.rate = 100}, [&](error_code error, auto is) {
        CHECK(error == error_code{});
        periodic = std::move(is);
        periodic.async_next([&](error_code what, const report_gripper& report) {
            CHECK(what == error_code{});
            CHECK(report.opening == Approx(100));
            ++connected;
        });
    });
    test.unit.async_event<report_gripper>(test.arm, {.event_type = jaus::event_type::every_change},
                                          [&](error_code error, auto is) {
                                              CHECK(error == error_code{});
                                              changes = std::move(is);
                                              changes.async_next([&](error_code what, const report_gripper& report) {
                                                  CHECK(what == error_code{});
                                                  CHECK(report.force == Approx(60));
                                                  ++changed;
                                              });
                                              REQUIRE(test.unit.send(test.arm, set_gripper{.force = 60}));
                                          });
    CHECK(test.until([&] { return connected == 1 && changed == 1; }));
}

TEST_CASE("private messages are among the services of a component") {
    gripper_and_operator test;
    std::vector<std::uint16_t> takes, sends;
    std::optional<error_code> error;
    test.unit.async_ask(test.arm, jaus::query_services{}, [&](error_code what, const auto& services) {
        error = what;
        for (const auto& service : services->service) {
            for (const auto& one : service.input_message) takes.push_back(one.command_code);
            for (const auto& one : service.output_message) sends.push_back(one.command_code);
        }
    });
    REQUIRE(test.until([&] { return error.has_value(); }));
    CHECK(std::ranges::count(takes, 0xD101) == 1);
    CHECK(std::ranges::count(takes, 0xD102) == 1);
    CHECK(std::ranges::count(takes, 0xD104) == 1);
    CHECK(std::ranges::count(sends, 0xD103) >= 1);
}

} // namespace
