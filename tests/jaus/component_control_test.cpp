// Control of a component: granted, refused, taken over, released, lost, and the commands that only the controller
// sends.
#include "jaus/lossy_channel.hpp"
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/held_control.hpp>

namespace {

using namespace jauscat::test;
using namespace std::chrono_literals;
using support::instant;
namespace jaus = jauscat::jaus;
using enum jaus::component_control_response;
using jaus::message_outcome;
constexpr jaus::address self{1, 49, 2, 3}, ocu{1, 32, 1, 1}, other{1, 33, 1, 1};

struct arm {
    jaus::component_control control;
    sent_messages sent{};

    explicit arm(const jaus::control_options& options = {}) : control{self, options} {}

    template <class T> message_outcome hear(const T& body, jaus::address from, instant now = 0s) {
        const auto bytes = message({.destination = self, .source = from, .sequence_number = 9}, body);
        const auto m = jaus::split(bytes);
        control.heard(m.header, now);
        if (!control.admits(m.header)) return message_outcome::refused;
        return control.on_message(m.header, m.body, now, sent.sink());
    }
    /// The answer to a request for control.
    jaus::component_control_response request(std::uint8_t authority, jaus::address from, instant now = 0s) {
        sent.clear();
        REQUIRE(hear(jaus::request_component_control{authority}, from, now) == message_outcome::handled);
        REQUIRE_FALSE(sent.empty());
        const std::size_t last = sent.size() - 1;
        REQUIRE(sent.header(last).destination == from);
        REQUIRE(sent.header(last).source == self);
        REQUIRE(sent.header(last).sequence_number == 9);
        return sent.body<jaus::confirm_component_control>(last).response_code;
    }
    bool admits(std::uint16_t code, jaus::address from) {
        return control.admits({.command_code = code, .source = from});
    }
    jaus::report_component_control report() {
        sent.clear();
        REQUIRE(hear(jaus::query_component_control{}, other) == message_outcome::handled);
        return sent.body<jaus::report_component_control>(0);
    }
};

} // namespace

TEST_CASE("the first request gets control, with any authority") {
    arm a;
    REQUIRE_FALSE(a.control.controller());
    REQUIRE(a.report() == jaus::report_component_control{});
    REQUIRE(a.request(0, ocu) == control_accepted);
    REQUIRE(a.control.controller() == jaus::controller{ocu, 0});
    REQUIRE(a.request(7, ocu) == control_accepted); // the controller may change its authority
    REQUIRE(a.sent.size() == 1);
    REQUIRE(a.report() == jaus::report_component_control{1, 1, 32, 1, 7});
}

TEST_CASE("equal and lower authority do not get control, higher takes it over and the old controller is notified") {
    arm a;
    a.request(100, ocu);
    REQUIRE(a.request(100, other) == control_not_accepted);
    REQUIRE(a.sent.size() == 1);
    REQUIRE(a.request(99, other) == control_not_accepted);
    REQUIRE(a.control.controller() == jaus::controller{ocu, 100});

    REQUIRE(a.request(101, other) == control_accepted);
    REQUIRE(a.sent.size() == 2);
    static_cast<void>(a.sent.body<jaus::reject_component_control>(0));
    REQUIRE(a.sent.header(0).destination == ocu);
    REQUIRE(a.sent.header(0).source == self);
    REQUIRE(a.control.controller() == jaus::controller{other, 101});
    REQUIRE(a.request(255, ocu) == control_accepted);
}

TEST_CASE("only the controller releases control") {
    arm a;
    REQUIRE(a.hear(jaus::release_component_control{}, other) ==
            message_outcome::handled); // nobody's: nothing to refuse
    a.request(1, ocu);
    REQUIRE(a.hear(jaus::release_component_control{}, other) == message_outcome::refused);
    const jaus::header unasked{.command_code = 0x000E, .source = other}; // admits was not asked
    REQUIRE(a.control.on_message(unasked, {}, instant{0s}, a.sent.sink()) == message_outcome::handled);
    REQUIRE(a.control.controls(ocu));
    REQUIRE(a.hear(jaus::release_component_control{}, ocu) == message_outcome::handled);
    REQUIRE_FALSE(a.control.controller());
    REQUIRE(a.request(0, other) == control_accepted);
}

TEST_CASE("of all codes, queries, reports and the open commands are admitted from every sender, others are not") {
    arm a;
    for (unsigned code = 0; code <= 0xFFFF; ++code) REQUIRE(a.admits(static_cast<std::uint16_t>(code), other));
    a.request(1, ocu);
    std::uint64_t refused = 0;
    for (unsigned i = 0; i <= 0xFFFF; ++i) {
        const auto code = static_cast<std::uint16_t>(i);
        const bool asks_or_reports = code >= 0x2000 && code < 0x6000;
        const bool listed_open = std::ranges::any_of(jaus::command_rules, [&](const jaus::ruled_command& one) {
            return one.command_code == code && one.rule == jaus::command_rule::open;
        });
        REQUIRE(a.admits(code, ocu));
        REQUIRE(a.admits(code, other) == (asks_or_reports || listed_open));
        refused += !(asks_or_reports || listed_open);
        REQUIRE(a.control.refused() == refused);
    }
    REQUIRE(refused == 0x10000 - 0x4000 - 15);
}

TEST_CASE("what the reference architecture refuses to senders without control is refused, except Set Emergency") {
    // The note on authority, as it stands there.
    std::vector<std::uint16_t> list{0x0001, 0x0002, 0x0003, 0x0004, 0x0005, 0x0006, 0x0007, 0x000E, 0x0011,
                                    0x0405, 0x0406, 0x0407, 0x0408, 0x040A, 0x040C, 0x040D, 0x040F, 0x0410};
    for (std::uint16_t code = 0x0601; code <= 0x0608; ++code) list.push_back(code);
    for (const std::uint16_t code : std::to_array<std::uint16_t>({0x0801, 0x0802, 0x0805, 0x0806}))
        list.push_back(code);
    for (const std::uint16_t code : list)
        REQUIRE((jaus::rule_of(code) == jaus::command_rule::open) ==
                (code == jaus::command_code_of<jaus::set_emergency>));
}

TEST_CASE("0404h, payload, missions and unknown codes count as motion commands") {
    using enum jaus::command_rule;
    for (const int code : {0x0404, 0x0405, 0x0607, 0x0A25, 0x0D01, 0x0E00, 0x0E01, 0x0E04, 0x0E05, 0x0E06})
        REQUIRE(jaus::rule_of(static_cast<std::uint16_t>(code)) == moving);
    for (const int code : {0x0000, 0x0012, 0x0409, 0x040B, 0x0600, 0x0E07, 0x1FFF, 0x6000, 0x8123, 0xD000, 0xFFFF})
        REQUIRE(jaus::rule_of(static_cast<std::uint16_t>(code)) == moving);
    for (const int code : {0x2000, 0x2E01, 0x4000, 0x4402, 0x5FFF})
        REQUIRE(jaus::rule_of(static_cast<std::uint16_t>(code)) == open);
    // What ends a mission must work before a Resume, too.
    for (const int code : {0x0E02, 0x0E03}) REQUIRE(jaus::rule_of(static_cast<std::uint16_t>(code)) == controlled);
}

TEST_CASE("a user's own messages count as motion commands unless declared harmless") {
    static constexpr std::array<std::uint16_t, 1> own{0xD081};
    arm a{{.harmless = own}};
    a.request(1, ocu);
    REQUIRE(a.admits(0xD081, other));
    REQUIRE_FALSE(a.admits(0xD082, other));
    REQUIRE(a.admits(0x0006, other));
    REQUIRE(a.control.refused() == 1);
}

TEST_CASE("authority is set and reported") {
    arm a{{.authority_code = 12}};
    REQUIRE(a.hear(jaus::query_component_authority{}, other) == message_outcome::handled);
    REQUIRE(a.sent.body<jaus::report_component_authority>(0).authority_code == 12);
    REQUIRE(a.hear(jaus::set_component_authority{200}, other) == message_outcome::handled);
    a.request(1, ocu);
    REQUIRE(a.hear(jaus::set_component_authority{3}, other) == message_outcome::refused);
    REQUIRE(a.control.authority_code() == 200);
    REQUIRE(a.hear(jaus::set_component_authority{3}, ocu) == message_outcome::handled);
    REQUIRE(a.control.authority_code() == 3);
}

TEST_CASE("control ends when the controller disappears") {
    arm a;
    a.request(1, ocu);
    a.sent.clear();
    a.control.on_lost([](const jaus::address& who) { return who == other; });
    REQUIRE(a.control.controls(ocu));
    a.control.on_lost([](const jaus::address& who) { return who.subsystem == ocu.subsystem; });
    REQUIRE_FALSE(a.control.controller());
    REQUIRE(a.sent.empty());
}

TEST_CASE("a silent controller is queried for its heartbeat after a quarter of the timeout, and lost after all of it") {
    arm a{{.timeout = 1s}};
    REQUIRE_FALSE(a.control.next_event());
    a.request(1, ocu, 10s);
    a.sent.clear();
    for (const instant due : {instant{10250ms}, instant{10500ms}, instant{10750ms}}) {
        REQUIRE(a.control.next_event() == due);
        a.control.on_time(due + -1ns, a.sent.sink());
        REQUIRE(a.sent.empty());
        a.control.on_time(due, a.sent.sink());
        REQUIRE(a.sent.size() == 1);
        REQUIRE(a.sent[0] == from_hex("06 02 02 22 01 20 01 01 01 31 02 03 00 00 00 00"));
        a.sent.clear();
    }
    REQUIRE(a.control.next_event() == instant{11s});
    a.control.heard({.source = other}, instant{10900ms});
    a.control.on_time(instant{11s - 1ns}, a.sent.sink());
    REQUIRE(a.control.controls(ocu));
    REQUIRE(a.sent.empty());
    a.control.on_time(instant{11s}, a.sent.sink());
    REQUIRE_FALSE(a.control.controller());
    REQUIRE(a.control.last_change() == jaus::control_change::lost);
    REQUIRE(a.sent.size() == 1);
    static_cast<void>(a.sent.body<jaus::reject_component_control>(0));
    REQUIRE(a.sent.header(0).destination == ocu);
    REQUIRE_FALSE(a.control.next_event());
    a.control.on_time(instant{20s}, a.sent.sink());
    REQUIRE(a.sent.size() == 1);
}

TEST_CASE("any message of the controller but a heartbeat query proves liveness, and its heartbeat counts for the "
          "control that queried it") {
    arm a{{.timeout = 1s}};
    a.request(1, ocu, 10s);
    const jaus::header pulse{.command_code = 0x4202, .destination = self, .source = ocu};
    REQUIRE_FALSE(a.control.takes_pulse(pulse));        // not asked for
    a.control.on_time(instant{10900ms}, a.sent.sink()); // late: asked once, not three times
    REQUIRE(a.sent.size() == 2);
    REQUIRE(a.control.next_event() == instant{11s});
    a.control.heard({.command_code = 0x2202, .destination = self, .source = ocu}, instant{10950ms}); // by its node
    REQUIRE(a.control.next_event() == instant{11s});
    a.control.heard(pulse, instant{10950ms});
    REQUIRE(a.control.next_event() == instant{11200ms});
    REQUIRE_FALSE(a.control.takes_pulse({.command_code = 0x4202, .destination = self, .source = other}));
    REQUIRE_FALSE(a.control.takes_pulse({.command_code = 0x4002, .destination = self, .source = ocu}));
    REQUIRE(a.control.takes_pulse(pulse));
    REQUIRE_FALSE(a.control.takes_pulse(pulse));
    a.control.on_time(instant{11200ms}, a.sent.sink());
    a.request(2, other, 11300ms);
    REQUIRE_FALSE(a.control.takes_pulse({.command_code = 0x4202, .destination = self, .source = other}));
}

TEST_CASE("a further command of a sender without control does not make its heartbeat an unrequested one") {
    arm a{{.timeout = 1s}};
    const jaus::header move{.command_code = 0x0405, .destination = self, .source = ocu};
    const auto obey = [&](instant now) {
        a.control.heard(move, now);
        a.control.obeyed(move, message_outcome::handled, now);
    };
    obey(10s);
    a.control.on_time(instant{10250ms}, a.sent.sink());
    REQUIRE(a.sent.size() == 1);
    REQUIRE(a.sent.header(0).command_code == 0x2202);
    obey(10260ms);
    const jaus::header pulse{.command_code = 0x4202, .destination = self, .source = ocu};
    REQUIRE(a.control.takes_pulse(pulse));
    REQUIRE_FALSE(a.control.takes_pulse(pulse));
}

TEST_CASE(
    "a sender without control that was heard again is queried after a quarter of the timeout, as a controller is") {
    arm a{{.timeout = 1s}};
    const jaus::header move{.command_code = 0x0405, .destination = self, .source = ocu};
    a.control.heard(move, instant{10s});
    a.control.obeyed(move, message_outcome::handled, instant{10s});
    a.control.on_time(instant{10750ms}, a.sent.sink());
    REQUIRE(a.control.next_event() == instant{11s}); // its end
    a.control.heard({.command_code = 0x4405, .destination = self, .source = ocu}, instant{10800ms});
    REQUIRE(a.control.next_event() == instant{11050ms});
    a.request(9, other, 10900ms); // it is watched beside a controller, too
    REQUIRE(a.control.next_event() == instant{11050ms});
    a.control.heard(move, instant{10950ms});
    REQUIRE(a.control.next_event() == instant{11150ms});
}

TEST_CASE("a controller that asks again has the authority of that request, and its heartbeat is still expected") {
    arm a{{.timeout = 1s}};
    a.request(9, ocu, 10s);
    a.control.on_time(instant{10250ms}, a.sent.sink());
    REQUIRE(a.request(2, ocu, 10300ms) == control_accepted);
    REQUIRE(a.control.takes_pulse({.command_code = 0x4202, .destination = self, .source = ocu}));
    REQUIRE(a.report().authority_code == 2);
    REQUIRE(a.request(3, other, 10400ms) == control_accepted);
}

TEST_CASE("the default timeout is half a second, and any other than 0 works") {
    arm a;
    a.request(1, ocu, 10s);
    REQUIRE(a.control.next_event() == instant{10125ms});
    a.control.on_time(instant{10500ms}, a.sent.sink());
    REQUIRE_FALSE(a.control.controller());
    arm hasty{{.timeout = 1ns}}, patient{{.timeout = std::chrono::nanoseconds::max()}};
    hasty.request(1, ocu, 10s);
    REQUIRE(hasty.control.next_event() == instant{10s + 1ns});
    hasty.control.on_time(instant{10s + 1ns}, hasty.sent.sink());
    REQUIRE_FALSE(hasty.control.controller());
    patient.request(1, ocu, 10s);
    for (int i = 0; i != 3; ++i) patient.control.on_time(*patient.control.next_event(), patient.sent.sink());
    REQUIRE(patient.control.controls(ocu));
    REQUIRE(patient.control.next_event() == jauscat::time_point::max());
}

TEST_CASE("a change of the controller has its cause") {
    using enum jaus::control_change;
    arm a;
    a.request(1, ocu);
    REQUIRE(a.control.last_change() == granted);
    a.request(2, other);
    REQUIRE(a.control.last_change() == taken_over);
    a.request(3, other);
    REQUIRE(a.control.last_change() == granted);
    a.hear(jaus::release_component_control{}, other);
    REQUIRE(a.control.last_change() == released);
    a.request(1, ocu);
    a.control.reject(a.sent.sink());
    REQUIRE(a.control.last_change() == rejected);
    a.request(1, ocu);
    a.control.on_lost([](const jaus::address&) { return true; });
    REQUIRE(a.control.last_change() == lost);
}

TEST_CASE("without a timeout control does not expire") {
    arm a{{.timeout = 0s}};
    a.request(1, ocu);
    REQUIRE_FALSE(a.control.next_event());
    a.control.on_time(instant{100h}, a.sent.sink());
    REQUIRE(a.control.controls(ocu));
}

TEST_CASE("the component can take control back") {
    arm a;
    a.control.reject(a.sent.sink());
    REQUIRE(a.sent.empty());
    a.request(1, ocu);
    a.sent.clear();
    a.control.reject(a.sent.sink());
    REQUIRE(a.sent.header(0).command_code == jaus::command_code_of<jaus::reject_component_control>);
    REQUIRE(a.sent.header(0).destination == ocu);
    REQUIRE_FALSE(a.control.controller());
}

TEST_CASE("malformed control messages change nothing, other messages are not handled") {
    arm a;
    const std::array<std::byte, 6> bytes{};
    for (const std::uint16_t code : std::to_array<std::uint16_t>({0x0001, 0x000D, 0x000E, 0x2001, 0x200D})) {
        CAPTURE(code);
        CHECK(a.control.on_message({.command_code = code, .source = ocu}, bytes, instant{0s}, a.sent.sink()) ==
              message_outcome::malformed);
    }
    for (const std::uint16_t code : std::to_array<std::uint16_t>({0x000F, 0x0010, 0x0405, 0x0006}))
        CHECK(a.control.on_message({.command_code = code, .source = ocu}, bytes, instant{0s}, a.sent.sink()) ==
              message_outcome::unhandled);
    CHECK_FALSE(a.control.controller());
    CHECK(a.sent.empty());
}

TEST_CASE("after a bad network both sides agree on the controller, if silent controllers lose control") {
    for (unsigned seed = 0; seed != 300; ++seed) {
        lossy_channel network{seed};
        network.faults = {.lose = 20, .duplicate = 15, .delay = 80, .longest = 50ms};
        jaus::component_control control{self, {.timeout = 1s}};
        const jaus::held_control_options keep{.retry = {.interval = 100ms, .attempts = 5}, .renewal = 300ms};
        std::array operators{jaus::held_control{ocu, self, keep}, jaus::held_control{other, self, keep}};
        const auto out = network.sink();
        network.listen(self, [&](const jaus::header& head, std::span<const std::byte> body) {
            control.heard(head, network.now);
            if (control.admits(head)) control.on_message(head, body, network.now, out);
        });
        network.work([&] {
            control.on_time(network.now, out);
            return control.next_event();
        });
        for (const auto i : {0u, 1u}) {
            auto& one = operators[i];
            network.listen(i == 0 ? ocu : other, [&](const jaus::header& head, std::span<const std::byte> body) {
                one.on_message(head, body, network.now, out);
            });
            network.work([&] {
                one.on_time(network.now, out);
                return one.next_event();
            });
        }
        std::mt19937 random{seed};
        for (int i = 0; i != 100; ++i) {
            auto& one = operators[random() % 2];
            if (random() % 4 == 0)
                one.release(out);
            else
                one.ask(static_cast<std::uint8_t>(random() % 4), network.now, out);
            network.run(network.now + 50ms);
        }
        network.faults = {};
        network.run(network.now + 3s);
        INFO("seed " << seed);
        REQUIRE((operators[0].state() == jaus::control_state::held) == control.controls(ocu));
        REQUIRE((operators[1].state() == jaus::control_state::held) == control.controls(other));
    }
}

TEST_CASE("control with an interval of renewal below 0 is not renewed, as with 0") {
    for (const auto renewal : {0ns, -1ns, jauscat::duration::min()}) {
        sent_messages sent;
        jaus::held_control held{ocu, self, {.renewal = renewal}};
        held.ask(100, instant{0s}, sent.sink());
        const auto confirmed = message({.destination = ocu, .source = self}, jaus::confirm_component_control{});
        const auto m = jaus::split(confirmed);
        REQUIRE(held.on_message(m.header, m.body, instant{0s}, sent.sink()) == message_outcome::handled);
        CHECK_FALSE(held.next_event());
    }
}

TEST_CASE("only control that is requested or held is lost with its component") {
    sent_messages sent;
    std::vector<jaus::control_state> states;
    const auto note = [&](jaus::control_state state) { states.push_back(state); };
    jaus::held_control held{ocu, self, {}, note};
    REQUIRE(held.target() == self);
    const auto answered = [&](jaus::component_control_response response) {
        held.ask(100, instant{0s}, sent.sink());
        const auto confirmed = message({.destination = ocu, .source = self}, jaus::confirm_component_control{response});
        const auto m = jaus::split(confirmed);
        REQUIRE(held.on_message(m.header, m.body, instant{0s}, sent.sink()) == message_outcome::handled);
    };
    using state = jaus::control_state;
    const auto expect = [&](const std::vector<state>& expected) {
        REQUIRE(states == expected);
        states.clear();
    };
    held.on_lost(self);
    answered(control_not_accepted);
    held.on_lost(self);
    expect({state::asking, state::refused});
    answered(control_accepted);
    held.on_lost(other);
    expect({state::asking, state::held});
    held.on_lost({255, 255, self.node, self.subsystem});
    expect({state::lost});
    answered(control_accepted);
    answered(control_not_accepted); // another one has taken it, and the message of that was lost
    expect({state::asking, state::held, state::lost});
    held.ask(100, instant{0s}, sent.sink());
    held.release(sent.sink());
    held.on_lost(self);
    expect({state::asking, state::none});
}

TEST_CASE("control that was rejected is not released, and a new request for it has all its attempts") {
    sent_messages sent;
    jaus::held_control held{ocu, self, {.retry = {.interval = 1s, .attempts = 3}}};
    const auto hear = [&](const auto& body) {
        const auto bytes = message({.destination = ocu, .source = self}, body);
        const auto m = jaus::split(bytes);
        return held.on_message(m.header, m.body, instant{0s}, sent.sink());
    };
    held.ask(100, instant{0s}, sent.sink());
    REQUIRE(hear(jaus::confirm_component_control{control_accepted}) == message_outcome::handled);
    REQUIRE(hear(jaus::reject_component_control{}) == message_outcome::handled);
    sent.clear();
    REQUIRE(hear(jaus::query_heartbeat_pulse{}) == message_outcome::unhandled);
    REQUIRE(sent.empty()); // the target has taken it back itself
    for (int run = 0; run != 2; ++run) {
        sent.clear();
        held.ask(100, instant{0s}, sent.sink());
        while (held.next_event()) held.on_time(*held.next_event(), sent.sink());
        REQUIRE(held.state() == jaus::control_state::unanswered);
        REQUIRE(sent.size() == 3);
    }
}
