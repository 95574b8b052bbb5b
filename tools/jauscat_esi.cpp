// jauscat-esi: writes the ESI file and the SII of a slave, and checks ESI files.
#include "support/arm_slave.hpp"
#include "support/link_options.hpp"
#include "support/mailbox_option.hpp"
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/esi/write_esi.hpp>
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/text/hex.hpp>

#include <algorithm>
#include <charconv>
#include <deque>
#include <fstream>
#include <map>

namespace {

namespace bridging = jauscat::bridging;
namespace catalogue = jauscat::catalogue;
namespace esi = jauscat::esi;
using jauscat::text::hex_number;

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
  jauscat-esi --sae --component 33=core,set_wrench_effort --output sae.xml
                                                        a component of SAE JAUS: messages, or all of a set (core,
                                                        mobility, environment_sensing, manipulator, ugv)
  jauscat-esi --index-base 0x2000 --output arm.xml      objects in the manufacturer's area
  jauscat-esi --from arm.xml --sii arm.bin              the SII of the slave that a file describes
  jauscat-esi --list terminals.xml                      the devices and modules of a file
  jauscat-esi --list terminals.xml --product 0x3EA3052  what one of them has: SyncManagers, PDOs, slots, slips of the file
  jauscat-esi --check arm.xml                           what the schema demands, the standard advises and the emulated
                                                        device needs: there or not, with the line

Of a file with several devices --check looks at all; for --from and --list --product, --revision and --device choose one. Where no device has the revision, it is
the newest below it, as a configuration tool does.

Exit code: 0 on success, with --check if the file has all that the schema demands; 1 if it has not, or if a file cannot be
read or written; 2 for a wrong command line.
)";

/// What a translation table makes of a component and of a message.
struct table_numbers {
    bool exact_size{};
    std::uint16_t (*index_of)(std::uint8_t component, std::uint16_t command_code){};
    bridging::sub_object (*sub_object_of)(std::uint16_t command_code, std::string_view name, std::size_t max_body){};
    const catalogue::list* messages{};
    std::map<std::string_view, const catalogue::list*> sets{}; ///< lists of messages that have a name

    template <class Table> static table_numbers of(const catalogue::list& messages) {
        const auto index = [](std::uint8_t component, std::uint16_t command_code) {
            typename Table::header_type header{};
            typename Table::packet_type packet{};
            Table::index_row::from::of(header) = component;
            Table::subindex_row::from::of(header) = command_code;
            static_cast<void>(Table::index_row::to_packet(header, packet, {})); // each message of the catalogue has one
            return static_cast<std::uint16_t>(Table::index_row::to::of(packet));
        };
        return {.exact_size = jauscat::translate::has_fixed_length<Table>,
                .index_of = index,
                .sub_object_of = &bridging::sub_object_of<Table>,
                .messages = &messages};
    }
    /// The table of SAE JAUS.
    template <class Table> static table_numbers of_sae() {
        auto made = of<Table>(catalogue::sae());
        made.sets = {{"core", &catalogue::sae_core_1_1()},
                     {"mobility", &catalogue::sae_mobility_1_1()},
                     {"environment_sensing", &catalogue::sae_environment_sensing_2_0()},
                     {"manipulator", &catalogue::sae_manipulator_2_0()},
                     {"ugv", &catalogue::sae_ground_vehicle_1_0()}};
        return made;
    }
    /// An SAE entry has the message ID in its size; behind a message is a sequence number of as many bytes.
    [[nodiscard]] bridging::sub_object of(const catalogue::entry& message) const {
        return sub_object_of(message.command_code(), message.name(),
                             message.takes_rest() ? jauscat::wire::unbounded : message.max_size());
    }
    /// A message by its name or its code, or the messages of a set.
    [[nodiscard]] std::vector<catalogue::entry> find(const std::string& text) const {
        if (const auto set = sets.find(text); set != sets.end()) return {set->second->begin(), set->second->end()};
        const auto found = messages->find(std::string_view{text});
        if (!found) throw example::usage_error{"--component: " + found.error().message};
        return {**found};
    }
};

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
        if (!table_.sets.empty())
            throw example::usage_error{"--sae needs the messages of each component: --component " + text +
                                       "=MESSAGE,..."};
        add(component, accepted_by_arm());
        if (std::ranges::find(objects_, every_component, &bridging::object_description::component) == objects_.end())
            add(every_component, accepted_by_arm());
    }
    [[nodiscard]] std::vector<catalogue::entry> named(const std::string& list) const {
        std::vector<catalogue::entry> messages;
        for (std::size_t at = 0;;) {
            const auto comma = list.find(',', at);
            const auto found = table_.find(list.substr(at, comma - at));
            messages.insert(messages.end(), found.begin(), found.end());
            if (comma == list.npos) return messages;
            at = comma + 1;
        }
    }
    static std::vector<catalogue::entry> accepted_by_arm() {
        std::vector<catalogue::entry> messages;
        for (const auto code : codes_of(robot_messages{})) messages.push_back(*catalogue::ra_3_3().find(code));
        return messages;
    }
    /// An object for each index that the table gives to messages of the component.
    void add(std::uint8_t component, const std::vector<catalogue::entry>& messages) {
        std::map<std::uint16_t, std::vector<bridging::sub_object>> by_index;
        for (const auto& message : messages)
            by_index[table_.index_of(component, message.command_code())].push_back(table_.of(message));
        const auto& name = names_.emplace_back("component " + std::to_string(component));
        for (auto& [index, entries] : by_index) {
            std::ranges::sort(entries, {}, &bridging::sub_object::subindex);
            const auto twice = std::ranges::adjacent_find(entries, {}, &bridging::sub_object::subindex);
            if (twice != entries.end())
                throw example::usage_error{"--" + name + ": " + std::string{twice->name} + " is there twice"};
            objects_.push_back({.index = index,
                                .component = component,
                                .name = name,
                                .exact_size = table_.exact_size,
                                .entries = entries_.emplace_back(std::move(entries))});
        }
    }

    table_numbers table_;
    std::deque<std::vector<bridging::sub_object>> entries_{}; // objects_ refers to these
    std::deque<std::string> names_{};
    std::vector<bridging::object_description> objects_{};
};

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

int check(const std::string& file) {
    const auto checked = esi::check_esi(file);
    if (!checked) throw std::runtime_error{checked.error().message};
    struct group {
        esi::demand by;
        const char* title;
        const char* missing;
    };
    bool fits_schema = true;
    for (const auto& [by, title, missing_text] :
         {group{esi::demand::schema, "the schema demands", "MISSING"},
          group{esi::demand::standard, "the standard advises", "without"},
          group{esi::demand::emulation, "the emulated device needs", "without"}}) {
        std::cout << title << ":\n";
        std::size_t all = 0, missing = 0;
        for (const auto& each : *checked) {
            if (each.by != by) continue;
            ++all;
            const auto label = padded(each.met() ? "ok" : missing_text, 7);
            std::cout << "  " << (each.met() ? example::good(label) : example::bad(label)) << "  " << each.what << "  ("
                      << each.reason << ")\n";
            if (each.met()) continue;
            ++missing;
            std::cout << "           " << example::bad(each.problem) << "\n";
        }
        if (by == esi::demand::schema) fits_schema = missing == 0;
        std::cout << "  " << all - missing << " of " << all << " are there\n";
    }
    std::cout << file << (fits_schema ? " has" : " does not have") << " what the schema demands\n";
    return fits_schema ? example::success : example::failure;
}

table_numbers ra_table_of(const boost::program_options::variables_map& values) {
    table_numbers table{};
    example::with_table(values, [&]<class Table>() {
        table = table_numbers::of<Table>(catalogue::ra_3_3());
        return int{example::success};
    });
    return table;
}
table_numbers sae_table_of(const boost::program_options::variables_map& values) {
    namespace tables = jauscat::translation;
    if (!values["table"].defaulted() || values["fixed-length"].as<bool>())
        throw example::usage_error{"--sae has a table of its own: leave out --table and --fixed-length"};
    const auto& base = values["index-base"];
    if (base.defaulted() || base.as<std::string>() == "0x2000") return table_numbers::of_sae<tables::sae_table>();
    if (base.as<std::string>() == "0x6900") return table_numbers::of_sae<tables::sae_table_at_6900h>();
    throw example::usage_error{"--index-base must be 0x2000 or 0x6900 with --sae, not '" + base.as<std::string>() +
                               "'"};
}

/// The device that the command line describes.
esi::device described(const boost::program_options::variables_map& values) {
    auto slave = example::arm_slave;
    slave.mailbox_out_size = slave.mailbox_in_size = example::mailbox_size_of(values);
    const auto table = values["sae"].as<bool>() ? sae_table_of(values) : ra_table_of(values);
    const component_objects objects{values["component"].as<std::vector<std::string>>(), table};
    return esi::make_device(
        slave,
        {.vendor_name = "JausCat", .group_type = "JausCat", .group_name = "JAUS components", .type = "robot_arm"},
        objects.all(), true);
}

esi::device_choice choice_of(const boost::program_options::variables_map& values) {
    const auto number = [&](const char* name) -> std::optional<std::uint32_t> {
        if (values.count(name) == 0) return std::nullopt;
        const auto& text = values[name].as<std::string>();
        if (const auto read = esi::parse_number_liberally(text)) return read;
        throw example::usage_error{std::string{"--"} + name + " must be a number such as 26 or 0x1A, not '" + text +
                                   "'"};
    };
    return {.product = number("product"), .revision = number("revision"), .number = number("device")};
}
bool is_chosen(const boost::program_options::variables_map& values) {
    return values.count("product") + values.count("revision") + values.count("device") != 0;
}

template <class T> T or_throw(jauscat::result<T, esi::error> read) {
    if (!read) throw std::runtime_error{read.error().message};
    return *std::move(read);
}

/// The device of a file.
esi::device read(const boost::program_options::variables_map& values) {
    for (const auto* const other : {"component", "sae", "mailbox-size", "table", "index-base", "fixed-length"})
        if (!values[other].defaulted())
            throw example::usage_error{std::string{"--from and --"} + other + " exclude each other"};
    return or_throw(esi::read_esi(values["from"].as<std::string>(), choice_of(values)));
}

void print_pdos(const std::vector<esi::pdo>& pdos, const char* direction) {
    for (const auto& each : pdos) {
        std::cout << direction << " " << hex_number(each.index, 4) << " \"" << each.name << "\", "
                  << (each.sync_manager == esi::not_assigned ? std::string{"not assigned"}
                                                             : "SyncManager " + std::to_string(each.sync_manager))
                  << (each.fixed ? ", fixed" : "") << (each.mandatory ? ", mandatory" : "") << '\n';
        for (const auto& entry : each.entries)
            std::cout << "  " << padded(std::to_string(entry.bits) + " bits", 10)
                      << (entry.index == 0 ? "gap"
                                           : hex_number(entry.index, 4) + ':' + std::to_string(entry.subindex) + "  " +
                                                 padded(entry.type, 8) + "  " + entry.name)
                      << '\n';
    }
}

/// The line where the file has a slip, and why it costs something.
void print_slips(const std::vector<esi::error>& slips) {
    for (const auto& each : slips) std::cout << example::bad("left out: " + each.message) << '\n';
}

void print_device(const esi::device& device) {
    std::cout << device.type << " \"" << device.name << "\" of \"" << device.vendor_name << "\", vendor "
              << hex_number(device.vendor_id, 8) << ", product " << hex_number(device.product_code, 8) << ", revision "
              << hex_number(device.revision, 8) << '\n';
    std::string protocols = device.has_coe ? "CoE" : "";
    for (const auto& each : device.protocols) protocols += (protocols.empty() ? "" : ", ") + each;
    std::cout << "mailbox: " << (protocols.empty() ? "none" : protocols) << '\n';
    for (std::size_t i = 0; i != device.sync_managers.size(); ++i) {
        const auto& each = device.sync_managers[i];
        const auto* const use =
            std::ranges::find(esi::sync_manager_uses, each.use, [](const auto& known) { return known.first; });
        std::cout << "SyncManager " << i << ": "
                  << (use == esi::sync_manager_uses.end() ? std::string_view{"no use"} : use->second) << ", start "
                  << hex_number(each.start, 4) << ", " << each.default_size << " bytes, control "
                  << hex_number(each.control, 2) << '\n';
    }
    print_pdos(device.rx_pdos, "outputs");
    print_pdos(device.tx_pdos, "inputs");
    for (const auto& each : device.clock_modes)
        std::cout << "clock mode \"" << each.name << "\": AssignActivate " << hex_number(each.assign_activate, 4)
                  << '\n';
    for (const auto& each : device.start_up) {
        std::cout << "start-up object " << hex_number(each.index, 4) << ':' << int{each.subindex} << " = "
                  << esi::hex_bytes(each.data);
        for (const auto& transition : each.transitions) std::cout << ' ' << transition;
        std::cout << (each.comment.empty() ? "" : "  " + each.comment) << '\n';
    }
    for (const auto& each : device.slots) {
        std::cout << "slot \"" << each.name << "\", " << each.min_instances << " to " << each.max_instances << ":";
        for (const auto ident : each.module_idents) std::cout << ' ' << hex_number(ident, 8);
        for (const auto& name : each.module_classes) std::cout << ' ' << name;
        std::cout << '\n';
    }
    std::cout << device.objects.size() << " objects\n";
    print_slips(device.slips);
}

int list(const boost::program_options::variables_map& values) {
    const auto& path = values["list"].as<std::string>();
    const auto file = or_throw(esi::esi_file::open(path));
    if (is_chosen(values)) {
        print_device(or_throw(file.read(choice_of(values))));
        return example::success;
    }
    std::size_t number = 0, width = 4;
    for (const auto& each : file.devices()) width = std::max(width, each.type.size());
    if (!file.devices().empty()) std::cout << "device  product     revision    " << padded("type", width) << "  name\n";
    for (const auto& each : file.devices())
        std::cout << padded(std::to_string(number++), 6) << "  " << hex_number(each.product_code, 8) << "  "
                  << hex_number(each.revision, 8) << "  " << padded(each.type, width) << "  " << each.name << '\n';
    const auto modules = file.modules();
    for (const auto& each : modules) {
        std::cout << "module  " << hex_number(each.ident, 8) << "  " << padded(each.module_class, 10) << "  "
                  << padded(each.type, width) << "  " << each.name << '\n';
        print_slips(each.slips);
    }
    std::cout << path << ": " << file.devices().size() << (file.devices().size() == 1 ? " device" : " devices") << ", "
              << modules.size() << (modules.size() == 1 ? " module" : " modules") << '\n';
    return example::success;
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
        const esi::emulated_device emulated{device};
        const auto sii = emulated.sii();
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
            ("sae", po::bool_switch(), "components and messages are those of SAE JAUS, at the objects of its table")
            ("output", po::value<std::string>(), "ESI file to write, instead of standard output")
            ("sii", po::value<std::string>(), "file to write with the content of the SII")
            ("from", po::value<std::string>(), "ESI file that describes the slave, instead of the other options")
            ("list", po::value<std::string>(), "ESI file whose devices and modules are listed; with a choice, what that device has")
            ("product", po::value<std::string>(), "choose a device of the file by its product code")
            ("revision", po::value<std::string>(), "choose it by its revision, or the newest one below")
            ("device", po::value<std::string>(), "choose it by its number in the file, from 0")
            ("check", po::value<std::string>(), "ESI file to check; nothing is written");
        // clang-format on
        example::add_mailbox_option(options);
        example::add_table_options(options);
        const auto values = example::parse(argc, argv, options, help);
        if (is_chosen(values) && values.count("from") + values.count("list") == 0)
            throw example::usage_error{
                "--product, --revision and --device choose a device of the file of --from or --list"};
        if (values.count("list") != 0) return list(values);
        return values.count("check") != 0 ? check(values["check"].as<std::string>()) : write(values);
    });
}
