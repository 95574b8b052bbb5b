// Random messages of every type of the SAE services, encoded and decoded by their entries.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/random_message.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/core.hpp>
#include <jauscat/schema/sae/environment_sensing.hpp>
#include <jauscat/schema/sae/manipulator.hpp>
#include <jauscat/schema/sae/mobility.hpp>
#include <jauscat/schema/sae/ugv.hpp>

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using jauscat::test::to_hex;

constexpr int rounds = 10'000;

/// A random message in its entry's form; its lists are in `lists`.
template <wire::message T>
catalogue::any_message random_of(const catalogue::entry& type, support::generator& g,
                                 std::pmr::memory_resource& lists) {
    auto made = catalogue::any_message::made_by(type, 0, [&](void* object, wire::arena&) {
        *static_cast<T*>(object) = support::random_message<T>(g, lists, {.exact = true});
        return jauscat::result<void, text::error>{};
    });
    return *std::move(made);
}

template <wire::message T> void come_back() {
    const auto* const type = catalogue::sae().find(T::schema::message_id);
    REQUIRE(type != nullptr);
    support::generator g{T::schema::message_id};
    std::pmr::unsynchronized_pool_resource pool;
    for (int round = 0; round != rounds; ++round) {
        std::pmr::monotonic_buffer_resource lists{&pool};
        const auto message = random_of<T>(*type, g, lists);
        const auto bytes = message.encode();
        if (!bytes) FAIL(type->name() << " in round " << round << ": " << wire::describe(bytes.error()));
        const auto again = type->decode(*bytes);
        if (!again || !(*static_cast<const T*>(again->object()) == *static_cast<const T*>(message.object())) ||
            *again->encode() != *bytes)
            FAIL(type->name() << " in round " << round << ": " << to_hex(*bytes));
        if (round % 100 != 0) continue;
        if (!type->diagnose(*bytes)) FAIL(type->name() << ": diagnose refuses " << to_hex(*bytes));
        const auto read = catalogue::from_json(*type, catalogue::to_json(*again));
        if (!read || *read->encode() != *bytes) FAIL(type->name() << ": JSON of " << to_hex(*bytes));
    }
}

template <class... Messages> std::size_t all_come_back(jaus::message_list<Messages...>) {
    (come_back<Messages>(), ...);
    return sizeof...(Messages);
}

} // namespace

TEST_CASE("10,000 random messages of each type of the core set come back") {
    CHECK(all_come_back(jauscat::sae::core::messages{}) > 40);
}
TEST_CASE("10,000 random messages of each type of the mobility set come back") {
    CHECK(all_come_back(jauscat::sae::mobility::messages{}) > 40);
}
TEST_CASE("10,000 random messages of each type of the environment sensing set come back") {
    CHECK(all_come_back(jauscat::sae::environment_sensing::messages{}) > 40);
}
TEST_CASE("10,000 random messages of each type of the manipulator set come back") {
    CHECK(all_come_back(jauscat::sae::manipulator::messages{}) > 40);
}
TEST_CASE("10,000 random messages of each type of the ground vehicle set come back") {
    CHECK(all_come_back(jauscat::sae::ugv::messages{}) > 20);
}
