// A slave rebuilt from an ESI file alone behaves as the one that was described: its SII byte for byte, and its answers
// to the master for objects and subindices that are there and that are not.
#include "esi/machine.hpp"
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/translate/fixed_length.hpp>

#include <map>

using namespace jauscat;
using namespace jauscat::ethercat;
using test::machine;
using test::sample_components;
using test::sample_slave;

namespace {

/// Sends the same requests to both machines; true if the answers are equal.
template <class Table> void compare_machines(std::size_t transfer_size, const slave_description& slave = sample_slave) {
    const auto xml = esi::write_esi(test::sample_device<Table>(slave, transfer_size != 0));
    const esi::emulated_device device{*esi::parse_esi(xml, "sample.xml")};
    CHECK(device.transfer_size() == transfer_size);
    machine original{slave, sample_components<Table>, transfer_size};
    machine rebuilt{device.description(), device.components(), device.transfer_size()};

    CHECK(original.read_sii() == rebuilt.read_sii());

    std::size_t there = 0;
    for (std::uint32_t i = 0; i != 0x10000; ++i) {
        const auto index = static_cast<std::uint16_t>(i);
        const auto one = original.upload(index, 0);
        if (one != rebuilt.upload(index, 0)) FAIL("object " << std::hex << index << " answers differently");
        if (one.error.abort != abort_code::no_object) ++there;
    }
    CHECK(there == 6);

    std::map<std::uint32_t, std::size_t> seen; // number of each abort code, 0 for success
    const auto same = [&](const machine::answer& one, const machine::answer& other, unsigned index, unsigned sub) {
        if (one != other) FAIL("subindex " << std::hex << index << ':' << sub << " answers differently");
        ++seen[static_cast<std::uint32_t>(one.error.abort)];
    };
    const auto own = sample_components<Table>[0].index, every = sample_components<Table>[1].index;
    for (const std::uint16_t index : {std::uint16_t{0x1000}, std::uint16_t{0x1008}, std::uint16_t{0x1018},
                                      std::uint16_t{0x1C00}, own, every, std::uint16_t{0x2000}}) {
        for (unsigned sub = 0; sub != 256; ++sub) {
            const auto subindex = static_cast<std::uint8_t>(sub);
            same(original.upload(index, subindex), rebuilt.upload(index, subindex), index, sub);
            for (const auto size : {0u, 1u, 4u, 5u, 10u, 11u, 12u, 13u, 27u, 28u, 29u, 30u, 31u, 252u, 1600u}) {
                same(original.download(index, subindex, size), rebuilt.download(index, subindex, size), index, sub);
                same(original.upload(index, subindex), rebuilt.upload(index, subindex), index, sub);
            }
        }
    }
    // The comparison has seen every kind of answer that the objects have.
    for (const auto code :
         {abort_code::none, abort_code::no_object, abort_code::no_subindex, abort_code::read_only,
          abort_code::write_only, abort_code::no_data,
          translate::has_fixed_length<Table> ? abort_code::length_mismatch : abort_code::length_too_high}) {
        INFO(std::hex << static_cast<std::uint32_t>(code));
        CHECK(seen[static_cast<std::uint32_t>(code)] > 0);
    }
}

using fixed_table =
    translate::fixed_length<translation::seed_table, jaus::query_wrench_effort, jaus::report_wrench_effort,
                            jaus::set_wrench_effort, jaus::set_travel_speed>;

} // namespace

TEST_CASE("a slave rebuilt from its ESI file answers like the original") {
    compare_machines<translation::seed_table>(28);
}

TEST_CASE("a slave of exact sizes rebuilt from its ESI file answers like the original") {
    compare_machines<fixed_table>(30);
}

TEST_CASE(
    "a slave whose objects need segments, or exceed its memory, rebuilt from its ESI file answers like the original") {
    auto small = sample_slave;
    small.mailbox_out_size = 32; // for 16 bytes of an object
    small.mailbox_in_offset = 0x1400;
    small.mailbox_in_size = 40;
    compare_machines<translation::seed_table>(28, small);
    compare_machines<translation::seed_table>(0, small);
}

TEST_CASE("a slave with process data is rebuilt from its file with its PDOs and mapped objects") {
    static constexpr std::array outputs{pdo_entry{0x7000, 1, 16, data_types::unsigned16, "left"},
                                        pdo_entry{0x7000, 2, 1, data_types::boolean, "on"}, pdo_entry{.bits = 5},
                                        pdo_entry{0x7000, 3, 2, data_types::bit1 + 1, "mode"},
                                        pdo_entry{0x7010, 0, 8, data_types::unsigned8, "level"}};
    static constexpr std::array inputs{pdo_entry{0x6000, 1, 32, data_types::integer32, "place"}};
    auto slave = sample_slave;
    slave.outputs = outputs;
    for (const bool has_inputs : {true, false}) {
        if (has_inputs)
            slave.inputs = inputs;
        else
            slave.inputs = {};
        slave.error_register = slave.synchronization = has_inputs;
        slave.hardware_version = has_inputs ? "A" : "";
        slave.software_version = "1.2";
        const auto described = test::sample_device<>(slave);
        const auto xml = esi::write_esi(described);
        CHECK(esi::parse_esi(xml, "sample.xml") == described);
        const auto findings = esi::check_esi_text(xml, "sample.xml");
        REQUIRE(findings);
        for (const auto& each : *findings) {
            INFO(each.what << ": " << each.problem);
            CHECK(each.met());
        }
        const esi::emulated_device device{*esi::parse_esi(xml, "sample.xml")};
        machine original{slave, sample_components<translation::seed_table>, 28};
        machine rebuilt{device.description(), device.components(), 28};
        const auto size = make_sii_image(slave).size();
        CHECK(original.read_sii(size) == rebuilt.read_sii(size));
        std::size_t there = 0;
        for (std::uint32_t index = 0x1000; index != 0x8000; ++index)
            for (const auto subindex : std::to_array<std::uint8_t>({0, 1, 2, 3, 4, 6, 7})) {
                const auto one = original.upload(static_cast<std::uint16_t>(index), subindex);
                if (one != rebuilt.upload(static_cast<std::uint16_t>(index), subindex))
                    FAIL(std::hex << index << ':' << int{subindex} << " answers differently");
                there += one.error == master_error{} && subindex == 0 ? 1 : 0;
            }
        // 1000h, 1008h, 100Ah, 1018h, 1600h, 1C00h, 1C12h, 1C13h, 7000h, 7010h, two components; and 1001h, 1009h,
        // 1A00h, 1C32h, 1C33h, 6000h.
        CHECK(there == (has_inputs ? 18 : 12));
    }
}

TEST_CASE("the standard objects of a rebuilt slave have the values of its SII") {
    const esi::emulated_device device{*esi::parse_esi(test::sample_esi(), "sample.xml")};
    machine rebuilt{device.description(), device.components(), device.transfer_size()};
    const auto hex = [&](std::uint16_t index, std::uint8_t subindex) {
        return test::to_hex(rebuilt.upload(index, subindex).data);
    };
    CHECK(hex(0x1000, 0) == "00 00 00 00");
    CHECK(hex(0x1008, 0) == "61 72 6d 20 3c 31 3e");
    CHECK(hex(0x1018, 0) == "04");
    CHECK(hex(0x1018, 1) == "a5 06 00 00");
    CHECK(hex(0x1018, 2) == "21 00 00 00");
    CHECK(hex(0x1018, 3) == "02 00 01 00");
    CHECK(hex(0x1018, 4) == "00 00 00 00");
    CHECK(hex(0x1C00, 0) == "02");
    CHECK(hex(0x1C00, 1) == "01");
    CHECK(hex(0x1C00, 2) == "02");
    CHECK(hex(0x1B15, 0) == "79"); // the highest rank, 121: Report Wrench Effort
    const auto sii = rebuilt.read_sii();
    CHECK(test::to_hex(std::span{sii}.first(32)) == "80 00 00 00 00 00 00 00 34 12 00 00 00 00 " +
                                                        test::to_hex(std::span{sii}.subspan(14, 1)) +
                                                        " 00 a5 06 00 00 21 00 00 00 02 00 01 00 00 00 00 00");
    CHECK(sii_checksum(std::span{sii}.first(14)) == std::to_integer<std::uint8_t>(sii[14]));
}

TEST_CASE("rebuilt objects have sizes, access and command codes") {
    const esi::emulated_device device{*esi::parse_esi(test::sample_esi<fixed_table>(), "sample.xml")};
    REQUIRE(device.components().size() == 2);
    const auto& own = device.components()[0];
    CHECK(own.index == 0x1B15);
    CHECK(own.component == 33);
    CHECK(own.name == "component 33");
    CHECK(own.exact_size);
    REQUIRE(own.entries.size() == 3);
    CHECK(own.entries[0] == bridging::sub_object{26, 0x0405, "set_wrench_effort", 30, false, true});
    CHECK(own.entries[1] == bridging::sub_object{72, 0x2405, "query_wrench_effort", 12, false, true});
    CHECK(own.entries[2] == bridging::sub_object{121, 0x4405, "report_wrench_effort", 30, true, true});
    CHECK(device.components()[1].index == 0x1BF3);
}

TEST_CASE("features that an emulated slave lacks are refused by name") {
    const auto complaint = [](auto change, esi::errc code = esi::errc::cannot_be_emulated) -> std::string {
        auto device = test::sample_device();
        change(device);
        try {
            const esi::emulated_device made{device};
            return "accepted";
        } catch (const esi::esi_error& error) {
            CHECK(error.code() == code);
            CHECK(!error.error().element.empty());
            return error.what();
        }
    };
    CHECK(complaint([](esi::device&) {}) == "accepted");
    const auto order = "\"arm <1>\": <Sm>: expected MBoxOut first, then MBoxIn, and no other";
    CHECK(complaint([](esi::device& d) { std::swap(d.sync_managers[0], d.sync_managers[1]); }) == order);
    CHECK(complaint([](esi::device& d) { d.sync_managers.push_back(d.sync_managers[0]); }) == order);
    CHECK(complaint([](esi::device& d) { d.sync_managers.clear(); }) == order);
    CHECK(complaint([](esi::device& d) { d.sync_managers[1].default_size = 23; }) ==
          "\"arm <1>\": <Sm>: expected a mailbox of 24 to 1486 bytes");
    CHECK(complaint([](esi::device& d) { d.sync_managers[1].start = 0x3000; }) ==
          "\"arm <1>\": <Sm>: SyncManager 1 is outside of the memory, 1000h to 2FFFh");
    const auto add_area = [](esi::device& d, std::uint16_t size) {
        d.sync_managers.push_back(
            {.use = ethercat::sii_sync_manager_use::outputs, .start = 0x1800, .default_size = size, .control = 0x64});
    };
    CHECK(complaint([&](esi::device& d) {
              for (int i = 0; i != 7; ++i) add_area(d, 1);
          }) == "\"arm <1>\": <Sm>: expected at most 8 SyncManagers");
    CHECK(complaint([&](esi::device& d) { add_area(d, 700); }) ==
          "\"arm <1>\": <Sm>: expected at most 682 bytes of outputs and 1024 of inputs");
    CHECK(complaint([](esi::device& d) {
              d.rx_pdos.push_back({.index = 0x1600, .sync_manager = esi::not_assigned, .entries = {{.bits = 256}}});
          }) == "\"arm <1>\": <RxPdo>: #x1600 has an entry of 256 bits, expected at most 255");
    CHECK(complaint([&](esi::device& d) {
              add_area(d, 1);
              d.sync_managers.back().control = 0x26;
          }) == "\"arm <1>\": <Sm>: SyncManager 2 has process data in one buffer (ControlByte #x26), expected three");
    CHECK(complaint([](esi::device& d) { d.eeprom.image.resize(127); }) ==
          "\"arm <1>\": <Data>: expected 128 bytes of SII or more");
    CHECK(complaint([](esi::device& d) { d.objects[4].properties[0].value = "256"; }, esi::errc::invalid_value) ==
          "\"arm <1>\": <Object>: #x1B15: its property JausComponent is no component ID");
    CHECK(complaint([](esi::device& d) { d.objects[4].entries[1].properties.clear(); }, esi::errc::missing) ==
          "\"arm <1>\": <Object>: #x1B15: subindex 26 has no property JausCommandCode with a command code");
}
