// jauscat-esi: writes the ESI file of a robot arm, and checks ESI files.
#include "arm_application.hpp"
#include "support/arm_slave.hpp"
#include "support/link_options.hpp"
#include "support/mailbox_option.hpp"
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/write_esi.hpp>

#include <fstream>

namespace {

namespace esi = jauscat::esi;

constexpr const char* help = R"(jauscat-esi: writes an ESI file (EtherCAT Slave Information), or checks one.

The file describes the slave that robot_arm emulates: its mailbox, its process data, its CoE features, its SII memory,
and an object for its JAUS component with an entry for each message that it accepts. It is for configuration tools and
emulators.

Examples:
  jauscat-esi --output arm.xml                          the robot arm, under the seed table
  jauscat-esi --component 38 --table self-contained     another component, to standard output
  jauscat-esi --index-base 0x2000 --output arm.xml      objects in the manufacturer's area
  jauscat-esi --check arm.xml                           lists the requirements of configuration tools, met or not

Exit code: 0 on success, with --check if nothing is missing; 1 if a file cannot be read or written, or something is
missing; 2 for a wrong command line.
)";

template <class Table> std::string esi_of(std::uint8_t component, std::uint16_t mailbox_size) {
    // The arm's own component is any other; the indices of components follow one another.
    auto objects = example::arm_application<Table>::objects;
    auto& own = objects.front();
    own.index = static_cast<std::uint16_t>(own.index - own.component + component);
    own.component = component;
    const std::string name = "component " + std::to_string(component);
    own.name = name;
    auto slave = example::arm_slave;
    slave.mailbox_out_size = slave.mailbox_in_size = mailbox_size;
    return esi::write_esi(esi::make_device(
        slave,
        {.vendor_name = "JausCat", .group_type = "JausCat", .group_name = "JAUS components", .type = "robot_arm"},
        objects, true));
}

int check(const std::string& file) {
    const auto checked = esi::check_esi(file);
    if (!checked) throw std::runtime_error{checked.error().message};
    const auto& findings = *checked;
    std::size_t missing = 0;
    for (const auto& each : findings) {
        std::cout << (each.met() ? example::good("ok     ") : example::bad("MISSING")) << "  " << each.what << "  ("
                  << each.reason << ")\n";
        if (each.met()) continue;
        ++missing;
        std::cout << "         " << example::bad(each.problem) << "\n";
    }
    std::cout << file << ": " << findings.size() - missing << " of " << findings.size()
              << " things that configuration tools require are there\n";
    return missing == 0 ? example::success : example::failure;
}

int write(const boost::program_options::variables_map& values) {
    const auto component = values["component"].as<unsigned>();
    if (component < 1 || component > 254)
        throw example::usage_error{"--component must be a JAUS component ID, 1 to 254"};
    const auto mailbox_size = example::mailbox_size_of(values);
    std::string text;
    example::with_table(values, [&]<class Table>() {
        text = esi_of<Table>(static_cast<std::uint8_t>(component), mailbox_size);
        return int{example::success};
    });
    if (values.count("output") == 0) {
        std::cout << text;
        return example::success;
    }
    const auto& path = values["output"].as<std::string>();
    std::ofstream file{path, std::ios::binary};
    file << text << std::flush;
    if (!file) throw std::runtime_error{path + ": cannot be written"};
    return example::success;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("jauscat-esi", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("component", po::value<unsigned>()->default_value(33), "JAUS component ID of the slave, 1 to 254")
            ("output", po::value<std::string>(), "file to write, instead of standard output")
            ("check", po::value<std::string>(), "ESI file to check; nothing is written");
        // clang-format on
        example::add_mailbox_option(options);
        example::add_table_options(options);
        const auto values = example::parse(argc, argv, options, help);
        return values.count("check") != 0 ? check(values["check"].as<std::string>()) : write(values);
    });
}
