// Whole components that talk to each other: control, emergencies, acknowledgement, over a good channel and a bad one.
#include "jaus/lossy_channel.hpp"
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/jaus/component/held_control.hpp>
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/jaus/events/service_connections.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace {

using namespace jauscat::test;
using namespace std::chrono_literals;
using support::instant;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using enum jaus::component_outcome;
using jaus::ack_nak;
using jaus::component_outcome;
using jaus::control_state;
using jaus::delivered;
using jaus::message_outcome;
using jaus::primary_status_code;
using jaus::state_event;

constexpr jaus::address arm_address{1, 49, 2, 3}, ocu_address{1, 32, 1, 1}, boss_address{1, 40, 1, 9};

/// Records the hooks of a component.
struct told {
    std::vector<std::pair<primary_status_code, primary_status_code>> states{};
    std::vector<std::optional<jaus::controller>> controllers{};
    std::vector<jaus::control_change> changes{};
    std::vector<std::pair<std::uint16_t, delivered>> outcomes{}; // command code

    void on_state(primary_status_code from, primary_status_code to) { states.emplace_back(from, to); }
    void on_controller(const std::optional<jaus::controller>& now_it_is, jaus::control_change why) {
        controllers.push_back(now_it_is);
        changes.push_back(why);
    }
    void on_delivered(const jaus::awaited_message& m, delivered what) {
        outcomes.emplace_back(m.header.command_code, what);
    }
    jaus::component_hooks hooks() {
        return {.on_state = jaus::bound<&told::on_state>(*this),
                .on_controller = jaus::bound<&told::on_controller>(*this),
                .on_delivered = jaus::bound<&told::on_delivered>(*this)};
    }
};

/// A part that takes a message and has something to do at a time.
struct ticking_part {
    std::uint16_t code{};
    jauscat::time_point due{};
    int heard{}, ticks{};
    std::vector<jaus::address> lost{};

    message_outcome on_message(const jaus::header& head, std::span<const std::byte>, jauscat::time_point,
                               jaus::message_sink) noexcept {
        if (head.command_code != code) return message_outcome::unhandled;
        ++heard;
        return message_outcome::handled;
    }
    void on_time(jauscat::time_point now, jaus::message_sink) noexcept { ticks += now >= due; }
    [[nodiscard]] std::optional<jauscat::time_point> next_event() const noexcept { return due; }
    void on_lost(const jaus::address& who) { lost.push_back(who); }
};

/// An arm that obeys Set Wrench Effort and halts in an emergency. It is ready.
struct arm {
    told hooks{};
    jaus::component_memory<4, 64, 64> memory{};
    ticking_part part{.code = 0xD001, .due = instant{100h}};
    jaus::component<ticking_part> core;
    sent_messages sent{};
    std::vector<double> efforts{};

    explicit arm(const jaus::component_options& options = {})
        : core{arm_address, memory, hooks.hooks(), options, part} {
        core.change(state_event::initialized);
        hooks = {};
    }
    component_outcome hear(const jaus::header& head, std::span<const std::byte> body, instant now,
                           jaus::message_sink out) {
        jaus::dispatcher own{jaus::on<jaus::set_wrench_effort>([&](const jaus::header&, const auto& m) {
                                 efforts.push_back(m.propulsive_linear_effort_x.value_or(0));
                             }),
                             jaus::on<jaus::query_wrench_effort>([](const jaus::header&, const auto&) {})};
        return core.on_message(head, body, now, out, own);
    }
    template <class T>
    component_outcome hear(const T& body, const jaus::address& from, ack_nak wish = ack_nak::none,
                           std::uint16_t number = 0, instant now = 0s) {
        const auto bytes =
            message({.ack_nak = wish, .destination = arm_address, .source = from, .sequence_number = number}, body);
        const auto m = jaus::split(bytes);
        return hear(m.header, m.body, now, sent.sink());
    }
    void put_under_control_of(const jaus::address& who, std::uint8_t authority = 100) {
        REQUIRE(hear(jaus::request_component_control{authority}, who) == handled);
        REQUIRE(core.control().controls(who));
        sent.clear();
        hooks = {};
    }
};

/// An operator that wants control of the arm.
struct ocu {
    told hooks{};
    jaus::component_memory<16, 64, 64> memory{};
    jaus::held_control control;
    jaus::component<jaus::held_control> core;
    std::vector<std::uint16_t> reports{};

    explicit ocu(const jaus::address& self, const jaus::component_options& options = {})
        : control{self, arm_address}, core{self, memory, hooks.hooks(), options, control} {}
    component_outcome hear(const jaus::header& head, std::span<const std::byte> body, instant now,
                           jaus::message_sink out) {
        return core.on_message(head, body, now, out, [&](const jaus::header& h, std::span<const std::byte>) {
            reports.push_back(h.command_code);
            return message_outcome::handled;
        });
    }
};

/// Lets a component send and hear over a channel.
void join(lossy_channel& channel, auto& component) {
    channel.listen(component.core.self(), [&](const jaus::header& head, std::span<const std::byte> body) {
        component.hear(head, body, channel.now, channel.sink());
    });
    channel.work([&]() -> std::optional<jauscat::time_point> {
        component.core.on_time(channel.now, channel.sink());
        return component.core.next_event();
    });
}

const jaus::set_wrench_effort push{.propulsive_linear_effort_x = 50.0};
const jaus::set_emergency stop{{jaus::set_emergency_code::transition_to_emergency}};
const jaus::clear_emergency go_on{{jaus::clear_emergency_code::clear_emergency}};

} // namespace

TEST_CASE("an operator takes control, commands, loses control to a higher authority, and gets it back") {
    lossy_channel channel;
    arm a;
    ocu operator_{ocu_address}, boss{boss_address};
    join(channel, a);
    join(channel, operator_);
    join(channel, boss);
    const auto until = [&](instant end) { channel.run(end); };

    operator_.control.ask(100, channel.now, channel.sink());
    until(10ms);
    REQUIRE(operator_.control.state() == control_state::held);
    REQUIRE(a.hooks.controllers == std::vector<std::optional<jaus::controller>>{jaus::controller{ocu_address, 100}});

    REQUIRE(operator_.core.send({.destination = arm_address}, push, channel.now, channel.sink()));
    REQUIRE(boss.core.send({.destination = arm_address}, push, channel.now, channel.sink()));
    until(20ms);
    REQUIRE(a.efforts.size() == 1);
    REQUIRE(operator_.hooks.outcomes ==
            std::vector<std::pair<std::uint16_t, delivered>>{{0x0405, delivered::acknowledged}});
    REQUIRE(boss.hooks.outcomes == std::vector<std::pair<std::uint16_t, delivered>>{{0x0405, delivered::refused}});
    REQUIRE(a.core.count(not_controller) == 1);

    boss.control.ask(100, channel.now, channel.sink());
    until(30ms);
    REQUIRE(boss.control.state() == control_state::refused);
    boss.control.ask(101, channel.now, channel.sink());
    until(40ms);
    REQUIRE(boss.control.state() == control_state::held);
    REQUIRE(operator_.control.state() == control_state::lost);
    REQUIRE(operator_.core.send({.destination = arm_address}, push, channel.now, channel.sink()));
    until(50ms);
    REQUIRE(operator_.hooks.outcomes.back() == std::pair{std::uint16_t{0x0405}, delivered::refused});
    REQUIRE(a.efforts.size() == 1);

    // What is no command is answered to anybody.
    REQUIRE(jaus::put({.destination = arm_address, .source = ocu_address}, jaus::query_component_control{},
                      channel.sink()));
    boss.control.release(channel.sink());
    until(60ms);
    REQUIRE(operator_.reports == std::vector<std::uint16_t>{0x400D});
    REQUIRE_FALSE(a.core.control().controller());
    operator_.control.ask(0, channel.now, channel.sink());
    until(70ms);
    REQUIRE(operator_.control.state() == control_state::held);
    REQUIRE(a.core.waiting() + operator_.core.waiting() + boss.core.waiting() == 0);
}

TEST_CASE("a lost request for control is repeated, and abandoned without an answer") {
    lossy_channel channel;
    ocu operator_{ocu_address};
    join(channel, operator_);
    operator_.control.ask(1, channel.now, channel.sink());
    channel.run(1s);
    REQUIRE(operator_.control.state() == control_state::asking);
    arm a;
    SECTION("the arm answers in time") {
        join(channel, a);
        channel.run(5s);
        REQUIRE(operator_.control.state() == control_state::held);
    }
    SECTION("there is no arm") {
        channel.run(3s);
        REQUIRE(operator_.control.state() == control_state::unanswered);
        REQUIRE_FALSE(operator_.core.next_event());
    }
}

TEST_CASE("a controller that renews its control keeps it, a silent one loses it") {
    lossy_channel channel;
    arm a{{.control = {.timeout = 1s}}};
    jaus::component_memory<1, 64, 4> memory{};
    std::vector<control_state> states{};
    const auto changed = [&](control_state s) { states.push_back(s); };
    jaus::held_control control{
        ocu_address, arm_address, {.retry = {.interval = 100ms, .attempts = 3}, .renewal = 400ms}, changed};
    jaus::component core{ocu_address, memory, {}, {}, control};
    bool alive = true;
    channel.listen(ocu_address, [&](const jaus::header& head, std::span<const std::byte> body) {
        if (!alive && head.command_code == jaus::command_code_of<jaus::query_heartbeat_pulse>) return;
        core.on_message(head, body, channel.now, channel.sink(),
                        [](const jaus::header&, auto) { return message_outcome::unhandled; });
    });
    channel.work([&]() -> std::optional<jauscat::time_point> {
        if (!alive) return std::nullopt;
        core.on_time(channel.now, channel.sink());
        return core.next_event();
    });
    join(channel, a);
    control.ask(5, channel.now, channel.sink());
    channel.run(20s);
    REQUIRE(control.state() == control_state::held);
    REQUIRE(a.core.control().controls(ocu_address));
    alive = false;
    channel.run(22s);
    REQUIRE_FALSE(a.core.control().controller());
    REQUIRE(control.state() == control_state::lost);
    REQUIRE(states == std::vector{control_state::asking, control_state::held, control_state::lost});
}

TEST_CASE("a late confirmation of an abandoned request is answered with a release") {
    sent_messages sent;
    jaus::held_control control{ocu_address, arm_address};
    const auto hear = [&](const auto& body, const jaus::address& from) {
        const auto bytes = message({.destination = ocu_address, .source = from}, body);
        const auto m = jaus::split(bytes);
        return control.on_message(m.header, m.body, instant{0s}, sent.sink());
    };
    constexpr auto taken_by_it = message_outcome::handled;
    control.ask(1, instant{0s}, sent.sink());
    REQUIRE(hear(jaus::confirm_component_control{}, boss_address) == message_outcome::unhandled);
    REQUIRE(control.state() == control_state::asking);
    control.release(sent.sink());
    REQUIRE(sent.size() == 2);
    REQUIRE(hear(jaus::confirm_component_control{}, arm_address) == message_outcome::handled);
    REQUIRE(sent.size() == 3);
    REQUIRE(sent.header(2).command_code == 0x000E);
    REQUIRE(sent.header(2).destination == arm_address);
    REQUIRE(control.state() == control_state::none);
    control.release(sent.sink());
    REQUIRE(sent.size() == 3);

    // Also one that comes after a refusal or a loss: the arm is held by a unit that does not know it.
    for (const control_state state : {control_state::refused, control_state::lost}) {
        control.ask(1, instant{0s}, sent.sink());
        if (state == control_state::lost) REQUIRE(hear(jaus::confirm_component_control{}, arm_address) == taken_by_it);
        REQUIRE(hear(jaus::reject_component_control{}, arm_address) == taken_by_it);
        REQUIRE(control.state() == state);
        sent.clear();
        REQUIRE(hear(jaus::confirm_component_control{}, arm_address) == taken_by_it);
        REQUIRE(control.state() == state);
        REQUIRE(sent.size() == 1);
        REQUIRE(sent[0] == from_hex("06 02 0e 00 01 31 02 03 01 20 01 01 00 00 00 00"));
        REQUIRE(hear(jaus::confirm_component_control{jaus::component_control_response::control_not_accepted},
                     arm_address) == taken_by_it);
        REQUIRE(sent.size() == 1);
    }
    control.release(sent.sink());

    // An answer of Reject is a refusal, and a component that has disappeared is lost.
    control.ask(1, instant{0s}, sent.sink());
    REQUIRE(hear(jaus::reject_component_control{}, arm_address) == message_outcome::handled);
    REQUIRE(control.state() == control_state::refused);
    control.ask(1, instant{0s}, sent.sink());
    control.on_lost(boss_address);
    REQUIRE(control.state() == control_state::asking);
    control.on_lost(arm_address);
    REQUIRE(control.state() == control_state::lost);
    control.ask(1, instant{0s}, sent.sink());
    control.on_lost({255, 255, 1, 1}); // a node that is not the arm's
    REQUIRE(control.state() == control_state::asking);
    control.on_lost({255, 255, arm_address.node, arm_address.subsystem});
    REQUIRE(control.state() == control_state::lost);
    REQUIRE(hear(jaus::report_component_authority{}, arm_address) == message_outcome::unhandled);
}

TEST_CASE("what is marked as experimental is not the standard's message of its code") {
    arm a;
    a.put_under_control_of(ocu_address);
    const auto hear = [&](std::uint16_t code, std::span<const std::byte> body, bool experimental, ack_nak wish) {
        return a.hear({.ack_nak = wish,
                       .experimental = experimental,
                       .command_code = code,
                       .destination = arm_address,
                       .source = ocu_address,
                       .data_size = static_cast<std::uint16_t>(body.size()),
                       .sequence_number = 7},
                      body, 0s, a.sent.sink());
    };
    const auto body = from_hex("0100 ff7f");
    CHECK(hear(0x0405, body, true, ack_nak::request) == component_outcome::experimental);
    REQUIRE(a.sent.size() == 1);
    CHECK(a.sent.header(0).ack_nak == ack_nak::nak);
    CHECK(a.efforts.empty());
    CHECK(hear(0x0003, {}, true, ack_nak::none) == component_outcome::experimental);
    CHECK(a.core.state() == primary_status_code::ready);
    CHECK(hear(0x2002, {}, true, ack_nak::none) == component_outcome::experimental);
    CHECK(a.sent.size() == 1);
    // Private ones reach their handlers, whether they are marked or not.
    CHECK(hear(0xD001, {}, true, ack_nak::none) == handled);
    CHECK(hear(0xD001, {}, false, ack_nak::none) == handled);
    CHECK(a.part.heard == 2);
    // Set Velocity State is no message of the standard; no handler has it here, nor a code that is nobody's.
    CHECK(hear(0x0404, {}, true, ack_nak::none) == unknown);
    CHECK(hear(0x4415, {}, true, ack_nak::none) == unknown);
    CHECK(hear(0x0405, body, false, ack_nak::none) == handled);
}

TEST_CASE("any sender can stop a controlled arm, and only that sender, not the controller, can clear the emergency") {
    arm a;
    a.put_under_control_of(ocu_address);
    REQUIRE(a.hear(push, ocu_address) == handled);
    REQUIRE(a.hear(stop, boss_address, ack_nak::request) == handled);
    REQUIRE(a.sent.header(0).ack_nak == ack_nak::ack);
    REQUIRE(a.core.state() == primary_status_code::emergency);
    REQUIRE(a.hooks.states == std::vector<std::pair<primary_status_code, primary_status_code>>{
                                  {primary_status_code::ready, primary_status_code::emergency}});
    REQUIRE(a.hear(push, ocu_address) == not_ready);
    REQUIRE(a.hear(go_on, ocu_address) == refused);
    REQUIRE(a.hear(go_on, {1, 33, 1, 1}) == not_controller);
    REQUIRE(a.hear(go_on, boss_address) == handled);
    REQUIRE(a.core.state() == primary_status_code::standby);
    REQUIRE(a.hear(push, ocu_address) == not_ready);
    REQUIRE(a.hear(jaus::resume{}, boss_address) == not_controller);
    REQUIRE(a.hear(jaus::resume{}, ocu_address) == handled);
    REQUIRE(a.hear(push, ocu_address) == handled);
    REQUIRE(a.efforts.size() == 2);
}

TEST_CASE("a Set Emergency with code 0, as some nodes send it, stops, and its outcome states this") {
    arm a;
    REQUIRE(a.hear(jaus::set_emergency{}, boss_address, ack_nak::request) == stopped_on_invalid_emergency);
    REQUIRE(a.core.state() == primary_status_code::emergency);
    REQUIRE(a.sent[0] == from_hex("36 02 06 00 01 28 01 09 01 31 02 03 00 00 00 00"));
    REQUIRE(a.core.count(stopped_on_invalid_emergency) == 1);
    REQUIRE(a.hear(go_on, boss_address) == handled);
    REQUIRE(a.core.state() == primary_status_code::standby);
}

TEST_CASE("loss of a peer ends its control and its hold of an emergency") {
    arm a;
    a.put_under_control_of(ocu_address);
    a.hear(stop, boss_address);
    a.core.on_lost({255, 255, 1, 1});
    REQUIRE_FALSE(a.core.control().controller());
    REQUIRE(a.hooks.controllers == std::vector<std::optional<jaus::controller>>{std::nullopt});
    REQUIRE(a.hear(go_on, ocu_address) == refused);
    a.core.on_lost(boss_address);
    REQUIRE(a.hear(go_on, ocu_address) == handled);
    REQUIRE(a.part.lost == std::vector<jaus::address>{{255, 255, 1, 1}, boss_address});
}

TEST_CASE("a component that is not Ready handles core messages and refuses motion commands") {
    for (const auto event :
         {state_event::standby, state_event::failed, state_event::shutdown, state_event::emergency}) {
        arm a;
        REQUIRE(a.core.change(event));
        REQUIRE(a.hear(push, ocu_address, ack_nak::request) == not_ready);
        REQUIRE(a.sent.header(0).ack_nak == ack_nak::nak);
        REQUIRE(a.hear(jaus::query_wrench_effort{}, ocu_address) == handled);
        REQUIRE(a.hear(jaus::query_component_status{}, ocu_address) == handled);
        REQUIRE(a.hear(jaus::set_component_authority{4}, ocu_address) == handled);
        REQUIRE(a.efforts.empty());
    }
    arm willing{{.obeys_only_when_ready = false}};
    willing.core.change(state_event::standby);
    REQUIRE(willing.hear(push, ocu_address) == handled);
}

TEST_CASE("motion commands are executed in Ready only, and only from the controller if there is one") {
    jaus::component_memory<4, 64, 64> memory{};
    sent_messages sent;
    for (unsigned i = 0; i <= 0xFFFF; ++i) {
        const auto code = static_cast<std::uint16_t>(i);
        if (jaus::rule_of(code) != jaus::command_rule::moving) continue;
        ticking_part part{.code = static_cast<std::uint16_t>(i % 2 == 0 ? code : 0),
                          .due = instant{100h}}; // a part is no way around
        jaus::component core{arm_address, memory, {}, {.control = {.timeout = 0s}}, part};
        int obeyed = 0;
        const auto hear = [&](const jaus::address& from) {
            const jaus::header head{.command_code = code, .destination = arm_address, .source = from};
            return core.on_message(head, {}, instant{0s}, sent.sink(), [&](const jaus::header&, auto) {
                ++obeyed;
                return message_outcome::handled;
            });
        };
        const auto count = [&] { return obeyed + part.heard; };
        if (hear(ocu_address) != not_ready) FAIL(code << " in Initialize");
        core.change(state_event::initialized);
        if (hear(ocu_address) != handled || count() != 1) FAIL(code << " in Ready");
        core.change(state_event::standby);
        if (hear(ocu_address) != not_ready) FAIL(code << " in Standby");
        core.change(state_event::emergency);
        if (hear(ocu_address) != not_ready) FAIL(code << " in Emergency");
        core.end_emergency();
        core.change(state_event::resume);
        const std::array authority{std::byte{255}};
        core.on_message({.command_code = 0x000D, .destination = arm_address, .source = ocu_address}, authority,
                        instant{0s}, sent.sink(), [](const jaus::header&, auto) { return message_outcome::unhandled; });
        if (hear(boss_address) != not_controller) FAIL(code << " from another than the controller");
        if (hear(ocu_address) != handled || count() != 2) FAIL(code << " from the controller");
        sent.clear();
    }
}

TEST_CASE("a query, a report and a harmless private message are delivered in every state") {
    static constexpr std::array<std::uint16_t, 1> own{0xD001};
    arm a{{.control = {.harmless = own}}};
    a.put_under_control_of(ocu_address);
    REQUIRE(a.core.change(state_event::emergency));
    const auto hear = [&](std::uint16_t code) {
        return a.hear({.command_code = code, .destination = arm_address, .source = boss_address}, {}, instant{0s},
                      a.sent.sink());
    };
    REQUIRE(hear(0xD001) == handled);
    REQUIRE(a.part.heard == 1);
    REQUIRE(hear(0x2408) == unknown);
    REQUIRE(hear(0x4402) == unknown);
    REQUIRE(hear(0xD002) == not_controller);
}

TEST_CASE("a message that was not executed gets a NAK, and everything is counted") {
    arm a;
    a.put_under_control_of(ocu_address);
    const auto answer_to = [&](const auto& body, const jaus::address& from, component_outcome expected) {
        static std::uint16_t number = 0;
        a.sent.clear();
        CHECK(a.hear(body, from, ack_nak::request, ++number) == expected);
        REQUIRE_FALSE(a.sent.empty());
        const auto last = a.sent.header(a.sent.size() - 1);
        CHECK(last.sequence_number == number);
        CHECK(last.destination == from);
        return last.ack_nak;
    };
    CHECK(answer_to(push, ocu_address, handled) == ack_nak::ack);
    CHECK(answer_to(push, boss_address, not_controller) == ack_nak::nak);
    CHECK(answer_to(jaus::resume{}, ocu_address, handled) == ack_nak::ack);
    CHECK(answer_to(go_on, ocu_address, handled) == ack_nak::ack);
    CHECK(answer_to(jaus::report_travel_speed{}, boss_address, unknown) == ack_nak::nak);
    CHECK(answer_to(jaus::query_component_status{}, boss_address, handled) == ack_nak::ack);
    CHECK(a.sent.size() == 2); // the report, then the ACK
    CHECK(a.sent.header(0).command_code == 0x4002);
    CHECK(a.core.count(handled) == 5); // with the request for control
    CHECK(a.core.count(not_controller) == 1);
    CHECK(a.core.control().refused() == 1);
    CHECK(a.core.count(unknown) == 1);

    const std::array<std::byte, 1> wrong{};
    const jaus::header head{.ack_nak = ack_nak::request,
                            .command_code = 0x0405,
                            .destination = arm_address,
                            .source = ocu_address,
                            .data_size = 1};
    a.sent.clear();
    CHECK(a.hear(head, wrong, instant{0s}, a.sent.sink()) == malformed);
    CHECK(a.sent.header(0).ack_nak == ack_nak::nak);
    CHECK(a.core.count(malformed) == 1);
}

TEST_CASE("a repeated command is acknowledged again and executed once") {
    arm a;
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 7) == handled);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 7) == repeated);
    REQUIRE(a.efforts.size() == 1);
    REQUIRE(a.sent.size() == 2);
    REQUIRE(a.sent[0] == a.sent[1]);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 8) == handled);
    REQUIRE(a.hear(push, ocu_address) == handled);
    REQUIRE(a.hear(push, ocu_address) == handled);
    REQUIRE(a.efforts.size() == 4);
}

TEST_CASE("what a rule refuses is not remembered, and is refused again") {
    arm a;
    a.put_under_control_of(ocu_address);
    for (std::uint16_t i = 1; i != 1000; ++i)
        for (const auto& from : {boss_address, jaus::address{1, 41, 1, 9}, jaus::address{1, 42, 1, 9}})
            REQUIRE(a.hear(push, from, ack_nak::request, i) == not_controller);
    REQUIRE(a.sent.size() == 3 * 999); // a NAK each
    REQUIRE(a.hear(push, boss_address, ack_nak::request, 999) == not_controller);
    for (std::uint16_t i = 1; i != 33; ++i) REQUIRE(a.hear(push, ocu_address, ack_nak::request, i) == handled);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 5) == repeated);
    // Executed, and then no more allowed: its repeat is acknowledged all the same.
    REQUIRE(a.hear(jaus::standby{}, ocu_address) == handled);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 5) == repeated);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 40) == not_ready);
    REQUIRE(a.hear(jaus::resume{}, ocu_address) == handled);
    a.core.reject_control(a.sent.sink());
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 5) == repeated);
    REQUIRE(a.efforts.size() == 32);
}

TEST_CASE("places are kept for the controller, whatever others are allowed to send") {
    arm a; // of 64 places
    std::uint16_t number = 0;
    unsigned taken = 0;
    a.put_under_control_of(ocu_address);
    const auto asks = [&](const jaus::address& from) { // open to all, and refused by their low authority
        return a.hear(jaus::request_component_control{0}, from, ack_nak::request, ++number);
    };
    for (std::uint8_t i = 50; i != 60; ++i)
        for (unsigned j = 0; j != 20; ++j) taken += asks({1, i, 1, 9}) != no_capacity;
    REQUIRE(taken == 48);
    for (std::uint16_t i = 1; i != 17; ++i) REQUIRE(a.hear(push, ocu_address, ack_nak::request, i) == handled);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 17) == no_capacity);
    REQUIRE(asks({1, 61, 1, 9}) == no_capacity);
    REQUIRE(a.hear(stop, {1, 61, 1, 9}, ack_nak::request, 1) == handled);
}

TEST_CASE("the places that the controller has are none of the share of all others") {
    arm a; // of 64 places
    a.put_under_control_of(ocu_address);
    for (std::uint16_t i = 1; i != 33; ++i) REQUIRE(a.hear(push, ocu_address, ack_nak::request, i) == handled);
    for (std::uint8_t i = 50; i != 82; ++i)
        REQUIRE(a.hear(jaus::request_component_control{0}, {1, i, 1, 9}, ack_nak::request, 1) == handled);
    REQUIRE(a.hear(jaus::request_component_control{0}, {1, 82, 1, 9}, ack_nak::request, 1) == no_capacity);
}

TEST_CASE("a command that an actuator executes later is acknowledged after its execution") {
    jaus::component_memory<4, 64, 64> memory{};
    jaus::component core{arm_address, memory, {}, {}};
    core.change(state_event::initialized);
    sent_messages sent;
    int handed_on{};
    const auto hear = [&](const auto& body, std::uint16_t number) {
        const auto bytes = message(
            {.ack_nak = ack_nak::request, .destination = arm_address, .source = ocu_address, .sequence_number = number},
            body);
        const auto m = jaus::split(bytes);
        const auto what = core.on_message(m.header, m.body, instant{0s}, sent.sink(), [&](const jaus::header&, auto) {
            ++handed_on;
            return message_outcome::deferred;
        });
        return std::pair{m.header, what};
    };
    const auto [head, what] = hear(push, 7);
    REQUIRE(what == deferred);
    REQUIRE(hear(push, 7).second == pending);
    REQUIRE(sent.empty());
    REQUIRE(core.finish(head, true, instant{1s}, sent.sink()));
    REQUIRE(sent[0] == from_hex("36 02 05 04 01 20 01 01 01 31 02 03 00 00 07 00"));
    REQUIRE(hear(push, 7).second == repeated);
    REQUIRE(sent[1] == sent[0]);
    REQUIRE(core.finish(hear(push, 8).first, false, instant{1s}, sent.sink()));
    REQUIRE(sent[2] == from_hex("26 02 05 04 01 20 01 01 01 31 02 03 00 00 08 00"));
    REQUIRE(handed_on == 2);
    REQUIRE(core.count(deferred) == 2);
    REQUIRE(core.count(pending) == 1);
}

TEST_CASE("a hook decides the outcome of state commands, after the notification of the new state") {
    message_outcome outcome{message_outcome::deferred};
    std::vector<std::uint16_t> heard; // command codes; FFFFh: a new state
    const auto on_state = [&](primary_status_code, primary_status_code) { heard.push_back(0xFFFF); };
    const auto on_state_command = [&](const jaus::header& head) {
        heard.push_back(head.command_code);
        return outcome;
    };
    jaus::component_memory<4, 64, 64> memory{};
    jaus::component core{arm_address, memory, {.on_state = on_state, .on_state_command = on_state_command}, {}};
    core.change(state_event::initialized);
    heard.clear();
    sent_messages sent;
    std::uint16_t number{};
    const auto hear = [&](const auto& body) {
        const auto bytes = message({.ack_nak = ack_nak::request,
                                    .destination = arm_address,
                                    .source = ocu_address,
                                    .sequence_number = ++number},
                                   body);
        const auto m = jaus::split(bytes);
        return std::pair{m.header,
                         core.on_message(m.header, m.body, instant{0s}, sent.sink(),
                                         [](const jaus::header&, auto) { return message_outcome::unhandled; })};
    };
    const auto [first, what] = hear(stop);
    REQUIRE(what == deferred);
    const auto [second, again] = hear(stop); // in force already, and told all the same
    REQUIRE(again == deferred);
    REQUIRE(heard == std::vector<std::uint16_t>{0xFFFF, 0x0006, 0x0006});
    REQUIRE(core.state() == primary_status_code::emergency);
    REQUIRE(sent.empty());
    REQUIRE(core.finish(first, true, instant{1s}, sent.sink()));
    REQUIRE(sent[0] == from_hex("36 02 06 00 01 20 01 01 01 31 02 03 00 00 01 00"));
    REQUIRE(core.finish(second, false, instant{1s}, sent.sink()));
    REQUIRE(sent[1] == from_hex("26 02 06 00 01 20 01 01 01 31 02 03 00 00 02 00"));

    // What the state refuses, the hook does not hear of.
    REQUIRE(hear(jaus::resume{}).second == refused);
    REQUIRE(heard.size() == 3);
    outcome = message_outcome::refused;
    REQUIRE(hear(go_on).second == refused);
    REQUIRE(sent[3] == from_hex("26 02 07 00 01 20 01 01 01 31 02 03 00 00 04 00"));
    outcome = message_outcome::handled;
    REQUIRE(hear(jaus::resume{}).second == handled);
    REQUIRE(hear(jaus::standby{}).second == handled);
    REQUIRE(hear(jaus::reset{}).second == handled);
    REQUIRE(hear(jaus::shutdown{}).second == handled);
    REQUIRE(heard == std::vector<std::uint16_t>{0xFFFF, 0x0006, 0x0006, 0xFFFF, 0x0007, 0xFFFF, 0x0004, 0xFFFF, 0x0003,
                                                0xFFFF, 0x0005, 0xFFFF, 0x0002});
    REQUIRE(hear(jaus::set_component_authority{1}).second == handled); // none of the state's
    REQUIRE(heard.size() == 13);
}

TEST_CASE("an acknowledgement without a waiting message ends in the core, but proves liveness") {
    arm a{{.control = {.timeout = 1s}}};
    a.put_under_control_of(ocu_address);
    const jaus::header head{
        .ack_nak = ack_nak::ack, .command_code = 0x0405, .destination = arm_address, .source = ocu_address};
    REQUIRE(a.hear(head, {}, instant{900ms}, a.sent.sink()) == unmatched_acknowledgement);
    REQUIRE(a.core.next_event() == instant{1150ms});
    REQUIRE(a.efforts.empty());
    REQUIRE(a.core.send({.destination = ocu_address}, jaus::standby{}, instant{850ms}, a.sent.sink()));
    REQUIRE(a.core.next_event() == instant{1100ms});
}

TEST_CASE("a dropped repeat proves liveness") {
    arm a{{.control = {.timeout = 1s}}};
    a.put_under_control_of(ocu_address);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 7, 100ms) == handled);
    REQUIRE(a.core.next_event() == instant{350ms});
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 7, 300ms) == repeated);
    REQUIRE(a.core.next_event() == instant{550ms});
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 8, 400ms) == handled);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 8, 500ms) == repeated);
    REQUIRE(a.core.next_event() == instant{750ms});
}

TEST_CASE("a large data set, which may have waited in its sender's node, does not prove liveness") {
    arm a{{.control = {.timeout = 1s}}};
    a.put_under_control_of(ocu_address);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 7, 100ms) == handled);
    const std::vector<std::byte> large(jaus::max_body_size + 1);
    a.hear({.command_code = 0xD117, .destination = arm_address, .source = ocu_address}, large, instant{300ms},
           a.sent.sink());
    REQUIRE(a.core.next_event() == instant{350ms});
}

TEST_CASE(
    "an operator that sends no commands keeps control by its heartbeats, one that dies loses it within half a second") {
    lossy_channel channel;
    arm a;
    ocu operator_{ocu_address};
    join(channel, a);
    bool dead = false; // the component: its node lives
    channel.listen(ocu_address, [&](const jaus::header& head, std::span<const std::byte> body) {
        if (!dead) operator_.hear(head, body, channel.now, channel.sink());
    });
    operator_.control.ask(5, channel.now, channel.sink());
    channel.run(60s);
    REQUIRE(operator_.control.state() == control_state::held);
    REQUIRE(a.core.control().controls(ocu_address));
    REQUIRE(a.core.count(unknown) == 0); // the pulses are nobody else's business
    REQUIRE(operator_.core.count(unknown) == 0);
    REQUIRE(operator_.reports.empty());

    dead = true;
    channel.run(60s + 501ms); // an answer was still on its way
    REQUIRE_FALSE(a.core.control().controller());
    REQUIRE(a.hooks.changes == std::vector{jaus::control_change::granted, jaus::control_change::lost});
    REQUIRE(a.hooks.controllers.back() == std::nullopt);
}

TEST_CASE("a unit whose release was lost is still queried for its heartbeat, and releases again") {
    lossy_channel channel;
    arm a;
    ocu operator_{ocu_address};
    join(channel, a);
    join(channel, operator_);
    operator_.control.ask(5, channel.now, channel.sink());
    channel.run(1s);
    operator_.control.release([](std::span<const std::byte>) {});
    channel.run(1200ms);
    REQUIRE_FALSE(a.core.control().controller());
    REQUIRE(a.hooks.changes.back() == jaus::control_change::released);
    REQUIRE(operator_.control.state() == control_state::none);
    // The question itself is answered by another part, or by the application: it may have come for another reason.
    REQUIRE(operator_.reports == std::vector<std::uint16_t>{0x2202});
}

TEST_CASE("a heartbeat query is answered while control is wanted, and with some releases after that") {
    sent_messages sent;
    jaus::held_control control{ocu_address, arm_address};
    const auto ask = [&](const jaus::address& from) {
        const auto bytes = message({.destination = ocu_address, .source = from}, jaus::query_heartbeat_pulse{});
        const auto m = jaus::split(bytes);
        sent.clear();
        return control.on_message(m.header, m.body, instant{0s}, sent.sink());
    };
    REQUIRE(ask(arm_address) == message_outcome::unhandled);
    REQUIRE(sent.empty());
    control.ask(1, instant{0s}, sent.sink());
    REQUIRE(ask(boss_address) == message_outcome::unhandled);
    REQUIRE(ask(arm_address) == message_outcome::handled);
    REQUIRE(sent[0] == from_hex("06 02 02 42 01 31 02 03 01 20 01 01 00 00 00 00"));
    control.release(sent.sink());
    std::size_t releases = 0;
    for (int i = 0; i != 100; ++i) {
        REQUIRE(ask(arm_address) == message_outcome::unhandled);
        for (std::size_t k = 0; k != sent.size(); ++k) releases += sent.header(k).command_code == 0x000E;
    }
    REQUIRE(releases == 8);
}

TEST_CASE("every message of a controller proves liveness, also a Clear Emergency") {
    arm a{{.control = {.timeout = 1s}}};
    a.put_under_control_of(ocu_address);
    REQUIRE(a.hear(stop, ocu_address, ack_nak::none, 0, 300ms) == handled);
    REQUIRE(a.core.next_event() == instant{550ms});
    REQUIRE(a.hear(go_on, ocu_address, ack_nak::none, 0, 600ms) == handled);
    REQUIRE(a.core.next_event() == instant{850ms});
}

TEST_CASE("parts handle messages after the core, and get their timer events") {
    arm a;
    a.part.due = instant{3s};
    REQUIRE(a.core.next_event() == instant{3s});
    a.core.on_time(instant{2s}, a.sent.sink());
    REQUIRE(a.part.ticks == 0);
    a.core.on_time(instant{3s}, a.sent.sink());
    REQUIRE(a.part.ticks == 1);
    const jaus::header head{.command_code = 0xD001, .destination = arm_address, .source = ocu_address};
    REQUIRE(a.hear(head, {}, instant{0s}, a.sent.sink()) == handled);
    REQUIRE(a.part.heard == 1);
    a.part.code = 0x0003;
    REQUIRE(a.hear(jaus::standby{}, ocu_address) == handled); // the core's
    REQUIRE(a.part.heard == 1);
}

TEST_CASE("a hook without a result that refers to no function does nothing") {
    STATIC_REQUIRE([] {
        jaus::hook<void(int)>{}(1);
        return !jaus::hook<void(int)>{};
    }());
}

TEST_CASE("service connections, events, a description and control of another are parts of a component") {
    std::array<std::byte, 512> service_memory{}, event_memory{}, description_memory{};
    const std::array service_reports{jaus::connectable_report{0x440A}};
    const std::array event_reports{jaus::eventful_report{0x440A}};
    const auto fill = [](std::uint16_t, std::uint32_t, std::span<std::byte> body) -> std::optional<std::size_t> {
        return wire::encode(jaus::report_travel_speed{5.0}, body)->size();
    };
    const auto fill_event = [](std::uint16_t, std::span<const std::byte>,
                               std::span<std::byte> body) -> std::optional<std::size_t> {
        return wire::encode(jaus::report_travel_speed{5.0}, body)->size();
    };
    jaus::service_connections<4> connections{arm_address, service_reports, fill, service_memory};
    jaus::events<4> events{arm_address, event_reports, fill_event, event_memory};
    jaus::described_component description{arm_address, {}, {.to = {1, 1, 2, 3}, .period = 1s}, description_memory};
    jaus::held_control gripper{arm_address, {1, 50, 2, 3}};
    jaus::component_memory<> memory{};
    jaus::component core{arm_address, memory, {}, {}, connections, events, description, gripper};
    sent_messages sent;
    const auto hear = [&](const auto& body) {
        const auto bytes =
            message({.ack_nak = ack_nak::request, .destination = arm_address, .source = ocu_address}, body);
        const auto m = jaus::split(bytes);
        sent.clear();
        return core.on_message(m.header, m.body, instant{10s}, sent.sink(),
                               [](const jaus::header&, auto) { return message_outcome::unhandled; });
    };
    core.on_time(instant{10s}, sent.sink()); // the first heartbeat
    REQUIRE(sent.header(0).command_code == 0x4202);
    REQUIRE(core.next_event() == instant{11s});

    REQUIRE(hear(jaus::create_service_connection{.command_code = 0x440A, .requested_periodic_update_rate = 10}) ==
            handled);
    REQUIRE(sent.size() == 2);
    REQUIRE(sent.header(0).command_code == 0x0009);
    REQUIRE(sent.header(1).ack_nak == ack_nak::ack);
    REQUIRE(core.next_event() == instant{10s});
    sent.clear();
    core.on_time(instant{10s}, sent.sink());
    REQUIRE(sent.header(0).command_code == 0x440A);

    REQUIRE(hear(jaus::create_event{.message_code = 0x440A, .event_type = jaus::event_type::every_change}) == handled);
    REQUIRE(sent.header(0).command_code == 0x01F3);
    REQUIRE(hear(jaus::query_heartbeat_pulse{}) == handled);
    REQUIRE(hear(jaus::confirm_component_control{}) == unknown); // of one that the arm has not asked
    gripper.ask(1, instant{10s}, sent.sink());
    core.on_lost(ocu_address);
    REQUIRE(std::ranges::none_of(connections.connections(), [](const auto& c) { return c.command_code != 0; }));
    REQUIRE(std::ranges::none_of(events.records(), [](const auto& e) { return e.message_code != 0; }));
    REQUIRE(gripper.state() == control_state::asking);
}

TEST_CASE("the application can take control back, and end any emergency") {
    arm a;
    a.put_under_control_of(ocu_address);
    a.hear(stop, boss_address);
    a.core.reject_control(a.sent.sink());
    REQUIRE(a.sent.header(0).command_code == 0x0010);
    REQUIRE(a.hooks.controllers == std::vector<std::optional<jaus::controller>>{std::nullopt});
    a.core.end_emergency();
    REQUIRE(a.hooks.states.back() == std::pair{primary_status_code::emergency, primary_status_code::standby});
}

TEST_CASE("the application sets the clock and the secondary status") {
    arm a;
    REQUIRE(a.core.clock().set(jaus::civil_time{std::chrono::sys_days{std::chrono::year{2026} / 2 / 3}}, instant{0s}));
    a.core.set_secondary_status(7);
    REQUIRE(a.hear(jaus::query_time{2}, ocu_address) == handled);
    REQUIRE(a.sent.body<jaus::report_time>(0).date_stamp == jaus::date_stamp{3, 2, 26});
    REQUIRE(a.hear(jaus::query_component_status{}, ocu_address) == handled);
    REQUIRE(a.sent.body<jaus::report_component_status>(1).secondary_status_code == 7);
}

TEST_CASE("over a bad channel every acknowledged command of the controller was executed once") {
    const unsigned seed = GENERATE(range(1u, 9u));
    CAPTURE(seed);
    lossy_channel channel{seed};
    arm a{{.control = {.timeout = 0s}}}; // the channel is too bad for any that is not longer than its silences
    ocu operator_{ocu_address, {.acknowledgement = {.retry = {.interval = 100ms, .attempts = 9}}}};
    ocu intruder{boss_address, {.acknowledgement = {.retry = {.interval = 100ms, .attempts = 9}}}};
    join(channel, a);
    join(channel, operator_);
    join(channel, intruder);
    operator_.control.ask(10, channel.now, channel.sink());
    channel.run(10ms);
    REQUIRE(operator_.control.state() == control_state::held);

    channel.faults = {.lose = 30, .duplicate = 20, .delay = 40};
    std::size_t sent = 0;
    for (int i = 0; i != 300; ++i) {
        // The effort tells which command it is.
        const double effort = i / 4.0;
        if (operator_.core.send({.destination = arm_address},
                                jaus::set_wrench_effort{.propulsive_linear_effort_x = effort}, channel.now,
                                channel.sink()))
            ++sent;
        static_cast<void>(intruder.core.send({.destination = arm_address}, push, channel.now, channel.sink()));
        channel.run(channel.now + 500ms);
    }
    channel.run(channel.now + 1h);
    REQUIRE(sent == 300);
    REQUIRE(a.efforts.size() <= sent);
    auto obeyed = a.efforts;
    std::ranges::sort(obeyed);
    REQUIRE(std::ranges::adjacent_find(obeyed) == obeyed.end());
    const auto count = [](const ocu& o, delivered what) {
        return static_cast<std::size_t>(
            std::ranges::count(o.hooks.outcomes, what, &std::pair<std::uint16_t, delivered>::second));
    };
    REQUIRE(operator_.hooks.outcomes.size() == sent);
    REQUIRE(count(operator_, delivered::refused) == 0);
    REQUIRE(count(operator_, delivered::acknowledged) <= obeyed.size());
    REQUIRE(count(operator_, delivered::acknowledged) > 280);
    REQUIRE(count(intruder, delivered::acknowledged) == 0);
    REQUIRE(count(intruder, delivered::refused) > 250);
    REQUIRE(a.core.count(repeated) > 0);
}

TEST_CASE("for random messages, commands are executed in Ready only, from the controller if there is one, and any "
          "sender can stop") {
    std::mt19937 random{7};
    const std::array codes{0x0001, 0x0002, 0x0003, 0x0004, 0x0005, 0x0006, 0x0007, 0x0009, 0x000D, 0x000E, 0x000F,
                           0x0010, 0x0011, 0x0405, 0x2001, 0x2002, 0x200D, 0x2011, 0x2405, 0x4002, 0xD001, 0xFFFF};
    std::map<component_outcome, int> outcomes;
    for (int run = 0; run != 300; ++run) {
        arm a{{.after = jaus::after_emergency::resume, .control = {.timeout = 2s}}};
        jauscat::time_point now{};
        for (int i = 0; i != 200; ++i) {
            now += std::chrono::milliseconds{random() % 50};
            a.core.on_time(now, a.sent.sink());
            if (random() % 50 == 0) a.core.on_lost({1, static_cast<std::uint8_t>(32 + random() % 3), 1, 1});
            std::array<std::byte, 8> bytes{};
            for (auto& b : bytes) b = static_cast<std::byte>(random() % 4); // often a body, often none
            std::size_t size = random() % 3 == 0 ? random() % bytes.size() : 0;
            auto code = static_cast<std::uint16_t>(codes[random() % codes.size()]);
            if (code == 0x0002 && random() % 8 != 0) code = 0x0006; // a shutdown ends the story
            if ((code == 0x0006 || code == 0x0007) && random() % 2 == 0) bytes[0] = std::byte{1}, size = 2;
            if (code == 0x000D || code == 0x0001) size = 1;
            if (code == 0x0405) bytes[0] = bytes[1] = std::byte{}, size = 2;
            const jaus::header head{.ack_nak = static_cast<ack_nak>(random() % 4),
                                    .command_code = code,
                                    .destination = arm_address,
                                    .source = {1, static_cast<std::uint8_t>(32 + random() % 3), 1, 1},
                                    .data_size = static_cast<std::uint16_t>(size),
                                    .sequence_number = static_cast<std::uint16_t>(random() % 1000)};
            const auto body = std::span{bytes}.first(size);
            const auto before = a.core.state();
            const auto controller = a.core.control().controller();
            const bool is_or_may_be_controller = !controller || controller->address == head.source;
            a.sent.clear();
            const auto efforts = a.efforts.size();
            const auto what = a.hear(head, body, now, a.sent.sink());
            ++outcomes[what];

            if (a.efforts.size() != efforts) {
                REQUIRE(before == primary_status_code::ready);
                REQUIRE(is_or_may_be_controller);
                REQUIRE(what == handled);
            }
            if (code == 0x0006 && !jaus::is_acknowledgement(head)) {
                REQUIRE((what == handled || what == stopped_on_invalid_emergency));
                REQUIRE((what == handled) == jaus::says_emergency(body));
                REQUIRE((a.core.state() == primary_status_code::emergency || before == primary_status_code::shutdown));
            }
            const bool done = what == handled || what == stopped_on_invalid_emergency;
            if (!done) REQUIRE(a.core.state() == before);
            if (what == not_controller) REQUIRE_FALSE(is_or_may_be_controller);
            if (before == primary_status_code::emergency && a.core.state() != before)
                REQUIRE((code == 0x0002 || code == 0x0007));
            // An acknowledgement that was asked for is the last that is sent, and says whether it was taken.
            if (head.ack_nak == ack_nak::request && what != no_capacity) {
                REQUIRE_FALSE(a.sent.empty());
                const auto last = a.sent.header(a.sent.size() - 1);
                REQUIRE(jaus::is_acknowledgement(last));
                if (what != repeated) REQUIRE((last.ack_nak == ack_nak::ack) == done);
            }
        }
    }
    // All of it has happened.
    for (const auto what : {handled, stopped_on_invalid_emergency, refused, malformed, unknown, not_controller,
                            not_ready, repeated, unmatched_acknowledgement})
        REQUIRE(outcomes[what] > 0);
}

TEST_CASE("an action of the component itself makes a message numbered 0 new") {
    arm a;
    const auto resume = [&] { return a.hear(jaus::resume{}, ocu_address, ack_nak::request, 0); };
    REQUIRE(resume() == handled);
    REQUIRE(resume() == repeated);
    a.core.change(state_event::failed); // what it drives is lost
    a.sent.clear();
    REQUIRE(resume() == refused);
    REQUIRE(a.sent.size() == 0); // it may be the repeat of the one that was obeyed
    a.core.change(state_event::reset);
    a.core.change(state_event::initialized);
    REQUIRE(resume() == handled);
    REQUIRE(resume() == repeated);
    a.put_under_control_of(boss_address);
    a.core.reject_control(a.sent.sink());
    REQUIRE(resume() == handled);
}

TEST_CASE("a sender without control is watched from its motion command on, and lost by silence as a controller is") {
    for (const auto period : {500ms, 3000ms}) {
        arm a{{.control = {.timeout = period}}};
        REQUIRE(a.hear(push, ocu_address, ack_nak::none, 0, 10s) == handled);
        a.sent.clear();
        for (int i = 1; i != 4; ++i) {
            REQUIRE(a.core.next_event() == instant{10s + i * period / 4});
            a.core.on_time(instant{10s + i * period / 4}, a.sent.sink());
            REQUIRE(a.sent.size() == static_cast<std::size_t>(i));
            REQUIRE(a.sent.header(static_cast<std::size_t>(i) - 1).command_code ==
                    jaus::command_code_of<jaus::query_heartbeat_pulse>);
        }
        REQUIRE(a.hooks.changes.empty());
        a.core.on_time(instant{10s + period}, a.sent.sink());
        REQUIRE(a.hooks.changes == std::vector{jaus::control_change::lost});
        REQUIRE(a.hooks.controllers == std::vector<std::optional<jaus::controller>>{std::nullopt});
        a.core.on_time(instant{20s}, a.sent.sink());
        REQUIRE(a.hooks.changes.size() == 1); // told once
        // The next command is watched again.
        REQUIRE(a.hear(push, ocu_address, ack_nak::none, 0, 30s) == handled);
        a.core.on_time(instant{30s + period}, a.sent.sink());
        REQUIRE(a.hooks.changes.size() == 2);
    }
}

TEST_CASE("any message of a sender without control counts as its life") {
    arm a;
    const jaus::header pulse{.command_code = 0x4202, .destination = arm_address, .source = ocu_address};
    REQUIRE(a.hear(push, ocu_address) == handled);
    a.core.on_time(instant{130ms}, a.sent.sink());
    REQUIRE(a.hear(pulse, {}, 140ms, a.sent.sink()) == handled); // asked for: the application does not get it
    REQUIRE(a.hear(pulse, {}, 140ms, a.sent.sink()) == unknown);
    a.core.on_time(instant{639ms}, a.sent.sink());
    REQUIRE(a.hooks.changes.empty());
    REQUIRE(a.hear(jaus::query_wrench_effort{}, ocu_address, ack_nak::none, 0, 639ms) == handled);
    a.core.on_time(instant{1138ms}, a.sent.sink());
    REQUIRE(a.hooks.changes.empty());
    REQUIRE(a.hear(push, boss_address, ack_nak::none, 0, 1138ms) == handled);
    a.core.on_time(instant{1200ms}, a.sent.sink());
    REQUIRE(a.hooks.changes.empty()); // the other sender is not the one whose command is in force any more
    a.core.on_time(instant{1638ms}, a.sent.sink());
    REQUIRE(a.hooks.changes == std::vector{jaus::control_change::lost});
}

TEST_CASE("a sender of many commands is watched once") {
    arm a;
    for (const auto now : {0ms, 100ms, 200ms}) REQUIRE(a.hear(push, ocu_address, ack_nak::none, 0, now) == handled);
    REQUIRE(a.hear(jaus::query_wrench_effort{}, ocu_address, ack_nak::none, 0, 400ms) == handled);
    a.core.on_time(instant{899ms}, a.sent.sink());
    CHECK(a.hooks.changes.empty());
    a.core.on_time(instant{900ms}, a.sent.sink());
    CHECK(a.hooks.changes == std::vector{jaus::control_change::lost});
}

TEST_CASE("every message that moves something is watched, also a private one and a large one, and no other is") {
    struct sent_command {
        std::uint16_t code;
        std::size_t size;
        bool is_watched;
    };
    const std::array<std::uint16_t, 1> harmless{0xD00D};
    for (const auto& [code, size, is_watched] : std::to_array<sent_command>({{0x0405, 2, true},
                                                                             {0x0602, 2, true},
                                                                             {0xD005, 0, true},
                                                                             {0x7000, 1, true},
                                                                             {0xD005, 9000, true},
                                                                             {0xD00D, 4, false},
                                                                             {0x2405, 2, false},
                                                                             {0x4405, 2, false},
                                                                             {0x0E02, 2, false}})) {
        CAPTURE(code, size);
        arm a{{.control = {.harmless = harmless}}};
        const std::vector<std::byte> body(size);
        for (const auto outcome : {message_outcome::unhandled, message_outcome::refused, message_outcome::malformed,
                                   message_outcome::deferred, message_outcome::handled}) {
            a.core.on_message({.command_code = code, .destination = arm_address, .source = ocu_address}, body,
                              instant{1s}, a.sent.sink(), [&](const jaus::header&, auto) { return outcome; });
            const bool is_obeyed = outcome == message_outcome::deferred || outcome == message_outcome::handled;
            CHECK(a.core.control().is_moved_by(ocu_address) == (is_watched && is_obeyed));
        }
        a.core.on_time(instant{1500ms}, a.sent.sink());
        CHECK(a.hooks.changes.size() == (is_watched ? 1 : 0));
    }
}

TEST_CASE("a deferred command is watched before it is executed, and replaces others when it is") {
    arm a;
    const auto tell = [&](const jaus::address& from, instant now, message_outcome outcome) {
        const jaus::header head{.command_code = 0x0405, .destination = arm_address, .source = from};
        a.core.on_message(head, {}, now, a.sent.sink(), [&](const jaus::header&, auto) { return outcome; });
        return head;
    };
    const auto finish = [&](const jaus::header& head, bool executed, instant now) {
        static_cast<void>(a.core.finish(head, executed, now, a.sent.sink()));
    };
    const auto loses = [&](instant now) {
        const auto before = a.hooks.changes.size();
        a.core.on_time(now, a.sent.sink());
        return a.hooks.changes.size() != before;
    };
    SECTION("not executed: both senders move it, for all that is known") {
        tell(ocu_address, 1s, message_outcome::handled);
        finish(tell(boss_address, 1400ms, message_outcome::deferred), false, 1450ms);
        REQUIRE_FALSE(loses(1499ms));
        REQUIRE(loses(1500ms));
        REQUIRE_FALSE(loses(5s));
    }
    SECTION("not executed, and no other one: it moves it, for all that is known") {
        finish(tell(boss_address, 1s, message_outcome::deferred), false, 1100ms);
        REQUIRE_FALSE(loses(1499ms));
        REQUIRE(loses(1500ms));
    }
    SECTION("executed: only the last one moves it") {
        tell(ocu_address, 1s, message_outcome::handled);
        finish(tell(boss_address, 1400ms, message_outcome::deferred), true, 1450ms);
        REQUIRE_FALSE(loses(1899ms));
        REQUIRE(loses(1900ms));
    }
    SECTION("one that waits may move it soon") {
        const auto waits = tell(boss_address, 1s, message_outcome::deferred);
        tell(ocu_address, 1400ms, message_outcome::handled);
        REQUIRE(a.core.control().is_moved_by(boss_address));
        finish(waits, true, 1450ms);
        REQUIRE_FALSE(a.core.control().is_moved_by(ocu_address));
        REQUIRE(loses(1500ms));
    }
    SECTION("as long as one of its commands waits") {
        const auto first = tell(boss_address, 1s, message_outcome::deferred);
        const auto second = tell(boss_address, 1s, message_outcome::deferred);
        finish(first, true, 1100ms);
        tell(ocu_address, 1200ms, message_outcome::handled);
        REQUIRE(a.core.control().is_moved_by(boss_address));
        SECTION("its sender is watched") { REQUIRE(loses(1500ms)); }
        SECTION("and no longer") {
            finish(second, false, 1300ms);
            tell(ocu_address, 1400ms, message_outcome::handled);
            REQUIRE_FALSE(loses(1500ms));
        }
    }
    SECTION("after a stop it is not watched for a command that was refused for it") {
        const auto waits = tell(boss_address, 1s, message_outcome::deferred);
        a.hear(jaus::standby{}, boss_address, ack_nak::none, 0, 1s);
        finish(waits, false, 1s);
        REQUIRE_FALSE(loses(5s));
    }
    SECTION("of more senders than are watched, the last ones are") {
        for (std::uint8_t i = 1; i != 100; ++i)
            tell({1, 32, 1, i}, instant{1s + i * 1ms}, i == 1 ? message_outcome::handled : message_outcome::deferred);
        REQUIRE(a.core.control().is_moved_by({1, 32, 1, 1})); // its command is in force
        REQUIRE(a.core.control().is_moved_by({1, 32, 1, 99}));
        REQUIRE(loses(1501ms));
    }
}

TEST_CASE("what a sender has left in force is watched when another component has control, until that moves something") {
    for (const bool moves : {false, true}) {
        CAPTURE(moves);
        arm a;
        REQUIRE(a.hear(push, ocu_address) == handled);
        a.hear(jaus::request_component_control{9}, boss_address, ack_nak::none, 0, 100ms);
        if (moves) REQUIRE(a.hear(push, boss_address, ack_nak::none, 0, 200ms) == handled);
        a.hear(jaus::query_wrench_effort{}, boss_address, ack_nak::none, 0, 499ms);
        a.hooks = {};
        a.core.on_time(instant{500ms}, a.sent.sink());
        REQUIRE(a.core.control().controls(boss_address));
        REQUIRE(a.hooks.changes.size() == (moves ? 0 : 1));
        if (moves) continue;
        REQUIRE(a.hooks.changes.front() == jaus::control_change::lost);
        REQUIRE(a.hooks.controllers.front()->address == boss_address);
    }
}

TEST_CASE("what a controller leaves in force is watched after its control has ended") {
    for (const bool is_released : {true, false}) {
        CAPTURE(is_released);
        arm a;
        a.put_under_control_of(ocu_address);
        REQUIRE(a.hear(push, ocu_address, ack_nak::none, 0, 100ms) == handled);
        if (is_released)
            a.hear(jaus::release_component_control{}, ocu_address, ack_nak::none, 0, 300ms);
        else
            a.hear(jaus::request_component_control{255}, boss_address, ack_nak::none, 0, 300ms);
        a.hooks = {};
        a.hear(jaus::query_wrench_effort{}, boss_address, ack_nak::none, 0, 599ms);
        a.core.on_time(instant{599ms}, a.sent.sink());
        REQUIRE(a.hooks.changes.empty());
        a.core.on_time(instant{is_released ? 799ms : 600ms}, a.sent.sink());
        REQUIRE(a.hooks.changes.empty() == is_released);
        a.core.on_time(instant{800ms}, a.sent.sink());
        REQUIRE(a.hooks.changes.size() == 1);
        REQUIRE(a.hooks.changes.front() == jaus::control_change::lost);
    }
}

TEST_CASE("what a controller leaves in force is watched after the component has taken control back") {
    arm a;
    a.put_under_control_of(ocu_address);
    REQUIRE(a.hear(push, ocu_address, ack_nak::none, 0, 100ms) == handled);
    a.core.reject_control(a.sent.sink());
    REQUIRE(a.hooks.changes == std::vector{jaus::control_change::rejected});
    REQUIRE(a.core.control().is_moved_by(ocu_address));
    a.core.on_time(instant{599ms}, a.sent.sink());
    REQUIRE(a.hooks.changes.size() == 1);
    a.core.on_time(instant{600ms}, a.sent.sink());
    REQUIRE(a.hooks.changes.back() == jaus::control_change::lost);
}

TEST_CASE("a sender that takes control is watched once, and right after its loss the next sender is") {
    arm a;
    REQUIRE(a.hear(push, ocu_address) == handled);
    REQUIRE(a.hear(jaus::request_component_control{9}, ocu_address, ack_nak::none, 0, 100ms) == handled);
    a.sent.clear();
    a.hooks = {};
    a.core.on_time(instant{225ms}, a.sent.sink());
    REQUIRE(a.sent.size() == 1); // one query
    a.core.on_time(instant{600ms}, a.sent.sink());
    REQUIRE(a.hooks.changes == std::vector{jaus::control_change::lost});
    REQUIRE(a.hear(push, boss_address, ack_nak::none, 0, 600ms) == handled);
    a.core.on_time(instant{1100ms}, a.sent.sink());
    REQUIRE(a.hooks.changes.size() == 2);
}

TEST_CASE("a state in which nothing moves ends the watch of senders") {
    for (const int way : {0, 1, 2, 3, 4}) {
        CAPTURE(way);
        arm a;
        REQUIRE(a.hear(push, ocu_address) == handled);
        if (way == 0) a.hear(jaus::standby{}, boss_address);
        if (way == 1) a.hear(stop, boss_address);
        if (way == 2) a.core.at_rest();
        if (way == 3) a.hear(jaus::reset{}, boss_address);
        if (way == 4) a.hear(jaus::shutdown{}, boss_address);
        a.sent.clear();
        a.core.on_time(instant{1s}, a.sent.sink());
        REQUIRE(a.sent.empty());
        REQUIRE(a.hooks.changes.empty());
    }
}

TEST_CASE("a sender whose node is lost is lost at once, and the same command is a new one then") {
    arm a{{.control = {.timeout = 0s}}};
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 0) == handled);
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 0) == repeated);
    a.core.on_lost({255, 255, 2, 1});
    REQUIRE(a.hooks.changes.empty());
    a.core.on_lost({255, 255, ocu_address.node, ocu_address.subsystem});
    REQUIRE(a.hooks.changes == std::vector{jaus::control_change::lost});
    REQUIRE(a.hear(push, ocu_address, ack_nak::request, 0) == handled);
}

TEST_CASE("motion without control is refused, or not watched, by option") {
    using enum jaus::motion_without_control;
    arm strict{{.control = {.without_control = refused}}};
    REQUIRE(strict.hear(push, ocu_address) == not_controller);
    REQUIRE(strict.hear(jaus::query_wrench_effort{}, ocu_address) == handled);
    REQUIRE(strict.hear(jaus::standby{}, ocu_address) == handled); // it moves nothing
    REQUIRE(strict.hear(jaus::resume{}, ocu_address) == handled);
    strict.put_under_control_of(ocu_address);
    REQUIRE(strict.hear(push, ocu_address) == handled);
    REQUIRE(strict.hear(jaus::release_component_control{}, ocu_address) == handled);
    REQUIRE(strict.hear(push, ocu_address) == not_controller);
    strict.hooks = {};
    strict.core.on_time(instant{500ms}, strict.sent.sink());
    REQUIRE(strict.hooks.changes == std::vector{jaus::control_change::lost}); // what it has left in force

    arm lax{{.control = {.without_control = unwatched}}};
    REQUIRE(lax.hear(push, ocu_address) == handled);
    lax.core.on_time(instant{10s}, lax.sent.sink());
    lax.core.on_lost(ocu_address);
    REQUIRE(lax.hooks.changes.empty());
    REQUIRE(lax.sent.empty());
    lax.put_under_control_of(ocu_address);
    lax.core.on_time(instant{10s}, lax.sent.sink());
    REQUIRE(lax.hooks.changes == std::vector{jaus::control_change::lost});
}

TEST_CASE("commands are not repeated after Reject Component Control, but what any sender may send is") {
    ocu operator_{ocu_address};
    sent_messages sent{};
    const auto send = [&](const jaus::address& to, const auto& body) {
        REQUIRE(operator_.core.send({.destination = to}, body, instant{0s}, sent.sink()));
    };
    send(arm_address, push);
    send(arm_address, jaus::standby{});
    send(arm_address, stop);
    send(arm_address, jaus::query_wrench_effort{});
    send(boss_address, push);
    send({2, arm_address.component, arm_address.node, arm_address.subsystem}, push); // another instance
    sent.clear();
    operator_.hear({.command_code = jaus::command_code_of<jaus::reject_component_control>,
                    .destination = ocu_address,
                    .source = arm_address},
                   {}, 100ms, sent.sink());
    REQUIRE(operator_.hooks.outcomes == std::vector<std::pair<std::uint16_t, delivered>>{
                                            {0x0405, delivered::control_lost}, {0x0003, delivered::control_lost}});
    operator_.core.on_time(instant{250ms}, sent.sink());
    REQUIRE(sent.size() == 4);
}
