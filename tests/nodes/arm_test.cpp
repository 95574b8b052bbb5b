// The robot arm behind its slave, in simulated time: what it obeys, what it refuses, and when it comes to rest.
#include "arm_application.hpp"
#include "arm_process_data.hpp"
#include "arm_watch.hpp"
#include "support/arm_slave.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/mapped_objects.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <string>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;

namespace {

using table = translation::seed_table;
constexpr std::uint16_t station = 2;

// The arm and its master.
struct robot {
    std::vector<std::string> said{};
    example::arm arm{[this](auto, const auto&, const std::string& line) { said.push_back(line); }, [] {}};
    std::uint16_t at; // its station address
    example::arm_application<table> application;
    bridging::listed_objects objects{application.objects, application};
    ethercat::mapped_objects mapped{example::arm_slave, objects};
    ethercat::standard_objects dictionary{example::arm_slave, mapped};
    ethercat::slave slave{example::arm_slave, dictionary};
    example::arm_process_data process_data{arm};
    example::arm_watch watch;
    test::simulated_link link{[this](std::span<std::byte> frame) {
        application.set_station(slave.station_address());
        slave.process(frame);
        work();
    }};
    ethercat::master_for<16> master{};
    ethercat::process_data_for<1, 64> data{};

    explicit robot(std::chrono::milliseconds command_timeout = 500ms, std::uint16_t address = station,
                   std::optional<std::uint8_t> node = {})
        : at{address}, application{2, arm, node}, watch{arm, command_timeout} {
        mapped.show(slave.outputs(), slave.inputs());
        REQUIRE(run(ethercat::bring_up{0, at}));
    }
    void work() {
        slave.on_time(link.now);
        watch.look(slave, link.now);
        process_data.work(slave);
    }
    void wait(std::chrono::nanoseconds time) {
        for (const auto end = link.now + time; link.now < end; link.now += 10ms) work();
    }
    template <ethercat::master_job Job> typename Job::result_type run(const Job& job) { return link.run(master, job); }
    /// Writes a message to the arm's object.
    ethercat::master_result<> send(const auto& message) {
        using delivery = bridging::delivery<table>;
        std::array<std::byte, 64> bytes{};
        std::array<std::byte, delivery::translator::max_packet_size> packet{};
        constexpr jaus::address self{1, 33, station, 2};
        const auto made = jaus::make_message({.destination = self, .source = self}, message, bytes);
        REQUIRE(made);
        const auto used = delivery::translator::to_packet(*made, packet);
        REQUIRE(used);
        const auto object = delivery::object_of(*used);
        return run(ethercat::download{at, object.index, object.subindex, object.data});
    }
    void drive() {
        REQUIRE(send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50.0}));
        CHECK(arm.moves());
    }
    /// To OP; `cycle` exchanges process data from then on.
    void to_op() {
        REQUIRE(run(ethercat::configure{station}));
        REQUIRE(run(ethercat::change_state{station, ethercat::al_state::op}));
        data.set_slaves(master.slaves(), {.watch_slaves = true});
    }
    void cycle() {
        data.begin_cycle();
        std::array<std::byte, ethercat::max_frame_size> frame{};
        const auto bytes = std::span{frame}.first(data.next_frame(frame, link.now));
        slave.process(bytes);
        REQUIRE(data.on_frame(bytes));
        work();
        link.now += 10ms;
    }
    /// What an upload brings, in hex; empty if it is aborted.
    std::string object(std::uint16_t index, std::uint8_t subindex) {
        std::vector<std::byte> value(64);
        const auto result = run(ethercat::upload{at, index, subindex, value});
        return result ? test::to_hex(*result) : std::string{};
    }
    bool says(const std::string& line) const { return std::ranges::find(said, line) != said.end(); }
};

jaus::set_emergency emergency() {
    jaus::set_emergency set{};
    set.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
    return set;
}
jaus::clear_emergency end_of_emergency() {
    jaus::clear_emergency clear{};
    clear.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
    return clear;
}
const ethercat::master_error refused{.code = ethercat::master_errc::sdo_abort,
                                     .abort = ethercat::abort_code{0x08000022}};

} // namespace

TEST_CASE("efforts by mailbox end after the command timeout without a message") {
    robot r;
    r.drive();
    r.wait(490ms);
    CHECK(r.arm.moves());
    r.wait(30ms);
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("no message for 500 ms: all efforts to zero"));

    r.drive();
    for (int i = 0; i != 20; ++i) { // a pulse every 100 ms is life
        r.wait(100ms);
        REQUIRE(r.send(jaus::report_heartbeat_pulse{}));
    }
    CHECK(r.arm.moves());
    r.wait(520ms);
    CHECK_FALSE(r.arm.moves());

    robot without{0ms};
    without.drive();
    without.wait(60s);
    CHECK(without.arm.moves());
}

TEST_CASE("an arm with a node of its own accepts any station address, and without one reports its address") {
    for (const std::uint16_t address : {std::uint16_t{1}, std::uint16_t{1001}, std::uint16_t{0x1001}}) {
        robot r{500ms, address, station};
        r.drive();
        CHECK(r.arm.efforts().propulsive_linear_effort_x.value_or(0) > 49);
    }
    robot without{500ms, 0x1001};
    CHECK(without.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50.0}).error() ==
          ethercat::master_error{.code = ethercat::master_errc::sdo_abort, .abort = ethercat::abort_code{0x06040043}});
    CHECK_FALSE(without.arm.moves());
    CHECK(without.says("refused an object: the station address 4097 (0x1001) is not a JAUS node, 1 to 254: give the "
                       "node with --node"));
}

TEST_CASE("the arm's dictionary has the objects that its PDOs map, and those that tools require") {
    robot r;
    CHECK(r.object(0x1001, 0) == "00");
    CHECK(r.object(0x1009, 0) == "65 6d 75 6c 61 74 65 64");
    CHECK(r.object(0x100A, 0) == "31");
    for (const std::uint16_t synchronization : {std::uint16_t{0x1C32}, std::uint16_t{0x1C33}}) {
        CHECK(r.object(synchronization, 0) == "06");
        CHECK(r.object(synchronization, 1) == "00 00");
        CHECK(r.object(synchronization, 4) == "01 00");
        CHECK(r.object(synchronization, 5) == "00 00 00 00");
    }
    for (const std::uint16_t pdo : {std::uint16_t{0x1600}, std::uint16_t{0x1A00}}) {
        REQUIRE(r.object(pdo, 0) == "0e");
        for (std::uint8_t i = 1; i <= 14; ++i) {
            const auto mapped = test::from_hex(r.object(pdo, i)); // bits, subindex, index
            const auto index = std::to_integer<unsigned>(mapped[2]) | std::to_integer<unsigned>(mapped[3]) << 8U;
            const auto value = r.object(static_cast<std::uint16_t>(index), std::to_integer<std::uint8_t>(mapped[1]));
            INFO(std::hex << index << ':' << std::to_integer<unsigned>(mapped[1]) << " is " << value);
            CHECK((value.size() + 1) / 3 == std::to_integer<unsigned>(mapped[0]) / 8);
        }
    }
    CHECK(r.object(0x7000, 15).empty());

    r.to_op();
    auto& data = r.data;
    const auto outputs = data.outputs(r.master.slaves()[0]);
    std::ranges::copy(test::from_hex("0100 0100 ff3f"), outputs.begin());
    for (int i = 0; i != 4; ++i) r.cycle();
    CHECK(r.object(0x7000, 3) == "ff 3f");
    CHECK(r.object(0x6000, 1) == "01 00");
    CHECK(r.object(0x6000, 3) == "ff 3f");
}

TEST_CASE("in an emergency the arm aborts motion commands, and executes stop orders") {
    robot r;
    r.drive();
    REQUIRE(r.send(emergency()));
    CHECK(r.says("EMERGENCY: all efforts to zero"));
    CHECK(r.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50.0}) == refused);
    CHECK(r.send(jaus::set_travel_speed{.desired_speed = 1.0}) == refused);
    CHECK_FALSE(r.arm.moves());
    CHECK(r.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 0.0}));
    CHECK(r.send(jaus::set_travel_speed{}));

    CHECK(r.send(jaus::clear_emergency{})); // without its code
    CHECK(r.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50.0}) == refused);
    CHECK(r.send(end_of_emergency()));
    r.drive();
    CHECK(r.send(jaus::set_emergency{})); // whatever its code says
    CHECK_FALSE(r.arm.moves());
    CHECK(r.send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50.0}) == refused);
}

TEST_CASE("a process-data command in an emergency is not executed, then or later") {
    using exchange =
        bridging::image_exchange<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;
    robot r;
    REQUIRE(r.send(emergency()));
    r.to_op();
    auto& data = r.data;
    const auto& record = *r.master.find(station);
    exchange jaus_side{{.subsystem = 2, .station = station}, 33};
    r.cycle();
    r.cycle();
    REQUIRE(jaus_side.start(data.outputs(record), data.inputs(record)));
    const auto command = [&](double effort) {
        std::array<std::byte, 32> body{};
        const auto encoded = wire::encode(jaus::set_wrench_effort{.propulsive_linear_effort_x = effort}, body);
        REQUIRE(encoded);
        const jaus::header head{.command_code = exchange::command_code};
        REQUIRE(jaus_side.on_command(head, *encoded, data.outputs(record), data.inputs(record), {}) ==
                translate::errc::ok);
        for (int i = 0; i != 3; ++i) r.cycle();
        return exchange::given(data.outputs(record)) == exchange::taken(data.inputs(record));
    };
    CHECK_FALSE(command(50));
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("in an emergency: refused"));
    REQUIRE(r.send(end_of_emergency()));
    for (int i = 0; i != 3; ++i) r.cycle();
    CHECK_FALSE(r.arm.moves()); // the old command still stands in the outputs
    CHECK(command(60));
    CHECK(r.arm.moves());
    REQUIRE(r.send(emergency()));
    CHECK(command(0)); // a stop
}

TEST_CASE("the arm stops when its slave leaves the states in which it can be commanded") {
    robot r;
    r.drive();
    REQUIRE(r.run(ethercat::change_state{station, ethercat::al_state::init}));
    CHECK_FALSE(r.arm.moves());

    REQUIRE(r.run(ethercat::bring_up{0, station}));
    r.drive();
    REQUIRE(r.run(ethercat::bring_up{0, station})); // another master takes it over
    CHECK_FALSE(r.arm.moves());

    r.drive();
    std::array<std::byte, 2> other{std::byte{9}};
    REQUIRE(r.run(ethercat::exchange_datagram{ethercat::command::apwr, 0, 0x0010, other}));
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("another station address: all efforts to zero"));

    REQUIRE(r.run(ethercat::bring_up{0, station}));
    r.to_op();
    r.cycle();
    r.drive(); // by mailbox, though in OP
    r.wait(120ms);
    CHECK(r.slave.state() == ethercat::al_state::safe_op);
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("no process data any more: all efforts to zero"));
}
