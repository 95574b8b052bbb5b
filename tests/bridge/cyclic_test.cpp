// Messages and stop orders by process data.
#include "rig.hpp"

using namespace test;
using jaus::ack_nak;
using status = jaus::primary_status_code;

TEST_CASE("a process-data command is acknowledged when the slave's inputs repeat its counter") {
    rig r{1, true};
    r.run_until_ready();
    const auto number = r.drive(50);
    CHECK(!r.answer(number));
    const auto took = r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_acknowledged(number));
    CHECK(took <= 30ms);
    CHECK(r.motor().effort == Approx(50).margin(0.01));
    // Not by mailbox.
    CHECK(std::ranges::count(r.motor().executed, jaus::command_code_of<jaus::set_wrench_effort>) == 0);
}

TEST_CASE("of two commands between two cycles only the one that the slave accepted is acknowledged") {
    rig r{1, true};
    r.run_until_ready();
    r.run(1ms); // a cycle has just gone
    const auto first = r.drive(50);
    const auto second = r.drive(20);
    r.run_until([&] { return r.answer(first).has_value() && r.answer(second).has_value(); });
    CHECK(r.is_refused(first));
    CHECK(r.is_acknowledged(second));
    CHECK(r.motor().efforts.back() == Approx(20).margin(0.01));
}

TEST_CASE("an observer hears of a command that is merged with one which the slave has not executed") {
    rig r{1, true};
    r.run_until_ready();
    const auto alone = r.drive(50);
    r.run_until([&] { return r.answer(alone).has_value(); });
    CHECK(r.watcher.merged_numbers.empty());
    r.run(1ms); // a cycle has just gone
    r.drive(20);
    const auto second = r.drive(30);
    r.run_until([&] { return r.answer(second).has_value(); });
    CHECK(r.watcher.merged_numbers == std::vector{second});
}

TEST_CASE("a frame that is delayed by the process data is requested after them") {
    rig r{1, true};
    r.run_until_ready();
    r.run_until([&] { return r.bus.next_event().value_or(jauscat::time_point{}) > r.now + 5ms; });
    r.run(7ms + 600us); // within the reserve
    r.tell(jaus::set_travel_speed{.desired_speed = 3});
    REQUIRE(r.bus.next_event());
    std::array<std::byte, ethercat::max_frame_size> frame{};
    CHECK((r.bus.next_frame(frame, r.now) != 0 || *r.bus.next_event() > r.now));
}

TEST_CASE("a query is answered from fresh inputs, and refused without a link") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    r.run(20ms);
    r.tell(jaus::query_wrench_effort{.presence_vector = 1}, 0, ack_nak::none);
    REQUIRE(r.received<jaus::report_wrench_effort>().size() == 1);
    CHECK(r.received<jaus::report_wrench_effort>().front().propulsive_linear_effort_x == Approx(50).margin(0.01));
    r.cable_is_out = true;
    r.run(120ms);
    const auto number = r.tell(jaus::query_wrench_effort{.presence_vector = 1});
    r.run(100ms);
    CHECK(r.received<jaus::report_wrench_effort>().size() == 1);
    CHECK(r.is_refused(number));
}

TEST_CASE("a silent slave counts as lost within the time limit, and the bridge continues to accept messages") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    r.cable_is_out = true;
    const auto took = r.run_until([&] { return r.unit().state() == status::failure; });
    CHECK(took <= 50ms + 2 * r.options.period);
    CHECK(r.is_refused(r.drive(20)));
    // The slave's own watchdog.
    r.run_until([&] { return r.motor().effort == 0; }, 200ms);
    r.cable_is_out = false;
    r.run_until_ready();
    const auto number = r.drive(30);
    r.run_until([&] { return r.is_acknowledged(number); });
}

TEST_CASE("a slave is not lost by a pause of the program, and its inputs from before are too old for a query") {
    rig r{1, true};
    r.run_until_ready();
    r.run(20ms);
    for (int i = 0; i != 20; ++i) {
        r.run_until([&, before = r.frames] { return r.frames != before; });
        r.now += r.options.data_limit + 5ms; // the frame is back, and not looked at
        for (auto& each : r.actuators) each.slave.on_time(r.now - 50ms);
        const auto number = r.tell(jaus::query_wrench_effort{.presence_vector = 1});
        CHECK(r.is_refused(number));
        r.run(50ms);
    }
    CHECK(r.received<jaus::report_wrench_effort>().empty());
    CHECK(r.watcher.lost == 0);
    // Lost frames count, also where the program pauses in between.
    r.cable_is_out = true;
    const auto took = r.run_until([&] { return r.watcher.lost != 0; });
    CHECK(took <= 50ms + 2 * r.options.period);
}

TEST_CASE("a slave that is polled every 5 ms detects missing outputs within the limit") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    r.run_until([&, before = r.frames] { return r.frames != before; });
    r.cable_is_out = true;
    r.run(bridging::at_rest_in_cycles - 5ms);
    CHECK(r.motor().effort == 0);
}

TEST_CASE("a slave that leaves OP counts as lost within two cycles") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    std::array<std::byte, 64> frame{};
    ethercat::frame_builder build{frame, 77};
    build.add(ethercat::command::fpwr, 2, ethercat::esc_registers::al_control.address,
              ethercat::al_control{.state = ethercat::al_state::safe_op});
    const auto finished = build.finish();
    REQUIRE(finished);
    r.actuators[0].pass(*finished, r.now);
    const auto took = r.run_until([&] { return r.watcher.lost == 1; });
    CHECK(took <= 21ms);
    CHECK(r.watcher.last_loss == bridging::loss::left_state);
    r.run_until([&] { return r.watcher.up == 2; });
    CHECK(r.motor().effort == 0);
}

TEST_CASE("a slave that is lost after confirming an emergency, before its answer arrives, gets the emergency again") {
    rig r{1, true};
    r.run_until_ready();
    bool is_answered = false;
    r.on_way_back = [&](std::span<std::byte> frame) {
        r.round_trip = 200us;
        ethercat::frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto datagram : view) {
            if (is_answered || !r.motor().emergency || datagram.header.cmd != ethercat::command::fprd ||
                datagram.data.size() != 256 || datagram.working_counter == 0)
                continue;
            is_answered = true;
            r.round_trip = 12ms; // of this frame alone
            r.dead_from = 0;
        }
    };
    const auto first = r.tell(rig::stop());
    r.run_until([&] { return r.watcher.lost == 1; });
    CHECK(is_answered);
    r.run(20ms); // the answer has returned
    CHECK(r.unit().stops().emergency_is_pending());
    r.motor().reset();
    const auto second = r.tell(rig::stop(), 0, ack_nak::request, rig::stranger);
    r.run(200ms);
    CHECK_FALSE(r.answer(first));
    CHECK_FALSE(r.answer(second));
    r.dead_from = 100;
    r.run_until([&] { return r.is_acknowledged(first) && r.is_acknowledged(second); });
    CHECK(r.motor().emergency);
}

TEST_CASE("a slave that loses its station address counts as lost within two cycles") {
    rig r{1, true};
    r.run_until_ready();
    std::array<std::byte, 64> frame{};
    ethercat::frame_builder build{frame, 77};
    build.add(ethercat::command::fpwr, 2, ethercat::esc_registers::station_address.address, ethercat::esc_word{0x1001});
    const auto finished = build.finish();
    REQUIRE(finished);
    r.actuators[0].pass(*finished, r.now);
    const auto took = r.run_until([&] { return r.watcher.lost == 1; });
    CHECK(took <= 21ms);
    CHECK(r.watcher.last_loss == bridging::loss::no_station);
}

TEST_CASE("a slave whose station address goes to another one while it is brought up does not operate") {
    rig r{2, true};
    r.run_until_ready();
    const auto give = [&r](std::size_t to, std::uint16_t station) { // as another master
        std::array<std::byte, 64> frame{};
        ethercat::frame_builder build{frame, 77};
        build.add(ethercat::command::apwr, 0, ethercat::esc_registers::station_address.address,
                  ethercat::esc_word{station});
        const auto finished = build.finish();
        REQUIRE(finished);
        r.actuators[to].pass(*finished, r.now);
    };
    give(0, 0);
    give(1, 0);
    r.run_until([&] { return !r.fronts[0].up() && !r.fronts[1].up(); });
    r.run_until([&] {
        return std::ranges::all_of(r.actuators,
                                   [](const auto& each) { return each.slave.state() == ethercat::al_state::pre_op; });
    });
    give(0, 0);
    give(1, 2);
    r.run_until([&] { return r.fronts[0].up(); });
    CHECK(r.actuators[0].slave.station_address() == 2);
    r.run_until_ready();
    CHECK(r.actuators[1].slave.station_address() == 3);
}

TEST_CASE("Standby by process data is acknowledged when the inputs confirm it") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    const auto number = r.tell(jaus::standby{});
    CHECK(!r.answer(number));
    const auto took = r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(took <= 50ms);
    CHECK(r.motor().effort == 0);
}

TEST_CASE("an emergency of a cyclic slave is sent by mailbox, and its outputs are set to zero") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    const auto number = r.tell(rig::stop());
    const auto took = r.run_until([&] { return r.motor().effort == 0; });
    CHECK(took <= 100ms);
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(r.motor().emergency);
    r.run_until([&, cleared = r.tell(rig::clear())] { return r.is_acknowledged(cleared); });
    r.run(100ms);
    CHECK(r.motor().effort == 0);
    r.tell(jaus::resume{});
    r.run_until([&, moves = r.drive(20)] { return r.is_acknowledged(moves); });
    CHECK(r.motor().effort == Approx(20).margin(0.01));
}

TEST_CASE("messages without process data are sent by mailbox between cycles") {
    rig r{1, true};
    r.run_until_ready();
    const auto number = r.tell(jaus::set_travel_speed{.desired_speed = 3});
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(r.bus.process_data().statistics().lost == 0);
}

TEST_CASE("a frame of process data that is not sent ends no transfer") {
    rig r{rig::driving{50, true}};
    unsigned left = 1;
    r.takes = [&](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(frame));
        const bool has_process_data =
            std::ranges::any_of(view, [](const auto& each) { return each.header.cmd == ethercat::command::lrw; });
        if (!has_process_data || left == 0) return true;
        --left;
        return false;
    };
    r.actuators[0].hangs = true; // so that the transfer lasts until the next cycle
    const auto number = r.tell(jaus::set_travel_speed{.desired_speed = 3});
    r.run_until([&] { return left == 0; });
    r.actuators[0].hangs = false;
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_acknowledged(number));
}

TEST_CASE("a command that the slave does not accept in time is removed from its outputs") {
    rig r{1, true};
    r.run_until_ready();
    r.actuators[0].hangs = true; // its controller still answers
    const auto number = r.drive(50);
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.is_refused(number));
    CHECK(r.unit().stops().stop_is_pending());
    r.run(20ms);
    r.actuators[0].hangs = false;
    r.run(500ms);
    CHECK(std::ranges::count(r.motor().efforts, 0) != 0);
    CHECK(std::ranges::find_if(r.motor().efforts, [](double each) { return each > 1; }) == r.motor().efforts.end());
}

TEST_CASE("a slave that does not accept zeros in time counts as lost") {
    rig r{1, true};
    r.run_until_ready();
    r.actuators[0].hangs = true;
    r.tell(jaus::standby{});
    const auto took = r.run_until([&] { return r.watcher.lost == 1; });
    CHECK(took <= 120ms);
    CHECK(r.watcher.last_loss == bridging::loss::no_process_data);
}

TEST_CASE("answering a query from the inputs does not change the bytes of a running transfer") {
    rig r{1, true};
    r.run_until_ready();
    r.actuators[0].hangs = true; // the download remains in the mailbox until it continues
    r.motor().executed.clear();
    const auto number = r.tell(jaus::set_travel_speed{.desired_speed = 3});
    r.frames_to_lose = 1; // the write is repeated, out of the packet
    for (int i = 0; i != 8; ++i) {
        r.tell(jaus::query_wrench_effort{.presence_vector = 1}, 0, ack_nak::none);
        r.run(1ms);
    }
    r.actuators[0].hangs = false;
    r.run_until([&] { return r.answer(number).has_value(); });
    CHECK(r.received<jaus::report_wrench_effort>().size() == 8);
    CHECK(r.is_acknowledged(number));
    CHECK(std::ranges::count(r.motor().executed, jaus::command_code_of<jaus::set_travel_speed>) == 1);
}

TEST_CASE("the loss of one cyclic slave does not stop the process data of another") {
    rig r{2, true};
    r.run_until_ready();
    r.run_until_acknowledged(r.drive(50, 0));
    r.run_until_acknowledged(r.drive(40, 1));
    r.actuators[1].power_cycle();
    r.run_until([&] { return r.watcher.lost == 1; });
    CHECK(r.motor(0).effort == Approx(50).margin(0.01));
    r.run_until([&] { return r.watcher.up == 3; });
    CHECK(r.watcher.lost == 1);
    CHECK(r.motor(0).effort == Approx(50).margin(0.01));
    CHECK(r.motor(1).effort == 0);
    CHECK(r.unit(0).state() == status::ready);
    CHECK(r.bus.master().statistics().foreign == 0); // also the frames that were outstanding at the change
}

TEST_CASE("a process-data command that arrives before a stop order is confirmed waits, and is not sent by mailbox") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    r.lose(rig::operator_unit);
    REQUIRE(r.unit().stops().stop_is_pending());
    REQUIRE(r.unit().state() == status::ready);
    const auto number = r.drive(20);
    r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(std::ranges::count(r.motor().executed, jaus::command_code_of<jaus::set_wrench_effort>) == 0);
    REQUIRE(r.motor().efforts.size() >= 3);
    CHECK(*(r.motor().efforts.end() - 2) == 0);
    CHECK(r.motor().efforts.back() == Approx(20).margin(0.01));
}

TEST_CASE("a stop order is written to the outputs even if many commands wait for the slave") {
    rig r{1, true};
    r.run_until_ready();
    std::vector<std::uint16_t> numbers;
    for (int i = 0; i != 40; ++i) numbers.push_back(r.drive(i));
    const auto number = r.tell(jaus::standby{});
    const auto took = r.run_until([&] { return r.is_acknowledged(number); });
    CHECK(took <= 30ms);
    CHECK(r.motor().effort == 0);
    for (const auto each : numbers) CHECK(r.is_refused(each));
}

TEST_CASE("lost process data frames do not count as loss of the slave, and the mailbox continues to work") {
    rig r{1, true};
    r.run_until_ready();
    for (int i = 0; i != 20; ++i) {
        r.frames_to_lose = 3;
        const auto number = r.tell(jaus::set_travel_speed{.desired_speed = 3});
        r.run_until([&] { return r.answer(number).has_value(); });
        CHECK(r.is_acknowledged(number));
        r.run(50ms); // the slave's watchdog
    }
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("the end of the program stops a cyclic slave") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    r.shut_down();
    const auto took = r.run_until([&] { return r.bus.at_rest(); });
    CHECK(took <= 50ms);
    CHECK(r.motor().effort == 0);
}

TEST_CASE("loss of a sender without control stops the slave in cycles") {
    rig r{rig::driving{.percent = 50, .cyclic = true}};
    for (int i = 0; i != 10; ++i) {
        r.run(100ms);
        r.tell(jaus::report_heartbeat_pulse{}, 0, ack_nak::none);
    }
    CHECK(r.motor().effort != 0);
    r.run_until([&] { return r.motor().effort == 0; }, r.core_options.control.timeout + 30ms);
    r.run_until([&] { return r.unit().stops().settled(); });
    CHECK(r.watcher.stop_causes.back() == bridging::stop_cause::sender_lost);
    // Of commands without acknowledgement, too.
    r.drive(50, 0, ack_nak::none);
    r.run_until([&] { return r.motor().effort != 0; });
    r.run_until([&] { return r.motor().effort == 0; }, r.core_options.control.timeout + 30ms);
}

TEST_CASE("a restarted bridge does not reassign the image area of a slave that still runs") {
    rig before{2, true};
    before.actuators[0].hangs = true; // so that the other one comes first in the process image
    before.run_until([&] { return before.unit(1).state() == status::ready; });
    before.actuators[0].hangs = false;
    before.run_until_ready();
    before.run_until_acknowledged(before.drive(50, 1));

    rig r{2, true}; // after kill -9
    r.actuators.swap(before.actuators);
    r.now = before.now + 5ms;
    r.dead_from = 1; // a cable that is out for less than its watchdog waits
    const auto back = r.now + 70ms;
    while (r.now < back && r.unit().state() != status::ready) r.run(1ms);
    r.dead_from = 2;
    r.run_until([&] { return r.unit().state() == status::ready; });
    r.drive(30, 0);
    r.run(50ms);
    CHECK(r.motor(0).effort == Approx(30).margin(0.01));
    CHECK(r.motor(1).effort == 0);
    r.run_until_ready();
    CHECK(r.motor(1).effort == 0);
}
