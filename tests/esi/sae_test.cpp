// ESI files and objects of SAE messages.
#include "esi/machine.hpp"
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/bridge/sae_delivery.hpp>
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/schema/sae/core.hpp>
#include <jauscat/schema/sae/environment_sensing.hpp>
#include <jauscat/schema/sae/manipulator.hpp>
#include <jauscat/schema/sae/mobility.hpp>
#include <jauscat/schema/sae/ugv.hpp>
#include <jauscat/schema/translation/sae_table.hpp>

#include <algorithm>
#include <set>

using namespace jauscat;
using test::machine;
using bytes = machine::bytes;
using table = translation::sae_table;

namespace {

/// A component that accepts every message of the sets, and one with messages of one service.
using everything = bridging::object_lists<
    table, 33,
    jaus::joined_lists<sae::core::messages, sae::mobility::messages, sae::environment_sensing::messages,
                       sae::manipulator::messages, sae::ugv::messages>>;
using primitive_driver = bridging::object_list<table, 34, sae::mobility::set_wrench_effort,
                                               sae::mobility::query_wrench_effort, sae::mobility::report_wrench_effort>;

constexpr auto components = [] {
    std::array<bridging::object_description, everything::descriptions.size() + 1> all{};
    std::ranges::copy(everything::descriptions, all.begin());
    all.back() = primitive_driver::description;
    return all;
}();

constexpr std::uint16_t station = 2;

/// Restores the message of each object that is written.
struct restoring_application {
    bytes received{};

    static ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = ethercat::abort_code::no_data};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        using delivery = bridging::sae_delivery<table>;
        received.resize(delivery::translator::max_message_size);
        const auto restored = delivery::message_of({station, index, subindex, data}, received);
        received.resize(restored->size());
        return restored ? ethercat::abort_code::none : ethercat::abort_code::parameter_incompatible;
    }
};

} // namespace

TEST_CASE("a component has an object for each set of SAE messages that it accepts") {
    const auto& objects = everything::descriptions;
    REQUIRE(objects.size() == 5);
    const std::array<std::size_t, 5> sizes{54, 83, 59, 46, 34};
    for (std::size_t i = 0; i != objects.size(); ++i) {
        CHECK(objects[i].index == 0x2021 + 0x100 * i);
        CHECK(objects[i].component == 33);
        CHECK(objects[i].name == "component 33");
        CHECK(objects[i].entries.size() == sizes[i]);
        CHECK(objects[i].highest_subindex() == sizes[i]);
    }
    std::set<std::uint16_t> ids;
    for (const auto& entry : everything::entries) ids.insert(entry.command_code);
    const auto& ranked = translation::sae_segments::codes;
    CHECK(ids == std::set<std::uint16_t>(ranked.begin(), ranked.end()));
    // The ID is not in the data, the sequence number is: 1 byte of authority, 7 of header, 2 of sequence number.
    CHECK(*objects[0].find(1) == bridging::sub_object{1, 0x0001, "set_authority", 10, false, true});
    const auto& driver = primitive_driver::description;
    CHECK(driver.index == 0x2122);
    REQUIRE(driver.entries.size() == 3);
    CHECK(driver.entries[0].name == "set_wrench_effort");
    CHECK(driver.entries[2].readable);
    CHECK_FALSE(driver.entries[1].readable);
}

TEST_CASE("the ESI file of a slave with SAE messages is complete, and comes back as the same objects") {
    const auto described = esi::make_device(test::sample_slave, test::sample_texts, components, true);
    const auto xml = esi::write_esi(described);
    CHECK(esi::parse_esi(xml, "sae.xml") == described);
    const auto findings = esi::check_esi_text(xml, "sae.xml");
    REQUIRE(findings);
    for (const auto& each : *findings) {
        INFO(each.what << ": " << each.problem);
        CHECK(each.met());
    }
    const esi::emulated_device device{*esi::parse_esi(xml, "sae.xml")};
    REQUIRE(device.components().size() == components.size());
    for (std::size_t i = 0; i != components.size(); ++i) {
        CHECK(device.components()[i].index == components[i].index);
        CHECK(device.components()[i].component == components[i].component);
        CHECK(std::ranges::equal(device.components()[i].entries, components[i].entries));
    }
}

TEST_CASE("the emulated slave of the file takes the largest message of each SAE object, and refuses a byte more") {
    const auto xml = esi::write_esi(esi::make_device(test::sample_slave, test::sample_texts, components, true));
    const esi::emulated_device device{*esi::parse_esi(xml, "sae.xml")};
    machine slave{device.description(), device.components(), device.transfer_size()};
    for (const auto& object : components)
        for (const auto& entry : object.entries) {
            CAPTURE(object.index, entry.name, entry.max_size);
            REQUIRE(slave.download(object.index, entry.subindex, entry.max_size).error == ethercat::master_error{});
            REQUIRE(slave.download(object.index, entry.subindex, entry.max_size + 1u).error !=
                    ethercat::master_error{});
        }
    CHECK(slave.download(0x2021, 55, 10).error.abort == ethercat::abort_code::no_subindex);
    CHECK(slave.download(0x2521, 1, 10).error.abort == ethercat::abort_code::no_object);
}

TEST_CASE("a slave restores the whole SAE message from what crosses the wire") {
    // SetWrenchEffort, one effort of 50 %, to 258.2.34 from 65534.4.3.
    const auto sent = test::from_hex("00 1400 06 22 02 0201 03 04 feff 0504 0100 ffbf 0700");
    using delivery = bridging::sae_delivery<table>;
    bytes packet(delivery::translator::max_packet_size);
    const auto translated = delivery::translator::to_packet(sent, packet);
    REQUIRE(translated);
    const auto object = delivery::object_of(*translated);
    CHECK(object.station == station);
    CHECK(object.index == 0x2122);

    restoring_application application{};
    bridging::listed_objects listed{components, application};
    ethercat::standard_objects objects{test::sample_slave, listed};
    bytes memory(2000);
    std::array<ethercat::slave, 1> slaves{{ethercat::slave{test::sample_slave, objects, {.transfer_memory = memory}}}};
    ethercat::loopback_link link{slaves};
    ethercat::master_for<16> master{};
    REQUIRE(net::run(link, master, ethercat::bring_up{0, station}));
    REQUIRE(net::run(link, master, ethercat::download{station, object.index, object.subindex, object.data}));
    CHECK(test::to_hex(application.received) == test::to_hex(sent));
}
