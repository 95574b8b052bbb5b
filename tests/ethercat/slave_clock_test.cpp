// The distributed clock of an emulated slave: local time, receive times, control, SYNC unit, register by register.
#include "ethercat/objects.hpp"
#include "ethercat/slave_bench.hpp"
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
namespace test = jauscat::test;
namespace wire = jauscat::wire;

namespace {

constexpr std::array one_word{pdo_entry{0x7000, 1, 16, 6, "effort"}};

// One slave that is told the time with each frame.
struct clock_bench {
    explicit clock_bench(const slave_description& description, const clock_error& error = {})
        : dictionary{description, objects}, device{description, dictionary} {
        device.set_clock_error(error);
        device.pass_time(now);
    }

    test::returned_datagram send(command cmd, std::uint16_t ado, std::span<const std::byte> data) {
        return test::send_through([this](std::span<std::byte> frame) { device.process(frame, now); }, cmd, 0, ado,
                                  data);
    }
    std::uint16_t write(std::uint16_t ado, std::string_view hex) {
        return send(command::apwr, ado, from_hex(hex)).working_counter;
    }
    template <class T> std::uint16_t write(const esc_register_of<T>& at, const T& value) {
        std::vector<std::byte> bytes(wire::max_size<T>);
        REQUIRE(wire::encode(value, bytes));
        return send(command::apwr, at.address, bytes).working_counter;
    }
    std::string read(std::uint16_t ado, std::size_t size) {
        return to_hex(send(command::aprd, ado, std::vector<std::byte>(size)).data);
    }
    template <class T> T read(const esc_register_of<T>& at) {
        const auto back = send(command::aprd, at.address, std::vector<std::byte>(wire::max_size<T>));
        REQUIRE(back.working_counter == 1);
        T value{};
        REQUIRE(wire::decode(value, back.data));
        return value;
    }
    std::string state(std::string_view control) {
        write(0x0120, control);
        return read(0x0130, 6);
    }
    void to_safe_op() {
        write(0x0800, "0010 0001 26 00 01 00 0016 0001 22 00 01 00");
        CHECK(state("0200") == "02 00 00 00 00 00");
        write(0x0810, "001c 0200 24 00 01 00");
        write(0x0600, "00000000 0200 00 07 001c 00 02 01 000000");
    }
    void pass(jauscat::duration time) { now += time; }

    test::objects objects{};
    standard_objects dictionary;
    slave device;
    jauscat::time_point now{};
};

constexpr slave_description clock_64{.vendor = 1, .clock = clock_width::bits_64};
constexpr slave_description clock_32{.vendor = 1, .clock = clock_width::bits_32};
constexpr slave_description synchronous{
    .vendor = 1, .outputs = one_word, .clock = clock_width::bits_64, .sync_missed_limit = 3};

} // namespace

TEST_CASE("a slave without a clock has zeros in the clock's registers") {
    clock_bench b{{.vendor = 1}};
    CHECK(b.read(0x0008, 2) == "00 00");
    b.pass(1ms);
    b.write(0x0900, "00");
    b.write(0x0981, "03");
    CHECK(b.read(0x0900, 256) == to_hex(std::vector<std::byte>(256)));
}

TEST_CASE("a clock says in the features what it can do") {
    CHECK(clock_bench{clock_64}.read(0x0008, 2) == "0c 01");
    CHECK(clock_bench{clock_32}.read(0x0008, 2) == "04 01");
}

TEST_CASE("the local time drifts by what is given") {
    clock_bench b{clock_64, {.drift = 100'000, .start = 1'000'000'000'000}};
    b.pass(10s);
    CHECK(b.read(esc_registers::dc_system_time).value / 10 == 101'000'099'999); // rounded down
    clock_bench slow{clock_64, {.drift = -100'000}};
    slow.pass(10s);
    CHECK(slow.read(esc_registers::dc_system_time).value / 10 == 999'900'000);
}

TEST_CASE("a write to 0x0900 stores local times of its own frame only") {
    clock_bench b{clock_64, {.start = 0x1'0000'0000}};
    b.pass(100ns);
    CHECK(b.write(0x0900, "00") == 1);
    b.device.frame_returned(1, b.now + 500ns);
    b.pass(1us);
    CHECK(b.read(0x0900, 16) == "64 00 00 00 58 02 00 00 00 00 00 00 00 00 00 00");
    b.device.frame_returned(1, b.now + 100ns); // of the read
    CHECK(b.read(0x0900, 8) == "64 00 00 00 58 02 00 00");
    CHECK(b.read(0x0918, 8) == "64 00 00 00 01 00 00 00");
    CHECK(b.write(0x0904, "00000000") == 1); // read only
    CHECK(b.read(0x0904, 4) == "58 02 00 00");
}

TEST_CASE(
    "the system time read is local time plus offset minus delay, and differences are compared with the low half") {
    clock_bench b{clock_64, {.start = 5'000}};
    CHECK(b.write(esc_registers::dc_offset, {-2'000}) == 1);
    CHECK(b.write(esc_registers::dc_delay, {300}) == 1);
    CHECK(b.read(esc_registers::dc_system_time).value == 2'700);
    CHECK(b.read(0x0920, 8) == "30 f8 ff ff ff ff ff ff");
    CHECK(b.write(0x0934, "00 0c") == 1); // no filter
    CHECK(b.write(0x0930, "0010") == 1);
    CHECK(b.write(0x0910, "c409000000000000") == 1); // 2500: the slave is 200 ahead
    CHECK(b.read(0x092C, 4) == "c8 00 00 00");
    CHECK(b.write(0x0910, "f00a0000") == 1); // 2800: 100 behind
    CHECK(b.read(0x092C, 4) == "64 00 00 80");
    CHECK(b.read(esc_registers::dc_system_time).value == 2'700); // not stored
    CHECK(b.write(0x0930, "0010") == 1);
    CHECK(b.read(0x092C, 8) == "00 00 00 00 00 10 00 00");
}

TEST_CASE("a clock of 32 bits has the low halves only") {
    clock_bench b{clock_32, {.start = 0xFFFF'FFFF}};
    b.pass(2ns);
    CHECK(b.write(0x0920, "01000000ffffffff") == 1);
    CHECK(b.read(0x0910, 8) == "02 00 00 00 00 00 00 00");
    CHECK(b.read(0x0920, 8) == "01 00 00 00 00 00 00 00");
}

TEST_CASE("the control follows received times from any difference, and shows the deviation of the period") {
    const auto drift = GENERATE(-100'000, 0, 100'000);
    const auto interval = GENERATE(50us, 1ms, 4ms);
    const auto ahead = GENERATE(-20'000, 0, 20'000);
    clock_bench b{clock_64, {.drift = drift, .start = 1'000'000}};
    b.write(0x0930, "0010");
    const auto reference = [&] {
        return static_cast<std::uint64_t>(b.now.time_since_epoch().count() + 1'000'000 - ahead);
    };
    int worst = 0;
    for (int i = 0; i != 15'000; ++i) {
        b.pass(interval);
        b.write(esc_registers::dc_system_time, {reference()});
        if (i >= 10'000) worst = std::max(worst, std::abs(b.read(esc_registers::dc_difference).value()));
    }
    CAPTURE(drift, interval.count(), ahead);
    CHECK(worst <= 2);
    const auto d = b.read(esc_registers::dc_speed_difference).value;
    const double speed = d / (5.0 * (4096 + d + 2) * (4096 - d + 2));
    CHECK(speed * 1e9 == Approx(-drift).margin(1'000));
}

TEST_CASE("SYNC0 comes at its start time and then in each cycle, by the system time") {
    clock_bench b{clock_64};
    b.write(esc_registers::dc_offset, {1'000'000'000});
    b.write(esc_registers::dc_start_time, {1'010'000'000});
    b.write(0x09A0, "40420f00 00000000"); // 1 ms
    CHECK(b.write(0x0981, "03") == 1);
    CHECK(b.read(0x0984, 1) == "01");
    b.pass(9'999'999ns);
    b.device.pass_time(b.now);
    CHECK(b.device.sync0_count() == 0);
    b.pass(1ns);
    b.device.pass_time(b.now);
    CHECK(b.device.sync0_count() == 1);
    CHECK(b.read(0x0984, 1) == "00");
    CHECK(b.read(esc_registers::dc_start_time).value == 1'011'000'000); // the next one
    b.pass(10ms);
    b.device.pass_time(b.now);
    CHECK(b.device.sync0_count() == 11);
    CHECK(b.write(0x0981, "00") == 1);
    b.pass(10ms);
    b.device.pass_time(b.now);
    CHECK(b.device.sync0_count() == 11);
}

TEST_CASE("a start time in the past waits for the time to wrap") {
    clock_bench wide{clock_64, {.start = 1'000'000}};
    wide.write(0x09A0, "40420f00");
    wide.write(0x0981, "03"); // start time 0
    CHECK(wide.read(0x0984, 1) == "05");
    wide.pass(10s);
    wide.device.pass_time(wide.now);
    CHECK(wide.device.sync0_count() == 0);

    clock_bench narrow{clock_32, {.start = 1'000'000}};
    narrow.write(0x0981, "03"); // once
    narrow.pass(4'294'967'295ns - 1ms);
    narrow.device.pass_time(narrow.now);
    CHECK(narrow.device.sync0_count() == 0);
    narrow.pass(1ns);
    narrow.device.pass_time(narrow.now);
    CHECK(narrow.device.sync0_count() == 1);

    clock_bench checked{clock_64, {.start = 1'000'000}};
    checked.write(0x0981, "23"); // a start time that is not near begins at once
    checked.device.pass_time(checked.now);
    CHECK(checked.device.sync0_count() == 1);
}

TEST_CASE("a SYNC1 later than SYNC0's cycle leaves SYNC0s out") {
    const auto count_of = [](std::uint32_t cycle, std::uint32_t delay) {
        slave_clock clock;
        clock.advance({});
        clock.activate({.on = true, .sync0 = true, .sync1 = true}, clock.system_time() + 1'000, cycle, delay,
                       clock_width::bits_64);
        const auto end = clock.system_time() + 1'000 + 9 * std::uint64_t{cycle};
        clock.advance(jauscat::time_point{jauscat::duration{static_cast<std::int64_t>(end)}});
        CHECK(clock.take_sync0() == 10);
        return clock.take_sync1();
    };
    CHECK(count_of(1'000'000, 0) == 10);
    CHECK(count_of(1'000'000, 100'000) == 9);
    CHECK(count_of(1'000'000, 1'000'000) == 5); // period 2 ms
    CHECK(count_of(1'000'000, 3'000'000) == 2); // period 4 ms
}

TEST_CASE("registers of the SYNC unit are the slave's while it is assigned to it") {
    clock_bench b{clock_64};
    b.write(0x0980, "01");
    b.write(0x09A0, "40420f00");
    b.write(0x0981, "03");
    b.write(0x0920, "01");
    CHECK(b.read(0x0980, 2) == "01 00");
    CHECK(b.read(0x09A0, 4) == "00 00 00 00");
    CHECK(b.read(0x0920, 1) == "00");
    b.write(0x0980, "0003"); // both at once: the activation is still the slave's
    b.write(0x0981, "03");
    CHECK(b.read(0x0980, 2) == "00 03");
}

TEST_CASE("a SYNC0 that finds old outputs is counted, and several in a row end OP") {
    clock_bench b{synchronous};
    b.to_safe_op();
    b.write(0x09A0, "40420f00");
    b.write(esc_registers::dc_start_time, {500'000});
    b.write(0x0981, "03");
    CHECK(b.state("0400") == "04 00 00 00 00 00");
    CHECK(b.state("0800") == "08 00 00 00 00 00");
    for (int i = 0; i != 10; ++i) {
        b.send(command::bwr, 0x1C00, from_hex("0102"));
        b.pass(1ms);
    }
    b.device.pass_time(b.now);
    CHECK(b.device.sync0_count() == 10);
    CHECK(b.device.sync_missed() == 0);
    b.pass(2ms); // two without outputs
    b.send(command::bwr, 0x1C00, from_hex("0102"));
    CHECK(b.device.sync_missed() == 2);
    b.pass(1ms);
    b.device.pass_time(b.now);
    CHECK(b.device.sync_missed() == 2);
    CHECK(b.device.state() == al_state::op);
    b.pass(3ms);
    CHECK(b.read(0x0130, 6) == "14 00 00 00 1a 00");
    CHECK(b.device.sync_missed() == 5);
}

TEST_CASE("objects 1C32h and 1C33h say how a slave is synchronized, and what it has missed") {
    auto description = synchronous;
    description.synchronization = true;
    clock_bench b{description};
    const auto read = [&](std::uint8_t subindex) {
        std::array<std::byte, 8> value{};
        const auto got = b.dictionary.read(0x1C32, subindex, value);
        CHECK(got.error == abort_code::none);
        return to_hex(std::span{value}.first(got.size));
    };
    CHECK(read(0) == "06");
    b.dictionary.show(b.device.synchronization());
    CHECK(read(0) == "20");
    CHECK(read(1) == "00 00");
    b.to_safe_op();
    b.write(0x09A0, "40420f00");
    b.write(esc_registers::dc_start_time, {500'000});
    b.write(0x0981, "03");
    b.state("0400");
    b.state("0800");
    b.send(command::bwr, 0x1C00, from_hex("0102"));
    b.pass(1ms);
    b.device.pass_time(b.now);
    CHECK(read(1) == "02 00");
    CHECK(read(2) == "40 42 0f 00");
    CHECK(read(10) == read(2));
    CHECK(read(4) == "0d 00");
    CHECK(read(11) == "00 00");
    CHECK(read(32) == "00");
    b.pass(2ms);
    b.device.pass_time(b.now);
    CHECK(read(11) == "02 00");
    CHECK(read(32) == "01");
    b.send(command::bwr, 0x1C00, from_hex("0102"));
    b.pass(1ms);
    b.device.pass_time(b.now);
    CHECK(read(11) == "02 00");
    CHECK(read(32) == "00");

    std::array<std::byte, 8> value{};
    CHECK(b.dictionary.read(0x1C32, 14, value).error == abort_code::no_subindex);
    CHECK(b.dictionary.read(0x1C33, 1, value).error == abort_code::no_object); // it has no inputs
    const auto flag = b.dictionary.describe(0x1C32, 32);
    REQUIRE(flag);
    CHECK(flag->name == "Sync error");
    CHECK(flag->data_type == data_types::boolean);
    CHECK(b.dictionary.describe(0x1C32, 11)->name == "SM event missed");
    CHECK(b.dictionary.describe(0x1C32)->highest_subindex == 32);
    CHECK(!b.dictionary.describe(0x1C32, 20));
}

TEST_CASE("a slave that needs SYNC0 refuses SAFE-OP without it, and OP before the first one") {
    auto description = synchronous;
    description.needs_sync = true;
    clock_bench b{description};
    b.to_safe_op();
    CHECK(b.state("0400") == "12 00 00 00 30 00");
    b.write(0x09A0, "40420f00");
    b.write(esc_registers::dc_start_time, {5'000'000});
    b.write(0x0981, "03");
    CHECK(b.state("1200") == "02 00 00 00 00 00");
    CHECK(b.state("0400") == "04 00 00 00 00 00");
    CHECK(b.state("0800") == "14 00 00 00 2d 00");
    b.pass(5ms);
    b.state("1400");
    CHECK(b.state("0800") == "08 00 00 00 00 00");
}

TEST_CASE("ports with a slave behind them are open") {
    clock_bench b{clock_64};
    CHECK(b.read(0x0110, 2) == "10 56");
    b.device.set_connected(1, true);
    CHECK(b.read(0x0110, 2) == "30 5a");
    b.device.set_connected(3, true);
    CHECK(b.read(0x0110, 2) == "b0 9a");
    CHECK(b.read(0x0007, 1) == "cf");
}
