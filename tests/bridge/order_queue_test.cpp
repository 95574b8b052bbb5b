// Messages that wait.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/bridge/order_queue.hpp>

using namespace std::chrono_literals;
using support::instant;
namespace bridging = jauscat::bridging;
namespace jaus = jauscat::jaus;

namespace {

constexpr jaus::address sender{.instance = 1, .component = 32, .node = 1, .subsystem = 1};

template <class T> std::vector<std::byte> body_of(const T& message) {
    std::vector<std::byte> body(256);
    const auto encoded = jauscat::wire::encode(message, body);
    REQUIRE(encoded);
    body.resize(encoded->size());
    return body;
}
bridging::order order_of(std::uint16_t code, std::uint16_t number, const jaus::address& from = sender) {
    return {.header = {.command_code = code, .source = from, .sequence_number = number},
            .expires = jauscat::deadline{instant{1s}}};
}
constexpr auto nobody = [](const jaus::header&) { FAIL("nothing is superseded"); };
constexpr auto any = [](const bridging::order&) { return true; };

} // namespace

TEST_CASE("messages leave in order of arrival, and places are reused") {
    bridging::order_memory<4, 64> memory;
    bridging::order_queue queue{memory};
    std::uint16_t in = 0, out = 0;
    const auto body = body_of(jaus::set_global_waypoint{});
    for (int round = 0; round != 10; ++round) {
        for (int i = 0; i != 3; ++i)
            CHECK(queue.push(order_of(jaus::command_code_of<jaus::set_global_waypoint>, ++in), body, nobody) ==
                  bridging::queued::last);
        while (const auto* const next = queue.first(any)) {
            CHECK(next->header.sequence_number == ++out);
            CHECK(std::ranges::equal(queue.body(*next), body));
            queue.remove(*next);
        }
    }
    CHECK(out == in);
}

TEST_CASE("a full queue, and a body that exceeds its place, are refused") {
    bridging::order_memory<2, 8> memory;
    bridging::order_queue queue{memory};
    const std::array<std::byte, 9> large{};
    const auto small = std::span<const std::byte>{large}.first(8);
    CHECK(queue.push(order_of(2, 1), large, nobody) == bridging::queued::too_large);
    CHECK(queue.push(order_of(2, 1), small, nobody) == bridging::queued::last);
    CHECK(queue.push(order_of(2, 2), small, nobody) == bridging::queued::last);
    CHECK(queue.push(order_of(2, 3), small, nobody) == bridging::queued::full);
}

TEST_CASE("places that are reserved for others stay free") {
    bridging::order_memory<3, 8> memory;
    bridging::order_queue queue{memory};
    const std::array<std::byte, 8> body{};
    CHECK(queue.push(order_of(2, 1), body, nobody, 2) == bridging::queued::last);
    CHECK(queue.push(order_of(2, 2), body, nobody, 2) == bridging::queued::full);
    CHECK(queue.push(order_of(2, 2), body, nobody, 1) == bridging::queued::last);
    CHECK(queue.push(order_of(2, 3), body, nobody) == bridging::queued::last);
    CHECK(queue.size() == 3);
}

TEST_CASE("a newer command of the same sender replaces the older one and keeps its other fields") {
    bridging::order_memory<4, 64> memory;
    bridging::order_queue queue{memory};
    const auto code = jaus::command_code_of<jaus::set_wrench_effort>;
    auto other = sender;
    other.node = 7;
    CHECK(
        queue.push(order_of(code, 1),
                   body_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 10, .propulsive_linear_effort_y = 20}),
                   nobody) == bridging::queued::last);
    CHECK(queue.push(order_of(code, 2, other), body_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 1}),
                     nobody) == bridging::queued::last);
    std::uint16_t superseded = 0;
    CHECK(queue.push(order_of(code, 3), body_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 30}),
                     [&](const jaus::header& older) { superseded = older.sequence_number; }) ==
          bridging::queued::merged);
    CHECK(superseded == 1);
    CHECK(queue.size() == 2);
    const auto* const first = queue.first(any);
    REQUIRE(first != nullptr);
    CHECK(first->header.sequence_number == 3);
    CHECK(std::ranges::equal(queue.body(*first), body_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 30,
                                                                                 .propulsive_linear_effort_y = 20})));
}

TEST_CASE("waypoints are never merged") {
    bridging::order_memory<4, 64> memory;
    bridging::order_queue queue{memory};
    const auto body = body_of(jaus::set_global_waypoint{});
    for (std::uint16_t i = 1; i != 4; ++i)
        CHECK(queue.push(order_of(jaus::command_code_of<jaus::set_global_waypoint>, i), body, nobody) ==
              bridging::queued::last);
    CHECK(queue.size() == 3);
}

TEST_CASE("a command that does not decode is queued unchanged, for the slave to refuse") {
    bridging::order_memory<4, 64> memory;
    bridging::order_queue queue{memory};
    const std::array<std::byte, 3> bad{std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}};
    const auto code = jaus::command_code_of<jaus::set_wrench_effort>;
    CHECK(queue.push(order_of(code, 1), bad, nobody) == bridging::queued::last);
    CHECK(queue.push(order_of(code, 2), body_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 1}), nobody) ==
          bridging::queued::last);
    CHECK(queue.size() == 2);
}
