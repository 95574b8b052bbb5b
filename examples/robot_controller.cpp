// The robot controller: JAUS messages in over UDP, SDO downloads out over EtherCAT, and reports the way back.
#include "robot_controller/slave_front.hpp"
#include "support/link_options.hpp"

#include <thread>

namespace {

namespace ethercat = jauscat::ethercat;

constexpr const char* help = R"(robot_controller: carries JAUS messages to an EtherCAT slave and its reports back.

It brings the slave to PRE-OP with the station address --station. In front of it stands the JAUS node of that number,
with a node manager (heartbeats) and the components that the configuration gives the node, or else component 33, a
Primitive Driver. State, control and acknowledgement of a component are kept here; all its other messages are
translated into SDO downloads. After a query the report is uploaded and sent to the asker.

A component obeys when it is ready. In every other state, and when its controller is lost, the slave is brought to rest.

With --cycle the slave runs in OP, and wrench efforts take the cyclic path: a Set Wrench Effort is in the slave's outputs
in the next cycle, and Query Wrench Effort is answered from its inputs. All other messages go by the mailbox, in between.

Examples:
  robot_controller --this b                   EtherCAT in UDP to 127.0.0.1, port 34980
  robot_controller --this b --table self-contained
  robot_controller --this b --link raw --interface eth0
  robot_controller --this b --link raw --interface eth0 --cycle 1000
)";

} // namespace

int main(int argc, char** argv) {
    return example::run("robot_controller", [&] {
        namespace po = boost::program_options;
        po::options_description options{"Options"};
        // clang-format off
        options.add_options()
            ("help", "show this text")
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this controller is, instead of the file's <thissystem>")
            ("station", po::value<std::uint16_t>()->default_value(2), "station address and JAUS node of the slave, 1 to 254")
            ("clear-subindex-0", po::bool_switch(), "write 0 to subindex 0 of an object before each message, for slaves that abort with 06010003h else")
            ("cycle", po::value<unsigned>()->default_value(0), "microseconds from one cycle of process data to the next: wrench efforts then go without the mailbox; 0: no cycles")
            ("watchdog", po::value<unsigned>()->default_value(0), "with --cycle: milliseconds without outputs after which the slave leaves OP, up to 6500; 0: the slave's own time, mostly 100")
            ("wait", po::value<unsigned>()->default_value(5000), "milliseconds to wait for the slave at the start")
            ("open", "take messages from everybody, for trials")
            ("frame-timeout", po::value<unsigned>()->default_value(20), "milliseconds after which a frame is lost");
        // clang-format on
        example::add_link_options(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto station = values["station"].as<std::uint16_t>();
        if (station < 1 || station > 254) throw example::usage_error{"--station must be 1 to 254"};
        if (values["watchdog"].as<unsigned>() > 6500) throw example::usage_error{"--watchdog must be 0 to 6500"};
        const auto config = example::load_config(values);
        return example::with_link(values, example::link_end::master, [&](auto& link, const std::string& where) {
            const example::speaker say{"controller"};
            say(where);
            const example::slave_settings settings{
                .slave = {.subsystem = config.me().jausip.subsystem, .station = station},
                .frame_timeout = std::chrono::milliseconds{values["frame-timeout"].as<unsigned>()},
                .download = {.clear_subindex_0 = values["clear-subindex-0"].as<bool>()},
                .period = std::chrono::microseconds{values["cycle"].as<unsigned>()},
                .watchdog = std::chrono::milliseconds{values["watchdog"].as<unsigned>()}};
            std::unique_ptr<example::any_exchange> exchange;
            example::with_table(values, [&]<class Table>() {
                exchange = std::make_unique<example::exchange_under<Table>>(settings.slave);
                return example::success;
            });
            example::slave_front front{config,
                                       link,
                                       std::move(exchange),
                                       settings,
                                       values.count("open") != 0 ? jauscat::net::access::open
                                                                 : jauscat::net::access::closed,
                                       say};
            front.run(std::chrono::milliseconds{values["wait"].as<unsigned>()}, false);
            return int{example::success};
        });
    });
}
