// Messages of SAE services, one for each construct of JSIDL: golden messages with damaged bytes, and random messages.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/sae/core/events.hpp>
#include <jauscat/schema/sae/core/list_manager.hpp>
#include <jauscat/schema/sae/environment_sensing/range_sensor.hpp>
#include <jauscat/schema/sae/mobility/gps_fix.hpp>
#include <jauscat/schema/sae/mobility/local_operating_zone.hpp>
#include <jauscat/text/json.hpp>
#include <jauscat/text/print.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace {

namespace text = jauscat::text;
namespace wire = jauscat::wire;
namespace core = jauscat::sae::core;
namespace mobility = jauscat::sae::mobility;
namespace sensing = jauscat::sae::environment_sensing;
using wire::errc;

struct lent_memory {
    std::vector<std::byte> bytes = std::vector<std::byte>(std::size_t{1} << 20U);
    wire::arena arena{bytes};
};

template <wire::message T> std::vector<std::byte> encoded(const T& value) {
    std::vector<std::byte> out(wire::encoded_size(value));
    const auto written = wire::encode(value, out, wire::tolerate_values);
    REQUIRE(written);
    REQUIRE(written->size() == out.size());
    return out;
}

/// Any bytes: an error, or a message that encodes and comes back. `bytes` ends where its memory ends.
template <wire::message T> bool require_error_or_message(std::span<const std::byte> bytes, lent_memory& memory) {
    memory.arena.reset();
    T value{};
    const errc error = wire::decode(value, bytes, memory.arena, wire::tolerate_values).error();
    const errc strict = wire::decode(value, bytes, memory.arena).error();
    const errc diagnosed = wire::diagnose<T>(bytes).error;
    if (strict != diagnosed) FAIL("diagnose says " << wire::describe(diagnosed) << " for " << wire::describe(strict));
    if (error != errc::ok) {
        if (strict != error) FAIL("decode has two reasons");
        return false;
    }
    if (strict != errc::ok && strict != errc::outside_value_set) FAIL(wire::describe(strict));
    if (strict != wire::check_values(value)) FAIL("check_values differs");
    if (!wire::view<T>{bytes}) FAIL("a view refuses " << text::detail::plain_hex(bytes));
    wire::raw<T> raw{};
    if (!wire::decode(raw, bytes, memory.arena)) FAIL("a raw message refuses the bytes");
    std::vector<std::byte> out(wire::encoded_size(raw));
    if (!wire::encode(raw, out) || out.size() != bytes.size()) FAIL("a raw message has another size");
    if (strict == errc::ok) {
        const auto again = encoded(value);
        T other{};
        if (!wire::decode(other, again, memory.arena) || !(other == value)) FAIL("a message does not come back");
    }
    return true;
}

template <wire::message T> std::vector<std::vector<std::byte>> golden_of() {
    std::vector<std::vector<std::byte>> found;
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) {
        const auto one = text::json::parse(line);
        if (std::stoi(one.at("code").get<std::string>(), nullptr, 16) == T::schema::message_id)
            found.push_back(jauscat::test::from_hex(one.at("hex").get<std::string>()));
    }
    REQUIRE(!found.empty());
    return found;
}

} // namespace

#define MESSAGES                                                                                                       \
    core::create_event, core::query_events, core::reject_event_request, core::set_element,                             \
        mobility::set_local_operating_zone, sensing::report_sensor_geometric_properties, mobility::report_gps_fix,     \
        sensing::report_range_sensor_data, sensing::report_range_sensor_compressed_data

TEMPLATE_TEST_CASE("damaged messages of SAE JAUS are refused or are other messages", "", MESSAGES) {
    lent_memory memory;
    for (const auto& bytes : golden_of<TestType>()) {
        TestType value{};
        memory.arena.reset();
        REQUIRE(wire::decode(value, bytes, memory.arena));
        REQUIRE(wire::diagnose<TestType>(bytes));
        REQUIRE(wire::diagnose(value));
        for (std::size_t size = 0; size != bytes.size(); ++size) {
            const std::vector<std::byte> shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
            memory.arena.reset();
            REQUIRE(wire::decode(value, shorter, memory.arena).error() == errc::truncated);
            REQUIRE(wire::view<TestType>{shorter}.error() == errc::truncated);
            REQUIRE(wire::diagnose<TestType>(shorter).error == errc::truncated);
        }
        const unsigned every = bytes.size() < 100 ? 1 : 17;
        for (std::size_t at = 0; at != bytes.size(); ++at)
            for (unsigned change = 1; change < 256; change += every) {
                auto changed = bytes;
                changed[at] ^= static_cast<std::byte>(change);
                require_error_or_message<TestType>(changed, memory);
            }
    }
    SUCCEED();
}

TEMPLATE_TEST_CASE("random messages of SAE JAUS come back, as bytes and as JSON", "", MESSAGES) {
    lent_memory memory, other;
    support::generator g{2026};
    for (unsigned round = 0; round != 200; ++round) {
        CAPTURE(round);
        memory.arena.reset();
        std::pmr::monotonic_buffer_resource lists;
        const auto value = support::random_message<TestType>(g, lists);
        REQUIRE(wire::check_values(value) == errc::ok);
        const auto bytes = encoded(value);
        TestType found{};
        REQUIRE(wire::describe(wire::decode(found, bytes, memory.arena).error()) == "ok");
        REQUIRE(encoded(found) == bytes);
        REQUIRE(require_error_or_message<TestType>(bytes, other));

        TestType read{};
        const auto done = text::from_json(text::to_json(found), read, memory.arena);
        if (!done) FAIL(done.error().message);
        REQUIRE(encoded(read) == bytes);
        REQUIRE(!text::to_text(found).empty());
    }
}
