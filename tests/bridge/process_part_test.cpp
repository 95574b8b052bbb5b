// A component with a process part of its own, in front of several slaves.
#include "joint_part.hpp"
#include "rig.hpp"

using namespace test;
using jaus::ack_nak;
using status = jaus::primary_status_code;

namespace {

/// An arm: one component in front of as many actuators as joints.
struct arm {
    explicit arm(std::size_t joints) : r{joints, true, {&part}} { r.run_until_ready(); }

    std::uint16_t drive(double percent) {
        jaus::basic_set_joint_efforts<joint_part::most> message{};
        for (std::size_t i = 0; i != r.actuators.size(); ++i)
            REQUIRE(message.joint_effort.push_back(percent + static_cast<double>(i)));
        return r.tell(message);
    }
    void run_until_moving(double percent) { r.run_until_acknowledged(drive(percent)); }
    bool is_at_rest() const {
        return std::ranges::all_of(r.actuators, [](const auto& each) { return each.behind.effort == 0; });
    }

    joint_part part{};
    rig r;
};

} // namespace

TEST_CASE("element i of a joint list goes to slave i, and is acknowledged when all have executed it") {
    arm a{6};
    a.r.actuators[4].hangs = true;
    const auto number = a.drive(30);
    a.r.run(35ms);
    CHECK(!a.r.answer(number));
    a.r.actuators[4].hangs = false;
    a.r.run_until([&] { return a.r.is_acknowledged(number); });
    for (std::size_t i = 0; i != 6; ++i) CHECK(a.r.motor(i).effort == Approx(30 + static_cast<double>(i)).margin(0.01));
    a.r.tell(jaus::query_joint_efforts{}, 0, ack_nak::none);
    a.r.run(30ms);
    const auto reports = a.r.received<jaus::basic_report_joint_efforts<joint_part::most>>();
    REQUIRE(reports.size() == 1);
    REQUIRE(reports[0].joint_effort.size() == 6);
    CHECK(reports[0].joint_effort[5] == Approx(35).margin(0.01));
    CHECK(a.part.starts == 1);
}

TEST_CASE("a part takes one step in each cycle, also when the cycle's frame is lost") {
    arm a{2};
    const auto before = a.part.steps;
    a.r.run(200ms);
    CHECK(a.part.steps - before >= 19);
    CHECK(a.part.steps - before <= 21);
    a.r.frames_to_lose = 3;
    const auto lossy = a.part.steps;
    a.r.run(50ms);
    CHECK(a.part.steps - lossy >= 4);
    CHECK(a.part.steps - lossy <= 6);
}

TEST_CASE("a lost slave brings the others of its component to rest") {
    arm a{6};
    a.run_until_moving(30);
    SECTION("it was reset") { a.r.actuators[3].power_cycle(); }
    SECTION("it left its state") {
        a.r.actuators[3].slave.power_on(); // also its address
    }
    SECTION("the cable behind the third is out") { a.r.dead_from = 3; }
    const auto took = a.r.run_until([&] { return a.r.watcher.lost != 0; });
    CHECK(took <= 21ms); // two cycles
    CHECK(a.r.unit().state() == status::failure);
    CHECK(a.r.run_until([&] {
        return std::ranges::all_of(std::array{0, 1, 2}, [&](std::size_t i) { return a.r.motor(i).effort == 0; });
    }) <= 21ms);
    CHECK(a.part.starts == 1);
    const auto number = a.drive(20);
    CHECK(a.r.last_outcome == jaus::component_outcome::not_ready);
    CHECK(!a.r.is_acknowledged(number));
    a.r.run(20ms);
    if (a.r.dead_from != 3) CHECK(a.part.missing <= 1);
    a.r.dead_from = 1000;
    a.r.run_until_ready();
    CHECK(a.part.starts == 2);
    CHECK(a.part.checks == 6 + a.r.watcher.lost); // the objects of each slave that has returned, again
    CHECK(a.is_at_rest());
    a.run_until_moving(20);
    CHECK(a.r.motor(3).effort == Approx(23).margin(0.01));
}

TEST_CASE("a drive's fault brings the component to Failure and all its slaves to rest, until it has ended") {
    arm a{3};
    a.run_until_moving(30);
    a.part.fault = bridging::drive_fault{.slave = 1, .code = 0x8611};
    const auto took = a.r.run_until([&] { return a.r.unit().state() == status::failure; });
    CHECK(took <= 21ms);
    REQUIRE(a.r.watcher.faults.size() == 1);
    CHECK(a.r.watcher.faults[0] == bridging::drive_fault{.slave = 1, .code = 0x8611});
    CHECK(a.r.run_until([&] { return a.is_at_rest() && a.r.unit().stops().settled(); }) <= 30ms);
    CHECK(a.r.watcher.lost == 0);
    a.r.run(100ms);
    CHECK(a.r.unit().state() == status::failure);
    const auto number = a.drive(20);
    a.r.run(50ms);
    CHECK(!a.r.is_acknowledged(number));
    CHECK(a.is_at_rest());

    SECTION("it does not end by a Reset") {
        a.part.reset_helps = false;
        a.r.tell(jaus::reset{});
        a.r.run(50ms);
        CHECK(a.part.resets == 1);
        CHECK(a.r.unit().state() == status::failure);
        a.part.fault.reset();
    }
    SECTION("a Reset acknowledges it") { a.r.tell(jaus::reset{}); }
    a.r.run_until_ready();
    CHECK(a.r.watcher.ended_faults == 1);
    CHECK(a.part.starts == 1);
    a.run_until_moving(20);
    a.part.fault = bridging::drive_fault{.slave = 1, .code = 0x8611}; // the same, again
    a.r.run_until([&] { return a.r.unit().state() == status::failure; });
    CHECK(a.r.watcher.faults.size() == 2);
}

TEST_CASE("a part without a mailbox gets emergencies, and other messages are unknown") {
    arm a{2};
    a.run_until_moving(30);
    for (auto& each : a.r.actuators) each.behind.executed.clear();
    const auto number = a.r.tell(rig::stop());
    const auto took = a.r.run_until([&] { return a.r.is_acknowledged(number); });
    CHECK(took <= 30ms);
    CHECK(a.is_at_rest());
    a.r.run_until([&, cleared = a.r.tell(rig::clear())] { return a.r.is_acknowledged(cleared); });
    a.r.tell(jaus::resume{});
    a.run_until_moving(10);
    a.r.tell(jaus::set_travel_speed{.desired_speed = 3});
    CHECK(a.r.last_outcome == jaus::component_outcome::unknown);
    for (const auto& each : a.r.actuators) CHECK(each.behind.executed.empty());
}

TEST_CASE("an operator that is lost, and the end of the program, bring all slaves of a component to rest") {
    arm a{3};
    a.r.tell(jaus::request_component_control{.authority_code = 100}, 0, ack_nak::none);
    a.run_until_moving(30);
    SECTION("the operator") {
        a.r.lose(rig::operator_unit);
        CHECK(a.r.run_until([&] { return a.is_at_rest(); }) <= 30ms);
        CHECK(a.r.unit().state() == status::ready);
    }
    SECTION("the program") {
        a.r.shut_down();
        CHECK(a.r.run_until([&] { return a.r.bus.at_rest(); }) <= 30ms);
        CHECK(a.is_at_rest());
    }
}

TEST_CASE("a slave that does not obey a stop order is lost with its group") {
    arm a{3};
    a.run_until_moving(30);
    a.r.actuators[2].hangs = true;
    a.r.tell(jaus::standby{});
    const auto took = a.r.run_until([&] { return a.r.watcher.lost == 3; });
    CHECK(took <= 120ms);
    CHECK(a.r.unit().state() == status::failure);
    a.r.actuators[2].hangs = false;
    a.r.run_until([&] { return a.r.unit().state() == status::standby; });
    CHECK(a.is_at_rest());
}

TEST_CASE("a slave that does not obey a stop order is lost within the limit, also where another one is lost already") {
    arm a{3};
    a.run_until_moving(30);
    const bool obeys = GENERATE(false, true);
    a.r.motor(0).emergency = !obeys; // it takes no outputs
    a.r.dead_from = 1;
    a.r.run_until([&] { return a.r.watcher.lost == 2; }, 21ms);
    a.r.run(100ms);
    CHECK(a.r.watcher.lost == (obeys ? 2 : 3));
    if (!obeys) CHECK(a.r.watcher.last_loss == bridging::loss::no_process_data);
    CHECK(a.r.unit().stops().stop_is_pending()); // the others have not executed it
    CHECK(a.r.motor(0).effort == 0);             // a slave that leaves OP stops by itself
    a.r.motor(0).emergency = false;
    a.r.dead_from = 1000;
    a.r.run_until_ready();
    CHECK(a.is_at_rest());
    CHECK(a.r.watcher.lost == (obeys ? 2 : 3));
}

TEST_CASE("a slave that is back before others of its group is not asked to execute their stop order") {
    arm a{3};
    a.run_until_moving(30);
    a.r.motor(0).emergency = true; // it takes no outputs
    const bool is_first = GENERATE(true, false);
    a.r.dead_from = 2;
    if (!is_first) a.r.run_until([&] { return a.r.watcher.lost == 1; }, 21ms);
    a.r.actuators[1].power_cycle();
    a.r.run_until([&] { return a.r.watcher.lost == 2; }, 21ms);
    a.r.run_until([&] { return a.r.fronts[1].up(); }, 60ms);
    a.r.motor(0).emergency = false; // it executes the order late, but in time
    a.r.run(200ms);
    CHECK(a.r.watcher.lost == 2);
    CHECK(a.r.fronts[0].up());
    CHECK(a.r.fronts[1].up());
    CHECK(a.r.motor(0).effort == 0);
    CHECK(a.r.unit().stops().stop_is_pending());
    a.r.dead_from = 1000;
    a.r.run_until_ready();
    CHECK(a.is_at_rest());
    a.run_until_moving(20);
}

TEST_CASE("start-up objects that a slave does not have are passed over") {
    static constexpr std::array vendor{std::byte{1}, std::byte{}, std::byte{}, std::byte{}};
    joint_part part;
    part.start_up_objects = {{.index = 0x1FFF, .subindex = 0, .data = vendor},  // no such object
                             {.index = 0x1018, .subindex = 9, .data = vendor},  // no such subindex
                             {.index = 0x1018, .subindex = 1, .data = vendor}}; // has this value already
    rig r{1, true, {&part}};
    r.run_until_ready();
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("a slave that refuses to tell a start-up object that it has does not operate") {
    static constexpr std::array value{std::byte{1}};
    joint_part part;
    part.start_up_objects = {{.index = 6933, .subindex = 26, .data = value}}; // can only be written
    rig r{1, true, {&part}};
    r.run_until([&] { return r.watcher.lost == 2; });
    CHECK(r.watcher.last_loss == bridging::loss::no_process_data);
    CHECK_FALSE(r.fronts[0].up());
    CHECK(r.bus.bring_up_error(r.fronts[0]).abort == ethercat::abort_code::write_only);
}

TEST_CASE("slaves with other process data than a part needs are not served") {
    joint_part part;
    bridging::process_channel empty{part, {}};
    CHECK(empty.fronts().empty());
    std::array<std::byte, 4> few{};
    const bridging::slave_data wrong{.outputs = few, .inputs = few};
    CHECK(part.start({&wrong, 1}, 10ms).error() == jauscat::translate::errc::wrong_size);
    bridging::wrench_effort_part efforts;
    CHECK(efforts.start({&wrong, 1}, 10ms).error() == jauscat::translate::errc::wrong_size);
}

TEST_CASE("256 slaves in one ring: the loss of one stops its own component alone, within two cycles") {
    constexpr std::size_t joints = 32, arms = 8;
    std::deque<joint_part> parts(arms);
    std::vector<bridging::process_part*> groups;
    for (auto& each : parts) groups.push_back(&each);
    rig r{arms * joints, true, groups};
    r.run_until_ready();
    CHECK(r.bus.process_data().fits());
    jaus::basic_set_joint_efforts<joint_part::most> message{};
    for (std::size_t i = 0; i != joints; ++i) REQUIRE(message.joint_effort.push_back(static_cast<double>(i)));
    std::vector<std::uint16_t> numbers;
    for (std::size_t i = 0; i != arms; ++i) numbers.push_back(r.tell(message, i));
    for (const auto number : numbers) r.run_until([&] { return r.is_acknowledged(number); });
    for (std::size_t i = 0; i != arms * joints; ++i)
        CHECK(r.motor(i).effort == Approx(static_cast<double>(i % joints)).margin(0.01));

    r.actuators[5 * joints + 17].power_cycle();
    CHECK(r.run_until([&] { return r.unit(5).state() == status::failure; }) <= 21ms);
    CHECK(r.run_until([&] { return r.motor(5 * joints + 31).effort == 0; }) <= 21ms);
    r.run(50ms);
    CHECK(r.watcher.lost == 1);
    for (std::size_t i = 0; i != arms; ++i)
        if (i != 5) CHECK(r.motor(i * joints + 31).effort == Approx(31).margin(0.01));
    r.run_until_ready();
    CHECK(r.motor(5 * joints + 31).effort == 0);
}
