// Many slaves at once: bring-up and changes of state with the datagrams of many slaves in one frame.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::simulated_link;
namespace test = jauscat::test;

namespace {

using bytes = std::vector<std::byte>;

constexpr std::array<pdo_entry, 2> words{pdo_entry{0x7000, 1, 16, 6, "left"}, pdo_entry{0x7000, 2, 16, 6, "right"}};
constexpr std::array<pdo_entry, 1> state{pdo_entry{0x6000, 1, 32, 7, "state"}};
const slave_description motor{.vendor = 1, .product = 0x11, .outputs = words, .inputs = state};

struct chain {
    test::objects objects{};
    std::vector<std::unique_ptr<standard_objects>> standard{};
    std::vector<std::unique_ptr<slave>> devices{};
    std::vector<slave_record> records;
    class master master;
    simulated_link link{[this](std::span<std::byte> frame) {
        for (auto& each : devices) each->process(frame);
    }};
    std::vector<bring_up_place> places{};

    explicit chain(std::size_t count, slave_description description = motor, const master_config& config = {})
        : records(count), master{records, config} {
        for (std::size_t i = 0; i != count; ++i) {
            description.serial = static_cast<std::uint32_t>(i + 1);
            standard.push_back(std::make_unique<standard_objects>(description, objects));
            devices.push_back(std::make_unique<slave>(description, *standard.back()));
            places.emplace_back(
                bring_up{.position = static_cast<std::uint16_t>(i), .station = static_cast<std::uint16_t>(i + 1)});
        }
    }
    template <master_job Job> typename Job::result_type run(const Job& job) { return link.run(master, job); }
    std::uint64_t sent() const { return master.statistics().sent; }
    std::size_t in_state(al_state wanted) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(devices, [&](const auto& each) { return each->state() == wanted; }));
    }
};

} // namespace

TEST_CASE("256 slaves are brought up in the frames that hold their datagrams") {
    struct row {
        std::size_t slaves;
        std::uint64_t frames;
        std::chrono::microseconds time;
    };
    // These are the numbers of docs/ethercat.md.
    for (const auto& [slaves, frames, expected] :
         {row{1, 24, 1386us}, row{16, 24, 2311us}, row{64, 28, 5882us}, row{256, 112, 45034us}}) {
        chain c{slaves};
        c.link.record = true;
        REQUIRE(*c.run(scan{}) == slaves);
        const auto before = c.sent();
        c.link.seen.clear();
        REQUIRE(*c.run(bring_up_all{c.places}) == slaves);
        CHECK(c.sent() - before == frames);
        std::size_t size = 0;
        for (const auto& frame : c.link.seen) size += frame.size() + 24; // preamble, check sequence, gap
        // At 100 Mbit/s, 1 us in each slave there and back, 50 us in the computer.
        const auto time = size * 80ns + (c.sent() - before) * (slaves * 1us + 50us);
        CHECK(std::chrono::floor<std::chrono::microseconds>(time) == expected);
        CHECK(c.master.slaves().size() == slaves);
        CHECK(c.in_state(al_state::pre_op) == slaves);
        for (std::uint16_t i = 0; i != slaves; ++i) {
            const auto* const record = c.master.find(static_cast<std::uint16_t>(i + 1));
            REQUIRE(record != nullptr);
            CHECK(record->position == i);
            CHECK(record->identity.serial == i + 1u);
            CHECK(record->mailbox.coe);
        }
    }
}

TEST_CASE("a slave that fails does not stop the others") {
    chain c{40};
    REQUIRE(c.run(scan{}));
    c.places[3].slave.identity.product = 0x12;
    c.places.emplace_back(bring_up{.position = 99, .station = 99});
    c.places[39].slave.station = 7; // that of another one
    CHECK(*c.run(bring_up_all{c.places}) == 38);
    CHECK(c.places[3].error == master_error{.code = master_errc::wrong_identity, .product = 0x11});
    CHECK(c.places[40].error == master_error{.code = master_errc::no_slave, .slaves = 40});
    CHECK(c.places[39].error.code == master_errc::duplicate_station);
    for (const std::size_t good : {0u, 2u, 4u, 38u}) CHECK(c.places[good].error == master_error{});
    CHECK(c.master.find(4) == nullptr);

    chain few{3};
    few.places.emplace_back(bring_up{.position = 2, .station = 9});
    CHECK(*few.run(bring_up_all{std::span{few.places}.first(0)}) == 0);
    CHECK(few.sent() == 0);
}

TEST_CASE("slaves without memory in the master are refused, and the others run") {
    chain c{3};
    slave_memory<2> memory;
    master m{memory};
    CHECK(*c.link.run(m, bring_up_all{c.places}) == 2);
    CHECK(c.places[2].error.code == master_errc::too_many_slaves);
}

TEST_CASE("station addresses that an earlier master has left do not matter") {
    chain c{20};
    REQUIRE(c.run(bring_up_all{c.places}));
    std::vector<slave_record> records(20);
    master other{records};
    std::ranges::reverse(c.places);
    for (std::uint16_t i = 0; i != 20; ++i) c.places[i].slave.position = i; // each has another's address
    REQUIRE(*c.link.run(other, bring_up_all{c.places}) == 20);
    for (std::uint16_t i = 0; i != 20; ++i) CHECK(c.devices[i]->station_address() == 20 - i);
    REQUIRE(*c.link.run(other, bring_up_all{std::span{c.places}.first(10)}) == 10); // those that are up, once more
    CHECK(other.slaves().size() == 20);
}

TEST_CASE("many slaves change their state at once") {
    chain c{64};
    REQUIRE(*c.run(bring_up_all{c.places}) == 64);
    std::vector<state_place> places;
    for (std::uint16_t station = 1; station != 65; ++station) {
        if (station != 5) REQUIRE(c.run(configure{station}));
        places.emplace_back(station);
    }
    places.emplace_back(std::uint16_t{99});
    const auto before = c.sent();
    CHECK(*c.run(change_states{places, al_state::safe_op}) == 63);
    CHECK(c.sent() - before == 3); // a look, a request, a look
    CHECK(c.in_state(al_state::safe_op) == 63);
    CHECK(places[4].error.code == master_errc::al_error);
    CHECK(places[64].error == master_error{.code = master_errc::wrong_station, .station = 99});
    CHECK(*c.run(change_states{places, al_state::op}) == 63);
    CHECK(places[4].error.code == master_errc::not_configured);
    CHECK(c.in_state(al_state::op) == 63);

    std::vector<process_slot> slots(64);
    bytes image(process_image::of(c.master.slaves()).size), frame(max_frame_size);
    process_data data{slots, image};
    REQUIRE(data.set_slaves(c.master.slaves(), {.watch_slaves = true}));
    data.begin_cycle();
    while (const auto size = data.next_frame(frame, c.link.now)) {
        const auto passing = std::span{frame}.first(size);
        for (auto& each : c.devices) each->process(passing);
        REQUIRE(data.on_frame(passing));
    }
    CHECK(data.is_complete());
    for (const auto& slave : c.master.slaves())
        CHECK((data.status(slave).condition == slave_condition::running) == (slave.station != 5));
}

TEST_CASE("many slaves come up over a link that loses frames, and a link that is lost ends the job") {
    chain c{30, motor, {.frame_timeout = 1ms, .frame_lifetime = 3ms}};
    c.link.faults = {.lose = 10, .duplicate = 10, .delay = 20};
    for (int i = 0; i != 20; ++i) REQUIRE(*c.run(bring_up_all{c.places}) == 30);
    c.link.faults.lose = 100;
    CHECK(c.run(bring_up_all{c.places}).error().code == master_errc::no_reply);
    for (const auto& each : c.places) CHECK(each.error.code == master_errc::no_reply);
    CHECK(c.master.slaves().empty());
    c.link.faults = {};
    CHECK(*c.run(bring_up_all{c.places}) == 30);
}
