// Pending stop orders, and their order.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/bridge/stop_debt.hpp>

using namespace std::chrono_literals;
using jauscat::bridge::stop_debt;
using jauscat::bridge::stop_order;
using support::instant;

TEST_CASE("an emergency is sent first, and its confirmation also settles the stop by zeros") {
    stop_debt debt{20ms};
    CHECK(debt.settled());
    debt.owe_rest();
    debt.owe_emergency();
    CHECK(debt.next() == stop_order::emergency);
    debt.confirmed(stop_order::emergency);
    CHECK(debt.settled());
}

TEST_CASE("a refused stop order is retried after a growing interval, without limit") {
    stop_debt debt{20ms};
    debt.owe_emergency();
    for (unsigned i = 1; i != 1000; ++i) {
        CHECK(debt.refused(*debt.next(), false, instant{1s}));
        CHECK(debt.next_attempt() == instant{1s + 20ms * std::min(i, 10U)});
        CHECK(debt.refusals() == i);
        CHECK(debt.owes_stop());
    }
}

TEST_CASE("zeros refused three times alternate with an emergency") {
    stop_debt debt{20ms};
    debt.owe_rest();
    for (int i = 0; i != 3; ++i) {
        CHECK(debt.next() == stop_order::rest);
        debt.refused(stop_order::rest, false, instant{0s});
    }
    CHECK(debt.next() == stop_order::emergency);
    debt.confirmed(stop_order::emergency);
    CHECK(debt.settled());
}

TEST_CASE(
    "the end of an emergency is sent last, is dropped after three refusals, and is cancelled by a new emergency") {
    stop_debt debt{20ms};
    debt.owe_clear();
    debt.owe_rest();
    CHECK(debt.next() == stop_order::rest);
    debt.confirmed(stop_order::rest);
    CHECK(debt.next() == stop_order::clear_emergency);
    CHECK(debt.refused(stop_order::clear_emergency, false, instant{0s}));
    CHECK(debt.refused(stop_order::clear_emergency, false, instant{0s}));
    CHECK(!debt.refused(stop_order::clear_emergency, false, instant{0s}));
    CHECK(debt.settled());
    debt.owe_clear();
    debt.owe_emergency();
    CHECK(!debt.owes_clear());
}

TEST_CASE("an actuator that lacked emergencies gets the next one nevertheless") {
    stop_debt debt{20ms};
    debt.owe_emergency();
    debt.refused(stop_order::emergency, true, instant{0s});
    CHECK(debt.next() == stop_order::rest);
    debt.confirmed(stop_order::rest);
    CHECK(debt.settled());
    debt.owe_emergency();
    debt.refused(stop_order::emergency, false, instant{0s});
    debt.confirmed(stop_order::rest);
    CHECK(debt.next() == stop_order::emergency);
}
