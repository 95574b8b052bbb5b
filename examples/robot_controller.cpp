// The robot controller: receives JAUS messages over UDP, sends SDO downloads over EtherCAT, and returns reports.
#include "robot_controller/front.hpp"
#include "support/link_options.hpp"

#include <atomic>
#include <exception>
#include <thread>

namespace {

namespace bridging = jauscat::bridging;

constexpr const char* help = R"(robot_controller: carries JAUS messages to an EtherCAT slave and its reports back.

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
  robot_controller --config robot.xml --this arm      the masters of arm in robot.xml
)";

using values_map = boost::program_options::variables_map;

/// A system in front of a slave, and the link to it.
struct place {
    jauscat::net::jaus_config config{}; ///< seen by the system
    std::uint16_t station{};
    example::opened_link link{};
};

/// The masters of the configuration, or else the one of the command line.
std::vector<place> open_places(const values_map& values) {
    const auto config = example::load_config(values);
    const auto masters = config.masters_of(config.this_system);
    std::vector<place> places;
    if (masters.empty()) {
        const auto station = values["station"].as<std::uint16_t>();
        if (station < 1 || station > 254) throw example::usage_error{"--station must be 1 to 254"};
        places.push_back({config, station, example::open_link(values, example::link_end::master)});
        return places;
    }
    for (const auto* option : {"station", "link", "interface", "ethercat-host", "ethercat-port"})
        if (values.count(option) != 0 && !values[option].defaulted())
            throw example::usage_error{std::string{"--"} + option + " is not for " + config.this_system +
                                       ", whose masters are in " + config.source};
    for (const auto* system : masters) {
        const auto& wire = *system->ethercat;
        places.push_back({config.with_this(system->name), system->jausip.node,
                          wire.interface_name.empty()
                              ? example::open_udp_link(example::link_end::master, wire.udp_host, wire.udp_port)
                              : example::open_raw_link(wire.interface_name)});
    }
    return places;
}

/// Milliseconds within which the slave is at rest after something is lost.
std::chrono::milliseconds limit_of(const values_map& values, std::chrono::microseconds period) {
    const bool is_given = !values["stop-within"].empty();
    const bool cycles = period != period.zero();
    const std::chrono::milliseconds limit =
        is_given ? std::chrono::milliseconds{values["stop-within"].as<unsigned>()}
                 : std::max(cycles ? example::bridging::at_rest_in_cycles : example::bridging::at_rest_by_mailbox,
                            std::chrono::duration_cast<std::chrono::milliseconds>(4 * period));
    constexpr std::chrono::milliseconds shortest{20}, longest_watchdog{6500}, longest{60'000};
    if (limit < shortest || limit > (cycles ? longest_watchdog : longest))
        throw example::usage_error{std::string{"--stop-within must be 20 to "} +
                                   (cycles ? "6500 with --cycle" : "60000")};
    if (limit < 4 * period) throw example::usage_error{"--stop-within must be at least 4 cycles"};
    return limit;
}

example::front_options options_for(const place& at, const std::string& trace_name, const values_map& values) {
    const std::chrono::microseconds period{values["cycle"].as<unsigned>()};
    auto timing = example::bridging::at_rest_within(limit_of(values, period), period);
    timing.master.frame_timeout = std::chrono::milliseconds{values["frame-timeout"].as<unsigned>()};
    timing.download.clear_subindex_0 = values["clear-subindex-0"].as<bool>();
    return {.slave = {.identity = {.subsystem = at.config.me().jausip.subsystem, .station = at.station},
                      .cyclic = period != period.zero()},
            .timing = timing,
            .who = values.count("open") != 0 ? jauscat::net::access::open : jauscat::net::access::closed,
            .trace_name = trace_name};
}

std::unique_ptr<example::bridging::any_exchange> exchange_with(const bridging::slave_identity& slave,
                                                               const values_map& values) {
    std::unique_ptr<example::bridging::any_exchange> made;
    example::with_table(values, [&]<class Table>() {
        made = std::make_unique<example::bridging::exchange_under<Table>>(slave);
        return example::success;
    });
    return made;
}

/// Each front on a thread of its own, until Ctrl-C. The error of a single one is thrown.
int run_all(std::deque<example::front>& fronts, std::chrono::milliseconds patience) {
    std::vector<std::exception_ptr> errors(fronts.size());
    std::atomic<bool> all_at_rest{true};
    const bool alone = fronts.size() == 1;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i != fronts.size(); ++i)
            threads.emplace_back([&front = fronts[i], &error = errors[i], &all_at_rest, patience, alone] {
                try {
                    if (!front.run(patience, !alone)) all_at_rest = false;
                } catch (const std::exception& problem) {
                    if (!alone) front.say_failed(problem.what());
                    error = std::current_exception();
                }
            });
    }
    if (alone && errors.front()) std::rethrow_exception(errors.front());
    const bool well = std::ranges::all_of(errors, [](const auto& error) { return error == nullptr; });
    return well && all_at_rest ? example::success : example::failure;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("robot_controller", [&] {
        namespace po = boost::program_options;
        po::options_description described;
        // clang-format off
        described.add_options()
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this controller is, instead of the file's <thissystem>")
            ("station", po::value<std::uint16_t>()->default_value(2), "station address and JAUS node of the slave, 1 to 254")
            ("clear-subindex-0", po::bool_switch(), "write 0 to subindex 0 of an object before each message, for slaves that otherwise abort with 06010003h")
            ("cycle", po::value<unsigned>()->default_value(0), "period of the process data in microseconds; wrench efforts then bypass the mailbox; 0: no process data")
            ("stop-within", po::value<unsigned>(), "milliseconds within which the slave is at rest after its controller, the link, its state or this program is lost; default: 500, with --cycle 100")
            ("wait", po::value<unsigned>()->default_value(5000), "milliseconds to wait for the slave at the start")
            ("open", "accept messages from all senders, for tests")
            ("frame-timeout", po::value<unsigned>()->default_value(20), "milliseconds after which a frame is lost");
        // clang-format on
        example::add_log_option(described);
        example::add_link_options(described);
        const auto values = example::parse(argc, argv, described, help);
        static_cast<void>(limit_of(values, std::chrono::microseconds{values["cycle"].as<unsigned>()}));
        const auto places = open_places(values);
        if (std::ranges::any_of(places, [](const place& at) { return at.link.is_raw; })) example::give_up_privileges();
        std::deque<example::front> fronts;
        for (const auto& at : places) {
            const auto name = places.size() == 1 ? std::string{} : at.config.this_system;
            const example::speaker say{name.empty() ? "controller" : "controller " + name,
                                       {{"system", at.config.this_system}}};
            const auto options = options_for(at, name, values);
            say(example::events::link_opened, {{"link", at.link.where}}, at.link.where);
            fronts.emplace_back(at.config, *at.link.link, exchange_with(options.slave.identity, values), options, say);
        }
        for (auto& front : fronts)
            front.disappeared = [&](const auto& gone) {
                for (auto& other : fronts) other.lose(gone);
            };
        return run_all(fronts, std::chrono::milliseconds{values["wait"].as<unsigned>()});
    });
}
