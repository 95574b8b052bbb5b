// Each check of the model can fail: it is shown what must not be.
#include "simulation/idle_process.hpp"
#include "simulation/model.hpp"
#include "support/catch.hpp"

using namespace simulation;
using namespace std::chrono_literals;

namespace {

constexpr jaus::address robot_id{1, 33, 1, 2}, operator_id{1, 32, 1, 1}, other_id{1, 32, 1, 4};

/// A robot, its operator and another one; all that they do is said by the test.
struct stage {
    world w{1, 0};
    network n{w};
    idle_process robot{w, n, "robot"}, unit{w, n, "operator"}, other_unit{w, n, "other operator"};
    model m{w, n};
    std::uint8_t actuator{m.add_actuator(robot, robot_id, robot.number(), 500ms)};
    std::uint8_t sender{m.add_sender(unit, operator_id)}, other{m.add_sender(other_unit, other_id)};
    std::uint16_t number{1};

    stage() {
        for (process* one : {&robot, &unit, &other_unit}) one->start();
        m.starts(actuator);
        m.enters(actuator, jaus::primary_status_code::initialize, jaus::primary_status_code::ready);
    }
    /// The message as it is handed over, with the number of the model's.
    struct sent {
        std::uint32_t message;
        jaus::header head;
    };
    template <class T> sent send(std::uint8_t who, const T& body, jaus::ack_nak how = jaus::ack_nak::request) {
        sent made{};
        made.head = {.ack_nak = how,
                     .command_code = jaus::command_code_of<T>,
                     .destination = robot_id,
                     .source = who == sender ? operator_id : other_id,
                     .sequence_number = number++};
        REQUIRE(jaus::put(made.head, body, [&](bytes whole) { made.message = m.hands_over(who, whole); }));
        return made;
    }
    template <class T> void answer(const jaus::header& request, const T& body) {
        REQUIRE(jaus::answer(request, robot_id, body, [&](bytes whole) { m.answers(actuator, whole); }));
    }
    void acknowledge(const sent& one, jaus::ack_nak how = jaus::ack_nak::ack) {
        REQUIRE(jaus::acknowledge(one.head, robot_id, how, [&](bytes whole) { m.answers(actuator, whole); }));
    }
    void refuse(const sent& one) {
        m.arrives(actuator, one.message, one.head);
        acknowledge(one, jaus::ack_nak::nak);
        m.handled(actuator);
    }
    /// It comes, `work()` is done, and it is acknowledged.
    void take(const sent& one, auto&& work) {
        m.arrives(actuator, one.message, one.head);
        work();
        if (one.head.ack_nak == jaus::ack_nak::request) acknowledge(one);
        m.handled(actuator);
    }
    void take_control(std::uint8_t who) {
        const auto asked = send(who, jaus::request_component_control{1}, jaus::ack_nak::none);
        m.arrives(actuator, asked.message, asked.head);
        answer(asked.head, jaus::confirm_component_control{jaus::component_control_response::control_accepted});
        m.handled(actuator);
    }
    command_number move(std::uint8_t who) {
        const auto command = m.new_command();
        take(send(who, efforts_of<jaus::set_wrench_effort>(command)), [&] { m.executes(actuator, command); });
        return command;
    }
    void pass(simulation::time how_long) {
        w.run(w.now() + how_long);
        m.check();
    }
    [[nodiscard]] std::optional<contract> broken() const {
        return w.broken() ? std::optional{w.broken()->point} : std::nullopt;
    }
};

} // namespace

TEST_CASE("correct behaviour violates no rule") {
    stage s;
    s.take_control(s.sender);
    s.move(s.sender);
    s.take(s.send(s.sender, jaus::standby{}), [&] {
        s.m.enters(s.actuator, jaus::primary_status_code::ready, jaus::primary_status_code::standby);
        s.m.rests(s.actuator);
    });
    s.pass(1s);
    REQUIRE_FALSE(s.broken());
}

TEST_CASE("S1 detects an acknowledgement of a message that was not executed") {
    stage s;
    s.take(s.send(s.sender, efforts_of<jaus::set_wrench_effort>(s.m.new_command())), [] {});
    REQUIRE(s.broken() == contract::s1);
}

TEST_CASE("S1 detects an acknowledgement that was not sent for the sender's message") {
    stage s;
    const auto one = s.send(s.sender, efforts_of<jaus::set_wrench_effort>(s.m.new_command()));
    s.m.learns(s.sender, one.head, true);
    REQUIRE(s.broken() == contract::s1);
}

TEST_CASE("S1 detects a command that is executed twice") {
    stage s;
    const auto command = s.m.new_command();
    const auto one = s.send(s.sender, efforts_of<jaus::set_wrench_effort>(command));
    s.pass(1ms);
    s.take(one, [&] { s.m.executes(s.actuator, command); });
    REQUIRE_FALSE(s.broken());
    s.take(one, [&] { s.m.executes(s.actuator, command); });
    REQUIRE(s.broken() == contract::s1);
}

TEST_CASE("S1 detects a NAK for an executed message") {
    stage s;
    s.pass(1ms);
    const auto command = s.m.new_command();
    const auto one = s.send(s.sender, efforts_of<jaus::set_wrench_effort>(command));
    s.m.arrives(s.actuator, one.message, one.head);
    s.m.executes(s.actuator, command);
    s.acknowledge(one, jaus::ack_nak::nak);
    s.m.handled(s.actuator);
    REQUIRE(s.broken() == contract::s1);
}

TEST_CASE("S1 detects an acknowledged large data set that was not received") {
    stage s;
    const jaus::header head{.ack_nak = jaus::ack_nak::request, .command_code = large_code, .destination = robot_id};
    s.m.sends_large(s.sender, head, 1);
    s.m.learns_large(s.sender, head, jaus::delivered::acknowledged);
    REQUIRE(s.broken() == contract::s1);
}

TEST_CASE("S2 detects an acknowledged stop order without a stop") {
    stage s;
    s.take(s.send(s.sender, jaus::standby{}), [] {});
    REQUIRE(s.broken() == contract::s2);
}

TEST_CASE("S2 checks Standby with the number 0 that is acknowledged after 64 other messages and a refused Standby") {
    stage s;
    const auto send_standby = [&] {
        s.number = 0;
        return s.send(s.sender, jaus::standby{});
    };
    const auto first = send_standby();
    SECTION("the first Standby was executed") {
        s.m.arrives(s.actuator, first.message, first.head);
        s.m.enters(s.actuator, jaus::primary_status_code::ready, jaus::primary_status_code::standby);
        s.m.handled(s.actuator);
    }
    SECTION("the first Standby was refused") { s.refuse(first); }
    s.m.learns_nothing(s.sender, first.head);
    for (int i = 0; i != 64; ++i) s.refuse(s.send(s.other, jaus::resume{}));
    const bool was_executed = s.m.actuator(s.actuator).state == jaus::primary_status_code::standby;
    s.refuse(send_standby());
    s.acknowledge(first);
    REQUIRE(s.broken() == (was_executed ? std::nullopt : std::optional{contract::s2}));
}

TEST_CASE("S2 detects a Set Emergency without effect, also without acknowledgement request") {
    stage s;
    s.take(s.send(s.sender, jaus::set_emergency{}, jaus::ack_nak::none), [] {});
    REQUIRE(s.broken() == contract::s2);
}

TEST_CASE("S2 detects efforts that continue in Standby") {
    stage s;
    s.move(s.sender);
    s.take(s.send(s.sender, jaus::standby{}),
           [&] { s.m.enters(s.actuator, jaus::primary_status_code::ready, jaus::primary_status_code::standby); });
    s.pass(1s);
    REQUIRE(s.broken() == contract::s2);
}

TEST_CASE("S3 detects efforts that continue after the death of the controller, and of its component") {
    stage s;
    s.take_control(s.sender);
    s.move(s.sender);
    SECTION("the controller is alive") {
        s.pass(5s);
        REQUIRE_FALSE(s.broken());
    }
    SECTION("the controller has died") {
        s.unit.die(10s);
        s.pass(800ms);
        REQUIRE_FALSE(s.broken());
        s.pass(200ms);
        REQUIRE(s.broken() == contract::s3);
    }
    SECTION("the controller's component does nothing any more") {
        s.m.mutes(s.sender);
        s.pass(1s);
        REQUIRE(s.broken() == contract::s3);
    }
}

TEST_CASE("S4 detects a report of other efforts or of another state") {
    stage s;
    const auto command = s.move(s.sender);
    const jaus::header query{.destination = robot_id, .source = operator_id};
    SECTION("correct report") {
        s.answer(query, efforts_of<jaus::report_wrench_effort>(command));
        s.answer(query, jaus::report_component_status{jaus::primary_status_code::ready, 0});
        REQUIRE_FALSE(s.broken());
    }
    SECTION("old efforts") {
        s.answer(query, efforts_of<jaus::report_wrench_effort>(command - 1));
        REQUIRE(s.broken() == contract::s4);
    }
    SECTION("another state") {
        s.answer(query, jaus::report_component_status{jaus::primary_status_code::standby, 0});
        REQUIRE(s.broken() == contract::s4);
    }
}

TEST_CASE("S5 detects motion in Standby, or by a sender other than the controller") {
    stage s;
    s.take_control(s.sender);
    SECTION("by a sender other than the controller") {
        s.move(s.other);
        REQUIRE(s.broken() == contract::s5);
    }
    SECTION("in Standby") {
        s.m.enters(s.actuator, jaus::primary_status_code::ready, jaus::primary_status_code::standby);
        s.move(s.sender);
        REQUIRE(s.broken() == contract::s5);
    }
}

TEST_CASE("S5 detects an emergency that ends before each of its senders has cleared it") {
    stage s;
    s.pass(1ms);
    using enum jaus::primary_status_code;
    jaus::set_emergency stop{};
    s.take(s.send(s.sender, stop), [&] { s.m.enters(s.actuator, ready, emergency); });
    REQUIRE_FALSE(s.broken());
    s.take(s.send(s.other, jaus::clear_emergency{}),
           [&] { s.m.enters(s.actuator, emergency, jaus::primary_status_code::standby); });
    REQUIRE(s.broken() == contract::s5);
}

TEST_CASE("S6 detects a sender that never gets an outcome of its message") {
    stage s;
    const auto one = [&] {
        std::uint32_t made{};
        REQUIRE(jaus::put({.ack_nak = jaus::ack_nak::request, .destination = robot_id, .source = operator_id},
                          jaus::resume{}, [&](bytes whole) { made = s.m.hands_over(s.sender, whole, 1s); }));
        return made;
    }();
    REQUIRE(one != 0);
    s.pass(900ms);
    REQUIRE_FALSE(s.broken());
    s.pass(200ms);
    REQUIRE(s.broken() == contract::s6);
}

TEST_CASE("S7 detects efforts that were never sent, and a large data set with a wrong byte") {
    stage s;
    SECTION("efforts") {
        s.m.executes(s.actuator, 77);
        REQUIRE(s.broken() == contract::s7);
    }
    SECTION("a large data set") {
        std::vector<std::byte> body(5000);
        fill_large(body, 5);
        const jaus::header head{.command_code = large_code, .destination = robot_id, .source = operator_id};
        s.m.sends_large(s.sender, head, 5);
        s.m.delivers_large(s.robot, head, body);
        REQUIRE_FALSE(s.broken());
        body[4321] ^= std::byte{1};
        s.m.delivers_large(s.robot, head, body);
        REQUIRE(s.broken() == contract::s7);
    }
}
