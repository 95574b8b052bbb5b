// A bridge between an operator's node and actuators behind EtherCAT in UDP, all in this program.
#include "app/emulated_bus.hpp"
#include "bridge/actuator.hpp"
#include "bridge/joint_part.hpp"
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/until.hpp"
#include <jauscat/app/bridge.hpp>
#include <jauscat/app/component.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/bridge/observer.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using namespace std::chrono_literals;
using boost::system::error_code;
namespace asio = boost::asio;
namespace jaus = jauscat::jaus;
namespace ethercat = jauscat::ethercat;
namespace translation = jauscat::translation;
using jauscat::bus_errc;
using status = jaus::primary_status_code;

namespace {

/// Actuators of the nodes 2.2, 2.3, ... in one ring.
class actuator_bus : public jauscat::test::basic_emulated_bus<test::emulated_actuator> {
  public:
    explicit actuator_bus(std::size_t count, ethercat::clock_width clock = ethercat::clock_width::no_clock)
        : basic_emulated_bus{[=](auto& made) {
              for (std::size_t i = 0; i != count; ++i)
                  made.emplace_back(std::uint8_t{2}, static_cast<std::uint16_t>(2 + i), clock);
          }} {}

    [[nodiscard]] double effort(std::size_t i = 0) {
        return with(i, [](auto& each) { return each.behind.effort; });
    }
    /// How far the system times of the first two are apart, in ns.
    [[nodiscard]] std::int64_t spread() {
        return with_all([](auto& all) {
            const auto now = jauscat::net::now();
            return std::abs(static_cast<std::int64_t>(all[0].slave.clock().system_time(now) -
                                                      all[1].slave.clock().system_time(now)));
        });
    }
};

/// A file with an operator (1.1) and two controllers (2.2, 2.3).
class configuration {
  public:
    configuration() {
        const auto ports = support::free_ports<3>();
        const auto system = [&](const char* name, const char* id, std::size_t i) {
            return "<system><name>" + std::string{name} + "</name><jausip>" + id + "</jausip><ip>127.0.0.1</ip><port>" +
                   std::to_string(ports[i]) + "</port></system>\n";
        };
        const auto name = "jauscat_bridge_" + std::to_string(ports[0]) + ".xml"; // nobody else has this port
        path_ = std::filesystem::temp_directory_path() / name;
        std::ofstream{path_} << "<jausconfig>\n<thissystem>ocu</thissystem>\n"
                             << system("ocu", "1.1.0.0", 0) << system("arm", "2.2.0.0", 1)
                             << system("leg", "2.3.0.0", 2) << "</jausconfig>\n";
    }
    ~configuration() { std::remove(path_.c_str()); }
    configuration(const configuration&) = delete;
    configuration& operator=(const configuration&) = delete;

    [[nodiscard]] jauscat::node_options of(const char* name, std::vector<std::string>& lines) const {
        return {.config = path_, .this_system = name, .name = name, .log = [&lines](std::string_view line) {
                    lines.emplace_back(line);
                }};
    }

  private:
    std::string path_;
};

constexpr jaus::address arm{.instance = 1, .component = 33, .node = 2, .subsystem = 2};
constexpr jaus::address leg{.instance = 1, .component = 33, .node = 3, .subsystem = 2};

/// A ring, a bus, the nodes of operator and arm in one io_context.
struct bench {
    explicit bench(std::size_t slaves = 1,
                   const jauscat::bus_options& bus_options = {.frame_timeout = jauscat::test::frame_timeout},
                   ethercat::clock_width clock = ethercat::clock_width::no_clock)
        : ring{slaves, clock} {
        auto options = bus_options;
        options.log = [this](std::string_view line) { lines.emplace_back(line); };
        bus.emplace(context, ring.where(), options);
        unit.on(
            [this](const jaus::report_wrench_effort& report, const jaus::header& head) {
                reported = report.propulsive_linear_effort_x;
                reporter = head.source;
            },
            [this](const jaus::report_component_status& report) { told_state = report.primary_status_code; });
        unit.ready();
    }
    template <class Table = translation::seed_table>
    void serve(const jauscat::slave_choice& which = {.position = 0}, const jauscat::bridge_options& options = {}) {
        bridge.emplace(*robot, *bus, Table{}, options);
        bridge->serve({.component = 33}, bus->slave(which));
        bridge->when_up([this](const auto&) { ++up; });
        bridge->when_lost([this](const auto&, error_code why) { lost.push_back(why); });
        bridge->when_changed([this](const auto&, status now) { state = now; });
        bridge->when_at_rest([this](const auto&) { ++at_rest; });
    }
    void start() {
        robot->start();
        operator_node.start();
    }
    [[nodiscard]] bool until(auto done) { return support::until(context, done); }
    void run(std::chrono::milliseconds time) {
        context.restart();
        context.run_for(time);
    }
    /// The operator takes control, and commands an effort until it is in force.
    bool drive(double percent, std::size_t i = 0, const jaus::address& to = arm) {
        jaus::request_component_control request{.authority_code = 100};
        int turns = 0;
        return until([&] {
            if (turns++ % 20 == 0) {
                static_cast<void>(unit.send(to, request));
                static_cast<void>(unit.send(to, jaus::set_wrench_effort{.propulsive_linear_effort_x = percent}));
            }
            return std::abs(ring.effort(i) - percent) < 0.1;
        });
    }
    bool has_line(std::string_view part) const {
        return std::ranges::any_of(lines, [&](const auto& line) { return line.find(part) != line.npos; });
    }

    std::vector<std::string> lines{};
    configuration config{};
    actuator_bus ring;
    asio::io_context context{1};
    jauscat::node operator_node{context, config.of("ocu", lines)};
    jauscat::component unit{operator_node, {.id = 32, .name = "operator"}};
    std::optional<jauscat::node> robot{std::in_place, context, config.of("arm", lines)};
    std::optional<jauscat::bus> bus{};
    std::optional<jauscat::bridge> bridge{};
    unsigned up{}, at_rest{};
    std::vector<error_code> lost{};
    status state{};
    std::optional<double> reported{};
    jaus::address reporter{};
    std::optional<status> told_state{};
};

/// The component in front of three slaves.
constexpr jaus::address manipulator{.instance = 1, .component = 56, .node = 2, .subsystem = 2};
/// The operator takes control of it and drives the joints to 10, 20 and 30 percent.
bool drive_joints(bench& b) {
    int turns = 0;
    return b.until([&] {
        if (turns++ % 20 == 0) {
            static_cast<void>(b.unit.send(manipulator, jaus::request_component_control{.authority_code = 100}));
            static_cast<void>(b.unit.send(manipulator, jaus::basic_set_joint_efforts<3>{.joint_effort = {10, 20, 30}}));
        }
        return std::abs(b.ring.effort(0) - 10) < 0.1 && std::abs(b.ring.effort(2) - 30) < 0.1;
    });
}

const auto no_log = [](std::string_view) {};

} // namespace

TEST_CASE("a bridge carries commands to its slave, and reports back") {
    bench b;
    b.serve();
    CHECK_FALSE(b.bridge->is_up());
    b.start();
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    CHECK(b.up == 1);
    CHECK(b.bridge->is_up());
    CHECK(b.bridge->at_rest());
    CHECK(b.has_line("slave 0 answers, in PRE-OP"));
    REQUIRE(b.drive(40));
    int turns = 0;
    REQUIRE(b.until([&] {
        if (turns++ % 20 == 0)
            static_cast<void>(b.unit.send(
                arm, jaus::query_wrench_effort{.presence_vector = jaus::presence_bits_of<jaus::report_wrench_effort>}));
        return b.reported.has_value();
    }));
    CHECK(std::abs(*b.reported - 40) < 0.1);
    CHECK(b.lost.empty());
}

TEST_CASE("an actuator comes to rest when its controller is lost") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    b.run(700ms);
    CHECK(b.ring.effort() > 39); // the controller lives
    b.operator_node.stop();
    REQUIRE(b.until([&] { return b.ring.effort() == 0; }));
    CHECK(b.state == status::ready);
    CHECK(b.lost.empty());
}

TEST_CASE("a silent slave and garbage bring the actuator to rest, and the component to Failure") {
    const bool is_garbage = GENERATE(false, true);
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    auto& fault = is_garbage ? b.ring.is_garbage : b.ring.is_silent;
    const auto begun = jauscat::net::now();
    fault = true;
    REQUIRE(b.until([&] { return b.state == status::failure; }));
    CHECK(jauscat::net::now() - begun < 2s);
    CHECK(b.lost.size() == 1);
    CHECK(b.has_line("slave 0 is lost"));
    CHECK_FALSE(b.bridge->is_up());
    CHECK_FALSE(b.bridge->at_rest());
    fault = false;
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    CHECK(b.ring.effort() == 0);
    CHECK(b.bridge->at_rest());
    REQUIRE(b.drive(30));
}

TEST_CASE("a slave that was reset is brought up and to rest again") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    b.ring.with(0, [](auto& each) { each.power_cycle(); });
    REQUIRE(b.until([&] { return !b.lost.empty(); }));
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    REQUIRE(b.drive(20));
}

TEST_CASE("an actuator is at rest after the end of node, bridge and bus") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    SECTION("the node stops") { b.robot->stop(); }
    SECTION("the node ends") { b.robot.reset(); }
    SECTION("the bridge ends") { b.bridge.reset(); }
    SECTION("the bus ends") {
        b.bus.reset();
        REQUIRE(b.until([&] { return b.state == status::shutdown; }));
    }
    SECTION("the bus stops") { b.bus->stop(); }
    CHECK(b.ring.effort() == 0);
    b.run(20ms);
}

TEST_CASE("an end does not wait longer than a second for a slave that does not confirm") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    b.ring.is_silent = true;
    const auto begun = jauscat::net::now();
    b.robot->stop();
    CHECK(jauscat::net::now() - begun < 1s);
    CHECK(b.has_line("slave 0 has not confirmed that it is at rest"));
    CHECK_FALSE(b.bridge->at_rest());
}

TEST_CASE("an end reports a slave that was lost before and has not confirmed that it is at rest") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    b.ring.is_silent = true;
    REQUIRE(b.until([&] { return !b.lost.empty(); }));
    SECTION("the node stops") { b.robot->stop(); }
    SECTION("the bus stops first") {
        b.bus->stop();
        CHECK_FALSE(b.bridge->at_rest());
        b.robot->stop();
    }
    CHECK(b.has_line("slave 0 has not confirmed that it is at rest"));
    CHECK_FALSE(b.bridge->at_rest());
}

TEST_CASE("the state of a bridge's component is subscribed to") {
    bench b;
    b.serve();
    b.start();
    std::vector<status> told;
    jauscat::subscription<jaus::report_component_status> changes;
    b.unit.async_event<jaus::report_component_status>(
        arm, jaus::create_event{.event_type = jaus::event_type::every_change}, [&](error_code why, auto events) {
            REQUIRE_FALSE(why);
            changes = std::move(events);
        });
    std::function<void()> next = [&] {
        changes.async_next([&](error_code why, const jaus::report_component_status& report) {
            if (why) return;
            told.push_back(report.primary_status_code);
            next();
        });
    };
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    REQUIRE(b.until([&] { return b.drive(40); }));
    next();
    b.ring.with(0, [](auto& each) { each.power_cycle(); });
    REQUIRE(b.until([&] { return std::ranges::count(told, status::failure) != 0 && told.back() == status::ready; }));
}

TEST_CASE("a bus that ends first says whether its slaves are at rest") {
    const bool is_silent = GENERATE(false, true);
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    b.ring.is_silent = is_silent;
    b.bus->stop();
    b.robot->stop();
    CHECK(b.bridge->at_rest() == !is_silent);
    CHECK(b.has_line("slave 0 has not confirmed that it is at rest") == is_silent);
}

TEST_CASE("an application logs each step of a bridge itself") {
    std::vector<std::string> steps{};
    std::size_t frames_out{}, frames_in{};
    jauscat::bus_options options{.frame_timeout = jauscat::test::frame_timeout};
    options.on_frame = [&](const jauscat::passing_frame& frame) { ++(frame.is_sent ? frames_out : frames_in); };
    bench b{1, options};
    auto of_node = b.config.of("arm", b.lines);
    of_node.on_received = [&](const auto&, const jaus::header& head, auto) {
        if (head.command_code == jaus::command_code_of<jaus::set_wrench_effort>) steps.emplace_back("received");
    };
    of_node.on_handled = [&](const auto&, const jaus::header& head, auto, jaus::component_outcome what) {
        if (head.command_code == jaus::command_code_of<jaus::set_wrench_effort>) steps.emplace_back(describe(what));
    };
    of_node.on_sent = [&](std::span<const std::byte> message) {
        const auto head = jaus::split(message).header;
        if (head.source == arm && head.command_code == jaus::command_code_of<jaus::confirm_component_control>)
            steps.emplace_back("sent");
    };
    b.robot.emplace(b.context, of_node);
    b.serve();
    const auto translated = [&](const auto&, auto) { steps.emplace_back("translated"); };
    const auto stop = [&](const auto&, auto, jauscat::bridging::stop_cause why) {
        if (why == jauscat::bridging::stop_cause::program_ends) steps.emplace_back("stop");
    };
    const jauscat::bridging::observer by{.stop_required = stop, .translated = translated};
    b.bridge->observe(by);
    b.start();
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    steps.clear();
    REQUIRE(b.drive(40));
    const auto before = [&](const std::string& first, const std::string& second) {
        return std::ranges::find(steps, first) < std::ranges::find(steps, second) &&
               std::ranges::find(steps, second) != steps.end();
    };
    CHECK(before("sent", "received"));
    CHECK(before("received", "translated"));
    CHECK(std::ranges::find(steps, describe(jaus::component_outcome::deferred)) != steps.end());
    CHECK(frames_out != 0);
    CHECK(frames_in != 0);
    CHECK_FALSE(b.has_line("slave 0 answers"));
    b.robot->stop();
    CHECK(std::ranges::find(steps, "stop") != steps.end());
    CHECK(b.bridge->at_rest());
    CHECK(b.ring.effort() == 0);
}

TEST_CASE("a node starts again with its bridge") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    b.robot->stop();
    CHECK(b.ring.effort() == 0);
    b.run(20ms);
    b.robot->start();
    REQUIRE(b.drive(50));
}

TEST_CASE("an end in a callback of the bridge") {
    bench b;
    b.serve();
    b.bridge->when_up([&](const auto&) { b.bridge.reset(); });
    b.start();
    REQUIRE(b.until([&] { return !b.bridge; }));
    b.run(20ms);
}

TEST_CASE("an operator's emergency reaches the slave") {
    bench b;
    b.serve();
    b.start();
    REQUIRE(b.drive(40));
    jaus::set_emergency stop{};
    stop.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
    CHECK(b.unit.send(arm, stop));
    REQUIRE(b.until([&] { return b.ring.with(0, [](auto& each) { return each.behind.emergency; }); }));
    CHECK(b.ring.effort() == 0);
    REQUIRE(b.until([&] { return b.state == status::emergency; }));
}

TEST_CASE("a slave is served by its name, its identity, and after a start of the bus") {
    bench b;
    SECTION("by name") { b.serve({.name = "actuator"}); }
    SECTION("by position and identity") { b.serve({.position = 0, .identity = {.revision = 1}}); }
    SECTION("after a start") {
        std::optional<error_code> started;
        b.bus->async_start([&](error_code error) { started = error; });
        REQUIRE(b.until([&] { return started.has_value(); }));
        CHECK_FALSE(*started);
        b.serve({.identity = {.revision = 1}});
    }
    b.start();
    REQUIRE(b.drive(40));
}

TEST_CASE("a slave that is not there, or another one, is not served") {
    bench b;
    SECTION("name") {
        b.serve({.name = "gripper"});
        b.start();
        REQUIRE(b.until([&] { return b.has_line("slave gripper is not found"); }));
    }
    SECTION("identity") {
        b.serve({.position = 0, .identity = {.vendor = 99}});
        b.start();
        REQUIRE(b.until([&] { return b.has_line("slave 0 is not brought up: another slave"); }));
    }
    SECTION("position") {
        b.serve({.position = 3});
        b.start();
        REQUIRE(b.until([&] { return b.has_line("slave 3 is not brought up"); }));
    }
    CHECK(b.up == 0);
    CHECK_FALSE(b.bridge->is_up());
}

TEST_CASE("a bus works in a thread of its own") {
    const auto period = GENERATE(0ms, 5ms);
    bench b{2, {.frame_timeout = jauscat::test::frame_timeout, .thread = true}};
    b.serve({.position = 0}, {.period = period});
    b.start();
    REQUIRE(b.drive(40));
    b.run(200ms);
    std::this_thread::sleep_for(300ms); // the program is busy
    CHECK(b.lost.empty());
    std::optional<std::pair<error_code, std::uint32_t>> read;
    std::optional<std::thread::id> where;
    b.bus->slave({.position = 0}).async_read<std::uint32_t>(0x1018, 3, [&](error_code why, std::uint32_t value) {
        read.emplace(why, value);
        where = std::this_thread::get_id();
    });
    REQUIRE(b.until([&] { return read.has_value(); }));
    CHECK_FALSE(read->first);
    CHECK(read->second == 1);
    CHECK(where == std::this_thread::get_id());
    b.ring.is_silent = true;
    REQUIRE(b.until([&] { return b.state == status::failure; }));
    b.ring.is_silent = false;
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    REQUIRE(b.drive(30));
    SECTION("the node stops") { b.robot->stop(); }
    SECTION("the bridge ends") { b.bridge.reset(); }
    SECTION("the bus ends") { b.bus.reset(); }
    CHECK(b.ring.effort() == 0);
    b.run(20ms);
}

TEST_CASE("a stop order that the slave refuses is repeated, and logged") {
    bench b;
    b.ring.with(0, [](auto& each) {
        each.behind.abort_code_of = jaus::command_code_of<jaus::set_wrench_effort>;
        each.behind.aborts = 3;
    });
    b.serve();
    b.start();
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    CHECK(b.has_line("slave 0 has refused the stop order of 2.2.33.1"));
}

TEST_CASE("in cycles an effort goes by process data") {
    bench b;
    b.serve({.position = 0}, {.period = 10ms});
    b.start();
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    CHECK(b.has_line("slave 0 answers, in OP"));
    b.ring.with(0, [](auto& each) { CHECK(each.slave.state() == ethercat::al_state::op); });
    REQUIRE(b.drive(40));
    b.robot->stop();
    CHECK(b.ring.effort() == 0);
}

TEST_CASE("in cycles with SYNC signals the components of a bridge are ready in OP, and at rest at the end") {
    const bool thread = GENERATE(false, true);
    jauscat::net::slave_entry first{.name = "shoulder", .position = 0}, second{.name = "elbow", .position = 1};
    first.sync.emplace();
    second.sync.emplace().shift = 100'000;
    bench b{2,
            {.slaves = {first, second}, .frame_timeout = jauscat::test::frame_timeout, .thread = thread},
            ethercat::clock_width::bits_64};
    b.ring.with(0, [](auto& each) { each.slave.set_clock_error({.drift = 80'000, .start = 1'000'000'000}); });
    b.ring.with(1, [](auto& each) { each.slave.set_clock_error({.drift = -60'000, .start = 7'000'000'000}); });
    b.serve({.name = "shoulder"}, {.at_rest_within = 2s, .period = 5ms});
    b.bridge->serve({.component = 33, .instance = 2}, b.bus->slave({.name = "elbow"}));
    b.start();
    jaus::address second_unit = arm;
    second_unit.instance = 2;
    REQUIRE(b.until([&] { return b.up == 2; }));
    REQUIRE(b.drive(40));
    REQUIRE(b.drive(60, 1, second_unit));
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const auto before = b.ring.with(i, [](auto& each) {
            CHECK(each.slave.state() == ethercat::al_state::op);
            CHECK(each.slave.clock().activation().on);
            CHECK(each.slave.clock().activation().sync0);
            CHECK(each.slave.synchronization().sync0_cycle == 5'000'000);
            return each.slave.sync0_count();
        });
        REQUIRE(
            b.until([&] { return b.ring.with(i, [](auto& each) { return each.slave.sync0_count(); }) > before + 20; }));
    }
    CHECK(b.ring.spread() < 1'000);
    b.robot->stop();
    CHECK(b.ring.effort(0) == 0);
    CHECK(b.ring.effort(1) == 0);
    for (const auto& line : b.lines) UNSCOPED_INFO(line);
    CHECK(b.lost.empty());
    CHECK_FALSE(b.has_line("the distributed clocks differ"));
}

TEST_CASE("a component has a process image by tables of the application's") {
    constexpr jaus::address gripper{.instance = 1, .component = 45, .node = 2, .subsystem = 2};
    bench b;
    b.bridge.emplace(*b.robot, *b.bus, translation::seed_table{}, jauscat::bridge_options{.period = 10ms});
    b.bridge->serve(
        {.component = 45}, b.bus->slave({.position = 0}),
        jauscat::process_image<translation::set_wrench_effort_table, translation::report_wrench_effort_table>());
    b.start();
    REQUIRE(b.drive(40, 0, gripper));
    b.ring.with(0, [](auto& each) {
        CHECK(std::ranges::count(each.behind.executed, jaus::command_code_of<jaus::set_wrench_effort>) == 0);
    });
    b.operator_node.stop();
    REQUIRE(b.until([&] { return b.ring.effort() == 0; }));
}

TEST_CASE("a component in front of several slaves drives each, and rests when one is lost") {
    const bool thread = GENERATE(false, true);
    constexpr std::size_t joints = 3;
    bench b{joints, {.frame_timeout = jauscat::test::frame_timeout, .thread = thread}};
    b.bridge.emplace(*b.robot, *b.bus, translation::seed_table{}, jauscat::bridge_options{.period = 10ms});
    std::vector<jauscat::slave> slaves;
    for (std::uint16_t i = 0; i != joints; ++i) slaves.push_back(b.bus->slave({.position = i}));
    b.bridge->serve({.component = 56}, slaves, std::make_unique<test::joint_part>());
    std::vector<jauscat::slave_choice> lost;
    b.bridge->when_lost([&](const jauscat::slave_choice& which, error_code) { lost.push_back(which); });
    b.bridge->when_changed([&](const auto&, status now) { b.state = now; });
    b.start();
    REQUIRE(drive_joints(b));
    CHECK(b.bridge->is_up());
    b.ring.with(1, [](auto& each) { each.power_cycle(); });
    REQUIRE(b.until([&] { return b.state == status::failure; }));
    REQUIRE(b.until([&] { return b.ring.effort(0) == 0 && b.ring.effort(2) == 0; }));
    REQUIRE(b.until([&] { return b.state == status::ready && b.bridge->at_rest(); }));
    CHECK(lost.size() == 1);
    CHECK(lost[0].position == std::uint16_t{1});
    REQUIRE(drive_joints(b));
    SECTION("the node ends") { b.robot->stop(); }
    SECTION("the bridge ends") { b.bridge.reset(); }
    SECTION("the bus ends") { b.bus->stop(); }
    for (std::size_t i = 0; i != joints; ++i) CHECK(b.ring.effort(i) == 0);
    b.run(20ms);
}

TEST_CASE("a bridge takes a slave over that is in OP since an earlier life of its program") {
    bench b;
    asio::io_context earlier;
    std::optional<jauscat::bus> life{
        std::in_place, earlier, b.ring.where(),
        jauscat::bus_options{.frame_timeout = jauscat::test::frame_timeout, .log = no_log}};
    const auto run = [&](auto start) {
        std::optional<error_code> error;
        start([&](error_code why) { error = why; });
        REQUIRE(support::until(earlier, [&] { return error.has_value(); }));
        REQUIRE_FALSE(*error);
    };
    run([&](auto done) { life->async_start(done); });
    run([&](auto done) { life->slave({.position = 0}).async_operate({.period = 10ms, .watchdog = 6s}, done); });
    // It sends nothing any more. The application's own start is refused, a bridge's is not.
    std::optional<error_code> refused;
    b.bus->async_start([&](error_code why) { refused = why; });
    REQUIRE(b.until([&] { return refused.has_value(); }));
    CHECK(*refused == bus_errc::in_use);
    b.serve({.alias = 102});
    b.start();
    REQUIRE(b.drive(40));
    CHECK_FALSE(b.has_line("is not found"));
}

TEST_CASE("a named slave is served wherever it is, and never another one in its place") {
    const auto period = GENERATE(0ms, 10ms);
    enum class loss { reset, state, cable };
    const auto what = GENERATE(loss::reset, loss::state, loss::cable);
    bench b{2,
            {.slaves = {{.name = "elbow", .alias = 103}},
             .check_interval = 20ms,
             .frame_timeout = jauscat::test::frame_timeout}};
    b.ring.connect({0});
    b.serve({.name = "elbow"}, {.period = period});
    b.start();
    REQUIRE(b.until([&] { return b.has_line("slave \"elbow\" is refused: the slave is missing"); }));
    CHECK_FALSE(b.bridge->is_up());
    b.ring.connect({0, 1});
    REQUIRE(b.drive(40, 1));
    CHECK(b.has_line("slave \"elbow\" answers"));
    CHECK(b.bus->slave({.name = "elbow"}).info().station == 2);
    if (what == loss::reset) b.ring.with(1, [](auto& each) { each.power_cycle(); });
    if (what == loss::state)
        b.ring.with(1, [](auto& each) {
            each.hangs = true; // in OP its watchdog expires, in PRE-OP nothing is executed
        });
    if (what == loss::cable) b.ring.connect({0});
    REQUIRE(b.until([&] {
        static_cast<void>(b.unit.send(arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 40.0}));
        return b.state == status::failure;
    }));
    b.run(200ms);
    CHECK(b.ring.effort(0) == 0); // the other one is not taken for it
    if (what == loss::cable) CHECK_FALSE(b.bridge->is_up());
    b.ring.with(1, [](auto& each) { each.hangs = false; });
    if (what == loss::cable) b.ring.connect({1, 0}); // at another place
    REQUIRE(b.until([&] { return b.state == status::ready && b.bridge->at_rest(); }));
    REQUIRE(b.drive(41, 1));
    CHECK(b.ring.effort(0) == 0);
    if (what == loss::reset) b.robot->stop();
    if (what == loss::state) b.bridge.reset();
    if (what == loss::cable) b.bus->stop();
    CHECK(b.ring.effort(1) == 0);
    b.run(50ms);
}

TEST_CASE("a component in front of named slaves works again when one of them comes back elsewhere") {
    const bool thread = GENERATE(false, true);
    bench b{3,
            {.slaves = {{.name = "a", .alias = 102}, {.name = "b", .alias = 103}, {.name = "c", .alias = 104}},
             .check_interval = 20ms,
             .frame_timeout = jauscat::test::frame_timeout,
             .thread = thread}};
    b.bridge.emplace(*b.robot, *b.bus, translation::seed_table{}, jauscat::bridge_options{.period = 10ms});
    std::vector<jauscat::slave> slaves;
    for (const char* const name : {"a", "b", "c"}) slaves.push_back(b.bus->slave({.name = name}));
    b.bridge->serve({.component = 56}, slaves, std::make_unique<test::joint_part>());
    b.bridge->when_changed([&](const auto&, status now) { b.state = now; });
    b.ring.connect({2, 0, 1});
    b.start();
    REQUIRE(drive_joints(b));
    b.ring.connect({2, 0});
    REQUIRE(b.until([&] { return b.state == status::failure && b.ring.effort(0) == 0 && b.ring.effort(2) == 0; }));
    b.ring.with(1, [](auto& each) { each.power_cycle(); });
    b.ring.connect({1, 2, 0});
    REQUIRE(b.until([&] { return b.state == status::ready && b.bridge->at_rest(); }));
    REQUIRE(drive_joints(b));
    CHECK(std::abs(b.ring.effort(1) - 20) < 0.1);
    b.robot->stop();
    for (std::size_t i = 0; i != 3; ++i) CHECK(b.ring.effort(i) == 0);
}

TEST_CASE("operations of a bus go on beside its bridge") {
    bench b{2};
    b.serve();
    b.start();
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    std::optional<error_code> error;
    const auto wait = [&] {
        REQUIRE(b.until([&] { return error.has_value(); }));
        return *std::exchange(error, {});
    };
    b.bus->async_start([&](error_code why) { error = why; });
    CHECK_FALSE(wait());
    const auto all = b.bus->slaves();
    REQUIRE(all.size() == 2);
    CHECK(all[0].is_served);
    CHECK(all[0].station == 2);
    CHECK(all[0].name == "actuator");
    CHECK_FALSE(all[1].is_served);
    for (std::uint16_t i = 0; i != 2; ++i) {
        std::uint32_t revision{};
        b.bus->slave({.position = i}).async_read<std::uint32_t>(0x1018, 3, [&](error_code why, std::uint32_t value) {
            error = why;
            revision = value;
        });
        CHECK_FALSE(wait());
        CHECK(revision == 1);
    }
    b.bus->slave({.position = 0}).async_change(ethercat::al_state::init, [&](error_code why) { error = why; });
    CHECK(wait() == bus_errc::served);
    b.bus->slave({.position = 1}).async_change(ethercat::al_state::init, [&](error_code why) { error = why; });
    CHECK_FALSE(wait());
    REQUIRE(b.drive(40));
    CHECK(b.lost.empty());
    // A transfer that hangs does not keep the actuator from its stop order.
    b.ring.with(1, [](auto& each) { each.hangs = true; });
    b.bus->slave({.position = 1}).async_read<std::uint32_t>(0x1018, 3, [&](error_code why, std::uint32_t) {
        error = why;
    });
    b.operator_node.stop();
    REQUIRE(b.until([&] { return b.ring.effort() == 0; }));
    CHECK(b.lost.empty());
    CHECK(wait() == bus_errc::no_answer);
}

TEST_CASE("bridges of two nodes share a bus") {
    bench b{2};
    b.serve({.position = 0});
    jauscat::node second{b.context, b.config.of("leg", b.lines)};
    jauscat::bridge other{second, *b.bus, translation::seed_table{}};
    other.serve({.component = 33}, b.bus->slave({.position = 1}));
    second.start();
    b.start();
    REQUIRE(b.drive(40));
    REQUIRE(b.drive(60, 1, leg));
    second.stop();
    CHECK(b.ring.effort(1) == 0);
    REQUIRE(b.drive(41));
    CHECK(b.lost.empty());
}

TEST_CASE("bridges of a bus have options of their own") {
    bench b{2};
    b.serve({.position = 0}, {.at_rest_within = 400ms, .period = 50ms});
    jauscat::node second{b.context, b.config.of("leg", b.lines)};
    const auto period = GENERATE(0ms, 5ms);
    jauscat::bridge other{second, *b.bus, translation::seed_table{}, {.at_rest_within = 200ms, .period = period}};
    other.serve({.component = 33}, b.bus->slave({.position = 1}));
    second.start();
    b.start();
    REQUIRE(b.drive(40));
    REQUIRE(b.drive(60, 1, leg));
    b.ring.with(1, [=](auto& each) { CHECK((each.slave.state() == ethercat::al_state::op) == (period != 0ms)); });
    second.stop();
    CHECK(b.ring.effort(1) == 0);
    REQUIRE(b.drive(41));
    CHECK(b.lost.empty());
}

TEST_CASE("a node has several slaves") {
    const auto period = GENERATE(0ms, 10ms);
    bench b{2};
    b.serve({.position = 0}, {.period = period});
    jaus::address second = arm;
    second.instance = 2;
    b.bridge->serve({.component = 33, .instance = 2}, b.bus->slave({.position = 1}));
    b.start();
    REQUIRE(b.drive(40));
    REQUIRE(b.drive(60, 1, second));
    CHECK(std::abs(b.ring.effort(0) - 40) < 0.1);
    const jaus::query_wrench_effort query{.presence_vector = jaus::presence_bits_of<jaus::report_wrench_effort>};
    int turns = 0;
    REQUIRE(b.until([&] {
        if (turns++ % 20 == 0) static_cast<void>(b.unit.send(second, query));
        return b.reporter == second && std::abs(*b.reported - 60) < 0.1;
    }));
    b.robot->stop();
    CHECK(b.ring.effort(0) == 0);
    CHECK(b.ring.effort(1) == 0);
    CHECK(b.lost.empty());
}

TEST_CASE("a bridge has a table of the application's") {
    using own =
        translation::seed_table_of<translation::seed_index_base, translation::ra_command_codes_and<0xD101>>::type;
    bench b;
    b.serve<own>();
    b.start();
    REQUIRE(b.drive(40));
}

TEST_CASE("what cannot be served is refused at once") {
    bench b;
    b.serve();
    auto& bridge = *b.bridge;
    const auto first = b.bus->slave({.position = 0});
    CHECK_THROWS_AS(bridge.serve({.component = 33}, first), std::invalid_argument);
    CHECK_THROWS_AS(bridge.serve({.component = 0}, first), std::invalid_argument);
    CHECK_NOTHROW(bridge.serve({.component = 34}, first));
    const auto image = [] {
        return jauscat::process_image<translation::set_wrench_effort_table, translation::report_wrench_effort_table>();
    };
    CHECK_THROWS_AS(bridge.serve({.component = 45}, first, image()), std::invalid_argument); // no period
    CHECK_THROWS_AS(bridge.serve({.component = 45}, std::vector<jauscat::slave>{}, image()), std::invalid_argument);
    {
        bench c{2};
        c.bridge.emplace(*c.robot, *c.bus, translation::seed_table{}, jauscat::bridge_options{.period = 10ms});
        const auto one = c.bus->slave({.position = 0}), two = c.bus->slave({.position = 1});
        CHECK_THROWS_AS(c.bridge->serve({.component = 45}, {one, two}, image()), std::invalid_argument); // by mailbox
        CHECK_THROWS_AS(c.bridge->serve({.component = 45}, {one, two}, nullptr), std::invalid_argument);
        CHECK_THROWS_AS(c.bridge->serve({.component = 45}, {one, one}, std::make_unique<test::joint_part>()),
                        std::invalid_argument);
        CHECK_NOTHROW(c.bridge->serve({.component = 45}, {one, two}, std::make_unique<test::joint_part>()));
    }
    CHECK_THROWS_AS((jauscat::component{*b.robot, {.id = 34}}), std::invalid_argument);
    const jauscat::bridge_options too_quick{.at_rest_within = 1ms};
    CHECK_THROWS_AS((jauscat::bridge{*b.robot, *b.bus, translation::seed_table{}, too_quick}), std::invalid_argument);
    const jauscat::bridge_options endless{.period = jauscat::duration::max()};
    CHECK_THROWS_WITH((jauscat::bridge{*b.robot, *b.bus, translation::seed_table{}, endless}),
                      Catch::Contains("the period is at most 1.625 s"));
    asio::io_context elsewhere;
    jauscat::bus far{elsewhere, b.ring.where(), {.log = no_log}};
    CHECK_THROWS_AS((jauscat::bridge{*b.robot, far, translation::seed_table{}}), std::invalid_argument);
    jauscat::bus near{b.context, b.ring.where(), {.log = no_log}};
    CHECK_THROWS_AS(bridge.serve({.component = 35}, near.slave({.position = 0})), std::invalid_argument);
    b.start();
    CHECK_THROWS_AS(bridge.serve({.component = 36}, first), std::logic_error);
}
