// The robot arm behind its slave, in simulated time: what it obeys, what it refuses, and when it comes to rest.
#include "arm_application.hpp"
#include "arm_process_data.hpp"
#include "arm_watch.hpp"
#include "support/catch.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/image_exchange.hpp>
#include <jauscat/ethercat/listed_objects.hpp>
#include <jauscat/ethercat/process_data.hpp>
#include <jauscat/ethercat/standard_objects.hpp>
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
    example::arm arm{[this](const std::string& line) { said.push_back(line); }, [] {}};
    example::arm_application<table> application{2, arm};
    ethercat::listed_objects objects{application.objects, application};
    ethercat::slave_description description{.outputs = example::arm_process_data::outputs,
                                            .inputs = example::arm_process_data::inputs};
    ethercat::standard_objects dictionary{description, objects};
    ethercat::slave slave{description, dictionary};
    example::arm_process_data process_data{arm};
    example::arm_watch watch;
    test::simulated_link link{[this](std::span<std::byte> frame) {
        application.set_station(slave.station_address());
        slave.process(frame);
        work();
    }};
    ethercat::master master{};

    explicit robot(std::chrono::milliseconds command_timeout = 500ms) : watch{arm, command_timeout} {
        REQUIRE(run(master.bring_up(0, station)));
    }
    void work() {
        slave.on_time(link.now);
        watch.look(slave, link.now);
        process_data.work(slave);
    }
    void wait(std::chrono::nanoseconds time) {
        for (const auto end = link.now + time; link.now < end; link.now += 10ms) work();
    }
    ethercat::outcome run(bool started) {
        REQUIRE(started);
        return link.run(master);
    }
    /// Writes a message to the arm's object.
    ethercat::outcome send(const auto& message) {
        using delivery = ethercat::delivery<table>;
        std::array<std::byte, 64> bytes{};
        std::array<std::byte, delivery::translator::max_packet_size> packet{};
        constexpr jaus::address self{1, 33, station, 2};
        const auto size = jaus::make_message({.destination = self, .source = self}, message, bytes);
        REQUIRE(size);
        const auto used = delivery::translator::forth(std::span{bytes}.first(size.size()), packet);
        REQUIRE(used);
        const auto object = delivery::object_of(std::span{packet}.first(used.size()));
        return run(master.download(station, object.index, object.subindex, object.data));
    }
    void drive() {
        REQUIRE(send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50.0}));
        CHECK(arm.moves());
    }
    /// To OP; `cycle` exchanges process data from then on.
    ethercat::process_data to_op() {
        REQUIRE(run(master.configure(station)));
        REQUIRE(run(master.change_state(station, ethercat::al_state::op)));
        return ethercat::process_data{master.slaves(), {.watch_slaves = true}};
    }
    void cycle(ethercat::process_data& data) {
        std::array<std::byte, ethercat::max_frame_size> frame{};
        const auto bytes = std::span{frame}.first(data.next_frame(frame, link.now));
        slave.process(bytes);
        REQUIRE(data.on_frame(bytes));
        work();
        link.now += 10ms;
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
const ethercat::outcome refused{.error = ethercat::master_errc::sdo_abort, .detail = 0x08000022};

} // namespace

TEST_CASE("efforts by mailbox end when no message has come for the command timeout") {
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

TEST_CASE("in an emergency the arm aborts what moves, and obeys what brings it to rest") {
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

TEST_CASE("a command that process data bring in an emergency is not taken, then or later") {
    using exchange =
        ethercat::image_exchange<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;
    robot r;
    REQUIRE(r.send(emergency()));
    auto data = r.to_op();
    const auto& record = *r.master.find(station);
    exchange jaus_side{{.subsystem = 2, .station = station}, 33};
    r.cycle(data);
    r.cycle(data);
    REQUIRE(jaus_side.start(data.outputs(record), data.inputs(record)));
    const auto command = [&](double effort) {
        std::array<std::byte, 32> body{};
        const auto size = wire::encode(jaus::set_wrench_effort{.propulsive_linear_effort_x = effort}, body);
        REQUIRE(size);
        const jaus::header head{.command_code = exchange::command_code};
        REQUIRE(jaus_side.on_command(head, std::span{body}.first(size.size()), data.outputs(record),
                                     data.inputs(record), {}) == translate::errc::ok);
        for (int i = 0; i != 3; ++i) r.cycle(data);
        return exchange::given(data.outputs(record)) == exchange::taken(data.inputs(record));
    };
    CHECK_FALSE(command(50));
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("in an emergency: refused"));
    REQUIRE(r.send(end_of_emergency()));
    for (int i = 0; i != 3; ++i) r.cycle(data);
    CHECK_FALSE(r.arm.moves()); // the old command still stands in the outputs
    CHECK(command(60));
    CHECK(r.arm.moves());
    REQUIRE(r.send(emergency()));
    CHECK(command(0)); // a stop
}

TEST_CASE("the arm comes to rest when its slave leaves the states in which it is commanded") {
    robot r;
    r.drive();
    REQUIRE(r.run(r.master.change_state(station, ethercat::al_state::init)));
    CHECK_FALSE(r.arm.moves());

    REQUIRE(r.run(r.master.bring_up(0, station)));
    r.drive();
    REQUIRE(r.run(r.master.bring_up(0, station))); // another master takes it over
    CHECK_FALSE(r.arm.moves());

    r.drive();
    std::array<std::byte, 2> other{std::byte{9}};
    REQUIRE(r.run(r.master.exchange(ethercat::command::apwr, 0, 0x0010, other)));
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("another station address: all efforts to zero"));

    REQUIRE(r.run(r.master.bring_up(0, station)));
    auto data = r.to_op();
    r.cycle(data);
    r.drive(); // by mailbox, though in OP
    r.wait(120ms);
    CHECK(r.slave.state() == ethercat::al_state::safe_op);
    CHECK_FALSE(r.arm.moves());
    CHECK(r.says("no process data any more: all efforts to zero"));
}
