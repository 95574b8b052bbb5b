// A bus of emulated EtherCAT slaves behind a network interface or UDP, for masters to be tried against.
#include "arrival_time.hpp"
#include "line_source.hpp"
#include "stored_objects.hpp"
#include "support/link_options.hpp"
#include "support/say.hpp"
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/emulated_objects.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/slave_tree.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/value.hpp>

#include <algorithm>
#include <deque>
#include <map>
#include <sstream>

namespace {

namespace esi = jauscat::esi;
namespace ethercat = jauscat::ethercat;
using jauscat::text::hex_number;

constexpr const char* help = R"(emulated_bus: emulates a chain of EtherCAT slaves, to test masters.

The slaves have a CoE mailbox with SDO information and complete access, and process data with --outputs and --inputs.
Each has these objects of exact sizes, which store the written values:
  0x2000:0 1 byte    0x2001:0 2 bytes   0x2002:0 4 bytes   0x2003:0 28 bytes  0x2004:0 1000 bytes
  0x2010:1 to 0x2010:4, 4 bytes each    0x1AF4:1 and 0x6926:1, 28 bytes each
With --clock they have 0x1C32 and 0x1C33, too: missed SYNC0 are in subindex 11, an error in subindex 32. A frame comes back when it
has passed all cables, so that masters measure their delays: 300 ns in each slave, and --cable on each cable.
In OP the inputs repeat the outputs, so that a master can check its cycle.
With --esi the slaves are those of an ESI file, of jauscat-esi or of a vendor: its SyncManagers, PDOs, SII, and objects with
their default values. A report of a JAUS component that is read is the one written last. Of a file with several devices --product
and --revision choose one, or --device, which may be repeated, some by their numbers (jauscat-esi --list).
With --commands it takes lines of standard input: "emergency SLAVE CODE [REGISTER [BYTES]]" with the slave's position from 0, the
error code, the error register, and up to 5 bytes in hex. It is sent once a master has brought the slave to PRE-OP.

Examples:
  emulated_bus                                          one slave, EtherCAT in UDP on port 34980
  emulated_bus --slaves 5 --outputs 8 --inputs 8 --link raw --interface eth0
  emulated_bus --mailbox-size 24 --slow 20              small and slow
  emulated_bus --slaves 6 --outputs 2 --clock 64 --drift 100 --sync-missed 10
                                                        distributed clocks that drift
  emulated_bus --subindex-0-rule --state-rule           strict rules for mapping objects
  emulated_bus --esi arm.xml                            the slave that a file describes
  emulated_bus --esi terminals.xml --device 0 --device 7
                                                        two devices of a file with many
  echo "emergency 0 0x8110 0x11" | emulated_bus --commands
                                                        slave 0 sends an emergency
  emulated_bus --abort 0x2002=0x08000021 --abort 0x2010:1=0x06060000
)";

/// `0x2010:1` as an index and, if given, a subindex.
struct object_place {
    std::uint16_t index{};
    std::optional<std::uint8_t> subindex{};
};

unsigned long parse_number(const std::string& text, unsigned long most, const std::string& option) {
    std::size_t used = 0;
    unsigned long value = 0;
    try {
        value = std::stoul(text, &used, 0);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used == 0 || used != text.size() || text.front() == '-' || value > most)
        throw example::usage_error{"--" + option + ": '" + text + "' is no number such as 0x1A or 26, at most " +
                                   std::to_string(most)};
    return value;
}

object_place parse_place(const std::string& text, const std::string& option) {
    const auto colon = text.find(':');
    object_place place{.index = static_cast<std::uint16_t>(parse_number(text.substr(0, colon), 0xFFFF, option))};
    if (colon != text.npos)
        place.subindex = static_cast<std::uint8_t>(parse_number(text.substr(colon + 1), 0xFF, option));
    return place;
}

/// `INDEX[:SUB]=NUMBER`
std::pair<object_place, unsigned long> parse_setting(const std::string& text, unsigned long most,
                                                     const std::string& option) {
    const auto equals = text.find('=');
    if (equals == text.npos)
        throw example::usage_error{"--" + option + ": expected INDEX[:SUB]=NUMBER, not '" + text + "'"};
    return {parse_place(text.substr(0, equals), option), parse_number(text.substr(equals + 1), most, option)};
}

/// `size` bytes as process data: bytes, or, where these would be too many, values of 8 bytes and a rest.
struct process_data {
    std::deque<std::string> names{};
    std::vector<ethercat::pdo_entry> entries{};

    process_data(std::uint16_t index, std::size_t size, const std::string& name) {
        const std::size_t each = size <= ethercat::process_memory::max_entries - 1 ? 1 : 8;
        for (std::size_t at = 0; at < size; at += each) {
            const auto bytes = std::min(each, size - at);
            names.push_back(name + " " + std::to_string(entries.size() + 1));
            const std::uint8_t type = bytes == 1 ? 0x05 : bytes == 8 ? 0x1B : 0x0A; // UNSIGNED8 or 64, octets
            entries.push_back({.index = index,
                               .subindex = static_cast<std::uint8_t>(entries.size() + 1),
                               .bits = static_cast<std::uint8_t>(bytes * 8),
                               .data_type = type,
                               .name = names.back()});
        }
    }
};

/// Holds what was written last to each entry, of any size.
class written_objects {
  public:
    /// Called after each write.
    std::function<void(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data)> on_write{};

    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) const noexcept {
        const auto found = values_.find({index, subindex});
        if (found == values_.end()) return {.error = ethercat::abort_code::no_data};
        if (found->second.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        std::ranges::copy(found->second, out.begin());
        return {.size = found->second.size()};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        values_[{index, subindex}].assign(data.begin(), data.end());
        if (on_write) on_write(index, subindex, data);
        return ethercat::abort_code::none;
    }

  private:
    std::map<std::pair<std::uint16_t, std::uint8_t>, std::vector<std::byte>> values_{};
};

/// One slave with its objects, and what was logged about it.
class node {
  public:
    node(std::size_t position, const ethercat::slave_description& description, ethercat::coe_options options,
         const std::vector<std::pair<object_place, unsigned long>>& more)
        : say_{"slave " + std::to_string(position), {{"slave", position}}},
          dictionary_{description, prepare(more)},
          memory_(objects_.largest()),
          slave_{description, dictionary_, with_memory(options)} {
        if (description.synchronization) dictionary_.show(slave_.synchronization());
        objects_.add_mapped(description.outputs, slave_.outputs(), true);
        objects_.add_mapped(description.inputs, slave_.inputs(), false);
        objects_.on_write = [this](auto... what) { show_write(what...); };
    }
    /// The slave of a file, which outlives it.
    node(std::size_t position, const esi::emulated_device& file, ethercat::coe_options options)
        : say_{"slave " + std::to_string(position), {{"slave", position}}},
          file_objects_{std::in_place, file, messages_},
          dictionary_{file.description(), *file_objects_},
          memory_(file.transfer_size()),
          slave_{file.description(), *file_objects_, with_memory(options)} {
        file_objects_->show(slave_);
        messages_.on_write = [this](auto... what) { show_write(what...); };
    }
    node(const node&) = delete;
    node& operator=(const node&) = delete;

    ethercat::slave& slave() { return slave_; }

    /// Inputs repeat outputs.
    void work() {
        if (!slave_.take_outputs()) return;
        const auto outputs = slave_.outputs();
        const auto inputs = slave_.inputs();
        std::ranges::copy(outputs.first(std::min(outputs.size(), inputs.size())), inputs.begin());
    }

    void show_changes() {
        if (slave_.station_address() != station_) {
            station_ = slave_.station_address();
            say_(example::events::station_address, {{"station", station_}},
                 "station address " + std::to_string(station_) + " (" + hex_number(station_, 4) + ")");
        }
        const auto status = slave_.status();
        if (status.state == status_.state && status.error == status_.error && status.code == status_.code) return;
        status_ = status;
        const auto line = "state " + jauscat::text::to_text(status.state);
        const example::event_members members{
            {"state", jauscat::text::to_text(status.state)}, {"error", status.error}, {"code", status.code}};
        if (!status.error)
            say_(example::events::slave_state, members, line);
        else
            say_.bad(example::events::slave_state, members,
                     line + ", error " + hex_number(static_cast<std::uint16_t>(status.code), 4) + ": " +
                         std::string{describe(status.code)});
    }

    void show_emergency(const ethercat::coe_emergency& what) const {
        say_(example::events::emergency_sent,
             {{"error_code", what.error_code},
              {"error_register", what.error_register},
              {"data", jauscat::text::hex(what.data)}},
             "emergency " + hex_number(what.error_code, 4) + ", error register " + hex_number(what.error_register, 2) +
                 ", " + jauscat::text::hex(what.data));
    }

  private:
    void show_write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) const {
        constexpr std::size_t shown = 32;
        say_(example::events::object_written,
             {{"index", index}, {"subindex", subindex}, {"data", jauscat::text::hex(data)}, {"size", data.size()}},
             hex_number(index, 4) + ":" + std::to_string(subindex) + " = " +
                 jauscat::text::hex(data.first(std::min(data.size(), shown))) + (data.size() > shown ? " ..." : "") +
                 " (" + std::to_string(data.size()) + " bytes)");
    }
    example::stored_objects& prepare(const std::vector<std::pair<object_place, unsigned long>>& more) {
        for (const auto& [index, size] : {std::pair{0x2000, 1}, {0x2001, 2}, {0x2002, 4}, {0x2003, 28}, {0x2004, 1000}})
            objects_.add(static_cast<std::uint16_t>(index), 0, static_cast<std::size_t>(size));
        for (std::uint8_t subindex = 1; subindex <= 4; ++subindex) objects_.add(0x2010, subindex, 4);
        objects_.add(0x1AF4, 1, 28);
        objects_.add(0x6926, 1, 28);
        for (const auto& [place, size] : more) objects_.add(place.index, place.subindex.value_or(0), size);
        return objects_;
    }
    ethercat::coe_options with_memory(ethercat::coe_options options) {
        options.transfer_memory = memory_;
        return options;
    }

    example::speaker say_;
    example::stored_objects objects_{};
    written_objects messages_{}; // of a file's components
    std::optional<esi::emulated_objects> file_objects_{};
    ethercat::standard_objects dictionary_;
    std::vector<std::byte> memory_;
    ethercat::slave slave_;
    std::uint16_t station_{};
    ethercat::al_status status_{.state = ethercat::al_state::init};
};

/// Emergencies of the lines of standard input, kept until their slaves can send them.
class emergency_commands {
  public:
    explicit emergency_commands(std::deque<node>& nodes) : nodes_{nodes} {}

    void work() {
        while (const auto line = lines_.next()) {
            try {
                take(*line);
            } catch (const std::exception& wrong) {
                say_.bad(example::events::line_refused, {{"line", *line}}, std::string{wrong.what()});
            }
        }
        std::erase_if(waiting_, [&](const auto& each) {
            const auto& [slave, what] = each;
            if (!nodes_[slave].slave().send_emergency(what)) return false;
            nodes_[slave].show_emergency(what);
            return true;
        });
    }

  private:
    void take(const std::string& line) {
        std::istringstream words{line};
        std::string command, slave, code, error_register = "0", data;
        if (!(words >> command)) return; // an empty line
        words >> slave >> code;
        if (command != "emergency" || code.empty())
            throw std::invalid_argument{"expected 'emergency SLAVE CODE [REGISTER [BYTES]]', not '" + line + "'"};
        words >> error_register;
        std::getline(words, data);
        const auto bytes = esi::parse_bytes(data);
        ethercat::coe_emergency what{.error_code = static_cast<std::uint16_t>(parse_number(code, 0xFFFF, "commands")),
                                     .error_register =
                                         static_cast<std::uint8_t>(parse_number(error_register, 0xFF, "commands"))};
        if (!bytes || bytes->size() > what.data.size())
            throw std::invalid_argument{"'" + data + "' are not up to 5 bytes in hex"};
        std::ranges::copy(*bytes, what.data.begin());
        waiting_.emplace_back(parse_number(slave, nodes_.size() - 1, "commands"), what);
    }

    std::deque<node>& nodes_;
    script_lines lines_{};
    std::vector<std::pair<std::size_t, ethercat::coe_emergency>> waiting_{};
    example::speaker say_{"emulated_bus"};
};

/// `has_clocks`: a frame goes back when it is back on the bus, so that the next one does not overtake it. Otherwise it
/// is of no consequence when slaves see it.
int serve(jauscat::net::any_link& link, const std::string& where, std::deque<node>& nodes,
          std::chrono::nanoseconds cable, bool has_clocks, emergency_commands* commands) {
    std::vector<ethercat::wired_slave> wires;
    for (auto& each : nodes)
        wires.push_back(
            {.device = &each.slave(), .parent = std::max(wires.size(), std::size_t{1}) - 1, .cable = cable});
    ethercat::slave_tree tree{wires, std::chrono::nanoseconds{300}};
    example::write_event(example::events::ready, {{"slaves", nodes.size()}, {"link", where}},
                         std::to_string(nodes.size()) + (nodes.size() == 1 ? " slave, " : " slaves, ") + where +
                             ", waiting for a master (Ctrl-C ends)\n");
    std::array<std::byte, 1600> frame{};
    const example::speaker say{"emulated_bus"};
    std::string problem;
    std::uint64_t frames = 0;
    static_cast<void>(arrival_time(link.native_handle()));
    bool is_idle = true;
    jauscat::time_point back{}; // the last frame, by the slaves' time
    while (!example::stop_requested) {
        // Frames that wait came before now: the slaves' time does not pass them.
        const auto size = link.receive(frame, is_idle ? std::chrono::milliseconds{20} : std::chrono::milliseconds{});
        const auto at = std::max(size != 0 ? arrival_time(link.native_handle()) : jauscat::net::now(), back);
        is_idle = size == 0;
        if (size != 0) {
            ++frames;
            const auto received = std::span{frame}.first(size);
            // First the frame, as the hardware does, and only then what the slaves make of it.
            const auto returns = tree.pass(received, at);
            if (has_clocks) {
                back = returns;
                // To sleep may take a millisecond, to give way to other programs several.
                while (jauscat::net::now() < back) {}
            }
            if (!link.send(received))
                say.bad(example::events::frame_not_returned, {{"problem", link.problem()}},
                        "a frame did not go back: " + link.problem());
            for (auto& each : nodes) {
                each.slave().work();
                each.work();
            }
        } else if (link.problem() != problem) {
            problem = link.problem();
            if (!problem.empty()) say.bad(example::events::link_problem, {{"problem", problem}}, problem);
        }
        if (commands != nullptr) commands->work();
        for (auto& each : nodes) {
            each.slave().pass_time(at);
            each.slave().on_time(at);
            each.show_changes();
        }
    }
    example::write_event(example::events::stopped, {{"frames", frames}},
                         "stopped after " + std::to_string(frames) + " frames\n");
    return example::success;
}

/// The devices of the ESI file that are chosen. What the file has wrong is said.
void read_devices(const boost::program_options::variables_map& values, std::deque<esi::emulated_device>& into) {
    const auto file = esi::esi_file::open(values["esi"].as<std::string>());
    if (!file) throw std::runtime_error{file.error().message};
    const auto number = [](const std::string& text, const char* option) {
        return static_cast<std::uint32_t>(parse_number(text, 0xFFFFFFFF, option));
    };
    const auto add = [&](const esi::device_choice& choice) {
        const auto read = file->read(choice);
        if (!read) throw std::runtime_error{read.error().message};
        for (const auto& each : read->slips) std::cerr << "left out: " << each.message << "\n";
        into.emplace_back(*read);
    };
    esi::device_choice choice;
    if (!values["product"].defaulted()) choice.product = number(values["product"].as<std::string>(), "product");
    if (values.count("revision") != 0) choice.revision = number(values["revision"].as<std::string>(), "revision");
    if (values.count("device") == 0) return add(choice);
    for (const auto& each : values["device"].as<std::vector<std::string>>()) {
        choice.number = number(each, "device");
        add(choice);
    }
}

} // namespace

int main(int argc, char** argv) {
    return example::run("emulated_bus", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("slaves", po::value<std::size_t>()->default_value(1), "number of slaves, 1 to 100")
            ("outputs", po::value<std::size_t>()->default_value(0), "bytes of process data to each slave, 0 to 682")
            ("inputs", po::value<std::size_t>()->default_value(0), "bytes of process data from each slave, 0 to 1024")
            ("mailbox-size", po::value<std::uint16_t>()->default_value(128), "bytes of each mailbox, 24 to 1486")
            ("vendor", po::value<std::string>()->default_value("0x4A430000"), "vendor ID")
            ("product", po::value<std::string>()->default_value("0x00B5"), "product code")
            ("esi", po::value<std::string>(), "ESI file that describes the slaves, in place of --outputs, --inputs, --mailbox-size, --vendor, --eight-byte-sii, --object, --clock, --drift and --sync-missed")
            ("device", po::value<std::vector<std::string>>()->composing(), "number of a device in the ESI file, from 0; may be repeated for a chain of them")
            ("revision", po::value<std::string>(), "revision of the device in the ESI file, or the newest one below")
            ("eight-byte-sii", po::bool_switch(), "a read of the SII returns 8 bytes instead of 4")
            ("clock", po::value<unsigned>()->default_value(0), "bits of each slave's distributed clock, 32 or 64; 0: none")
            ("drift", po::value<unsigned>()->default_value(0), "largest error of the clocks in ppm, 0 to 1000: the first is slow, the last fast")
            ("cable", po::value<unsigned>()->default_value(200), "delay that the clocks see on each cable, 0 to 100000 ns")
            ("sync-missed", po::value<std::uint16_t>()->default_value(0), "leave OP after so many SYNC0 in a row without new outputs; 0: never")
            ("object", po::value<std::vector<std::string>>()->composing(), "another object: INDEX[:SUB]=BYTES; may be repeated")
            ("abort", po::value<std::vector<std::string>>()->composing(), "abort every transfer of an object: INDEX[:SUB]=CODE; may be repeated")
            ("subindex-0-rule", po::bool_switch(), "abort writes to PDO mapping objects while their subindex 0 is not 0")
            ("state-rule", po::bool_switch(), "abort writes to PDO mapping objects in other states than PRE-OP")
            ("empty-start", po::bool_switch(), "segmented uploads start without data")
            ("commands", po::bool_switch(), "take emergencies from standard input: emergency SLAVE CODE [REGISTER [BYTES]]")
            ("slow", po::value<std::uint32_t>()->default_value(0), "number of frames before a mailbox request is answered");
        // clang-format on
        example::add_log_option(options);
        example::add_medium_options(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto within = [&](const char* name, std::size_t value, std::size_t least, std::size_t most) {
            if (value >= least && value <= most) return value;
            throw example::usage_error{std::string{"--"} + name + " must be " + std::to_string(least) + " to " +
                                       std::to_string(most)};
        };
        const auto settings = [&](const char* name, unsigned long most) {
            std::vector<std::pair<object_place, unsigned long>> parsed;
            if (values.count(name) != 0)
                for (const auto& text : values[name].as<std::vector<std::string>>())
                    parsed.push_back(parse_setting(text, most, name));
            return parsed;
        };
        const auto number = [&](const char* name) {
            return static_cast<std::uint32_t>(parse_number(values[name].as<std::string>(), 0xFFFFFFFF, name));
        };

        const process_data outputs{
            0x7000, within("outputs", values["outputs"].as<std::size_t>(), 0, ethercat::process_memory::max_outputs),
            "output"};
        const process_data inputs{
            0x6000, within("inputs", values["inputs"].as<std::size_t>(), 0, ethercat::process_memory::max_inputs),
            "input"};
        const auto mailbox =
            static_cast<std::uint16_t>(within("mailbox-size", values["mailbox-size"].as<std::uint16_t>(),
                                              ethercat::min_mailbox_size, ethercat::max_mailbox_size));
        std::vector<ethercat::refused_object> refused;
        for (const auto& [place, code] : settings("abort", 0xFFFFFFFF))
            refused.push_back({place.index, place.subindex, static_cast<ethercat::abort_code>(code)});
        const auto objects = settings("object", 0xFFFF);
        const ethercat::coe_options rules{.subindex_0_rule = values["subindex-0-rule"].as<bool>(),
                                          .empty_start = values["empty-start"].as<bool>(),
                                          .state_rule = values["state-rule"].as<bool>(),
                                          .answer_delay = values["slow"].as<std::uint32_t>(),
                                          .refused = refused};
        std::deque<esi::emulated_device> devices;
        if (values.count("esi") != 0) {
            for (const auto* const other : {"outputs", "inputs", "mailbox-size", "vendor", "eight-byte-sii", "object",
                                            "clock", "drift", "sync-missed"})
                if (values.count(other) != 0 && !values[other].defaulted())
                    throw example::usage_error{std::string{"--esi and --"} + other + " exclude each other"};
            read_devices(values, devices);
        } else if (values.count("device") + values.count("revision") != 0) {
            throw example::usage_error{"--device and --revision choose a device of --esi"};
        }
        const auto bits = values["clock"].as<unsigned>();
        if (bits != 0 && bits != 32 && bits != 64) throw example::usage_error{"--clock must be 0, 32 or 64"};
        const auto clock = bits == 0    ? ethercat::clock_width::no_clock
                           : bits == 32 ? ethercat::clock_width::bits_32
                                        : ethercat::clock_width::bits_64;
        const auto drift = static_cast<std::int32_t>(within("drift", values["drift"].as<unsigned>(), 0, 1000)) * 1000;
        const std::chrono::nanoseconds cable{within("cable", values["cable"].as<unsigned>(), 0, 100'000)};
        std::deque<node> nodes;
        const auto count = within("slaves", values["slaves"].as<std::size_t>(), 1, 100);
        for (std::size_t i = 1; i <= count; ++i) {
            for (const auto& each : devices) nodes.emplace_back(nodes.size(), each, rules);
            if (!devices.empty()) continue;
            const ethercat::slave_description description{.vendor = number("vendor"),
                                                          .product = number("product"),
                                                          .serial = static_cast<std::uint32_t>(i),
                                                          .mailbox_out_size = mailbox,
                                                          .mailbox_in_size = mailbox,
                                                          .name = "JausCat emulated slave",
                                                          .eight_byte_sii_reads = values["eight-byte-sii"].as<bool>(),
                                                          .outputs = outputs.entries,
                                                          .inputs = inputs.entries,
                                                          .synchronization = clock != ethercat::clock_width::no_clock,
                                                          .clock = clock,
                                                          .sync_missed_limit =
                                                              values["sync-missed"].as<std::uint16_t>()};
            nodes.emplace_back(i - 1, description, rules, objects);
            // Up to the drift, evenly: the first is slow by all of it, the last fast.
            const auto step = static_cast<std::int64_t>(i - 1) * 2 * drift / static_cast<std::int64_t>(count);
            nodes.back().slave().set_clock_error(
                {.drift = static_cast<std::int32_t>(step - drift), .start = i * 1'000'000'007, .step = 10});
        }
        const bool has_clocks =
            clock != ethercat::clock_width::no_clock || std::ranges::any_of(devices, [](const auto& each) {
                return each.description().clock != ethercat::clock_width::no_clock;
            });
        std::optional<emergency_commands> commands;
        if (values["commands"].as<bool>()) commands.emplace(nodes);
        return example::with_link(values, example::link_end::slave, [&](auto& link, const std::string& where) {
            return serve(link, where, nodes, cable, has_clocks, commands ? &*commands : nullptr);
        });
    });
}
