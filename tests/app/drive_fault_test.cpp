// Faults of drives behind a bridge: the log, the application's functions and the status of the component.
#include "app/emulated_joint.hpp"
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/until.hpp"
#include <jauscat/app/bridge.hpp>
#include <jauscat/app/component.hpp>
#include <jauscat/bridge/component.hpp>
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/bridge/observer.hpp>
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/cia402/error_text.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace std::chrono_literals;
using boost::system::error_code;
namespace asio = boost::asio;
namespace bridging = jauscat::bridging;
namespace cia402 = jauscat::cia402;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
using bridging::drive_fault;
using status = jaus::primary_status_code;

namespace {

constexpr std::size_t drive_count = 2;
constexpr jaus::address arm{.instance = 1, .component = 54, .node = 1, .subsystem = 2};

/// A file with one system.
class configuration {
  public:
    configuration() {
        const auto port = std::to_string(support::free_ports<1>()[0]);
        path_ = std::filesystem::temp_directory_path() / ("jauscat_drive_fault_" + port + ".xml");
        std::ofstream{path_} << "<jausconfig>\n<thissystem>arm</thissystem>\n<system><name>arm</name>"
                                "<jausip>2.1.0.0</jausip><ip>127.0.0.1</ip><port>"
                             << port << "</port></system>\n</jausconfig>\n";
    }
    ~configuration() { std::remove(path_.c_str()); }
    configuration(const configuration&) = delete;
    configuration& operator=(const configuration&) = delete;

    [[nodiscard]] jauscat::node_options options(std::vector<std::string>& lines) const {
        return {.config = path_, .this_system = "arm", .name = "arm", .log = [&lines](std::string_view line) {
                    lines.emplace_back(line);
                }};
    }

  private:
    std::string path_;
};

/// A component in front of two drives, and an operator that asks for its status.
struct bench {
    explicit bench(bool has_error_code = true, bool has_thread = false,
                   const ethercat::slave_description& last = cia402::drive_description<>)
        : drives{{cia402::drive_description<>, last}},
          bus{context, drives.where(), {.thread = has_thread, .log = [](std::string_view) {}}} {
        std::array<bridging::joint_options, drive_count> joints{};
        std::vector<jauscat::slave> slaves;
        for (std::size_t i = 0; i != joints.size(); ++i) {
            joints[i] = {.slave = i,
                         .places = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs),
                         .axis = {.max_velocity = 20'000, .acceleration = 200'000, .deceleration = 200'000},
                         .scale = {.increments_per_radian = 10'000}};
            if (!has_error_code) joints[i].places.error_code = {};
            slaves.push_back(bus.slave({.position = static_cast<std::uint16_t>(i)}));
        }
        bridge.serve({.component = 54}, slaves, std::make_unique<bridging::joint_part<drive_count>>(joints));
        bridge.when_faulted([this](const jaus::address& of, const drive_fault& fault) {
            CHECK(of == arm);
            told.push_back(fault);
        });
        bridge.when_fault_ended([this](const jaus::address& of) {
            CHECK(of == arm);
            ++ended;
        });
        bridge.when_changed([this](const auto&, status now) { state = now; });
        unit.ready();
    }
    [[nodiscard]] bool until(auto done) { return support::until(context, done); }
    [[nodiscard]] bool starts() {
        node.start();
        return until([&] { return state == status::ready; });
    }
    [[nodiscard]] bool is_told(const drive_fault& fault) {
        return until([&] { return std::ranges::count(told, fault) == 1; });
    }
    [[nodiscard]] bool has_line(std::string_view part) const {
        return std::ranges::any_of(lines, [&](const auto& line) { return line.find(part) != line.npos; });
    }
    /// The status that a query returns.
    [[nodiscard]] std::optional<jaus::report_component_status> ask() {
        std::optional<jaus::report_component_status> report;
        bool is_over = false;
        unit.async_ask(arm, jaus::query_component_status{}, [&](error_code why, const auto& answer) {
            if (!why) report = answer;
            is_over = true;
        });
        static_cast<void>(until([&] { return is_over; }));
        return report;
    }
    void reset() { static_cast<void>(unit.send(arm, jaus::reset{})); }

    std::vector<std::string> lines{};
    std::vector<drive_fault> told{};
    unsigned ended{};
    std::optional<status> state{};
    jauscat::test::drive_bus drives;
    configuration config{};
    asio::io_context context{1};
    jauscat::node node{context, config.options(lines)};
    jauscat::component unit{node, {.id = 32, .name = "operator"}};
    jauscat::bus bus;
    jauscat::bridge bridge{node, bus, jauscat::translation::seed_table{}, {.at_rest_within = 500ms, .period = 10ms}};
};

constexpr std::uint16_t over_current = cia402::error_codes::over_current;
constexpr std::uint16_t dc_link_over_voltage = 0x3210;

} // namespace

TEST_CASE("a bridge does not serve joints whose ramp takes longer than the limit") {
    bench b;
    std::array<bridging::joint_options, 1> joints{
        {{.places = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs),
          .axis = {.max_velocity = 50'000, .acceleration = 200'000, .deceleration = 99'000},
          .scale = {.increments_per_radian = 10'000}}}};
    const auto serve = [&] {
        b.bridge.serve({.component = 55}, b.bus.slave({.position = 0}),
                       std::make_unique<bridging::joint_part<1>>(joints));
    };
    CHECK_THROWS_WITH(serve(),
                      "bridge: joint 1 needs 506 ms from max_velocity to rest by its deceleration, longer than "
                      "the 500 ms in which it has to be at rest");
    joints[0].axis.deceleration = 100'000;
    CHECK_NOTHROW(serve());
}

TEST_CASE("a drive that maps its objects otherwise than its joint's places is refused by name, once") {
    auto last = cia402::drive_description<>;
    last.outputs = jauscat::test::other_drive_outputs;
    bench b{true, false, last};
    b.node.start();
    const auto refusals = [&] {
        return std::ranges::count_if(b.lines, [](const auto& line) { return line.find("is lost") != line.npos; });
    };
    REQUIRE(b.until([&] { return refusals() != 0; }));
    CHECK(b.has_line("slave 1 is lost: it does not take part in the process data (object 0x6060:0: the slave's process "
                     "data do not have it where the program does: change the mapping or the program (8 bits from bit "
                     "16 on expected, 8 bits from bit 24 on found))"));
    REQUIRE(b.until([&] { return b.drives.with(1, [](auto& each) { return each.bring_ups == 3; }); }));
    CHECK(refusals() == 1);
    CHECK(b.state != status::ready);
    b.node.stop();
}

TEST_CASE("a drive's fault behind a bridge is logged with its code, called back, and in the status") {
    const bool has_thread = GENERATE(false, true);
    bench b{true, has_thread};
    REQUIRE(b.starts());
    CHECK(b.told.empty());
    b.drives.set_fault(1, over_current);
    REQUIRE(b.is_told({1, over_current}));
    REQUIRE(b.until([&] { return b.state == status::failure; }));
    CHECK(b.has_line("2.1.54.1: slave 1 has a drive fault: 2310h (continuous over current, device output side)"));
    const auto report = b.ask();
    REQUIRE(report);
    CHECK(report->primary_status_code == status::failure);
    CHECK((report->secondary_status_code & bridging::secondary_status::drive_fault) != 0);
    CHECK(b.told.size() == 1);
    CHECK(b.ended == 0);

    b.drives.set_fault(1, 0);
    b.reset();
    REQUIRE(b.until([&] { return b.ended == 1; }));
    REQUIRE(b.until([&] { return b.state == status::ready; }));
    CHECK(b.has_line("2.1.54.1: no drive has a fault any more"));
    const auto later = b.ask();
    REQUIRE(later);
    CHECK((later->secondary_status_code & bridging::secondary_status::drive_fault) == 0);

    b.drives.set_fault(0, over_current); // the next one
    REQUIRE(b.is_told({0, over_current}));
    b.node.stop();
}

TEST_CASE("each of several faults behind a bridge is told, also another one of the same drive") {
    bench b;
    REQUIRE(b.starts());
    b.drives.set_fault(0, over_current);
    REQUIRE(b.is_told({0, over_current}));
    b.drives.set_fault(1, dc_link_over_voltage);
    REQUIRE(b.is_told({1, dc_link_over_voltage}));
    CHECK(b.has_line("slave 1 has a drive fault: 3210h (DC link over-voltage)"));
    b.drives.with(0, [](auto& each) { each.drive.axes[0].values.error_code = cia402::error_codes::over_temperature; });
    REQUIRE(b.is_told({0, cia402::error_codes::over_temperature}));
    CHECK(b.told.size() == 3);
    CHECK(b.ended == 0);
    b.node.stop();
}

TEST_CASE("a fault without an error code behind a bridge is told as such") {
    bench b{false};
    REQUIRE(b.starts());
    b.drives.set_fault(1, over_current);
    REQUIRE(b.is_told({1, 0}));
    CHECK(b.has_line("slave 1 has a drive fault: no error code"));
    b.node.stop();
}

TEST_CASE("a fault that a drive has when its bridge starts is told") {
    bench b;
    b.drives.set_fault(1, over_current);
    b.node.start();
    REQUIRE(b.is_told({1, over_current}));
    CHECK(b.has_line("slave 1 has a drive fault: 2310h"));
    const auto report = b.ask();
    REQUIRE(report);
    CHECK(report->primary_status_code == status::failure);
    CHECK((report->secondary_status_code & bridging::secondary_status::drive_fault) != 0);
    b.node.stop();
}

TEST_CASE("a fault is told while another drive of the component is lost") {
    bench b;
    REQUIRE(b.starts());
    b.drives.with(0, [](auto& each) { each.slave.power_on(); }); // its station address is gone
    REQUIRE(b.until([&] { return b.has_line("slave 0 is lost"); }));
    b.drives.set_fault(1, over_current);
    REQUIRE(b.is_told({1, over_current}));
    b.node.stop();
}

TEST_CASE("an observer of a bridge gets the faults of drives and their end, instead of the log") {
    bench b;
    std::vector<drive_fault> seen;
    unsigned ends = 0;
    const auto faulted = [&](const bridging::component& of, const drive_fault& fault) {
        CHECK(of.self() == arm);
        seen.push_back(fault);
    };
    const auto fault_ended = [&](const bridging::component&) { ++ends; };
    const bridging::observer by{.faulted = faulted, .fault_ended = fault_ended};
    b.bridge.observe(by);
    REQUIRE(b.starts());
    b.drives.set_fault(1, over_current);
    REQUIRE(b.is_told({1, over_current}));
    CHECK(std::ranges::count(seen, drive_fault{1, over_current}) == 1);
    CHECK_FALSE(b.has_line("drive fault"));
    b.drives.set_fault(1, 0);
    b.reset();
    REQUIRE(b.until([&] { return ends == 1; }));
    b.node.stop();
}

TEST_CASE("an error code of a drive has its text, or that of its group") {
    using cia402::describe_error_code;
    CHECK(describe_error_code(0) == "no error");
    CHECK(describe_error_code(0x8611) == "following error");
    CHECK(describe_error_code(0x2312) == describe_error_code(0x2310));
    CHECK(describe_error_code(0x4FFF) == "temperature");
    CHECK(describe_error_code(0xFF12) == "manufacturer-specific");
    CHECK(describe_error_code(0x0001) == "unknown error code");
    CHECK(describe_error_code(0xA000) == "unknown error code");
}
