// Joint messages and drive objects: units, limits, zeros, both directions, wrong sizes.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/cia402/pdo_layout.hpp>
#include <jauscat/schema/translation/joint_tables.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace jauscat;
using namespace jauscat::translation;
using translate::object_translator;

namespace {

constexpr std::size_t joints = 2;
using positions = object_translator<set_joint_positions_table<joints>>;
using velocities = object_translator<set_joint_velocities_table<joints>>;
using efforts = object_translator<set_joint_efforts_table<joints>>;

// A gear of 100 and an encoder of 2^17, against the joint's direction, zero at 5000; and a plain one.
constexpr std::array<joint_scale, joints> scales{
    joint_scale{.increments_per_radian = 131072 * 100 / (2 * jaus::pi), .zero = 5000, .reversed = true},
    joint_scale{.increments_per_radian = 1000,
                .full_effort = 2000,
                .min_position = -1500,
                .max_position = 1500,
                .max_velocity = 2000,
                .max_torque = 900}};

struct result_of {
    std::vector<std::int64_t> values{};
    std::uint16_t index{};
    translate::axis_bits limited{};
    translate::errc error{};
};
template <class Translator, class Message> result_of translated(const Message& message) {
    std::array<std::byte, 64> body{};
    const auto encoded = wire::encode(message, body);
    REQUIRE(encoded);
    result_of found;
    const auto outcome =
        Translator::to_objects(*encoded, scales, [&](std::size_t axis, const auto& object, auto value) {
            CHECK(axis == found.values.size());
            found.index = object.index;
            found.values.push_back(value);
        });
    found.error = outcome.error();
    found.limited = outcome.value_or(0);
    return found;
}

} // namespace

TEST_CASE("joint positions become target positions in increments") {
    const auto found = translated<positions>(jaus::basic_set_joint_positions<8>{.joint_position = {1.0, -1.0}});
    CHECK(found.index == 0x607A);
    CHECK(found.values == std::vector<std::int64_t>{5000 - 2'086'076, -1000}); // 13,107,200 / 2 pi
    CHECK(found.limited == 0);
    const auto limited = translated<positions>(jaus::basic_set_joint_positions<8>{.joint_position = {0.0, 2.0}});
    CHECK(limited.values == std::vector<std::int64_t>{5000, 1500});
    CHECK(limited.limited == 2);
}

TEST_CASE("joint velocities become target velocities, and the step around 0 is 0") {
    const auto found = translated<velocities>(jaus::basic_set_joint_velocities<8>{.joint_velocity = {0.5, 3.0}});
    CHECK(found.index == 0x60FF);
    CHECK(found.values == std::vector<std::int64_t>{-1'043'038, 2000});
    CHECK(found.limited == 2);
    for (const char* const zero : {"02 FFFFFF7F FFFFFF7F", "02 00000080 00000080"}) {
        std::vector<std::int64_t> values;
        const auto bytes = test::from_hex(zero);
        REQUIRE(velocities::to_objects(bytes, scales,
                                       [&](std::size_t, const auto&, auto value) { values.push_back(value); }));
        CHECK(values == std::vector<std::int64_t>{0, 0});
    }
}

TEST_CASE("joint efforts become per mille of the rated torque") {
    const auto found = translated<efforts>(jaus::basic_set_joint_efforts<8>{.joint_effort = {50.0, -100.0}});
    CHECK(found.index == 0x6071);
    CHECK(found.values == std::vector<std::int64_t>{-500, -900}); // -2000 is beyond max_torque
    CHECK(found.limited == 2);
    const auto zero = translated<efforts>(jaus::basic_set_joint_efforts<8>{.joint_effort = {0.0, 0.0}});
    CHECK(zero.values == std::vector<std::int64_t>{0, 0});
}

TEST_CASE("a message for another number of joints is rejected as a whole") {
    CHECK(translated<positions>(jaus::basic_set_joint_positions<8>{.joint_position = {1.0}}).error ==
          translate::errc::wrong_size);
    const auto three = translated<positions>(jaus::basic_set_joint_positions<8>{.joint_position = {1.0, 1.0, 1.0}});
    CHECK(three.error == translate::errc::wrong_size);
    CHECK(three.values.empty());
    const auto none = translated<positions>(jaus::basic_set_joint_positions<8>{});
    CHECK(none.error == translate::errc::wrong_size);
    const auto cut = test::from_hex("02 FFFFFF7F FFFF");
    CHECK(positions::to_objects(cut, scales, [](auto...) { FAIL("called"); }).error() == translate::errc::truncated);
    const auto longer = test::from_hex("02 FFFFFF7F FFFFFF7F 00");
    CHECK(positions::to_objects(longer, scales, [](auto...) { FAIL("called"); }).error() ==
          translate::errc::wrong_size);
}

TEST_CASE("a value beyond the object's type is limited to it") {
    constexpr std::array<joint_scale, joints> fine{joint_scale{.increments_per_radian = 1e9},
                                                   joint_scale{.increments_per_radian = 1e9}};
    std::array<std::byte, 64> body{};
    const auto encoded = wire::encode(jaus::basic_set_joint_positions<2>{.joint_position = {20.0, -20.0}}, body);
    REQUIRE(encoded);
    std::vector<std::int64_t> values;
    const auto limited =
        positions::to_objects(*encoded, fine, [&](std::size_t, const auto&, auto value) { values.push_back(value); });
    REQUIRE(limited);
    CHECK(*limited == 3);
    CHECK(values == std::vector<std::int64_t>{2147483647, -2147483648LL});
}

TEST_CASE("reports are made of actual values, within the range of the message") {
    std::array<std::byte, 64> body{};
    const auto report = [&]<class Table>(std::int32_t first, std::int32_t second, std::uint16_t index) {
        const auto written = object_translator<Table>::from_objects(
            [&](std::size_t axis, const auto& object) {
                CHECK(object.index == index);
                return axis == 0 ? first : second;
            },
            scales, body);
        REQUIRE(written);
        typename Table::message_type message{};
        REQUIRE(wire::decode(message, *written));
        return message;
    };
    const auto position = report.operator()<report_joint_positions_table<joints>>(5000 - 2'086'076, 1'000'000, 0x6064);
    CHECK(position.joint_position[0] == Approx(1.0).margin(1e-6));
    CHECK(position.joint_position[1] == Approx(8 * jaus::pi).margin(1e-6)); // 1000 rad is beyond the range
    const auto velocity = report.operator()<report_joint_velocities_table<joints>>(-1'043'038, 500, 0x606C);
    CHECK(velocity.joint_velocity[0] == Approx(0.5).margin(1e-6));
    CHECK(velocity.joint_velocity[1] == Approx(0.5).margin(1e-6));
    const auto effort = report.operator()<report_joint_efforts_table<joints>>(-500, 400, 0x6077);
    CHECK(effort.joint_effort[0] == Approx(50).margin(0.01));
    CHECK(effort.joint_effort[1] == Approx(20).margin(0.01));

    CHECK(object_translator<report_joint_efforts_table<1>>::from_objects([](auto...) { return 0; }, scales, body)
              .error() == translate::errc::wrong_size);
    CHECK(object_translator<report_joint_efforts_table<2>>::from_objects([](auto...) { return 0; }, scales,
                                                                         std::span{body}.first(3))
              .error() == translate::errc::no_space);
}

TEST_CASE("a table writes the targets of all axes into process data") {
    constexpr cia402::pdo_layout<4> layout{cia402::mapping_of(cia402::objects::target_torque),
                                           cia402::mapping_of(cia402::objects::target_torque, 1)};
    std::array<std::byte, 4> image{};
    const auto body = test::from_hex("02 FFFF 0000"); // 100 %, -100 %
    REQUIRE(efforts::to_objects(body, scales, [&](std::size_t axis, const auto& object, auto value) {
        cia402::store(layout.find(object, axis), image, value);
    }));
    CHECK(test::to_hex(image) == test::to_hex(test::from_hex("18FC 7CFC"))); // -1000, -900
}

TEST_CASE("parameters of a joint are checked") {
    STATIC_REQUIRE(is_valid(joint_scale{}));
    STATIC_REQUIRE(!is_valid(joint_scale{.increments_per_radian = 0}));
    STATIC_REQUIRE(!is_valid(joint_scale{.increments_per_radian = std::numeric_limits<double>::quiet_NaN()}));
    STATIC_REQUIRE(!is_valid(joint_scale{.min_position = 5, .max_position = 5}));
    STATIC_REQUIRE(!is_valid(joint_scale{.max_torque = -1}));
}

TEST_CASE("a conversion that gives no number is refused before any object is written") {
    constexpr std::array<joint_scale, joints> unknown{
        joint_scale{}, joint_scale{.increments_per_radian = std::numeric_limits<double>::quiet_NaN()}};
    std::array<std::byte, 64> body{};
    const auto encoded = wire::encode(jaus::basic_set_joint_positions<8>{.joint_position = {1.0, -1.0}}, body);
    REQUIRE(encoded);
    int calls = 0;
    const auto outcome = positions::to_objects(*encoded, unknown, [&](auto...) { ++calls; });
    CHECK(outcome.error() == translate::errc::out_of_range);
    CHECK(calls == 0);
}
