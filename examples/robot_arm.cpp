// The robot arm: an EtherCAT slave with JAUS messages as objects, with its efforts shown as bars.
#include "arm_application.hpp"
#include "arm_process_data.hpp"
#include "arm_watch.hpp"
#include "support/arm_slave.hpp"
#include "support/link_options.hpp"
#include "support/mailbox_option.hpp"
#include "support/node_options.hpp"
#include "support/say.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/slave/mapped_objects.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/now.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;

constexpr const char* help = R"(robot_arm: an EtherCAT slave that executes JAUS messages.

It waits for an EtherCAT master (robot_controller, or any other) and shows the commands that it executes. Its JAUS
subsystem is that of its system in the configuration file. Its JAUS node is --node, or else the station address that
the master assigns.

Examples:
  robot_arm --this b                          EtherCAT in UDP on port 34980
  robot_arm --this b --node 2                 for a master whose station addresses are above 254, such as 0x1001
  robot_arm --this b --link raw --interface eth0
)";

/// By so much the watchdog and the command timeout are late at most.
constexpr auto longest_wait = std::chrono::milliseconds{5};

/// `-100 |         ####|              | 100` for a value within its limits.
std::string bar(double value, double min, double max) {
    constexpr int width = 40;
    const auto column = [&](double v) { return static_cast<int>(std::lround((v - min) / (max - min) * width)); };
    const int from = std::min(column(0), column(value)), to = std::max(column(0), column(value));
    std::string text(width + 1, ' ');
    for (int i = from; i <= to; ++i) text[static_cast<std::size_t>(i)] = '=';
    text[static_cast<std::size_t>(column(0))] = '|';
    return text;
}

void show(const jauscat::jaus::report_wrench_effort& efforts) {
    std::ostringstream rows;
    example::event_members raw;
    rows << example::bold("arm: efforts in force") << "\n";
    jauscat::wire::visit(efforts, [&]<class Item>(Item item, const auto& effort) {
        using range = typename Item::codec_type::range_type;
        raw.emplace_back(item.name(), static_cast<int>(Item::codec_type::to_raw(*effort)));
        rows << "  " << std::left << std::setw(32) << item.name() << std::right << std::setw(8) << std::fixed
             << std::setprecision(2) << *effort << ' ' << range::unit << "  [" << bar(*effort, range::min, range::max)
             << "]  raw " << static_cast<int>(Item::codec_type::to_raw(*effort)) << "\n";
    });
    example::write_limited("efforts", example::events::efforts_in_force, raw, rows.str());
}

std::optional<std::uint8_t> node_of(const boost::program_options::variables_map& values) {
    if (values.count("node") == 0) return {};
    const auto node = values["node"].as<unsigned>();
    if (node < 1 || node > 254) throw example::usage_error{"--node must be a JAUS node, 1 to 254"};
    return static_cast<std::uint8_t>(node);
}

template <class Table> int serve(auto& link, const std::string& where, std::uint8_t subsystem, const auto& values) {

    example::arm* arm_of_display = nullptr;
    const example::speaker say{"arm"};
    example::arm arm{say, [&] { show(arm_of_display->efforts()); }};
    arm_of_display = &arm;
    example::arm_application<Table> application{subsystem, arm, node_of(values)};
    bridging::listed_objects objects{application.objects, application,
                                     values["strict"].template as<bool>() ? bridging::size_rule::exact
                                                                          : bridging::size_rule::up_to_largest};
    auto description = example::arm_slave;
    description.mailbox_out_size = description.mailbox_in_size = example::mailbox_size_of(values);
    ethercat::mapped_objects mapped{description, objects};
    ethercat::standard_objects dictionary{description, mapped};
    std::array<std::byte, jauscat::bridging::largest_subobject(example::arm_application<Table>::objects)> memory{};
    ethercat::slave slave{description,
                          dictionary,
                          {.transfer_memory = memory,
                           .subindex_0_rule = values["subindex-0-rule"].template as<bool>(),
                           .empty_start = values["empty-start"].template as<bool>()}};
    mapped.show(slave.outputs(), slave.inputs());
    example::arm_process_data process_data{arm};
    const std::chrono::milliseconds command_timeout{values["command-timeout"].template as<unsigned>()};
    example::arm_watch watch{arm, command_timeout};
    if (command_timeout == command_timeout.zero())
        example::write_event(example::events::no_command_timeout, {},
                             example::bad("arm: without --command-timeout, efforts stay when the master falls silent") +
                                 "\n");

    example::write_event(example::events::ready, {{"subsystem", subsystem}, {"link", where}},
                         "arm: slave of subsystem " + std::to_string(subsystem) + ", " + where +
                             ", waiting for a master (Ctrl-C ends)\n");
    std::array<std::byte, 1600> frame{};
    auto state = slave.state();
    const auto show_state = [&] {
        if (slave.state() == state) return;
        state = slave.state();
        say(example::events::slave_state,
            {{"state", jauscat::text::to_text(state)}, {"station", slave.station_address()}},
            "state " + jauscat::text::to_text(state) + ", station address " + std::to_string(slave.station_address()));
    };
    const auto work = [&](jauscat::time_point now) {
        watch.look(slave, now); // first: the inputs say what is in force then
        process_data.work(slave);
        show_state();
    };
    std::string problem;
    while (!example::stop_requested) {
        const auto size = link.receive(frame, longest_wait);
        const auto now = jauscat::net::now();
        if (size == 0) {
            slave.on_time(now);
            work(now);
            if (link.problem() != problem) {
                problem = link.problem();
                if (!problem.empty()) say.bad(example::events::link_problem, {{"problem", problem}}, problem);
            }
            continue;
        }
        const auto received = std::span{frame}.first(size);
        application.set_station(slave.station_address());
        slave.process(received);
        slave.on_time(now); // after the frame: it may have waited here
        if (!link.send(received))
            say.bad(example::events::frame_not_returned, {{"problem", link.problem()}},
                    "a frame did not go back: " + link.problem());
        work(now);
    }
    example::write_event(example::events::stopped, {}, "arm: stopped\n");
    return example::success;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("robot_arm", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this arm belongs to, instead of the file's <thissystem>")
            ("node", po::value<unsigned>(), "JAUS node of this arm, 1 to 254, instead of the station address")
            ("command-timeout", po::value<unsigned>()->default_value(450), "milliseconds without a message after which efforts set by mailbox end; 0: never")
            ("empty-start", po::bool_switch(), "start segmented uploads without data, as some slaves do")
            ("strict", po::bool_switch(), "accept and return objects at their exact size only, as some slaves do: needs --fixed-length")
            ("subindex-0-rule", po::bool_switch(), "abort writes to PDO mapping objects while their subindex 0 is not 0, as some slaves do: needs the controller's --clear-subindex-0 or another --index-base");
        // clang-format on
        example::add_log_option(options);
        example::add_mailbox_option(options);
        example::add_link_options(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto subsystem = example::load_config(values).me().jausip.subsystem;
        return example::with_link(values, example::link_end::slave, [&](auto& link, const std::string& where) {
            return example::with_table(values,
                                       [&]<class Table>() { return serve<Table>(link, where, subsystem, values); });
        });
    });
}
