// The command line of the robot controller.
#pragma once
#include "support/link_options.hpp"
#include "support/live_view.hpp"
#include "support/node_options.hpp"
#include <jauscat/app/bridge_options.hpp>
#include <jauscat/app/bus.hpp>
#include <jauscat/app/joints.hpp>
#include <jauscat/app/node_options.hpp>
#include <jauscat/ethercat/cia402/pdo_layout.hpp>
#include <jauscat/jaus/message/message.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace example {

using values_map = boost::program_options::variables_map;

inline constexpr const char* controller_help =
    R"(robot_controller: carries JAUS messages to an EtherCAT slave and its reports back.

It brings the slave to PRE-OP with the station address --station, and runs a JAUS node of that number for it. The node
has a node manager (heartbeats) and the components that the configuration lists, or else component 33, a Primitive
Driver. The program handles state, control and acknowledgement of a component itself. It translates all other messages
of the component to SDO downloads. After a query it uploads the report and sends it to the source of the query.

A component executes commands when it is ready. In every other state, when its controller is lost, and when this
program ends, the slave is brought to rest: within --stop-within milliseconds after a loss (docs/safety.md).

With a configuration, this program can run several masters: those of all systems whose <ethercat> entry names it as
their controller, each with its own interface, slave and JAUS node (docs/configuration.md). The file then has the
interfaces and stations.

With --cycle the slave runs in OP, and wrench efforts bypass the mailbox: a Set Wrench Effort is in the slave's outputs
in the next cycle, and Query Wrench Effort is answered from its inputs. All other messages use the mailbox, between
cycles.

Examples:
  robot_controller --this b                   EtherCAT in UDP to 127.0.0.1, port 34980
  robot_controller --this b --table self-contained
  robot_controller --this b --link raw --interface eth0
  robot_controller --this b --link raw --interface eth0 --cycle 1000
  robot_controller --this b --web 8080        and its messages, bus and faults at http://127.0.0.1:8080/
  robot_controller --config robot.xml --this arm      the masters of arm in robot.xml
)";

/// Its options, and those of the log, the link and the table.
inline boost::program_options::options_description controller_options() {
    namespace po = boost::program_options;
    po::options_description options;
    // clang-format off
    options.add_options()
        ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
        ("this", po::value<std::string>(), "the system this controller is, instead of the file's <thissystem>")
        ("station", po::value<std::uint16_t>()->default_value(2), "station address and JAUS node of the slave, 1 to 254")
        ("clear-subindex-0", po::bool_switch(), "write 0 to subindex 0 of an object before each message, for slaves that otherwise abort with 06010003h")
        ("cycle", po::value<unsigned>()->default_value(0), "period of the process data in microseconds; wrench efforts then bypass the mailbox; 0: no process data")
        ("joint-increments", po::value<double>()->default_value(10'000), "of a drive, for one radian of its joint")
        ("joint-velocity", po::value<double>()->default_value(5), "of a joint at most, in radians per second")
        ("joint-acceleration", po::value<double>()->default_value(20), "of a joint, in radians per second squared")
        ("stop-within", po::value<unsigned>(), "milliseconds within which the slave is at rest after its controller, the link, its state or this program is lost; default: 500, with --cycle 100")
        ("wait", po::value<unsigned>(), "milliseconds to wait for the slave at the start; default: 5000, with SYNC signals 20000")
        ("open", "accept messages from all senders, for tests")
        ("frame-timeout", po::value<unsigned>()->default_value(20), "milliseconds after which a frame is lost");
    // clang-format on
    add_web_options(options);
    add_log_option(options);
    add_link_options(options);
    return options;
}

/// A system in front of a slave.
struct place {
    jauscat::net::jaus_config config{}; ///< seen by the system
    std::uint16_t station{};
    std::string link{}; ///< see link_name
    std::string name{}; ///< in front of log lines, where there are several
};

/// The masters of the configuration, or else the one of the command line.
inline std::vector<place> places_of(const values_map& values) {
    const auto config = load_config(values);
    const auto masters = config.masters_of(config.this_system);
    const auto station = values["station"].as<std::uint16_t>();
    if (masters.empty() && (station < 1 || station > 254)) throw usage_error{"--station must be 1 to 254"};
    if (masters.empty()) return {{config, station, link_name(values), {}}};
    for (const std::string option : {"station", "link", "interface", "ethercat-host", "ethercat-port"})
        if (values.count(option) != 0 && !values[option].defaulted())
            throw usage_error{"--" + option + " is not for " + config.this_system + ", whose masters are in " +
                              config.source};
    std::vector<place> places;
    for (const auto* system : masters) {
        const auto& wire = *system->ethercat;
        const auto link =
            wire.interface_name.empty() ? udp_link_name(wire.udp_host, wire.udp_port) : wire.interface_name;
        places.push_back({config.with_this(system->name), system->jausip.node, link,
                          masters.size() == 1 ? std::string{} : system->name});
    }
    return places;
}

/// A component, and the names of its slaves; none: the first slave of the ring.
struct front_component {
    jauscat::served_component component{};
    std::vector<std::string> slaves{};
};

/// The components in front of slaves: those that the configuration gives the system at the node, or the one of its
/// jausip, or a Primitive Driver.
inline std::vector<front_component> components_of(const jauscat::net::system_entry& me, std::uint8_t node) {
    constexpr std::uint8_t primitive_driver = 33;
    std::vector<front_component> found;
    for (const auto& entry : me.components)
        if (entry.id.node == node && !is_node_manager(entry.id))
            found.push_back({{entry.id.component, entry.id.instance, entry.authority}, entry.slaves});
    const auto& own = me.jausip;
    if (found.empty())
        found.push_back({{.component = own.component != 0 ? own.component : primitive_driver,
                          .instance = std::max<std::uint8_t>(own.instance, 1)}});
    if (me.ethercat && !me.ethercat->slaves.empty())
        for (auto& each : found)
            if (each.slaves.empty()) each.slaves.push_back(me.ethercat->slaves.front().name);
    return found;
}

inline std::vector<jauscat::slave> slaves_of(const jauscat::bus& bus, const std::vector<std::string>& names) {
    if (names.empty()) return {bus.slave({.position = 0})};
    std::vector<jauscat::slave> found;
    for (const auto& name : names) found.push_back(bus.slave({.name = name}));
    return found;
}
/// Joints that are alike, by drives with the usual process data; nullptr for a single slave.
inline std::unique_ptr<jauscat::bridging::process_part> joints_of(std::size_t count, const values_map& values) {
    namespace cia402 = jauscat::cia402;
    if (count < 2) return nullptr;
    if (values["cycle"].as<unsigned>() == 0) throw usage_error{"a component with several slaves needs --cycle"};
    const auto increments = values["joint-increments"].as<double>();
    const auto velocity = values["joint-velocity"].as<double>() * increments;
    const auto acceleration = values["joint-acceleration"].as<double>() * increments;
    constexpr double most = 2'000'000'000;
    if (!(increments > 0) || !(velocity >= 1 && velocity <= most) || !(acceleration >= 1 && acceleration <= most))
        throw usage_error{"--joint-increments, --joint-velocity or --joint-acceleration is out of range"};
    std::vector<jauscat::bridging::joint_options> joints(count);
    for (std::size_t i = 0; i != count; ++i)
        joints[i] = {.slave = i,
                     .places = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs),
                     .axis = {.max_velocity = velocity, .acceleration = acceleration, .deceleration = acceleration},
                     .scale = {.increments_per_radian = increments, .max_velocity = velocity}};
    return jauscat::joint_drives(joints);
}

/// How long the slave may take at the start. One with SYNC signals is in OP once the cycles follow the reference clock.
inline std::chrono::milliseconds wait_of(const std::vector<place>& places, const values_map& values) {
    if (values.count("wait") != 0) return std::chrono::milliseconds{values["wait"].as<unsigned>()};
    const auto has_sync = [](const auto& slave) { return slave.sync || !slave.sync_mode.empty(); };
    const bool is_synchronized = std::ranges::any_of(places, [&](const place& at) {
        const auto& ethercat = at.config.me().ethercat;
        return ethercat && std::ranges::any_of(ethercat->slaves, has_sync);
    });
    return std::chrono::milliseconds{is_synchronized ? 20'000 : 5'000};
}

inline jauscat::node_options node_options_of(const place& at, const values_map& values) {
    return {.config = at.config.source,
            .this_system = at.config.this_system,
            .node = static_cast<std::uint8_t>(at.station),
            .open = values.count("open") != 0};
}
inline jauscat::bus_options bus_options_of(const place& at, const values_map& values) {
    const auto& ethercat = at.config.me().ethercat;
    return {.slaves = ethercat ? ethercat->slaves : std::vector<jauscat::net::slave_entry>{},
            .frame_timeout = std::chrono::milliseconds{values["frame-timeout"].as<unsigned>()},
            .clear_subindex_0 = values["clear-subindex-0"].as<bool>()};
}
inline jauscat::bridge_options bridge_options_of(const values_map& values) {
    using std::chrono::milliseconds;
    const std::chrono::microseconds period{values["cycle"].as<unsigned>()};
    const bool cycles = period != period.zero();
    constexpr milliseconds shortest{20}, longest_watchdog{6500}, longest{60'000};
    if (4 * period > longest_watchdog) throw usage_error{"--cycle must be at most 1625000"};
    if (values.count("stop-within") == 0) return {.period = period};
    const milliseconds limit{values["stop-within"].as<unsigned>()};
    if (limit < shortest || limit > (cycles ? longest_watchdog : longest))
        throw usage_error{std::string{"--stop-within must be 20 to "} + (cycles ? "6500 with --cycle" : "60000")};
    if (limit < 4 * period) throw usage_error{"--stop-within must be at least 4 cycles"};
    return {.at_rest_within = limit, .period = period};
}

} // namespace example
