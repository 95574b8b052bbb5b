// Several slaves in a ring, from the scan to the cyclic exchange of their process data.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::from_hex;
using jauscat::test::simulated_link;
using jauscat::test::to_hex;
using support::instant;
namespace test = jauscat::test;

namespace {

using bytes = std::vector<std::byte>;
using cycle_data = process_data_for<16, 4096>;

constexpr std::array<pdo_entry, 2> two_words{pdo_entry{0x7000, 1, 16, 6, "left"}, pdo_entry{0x7000, 2, 16, 6, "right"}};
constexpr std::array<pdo_entry, 1> one_byte{pdo_entry{0x6000, 1, 8, 5, "state"}};
constexpr std::array<pdo_entry, 3> ten_bits{pdo_entry{0x7010, 1, 1, 1, "on"}, pdo_entry{0x7010, 2, 1, 1, "fast"},
                                            pdo_entry{0x7010, 3, 8, 5, "level"}};

// A slave with its objects.
struct device {
    slave_description description;
    test::objects objects{};
    standard_objects standard;
    slave here;
    explicit device(const slave_description& d) : description{d}, standard{description, objects}, here{d, standard} {}
    device(const device&) = delete;
    device& operator=(const device&) = delete;
};

struct bench {
    std::vector<std::unique_ptr<device>> devices{};
    bool works{true};
    simulated_link link{[this](std::span<std::byte> frame) {
        for (auto& each : devices) each->here.pass(frame);
        for (auto& each : devices)
            if (works) each->here.work();
    }};
    master_for<16> master{};

    explicit bench(std::initializer_list<slave_description> descriptions) {
        for (const auto& each : descriptions) devices.push_back(std::make_unique<device>(each));
    }

    slave& at(std::size_t i) { return devices[i]->here; }
    template <master_job Job> typename Job::result_type run(const Job& job) { return link.run(master, job); }
    bring_up::result_type up(std::uint16_t position, std::uint16_t station) { return run(bring_up{position, station}); }
    /// All slaves, under the stations 1, 2 ..., to SAFE-OP.
    void safe_op() {
        for (std::uint16_t i = 0; i != devices.size(); ++i) {
            REQUIRE(up(i, static_cast<std::uint16_t>(i + 1)));
            REQUIRE(run(configure{static_cast<std::uint16_t>(i + 1)}));
            REQUIRE(run(change_state{static_cast<std::uint16_t>(i + 1), al_state::safe_op}));
        }
    }
    void op() {
        safe_op();
        for (std::uint16_t i = 0; i != devices.size(); ++i)
            REQUIRE(run(change_state{static_cast<std::uint16_t>(i + 1), al_state::op}));
    }
    /// One cycle: out, through all slaves, back.
    bool cycle(process_data& data, bytes* sent = nullptr) {
        bytes frame(max_frame_size);
        data.begin_cycle();
        frame.resize(data.next_frame(frame, link.now));
        if (sent != nullptr) *sent = frame;
        for (auto& each : devices) each->here.process(frame);
        return data.on_frame(frame);
    }
};

/// One datagram of another master's.
void write_register(slave& device, command cmd, std::uint16_t adp, std::uint16_t ado, std::string_view hex) {
    bytes frame(max_frame_size);
    frame_builder builder{frame};
    builder.add(cmd, adp, ado, from_hex(hex));
    frame.resize(builder.finish()->size());
    device.process(frame);
}

const slave_description motors{.vendor = 1, .product = 0x11, .serial = 7, .outputs = two_words, .inputs = one_byte};
const slave_description lamps{.vendor = 1, .product = 0x22, .outputs = ten_bits};
const slave_description sensor{.vendor = 1, .product = 0x33, .inputs = one_byte};
const slave_description plain{.vendor = 1, .product = 0x44};

} // namespace

TEST_CASE("a scan counts the slaves and clears settings of an earlier master") {
    bench b{motors, lamps, plain};
    REQUIRE(b.up(0, 7));
    REQUIRE(b.up(1, 8));
    const auto result = b.run(scan{});
    REQUIRE(result);
    CHECK(*result == 3);
    CHECK(b.master.slaves().empty());
    for (std::size_t i = 0; i != 3; ++i) {
        CHECK(b.at(i).state() == al_state::init);
        CHECK(b.at(i).station_address() == 0);
    }

    bench empty{};
    CHECK(empty.run(scan{}).error() == master_error{});

    bench stubborn{plain};
    stubborn.works = false;
    stubborn.link.on_way_back = [](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view)
            if (d.header.ado == 0x0130) d.data[0] = std::byte{0x12};
    };
    CHECK(stubborn.run(scan{}).error() == master_error{.code = master_errc::state_timeout, .state = al_state{2}});
}

TEST_CASE("a station address of an earlier master at another slave is cleared") {
    bench b{motors, lamps, {.product = 0x55, .station_alias = 1}};
    write_register(b.at(1), command::apwr, 0, 0x0010, "0100");
    REQUIRE(b.up(2, 3));
    write_register(b.at(2), command::fpwr, 3, 0x0100, "00000001"); // its alias counts as an address
    REQUIRE(b.up(0, 1));
    CHECK(b.master.find(1)->identity.product == 0x11);
    CHECK(b.at(0).station_address() == 1);
    CHECK(b.at(1).station_address() == 0);
    CHECK(b.at(2).station_address() == 3);
    REQUIRE(b.run(check{1}));
    REQUIRE(b.run(check{3}));
    REQUIRE(b.up(1, 2));
    CHECK(b.master.slaves().size() == 3);
}

TEST_CASE("a station address that another slave keeps, although it is cleared, is reported") {
    bench b{motors, lamps};
    b.link.on_way_back = [&](bytes&) { write_register(b.at(1), command::apwr, 0, 0x0010, "0100"); };
    CHECK(b.up(0, 1).error() == master_error{.code = master_errc::duplicate_station, .working_counter = 2});
}

TEST_CASE("a slave with an unexpected identity is refused before it is configured") {
    bench b{motors};
    CHECK(b.run(bring_up{0, 1, {.vendor = 1, .product = 0x11, .serial = 7}}));
    CHECK(b.run(bring_up{0, 1, {.vendor = 2}}).error() ==
          master_error{.code = master_errc::wrong_identity, .product = 0x11});
    CHECK(b.run(bring_up{0, 1, {.product = 0x12}}).error().code == master_errc::wrong_identity);
    CHECK(b.run(bring_up{0, 1, {.revision = 9}}).error().code == master_errc::wrong_identity);
    CHECK(b.run(bring_up{0, 1, {.serial = 8}}).error().code == master_errc::wrong_identity);
    CHECK(b.master.slaves().empty());
    CHECK(b.at(0).state() == al_state::init);
}

TEST_CASE("a slave goes up one state at a time and down at once") {
    bench b{motors};
    REQUIRE(b.up(0, 1));
    REQUIRE(b.run(configure{1}));
    REQUIRE(b.run(change_state{1, al_state::op}));
    CHECK(b.at(0).state() == al_state::op);
    REQUIRE(b.run(change_state{1, al_state::op}));
    REQUIRE(b.run(change_state{1, al_state::pre_op}));
    CHECK(b.at(0).state() == al_state::pre_op);
    REQUIRE(b.run(change_state{1, al_state::init}));
    CHECK(b.at(0).state() == al_state::init);
    REQUIRE(b.run(change_state{1, al_state::safe_op}));
    CHECK(b.at(0).state() == al_state::safe_op);
}

TEST_CASE("a refused state is explained, and its error does not block the next attempt") {
    bench b{motors};
    REQUIRE(b.up(0, 1));
    const auto result = b.run(change_state{1, al_state::safe_op}); // nothing is configured
    REQUIRE(result.error().code == master_errc::al_error);
    const auto why = static_cast<unsigned>(result.error().al_status);
    CHECK((why == 0x1D || why == 0x1E || why == 0x17));
    CHECK_FALSE(describe_reason(result.error()).empty());
    REQUIRE(b.run(configure{1}));
    CHECK(b.run(change_state{1, al_state::safe_op}));
    CHECK(b.run(change_state{2, al_state::op}).error() ==
          master_error{.code = master_errc::wrong_station, .station = 2});
}

TEST_CASE("an unknown state leads to INIT, never upwards") {
    for (const unsigned raw : {0u, 5u, 6u, 7u, 9u, 0xCu, 0xFu}) {
        bench b{motors};
        std::string asked;
        unsigned polls = 0;
        b.link.on_way_back = [&](bytes& frame) {
            mutable_frame_view view;
            REQUIRE(view.parse(frame));
            for (const auto d : view) {
                if (d.header.ado == 0x0120) asked += to_hex(d.data.first(1)) + " ";
                if (d.header.ado == 0x0130 && polls != 0) --polls, d.data[0] = static_cast<std::byte>(raw);
            }
        };
        polls = 1;
        REQUIRE(b.up(0, 1));
        CHECK(asked == "11 01 02 ");
        asked.clear();
        polls = 1;
        REQUIRE(b.run(change_state{1, al_state::init}));
        CHECK(asked == "01 ");
        REQUIRE(b.up(0, 1));
        asked.clear();
        polls = 1;
        REQUIRE(b.run(change_state{1, al_state::pre_op}));
        CHECK(asked == "01 02 ");
        asked.clear();
        CHECK(b.run(change_state{1, static_cast<al_state>(raw)}).error() ==
              master_error{.code = master_errc::al_error, .al_status = al_status_code{0x12}});
        CHECK(asked.empty());
    }
}

TEST_CASE("an error in an unknown state is acknowledged with INIT") {
    bench b{motors};
    REQUIRE(b.up(0, 1));
    std::string asked;
    bool fails = true;
    b.link.on_way_back = [&](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) {
            if (d.header.ado == 0x0120) asked += to_hex(d.data.first(1)) + " ";
            if (d.header.ado == 0x0130 && fails) fails = false, d.data[0] = std::byte{0x10};
        }
    };
    REQUIRE(b.run(change_state{1, al_state::pre_op}));
    CHECK(asked == "11 02 ");
}

TEST_CASE("configure sets the watchdog, whatever its registers held before") {
    bench b{motors};
    REQUIRE(b.up(0, 1));
    const auto registers = [&] {
        std::string text;
        for (const std::uint16_t address : {std::uint16_t{0x0400}, std::uint16_t{0x0420}}) {
            std::array<std::byte, 2> value{};
            REQUIRE(b.run(exchange_datagram{command::fprd, 1, address, value}));
            text += to_hex(value) + " ";
        }
        return text;
    };
    write_register(b.at(0), command::fpwr, 1, 0x0400, "ffff");
    write_register(b.at(0), command::fpwr, 1, 0x0420, "0000");
    REQUIRE(b.run(configure{1}));
    CHECK(registers() == "c2 09 e8 03 ");
    CHECK(b.master.find(1)->watchdog == 100ms);
    REQUIRE(b.run(configure{1, 250ms}));
    CHECK(registers() == "c2 09 c4 09 ");
    REQUIRE(b.run(configure{1, 1ns})); // rounded up
    CHECK(registers() == "c2 09 01 00 ");
    CHECK(b.master.find(1)->watchdog == 100us);
    for (const auto wrong : {0ns, -1ns, std::chrono::nanoseconds{6'553'500'001}}) {
        CHECK(b.run(configure{1, wrong}).error().code == master_errc::watchdog_range);
        CHECK(b.run(change_state{1, al_state::op}).error().code == master_errc::not_configured);
    }
    REQUIRE(b.run(configure{1, std::chrono::nanoseconds{6'553'500'000}}));
    CHECK(registers() == "c2 09 ff ff ");
}

TEST_CASE("a slave that does not keep its watchdog settings does not reach OP") {
    const auto spoil = [](bench& b, std::uint16_t ado, std::string_view hex) {
        b.link.on_way_back = [ado, value = from_hex(hex)](bytes& frame) {
            mutable_frame_view view;
            REQUIRE(view.parse(frame));
            for (const auto d : view)
                if (d.header.ado == ado && d.header.cmd == command::fprd) std::ranges::copy(value, d.data.begin());
        };
    };
    const auto refused = [&](bench& b) {
        const auto result = b.run(configure{1});
        CHECK(b.run(change_state{1, al_state::op}).error().code == master_errc::not_configured);
        CHECK(b.at(0).state() == al_state::pre_op);
        return result;
    };
    bench b{motors};
    REQUIRE(b.up(0, 1));
    CHECK(b.run(change_state{1, al_state::op}).error().code == master_errc::not_configured);
    spoil(b, 0x0420, "0000");
    CHECK(refused(b).error() ==
          master_error{.code = master_errc::watchdog_not_kept, .watchdog_divider = 2498, .watchdog_units = 0});
    spoil(b, 0x0400, "ffff");
    CHECK(refused(b).error() ==
          master_error{.code = master_errc::watchdog_not_kept, .watchdog_divider = 65535, .watchdog_units = 1000});
    spoil(b, 0x0810, "001c 0400 24 00 01 00"); // writes of the outputs do not trigger it
    CHECK(refused(b).error().code == master_errc::watchdog_not_kept);
    CHECK_FALSE(describe(master_errc::watchdog_not_kept).empty());
    b.link.on_way_back = [](bytes& frame) { // a controller without these registers
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view)
            if (d.header.ado == 0x0420) d.bytes.last(2).front() = std::byte{0};
    };
    CHECK(refused(b).error().code == master_errc::working_counter);
    b.link.on_way_back = {};
    REQUIRE(b.run(configure{1}));
    REQUIRE(b.run(change_state{1, al_state::op}));
    REQUIRE(b.up(0, 1)); // once more
    CHECK(b.run(change_state{1, al_state::op}).error().code == master_errc::not_configured);

    bench without{sensor}; // without outputs there is nothing to watch
    REQUIRE(without.up(0, 1));
    spoil(without, 0x0420, "0000");
    REQUIRE(without.run(configure{1}));
    REQUIRE(without.run(change_state{1, al_state::op}));
}

TEST_CASE("a slave whose link fails while it is configured can be configured when the link is back") {
    int replies = 0;
    for (bool is_cut = true; is_cut; ++replies) {
        bench b{motors};
        REQUIRE(b.up(0, 1));
        b.link.on_way_back = [left = replies](bytes& frame) mutable {
            if (left-- <= 0) frame.clear();
        };
        const auto result = b.run(configure{1});
        is_cut = !result;
        INFO("after " << replies << " replies");
        if (is_cut) CHECK(result.error().code == master_errc::no_reply);
        b.link.on_way_back = {};
        CHECK(b.run(configure{1}));
    }
    CHECK(replies > 20);
}

TEST_CASE("writing the outputs triggers the watchdog even if the SII says otherwise") {
    bench b{motors};
    unsigned changed = 0;
    b.link.on_way_back = [&](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) {
            if (d.header.ado != 0x0502 || d.header.cmd != command::fprd) continue;
            if (to_hex(d.data.subspan(6, 4)) == "64 00 01 03") ++changed, d.data[6] = std::byte{0x24};
        }
    };
    b.op();
    CHECK(changed != 0);
    cycle_data data{b.master.slaves()};
    std::array<std::byte, 8> manager{};
    REQUIRE(b.run(exchange_datagram{command::fprd, 1, 0x0810, manager}));
    CHECK(to_hex(std::span{manager}.first(5)) == "00 1c 04 00 64");
    b.at(0).on_time(instant{0ms});
    REQUIRE(b.cycle(data));
    b.at(0).on_time(instant{1ms});
    b.at(0).on_time(instant{102ms});
    CHECK(b.at(0).state() == al_state::safe_op);
}

TEST_CASE("each slave has an image area for its process data, and keeps it after its return") {
    bench b{motors, lamps, plain, sensor};
    b.safe_op();
    const auto place = [&](std::uint16_t station) { return b.master.find(station)->process_data; };
    CHECK(place(1).output_address == 0);
    CHECK(place(1).output_size == 4);
    CHECK(place(1).input_address == 4);
    CHECK(place(1).input_size == 1);
    CHECK(place(2).output_address == 5);
    CHECK(place(2).output_size == 2);
    CHECK(place(2).input_size == 0);
    CHECK(place(3).size() == 0);
    CHECK(place(4).input_address == 7);
    CHECK(place(4).input_size == 1);
    const auto image = process_image::of(b.master.slaves());
    CHECK(image.size == 8);
    CHECK(image.write == 2);
    CHECK(image.read == 2);
    CHECK(image.read_write == 6);

    REQUIRE(b.up(0, 1));
    REQUIRE(b.run(configure{1}));
    CHECK(place(1).output_address == 0);
    CHECK(process_image::of(b.master.slaves()).size == 8);
}

TEST_CASE("a cycle carries outputs to and inputs from every slave, byte for byte") {
    bench b{motors, lamps, plain, sensor};
    b.op();
    cycle_data data{b.master.slaves()};
    std::ranges::copy(from_hex("11223344"), data.outputs(*b.master.find(1)).begin());
    std::ranges::copy(from_hex("fd03"), data.outputs(*b.master.find(2)).begin());
    b.at(0).inputs()[0] = std::byte{0x55};
    b.at(3).inputs()[0] = std::byte{0x66};
    bytes sent;
    REQUIRE(b.cycle(data, &sent));
    CHECK(data.is_complete());
    CHECK(data.working_counter() == 6);
    CHECK(to_hex(std::span{sent}.subspan(16, 20)) == "0c 01 00 00 00 00 08 00 00 00 11 22 33 44 00 fd 03 00 00 00");
    CHECK(to_hex(b.at(0).outputs()) == "11 22 33 44");
    CHECK(to_hex(b.at(1).outputs()) == "fd 03");
    CHECK(b.at(0).take_outputs());
    CHECK_FALSE(b.at(0).take_outputs());
    CHECK(to_hex(data.inputs(*b.master.find(1))) == "55");
    CHECK(to_hex(data.inputs(*b.master.find(4))) == "66");
    CHECK(data.inputs(*b.master.find(3)).empty());
    CHECK(data.statistics().complete == 1);
}

TEST_CASE("loss of a slave shows in the working counter, and its old inputs are kept") {
    bench b{motors, sensor};
    b.op();
    cycle_data data{b.master.slaves()};
    b.at(0).inputs()[0] = std::byte{1};
    REQUIRE(b.cycle(data));
    REQUIRE(data.is_complete());
    b.at(1).power_on();
    b.at(0).inputs()[0] = std::byte{2};
    REQUIRE(b.cycle(data));
    CHECK_FALSE(data.is_complete());
    CHECK(data.working_counter() == 3);
    CHECK(data.statistics().incomplete == 1);
    CHECK(to_hex(data.inputs(*b.master.find(1))) == "01");
}

TEST_CASE("a cycle that does not return is lost, and a late one is not used for the next") {
    bench b{motors};
    b.op();
    cycle_data data{b.master.slaves()};
    bytes first(max_frame_size), second(max_frame_size);
    data.begin_cycle();
    first.resize(data.next_frame(first, instant{0ms}));
    data.begin_cycle();
    second.resize(data.next_frame(second, instant{1ms}));
    CHECK(data.statistics().lost == 1);
    b.at(0).process(first);
    CHECK(data.on_frame(first)); // ours, but late
    CHECK(data.waits());
    CHECK(data.statistics().complete == 0);
    b.at(0).process(second);
    CHECK(data.on_frame(second));
    CHECK(data.statistics().complete == 1);
    // What the master sent is not this one's, and the other way round.
    bytes frame(max_frame_size);
    REQUIRE(b.master.start(change_state{1, al_state::op}));
    frame.resize(b.master.next_frame(frame, instant{2ms}));
    b.at(0).process(frame);
    CHECK_FALSE(data.on_frame(frame));
    CHECK(b.master.on_frame(frame, instant{2ms}));
}

TEST_CASE("each cycle reports for each watched slave whether it is present and in OP") {
    bench b{motors, sensor};
    b.op();
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    REQUIRE(data.fits());
    const auto status = [&](std::uint16_t station) { return data.status(*b.master.find(station)); };
    CHECK(status(1).condition == slave_condition::silent);
    CHECK_FALSE(status(1).ran_within(1h, instant{0ms}));

    b.link.now = instant{10ms};
    data.outputs(*b.master.find(1))[0] = std::byte{0x77};
    b.at(0).inputs()[0] = std::byte{0x55};
    b.at(1).inputs()[0] = std::byte{0x66};
    bytes sent;
    REQUIRE(b.cycle(data, &sent));
    CHECK(to_hex(std::span{sent}.subspan(16)) ==
          "0c 01 00 00 00 00 05 80 00 00 77 00 00 00 00 00 00 " // process data of the first
          "0c 01 05 00 00 00 01 80 00 00 00 00 00 "             // and of the second
          "04 01 01 00 30 01 06 80 00 00 00 00 00 00 00 00 00 00 "
          "04 01 01 00 0d 08 03 80 00 00 00 00 00 00 00 "
          "04 01 02 00 30 01 06 80 00 00 00 00 00 00 00 00 00 00 "
          "04 01 02 00 0d 08 03 00 00 00 00 00 00 00 00");
    CHECK(data.is_complete());
    CHECK(data.working_counter() == 4);
    CHECK(to_hex(b.at(0).outputs()) == "77 00 00 00");
    CHECK(to_hex(data.inputs(*b.master.find(1))) == "55");
    CHECK(to_hex(data.inputs(*b.master.find(2))) == "66");
    for (std::uint16_t station = 1; station != 3; ++station) {
        CHECK(status(station).condition == slave_condition::running);
        CHECK(status(station).al.state == al_state::op);
        CHECK(status(station).last_running == instant{10ms});
        CHECK_FALSE(status(station).reply_waiting);
    }

    // A master that took the first one's state: its inputs count in SAFE-OP, but it does not run.
    b.link.now = instant{20ms};
    write_register(b.at(0), command::fpwr, 1, 0x0120, "0400");
    b.at(0).inputs()[0] = std::byte{0x56};
    REQUIRE(b.cycle(data));
    CHECK(status(1).condition == slave_condition::not_in_op);
    CHECK(status(1).al.state == al_state::safe_op);
    CHECK(status(1).last_running == instant{10ms});
    CHECK(status(1).last_inputs == instant{20ms});
    CHECK(to_hex(data.inputs(*b.master.find(1))) == "56");
    CHECK(status(2).condition == slave_condition::running);

    // Reset: what the other one says counts all the same.
    b.link.now = instant{30ms};
    b.at(0).power_on();
    b.at(1).inputs()[0] = std::byte{0x67};
    REQUIRE(b.cycle(data));
    CHECK_FALSE(data.is_complete());
    CHECK(status(1).condition == slave_condition::absent);
    CHECK(status(1).last_inputs == instant{20ms});
    CHECK(status(2).condition == slave_condition::running);
    CHECK(to_hex(data.inputs(*b.master.find(2))) == "67");
}

TEST_CASE("a watched slave reports why it left OP") {
    bench b{motors};
    b.op();
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    b.at(0).on_time(instant{0ms});
    REQUIRE(b.cycle(data));
    b.at(0).on_time(instant{1ms});
    b.at(0).on_time(instant{200ms}); // its watchdog has expired
    REQUIRE(b.cycle(data));
    const auto& status = data.status(b.master.slaves().front());
    CHECK(status.condition == slave_condition::not_in_op);
    CHECK(status.al.error);
    CHECK(status.al.code == al_status_code::sync_manager_watchdog);
    CHECK_FALSE(describe(status.condition).empty());
}

TEST_CASE("a slave without its station address does not count as running, although its process data are exchanged") {
    bench b{motors};
    b.op();
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    b.at(0).inputs()[0] = std::byte{1};
    b.link.now = instant{10ms};
    REQUIRE(b.cycle(data));
    write_register(b.at(0), command::apwr, 0, 0x0010, "0900");
    b.at(0).inputs()[0] = std::byte{2};
    b.link.now = instant{20ms};
    REQUIRE(b.cycle(data));
    CHECK(data.is_complete());
    const auto& status = data.status(b.master.slaves().front());
    CHECK(status.condition == slave_condition::absent);
    CHECK(status.last_running == instant{10ms});
    CHECK(status.last_inputs == instant{10ms});
    CHECK(to_hex(data.inputs(b.master.slaves().front())) == "01");

    // Two slaves under one address: neither is believed.
    bench two{motors, motors};
    two.op();
    cycle_data both{two.master.slaves(), {.watch_slaves = true}};
    write_register(two.at(1), command::apwr, 0, 0x0010, "0100");
    REQUIRE(two.cycle(both));
    CHECK(both.status(*two.master.find(1)).condition == slave_condition::duplicate);
    CHECK_FALSE(both.status(*two.master.find(1)).last_inputs);
    CHECK(both.status(*two.master.find(2)).condition == slave_condition::absent);
}

TEST_CASE("an unknown state does not count as running") {
    bench b{motors};
    b.op();
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    for (const unsigned raw : {0u, 5u, 6u, 7u, 9u, 0xCu, 0xFu, 0x18u}) {
        bytes frame(max_frame_size);
        data.begin_cycle();
        frame.resize(data.next_frame(frame, instant{1ms}));
        b.at(0).process(frame);
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view)
            if (d.header.ado == 0x0130) d.data[0] = static_cast<std::byte>(raw);
        REQUIRE(data.on_frame(frame));
        const auto& status = data.status(b.master.slaves().front());
        CHECK(status.condition == (raw == 0x18 ? slave_condition::running : slave_condition::not_in_op));
        CHECK(status.last_inputs.has_value() == (raw == 0x18));
    }
}

TEST_CASE("silence of a watched slave is measured in time, from when the last good frame was sent") {
    bench b{motors};
    b.op();
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    const auto& status = data.status(b.master.slaves().front());
    b.link.now = instant{10ms};
    REQUIRE(b.cycle(data));
    CHECK(status.ran_within(100ms, instant{110ms}));
    CHECK(status.has_inputs_within(100ms, instant{110ms}));
    CHECK(status.condition_within(100ms, instant{110ms}) == slave_condition::running);
    CHECK_FALSE(status.ran_within(100ms, instant{110ms + 1ns}));
    CHECK(status.condition_within(100ms, instant{110ms + 1ns}) == slave_condition::silent);

    bytes frame(max_frame_size); // received 300 ms after it was sent: its news are as old
    data.begin_cycle();
    frame.resize(data.next_frame(frame, instant{20ms}));
    b.at(0).process(frame);
    REQUIRE(data.on_frame(frame));
    CHECK_FALSE(status.ran_within(100ms, instant{320ms}));
    CHECK(status.condition_within(100ms, instant{320ms}) == slave_condition::silent);

    b.at(0).power_on();
    b.link.now = instant{330ms};
    REQUIRE(b.cycle(data));
    CHECK(status.condition_within(100ms, instant{340ms}) == slave_condition::absent);
}

TEST_CASE("a slave that could not be brought up again keeps its image area, since it may still run") {
    bench b{motors, motors, motors};
    for (std::uint16_t i = 0; i != 2; ++i) {
        REQUIRE(b.up(i, static_cast<std::uint16_t>(i + 1)));
        REQUIRE(b.run(configure{static_cast<std::uint16_t>(i + 1)}));
    }
    const auto place = b.master.find(2)->process_data;
    for (const std::uint16_t position : std::initializer_list<std::uint16_t>{0, 1, 1}) {
        b.link.faults.lose = 100;
        CHECK_FALSE(b.up(position, static_cast<std::uint16_t>(position + 1)));
    }
    b.link.faults.lose = 0;
    REQUIRE(b.up(2, 3));
    REQUIRE(b.run(configure{3}));
    CHECK(b.master.find(3)->process_data.output_address >= place.output_address + place.size());
    REQUIRE(b.up(1, 2));
    REQUIRE(b.run(configure{2}));
    CHECK(b.master.find(2)->process_data.output_address == place.output_address);
}

TEST_CASE("slaves without process data are watched too, and a full reply mailbox is detected") {
    bench b{plain};
    b.devices[0]->objects.add(0x2002, 0, 4);
    REQUIRE(b.up(0, 1));
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    REQUIRE(b.cycle(data));
    const auto& status = data.status(b.master.slaves().front());
    CHECK(status.condition == slave_condition::not_in_op);
    CHECK(status.al.state == al_state::pre_op);
    CHECK_FALSE(status.reply_waiting);

    auto request = from_hex("0a00 0000 00 13 0020 40 0220 00 00000000"); // an upload of another master's
    request.resize(plain.mailbox_out_size);
    write_register(b.at(0), command::fpwr, 1, plain.mailbox_out_offset, to_hex(request));
    REQUIRE(b.cycle(data));
    CHECK(status.reply_waiting);
    REQUIRE(b.run(collect_emergencies{1}));
    REQUIRE(b.cycle(data));
    CHECK_FALSE(status.reply_waiting);
}

TEST_CASE("one frame watches sixteen slaves, and more data take more frames") {
    bench b{};
    for (std::size_t i = 0; i != 16; ++i) b.devices.push_back(std::make_unique<device>(motors));
    b.op();
    cycle_data data{b.master.slaves(), {.watch_slaves = true}};
    REQUIRE(data.fits());
    CHECK(data.frame_count() == 1);
    REQUIRE(b.cycle(data));
    CHECK(data.is_complete());
    for (const auto& slave : b.master.slaves()) CHECK(data.status(slave).condition == slave_condition::running);

    static std::array<pdo_entry, 128> many{};
    many.fill(pdo_entry{0x7000, 1, 32, 7, "word"});
    bench large{{.outputs = many}, {.inputs = many}, {.outputs = std::span{many}.first(100)}};
    large.safe_op();
    bytes frame(max_frame_size);
    cycle_data plain_cycle{large.master.slaves()};
    CHECK(plain_cycle.fits());
    plain_cycle.begin_cycle();
    CHECK(plain_cycle.next_frame(frame, instant{0ms}) == 16 + 12 + 1424);
    bench full{{.outputs = many}, {.inputs = many}, {.outputs = std::span{many}.first(115)}};
    full.safe_op();
    cycle_data full_cycle{full.master.slaves()};
    for (int cycle = 0; cycle != 300; ++cycle) {
        full_cycle.begin_cycle();
        CHECK(full_cycle.next_frame(frame, instant{cycle * 1ms}) == 16 + 12 + 1484);
        plain_cycle.begin_cycle();
        const auto size = plain_cycle.next_frame(frame, instant{cycle * 1ms});
        CHECK(size == (cycle < 254 ? 16 + 12 + 1424 : 16 + 12 + 1424 + 13)); // one more datagram: see process_data
    }
    cycle_data too_much{large.master.slaves(), {.watch_slaves = true}};
    CHECK(too_much.fits());
    CHECK(too_much.frame_count() == 2);
    process_data_for<3, 1423> too_small{large.master.slaves()};
    CHECK_FALSE(too_small.fits());
    too_small.begin_cycle();
    CHECK(too_small.next_frame(frame, instant{0ms}) == 0);
    process_data_for<2, 1424> too_few{large.master.slaves()};
    CHECK_FALSE(too_few.fits());
}

TEST_CASE("a reply from 256 cycles ago is not used for the present cycle") {
    for (const bool watches : {false, true}) {
        bench b{motors};
        b.op();
        cycle_data data{b.master.slaves(), {.watch_slaves = watches}};
        bytes first, frame;
        for (int cycle = 0; cycle != 257; ++cycle) {
            frame.resize(max_frame_size);
            data.begin_cycle();
            frame.resize(data.next_frame(frame, instant{cycle * 1ms}));
            if (cycle == 0) first = frame;
        }
        b.at(0).inputs()[0] = std::byte{0x77};
        b.at(0).process(first);
        CHECK(data.on_frame(first)); // nobody else's
        CHECK(data.waits());
        CHECK(data.inputs(*b.master.find(1))[0] == std::byte{});
        b.at(0).process(frame);
        CHECK(data.on_frame(frame));
        CHECK(data.is_complete());
        CHECK(data.inputs(*b.master.find(1))[0] == std::byte{0x77});
    }
}

TEST_CASE("a late frame of an earlier cycle is not used for a later exchange") {
    bench b{motors, sensor};
    b.op();
    cycle_data data{b.master.slaves()};
    bytes late(max_frame_size);
    data.begin_cycle();
    late.resize(data.next_frame(late, instant{0ms}));
    data.set_slaves(b.master.slaves().first(1));
    for (int cycle = 0; cycle != 300; ++cycle) REQUIRE(b.cycle(data));
    CHECK(data.on_frame(late));
    CHECK_FALSE(data.on_frame(late)); // one frame is missing, not two
}

TEST_CASE("mailbox transfers continue between the cycles") {
    bench b{motors};
    b.devices[0]->objects.add(0x2002, 0, 28);
    b.op();
    cycle_data data{b.master.slaves()};
    bytes frame(max_frame_size);
    const bytes value(28, std::byte{0x5A});
    for (int cycles = 0; cycles != 100; ++cycles) {
        REQUIRE(b.cycle(data));
        REQUIRE(data.is_complete());
        if (b.master.idle()) {
            if (cycles != 0) REQUIRE(b.master.error() == master_error{});
            REQUIRE(b.master.start(download{1, 0x2002, 0, value}));
        }
        if (const auto size = b.master.next_frame(frame, b.link.now += 1ms); size != 0) {
            b.at(0).process(std::span{frame}.first(size));
            REQUIRE(b.master.on_frame(std::span{frame}.first(size), b.link.now));
        }
    }
    CHECK(b.devices[0]->objects.writes >= 45);
}

TEST_CASE("a slave that cannot read and write in one datagram makes a cycle have two") {
    bench b{motors, sensor};
    b.link.on_way_back = [](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view)
            if (d.header.ado == 0 && d.header.cmd == command::fprd) d.data[9] |= std::byte{0x02};
    };
    b.op();
    cycle_data data{b.master.slaves()};
    REQUIRE(data.image().no_lrw);
    data.outputs(*b.master.find(1))[0] = std::byte{0x77};
    b.at(1).inputs()[0] = std::byte{0x88};
    bytes sent;
    REQUIRE(b.cycle(data, &sent));
    CHECK(data.is_complete());
    CHECK(to_hex(std::span{sent}.subspan(16, 11)) == "0b 01 00 00 00 00 06 80 00 00 77");
    CHECK(b.at(0).outputs()[0] == std::byte{0x77});
    CHECK(data.inputs(*b.master.find(2))[0] == std::byte{0x88});
}

TEST_CASE("PDOs of more than 65,535 bytes are refused") {
    bench b{motors};
    std::string asked;
    b.link.on_way_back = [&](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) {
            if (d.working_counter == 0) continue;
            if (d.header.ado == 0x1000) asked = to_hex(d.data.subspan(9, 3));
            if (d.header.ado != 0x1600) continue;
            const auto answer = [&](const std::string& sdo) {
                std::ranges::copy(from_hex("0030" + sdo), d.data.subspan(6).begin());
            };
            // 8 PDOs of 255 entries of 255 bits, one of 255 entries of 17 bits: 65,567 bytes, or 31 modulo 65,536.
            const bool is_count = asked.ends_with("00");
            if (asked.starts_with("12 1c"))
                answer(is_count ? "4f" + asked + "09" : "4b" + asked + (asked.ends_with("09") ? "0116" : "0016"));
            else if (asked.starts_with("00 16") || asked.starts_with("01 16"))
                answer(is_count ? "4f" + asked + "ff"
                                : "43" + asked + (asked.starts_with("00") ? "ff" : "11") + "010070");
        }
    };
    REQUIRE(b.up(0, 1));
    CHECK(b.run(configure{1}).error() == master_error{.code = master_errc::image_full, .bytes = 65'567 + 1});
}

TEST_CASE("PDOs of more entries than the limit of the whole job are refused") {
    const bool is_of_many_pdos = GENERATE(false, true); // 255 PDOs of 255 entries of no bits, or one SyncManager's each
    bench b{motors};
    std::string asked;
    unsigned answers = 0;
    b.link.on_way_back = [&](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) {
            if (d.working_counter == 0) continue;
            if (d.header.ado == 0x1000) asked = to_hex(d.data.subspan(9, 3));
            if (d.header.ado != 0x1600) continue;
            ++answers;
            const auto answer = [&](const std::string& sdo) {
                std::ranges::copy(from_hex("0030" + sdo), d.data.subspan(6).begin());
            };
            const bool is_count = asked.ends_with("00");
            if (asked.starts_with("12 1c") || asked.starts_with("13 1c"))
                answer(is_count ? "4f" + asked + (is_of_many_pdos ? "ff" : "09") : "4b" + asked + "0016");
            else if (asked.starts_with("00 16"))
                answer(is_count ? "4f" + asked + "ff" : "43" + asked + "00010070");
        }
    };
    REQUIRE(b.up(0, 1));
    const auto error = b.run(configure{1}).error();
    CHECK(error.code == master_errc::too_many_entries);
    CHECK(error.index == 0x1600);
    CHECK(answers < 2 * max_process_objects);
    b.link.on_way_back = {};
    CHECK(b.run(configure{1})); // the SII was given back, and the mailbox is free
}

TEST_CASE("an SII with more PDOs and entries than the limit of the whole job is refused") {
    auto of_sii = lamps;
    of_sii.mailbox_out_size = of_sii.mailbox_in_size = 0;
    bench b{of_sii};
    unsigned reads = 0;
    b.link.on_way_back = [&](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) {
            if (d.header.ado != 0x0502 || d.header.cmd != command::fprd || d.working_counter == 0) continue;
            const auto word = std::to_integer<unsigned>(d.data[2]) | std::to_integer<unsigned>(d.data[3]) << 8;
            if (word < 0x40) continue;
            ++reads;
            // One category of TxPDOs up to the end of the memory, of no entries each.
            std::ranges::copy(from_hex(word == 0x40 ? "3200 ff7f" : "001a 00 ff"), d.data.subspan(6).begin());
        }
    };
    REQUIRE(b.up(0, 1));
    CHECK(b.run(configure{1}).error() == master_error{.code = master_errc::too_many_entries});
    CHECK(reads < 8 * max_process_objects);
}

TEST_CASE("an SII with more SyncManagers than registers is refused") {
    bench b{motors};
    const auto listed = [](unsigned word) -> std::string {
        if (word == 0x40) return "2900 a000"; // SyncM: 40 of them
        if (word == 0x42 + 160) return "ffff 0000";
        return word % 4 == 2 ? "0011 0400" : word > 0x42 + 32 * 4 ? "24000103" : "02000000"; // number 32 has outputs
    };
    b.link.on_way_back = [&](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view)
            if (d.header.ado == 0x0502 && d.header.cmd == command::fprd && d.data[2] >= std::byte{0x40})
                std::ranges::copy(from_hex(listed(std::to_integer<unsigned>(d.data[2]))), d.data.subspan(6).begin());
    };
    REQUIRE(b.up(0, 1));
    CHECK(b.run(configure{1}).error() == master_error{.code = master_errc::sii_malformed, .sii_word = 0x42 + 32 * 4});
}

TEST_CASE("without mapping objects, and without a mailbox, the SII determines the process data") {
    bench b{motors};
    b.link.on_way_back = [](bytes& frame) { // as if no object were known
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view)
            if (d.header.ado == 0x1600 && d.working_counter != 0)
                std::ranges::copy(from_hex("0a00 0000 00 03 0020 80"), d.data.begin()),
                    std::ranges::copy(from_hex("00000206"), d.data.subspan(12).begin());
    };
    REQUIRE(b.up(0, 1));
    REQUIRE(b.run(configure{1}));
    CHECK(b.master.find(1)->process_data.output_size == 4);
    CHECK(b.master.find(1)->process_data.input_size == 1);
}

TEST_CASE("a ring reaches OP and exchanges process data over a bad link") {
    bench b{motors, lamps, sensor};
    b.master.reset({.frame_timeout = 1ms, .frame_lifetime = 3ms});
    b.link.faults = {.lose = 10, .duplicate = 10, .delay = 20};
    unsigned good = 0;
    for (int i = 0; i != 200; ++i) {
        bool up = true;
        for (std::uint16_t station = 1; up && station != 4; ++station) {
            up = b.up(static_cast<std::uint16_t>(station - 1), station) && b.run(configure{station}) &&
                 b.run(change_state{station, al_state::op});
            if (!up) CHECK(b.master.error().code == master_errc::no_reply);
        }
        good += up;
        if (!up) continue;
        for (std::size_t at = 0; at != 3; ++at) REQUIRE(b.at(at).state() == al_state::op);
        CHECK(process_image::of(b.master.slaves()).size == 8);
    }
    CHECK(good > 190);
}
