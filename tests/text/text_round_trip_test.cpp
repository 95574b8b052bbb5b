// What holds for every message: it comes back from JSON as it was, and its text names all of it.
#include "schema/messages.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/catalogue/json.hpp>

namespace {

namespace text = jauscat::text;
namespace wire = jauscat::wire;
using jauscat::catalogue::any_message;
using jauscat::test::to_hex;
using text::json;

/// Calls look(message, bytes) for random values of every message.
void for_random_messages(unsigned seed, auto&& look) {
    support::generator g{seed};
    for (const auto& message : messages::all()) {
        for (const double present : {0.0, 0.5, 0.5, 0.5, 0.5, 1.0}) {
            const auto random = message.random(g, {.present = present, .exact = true});
            INFO(message.name() << ": " << to_hex(random.bytes));
            REQUIRE(random.error == wire::errc::ok);
            const auto value = message.decode(random.bytes);
            REQUIRE(value);
            look(*value, random.bytes);
        }
    }
}

/// The JSON of a message, with its presence vector among the fields.
json whole_json(const any_message& message) {
    json made = to_json(message);
    if (const json vector = presence_vector_of(message); !vector.is_null()) made["presence_vector"] = vector;
    return made;
}

void check_comes_back(const any_message& message, const json& fields, const messages::octets& bytes) {
    INFO(fields.dump());
    const auto again = jauscat::catalogue::from_json(message.type(), fields);
    REQUIRE(again);
    REQUIRE(to_hex(*again->encode()) == to_hex(bytes));
}

/// The elements of payload data are bytes, which do not say how many there are.
bool counts_bytes(std::string_view name) { return name.starts_with("number_of_payload_"); }

/// Removes every "raw" beside a "value", and every count of a list that is there.
void simplify(json& fields) {
    for (auto it = fields.begin(); it != fields.end();) {
        if (fields.is_object() &&
            (it.key() == "raw" || (it.key().starts_with("number_of_") && !counts_bytes(it.key())) ||
             it.key() == "enumeration_length" || it.key() == "query_message_size")) {
            it = fields.erase(it);
            continue;
        }
        if (it->is_structured()) simplify(*it);
        ++it;
    }
}

} // namespace

TEST_CASE("every message is restored from its JSON") {
    for_random_messages(61, [](const any_message& message, const messages::octets& bytes) {
        const json fields = whole_json(message);
        check_comes_back(message, fields, bytes);
        // The JSON itself is one that others can read.
        check_comes_back(message, json::parse(fields.dump()), bytes);
    });
}

TEST_CASE("the text of every message names each of its fields") {
    for_random_messages(62, [](const any_message& message, const messages::octets&) {
        const std::string lines = "\n" + message.to_text();
        INFO(lines);
        const json fields = whole_json(message);
        for (const auto& field : fields.items()) {
            const std::string& name = field.key();
            INFO(name);
            const auto named = [&](std::string_view what_follows) {
                return lines.find("\n  " + name + std::string{what_follows}) != std::string::npos;
            };
            REQUIRE((named(" ") || named("[") || named(".") || named("\n")));
        }
    });
}

TEST_CASE("raw integers and counts may be left out of JSON") {
    for_random_messages(63, [](const any_message& message, const messages::octets& bytes) {
        // Counts of what is not there, or of a list that may be empty or absent, are no derived facts.
        if (message.command_code() == 0x4A23) return;
        json fields = whole_json(message);
        simplify(fields);
        check_comes_back(message, fields, bytes);
    });
}
