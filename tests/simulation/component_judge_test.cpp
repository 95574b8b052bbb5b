// Each check of components and operators can fail: it is shown what must not be.
#include "simulation/component_judge.hpp"
#include "simulation/idle_process.hpp"
#include "simulation/operator_judge.hpp"
#include "support/catch.hpp"

using namespace simulation;
using namespace std::chrono_literals;

namespace {

constexpr jaus::address robot{1, 33, 1, 2}, panel{1, 32, 1, 1}, other{1, 32, 1, 5};
using jaus::ack_nak, jaus::component_outcome, jaus::primary_status_code;

template <class T> std::vector<std::byte> message_of(jaus::header head, const T& body) {
    std::array<std::byte, 64> space{};
    const auto made = jaus::make_message(head, body, space);
    return {made->begin(), made->end()};
}

/// A component that is Ready, and its judge.
struct judged_robot {
    world w{1, 0};
    network n{w};
    idle_process program{w, n, "robot"};
    component_judge judge{w, program, {.id = robot, .timeout = 500ms, .remembered = 16}};
    std::uint16_t number{};

    judged_robot() {
        program.start();
        judge.starts();
        judge.initializes();
        judge.enters(primary_status_code::initialize, primary_status_code::ready);
        judge.has_changed();
    }
    template <class T> jaus::header gets(const jaus::address& from, const T& body, ack_nak asks = ack_nak::request) {
        const auto whole =
            message_of({.ack_nak = asks, .destination = robot, .source = from, .sequence_number = ++number}, body);
        const auto m = jaus::split(whole);
        judge.gets(m.header, m.body);
        return m.header;
    }
    void answers(const jaus::header& head, ack_nak how) {
        std::array<std::byte, jaus::header_size> space{};
        judge.sends(*jaus::make_acknowledgement(head, how, space));
    }
    void gives_control(const jaus::address& to, std::uint8_t authority) {
        const auto head = gets(to, jaus::request_component_control{authority}, ack_nak::none);
        judge.controlled(jaus::controller{to, authority}, jaus::control_change::granted);
        judge.sends(message_of(jaus::answer_to(head, robot), jaus::confirm_component_control{}));
        judge.has_handled(component_outcome::handled);
    }
    [[nodiscard]] bool is_broken() const { return w.broken().has_value(); }
};

} // namespace

TEST_CASE("a component that does not follow the state table is detected") {
    judged_robot s;
    const auto head = s.gets(panel, jaus::standby{});
    SECTION("it follows it") {
        s.judge.enters(primary_status_code::ready, primary_status_code::standby);
        s.answers(head, ack_nak::ack);
        s.judge.has_handled(component_outcome::handled);
        REQUIRE_FALSE(s.is_broken());
    }
    SECTION("it does not change its state") {
        s.answers(head, ack_nak::ack);
        s.judge.has_handled(component_outcome::handled);
        REQUIRE(s.is_broken());
    }
    SECTION("it refuses") {
        s.answers(head, ack_nak::nak);
        s.judge.has_handled(component_outcome::refused);
        REQUIRE(s.is_broken());
    }
    SECTION("it does not answer") {
        s.judge.enters(primary_status_code::ready, primary_status_code::standby);
        s.judge.has_handled(component_outcome::handled);
        REQUIRE(s.is_broken());
    }
    SECTION("it is acknowledged before the application learns of it") {
        s.answers(head, ack_nak::ack);
        s.judge.enters(primary_status_code::ready, primary_status_code::standby);
        s.judge.has_handled(component_outcome::handled);
        REQUIRE(s.is_broken());
    }
}

TEST_CASE("a component that obeys others than its controller is detected") {
    judged_robot s;
    s.gives_control(panel, 100);
    REQUIRE_FALSE(s.is_broken());
    SECTION("a command of another") {
        static_cast<void>(s.gets(other, jaus::resume{}, ack_nak::none));
        s.judge.has_handled(component_outcome::handled);
        REQUIRE(s.is_broken());
    }
    SECTION("a request of the same authority") {
        const auto head = s.gets(other, jaus::request_component_control{100}, ack_nak::none);
        s.judge.controlled(jaus::controller{other, 100}, jaus::control_change::taken_over);
        s.judge.sends(message_of(jaus::answer_to(head, robot), jaus::confirm_component_control{}));
        s.judge.has_handled(component_outcome::handled);
        REQUIRE(s.is_broken());
    }
}

TEST_CASE("a component that takes a new message for a repeat, or a repeat for a new one, is detected") {
    judged_robot s;
    const auto first = s.gets(panel, jaus::resume{});
    s.answers(first, ack_nak::ack);
    s.judge.has_handled(component_outcome::handled);
    REQUIRE_FALSE(s.is_broken());
    SECTION("a new one") {
        const auto head = s.gets(panel, jaus::resume{});
        s.answers(head, ack_nak::ack);
        s.judge.has_handled(component_outcome::repeated);
        REQUIRE(s.is_broken());
    }
    SECTION("a repeat") {
        s.judge.gets(first, {});
        s.answers(first, ack_nak::ack);
        s.judge.has_handled(component_outcome::handled);
        REQUIRE(s.is_broken());
    }
}

TEST_CASE("a silent controller that is not queried for its pulse is detected") {
    judged_robot s;
    s.gives_control(panel, 100);
    s.w.run(s.w.now() + 200ms);
    s.judge.runs();
    SECTION("it is queried") {
        s.judge.sends(message_of({.destination = panel, .source = robot}, jaus::query_heartbeat_pulse{}));
        s.judge.has_run();
        REQUIRE_FALSE(s.is_broken());
    }
    SECTION("it is not") {
        s.judge.has_run();
        REQUIRE(s.is_broken());
    }
}

TEST_CASE("an operator that does not repeat its message or its request in time is detected") {
    world w{1, 0};
    network n{w};
    idle_process program{w, n, "operator"};
    operator_judge judge{
        w,
        program,
        {.id = panel, .target = robot, .control = {.retry = {.interval = 200ms, .attempts = 3}}, .places = 8}};
    program.start();
    judge.starts(1);
    judge.asks(7);
    judge.changed(jaus::control_state::asking);
    const auto request = message_of({.destination = robot, .source = panel}, jaus::request_component_control{7});
    judge.sends(request);
    judge.has_done();
    REQUIRE_FALSE(w.broken());
    w.run(w.now() + 200ms);
    judge.runs();
    SECTION("the request is repeated") {
        judge.sends(request);
        judge.has_run();
        REQUIRE_FALSE(w.broken());
    }
    SECTION("it is not") {
        judge.has_run();
        REQUIRE(w.broken());
    }
    SECTION("an outcome comes that no message has") {
        judge.sends(request);
        judge.delivered({.destination = robot, .source = panel}, jaus::delivered::acknowledged);
        judge.has_run();
        REQUIRE(w.broken());
    }
}
