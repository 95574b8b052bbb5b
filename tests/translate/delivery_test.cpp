// What crosses the EtherCAT wire of a message, and the message that a slave makes of it.
#include "samples.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/delivery.hpp>

using namespace jauscat;
using namespace jauscat::test;
using translate::errc;

namespace {

using seed_delivery = bridging::delivery<translation::seed_table>;
using self_contained_delivery = bridging::delivery<translation::self_contained_table>;

/// Who the sample's slave is, and somebody else at the same station.
constexpr bridging::slave_identity addressee{.subsystem = 1, .station = 2, .instance = 5};
constexpr bridging::slave_identity stranger{.subsystem = 200, .station = 2, .instance = 100};

template <class Delivery>
outcome message_of(const bridging::object_access& object, const bridging::slave_identity& self) {
    std::vector<std::byte> out(Delivery::translator::max_message_size);
    const auto result = Delivery::message_of(object, self, out);
    return outcome_of(result, std::move(out));
}
template <class Delivery> outcome delivered(std::span<const std::byte> message, const bridging::slave_identity& self) {
    const auto packet = to_packet<typename Delivery::translator>(message).bytes;
    return message_of<Delivery>(Delivery::object_of(packet), self);
}

std::vector<std::byte> with_flag(unsigned flag) {
    auto message = vector_of(wrench_effort);
    message[13] = static_cast<std::byte>(flag << 4);
    return message;
}

} // namespace

TEST_CASE("under the seed table station, index, subindex and 28 bytes are sent") {
    const auto object = seed_delivery::object_of(wrench_effort_seed);
    CHECK(object.station == 2);
    CHECK(object.index == 6933);
    CHECK(object.subindex == 26);
    CHECK(to_hex(object.data) == to_hex(std::span{wrench_effort_seed}.subspan(56)));
}

TEST_CASE("under the self-contained table station, index, subindex and 32 bytes are sent") {
    const auto object = self_contained_delivery::object_of(wrench_effort_self_contained);
    CHECK(object.station == 2);
    CHECK(object.index == 6933);
    CHECK(object.subindex == 26);
    CHECK(to_hex(object.data) == to_hex(std::span{wrench_effort_self_contained}.subspan(56)));
}

TEST_CASE("a packet without its fields has no object") {
    const auto object = seed_delivery::object_of(std::span{wrench_effort_seed}.first(55));
    CHECK(object.index == 0);
    CHECK(object.data.empty());
}

TEST_CASE("under the seed table the addressed slave restores the message") {
    CHECK(to_hex(delivered<seed_delivery>(wrench_effort, addressee).bytes) == to_hex(wrench_effort));
}

TEST_CASE("under the seed table only subsystem and instance are the slave's") {
    auto expected = vector_of(wrench_effort);
    expected[4] = std::byte{100};
    expected[7] = std::byte{200};
    CHECK(to_hex(delivered<seed_delivery>(wrench_effort, stranger).bytes) == to_hex(expected));
}

TEST_CASE("under the seed table the data flag is not sent, so a message with one is not delivered") {
    for (const unsigned flag : {1u, 2u, 4u, 8u}) {
        const auto message = with_flag(flag);
        jaus::header head{};
        REQUIRE(wire::decode_prefix(head, message));
        CHECK(seed_delivery::deliverable(head) == errc::fragment_to_slave);
        CHECK(to_hex(delivered<seed_delivery>(message, addressee).bytes) == to_hex(wrench_effort));
    }
}

TEST_CASE("under the self-contained table every slave restores every message") {
    for (const unsigned flag : {0u, 1u, 2u, 4u, 8u})
        for (const auto& self : {addressee, stranger, bridging::slave_identity{}}) {
            const auto message = with_flag(flag);
            CHECK(to_hex(delivered<self_contained_delivery>(message, self).bytes) == to_hex(message));
        }
}

TEMPLATE_TEST_CASE("messages of every body size are delivered completely", "", seed_delivery, self_contained_delivery) {
    for (std::size_t size = 0; size <= TestType::translator::max_body; size += size < 40 ? 1 : 97) {
        const auto message = message_with_body(size);
        REQUIRE(to_hex(delivered<TestType>(message, addressee).bytes) == to_hex(message));
    }
}

TEMPLATE_TEST_CASE("an object without a message is refused", "", seed_delivery, self_contained_delivery) {
    const std::vector<std::byte> packet = to_packet<typename TestType::translator>(wrench_effort).bytes;
    const auto object = TestType::object_of(packet);
    const auto refused = [&](auto change) {
        auto changed = object;
        change(changed);
        return message_of<TestType>(changed, addressee).error;
    };
    CHECK(refused([](auto&) {}) == errc::ok);
    CHECK(refused([](auto& o) { o.station = 0x1001; }) == errc::out_of_range);
    CHECK(refused([](auto& o) { o.index = 6899; }) == errc::unknown_index);
    CHECK(refused([](auto& o) { o.index = 7156; }) == errc::unknown_index);
    CHECK(refused([](auto& o) { o.subindex = 0; }) == errc::unknown_subindex);
    CHECK(refused([](auto& o) { o.subindex = 159; }) == errc::unknown_subindex);
    CHECK(refused([](auto& o) { o.subindex = 255; }) == errc::unknown_subindex);
    CHECK(refused([](auto& o) { o.data = {}; }) == errc::truncated);
    CHECK(refused([](auto& o) { o.data = o.data.first(TestType::translator::rest_size - 1); }) == errc::truncated);

    std::array<std::byte, wrench_effort.size()> out{};
    CHECK(TestType::message_of(object, addressee, out).error() == errc::ok);
    CHECK(TestType::message_of(object, addressee, std::span{out}.first(out.size() - 1)).error() == errc::no_space);
}

TEST_CASE("a self-contained object of the wrong size is refused, since its header states the size") {
    const auto object = self_contained_delivery::object_of(wrench_effort_self_contained);
    auto cut = object;
    cut.data = cut.data.first(cut.data.size() - 1);
    CHECK(message_of<self_contained_delivery>(cut, addressee).error == errc::wrong_size);
}

TEST_CASE("a slave restores its message in a constant expression") {
    constexpr auto message = [] {
        // A copy: under its sanitizers g++ 12 takes no address of a global variable in a constant expression.
        const auto packet = wrench_effort_seed;
        std::array<std::byte, wrench_effort.size()> out{};
        const auto result = seed_delivery::message_of(seed_delivery::object_of(packet), addressee, out);
        return result ? out : decltype(out){};
    }();
    STATIC_REQUIRE(message == wrench_effort);
}
