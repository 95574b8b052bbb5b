// The catalogue of SAE services: every golden message by its entry, and damaged ones.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/message_id.hpp>

#include <fstream>
#include <set>

namespace {

namespace catalogue = jauscat::catalogue;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using jauscat::test::from_hex;
using jauscat::test::to_hex;

struct golden_message {
    const catalogue::entry* type{};
    std::vector<std::byte> payload{};
};

const std::vector<golden_message>& golden() {
    static const auto all = [] {
        std::vector<golden_message> read;
        std::ifstream file{support::test_data("sae_vectors.jsonl")};
        for (std::string line; std::getline(file, line);) {
            const auto hex = text::json::parse(line).at("hex").get<std::string>();
            auto payload = from_hex(hex);
            const auto* const type = catalogue::sae().find(*jauscat::sae::message_id_of(payload));
            INFO(hex);
            REQUIRE(type != nullptr);
            read.push_back({type, std::move(payload)});
        }
        return read;
    }();
    return all;
}

} // namespace

TEST_CASE("the catalogue of SAE has every message of the sets, and each ID once") {
    const auto& all = catalogue::sae();
    std::size_t count = 0;
    for (const auto* set :
         {&catalogue::sae_core_1_1(), &catalogue::sae_mobility_1_1(), &catalogue::sae_environment_sensing_2_0(),
          &catalogue::sae_manipulator_2_0(), &catalogue::sae_ground_vehicle_1_0()}) {
        for (const auto& one : *set) CHECK(*all.find(one.command_code()) == one);
        count += set->size();
    }
    CHECK(all.size() == count);
    std::set<std::uint16_t> codes;
    for (const auto& [type, payload] : golden()) codes.insert(type->command_code());
    CHECK(codes.size() == count);
}

TEST_CASE("an entry of SAE says what its schema says; its body begins with the message ID") {
    const auto found = catalogue::sae().find("set_wrench_effort");
    REQUIRE(found);
    const catalogue::entry& effort = **found;
    CHECK(effort.command_code() == 0x0405);
    CHECK(effort.query() == 0);
    CHECK(effort.report() == 0);
    CHECK(effort.min_size() == 4);
    CHECK(effort.presence_bits() == 0xFFF);
    const auto message = catalogue::sae().from_text("set_wrench_effort propulsive_linear_effort_x=100");
    REQUIRE(message);
    CHECK(to_hex(*message->encode()) == "05 04 01 00 ff ff");
    const auto query = catalogue::sae().find("query_wrench_effort");
    REQUIRE(query);
    CHECK((*query)->report() == 0x4405);
    CHECK(catalogue::sae().find(std::uint16_t{0x4405})->query() == 0x2405);
    CHECK(catalogue::sae().why_malformed(0x0405, from_hex("0504 0100 ff")).find("propulsive_linear_effort_x") !=
          std::string::npos);
    CHECK(catalogue::sae().find(std::uint16_t{0x9999}) == nullptr);
}

TEST_CASE("query and report of SAE name each other where the list has both") {
    std::size_t queries = 0;
    for (const auto& one : catalogue::sae()) {
        INFO(one.name());
        if (one.report() != 0) {
            ++queries;
            REQUIRE(catalogue::sae().find(one.report()) != nullptr);
            CHECK(catalogue::sae().find(one.report())->query() == one.command_code());
        }
        if (one.query() != 0) CHECK(catalogue::sae().find(one.query())->report() == one.command_code());
        CHECK(one.name().starts_with("query_") == (one.report() != 0));
        if (one.query() != 0) CHECK(one.name().starts_with("report_"));
    }
    CHECK(queries == 99);
}

TEST_CASE("a value outside its value set is told apart from bytes that are no message, and accepted on request") {
    const auto& emergency = *catalogue::sae().find(std::uint16_t{0x0006});
    const auto body = from_hex("0600 0000");
    const auto refused = emergency.decode(body);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().error == wire::errc::outside_value_set);
    CHECK(refused.error().field == "emergency_code");
    const auto message = emergency.decode(body, wire::tolerate_values);
    REQUIRE(message);
    CHECK(message->outside_values() == std::vector<std::string>{"emergency_code"});
    CHECK(message->to_text() == "  emergency_code = 0x0000 (outside its values)\n");
    CHECK(emergency.annotate(body).find("emergency_code = 0x0000 (outside its values)") != std::string::npos);
    CHECK(message->encode().error() == wire::errc::outside_value_set);
    CHECK(to_hex(*message->encode(wire::tolerate_values)) == "06 00 00 00");
    CHECK(emergency.decode(from_hex("0600 01"), wire::tolerate_values).error().error == wire::errc::truncated);
    const auto stop = emergency.decode(from_hex("0600 0100"), wire::tolerate_values);
    CHECK(stop->outside_values().empty());
    CHECK(stop->encode());
    // A time with 1023 ms: two bit-fields of a structure that is shown as one integer.
    const auto& pose = *catalogue::sae().find(std::uint16_t{0x4402});
    const auto late = pose.decode(from_hex("0244 0001 ffffffff"), wire::tolerate_values);
    REQUIRE(late);
    CHECK(late->outside_values().front() == "time_stamp.milliseconds");
    CHECK(late->to_text().ends_with(" (outside its values)\n"));
}

TEST_CASE("mobility 1.0 has other bytes for Local Vector, and the rest of 1.1") {
    const auto speed = from_hex("0804 01 ffff");
    CHECK(catalogue::sae_mobility_1_0().find(std::uint16_t{0x0408})->to_text(speed).find("speed") != std::string::npos);
    CHECK_FALSE(catalogue::sae_mobility_1_1().find(std::uint16_t{0x0408})->decode(speed));
    CHECK(catalogue::sae_mobility_1_0().size() == catalogue::sae_mobility_1_1().size());
    CHECK(*catalogue::sae_mobility_1_0().find(std::uint16_t{0x0405}) ==
          *catalogue::sae_mobility_1_1().find(std::uint16_t{0x0405}));
}

TEST_CASE("every golden message of SAE decodes and encodes by its entry, and comes back from its JSON") {
    for (const auto& [type, payload] : golden()) {
        INFO(type->name() << ": " << to_hex(payload));
        const auto message = type->decode(payload);
        REQUIRE(message);
        REQUIRE(to_hex(*message->encode()) == to_hex(payload));
        REQUIRE(payload.size() >= type->min_size());
        REQUIRE((payload.size() <= type->max_size() || type->takes_rest()));
        REQUIRE(type->diagnose(payload));
        REQUIRE(type->annotate(payload).find("message_id = ") != std::string::npos);
        text::json fields = catalogue::to_json(*message);
        const auto again = catalogue::from_json(*type, text::json::parse(fields.dump()));
        if (!again) FAIL(again.error().message << fields.dump());
        REQUIRE(to_hex(*again->encode()) == to_hex(payload));
    }
    CHECK(golden().size() == 1444);
}

TEST_CASE("every golden message of SAE that is cut is refused, and the reason is told") {
    for (const auto& [type, payload] : golden())
        for (std::size_t size = 0; size != payload.size(); ++size) {
            const auto cut = std::span{payload}.first(size);
            const auto message = type->decode(cut);
            if (message || message.error().error != wire::errc::truncated)
                FAIL(type->name() << ", " << size << " bytes of " << to_hex(payload));
        }
    SUCCEED();
}

#if defined(__has_feature)
#    if __has_feature(address_sanitizer)
constexpr bool is_sanitized = true; // 25 times slower
#    else
constexpr bool is_sanitized = false;
#    endif
#else
constexpr bool is_sanitized = false;
#endif

TEST_CASE("every golden message of SAE with one changed byte is an error or another message that comes back") {
    std::size_t errors = 0, messages = 0, outsiders = 0;
    for (const auto& [type, payload] : golden()) {
        auto changed = payload;
        for (std::size_t at = 0; at != payload.size(); ++at) {
            // Every other value of each byte; of a long message only some. Counts beyond the end are among these.
            const unsigned step = (payload.size() <= 16 ? 1 : 37) * (is_sanitized ? 7 : 1);
            for (unsigned change = 1; change < 256; change += step) {
                changed[at] = payload[at] ^ static_cast<std::byte>(change);
                const auto message = type->decode(changed, wire::tolerate_values);
                if (!message) {
                    ++errors;
                    continue;
                }
                ++messages;
                const auto bytes = message->encode(wire::tolerate_values);
                if (!bytes) FAIL(type->name() << ": what decodes does not encode: " << to_hex(changed));
                const auto other = type->decode(*bytes, wire::tolerate_values);
                if (!other || *other->encode(wire::tolerate_values) != *bytes)
                    FAIL(type->name() << ": the message does not come back: " << to_hex(changed));
                const bool is_outside = message->encode().error() == wire::errc::outside_value_set;
                if (!is_outside && change != 1) continue;
                const auto outside = message->outside_values();
                if (is_outside == outside.empty())
                    FAIL(type->name() << ": outside_values and encode disagree: " << to_hex(changed));
                if (!is_outside) continue;
                ++outsiders;
                const auto strict = type->decode(changed).error();
                if (text::field_path(strict) != outside.front())
                    FAIL(type->name() << ": " << text::field_path(strict) << " is not " << outside.front());
            }
            changed[at] = payload[at];
        }
    }
    CHECK(errors > (is_sanitized ? 1'000 : 10'000));
    CHECK(messages > (is_sanitized ? 10'000 : 100'000));
    CHECK(outsiders > (is_sanitized ? 100 : 1'000));
}
