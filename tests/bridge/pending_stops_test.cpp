// Pending stop orders, and their order.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/bridge/pending_stops.hpp>

using namespace std::chrono_literals;
using jauscat::bridging::pending_stops;
using jauscat::bridging::stop_order;
using support::instant;

TEST_CASE("an emergency is sent first, and its confirmation also settles the stop by zeros") {
    pending_stops stops{20ms};
    CHECK(stops.settled());
    stops.require_rest();
    stops.require_emergency();
    CHECK(stops.next() == stop_order::emergency);
    stops.confirmed(stop_order::emergency);
    CHECK(stops.settled());
}

TEST_CASE("a refused stop order is retried after a growing interval, without limit") {
    pending_stops stops{20ms};
    stops.require_emergency();
    for (unsigned i = 1; i != 1000; ++i) {
        CHECK(stops.refused(*stops.next(), false, instant{1s}));
        CHECK(stops.next_attempt() == instant{1s + 20ms * std::min(i, 10U)});
        CHECK(stops.refusals() == i);
        CHECK(stops.stop_is_pending());
    }
}

TEST_CASE("zeros refused three times alternate with an emergency") {
    pending_stops stops{20ms};
    stops.require_rest();
    for (int i = 0; i != 3; ++i) {
        CHECK(stops.next() == stop_order::rest);
        CHECK(stops.refused(stop_order::rest, false, instant{0s}));
    }
    CHECK(stops.next() == stop_order::emergency);
    stops.confirmed(stop_order::emergency);
    CHECK(stops.settled());
}

TEST_CASE(
    "the end of an emergency is sent last, is dropped after three refusals, and is cancelled by a new emergency") {
    pending_stops stops{20ms};
    stops.require_clear();
    stops.require_rest();
    CHECK(stops.next() == stop_order::rest);
    stops.confirmed(stop_order::rest);
    CHECK(stops.next() == stop_order::clear_emergency);
    CHECK(stops.refused(stop_order::clear_emergency, false, instant{0s}));
    CHECK(stops.refused(stop_order::clear_emergency, false, instant{0s}));
    CHECK(!stops.refused(stop_order::clear_emergency, false, instant{0s}));
    CHECK(stops.settled());
    stops.require_clear();
    stops.require_emergency();
    CHECK(!stops.clear_is_pending());
}

TEST_CASE("an actuator that lacked emergencies gets the next one nevertheless") {
    pending_stops stops{20ms};
    stops.require_emergency();
    CHECK(stops.refused(stop_order::emergency, true, instant{0s}));
    CHECK(stops.next() == stop_order::rest);
    stops.confirmed(stop_order::rest);
    CHECK(stops.settled());
    stops.require_emergency();
    CHECK(stops.refused(stop_order::emergency, false, instant{0s}));
    stops.confirmed(stop_order::rest);
    CHECK(stops.next() == stop_order::emergency);
}
