// jauscat-esi: writes the ESI file and the SII of a slave, and checks ESI files.
#include "support/arm_slave.hpp"
#include "support/link_options.hpp"
#include "support/mailbox_option.hpp"
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/write_esi.hpp>

#include <algorithm>
#include <charconv>
#include <deque>
#include <fstream>

namespace {

namespace bridging = jauscat::bridging;
namespace catalogue = jauscat::catalogue;
namespace esi = jauscat::esi;

constexpr const char* help =
    R"(jauscat-esi: writes an ESI file (EtherCAT Slave Information) and an SII, or checks a file.

Both describe the slave that robot_arm emulates: its mailbox, its process data, its CoE features, an object for its JAUS
component with an entry for each message that it accepts, and one for messages to all components. --component describes a slave with other components and
messages. The ESI file is for configuration tools and emulators, the SII for the slave's memory. With --sii alone no ESI
file is written.

Examples:
  jauscat-esi --output arm.xml                          the robot arm, under the seed table
  jauscat-esi --output arm.xml --sii arm.bin            and what its SII holds
  jauscat-esi --component 38 --table self-contained     another component, to standard output
  jauscat-esi --component 56=set_joint_velocities,query_joint_velocities,report_joint_velocities --output joints.xml
                                                        a component with messages by name or code, such as 0x0603;
                                                        may be repeated for several components
  jauscat-esi --index-base 0x2000 --output arm.xml      objects in the manufacturer's area
  jauscat-esi --from arm.xml --sii arm.bin              the SII of the slave that a file describes
  jauscat-esi --check arm.xml                           lists the requirements of configuration tools, met or not

Exit code: 0 on success, with --check if nothing is missing; 1 if a file cannot be read or written, or something is
missing; 2 for a wrong command line.
)";

/// What a translation table makes of a component and of a message.
struct table_numbers {
    std::uint16_t first_index{}; ///< of component 1; those of the others follow
    bool exact_size{};
    bridging::sub_object (*sub_object_of)(std::uint16_t command_code, std::string_view name, std::size_t max_body){};

    template <class Table> static constexpr table_numbers of() {
        return {bridging::object_list<Table, 1>::index, jauscat::translate::has_fixed_length<Table>,
                &bridging::sub_object_of<Table>};
    }
    [[nodiscard]] bridging::sub_object of(const catalogue::entry& message) const {
        return sub_object_of(message.command_code(), message.name(),
                             message.takes_rest() ? jauscat::wire::unbounded : message.max_size());
    }
};

/// A message by its name or its code.
const catalogue::entry& find_message(const std::string& text) {
    const auto found = catalogue::ra_3_3().find(text);
    if (!found) throw example::usage_error{"--component: " + found.error().message};
    return **found;
}

/// The messages that robot_arm accepts.
template <class... Messages> std::vector<std::uint16_t> codes_of(jauscat::jaus::message_list<Messages...>) {
    return {jauscat::jaus::command_code_of<Messages>...};
}

/// The objects of components as the command line names them: `33`, or `33=set_wrench_effort,0x2405`.
class component_objects {
  public:
    component_objects(const std::vector<std::string>& components, const table_numbers& table) : table_{table} {
        for (const auto& each : components) parse(each);
        std::ranges::sort(objects_, {}, &bridging::object_description::index);
        const auto twice = std::ranges::adjacent_find(objects_, {}, &bridging::object_description::index);
        if (twice != objects_.end())
            throw example::usage_error{"--component " + std::to_string(twice->component) + " is there twice"};
    }
    component_objects(const component_objects&) = delete;
    component_objects& operator=(const component_objects&) = delete;

    [[nodiscard]] std::span<const bridging::object_description> all() const { return objects_; }

  private:
    static constexpr std::uint8_t every_component = 255;

    void parse(const std::string& text) {
        const auto equals = text.find('=');
        const bool has_messages = equals != text.npos;
        unsigned id{};
        const auto* const end = text.data() + std::min(equals, text.size());
        const auto [stop, error] = std::from_chars(text.data(), end, id);
        if (error != std::errc{} || stop != end || id < 1 || id > (has_messages ? every_component : 254u))
            throw example::usage_error{"--component must be a JAUS component ID, 1 to 254, or with messages also 255 "
                                       "for all components, not '" +
                                       text + "'"};
        const auto component = static_cast<std::uint8_t>(id);
        if (has_messages) return add(component, named(text.substr(equals + 1)));
        add(component, accepted_by_arm());
        if (std::ranges::find(objects_, every_component, &bridging::object_description::component) == objects_.end())
            add(every_component, accepted_by_arm());
    }
    [[nodiscard]] std::vector<bridging::sub_object> named(const std::string& list) const {
        std::vector<bridging::sub_object> messages;
        for (std::size_t at = 0;;) {
            const auto comma = list.find(',', at);
            messages.push_back(table_.of(find_message(list.substr(at, comma - at))));
            if (comma == list.npos) return messages;
            at = comma + 1;
        }
    }
    [[nodiscard]] std::vector<bridging::sub_object> accepted_by_arm() const {
        std::vector<bridging::sub_object> messages;
        for (const auto code : codes_of(robot_messages{}))
            messages.push_back(table_.of(*catalogue::ra_3_3().find(code)));
        return messages;
    }
    void add(std::uint8_t component, std::vector<bridging::sub_object> messages) {
        std::ranges::sort(messages, {}, &bridging::sub_object::subindex);
        const auto& name = names_.emplace_back("component " + std::to_string(component));
        const auto twice = std::ranges::adjacent_find(messages, {}, &bridging::sub_object::subindex);
        if (twice != messages.end())
            throw example::usage_error{"--" + name + ": " + std::string{twice->name} + " is there twice"};
        objects_.push_back({.index = static_cast<std::uint16_t>(table_.first_index + component - 1),
                            .component = component,
                            .name = name,
                            .exact_size = table_.exact_size,
                            .entries = entries_.emplace_back(std::move(messages))});
    }

    table_numbers table_;
    std::deque<std::vector<bridging::sub_object>> entries_{}; // objects_ refers to these
    std::deque<std::string> names_{};
    std::vector<bridging::object_description> objects_{};
};

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

/// The device that the command line describes.
esi::device described(const boost::program_options::variables_map& values) {
    auto slave = example::arm_slave;
    slave.mailbox_out_size = slave.mailbox_in_size = example::mailbox_size_of(values);
    table_numbers table{};
    example::with_table(values, [&]<class Table>() {
        table = table_numbers::of<Table>();
        return int{example::success};
    });
    const component_objects objects{values["component"].as<std::vector<std::string>>(), table};
    return esi::make_device(
        slave,
        {.vendor_name = "JausCat", .group_type = "JausCat", .group_name = "JAUS components", .type = "robot_arm"},
        objects.all(), true);
}

/// The device of a file.
esi::device read(const boost::program_options::variables_map& values) {
    for (const auto* const other : {"component", "mailbox-size", "table", "index-base", "fixed-length"})
        if (!values[other].defaulted())
            throw example::usage_error{std::string{"--from and --"} + other + " exclude each other"};
    const auto device = esi::read_esi(values["from"].as<std::string>());
    if (!device) throw std::runtime_error{device.error().message};
    return *device;
}

void put(const std::string& path, std::string_view bytes) {
    std::ofstream file{path, std::ios::binary};
    file << bytes << std::flush;
    if (!file) throw std::runtime_error{path + ": cannot be written"};
}

int write(const boost::program_options::variables_map& values) {
    const auto device = values.count("from") != 0 ? read(values) : described(values);
    if (values.count("output") != 0)
        put(values["output"].as<std::string>(), esi::write_esi(device));
    else if (values.count("sii") == 0)
        std::cout << esi::write_esi(device);
    if (values.count("sii") != 0) {
        const auto sii = esi::emulated_device{device}.sii();
        put(values["sii"].as<std::string>(), {reinterpret_cast<const char*>(sii.data()), sii.size()});
    }
    return example::success;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("jauscat-esi", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("component", po::value<std::vector<std::string>>()->composing()->default_value({"33"}, "33"),
             "JAUS component of the slave: ID, with the messages of robot_arm, or ID=MESSAGE,...; may be repeated")
            ("output", po::value<std::string>(), "ESI file to write, instead of standard output")
            ("sii", po::value<std::string>(), "file to write with the content of the SII")
            ("from", po::value<std::string>(), "ESI file that describes the slave, instead of the other options")
            ("check", po::value<std::string>(), "ESI file to check; nothing is written");
        // clang-format on
        example::add_mailbox_option(options);
        example::add_table_options(options);
        const auto values = example::parse(argc, argv, options, help);
        return values.count("check") != 0 ? check(values["check"].as<std::string>()) : write(values);
    });
}
