// Start-up objects of an axis: the period as 60C2h, the mode where it is not in the process data.
#include "support/catch.hpp"
#include <jauscat/ethercat/cia402/start_up.hpp>

using namespace jauscat;
using namespace std::chrono_literals;
using cia402::interpolation_period;
using cia402::interpolation_period_of;

TEST_CASE("60C2h has a period in milliseconds, or in powers of ten below") {
    STATIC_REQUIRE(interpolation_period_of(1ms) == interpolation_period{1, -3});
    STATIC_REQUIRE(interpolation_period_of(20ms) == interpolation_period{20, -3});
    STATIC_REQUIRE(interpolation_period_of(250us) == interpolation_period{25, -5});
    STATIC_REQUIRE(interpolation_period_of(125us) == interpolation_period{125, -6});
    STATIC_REQUIRE(interpolation_period_of(62'500ns) == std::nullopt); // 625 x 10^-7 s
    STATIC_REQUIRE(interpolation_period_of(1s) == interpolation_period{100, -2});
    STATIC_REQUIRE(interpolation_period_of(255s) == interpolation_period{255, 0});
    STATIC_REQUIRE(interpolation_period_of(0ms) == std::nullopt);
    STATIC_REQUIRE(interpolation_period_of(-1ms) == std::nullopt);
    STATIC_REQUIRE(interpolation_period_of(333us) == std::nullopt);
}

TEST_CASE("60C2h has a period of more than 255 ms in tenths of a second or more") {
    const auto is = [](duration cycle, std::optional<interpolation_period> expected) {
        CAPTURE(cycle.count());
        CHECK(interpolation_period_of(cycle) == expected);
    };
    is(250ms, interpolation_period{250, -3});
    is(260ms, interpolation_period{26, -2});
    is(1s, interpolation_period{100, -2});
    is(2560ms, std::nullopt); // 256 x 10^-2 s
    is(25'500ms, interpolation_period{255, -1});
    is(255s, interpolation_period{255, 0});
    is(0ms, std::nullopt);
    is(-1ms, std::nullopt);
}

TEST_CASE("the start-up objects of an axis are 60C2h, and 6060h where it is not mapped") {
    const auto mapped = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs);
    const cia402::axis_start_up first{2ms, mapped};
    REQUIRE(first.values().size() == 2);
    CHECK(first.values()[0].index == 0x60C2);
    CHECK(first.values()[0].subindex == 1);
    CHECK(first.values()[0].data[0] == std::byte{2});
    CHECK(first.values()[1].data[0] == std::byte{0xFD});
    auto fixed = mapped;
    fixed.mode = {};
    fixed.fixed_mode = cia402::mode::cyclic_synchronous_velocity;
    const cia402::axis_start_up second{2ms, fixed, 1};
    REQUIRE(second.values().size() == 3);
    CHECK(second.values()[0].index == 0x68C2);
    CHECK(second.values()[2].index == 0x6860);
    CHECK(second.values()[2].data[0] == std::byte{9});
    fixed.fixed_mode = cia402::mode::none; // it stays in the one that it has
    CHECK(cia402::axis_start_up{2ms, fixed, 1}.values().size() == 2);
}
