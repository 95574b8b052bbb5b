// PDOs that a master maps and assigns: rules, sizes, values.
#include "ethercat/described_objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/assignable_pdos.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <array>
#include <string>
#include <vector>

using namespace jauscat;
using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::to_hex;

namespace {

constexpr std::array<pdo_entry, 1> gain{pdo_entry{0x2000, 0, 32, 7, "gain"}};
constexpr std::array<pdo_entry, 1> told{pdo_entry{0x2001, 0, 32, 7, "told"}};
constexpr slave_description plain{.vendor = 1, .product = 2, .outputs = gain, .inputs = told};

struct bench {
    test::described_objects own{};
    standard_objects standard{plain, own};
    assignable_pdos pdos{plain, standard};
    slave device{plain, pdos};
    std::array<slave_record, 1> records{};
    class master master{records};
    test::simulated_link link{[this](std::span<std::byte> frame) {
        device.process(frame);
        pdos.follow(device);
    }};

    bench() {
        REQUIRE(link.run(master, scan{}));
        REQUIRE(link.run(master, bring_up{.position = 0, .station = 7}));
    }
    abort_code write(std::uint16_t index, std::uint8_t subindex, std::string_view hex) {
        const auto data = from_hex(hex);
        const auto done = link.run(master, download{7, index, subindex, data});
        return done ? abort_code::none : done.error().abort;
    }
    std::string read(std::uint16_t index, std::uint8_t subindex) {
        std::array<std::byte, 16> into{};
        const auto got = link.run(master, upload{7, index, subindex, into});
        return got ? to_hex(*got) : std::string{};
    }
    /// Maps the entries into the PDO.
    void map(std::uint16_t index, const std::vector<std::string_view>& entries) {
        REQUIRE(write(index, 0, "00") == abort_code::none);
        std::uint8_t count = 0;
        for (const auto each : entries) REQUIRE(write(index, ++count, each) == abort_code::none);
        REQUIRE(write(index, 0, to_hex(std::array{std::byte{count}})) == abort_code::none);
    }
};

} // namespace

TEST_CASE("a master that maps nothing finds the PDOs of the description") {
    bench b;
    CHECK(b.read(0x1C12, 0) == "01");
    CHECK(b.read(0x1C12, 1) == "00 16");
    CHECK(b.read(0x1600, 0) == "01");
    CHECK(b.read(0x1600, 1) == "20 00 00 20");
    CHECK(b.read(0x1A00, 1) == "20 00 01 20");
    CHECK(b.read(0x1603, 0) == "00"); // empty
    CHECK(b.read(0x1604, 0).empty());
    CHECK(b.read(0x1008, 0) == to_hex(std::as_bytes(std::span{plain.name})));
    REQUIRE(b.link.run(b.master, configure{7}));
    REQUIRE(b.link.run(b.master, change_state{7, al_state::op}));
    CHECK(b.device.outputs().size() == 4);
}

TEST_CASE("mapping and assignment are written in PRE-OP, subindex 0 as 0 first, with what can be mapped") {
    bench b;
    CHECK(b.write(0x1600, 1, "20000020") == abort_code::subindex_0_not_zero);
    CHECK(b.write(0x1600, 0, "00") == abort_code::none);
    CHECK(b.write(0x1600, 1, "2000") == abort_code::length_mismatch);
    CHECK(b.write(0x1600, 0, "0000") == abort_code::length_mismatch);
    CHECK(b.write(0x1600, 65, "20000020") == abort_code::no_subindex);
    CHECK(b.write(0x1600, 0, "41") == abort_code::value_too_high);
    for (const auto* const entry : {"20000120",    // an input
                                    "10000020",    // not its size
                                    "20000040",    // no object
                                    "00000000",    // a gap of nothing
                                    "20000220"}) { // none to be mapped
        CHECK(b.write(0x1600, 1, entry) == abort_code::none);
        CHECK(b.write(0x1600, 0, "01") == abort_code::not_mappable);
        CHECK(b.read(0x1600, 0) == "00");
    }
    b.map(0x1600, {"04000000", "20000020", "04000000"}); // gaps before and behind
    CHECK(b.write(0x1C12, 1, "0116") == abort_code::subindex_0_not_zero);
    CHECK(b.write(0x1C12, 0, "00") == abort_code::none);
    CHECK(b.write(0x1C12, 1, "001a") == abort_code::not_mappable); // of the other direction
    CHECK(b.write(0x1C12, 1, "0017") == abort_code::not_mappable);
    CHECK(b.write(0x1C12, 0, "11") == abort_code::value_too_high);
    CHECK(b.write(0x1C12, 1, "0016") == abort_code::none);
    CHECK(b.write(0x1C12, 0, "01") == abort_code::none);
    REQUIRE(b.link.run(b.master, configure{7}));
    REQUIRE(b.link.run(b.master, change_state{7, al_state::safe_op}));
    CHECK(b.write(0x1600, 0, "00") == abort_code::device_state);
    CHECK(b.write(0x2002, 0, "01020304") == abort_code::none); // not one of the PDOs
    REQUIRE(b.link.run(b.master, change_state{7, al_state::op}));
    REQUIRE(b.device.outputs().size() == 5);
    b.pdos.take(from_hex("4433221100"));
    CHECK(to_hex(b.own.values[{0x2000, 0}]) == "34 23 12 01");
    b.own.values[{0x2001, 0}] = from_hex("01020304");
    b.pdos.give(b.device.inputs());
    CHECK(to_hex(b.device.inputs()) == "01 02 03 04");
}

TEST_CASE("more process data than a slave's memory has are refused, and directions may be empty") {
    bench b;
    const std::vector<std::string_view> most(64, "20000020");
    for (const auto index : std::array<std::uint16_t, 3>{0x1600, 0x1601, 0x1602}) b.map(index, most);
    CHECK(b.write(0x1C12, 0, "00") == abort_code::none);
    CHECK(b.write(0x1C12, 1, "0016") == abort_code::none);
    CHECK(b.write(0x1C12, 2, "0116") == abort_code::none);
    CHECK(b.write(0x1C12, 3, "0216") == abort_code::none);
    CHECK(b.write(0x1C12, 0, "03") == abort_code::pdo_length); // 768 bytes
    CHECK(b.write(0x1C12, 0, "02") == abort_code::none);
    REQUIRE(b.link.run(b.master, configure{7}));
    REQUIRE(b.link.run(b.master, change_state{7, al_state::safe_op}));
    CHECK(b.device.outputs().size() == 512);
    REQUIRE(b.link.run(b.master, change_state{7, al_state::pre_op}));
    CHECK(b.write(0x1C12, 0, "00") == abort_code::none);
    REQUIRE(b.link.run(b.master, configure{7}));
    REQUIRE(b.link.run(b.master, change_state{7, al_state::op}));
    CHECK(b.device.outputs().empty());
    CHECK(b.device.inputs().size() == 4);
}

TEST_CASE("a tool lists mapping objects with the others, and learns that they can be written") {
    bench b;
    std::vector<std::uint16_t> all;
    for (std::uint16_t next = 0; (next = b.pdos.next_index(next)) != 0;) all.push_back(next);
    CHECK(std::ranges::is_sorted(all));
    for (const auto index : std::array<std::uint16_t, 7>{0x1018, 0x1600, 0x1601, 0x1A03, 0x1C12, 0x1C13, 0x2000})
        CHECK(std::ranges::count(all, index) == 1);
    REQUIRE(b.pdos.describe(0x1600));
    CHECK(b.pdos.describe(0x1600)->highest_subindex == 1);
    CHECK(b.pdos.describe(0x1601)->highest_subindex == 0);
    CHECK(b.pdos.describe(0x1C12)->code == object_code::array);
    for (const auto subindex : std::array<std::uint8_t, 3>{0, 1, 64})
        CHECK(b.pdos.describe(0x1600, subindex)->access.write_pre_op);
    CHECK_FALSE(b.pdos.describe(0x1600, 65));
    CHECK_FALSE(b.pdos.describe(0x1C12, 17));
    CHECK(b.pdos.describe(0x2000, 0)->access.rx_pdo);
}

TEST_CASE("an emulated drive takes the mapping that it has at first, written once more") {
    static constexpr auto description = cia402::drive_description<>;
    cia402::emulated_drive<> drive;
    standard_objects standard{description, drive};
    assignable_pdos pdos{description, standard};
    for (const auto index : std::array<std::uint16_t, 2>{0x1600, 0x1A00}) {
        std::array<std::byte, 1> count{};
        REQUIRE(pdos.read(index, 0, count).size == 1);
        CHECK(pdos.write(index, 0, std::array{std::byte{}}) == abort_code::none);
        CHECK(pdos.write(index, 0, count) == abort_code::none);
    }
}
