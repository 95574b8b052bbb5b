// esi.md: the ESI file of a slave with messages and a table of one's own, and the slave that the file describes.
//     docs_device_file
// [includes]
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/write_esi.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

#include <array>
#include <exception>
#include <iostream>

namespace bridging = jauscat::bridging;
namespace esi = jauscat::esi;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace translation = jauscat::translation;
// [includes end]

/// Set Gripper, a message of one's own.
struct set_gripper {
    std::uint8_t finger{};
    std::uint8_t percent{};

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<field<&T::finger, u8>, field<&T::percent, u8>>;
    };
};

// [description]
// A table of one's own; two components, each with its messages.
inline constexpr auto command_codes = translation::ra_command_codes_and<jaus::command_code_of<set_gripper>>;
using gripper_table = translation::self_contained_table_of<translation::manufacturer_index_base, command_codes>::type;
constexpr std::array components{
    bridging::object_list<gripper_table, 33, set_gripper>::description,
    bridging::object_list<gripper_table, 34, jaus::query_wrench_effort, jaus::report_wrench_effort>::description};

// Process data: outputs in two PDOs, inputs in one, 1A00h.
constexpr std::array outputs{ethercat::pdo_entry{0x7000, 1, 16, ethercat::data_types::unsigned16, "position"},
                             ethercat::pdo_entry{0x7010, 1, 8, ethercat::data_types::unsigned8, "force"}};
constexpr std::array output_pdos{ethercat::pdo_part{0x1600, 1, "Position"}, ethercat::pdo_part{0x1601, 1, "Force"}};
constexpr std::array inputs{ethercat::pdo_entry{0x6000, 1, 16, ethercat::data_types::unsigned16, "position"}};

// The modes of the distributed clock; the first one is the default.
constexpr std::array clock_modes{ethercat::clock_mode{.name = "Free run"},
                                 ethercat::clock_mode{.name = "DC", .assign_activate = 0x300, .cycle_factor_0 = 1}};

constexpr ethercat::slave_description gripper{.vendor = 0x6A5,
                                              .product = 0x22,
                                              .name = "gripper",
                                              .outputs = outputs,
                                              .inputs = inputs,
                                              .output_parts = output_pdos,
                                              .clock_modes = clock_modes};
// [description end]

int main() try {
    // [write]
    const auto device = esi::make_device(
        gripper, {.vendor_name = "Makers", .group_type = "grippers", .group_name = "Grippers", .type = "G-2"},
        components, true);
    const std::string xml = esi::write_esi(device);
    // [write end]
    // [read]
    const auto read = esi::parse_esi(xml, "gripper.xml"); // or esi::read_esi("gripper.xml")
    if (!read) return std::cerr << describe(read.error()) << '\n', 1;
    const esi::emulated_device slave{*read};
    std::cout << slave.description().name << ": " << slave.sii().size() << " bytes of SII\n";
    for (const auto& object : slave.components())
        for (const auto& entry : object.entries)
            std::cout << esi::hex_number(object.index, 4) << ':' << int{entry.subindex} << "  " << entry.name
                      << ", up to " << entry.max_size << " bytes\n";
    // [read end]
} catch (const std::exception& problem) {
    return std::cerr << problem.what() << '\n', 1;
}
