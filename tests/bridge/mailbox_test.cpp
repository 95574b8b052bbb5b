// Messages and stop orders by mailbox.
#include "rig.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/frame_builder.hpp>

using namespace test;
using jaus::ack_nak;
using status = jaus::primary_status_code;

TEST_CASE("a command is acknowledged after the slave has executed it") {
    rig r{rig::ready{}};
    const auto number = r.drive(50);
    CHECK(r.motor().effort == 0);
    CHECK(!r.answer(number));
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_acknowledged(number));
    CHECK(r.motor().effort == Approx(50).margin(0.01));
}

TEST_CASE("a command is refused, and its slave kept, if that refuses the 0 that is to come first") {
    rig r{rig::ready{}};
    r.options.download.clear_subindex_0 = true;
    const auto number = r.drive(50);
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_refused(number));
    CHECK(r.watcher.refusals == std::vector{bridging::refusal::by_slave});
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("a query is answered with the slave's report") {
    rig r{rig::driving{25}};
    r.tell(jaus::query_wrench_effort{}, 0, ack_nak::none);
    r.run_until([&] { return !r.received<jaus::report_wrench_effort>().empty(); });
    CHECK(r.received<jaus::report_wrench_effort>().front().propulsive_linear_effort_x == Approx(25).margin(0.01));
}

TEST_CASE("the status lists stop orders that the actuator has not confirmed") {
    rig r;
    const auto asks = [&] {
        r.messages.clear();
        r.tell(jaus::query_component_status{}, 0, ack_nak::none);
        REQUIRE(r.received<jaus::report_component_status>().size() == 1);
        return r.received<jaus::report_component_status>().front();
    };
    using namespace bridging::secondary_status;
    CHECK(asks() == jaus::report_component_status{status::initialize, slave_absent | rest_unconfirmed});
    r.run_until_ready();
    CHECK(asks() == jaus::report_component_status{status::ready, 0});
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_emergency>;
    r.motor().aborts = 1;
    const auto number = r.tell(rig::stop());
    CHECK(asks() == jaus::report_component_status{status::emergency, rest_unconfirmed | emergency_unconfirmed});
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(asks() == jaus::report_component_status{status::emergency, 0});
    r.pull_cable();
    CHECK(asks() ==
          jaus::report_component_status{status::emergency, slave_absent | rest_unconfirmed | emergency_unconfirmed});
    r.tell(rig::clear());
    CHECK(asks().secondary_status_code ==
          (slave_absent | rest_unconfirmed | emergency_unconfirmed | clear_unconfirmed));
}

TEST_CASE("a command that the slave aborts is refused") {
    rig r{rig::ready{}};
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_wrench_effort>;
    r.motor().aborts = 1;
    const auto number = r.drive(50);
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_refused(number));
    CHECK(r.motor().effort == 0);
}

TEST_CASE("a command for all components of a level is executed as one for the component") {
    rig r{rig::ready{}};
    const jaus::header head{.command_code = jaus::command_code_of<jaus::set_wrench_effort>,
                            .destination = {255, 255, 255, 2},
                            .source = rig::operator_unit};
    std::array<std::byte, 64> space{};
    const auto body = jauscat::wire::encode(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50}, space);
    r.unit().on_message(
        head, *body, r.now, [](std::span<const std::byte>) {},
        [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::unhandled; });
    r.run(100ms);
    CHECK(r.motor().effort > 49);
}

TEST_CASE("an emergency stop that the slave aborts is repeated until it is confirmed, then acknowledged") {
    rig r{rig::driving{50}};
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_emergency>;
    r.motor().aborts = 3;
    const auto number = r.tell(rig::stop());
    CHECK(r.unit().state() == status::emergency);
    r.run_until([&] { return r.motor().aborted == 1; });
    CHECK(!r.answer(number));
    r.run_until([&] { return r.motor().emergency; });
    CHECK(r.motor().aborted == 3);
    r.run_until([&] { return r.is_acknowledged(number); }, 1s);
    CHECK(r.motor().effort == 0);
    CHECK(r.unit().stops().settled());
}

TEST_CASE("a slave that refuses an emergency gets zeros") {
    rig r{rig::driving{50}};
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_emergency>;
    r.motor().aborts = 1'000'000;
    const auto number = r.tell(rig::stop());
    const auto took = r.run_until([&] { return r.motor().effort == 0; });
    CHECK(took < 100ms);
    r.run(2s);
    CHECK(!r.answer(number)); // not in an emergency, as far as it reports
    CHECK(r.unit().stops().stop_is_pending());
}

TEST_CASE("a slave without an object for emergencies is stopped by zeros") {
    rig r{rig::driving{50}};
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_emergency>;
    r.motor().aborts = 1'000'000;
    r.motor().abort = ethercat::abort_code::no_subindex;
    const auto number = r.tell(rig::stop());
    r.run_until([&] { return r.is_acknowledged(number); }, 200ms);
    CHECK(r.motor().effort == 0);
    CHECK(r.motor().aborted == 1);
}

TEST_CASE("rest is told where zeros are confirmed before the slave says that it has no object for emergencies") {
    rig r{rig::driving{50}};
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_emergency>;
    r.motor().aborts = 1;
    const auto settled = r.watcher.settled_debts;
    const auto number = r.tell(rig::stop());
    r.run_until([&] { return r.motor().aborted == 1; });
    r.motor().aborts = 1'000'000;
    r.motor().abort = ethercat::abort_code::no_subindex;
    r.run_until([&] { return r.is_acknowledged(number); }, 200ms);
    CHECK(r.motor().effort == 0);
    CHECK(r.watcher.settled_debts == settled + 1);
}

TEST_CASE("a slave whose table has no object for emergencies is stopped by zeros at the next attempt") {
    rig r{rig::driving{50}};
    const auto usual = r.run_until_acknowledged(r.drive(40));
    r.exchanges[0].lacks = jaus::command_code_of<jaus::set_emergency>;
    CHECK(r.run_until_acknowledged(r.tell(rig::stop())) <= r.options.stop_interval + usual);
    CHECK(r.motor().effort == 0);
    CHECK(!r.motor().emergency);
}

TEST_CASE("a stop order wakes the link of its slave") {
    rig r{rig::ready{}};
    bool is_woken = false;
    const auto wake = [&] { is_woken = true; };
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.run_until_acknowledged(r.drive(50));
    r.fronts[0].on_work(wake);
    r.unit().on_lost(rig::operator_unit);
    CHECK(is_woken);
    CHECK(r.unit().stops().stop_is_pending());
}

TEST_CASE("stop orders are executed before waiting commands, which are refused") {
    rig r;
    r.round_trip = 8ms;
    r.run_until_ready();
    std::vector<std::uint16_t> numbers;
    for (int i = 0; i != 100; ++i) {
        numbers.push_back(r.drive(1 + i % 50));
        r.run(10ms);
    }
    const auto number = r.tell(rig::stop());
    const auto took = r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(took < 150ms);
    r.run(1s);
    CHECK(r.motor().effort == 0);
    CHECK(r.motor().executed.back() != jaus::command_code_of<jaus::set_wrench_effort>);
    for (const auto each : numbers) CHECK(r.answer(each).has_value());
}

TEST_CASE("of waiting commands with one sender and code only the newest is kept, with the fields of the older ones") {
    rig r;
    r.round_trip = 8ms;
    r.run_until_ready();
    const auto first = r.drive(10);
    r.run(1ms);
    const auto second = r.tell(jaus::set_wrench_effort{.propulsive_linear_effort_y = 5});
    const auto third = r.drive(30);
    r.run_until([&] { return r.answer(third).has_value(); });
    CHECK(r.is_acknowledged(first));
    CHECK(r.is_refused(second));
    CHECK(r.is_acknowledged(third));
    CHECK(r.watcher.refusals == std::vector{bridging::refusal::superseded});
    CHECK(r.watcher.merged_numbers == std::vector{third});
    REQUIRE(r.motor().efforts.size() >= 2);
    CHECK(r.motor().efforts.back() == Approx(30).margin(0.01));
}

TEST_CASE("the loss of a slave sets its component to Failure and notifies the controller, and the slave is stopped "
          "when it returns") {
    rig r{rig::ready{}};
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    REQUIRE(r.unit().control().controller());
    r.run_until_acknowledged(r.drive(50));
    r.cable_is_out = true;
    const auto took = r.run_until([&] { return r.unit().state() == status::failure; });
    CHECK(took < 600ms);
    CHECK(!r.received<jaus::reject_component_control>().empty());
    const auto refused = r.drive(60);
    CHECK(r.is_refused(refused));
    CHECK(r.motor().effort != 0); // it could not be notified
    r.cable_is_out = false;
    r.run_until([&] { return r.motor().effort == 0; }, 1s);
    r.run_until_ready();
    CHECK(r.watcher.lost == 1);
}

TEST_CASE("a slave reset is detected, and the emergency is sent again") {
    rig r{rig::ready{}};
    const auto number = r.tell(rig::stop());
    r.run_until([&] { return r.is_acknowledged(number); });
    r.actuators[0].power_cycle();
    REQUIRE(!r.motor().emergency);
    r.run_until([&] { return r.motor().emergency; }, 1s);
    CHECK(r.watcher.last_loss == bridging::loss::no_station);
    CHECK(r.unit().state() == status::emergency);
}

TEST_CASE("of a slave that is not at its station address when its state is read first, no state is told") {
    unsigned losses = 0;
    for (std::chrono::microseconds after{}; after != 100ms; after += 500us) {
        rig r{1};
        r.run(after);
        r.actuators[0].power_cycle();
        r.run_until_ready();
        CHECK(r.watcher.last_loss != bridging::loss::left_state);
        losses += r.watcher.lost;
    }
    CHECK(losses != 0);
}

TEST_CASE("an emergency stop for an absent slave is acknowledged after the slave has returned and executed it") {
    rig r{rig::driving{50}};
    r.pull_cable();
    const auto number = r.tell(rig::stop());
    r.run(3s);
    CHECK(!r.answer(number));
    CHECK(r.unit().stops().stop_is_pending());
    r.cable_is_out = false;
    r.run_until([&] { return r.motor().emergency; }, 1s);
    r.run_until([&] { return r.is_acknowledged(number); }, 100ms);
}

TEST_CASE("an emergency already in force is not acknowledged while the slave is absent") {
    rig r{rig::stopped{}};
    r.pull_cable();
    r.actuators[0].power_cycle();
    const auto number = r.tell(rig::stop());
    r.run(1s);
    CHECK(!r.answer(number));
    r.cable_is_out = false;
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(r.motor().emergency);
}

TEST_CASE("a Clear Emergency for an absent slave is acknowledged after the slave has executed it") {
    rig r{rig::stopped{}};
    r.pull_cable();
    const auto number = r.tell(rig::clear());
    r.run(2s);
    CHECK(!r.answer(number));
    CHECK(r.is_refused(r.drive(10)));
    r.cable_is_out = false;
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(!r.motor().emergency);
    // A component that was in an emergency waits for a Resume.
    CHECK(r.unit().state() == status::standby);
    r.tell(jaus::resume{});
    const auto moves = r.drive(10);
    r.run_until([&] { return r.is_acknowledged(moves); });
    CHECK(r.motor().effort == Approx(10).margin(0.01));
}

TEST_CASE("a Clear Emergency that the slave refuses is refused") {
    rig r{rig::stopped{}};
    r.motor().abort_code_of = jaus::command_code_of<jaus::clear_emergency>;
    r.motor().aborts = 1000;
    const auto number = r.tell(rig::clear());
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_refused(number));
    CHECK(r.motor().emergency);
}

TEST_CASE("a slave in an emergency unknown to the bridge is stopped by another emergency") {
    rig r;
    r.motor().emergency = true; // left over from an earlier controller
    r.run_until_ready();
    CHECK(r.motor().emergency);
    CHECK(r.is_refused([&] {
        const auto number = r.drive(10);
        r.run_until([&] { return r.answer(number).has_value(); });
        return number;
    }()));
    const auto number = r.tell(rig::clear());
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(!r.motor().emergency);
}

TEST_CASE("loss of the controller stops the slave, release of control does not") {
    rig r{rig::ready{}};
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.run_until_acknowledged(r.drive(50));
    r.tell(jaus::release_component_control{}, 0, ack_nak::none);
    r.run(200ms);
    CHECK(r.motor().effort != 0);
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.lose(rig::operator_unit);
    r.run_until([&] { return r.motor().effort == 0; }, 100ms);
}

TEST_CASE("loss of a sender without control stops the slave") {
    rig r{rig::ready{}};
    const auto pulse = [&](const jaus::address& of) { r.tell(jaus::report_heartbeat_pulse{}, 0, ack_nak::none, of); };
    r.run_until_acknowledged(r.drive(50));
    for (int i = 0; i != 20; ++i) {
        r.run(200ms);
        pulse(rig::operator_unit);
    }
    CHECK(!r.received<jaus::query_heartbeat_pulse>().empty());
    CHECK(r.motor().effort != 0);
    // Two senders: the last one counts.
    const auto command = jaus::set_wrench_effort{.propulsive_linear_effort_x = 20};
    r.run_until(
        [&, number = r.tell(command, 0, ack_nak::request, rig::stranger)] { return r.is_acknowledged(number); });
    for (int i = 0; i != 10; ++i) {
        r.run(100ms);
        pulse(rig::stranger);
    }
    CHECK(r.motor().effort != 0);
    const auto waited = r.run_until([&] { return r.motor().effort == 0; }, r.core_options.control.timeout + 20ms);
    CHECK(waited > r.core_options.control.timeout - 20ms);
    r.run_until([&] { return r.unit().stops().settled(); });
    CHECK(r.unit().state() == jaus::primary_status_code::ready);
    CHECK(r.watcher.stop_causes.back() == bridging::stop_cause::sender_lost);
    // Right after a controller was lost by silence.
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.run_until([&] { return !r.unit().control().controller() && r.unit().stops().settled(); });
    r.run_until_acknowledged(r.drive(50));
    r.run_until([&] { return r.motor().effort == 0; }, r.core_options.control.timeout + 20ms);
}

TEST_CASE("what a controller leaves in force when it releases control is stopped when it is lost") {
    rig r{rig::ready{}};
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.run_until_acknowledged(r.drive(50));
    r.tell(jaus::release_component_control{}, 0, ack_nak::none);
    CHECK(r.motor().effort != 0);
    r.run_until([&] { return r.motor().effort == 0; }, r.core_options.control.timeout + 20ms);
}

TEST_CASE("a command that arrives while the slave refuses zeros is not executed before they are confirmed") {
    rig r{rig::driving{50}};
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_wrench_effort>;
    r.motor().aborts = 1;
    r.lose(rig::operator_unit);
    r.run_until([&] { return r.motor().aborted == 1; });
    REQUIRE(r.unit().stops().stop_is_pending());
    const auto number = r.drive(20);
    r.run_until([&] { return r.is_acknowledged(number); });
    REQUIRE(r.motor().efforts.size() >= 3);
    CHECK(*(r.motor().efforts.end() - 2) == 0);
}

TEST_CASE("a command waits behind a stop order that the slave refuses for its time, and is refused then") {
    rig r{rig::driving{50}};
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.exchanges[0].lacks = jaus::command_code_of<jaus::set_emergency>;
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_wrench_effort>;
    r.motor().aborts = 1'000'000;
    r.lose(rig::operator_unit);
    const auto begun = r.now;
    const auto number = r.drive(20);
    r.run(r.options.order_timeout / 2);
    r.tell(jaus::report_heartbeat_pulse{}, 0, ack_nak::none); // the operator is there
    CHECK(!r.answer(number));
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.now - begun == r.options.order_timeout);
    CHECK(r.is_refused(number));
    CHECK(r.watcher.refusals == std::vector{bridging::refusal::expired});
    CHECK(r.unit().stops().stop_is_pending());
}

TEST_CASE("a component that takes control over does not inherit waiting commands") {
    rig r;
    r.round_trip = 8ms;
    r.run_until_ready();
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.tell(jaus::set_travel_speed{.desired_speed = 1}, 0, ack_nak::none); // occupies the slave
    const auto number = r.drive(50);
    r.tell(jaus::request_component_control{.authority_code = 200}, 0, ack_nak::none, rig::stranger);
    CHECK(r.is_refused(number));
    r.run(500ms);
    CHECK(r.motor().effort == 0);
}

TEST_CASE("waiting commands of a controller are executed after it has released control") {
    rig r;
    r.round_trip = 8ms;
    r.run_until_ready();
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.tell(jaus::set_travel_speed{.desired_speed = 1}, 0, ack_nak::none); // occupies the slave
    const auto number = r.drive(50);
    r.tell(jaus::release_component_control{}, 0, ack_nak::none);
    REQUIRE_FALSE(r.unit().control().controller());
    r.run_until_acknowledged(number, 500ms);
    CHECK(r.motor().effort == Approx(50).margin(0.01));
}

TEST_CASE("each of several emergency stops of one sender that wait for a slave is acknowledged") {
    rig r{rig::driving{50}};
    r.pull_cable();
    const auto first = r.tell(rig::stop()), second = r.tell(rig::stop());
    r.repeat(rig::stop(), second); // a copy
    r.cable_is_out = false;
    r.run_until_acknowledged(first);
    r.run_until_acknowledged(second);
    CHECK(r.motor().emergency);
}

TEST_CASE("a command that is in its transfer when the program is suspended is not executed after the limit") {
    rig r{rig::ready{}};
    r.frames_to_lose = 1; // its first frame
    const auto number = r.drive(50);
    r.run(1ms);
    REQUIRE_FALSE(r.answer(number));
    REQUIRE(r.options.data_limit < r.options.order_timeout);
    r.now += r.options.data_limit + 1ms;
    r.run(500ms);
    CHECK(std::ranges::count(r.motor().efforts, 0) == std::ssize(r.motor().efforts)); // of stop orders
    CHECK_FALSE(r.is_acknowledged(number));
}

TEST_CASE("a component that gets free control does not inherit waiting commands of others") {
    rig r;
    r.round_trip = 8ms;
    r.run_until_ready();
    r.tell(jaus::set_travel_speed{.desired_speed = 1}, 0, ack_nak::none); // occupies the slave
    const auto foreign = r.drive(50), own = r.tell(jaus::set_wrench_effort{.propulsive_linear_effort_x = 20}, 0,
                                                   ack_nak::request, rig::stranger);
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none, rig::stranger);
    CHECK(r.is_refused(foreign));
    r.run_until([&] { return r.is_acknowledged(own); });
    CHECK(r.motor().effort > 19);
    CHECK(std::ranges::max(r.motor().efforts) < 21);
}

namespace {

/// Another user's question is in the slave's mailbox, and its application hangs: the next message has to wait.
void fill_mailbox(rig& r) {
    r.actuators[0].hangs = true;
    std::array<std::byte, ethercat::max_frame_size> frame{};
    ethercat::frame_builder builder{frame};
    const auto mail = builder.add(ethercat::command::fpwr, 2, 0x1000, std::size_t{256});
    std::ranges::copy(jauscat::test::from_hex("0a00 0000 00 73 0020 40 0010 00 00000000"), mail.begin());
    r.actuators[0].pass(*builder.finish(), r.now);
}

} // namespace

TEST_CASE("a command that waits for room in the slave's mailbox is withdrawn when another component gets control") {
    rig r{rig::ready{}};
    fill_mailbox(r);
    const auto number = r.drive(50);
    r.run(5ms);
    REQUIRE_FALSE(r.answer(number));
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none, rig::stranger);
    r.run_until([&] { return r.is_refused(number); }, 1ms);
    CHECK(r.watcher.refusals == std::vector{bridging::refusal::stopped});
    const auto own =
        r.tell(jaus::set_wrench_effort{.propulsive_linear_effort_x = 20}, 0, ack_nak::request, rig::stranger);
    r.run(5ms);
    r.actuators[0].hangs = false;
    r.run_until_acknowledged(own, 5ms);
    r.run(100ms);
    CHECK(std::ranges::max(r.motor().efforts) < 21);
    CHECK(r.motor().effort > 19);
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("the controller's command that waits for room in the slave's mailbox is kept when it gets control") {
    rig r{rig::ready{}};
    fill_mailbox(r);
    const auto number = r.drive(50);
    r.run(5ms);
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.run(5ms);
    CHECK_FALSE(r.answer(number));
    r.actuators[0].hangs = false;
    r.run_until_acknowledged(number, 5ms);
}

TEST_CASE("a query that waits for room in the slave's mailbox is not withdrawn") {
    rig r{rig::ready{}};
    fill_mailbox(r);
    r.tell(jaus::query_wrench_effort{.presence_vector = 1}, 0, ack_nak::none);
    r.run(5ms);
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none, rig::stranger);
    r.run(5ms);
    r.actuators[0].hangs = false;
    r.run_until([&] { return !r.received<jaus::report_wrench_effort>().empty(); }, 5ms);
}

TEST_CASE("a command that waits for room in the slave's mailbox does not move it after a Standby") {
    rig r{rig::ready{}};
    fill_mailbox(r);
    const auto number = r.drive(50);
    r.run(5ms);
    const auto standby = r.tell(jaus::standby{});
    r.run_until([&] { return r.is_refused(number); }, 1ms);
    r.run(5ms);
    r.actuators[0].hangs = false;
    r.run_until_acknowledged(standby, 5ms);
    r.run(100ms);
    CHECK(std::ranges::max(r.motor().efforts) == 0);
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("whether a command is withdrawn that is just written to the slave's mailbox is decided by the reply") {
    for (const bool is_taken : {true, false}) {
        rig r{rig::ready{}};
        r.round_trip = 2ms;
        if (!is_taken) fill_mailbox(r);
        const auto number = r.drive(50);
        r.run(1ms);
        r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none, rig::stranger);
        r.actuators[0].hangs = false;
        r.run_until([&] { return r.answer(number).has_value(); }, 10ms);
        r.run(100ms);
        CHECK(r.is_acknowledged(number) == is_taken);
        CHECK((std::ranges::max(r.motor().efforts) > 49) == is_taken);
        CHECK(r.watcher.lost == 0);
    }
}

TEST_CASE("Standby is acknowledged when the slave is stopped, and no waiting message moves it afterwards") {
    rig r;
    r.round_trip = 4ms;
    r.run_until_ready();
    r.run_until_acknowledged(r.drive(50));
    const auto late = r.drive(70);
    const auto later = r.tell(jaus::set_travel_speed{.desired_speed = 3});
    const auto number = r.tell(jaus::standby{});
    CHECK(!r.answer(number));
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(r.motor().effort == 0);
    r.run(1s);
    CHECK(r.motor().effort == 0);
    CHECK(r.is_refused(later));
    CHECK(r.answer(late).has_value());
}

TEST_CASE("each Standby numbered 0 that comes while the first one is pending is acknowledged once") {
    rig r{rig::driving{50}};
    const auto acknowledged = [&] {
        return std::ranges::count_if(r.messages, [](const auto& message) {
            const auto head = jaus::split(message).header;
            return head.ack_nak == ack_nak::ack && head.sequence_number == 0 &&
                   head.command_code == jaus::command_code_of<jaus::standby>;
        });
    };
    r.motor().abort_code_of = jaus::command_code_of<jaus::set_wrench_effort>;
    r.motor().aborts = 2;
    r.repeat(jaus::standby{}, 0);
    r.repeat(jaus::resume{}, 0);
    r.repeat(jaus::standby{}, 0);
    CHECK(acknowledged() == 0);
    r.run_until([&] { return r.unit().stops().settled(); });
    r.run(1ms);
    CHECK(acknowledged() == 2);
    r.repeat(jaus::standby{}, 0);
    CHECK(acknowledged() == 3);
}

TEST_CASE("a copy of a message that is not executed yet is not executed twice") {
    rig r;
    r.round_trip = 8ms;
    r.run_until_ready();
    const jaus::set_travel_speed body{.desired_speed = 3};
    const auto number = r.tell(body);
    r.repeat(body, number);
    r.run(5ms);
    r.repeat(body, number);
    r.run_until([&] { return r.is_acknowledged(number); });
    r.repeat(body, number);
    r.run(200ms);
    CHECK(std::ranges::count(r.motor().executed, jaus::command_code_of<jaus::set_travel_speed>) == 1);
}

TEST_CASE("an emergency of a slave is detected without a message to that slave") {
    rig r;
    r.options.keep_alive = 0s;
    r.run_until_ready();
    // The answer to another master's upload becomes an emergency before it returns.
    constexpr ethercat::slave_description areas{};
    constexpr std::size_t mailbox_size = 256;
    std::array<std::byte, ethercat::max_frame_size> frame{};
    ethercat::frame_builder upload{frame, 0xEE};
    auto mail = upload.add(ethercat::command::fpwr, 2, areas.mailbox_out_offset, mailbox_size);
    constexpr std::array request{0x0A, 0, 0, 0, 0, 0x73, 0, 0x20, 0x40, 0, 0x10, 0, 0, 0, 0, 0};
    std::ranges::transform(request, mail.begin(), [](int b) { return static_cast<std::byte>(b); });
    r.actuators[0].pass(*upload.finish(), r.now);
    r.on_way_back = [](std::span<std::byte> back) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(back));
        for (auto each : view) {
            if (each.header.ado != areas.mailbox_in_offset || each.working_counter == 0) continue;
            constexpr std::array emergency{0, 0x10, 0x10, 0x23, 1, 0, 0, 0, 0, 0}; // 2310h
            std::ranges::transform(emergency, each.data.begin() + 6, [](int b) { return static_cast<std::byte>(b); });
        }
    };
    r.run_until([&] { return !r.watcher.emergencies.empty(); }, r.options.check_interval + 10ms);
    CHECK(r.watcher.emergencies == std::vector<std::uint16_t>{0x2310});
    r.on_way_back = {};
    r.run(1s);
    r.run_until_acknowledged(r.drive(50)); // after each message the kept ones are told
    CHECK(r.watcher.emergencies.size() == 1);
    CHECK(r.watcher.lost == 0);
}

namespace {
/// Heartbeats that a slave gets in a second.
auto beats_of(rig& r, std::size_t i) {
    r.motor(i).executed.clear();
    r.run(1s);
    return std::ranges::count(r.motor(i).executed, jaus::command_code_of<jaus::report_heartbeat_pulse>);
}
void refuse_beat(rig& r, std::size_t i) {
    r.motor(i).abort_code_of = jaus::command_code_of<jaus::report_heartbeat_pulse>;
    r.motor(i).aborts = 1;
    r.run_until([&] { return r.motor(i).aborts == 0; });
    CHECK(beats_of(r, i) == 0);
}
} // namespace

TEST_CASE("a slave without messages gets heartbeats") {
    rig r{rig::ready{}};
    const auto beats = beats_of(r, 0);
    CHECK(beats >= 8);
    CHECK(beats <= 11);
}

TEST_CASE("a slave that has refused heartbeats is tried again when it was away") {
    rig r{2};
    r.run_until_ready();
    refuse_beat(r, 1);
    r.actuators[1].power_cycle(); // it may be another device
    r.run_until([&] { return r.watcher.lost == 1; });
    r.run_until_ready();
    CHECK(beats_of(r, 1) >= 8);
}

TEST_CASE("a slave that is added in place of one that has refused heartbeats gets them") {
    rig r{2};
    r.run_until_ready();
    refuse_beat(r, 1);
    r.bus.remove(r.fronts[1], r.now);
    bridging::order_memory<16, 1532> memory;
    bridging::slave_front front{r.fronts[1].options(), r.exchanges[1], r.options, memory, r.watcher.observer()};
    REQUIRE(r.bus.add(front));
    const auto& unit = r.units.emplace_back(rig::unit_address(1), front, r.core_options);
    r.run_until([&] { return unit.state() == jaus::primary_status_code::ready && unit.stops().settled(); });
    CHECK(beats_of(r, 1) >= 8);
    r.bus.remove(front, r.now);
    r.units.pop_back();
}

namespace {
struct unknown_to_the_table {
    std::uint8_t value{};

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD001;
        using type = layout<field<&unknown_to_the_table::value, u8>>;
    };
};
} // namespace

TEST_CASE("messages without translation do not replace the heartbeats of a slave") {
    rig r{rig::ready{}};
    r.motor().executed.clear();
    for (int i = 0; i != 20; ++i) {
        r.tell(unknown_to_the_table{});
        r.run(50ms);
    }
    CHECK(r.watcher.refusals.back() == bridging::refusal::not_translated);
    CHECK(std::ranges::count(r.motor().executed, jaus::command_code_of<jaus::report_heartbeat_pulse>) >= 8);
}

TEST_CASE("the end of the program stops every slave") {
    rig r{3};
    r.run_until_ready();
    for (std::size_t i = 0; i != 3; ++i) r.run_until_acknowledged(r.drive(50, i));
    CHECK(r.bus.at_rest());
    r.shut_down();
    CHECK(!r.bus.at_rest());
    const auto took = r.run_until([&] { return r.bus.at_rest(); });
    CHECK(took < 200ms);
    for (std::size_t i = 0; i != 3; ++i) CHECK(r.motor(i).effort == 0);
}

TEST_CASE("an absent slave does not delay messages to other slaves") {
    rig r{2};
    r.run_until_ready();
    r.dead_from = 1;
    r.run_until([&] { return !r.fronts[1].up(); });
    for (int i = 0; i != 50; ++i) {
        const auto number = r.drive(i, 0);
        const auto took = r.run_until([&] { return r.is_acknowledged(number); });
        CHECK(took < 300ms);
        r.run(50ms);
    }
}

TEST_CASE(
    "a transfer to an unresponsive slave is abandoned for a stop order to another, and its late answer is dropped") {
    rig r{2};
    r.run_until_ready();
    r.run_until_acknowledged(r.drive(50, 0));
    r.actuators[1].hangs = true;
    const auto hung = r.drive(30, 1);
    r.run(5ms);
    const auto number = r.tell(rig::stop(), 0);
    const auto took = r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(took <= 80ms);
    r.run_until([&] { return r.answer(hung).has_value(); });
    CHECK(r.is_refused(hung));
    CHECK(r.watcher.lost == 1);
    r.actuators[1].hangs = false;
    r.run_until([&] { return r.fronts[1].up() && r.units[1].stops().settled(); });
    CHECK(r.motor(1).effort == 0);
}

TEST_CASE("a dead slave among six delays neither commands nor a stop order to the others") {
    rig r{6};
    r.run_until_ready();
    const auto one = r.run_until_acknowledged(r.drive(10, 0));
    r.actuators[5].hangs = true;
    const auto hung = r.drive(30, 5);
    r.run(5ms);
    std::vector<std::uint16_t> numbers;
    for (std::size_t i = 0; i != 5; ++i) numbers.push_back(r.drive(20, i));
    const auto five = r.run_until(
        [&] { return std::ranges::all_of(numbers, [&](auto number) { return r.is_acknowledged(number); }); });
    CHECK(five <= one + 100us); // all at once
    const auto stopped = r.run_until_acknowledged(r.tell(rig::stop(), 3));
    CHECK(stopped <= one + 100us);
    CHECK(r.motor(3).emergency);
    CHECK_FALSE(r.answer(hung));
    CHECK(r.watcher.lost == 0);
    CHECK(r.bus.statistics().foreign == 0);
}

TEST_CASE("a stop order gets the place of a transfer where more slaves are dead than messages go at the same time") {
    rig r{20}; // 16 lanes
    r.run_until_ready();
    for (std::size_t i = 0; i != 19; ++i) {
        r.actuators[i].hangs = true;
        r.drive(30, i);
    }
    r.run(5ms);
    const auto took = r.run_until_acknowledged(r.tell(rig::stop(), 19));
    CHECK(took <= 80ms);
    CHECK(r.watcher.lost == 1);
}

TEST_CASE("a job of others for a slave that gets a message waits for it, and others for all others do not") {
    rig r{2};
    r.run_until_ready();
    std::array<std::byte, 64> name{};
    struct sharing {
        rig& r;
        std::span<std::byte> into;
        std::uint16_t station{};
        std::vector<ethercat::master_error> ended{};
        bool begin(ethercat::master& idle) {
            const auto wanted = std::exchange(station, std::uint16_t{0});
            return wanted != 0 && idle.start(ethercat::upload{wanted, 0x1008, 0, into});
        }
        void done(ethercat::master& idle) { ended.push_back(idle.error()); }
        void cycle() {}
    } others{r, name};
    r.bus.share({.begin = jaus::bound<&sharing::begin>(others),
                 .done = jaus::bound<&sharing::done>(others),
                 .cycle = jaus::bound<&sharing::cycle>(others)});
    r.actuators[0].hangs = true;
    const auto hung = r.drive(30, 0);
    r.run(1ms);
    others.station = 2;
    r.run(5ms);
    CHECK(others.ended.empty());
    r.run_until_acknowledged(r.drive(20, 1), 5ms);
    r.actuators[0].hangs = false;
    r.run_until([&] { return r.is_acknowledged(hung); });
    r.run_until([&] { return others.ended.size() == 1; }, 5ms);
    CHECK(others.ended.back() == ethercat::master_error{});

    r.actuators[0].hangs = true;
    others.station = 3;
    r.drive(30, 0);
    r.run_until([&] { return others.ended.size() == 2; }, 5ms);
    CHECK(others.ended.back() == ethercat::master_error{});
}

TEST_CASE("a message waits for its slave for a bounded time") {
    rig r{rig::ready{}};
    r.frames_to_lose = 1000;
    const auto number = r.drive(50);
    const auto later = r.tell(jaus::set_travel_speed{.desired_speed = 3});
    r.run_until([&] { return r.answer(number).has_value() && r.answer(later).has_value(); }, 1s);
    CHECK(r.is_refused(number));
    CHECK(r.is_refused(later));
}

TEST_CASE("a program that was suspended does not continue requests from before") {
    rig r{rig::ready{}};
    r.cable_is_out = true;
    const auto ack = GENERATE(ack_nak::request, ack_nak::none);
    const auto number = r.drive(50, 0, ack);
    r.run(5ms);
    r.tell(jaus::standby{});
    r.cable_is_out = false;
    r.now += r.options.longest_silence + 1s;
    bool has_moved = false;
    r.run_until([&] {
        has_moved = has_moved || r.motor().effort != 0;
        return r.watcher.lost == 1 && r.fronts[0].up() && r.unit().stops().settled();
    });
    CHECK_FALSE(has_moved);
    CHECK(r.is_refused(number) == (ack == ack_nak::request));
}

TEST_CASE("the end of the program waits for an absent slave to return") {
    rig r{rig::driving{50}};
    r.pull_cable();
    r.shut_down();
    CHECK(!r.bus.at_rest());
    r.cable_is_out = false;
    r.run_until([&] { return r.bus.at_rest(); }, 2s);
    CHECK(r.motor().effort == 0);
}

TEST_CASE("a reply that waited when the states were read is collected once") {
    rig r{2};
    r.run_until_ready();
    r.run(200ms);
    unsigned collected = 0;
    r.on_way_back = [&](std::span<std::byte> back) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(back));
        for (auto each : view) {
            if (each.header.cmd == ethercat::command::fprd && each.header.ado == 0x1600) ++collected;
            if (each.header.adp != 2 || each.header.ado != ethercat::sync_manager_handshake_of(1).address) continue;
            each.data[0] |= std::byte{0x08}; // full
        }
    };
    r.run(r.options.check_interval);
    CHECK(collected <= 4); // and a keep-alive of each
}

TEST_CASE("a slave by mailbox operates only once its state was read") {
    rig r;
    r.on_way_back = [](std::span<std::byte> back) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(back));
        if ((*view.begin()).header.cmd != ethercat::command::nop) return; // not a look at the states
        for (auto each : view)
            if (each.header.ado == ethercat::esc_registers::al_status.address) each.data[0] &= std::byte{0xF0};
    };
    r.run(5s);
    CHECK(r.watcher.up == 0);
    CHECK(r.watcher.lost != 0);
    CHECK(r.watcher.last_loss == bridging::loss::left_state);
    CHECK(r.unit().state() != status::ready);
    r.on_way_back = {};
    r.run_until_ready();
}

TEST_CASE("slaves with station addresses of an earlier master are brought up") {
    rig r{2};
    for (auto& each : r.actuators) { // both have the one that the second is to get
        std::array<std::byte, ethercat::max_frame_size> frame{};
        ethercat::frame_builder write{frame, 0xEE};
        write.add(ethercat::command::apwr, 0, ethercat::esc_registers::station_address.address, ethercat::esc_word{3});
        each.pass(*write.finish(), r.now);
    }
    r.run_until_ready();
    CHECK(r.watcher.failed_bring_ups == 0);
}

TEST_CASE("a slave of unknown state counts as lost, also while the master waits for another slave") {
    rig r{2};
    r.run_until_ready();
    r.run_until_acknowledged(r.drive(50, 1));
    r.actuators[0].hangs = true;
    r.drive(30, 0);
    r.run(5ms);
    r.on_way_back = [](std::span<std::byte> back) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(back));
        for (auto each : view)
            if (each.header.adp == 3 && each.header.ado == ethercat::esc_registers::al_status.address)
                each.data[0] &= std::byte{0xF0};
    };
    const auto took = r.run_until([&] { return !r.fronts[1].up(); });
    CHECK(took <= r.options.check_interval + 10ms);
    CHECK(r.watcher.last_loss == bridging::loss::left_state);
    CHECK(r.unit(1).state() == status::failure);
}

TEST_CASE("a slave by mailbox works in PRE-OP, SAFE-OP and OP, where another master may take it") {
    const auto reported = GENERATE(std::byte{2}, std::byte{4}, std::byte{8});
    rig r{rig::ready{}};
    r.on_way_back = [&](std::span<std::byte> back) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(back));
        for (auto each : view)
            if (each.header.ado == ethercat::esc_registers::al_status.address) each.data[0] = reported;
    };
    r.run_until_acknowledged(r.drive(50));
    r.run(2 * r.options.check_interval);
    CHECK(r.watcher.lost == 0);
    CHECK(r.motor().effort != 0);
}

TEST_CASE("a slave by mailbox that reports an error is lost, and brought up again") {
    for (const unsigned reported : {0x14U, 0x12U}) { // SAFE-OP, PRE-OP
        rig r{rig::ready{}};
        r.run_until_acknowledged(r.drive(50));
        r.on_way_back = [&](std::span<std::byte> back) {
            ethercat::mutable_frame_view view;
            REQUIRE(view.parse(back));
            for (auto each : view)
                if (each.header.cmd == ethercat::command::fprd &&
                    each.header.ado == ethercat::esc_registers::al_status.address)
                    each.data[0] = static_cast<std::byte>(reported);
        };
        const auto took = r.run_until([&] { return !r.fronts[0].up(); });
        CHECK(took <= r.options.check_interval + 10ms);
        CHECK(r.watcher.last_loss == bridging::loss::left_state);
        CHECK(r.unit().state() == status::failure);
        r.on_way_back = {};
        r.run_until_ready();
        CHECK(r.motor().effort == 0);
    }
}

TEST_CASE("polling the states does not consume a reply for which the master waits") {
    rig r{rig::ready{}};
    r.run(30s); // every index was used
    for (int i = 0; i != 20; ++i) {
        r.actuators[0].power_cycle();
        r.run_until([&] { return !r.fronts[0].up(); });
        const auto took = r.run_until([&] { return r.fronts[0].up(); });
        CHECK(took < 20ms);
    }
    CHECK(r.watcher.failed_bring_ups == 0);
    CHECK(r.bus.statistics().lost == 0);
    CHECK(r.bus.statistics().foreign == 0);
}
