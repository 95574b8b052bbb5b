// Objects in process data: places, padding, any bit, signs.
#include "support/catch.hpp"
#include <jauscat/ethercat/cia402/axis_places.hpp>

#include <array>

using namespace jauscat::cia402;

namespace {

template <std::size_t Size> constexpr std::array<std::byte, Size> filled(unsigned value) {
    std::array<std::byte, Size> bytes{};
    bytes.fill(static_cast<std::byte>(value));
    return bytes;
}

} // namespace

TEST_CASE("the usual process data have their places at compile time") {
    constexpr auto places = places_of(cyclic_outputs, cyclic_inputs);
    STATIC_REQUIRE(cyclic_outputs.size() == 14);
    STATIC_REQUIRE(cyclic_inputs.size() == 16);
    STATIC_REQUIRE(places.target_position == pdo_place{32, 32, 0, 0x607A});
    STATIC_REQUIRE(places.torque == pdo_place{96, 16, 0, 0x6077});
    STATIC_REQUIRE(!places.profile_velocity.is_mapped());
    STATIC_REQUIRE(places.missing_for(mode::cyclic_synchronous_torque) == nullptr);
}

TEST_CASE("targets go out and feedback comes in byte by byte") {
    constexpr auto places = places_of(cyclic_outputs, cyclic_inputs);
    std::array<std::byte, 14> outputs = filled<14>(0xEE);
    places.store({.controlword = 0x010F,
                  .mode = mode::cyclic_synchronous_velocity,
                  .position = -2,
                  .velocity = 0x12345678,
                  .torque = -1000},
                 outputs);
    const std::array<unsigned, 14> expected{0x0F, 0x01, 9,    0xEE, 0xFE, 0xFF, 0xFF,
                                            0xFF, 0x78, 0x56, 0x34, 0x12, 0x18, 0xFC};
    for (std::size_t i = 0; i != outputs.size(); ++i) CHECK(std::to_integer<unsigned>(outputs[i]) == expected[i]);

    const auto feedback = places.load(filled<16>(0xFF));
    CHECK(feedback == axis_feedback{.statusword = 0xFFFF,
                                    .mode = mode{-1},
                                    .position = -1,
                                    .velocity = -1,
                                    .torque = -1,
                                    .error_code = 0xFFFF});
}

TEST_CASE("a layout read from a drive has padding, odd widths and several axes") {
    pdo_layout<16> outputs;
    for (const std::uint32_t entry : {0x60400010u, 0x00000003u, 0x607A0020u, 0x60600010u, 0x68400010u, 0x68FF0020u})
        REQUIRE(outputs.append(mapping_of(entry)));
    CHECK(outputs.find(objects::target_position) == pdo_place{19, 32, 0, 0x607A});
    CHECK(outputs.find(objects::mode_of_operation) == pdo_place{51, 16, 0, 0x6060}); // wider than the object
    CHECK(outputs.find(objects::controlword, 1) == pdo_place{67, 16, 0, 0x6840});
    CHECK(outputs.find(objects::target_velocity, 1) == pdo_place{83, 32, 0, 0x68FF});
    CHECK(!outputs.find(objects::target_velocity).is_mapped());
    CHECK(!outputs.find(0, 0).is_mapped());
    CHECK(outputs.size() == 15);

    auto image = filled<15>(0xFF);
    const auto position = outputs.find(objects::target_position);
    store(position, image, std::int32_t{-123'456'789});
    CHECK(load<std::int32_t>(position, image) == -123'456'789);
    store(position, image, std::int32_t{0});
    for (std::size_t bit = 0; bit != image.size() * 8; ++bit)
        CHECK(((std::to_integer<unsigned>(image[bit / 8]) >> (bit % 8)) & 1) == (bit < 19 || bit >= 51 ? 1u : 0u));
    store(outputs.find(objects::mode_of_operation), image, std::int8_t{-3});
    CHECK(load<mode>(outputs.find(objects::mode_of_operation), image) == mode{-3});
}

TEST_CASE("an image that is too short is not read or written outside") {
    std::array<std::byte, 3> image{};
    store(pdo_place{8, 32}, image, 0x11111111);
    CHECK(image == std::array<std::byte, 3>{});
    CHECK(load<std::int32_t>(pdo_place{8, 32}, filled<3>(0xFF)) == 0);
    CHECK(load<std::uint16_t>(pdo_place{8, 16}, filled<3>(0xFF)) == 0xFFFF);
}

TEST_CASE("a layout refuses entries beyond its capacity") {
    pdo_layout<1> layout;
    CHECK(layout.append(padding(8)));
    CHECK(!layout.append(padding(8)));
    CHECK(layout.size() == 1);
}

TEST_CASE("the object that a mode lacks is named") {
    constexpr pdo_layout<4> outputs{mapping_of(objects::controlword), mapping_of(objects::target_position)};
    constexpr pdo_layout<4> inputs{mapping_of(objects::statusword), mapping_of(objects::position_actual)};
    auto places = places_of(outputs, inputs);
    REQUIRE(places.missing_for(mode::cyclic_synchronous_position) != nullptr);
    CHECK(places.missing_for(mode::cyclic_synchronous_position)->index == 0x6060);
    CHECK(axis_places{}.missing_for(mode::cyclic_synchronous_position) == &objects::controlword);
    places.fixed_mode = mode::cyclic_synchronous_position;
    CHECK(places.missing_for(mode::cyclic_synchronous_position) == nullptr);
    CHECK(places.load(filled<6>(0)).mode == mode::cyclic_synchronous_position);
    places.fixed_mode = mode::cyclic_synchronous_velocity;
    CHECK(places.missing_for(mode::cyclic_synchronous_velocity)->name == "Target velocity");
    constexpr pdo_layout<4> velocity{mapping_of(objects::controlword), mapping_of(objects::target_velocity)};
    const auto blind = places_of(velocity, inputs);
    for (const auto each : {mode::profile_velocity, mode::cyclic_synchronous_velocity}) {
        auto fixed = blind;
        fixed.fixed_mode = each;
        REQUIRE(fixed.missing_for(each) != nullptr);
        CHECK(fixed.missing_for(each)->index == 0x606C);
    }
}
