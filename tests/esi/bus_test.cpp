// A slave rebuilt from an ESI file alone, on a bus: in each state its registers equal those of the original, and so do
// its SII, its objects with their descriptions, and its process data.
#include "esi/machine.hpp"
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/read_esi.hpp>

#include <optional>
#include <string>

using namespace jauscat;
using namespace jauscat::ethercat;
using test::machine;
using bytes = machine::bytes;

namespace {

constexpr std::array level{pdo_entry{0x7000, 1, 16, data_types::unsigned16, "level"}};
constexpr std::array place{pdo_entry{0x6000, 1, 32, data_types::integer32, "place"},
                           pdo_entry{0x6000, 2, 8, data_types::unsigned8, "state"}};
// Three PDOs out and two in, with bits and a gap.
constexpr std::array several_outputs{pdo_entry{0x7000, 1, 16, data_types::unsigned16, "speed"},
                                     pdo_entry{0x7000, 2, 1, data_types::boolean, "on"}, pdo_entry{.bits = 7},
                                     pdo_entry{0x7010, 0, 8, data_types::unsigned8, "mode"},
                                     pdo_entry{0x7020, 1, 32, data_types::integer32, "target"}};
constexpr std::array several_output_parts{pdo_part{0x1601, 3, "Speed"}, pdo_part{0x1610, 1, "Mode"},
                                          pdo_part{0x1605, 1, "Target"}};
constexpr std::array several_inputs{pdo_entry{0x6000, 1, 32, data_types::integer32, "place"},
                                    pdo_entry{0x6010, 1, 1, data_types::boolean, "moves"},
                                    pdo_entry{0x6010, 2, 2, data_types::bit1 + 1, "kind"}};
constexpr std::array several_input_parts{pdo_part{0x1A00, 1, "Place"}, pdo_part{0x1A02, 2, "State"}};

slave_description with_pdos(std::span<const pdo_entry> outputs, std::span<const pdo_entry> inputs) {
    auto slave = test::sample_slave;
    slave.outputs = outputs;
    slave.inputs = inputs;
    return slave;
}

/// Both slaves, and the description from the file that the second one is made of.
struct pair_of_machines {
    esi::emulated_device file;
    machine original;
    machine rebuilt;

    pair_of_machines(const slave_description& slave, std::span<const bridging::object_description> components,
                     const std::string& xml)
        : file{*esi::parse_esi(xml, "sample.xml")},
          original{slave, components, bridging::largest_subobject(components)},
          rebuilt{file.description(), file.components(), file.transfer_size()} {}

    /// The result of the same call of both, which is equal.
    auto both(auto&& call) {
        auto result = call(original);
        CHECK(result == call(rebuilt));
        return result;
    }
    template <master_job Job> void run(const Job& job) {
        CHECK(both([&](machine& each) { return each.run(job).error(); }) == master_error{});
    }
    /// Identity, states, SII, FMMUs, SyncManagers and watchdogs; not the clock, which runs.
    void compare_registers() {
        const auto registers = both([](machine& each) { return each.read(0x0000, 0x0900 / 2); });
        const auto rest = both([](machine& each) { return each.read(0x0900 / 2, 0x0900 / 2); });
        CHECK(registers != rest);
    }

    /// Returns how many objects there are.
    std::size_t compare_objects() {
        for (unsigned list = 0; list <= 5; ++list)
            both([&](machine& each) {
                bytes room(1000);
                const auto found = each.run(list_objects{machine::station, static_cast<object_list_type>(list), room});
                REQUIRE(found);
                return bytes{found->bytes().begin(), found->bytes().end()};
            });
        bytes room(1000);
        const auto all = original.run(list_objects{.station = machine::station, .into = room});
        REQUIRE(all);
        for (const auto index : *all) {
            CAPTURE(index);
            both([&](machine& each) {
                bytes into(1000);
                const auto found = each.run(describe_object{machine::station, index, into});
                REQUIRE(found);
                return bytes{found->bytes.begin(), found->bytes.end()};
            });
            for (unsigned i = 0; i != 256; ++i) {
                const auto subindex = static_cast<std::uint8_t>(i);
                both([&](machine& each) {
                    bytes into(1000);
                    const auto found = each.run(describe_entry{machine::station, index, subindex, 0x7F, into});
                    const auto answer = found ? found->bytes : std::span<const std::byte>{};
                    return std::pair{found.error(), bytes{answer.begin(), answer.end()}};
                });
                both([&](machine& each) { return each.upload(index, subindex); });
            }
        }
        return all->size();
    }
};

/// Takes both through all states; returns the number of objects.
std::size_t compare_on_bus(const slave_description& slave) {
    const auto components =
        slave.has_mailbox()
            ? std::span<const bridging::object_description>{test::sample_components<translation::seed_table>}
            : std::span<const bridging::object_description>{};
    const auto described = esi::make_device(slave, test::sample_texts, components, slave.has_mailbox());
    const auto xml = esi::write_esi(described);
    CHECK(esi::parse_esi(xml, "sample.xml") == described);
    const auto findings = esi::check_esi_text(xml, "sample.xml");
    REQUIRE(findings);
    for (const auto& each : *findings) {
        INFO(each.what << ": " << each.problem);
        CHECK(each.met());
    }

    pair_of_machines pair{slave, components, xml};
    const auto sii = pair.file.sii();
    CHECK(pair.both([&](machine& each) { return each.read_sii(sii.size()); }) == bytes{sii.begin(), sii.end()});
    pair.compare_registers();
    pair.run(configure{machine::station});
    pair.compare_registers();
    pair.run(change_state{machine::station, al_state::safe_op});
    pair.compare_registers();
    auto one = pair.original.cyclic(), other = pair.rebuilt.cyclic();
    const auto exchange = [&](std::uint8_t first, bool in_op) {
        if (!slave.has_process_data()) return;
        bytes outputs(slave.output_size()), inputs(slave.input_size());
        for (auto& each : outputs) each = static_cast<std::byte>(first++);
        for (auto& each : inputs) each = static_cast<std::byte>(first++);
        for (auto* const each : {&pair.original, &pair.rebuilt}) {
            std::ranges::copy(inputs, each->slave().inputs().begin());
            CHECK(each->exchange(each == &pair.original ? one : other, outputs) == inputs);
            const auto in_force = each->slave().outputs();
            CHECK((!in_op || std::ranges::equal(in_force, outputs)));
        }
    };
    exchange(1, false);
    pair.run(change_state{machine::station, al_state::op});
    for (std::uint8_t i = 0; i != 20; ++i) exchange(i, true);
    pair.compare_registers();
    if (!slave.has_mailbox()) {
        CHECK(pair.both([](machine& each) { return each.upload(0x1000, 0); }).error.code == master_errc::no_mailbox);
        return 0;
    }
    return pair.compare_objects();
}

} // namespace

TEST_CASE("a slave rebuilt from its ESI file has the registers, objects and process data of the original") {
    // 1000h, 1008h, 1018h, 1C00h, two components; with process data 1600h, 1A00h, 1C12h, 1C13h, 6000h, 7000h.
    CHECK(compare_on_bus(test::sample_slave) == 6);
    CHECK(compare_on_bus(with_pdos(level, place)) == 12);
    CHECK(compare_on_bus(with_pdos(level, {})) == 10);
    CHECK(compare_on_bus(with_pdos({}, place)) == 10);
}

TEST_CASE("a slave with another mailbox is rebuilt from its ESI file") {
    for (const auto& [out, in] : {std::pair{24, 24}, {34, 128}, {1486, 1486}}) {
        auto slave = with_pdos(level, place);
        slave.mailbox_out_offset = 0x1008;
        slave.mailbox_out_size = static_cast<std::uint16_t>(out);
        slave.mailbox_in_size = static_cast<std::uint16_t>(in);
        CAPTURE(out, in);
        CHECK(compare_on_bus(slave) == 12);
    }
}

TEST_CASE("a slave with several PDOs of a direction is rebuilt from its ESI file") {
    auto slave = with_pdos(several_outputs, several_inputs);
    slave.output_parts = several_output_parts;
    slave.input_parts = several_input_parts;
    // 1601h, 1605h, 1610h, 1A00h, 1A02h; 6000h, 6010h, 7000h, 7010h, 7020h.
    CHECK(compare_on_bus(slave) == 18);
    machine original{slave, {}, 0};
    const auto upload = [&](std::uint16_t index, std::uint8_t subindex) {
        return test::to_hex(original.upload(index, subindex).data);
    };
    CHECK(upload(0x1C12, 0) == "03");
    CHECK(upload(0x1C12, 1) == "01 16");
    CHECK(upload(0x1C12, 2) == "10 16");
    CHECK(upload(0x1C12, 3) == "05 16");
    CHECK(upload(0x1601, 0) == "03");
    CHECK(upload(0x1601, 3) == "07 00 00 00");
    CHECK(upload(0x1605, 1) == "20 01 20 70");
    CHECK(upload(0x1A02, 2) == "02 02 10 60");
}

TEST_CASE("a slave without a mailbox is rebuilt from its ESI file") {
    for (const auto& outputs : {std::span<const pdo_entry>{level}, std::span<const pdo_entry>{}}) {
        auto slave = with_pdos(outputs, place);
        slave.mailbox_out_size = slave.mailbox_in_size = 0;
        CHECK(compare_on_bus(slave) == 0);
    }
    auto slave = with_pdos(several_outputs, several_inputs);
    slave.mailbox_out_size = slave.mailbox_in_size = 0;
    slave.output_parts = several_output_parts;
    CHECK(compare_on_bus(slave) == 0);
}

TEST_CASE("the modes of a distributed clock are in the ESI file and in category 60 of the SII") {
    auto slave = with_pdos(level, place);
    slave.clock_modes = test::sample_clock_modes;
    slave.clock = clock_width::bits_64;
    CHECK(compare_on_bus(slave) == 12);
    const auto xml = esi::write_esi(esi::make_device(slave, test::sample_texts, {}, false));
    const auto has = [&](const char* part) { return xml.find(part) != xml.npos; };
    CHECK(has(R"(        <Dc>
          <OpMode>
            <Name>Free run</Name>
            <Desc>not synchronized</Desc>
            <AssignActivate>#x000</AssignActivate>
            <CycleTimeSync0 Factor="0">0</CycleTimeSync0>
            <ShiftTimeSync0>0</ShiftTimeSync0>
            <CycleTimeSync1 Factor="0">0</CycleTimeSync1>
            <ShiftTimeSync1>0</ShiftTimeSync1>
          </OpMode>
)"));
    CHECK(has(R"(            <AssignActivate>#x700</AssignActivate>
            <CycleTimeSync0 Factor="1">250000</CycleTimeSync0>
            <ShiftTimeSync0>-1000</ShiftTimeSync0>
            <CycleTimeSync1 Factor="-2">0</CycleTimeSync1>
            <ShiftTimeSync1>2000</ShiftTimeSync1>
)"));
    // 24 bytes a mode: cycle and shift of SYNC0, shift and factor of SYNC1, activation, factor of SYNC0, two strings
    // after those of the slave and its two PDOs.
    const auto sii = make_sii_image(slave);
    const auto wanted = test::from_hex("3c00 1800"
                                       "00000000 00000000 00000000 0000 0000 0000 04 05 00000000"
                                       "90d00300 18fcffff d0070000 feff 0007 0100 06 07 00000000"
                                       "ffff 0000");
    CHECK(std::search(sii.begin(), sii.end(), wanted.begin(), wanted.end()) != sii.end());
}
