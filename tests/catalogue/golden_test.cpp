// Every golden message, by its catalogue entry.
#include "schema/vectors.hpp"
#include "support/catch.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/jaus/message/message.hpp>

#include <set>

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
using jauscat::test::to_hex;

/// Calls check(entry, body) for every golden message.
void for_golden(auto&& check) {
    std::set<std::uint16_t> seen;
    for (const auto& vector : golden::vectors()) {
        INFO(vector.name << ": " << to_hex(vector.bytes));
        const auto* const type = catalogue::ra_3_3().find(vector.code);
        REQUIRE(type != nullptr);
        seen.insert(vector.code);
        check(*type, std::span{vector.bytes}.subspan(jaus::header_size));
    }
    CHECK(seen.size() == catalogue::ra_3_3().size() - 1); // 0404h is not in the standard
}

} // namespace

TEST_CASE("every golden message decodes and encodes by its entry") {
    for_golden([](const catalogue::entry& type, std::span<const std::byte> body) {
        const auto message = type.decode(body);
        REQUIRE(message);
        const auto again = message->encode();
        REQUIRE(again);
        REQUIRE(to_hex(*again) == to_hex(body));
        REQUIRE(body.size() >= type.min_size());
        REQUIRE(body.size() <= type.max_size());
        REQUIRE(type.diagnose(body));
    });
}

TEST_CASE("every golden message comes back from its JSON") {
    for_golden([](const catalogue::entry& type, std::span<const std::byte> body) {
        const auto message = type.decode(body);
        REQUIRE(message);
        text::json fields = catalogue::to_json(*message);
        if (const auto vector = catalogue::presence_vector_of(*message); !vector.is_null())
            fields["presence_vector"] = vector;
        INFO(fields.dump());
        const auto again = catalogue::from_json(type, text::json::parse(fields.dump()));
        REQUIRE(again);
        REQUIRE(to_hex(*again->encode()) == to_hex(body));
    });
}

TEST_CASE("every golden message that is cut is refused, and the log says where") {
    for_golden([](const catalogue::entry& type, std::span<const std::byte> body) {
        for (std::size_t size = 0; size != body.size(); ++size) {
            const auto cut = body.first(size);
            const auto message = type.decode(cut);
            const auto why = catalogue::ra_3_3().why_malformed(type.command_code(), cut);
            REQUIRE(message.has_value() == why.empty());
            if (!message) REQUIRE(why == text::to_text(message.error()));
        }
    });
}
