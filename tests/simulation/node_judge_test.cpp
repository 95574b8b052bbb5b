// Each check of the nodes can fail: it is shown what must not be.
#include "simulation/idle_process.hpp"
#include "simulation/node_judge.hpp"
#include "support/catch.hpp"

using namespace simulation;
using namespace std::chrono_literals;

namespace {

/// Two nodes that are 0 and 1.
struct two_nodes {
    world w{1, 0};
    network n{w};
    idle_process first{w, n, "first"}, second{w, n, "second"};
    node_judge judge{w, n};

    two_nodes() {
        for (idle_process* one : {&first, &second}) {
            judge.add(*one);
            one->start();
        }
        judge.connect({0, 1});
        pass(10s);
    }
    void pass(simulation::time how_long) { w.run(w.now() + how_long); }
    [[nodiscard]] std::optional<contract> broken() const {
        return w.broken() ? std::optional{w.broken()->point} : std::nullopt;
    }
};

} // namespace

TEST_CASE("a node that is known although it is silent is detected, and one that is heard and not known") {
    two_nodes s;
    SECTION("known and heard") {
        s.judge.sees(0, 1, true);
        REQUIRE_FALSE(s.broken());
    }
    SECTION("not known, and heard") {
        s.judge.sees(0, 1, false);
        REQUIRE(s.broken() == contract::availability);
    }
    SECTION("dead") {
        s.second.die(60s);
        s.pass(3s);
        s.judge.sees(0, 1, true);
        REQUIRE_FALSE(s.broken());
        s.pass(1s);
        s.judge.sees(0, 1, false);
        REQUIRE_FALSE(s.broken());
        s.judge.sees(0, 1, true);
        REQUIRE(s.broken() == contract::s8);
    }
}

TEST_CASE("reports to a lost consumer are detected") {
    two_nodes s;
    s.judge.sends_report(0, 1);
    s.second.die(60s);
    s.pass(3s);
    s.judge.sends_report(0, 1);
    REQUIRE_FALSE(s.broken());
    s.pass(1s);
    s.judge.sends_report(0, 1);
    REQUIRE(s.broken() == contract::s8);
}

TEST_CASE("reports that do not come, old values and values of nobody are detected") {
    two_nodes s;
    s.judge.requests(0, 1, report_way::connection, 100ms);
    s.judge.changes(1, {1, 1});
    s.judge.changes(1, {1, 2});
    SECTION("the present value, and then nothing") {
        s.judge.gets_report(0, report_way::connection, {1, 2});
        s.judge.check_reports();
        REQUIRE_FALSE(s.broken());
        s.pass(1s);
        s.judge.check_reports();
        REQUIRE(s.broken() == contract::availability);
    }
    SECTION("a value that was replaced") {
        s.judge.gets_report(0, report_way::connection, {1, 1});
        REQUIRE_FALSE(s.broken());
        s.pass(100ms);
        s.judge.gets_report(0, report_way::connection, {1, 1});
        REQUIRE(s.broken() == contract::s4);
    }
    SECTION("a value of nobody") {
        s.judge.gets_report(0, report_way::connection, {1, 3});
        REQUIRE(s.broken() == contract::s7);
    }
}

TEST_CASE("a broadcast that does not arrive, arrives twice or at its sender is detected") {
    two_nodes s;
    s.judge.broadcasts(0, 7);
    SECTION("it arrives once") {
        s.judge.gets_broadcast(1, 0, 7);
        s.pass(1s);
        s.judge.check_broadcasts();
        REQUIRE_FALSE(s.broken());
    }
    SECTION("it does not arrive") {
        s.pass(1s);
        s.judge.check_broadcasts();
        REQUIRE(s.broken() == contract::s1);
    }
    SECTION("twice") {
        s.judge.gets_broadcast(1, 0, 7);
        REQUIRE_FALSE(s.broken());
        s.judge.gets_broadcast(1, 0, 7);
        REQUIRE(s.broken() == contract::s1);
    }
    SECTION("at its sender") {
        s.judge.gets_broadcast(0, 0, 7);
        REQUIRE(s.broken() == contract::s1);
    }
}

TEST_CASE("a reported time that is not the one that was set is detected") {
    two_nodes s;
    const auto set = simulation::time{100h};
    s.judge.sets_time(0, set);
    s.pass(2s);
    s.judge.reports_time(0, set + 2s);
    REQUIRE_FALSE(s.broken());
    s.judge.reports_time(0, set);
    REQUIRE(s.broken() == contract::s4);
}
