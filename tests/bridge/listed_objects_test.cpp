// A slave's dictionary made of an object list: what it lets through to the application, and what it aborts.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/translate/fixed_length.hpp>

#include <array>
#include <vector>

using namespace jauscat;
using ethercat::abort_code;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::to_hex;

namespace {

/// Records its accesses, and returns the configured data.
struct application {
    std::vector<std::byte> held{};
    std::size_t reads{}, writes{};

    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte> out) noexcept {
        ++reads;
        if (held.size() > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::copy(held, out.begin());
        return {.size = held.size()};
    }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte> data) noexcept {
        ++writes;
        held.assign(data.begin(), data.end());
        return abort_code::none;
    }
};

template <class Table>
constexpr std::array arm_objects{
    bridging::object_list<Table, 33, jaus::set_wrench_effort, jaus::report_wrench_effort>::description,
    bridging::object_list<Table, 255, jaus::set_wrench_effort>::description};
using fixed_table =
    translate::fixed_length<translation::seed_table, jaus::set_wrench_effort, jaus::report_wrench_effort>;

template <class Table = translation::seed_table> struct dictionary {
    application behind{};
    bridging::listed_objects objects;

    explicit dictionary(bridging::size_rule sizes = bridging::size_rule::up_to_largest)
        : objects{arm_objects<Table>, behind, sizes} {}

    abort_code write(std::uint16_t index, std::uint8_t subindex, std::size_t size) {
        return objects.write(index, subindex, std::vector<std::byte>(size));
    }
    abort_code read(std::uint16_t index, std::uint8_t subindex, std::size_t held) {
        behind.held.resize(held);
        std::array<std::byte, 100> out{};
        const auto got = objects.read(index, subindex, out);
        if (got.error == abort_code::none) CHECK(got.size == held);
        return got.error;
    }
};

} // namespace

TEST_CASE("objects and subobjects that are not listed are aborted before the application sees them") {
    dictionary<> d;
    CHECK(d.write(6934, 26, 28) == abort_code::no_object);
    CHECK(d.write(6933, 27, 28) == abort_code::no_subindex);
    CHECK(d.write(7155, 121, 28) == abort_code::no_subindex);
    CHECK(d.read(6900, 121, 1) == abort_code::no_object);
    CHECK(d.read(6933, 122, 1) == abort_code::no_subindex);
    CHECK(d.behind.writes == 0);
    CHECK(d.behind.reads == 0);
    CHECK(d.write(6933, 26, 28) == abort_code::none);
    CHECK(d.write(7155, 26, 28) == abort_code::none);
    CHECK(d.behind.writes == 2);
}

TEST_CASE("the listed objects follow each other by their indices") {
    const dictionary<> d;
    CHECK(d.objects.next_index(0) == 6933);
    CHECK(d.objects.next_index(6933) == 7155);
    CHECK(d.objects.next_index(7155) == 0); // none
}

TEST_CASE("command objects are write-only, report objects readable and writable") {
    dictionary<> d;
    CHECK(d.read(6933, 26, 10) == abort_code::write_only);
    CHECK(d.behind.reads == 0);
    CHECK(d.read(6933, 121, 10) == abort_code::none);
    CHECK(d.write(6933, 121, 10) == abort_code::none);

    constexpr bridging::sub_object read_only[]{{.subindex = 1, .max_size = 4, .readable = true}};
    const bridging::object_description object{.index = 0x2000, .entries = read_only};
    application behind;
    bridging::listed_objects objects{{&object, 1}, behind};
    CHECK(objects.write(0x2000, 1, from_hex("00")) == abort_code::read_only);
    CHECK(behind.writes == 0);
}

TEST_CASE("subindex 0 holds the highest subindex and is read-only") {
    dictionary<> d;
    std::array<std::byte, 4> out{};
    const auto got = d.objects.read(6933, 0, out);
    CHECK(got.error == abort_code::none);
    CHECK(got.size == 1);
    CHECK(out[0] == std::byte{121});
    CHECK(d.objects.read(7155, 0, out).size == 1);
    CHECK(out[0] == std::byte{26});
    CHECK(d.objects.read(6933, 0, std::span{out}.first(0)).error == abort_code::exceeds_mailbox);
    CHECK(d.write(6933, 0, 1) == abort_code::read_only);
    CHECK(d.behind.reads + d.behind.writes == 0);
}

TEST_CASE("a message may be shorter, but not longer, than the largest") {
    dictionary<> d;
    CHECK(d.write(6933, 26, 28) == abort_code::none);
    CHECK(d.write(6933, 26, 10) == abort_code::none);
    CHECK(d.write(6933, 26, 29) == abort_code::length_too_high);
    CHECK(d.read(6933, 121, 28) == abort_code::none);
    CHECK(d.read(6933, 121, 10) == abort_code::none);
    CHECK(d.read(6933, 121, 29) == abort_code::length_mismatch);
    CHECK(d.behind.writes == 2);
}

TEST_CASE("a strict slave reads and writes exact sizes only") {
    dictionary<> d{bridging::size_rule::exact};
    CHECK(d.write(6933, 26, 28) == abort_code::none);
    for (const std::size_t size : {0u, 10u, 27u, 29u, 30u})
        CHECK(d.write(6933, 26, size) == abort_code::length_mismatch);
    CHECK(d.read(6933, 121, 28) == abort_code::none);
    for (const std::size_t size : {0u, 10u, 27u, 29u}) CHECK(d.read(6933, 121, size) == abort_code::length_mismatch);
    CHECK(d.behind.writes == 1);
}

TEST_CASE("objects of a table with fixed lengths have exact sizes, whether the slave is strict or not") {
    for (const auto rule : {bridging::size_rule::up_to_largest, bridging::size_rule::exact}) {
        dictionary<fixed_table> d{rule};
        CHECK(d.write(6933, 26, 30) == abort_code::none);
        CHECK(d.write(6933, 26, 28) == abort_code::length_mismatch);
        CHECK(d.read(6933, 121, 30) == abort_code::none);
        CHECK(d.read(6933, 121, 28) == abort_code::length_mismatch);
    }
}

namespace {

/// A message from a master to a strict slave over the wire, under `Table`.
template <class Table> struct strict_robot {
    application behind{};
    bridging::listed_objects objects{arm_objects<Table>, behind, bridging::size_rule::exact};
    std::array<ethercat::slave, 1> devices{ethercat::slave{{.vendor = 1}, objects}};
    jauscat::test::simulated_link link{devices};
    ethercat::master_for<16> master{};

    using delivery = bridging::delivery<Table>;

    void bring_up() { REQUIRE(link.run(master, ethercat::bring_up{0, 2})); }
    ethercat::master_result<> deliver(std::span<const std::byte> message) {
        bring_up();
        std::array<std::byte, delivery::translator::max_packet_size> packet{};
        const auto translated = delivery::translator::to_packet(message, packet);
        REQUIRE(translated);
        const auto object = delivery::object_of(*translated);
        return link.run(master, ethercat::download{object.station, object.index, object.subindex, object.data});
    }
    /// The message that an upload of the report's object gives.
    std::vector<std::byte> fetch() {
        bring_up();
        std::array<std::byte, 100> data{};
        const auto got = link.run(master, ethercat::upload{2, 6933, 121, data});
        REQUIRE(got);
        std::vector<std::byte> message(delivery::translator::max_message_size);
        const auto restored =
            delivery::message_of({2, 6933, 121, *got}, {.subsystem = 1, .station = 2, .instance = 5}, message);
        message.resize(restored->size());
        return message;
    }
};

const auto one_effort = from_hex("0602 0504 05210201 02200304 0400 2200 0100 ff7f");

} // namespace

TEST_CASE("a strict slave aborts a shorter message, and the reason names the option to use") {
    strict_robot<translation::seed_table> robot;
    const auto result = robot.deliver(one_effort);
    CHECK(result.error().code == ethercat::master_errc::sdo_abort);
    CHECK(static_cast<std::uint32_t>(result.error().abort) == 0x06070010);
    CHECK(describe_reason(result.error()).find("fixed_length") != std::string_view::npos);
    CHECK(robot.behind.writes == 0);
}

TEST_CASE("a strict slave accepts a shorter message under a table with fixed lengths") {
    strict_robot<fixed_table> robot;
    CHECK(robot.deliver(one_effort));
    CHECK(to_hex(robot.behind.held) == hex_of("0c00 0602 02200304 2200 0100 ff7f"
                                              "0000000000000000 0000000000000000"));
}

TEST_CASE("a strict slave returns a shorter report under a table with fixed lengths") {
    strict_robot<fixed_table> robot;
    robot.behind.held = from_hex("0e00 0602 02200304 2200 0300 ff7f 0180"
                                 "0000000000000000 000000000000");
    CHECK(to_hex(robot.fetch()) == hex_of("0602 0544 05210201 02200304 0600 2200 0300 ff7f 0180"));
}
