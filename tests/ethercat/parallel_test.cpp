// Many slaves at once: bring-up and changes of state with the datagrams of many slaves in one frame.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/master/slave_matching.hpp>
#include <jauscat/ethercat/slave/sii_image.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
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
    std::function<void()> before_frame{};
    bool hangs{}; ///< the applications of all slaves
    simulated_link link{[this](std::span<std::byte> frame) {
        if (before_frame) before_frame();
        for (auto& each : devices)
            if (hangs)
                each->pass(frame);
            else
                each->process(frame);
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
         {row{1, 24, 1386us}, row{16, 24, 2313us}, row{64, 28, 5892us}, row{256, 112, 45075us}}) {
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

TEST_CASE("a slave is recognised by its alias, its SII and its explicit device identification") {
    chain c{3, {.vendor = 1, .product = 0x11, .station_alias = 0x1234, .inputs = state, .device_id = 77}};
    REQUIRE(*c.run(bring_up_all{c.places}) == 3);
    auto found = c.run(identify{.station = 2, .device_id = true});
    REQUIRE(found);
    CHECK(found->identity.serial == 2);
    CHECK(found->alias == 0x1234);
    CHECK(found->stored_alias == 0x1234);
    CHECK(found->device_id == 77);
    CHECK(c.devices[1]->state() == al_state::pre_op);
    CHECK_FALSE(c.devices[1]->status().device_id_loaded);
    found = c.run(identify{.station = 2});
    REQUIRE(found);
    CHECK_FALSE(found->device_id);
    CHECK(c.run(identify{.station = 9}).error().code == master_errc::wrong_station);

    chain many{64}; // which have no such identification
    REQUIRE(*many.run(bring_up_all{many.places}) == 64);
    std::vector<identify_place> places;
    for (std::uint16_t station = 1; station != 66; ++station) places.emplace_back(station);
    CHECK(*many.run(identify_all{.places = places, .device_id = true}) == 64);
    for (std::size_t i = 0; i != 64; ++i) {
        CHECK(places[i].is.identity.serial == i + 1);
        CHECK_FALSE(places[i].is.device_id);
    }
    CHECK(places[64].error.code == master_errc::wrong_station);
    CHECK(many.in_state(al_state::pre_op) == 64);
}

TEST_CASE("slaves that come or go are found while the others run") {
    chain c{100};
    auto& devices = c.devices;
    std::vector<std::unique_ptr<slave>> later;
    later.push_back(std::move(devices[40]));
    devices.erase(devices.begin() + 40);
    c.places.resize(99);
    REQUIRE(*c.run(bring_up_all{c.places}) == 99);
    for (std::uint16_t station = 1; station != 100; ++station) {
        REQUIRE(c.run(configure{station}));
        REQUIRE(c.run(change_state{station, al_state::op}));
    }
    std::array<std::uint16_t, 4> into{};
    auto found = c.run(locate_slaves{into});
    REQUIRE(found);
    CHECK(found->slaves == 99);
    CHECK(found->known == 99);
    CHECK(found->unknown.empty());

    devices.insert(devices.begin() + 40, std::move(later.front())); // in the middle, not at the end
    const auto before = c.sent();
    found = c.run(locate_slaves{into});
    REQUIRE(found);
    CHECK(c.sent() - before == 3);
    CHECK(found->slaves == 100);
    CHECK(found->known == 99);
    REQUIRE(found->unknown.size() == 1);
    CHECK(found->unknown[0] == 40);
    CHECK(c.master.find(41)->position == 41);
    REQUIRE(c.run(bring_up{.position = 40, .station = 100}));
    CHECK(c.master.slaves().size() == 100);
    CHECK(c.in_state(al_state::op) == 99);

    devices[10]->power_on(); // reset
    devices.erase(devices.begin() + 20);
    found = c.run(locate_slaves{into});
    REQUIRE(found);
    CHECK(found->slaves == 99);
    CHECK(found->known == 98);
    REQUIRE(found->unknown.size() == 1);
    CHECK(found->unknown[0] == 10);
    CHECK(c.master.find(21)->position == slave_record::no_position);
    CHECK(c.master.find(22)->position == 20);
    const auto place = c.master.find(11)->process_data;
    REQUIRE(c.run(bring_up{.position = 10, .station = 11}));
    CHECK(c.master.find(11)->process_data == place);
    CHECK(c.in_state(al_state::op) == 97);
}

TEST_CASE("names are read from the SIIs of many slaves at once") {
    chain c{64};
    REQUIRE(*c.run(bring_up_all{c.places}) == 64);
    std::vector<name_place> places;
    for (std::uint16_t i = 0; i != 64; ++i) places.emplace_back(static_cast<std::uint16_t>(i + 1));
    places.emplace_back(std::uint16_t{99});
    const auto before = c.sent();
    CHECK(*c.run(read_names{places}) == 64);
    CHECK(c.sent() - before <= 20 * 4); // as for one, in four frames
    for (std::size_t i = 0; i != 64; ++i) CHECK(places[i].name.view() == motor.name);
    CHECK(places[64].error.code == master_errc::wrong_station);
}

TEST_CASE("the name in an SII is found wherever it is, and what is none is said") {
    const auto name_in = [](const std::vector<std::pair<std::uint16_t, std::string>>& categories) {
        std::vector<std::byte> sii(128);
        const auto put = [&](std::size_t word) {
            sii.push_back(static_cast<std::byte>(word & 0xFF));
            sii.push_back(static_cast<std::byte>(word >> 8));
        };
        for (const auto& [category, content] : categories) {
            put(category);
            put((content.size() + 1) / 2);
            for (const char c : content) sii.push_back(static_cast<std::byte>(c));
            if (content.size() % 2 != 0) sii.emplace_back();
        }
        put(0xFFFF);
        auto description = motor;
        const auto fixed = make_sii_image(motor);
        std::ranges::copy(std::span{fixed}.first(128), sii.begin());
        description.sii = sii;
        chain c{1, description};
        REQUIRE(*c.run(bring_up_all{c.places}) == 1);
        std::array place{name_place{1}};
        if (*c.run(read_names{place}) == 1) return std::string{place[0].name.view()};
        CHECK(place[0].error.code == master_errc::sii_malformed);
        return std::string{"malformed"};
    };
    using namespace std::string_literals;
    constexpr std::uint16_t strings = 10, general = 30, other = 2048;
    const auto texts = "\3\3one\0\5drive"s; // the second is empty
    CHECK(name_in({{strings, texts}, {general, "\1\1\1\3"s}}) == "drive");
    CHECK(name_in({{other, "abc"}, {general, "\0\0\0\3\0\0"s}, {other, ""}, {strings, texts}}) == "drive");
    CHECK(name_in({{strings, texts}, {general, "\0\0\0\1"s}}) == "one");
    CHECK(name_in({{strings, texts}, {general, "\0\0\0\2"s}}).empty());
    CHECK(name_in({{strings, texts}, {general, "\0\0\0\4"s}}).empty()); // there is none
    CHECK(name_in({{strings, texts}, {general, "\1\1\1\0"s}}).empty());
    CHECK(name_in({{strings, texts}}).empty());
    CHECK(name_in({{general, "\0\0\0\1"s}}).empty());
    CHECK(name_in({}).empty());
    CHECK(name_in({{strings, "\1\377" + std::string(255, 'x')}, {general, "\0\0\0\1"s}}) == std::string(127, 'x'));
    CHECK(name_in({{strings, "\1\12cut"s}, {general, "\0\0\0\1"s}}) == "malformed");
    CHECK(name_in(std::vector<std::pair<std::uint16_t, std::string>>(200, {other, ""})) == "malformed");
}

TEST_CASE("a slave with timeouts of its own is waited for so long") {
    chain c{2};
    REQUIRE(*c.run(bring_up_all{c.places}) == 2);
    using milliseconds = slave_timeouts::milliseconds;
    CHECK(c.master.set_timeouts(
        2, {milliseconds{11}, milliseconds{22}, milliseconds{33}, milliseconds{44}, milliseconds{55}}));
    CHECK_FALSE(c.master.set_timeouts(3, {}));
    // Between it and what the next polls take.
    const auto waits = [&](std::chrono::milliseconds time, const auto& job, master_errc why) {
        c.hangs = true;
        const auto begun = c.link.now;
        CHECK(c.run(job).error().code == why);
        CHECK(c.link.now - begun >= time);
        CHECK(c.link.now - begun < time + 2ms);
        c.hangs = false;
    };
    using enum al_state;
    const auto changes = [&](al_state from, al_state to, std::chrono::milliseconds time) {
        for (const auto station : std::array<std::uint16_t, 2>{1, 2}) {
            REQUIRE(c.run(change_state{station, pre_op}));
            REQUIRE(c.run(configure{station}));
            REQUIRE(c.run(change_state{station, from}));
            waits(station == 1 ? 5s : time, change_state{station, to}, master_errc::state_timeout);
            REQUIRE(c.run(bring_up{static_cast<std::uint16_t>(station - 1), station}));
        }
    };
    changes(init, pre_op, 11ms);
    changes(pre_op, safe_op, 22ms);
    changes(safe_op, op, 22ms);
    changes(op, safe_op, 44ms);
    changes(op, pre_op, 33ms);
    changes(safe_op, init, 33ms);
    std::array<std::byte, 4> into{};
    // For the answer, and then until the slave takes an abort.
    waits(2s, upload{1, 0x1018, 1, into}, master_errc::mailbox_timeout);
    waits(2 * 55ms, upload{2, 0x1018, 1, into}, master_errc::mailbox_timeout);
    waits(33ms, bring_up{1, 2}, master_errc::state_timeout);
}

TEST_CASE("positions that were read while a slave came are not taken") {
    chain c{100};
    auto& devices = c.devices;
    auto later = std::move(devices.back());
    devices.pop_back();
    c.places.resize(99);
    REQUIRE(*c.run(bring_up_all{c.places}) == 99);
    std::array<std::uint16_t, 4> into{};
    const auto begun = c.sent();
    c.before_frame = [&] {
        if (c.sent() - begun == 2 && later) devices.insert(devices.begin(), std::move(later)); // all others move
    };
    const auto found = c.run(locate_slaves{into});
    REQUIRE_FALSE(found);
    CHECK(found.error().code == master_errc::working_counter);
    CHECK(found.error().working_counter == 100);
    CHECK(c.run(locate_slaves{into})->known == 99);
}

TEST_CASE("missing, swapped, doubled and foreign slaves are named") {
    const auto device = [](std::uint32_t product, std::uint32_t serial = 0, std::uint16_t alias = 0) {
        return slave_identity{.identity = {.vendor = 1, .product = product, .serial = serial}, .alias = alias};
    };
    const std::array<expected_slave, 4> expected{expected_slave{.position = 0, .identity = {.product = 10}},
                                                 expected_slave{.position = 1, .identity = {.product = 20}},
                                                 expected_slave{.alias = 7, .identity = {.product = 30}},
                                                 expected_slave{.identity = {.vendor = 1, .serial = 99}}};
    std::array<matched_slave, 4> matches{};
    const auto match = [&](std::vector<slave_identity> ring) {
        std::vector<found_slave> found;
        for (const auto& each : ring)
            found.push_back({.position = static_cast<std::uint16_t>(found.size()), .is = each});
        const bool is_right = match_slaves(expected, found, matches);
        std::string text = is_right ? "right" : "wrong";
        for (const auto& each : matches) text += " " + std::string{describe(each.match)}.substr(0, 24);
        for (const auto& each : found) text += each.is_foreign ? " X" : " .";
        return text;
    };
    using enum slave_match;
    const auto is = [&](std::array<slave_match, 4> wanted) {
        for (std::size_t i = 0; i != 4; ++i)
            if (matches[i].match != wanted[i]) return false;
        return true;
    };
    CHECK(match({device(10), device(20), device(30, 0, 7), device(40, 99)}).starts_with("right"));
    CHECK(match({device(10), device(20), device(40, 99), device(30, 0, 7)}).starts_with("right"));
    CHECK(matches[2].at == 3);
    CHECK(match({device(20), device(10), device(30, 0, 7), device(40, 99)}).ends_with(". . . ."));
    CHECK(is({swapped, swapped, found, found}));
    CHECK(match({device(10), device(55), device(30, 0, 7), device(40, 98)}).ends_with(". X . X"));
    CHECK(is({found, foreign, found, missing}));
    CHECK(match({device(10), device(20), device(30, 0, 7), device(40, 99), device(30, 0, 7)}).ends_with(". . . . ."));
    CHECK(is({found, found, doubled, found}));
    CHECK(match({device(10)}).starts_with("wrong"));
    CHECK(is({found, missing, missing, missing}));
    CHECK(match({device(10), device(20), device(31, 0, 7), device(40, 99), device(10)}).ends_with(". . X . X"));
    CHECK(is({found, found, foreign, found}));
    CHECK(describe(found) == "the slave is there");
}

TEST_CASE("start-up objects are written in their order, those of one transition") {
    chain c{1};
    for (const auto index : std::initializer_list<std::uint16_t>{0x2000, 0x2001, 0x2002}) c.objects.add(index, 0, 2);
    c.objects.add(0x2003, 1, 40);
    REQUIRE(c.run(bring_up{0, 1}));
    const auto word = test::counting(2), large = test::counting(40);
    using enum state_transition;
    const std::array commands{init_command{.index = 0x2000, .data = word},
                              init_command{.index = 0x2001, .data = word, .transition = safe_op_to_op},
                              init_command{.index = 0x2003, .subindex = 1, .data = large},
                              init_command{.index = 0x3000, .data = word, .transition = safe_op_to_op},
                              init_command{.index = 0x2002, .data = word, .transition = safe_op_to_op}};
    CHECK(*c.run(run_init_commands{1, commands}) == 2);
    CHECK(c.objects.entries.at({0x2000, 0}).value == word);
    CHECK(c.objects.entries.at({0x2003, 1}).value == large);
    CHECK(c.objects.writes == 2);
    CHECK(c.run(run_init_commands{1, commands, safe_op_to_op}).error() ==
          master_error{.code = master_errc::sdo_abort, .command = 3, .index = 0x3000, .abort = abort_code::no_object});
    CHECK(c.objects.writes == 3); // the one before, not the one behind
    CHECK(*c.run(run_init_commands{1, commands, op_to_safe_op}) == 0);
    CHECK(c.run(run_init_commands{2, commands, op_to_safe_op}).error().code == master_errc::wrong_station);
    c.link.faults.lose = 100;
    CHECK(c.run(run_init_commands{1, commands}).error() ==
          master_error{.code = master_errc::no_reply, .index = 0x2000});
}

TEST_CASE("each cycle counts the slaves of the ring") {
    for (const bool watches : {false, true}) {
        chain c{100};
        REQUIRE(*c.run(bring_up_all{c.places}) == 100);
        std::vector<state_place> places;
        for (std::uint16_t station = 1; station != 99; ++station) { // two take no part
            REQUIRE(c.run(configure{station}));
            places.emplace_back(station);
        }
        REQUIRE(*c.run(change_states{places, al_state::op}) == 98);
        std::vector<process_slot> slots(100);
        bytes image(process_image::of(c.master.slaves()).size), frame(max_frame_size);
        process_data data{slots, image};
        REQUIRE(data.set_slaves(c.master.slaves(), {.watch_slaves = watches, .watch_ring = true}));
        const auto cycle = [&](jauscat::time_point now) {
            data.begin_cycle();
            while (const auto size = data.next_frame(frame, now)) {
                const auto passing = std::span{frame}.first(size);
                for (auto& each : c.devices) each->process(passing);
                REQUIRE(data.on_frame(passing));
            }
        };
        const jauscat::time_point start{1s};
        for (int i = 0; i != 300; ++i) cycle(start + i * 1ms);
        CHECK(data.is_complete());
        CHECK(data.ring().slaves == 100);
        CHECK(data.ring().all.state == static_cast<al_state>(8 | 2));
        CHECK(data.ring().last_frame == start + 299ms);
        c.devices.resize(98);
        cycle(start + 300ms);
        CHECK(data.ring().slaves == 98);
        CHECK(data.ring().all.state == al_state::op);
        c.devices[50]->power_on();
        cycle(start + 301ms);
        CHECK(data.ring().all.state == static_cast<al_state>(8 | 1));
        CHECK_FALSE(data.is_complete());
    }
}

TEST_CASE("the process data of many slaves are set up at once") {
    chain c{256};
    REQUIRE(*c.run(bring_up_all{c.places}) == 256);
    std::vector<configure_place> places;
    for (std::uint16_t station = 1; station != 257; ++station) places.emplace_back(station);
    places.emplace_back(std::uint16_t{999});
    REQUIRE(c.run(configure{1}));
    auto before = c.sent();
    REQUIRE(c.run(configure{2}));
    CHECK(c.sent() - before == 57);
    before = c.sent();
    CHECK(*c.run(configure_all{places}) == 256);
    CHECK(c.sent() - before == 1209);
    CHECK(places[256].error.code == master_errc::wrong_station);
    std::vector<state_place> all;
    for (std::uint16_t station = 1; station != 257; ++station) all.emplace_back(station);
    REQUIRE(*c.run(change_states{all, al_state::op}) == 256);
    // Each has a place of its own.
    CHECK(process_image::of(c.master.slaves()).size == 256 * 8);
    std::vector<bool> used(256 * 8);
    for (const auto& slave : c.master.slaves())
        for (auto at = slave.process_data.output_address; at != slave.process_data.end(); ++at) {
            CHECK_FALSE(used[at]);
            used[at] = true;
        }
    // Configured once more, each keeps its place.
    const auto place = c.master.find(77)->process_data;
    REQUIRE(*c.run(change_states{all, al_state::pre_op}) == 256);
    CHECK(*c.run(configure_all{places}) == 256);
    CHECK(c.master.find(77)->process_data == place);
}

TEST_CASE("process data of many slaves are set up over a bad link, and over one that copies frames") {
    for (const bool copies : {false, true}) {
        chain c{
            20, motor, {.frame_timeout = 1ms, .frame_lifetime = 3ms, .frames_may_be_copied = copies, .retries = 20}};
        c.link.faults = {.lose = 10, .duplicate = 10, .copy = copies ? 20u : 0u, .delay = 20};
        std::vector<configure_place> places;
        for (std::uint16_t station = 1; station != 21; ++station) places.emplace_back(station);
        for (int i = 0; i != 5; ++i) {
            REQUIRE(*c.run(bring_up_all{c.places}) == 20);
            const auto done = c.run(configure_all{places});
            CAPTURE(copies, i);
            for (const auto& each : places) CHECK(describe(each.error) == describe(master_error{}));
            REQUIRE(done == master_result<std::size_t>{20u});
            CHECK(process_image::of(c.master.slaves()).size == 20 * 8);
        }
        c.link.faults = {.lose = 100};
        CHECK(c.run(configure_all{places}).error().code == master_errc::no_reply);
        for (const auto& each : places) CHECK(each.error.code == master_errc::no_reply);
        for (const auto& slave : c.master.slaves()) CHECK(slave.watchdog == 0ns);
    }
}

TEST_CASE("objects of many slaves are read at once, and one that fails does not stop the others") {
    const bool are_copied = GENERATE(false, true);
    chain c{40, motor, {.frames_may_be_copied = are_copied}};
    REQUIRE(c.run(scan{}));
    REQUIRE(*c.run(bring_up_all{c.places}) == 40);
    std::vector<std::array<std::byte, 8>> values(42);
    std::vector<upload_place> places;
    for (std::size_t i = 0; i != 40; ++i)
        places.emplace_back(upload{static_cast<std::uint16_t>(i + 1), 0x1018, 4, values[i]});
    places[5].object.index = 0x5FFF;
    places.emplace_back(upload{99, 0x1018, 4, values[40]});
    places.emplace_back(upload{7, 0x1018, 1, values[41]}); // a second one of this slave
    const auto before = c.sent();
    CHECK(*c.run(upload_all{places}) == 39);
    if (!are_copied) CHECK(c.sent() - before < 40);
    for (std::size_t i = 0; i != 40; ++i) {
        if (i == 5) continue;
        CHECK(places[i].error == master_error{});
        REQUIRE(places[i].size == 4);
        CHECK(std::to_integer<std::size_t>(values[i][0]) == i + 1);
    }
    CHECK(places[5].error.code == master_errc::sdo_abort);
    CHECK(places[5].error.abort == abort_code::no_object);
    CHECK(places[5].size == 0);
    CHECK(places[40].error.code == master_errc::wrong_station);
    CHECK(places[41].error.code == master_errc::busy);
}
