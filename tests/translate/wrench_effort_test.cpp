// The example of the seed: Set Wrench Effort with all twelve elements, to the byte.
#include "samples.hpp"
#include "support/catch.hpp"
#include <jauscat/schema/jaus/platform.hpp>

using namespace jauscat;
using namespace jauscat::test;

namespace {

// By value: under its sanitizers g++ 12 takes no address of a global variable in a constant expression.
template <class Translator, std::size_t Size> constexpr auto packet_of(std::array<std::byte, Size> message) {
    std::array<std::byte, Translator::packet_size + Translator::rest_size + Size - Translator::header_size> out{};
    const auto result = Translator::to_packet(message, out);
    return result && result->size() == out.size() ? out : decltype(out){};
}
template <class Translator, std::size_t Size> constexpr bool is_packet_of(std::array<std::byte, Size> bytes) {
    std::array<std::byte, wrench_effort.size()> out{};
    const auto result = Translator::from_packet(bytes, out);
    return result && result->size() == out.size() && out == wrench_effort;
}

} // namespace

TEST_CASE("the sample message is Set Wrench Effort with all twelve elements") {
    jaus::set_wrench_effort body{};
    REQUIRE(wire::decode(body, std::span{wrench_effort}.subspan(16)));
    CHECK(body.propulsive_linear_effort_x == 100.0);
    CHECK(body.propulsive_linear_effort_y == -100.0);
    CHECK(body.resistive_rotational_effort_z == 60.0);
}

TEST_CASE("Set Wrench Effort is translated to the seed table's packet in a constant expression, and back") {
    STATIC_REQUIRE(packet_of<seed>(wrench_effort) == wrench_effort_seed);
    STATIC_REQUIRE(is_packet_of<seed>(wrench_effort_seed));
}

TEST_CASE("Set Wrench Effort is translated to the self-contained table's packet in a constant expression, and back") {
    STATIC_REQUIRE(packet_of<self_contained>(wrench_effort) == wrench_effort_self_contained);
    STATIC_REQUIRE(is_packet_of<self_contained>(wrench_effort_self_contained));
}

TEST_CASE("Set Wrench Effort is translated to the seed table's packet, and back") {
    const auto there = to_packet<seed>(wrench_effort);
    CHECK(to_hex(there.bytes) == to_hex(wrench_effort_seed));
    CHECK(to_hex(from_packet<seed>(there.bytes).bytes) == to_hex(wrench_effort));
}

TEST_CASE("Set Wrench Effort is translated to the self-contained table's packet, and back") {
    const auto there = to_packet<self_contained>(wrench_effort);
    CHECK(to_hex(there.bytes) == to_hex(wrench_effort_self_contained));
    CHECK(to_hex(from_packet<self_contained>(there.bytes).bytes) == to_hex(wrench_effort));
}

TEST_CASE("the numbers of the paper hold: 28 bytes of data, length 44, index 6933 or 6938, subindex 26") {
    auto message = vector_of(wrench_effort);
    const auto to_primitive_driver = to_packet<seed>(message).bytes;
    REQUIRE(to_primitive_driver.size() == 56 + 28);
    CHECK(get(to_primitive_driver, word::ul_data_cnt) == 28);
    CHECK(get(to_primitive_driver, word::ul_len) == 44);
    CHECK(get(to_primitive_driver, word::ul_index) == 6933);
    CHECK(get(to_primitive_driver, word::ul_sub_index) == 26);

    message[5] = std::byte{38};
    const auto to_global_pose_sensor = to_packet<seed>(message).bytes;
    REQUIRE(to_global_pose_sensor.size() == 56 + 28);
    CHECK(get(to_global_pose_sensor, word::ul_index) == 6938);
}

TEST_CASE("a translator has the expected sizes") {
    STATIC_REQUIRE(seed::rest_size == 8);
    STATIC_REQUIRE(seed::max_body == 1532);
    STATIC_REQUIRE(self_contained::rest_size == 12);
    STATIC_REQUIRE(self_contained::max_body == 1528);
    STATIC_REQUIRE(seed::max_packet_size == 1596);
    STATIC_REQUIRE(seed::max_message_size == 1548);
}
