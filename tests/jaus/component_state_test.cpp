// The states of a component: every event in every state, by messages and by the application; the end of an emergency.
#include "jaus/messages.hpp"
#include "support/catch.hpp"
#include <jauscat/jaus/component/component_state.hpp>

namespace {

using namespace jauscat::test;
namespace jaus = jauscat::jaus;
using enum jaus::primary_status_code;
using jaus::message_outcome;
using jaus::state_event;
using state = jaus::primary_status_code;
using maybe = std::optional<state>;

constexpr jaus::address self{1, 49, 2, 3}, ocu{1, 32, 1, 1}, other{1, 33, 1, 1}, third{1, 40, 5, 1};
constexpr maybe no{};

struct row {
    state from;
    std::array<maybe, 8> to; // in the order of state_event
};
// The table of state_after, written again. Emergency is entered from Ready here.
constexpr auto emergency_state = state::emergency, shutdown_state = state::shutdown, standby_state = state::standby;
constexpr std::array<row, 6> table{{
    {initialize, {ready, failure, shutdown_state, no, no, initialize, emergency_state, initialize}},
    {ready, {ready, failure, shutdown_state, standby_state, ready, initialize, emergency_state, ready}},
    {standby_state, {no, failure, shutdown_state, standby_state, ready, initialize, emergency_state, standby_state}},
    {shutdown_state, {no, no, shutdown_state, no, no, no, shutdown_state, shutdown_state}},
    {failure, {no, failure, shutdown_state, no, no, initialize, emergency_state, failure}},
    {emergency_state, {emergency_state, emergency_state, shutdown_state, no, no, no, emergency_state, standby_state}},
}};

struct arm {
    jaus::component_state<2> core;
    sent_messages sent{};

    explicit arm(state in = ready, jaus::after_emergency after = {}) : core{self, after} {
        if (in != initialize && in != failure) core.change(state_event::initialized);
        if (in == failure) core.change(state_event::failed);
        if (in == standby_state) core.change(state_event::standby);
        if (in == shutdown_state) core.change(state_event::shutdown);
        if (in == emergency_state) hear(jaus::set_emergency{{jaus::set_emergency_code::transition_to_emergency}});
        REQUIRE(core.state() == in);
    }
    template <class T> message_outcome hear(const T& body, jaus::address from = ocu) {
        const auto bytes = message({.destination = self, .source = from}, body);
        const auto m = jaus::split(bytes);
        return core.on_message(m.header, m.body, {}, sent.sink());
    }
    message_outcome set(jaus::address from = ocu) {
        return hear(jaus::set_emergency{{jaus::set_emergency_code::transition_to_emergency}}, from);
    }
    message_outcome clear(jaus::address from = ocu) {
        return hear(jaus::clear_emergency{{jaus::clear_emergency_code::clear_emergency}}, from);
    }
    message_outcome command(state_event event) {
        switch (event) {
        case state_event::shutdown: return hear(jaus::shutdown{});
        case state_event::standby: return hear(jaus::standby{});
        case state_event::resume: return hear(jaus::resume{});
        case state_event::reset: return hear(jaus::reset{});
        case state_event::emergency: return set();
        case state_event::emergency_cleared: return clear();
        default: return message_outcome::unhandled;
        }
    }
};

} // namespace

TEST_CASE("every application event has the effect of the table in every state") {
    for (const row& r : table)
        for (std::size_t i = 0; i != r.to.size(); ++i) {
            CAPTURE(static_cast<int>(r.from), i);
            arm a{r.from};
            // The OCU holds the emergency: the application has no part in it that it could take away.
            const auto event = static_cast<state_event>(i);
            const bool not_its_own = r.from == emergency_state && event == state_event::emergency_cleared;
            const auto expected = not_its_own ? no : r.to[i];
            CHECK(a.core.change(event) == expected.has_value());
            CHECK(a.core.state() == expected.value_or(r.from));
            CHECK(a.sent.empty());
        }
}

TEST_CASE("every command has the effect of the table in every state") {
    for (const row& r : table)
        for (std::size_t i = 2; i != r.to.size(); ++i) {
            CAPTURE(static_cast<int>(r.from), i);
            arm a{r.from};
            CHECK(a.command(static_cast<state_event>(i)) ==
                  (r.to[i] ? message_outcome::handled : message_outcome::refused));
            CHECK(a.core.state() == r.to[i].value_or(r.from));
        }
}

TEST_CASE("state_after equals the table, except for what an emergency stores") {
    for (const row& r : table)
        for (std::size_t i = 0; i != r.to.size(); ++i) {
            const auto event = static_cast<state_event>(i);
            const bool kept = event == state_event::initialized || event == state_event::failed ||
                              event == state_event::emergency_cleared;
            CHECK(jaus::state_after(r.from, event) == (r.from == emergency_state && kept ? no : r.to[i]));
        }
}

TEST_CASE("after an emergency a Ready component is in Standby or Ready, others keep their state") {
    for (const state before : {initialize, ready, standby_state, failure}) {
        for (const auto after : {jaus::after_emergency::standby, jaus::after_emergency::resume}) {
            arm a{before, after};
            REQUIRE(a.set() == message_outcome::handled);
            REQUIRE(a.core.state() == emergency_state);
            REQUIRE(a.clear() == message_outcome::handled);
            const bool stands_by = before == ready && after == jaus::after_emergency::standby;
            REQUIRE(a.core.state() == (stands_by ? standby_state : before));
        }
    }
}

TEST_CASE("state changes by the application during an emergency take effect after it") {
    arm ready_now{initialize, jaus::after_emergency::resume};
    ready_now.set();
    REQUIRE(ready_now.core.change(state_event::initialized));
    REQUIRE(ready_now.core.state() == emergency_state);
    ready_now.clear();
    REQUIRE(ready_now.core.state() == ready);

    arm broken{ready};
    broken.set();
    REQUIRE(broken.core.change(state_event::failed));
    REQUIRE_FALSE(broken.core.change(state_event::initialized));
    broken.clear();
    REQUIRE(broken.core.state() == failure);
}

TEST_CASE("an emergency ends when its last holder clears it") {
    arm a;
    a.set(ocu);
    a.set(other);
    a.set(ocu);
    REQUIRE(a.core.holds_emergency(ocu));
    REQUIRE_FALSE(a.core.holds_emergency(third));
    REQUIRE(a.clear(third) == message_outcome::refused);
    REQUIRE(a.clear(ocu) == message_outcome::handled);
    REQUIRE(a.core.state() == emergency_state);
    REQUIRE(a.clear(ocu) == message_outcome::refused);
    REQUIRE(a.clear(other) == message_outcome::handled);
    REQUIRE(a.core.state() == standby_state);
    REQUIRE(a.clear(ocu) == message_outcome::handled); // nothing is left to clear
}

TEST_CASE("an emergency of the application is not ended by a message") {
    arm a;
    REQUIRE(a.core.change(state_event::emergency));
    a.set(ocu);
    REQUIRE(a.clear(third) == message_outcome::refused);
    REQUIRE(a.clear(ocu) == message_outcome::handled);
    REQUIRE(a.core.state() == emergency_state);
    REQUIRE(a.core.change(state_event::emergency_cleared));
    REQUIRE(a.core.state() == standby_state);
}

TEST_CASE("the emergency of an absent sender can be cleared by any sender") {
    arm a;
    a.set(ocu);
    a.core.on_lost([](const jaus::address& who) { return who == other; });
    REQUIRE(a.clear(third) == message_outcome::refused);
    a.core.on_lost([](const jaus::address& who) { return who.node == ocu.node; });
    REQUIRE(a.core.state() == emergency_state);
    REQUIRE(a.clear(third) == message_outcome::handled);
    REQUIRE(a.core.state() == standby_state);
}

TEST_CASE("Clear Emergency clears only the sender's own emergency") {
    arm a;
    a.set(ocu);
    a.set(other);
    a.core.on_lost([](const jaus::address& who) { return who == other; });
    REQUIRE(a.clear(ocu) == message_outcome::handled);
    REQUIRE(a.core.state() == emergency_state);
    REQUIRE(a.clear(third) == message_outcome::handled);
    REQUIRE(a.core.state() == standby_state);

    arm full; // of two places
    full.set(ocu);
    full.set(other);
    full.set(third);
    full.clear(ocu);
    full.clear(other);
    REQUIRE(full.core.state() == emergency_state);
    REQUIRE(full.clear(third) == message_outcome::handled);
    REQUIRE(full.core.state() == standby_state);
}

TEST_CASE("an emergency takes effect also without a place to store its sender") {
    arm a;
    a.set(ocu);
    a.set(other);
    REQUIRE(a.set(third) == message_outcome::handled);
    REQUIRE_FALSE(a.core.holds_emergency(third));
    REQUIRE(a.clear(third) == message_outcome::handled);
    REQUIRE(a.clear(third) == message_outcome::refused);
    a.clear(ocu);
    REQUIRE(a.core.state() == emergency_state);
    a.clear(other);
    REQUIRE(a.core.state() == standby_state);
}

TEST_CASE("the application can end the emergency of any sender") {
    arm a;
    a.set(ocu);
    a.core.change(state_event::emergency);
    a.core.end_emergency();
    REQUIRE(a.core.state() == standby_state);
    REQUIRE_FALSE(a.core.holds_emergency(ocu));
    a.core.end_emergency();
    REQUIRE(a.core.state() == standby_state);
}

TEST_CASE("a shutdown ends an emergency with all its holders") {
    arm a;
    a.set(ocu);
    REQUIRE(a.hear(jaus::shutdown{}) == message_outcome::handled);
    REQUIRE_FALSE(a.core.holds_emergency(ocu));
    REQUIRE(a.set(ocu) == message_outcome::handled);
    REQUIRE(a.core.state() == shutdown_state);
    REQUIRE_FALSE(a.core.holds_emergency(ocu));
}

TEST_CASE("Set Emergency stops with any code and body, Clear Emergency needs its bit") {
    const std::array<std::byte, 3> bytes{std::byte{0}, std::byte{0x80}, std::byte{0xFF}};
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        arm a;
        const auto body = std::span{bytes}.first(size);
        REQUIRE_FALSE(jaus::says_emergency(body));
        REQUIRE(a.core.on_message({.command_code = 6, .source = ocu}, body, {}, a.sent.sink()) ==
                message_outcome::handled);
        REQUIRE(a.core.state() == emergency_state);
        REQUIRE(a.core.holds_emergency(ocu));
    }
    arm a;
    a.set();
    REQUIRE(a.hear(jaus::clear_emergency{}) == message_outcome::handled);
    REQUIRE(a.core.state() == emergency_state);
}

TEST_CASE("a query is answered with state and secondary code, also if sent to a broadcast address") {
    arm a{standby_state};
    a.core.secondary_status = 0x12345678;
    const auto query = message({.destination = {255, 255, 2, 3}, .source = ocu, .sequence_number = 77},
                               jaus::query_component_status{});
    const auto m = jaus::split(query);
    REQUIRE(a.core.on_message(m.header, m.body, {}, a.sent.sink()) == message_outcome::handled);
    REQUIRE(a.sent.size() == 1);
    const auto head = a.sent.header(0);
    REQUIRE(head.source == self);
    REQUIRE(head.destination == ocu);
    REQUIRE(head.sequence_number == 77);
    REQUIRE(a.sent.body<jaus::report_component_status>(0) == jaus::report_component_status{standby_state, 0x12345678});
}

TEST_CASE("bodies of the wrong size and other messages change nothing") {
    arm a;
    const std::array<std::byte, 3> bytes{};
    for (const std::uint16_t code : std::to_array<std::uint16_t>({2, 3, 4, 5, 7, 0x2002})) {
        CAPTURE(code);
        CHECK(a.core.on_message({.command_code = code, .source = ocu}, bytes, {}, a.sent.sink()) ==
              message_outcome::malformed);
    }
    CHECK(a.core.on_message({.command_code = 0x0405, .source = ocu}, bytes, {}, a.sent.sink()) ==
          message_outcome::unhandled);
    CHECK(a.core.state() == ready);
    CHECK(a.sent.empty());
}
