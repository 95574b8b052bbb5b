// Golden messages of every message that has a schema: header and body, field by field and byte for byte.
#include "support/catch.hpp"
#include "vectors.hpp"
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/wire/wire.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using jauscat::test::to_hex;

constexpr std::size_t header_size = wire::max_size<jaus::header>;

/// The bytes that `value` encodes to, as text.
template <wire::message T> std::string encoded(const T& value) {
    std::array<std::byte, wire::max_size<T>> out{};
    const auto written = wire::encode(value, out);
    return written ? to_hex(std::span{out}.first(written.size())) : std::string{wire::describe(written.error())};
}

jaus::address address(const golden::json& fields) {
    const auto octet = [&](const char* name) { return golden::number<std::uint8_t>(fields.get_child(name)); };
    return {.instance = octet("instance"),
            .component = octet("component"),
            .node = octet("node"),
            .subsystem = octet("subsystem")};
}

jaus::header expected_header(const golden::vector& vector) {
    const auto field = [&](const char* name) { return golden::number<std::uint16_t>(vector.header.get_child(name)); };
    return {.priority = static_cast<std::uint8_t>(field("priority")),
            .ack_nak = static_cast<jaus::ack_nak>(field("ack_nak")),
            .service_connection = field("service_connection") != 0,
            .experimental = field("experimental") != 0,
            .version = static_cast<std::uint8_t>(field("version")),
            .reserved = static_cast<std::uint8_t>(field("reserved")),
            .command_code = vector.code,
            .destination = address(vector.header.get_child("destination")),
            .source = address(vector.header.get_child("source")),
            .data_size = field("data_size"),
            .data_flag = static_cast<jaus::data_flag>(field("data_flag")),
            .sequence_number = field("sequence_number")};
}

/// Puts a JSON value into a member and into its raw counterpart.
template <class Item, class Value, class Raw> void put(const golden::json& json, Value& value, Raw& raw) {
    if constexpr (wire::message<Value>) {
        // A structure of bit-fields is given as the integer that carries them.
        const auto integer = golden::number<std::uint64_t>(json);
        std::array<std::byte, 8> bytes{};
        wire::u64le::store(bytes.data(), integer);
        REQUIRE(wire::decode_prefix(value, bytes));
        REQUIRE(wire::decode_prefix(raw, bytes));
    } else if constexpr (requires { typename Item::codec_type::range_type; }) {
        value = golden::number<double>(json.get_child("value"));
        raw = golden::number<Raw>(json.get_child("raw"));
    } else if constexpr (requires { typename Value::bits_type; }) {
        value = Value::from_bits(golden::number<typename Value::bits_type>(json));
        raw = value;
    } else {
        value = static_cast<Value>(golden::number<std::uint64_t>(json));
        raw = value;
    }
}

/// The message that a vector's fields describe, as real and as raw values. Every field must find its member.
template <wire::message T> std::pair<T, wire::raw<T>> expected_body(const golden::vector& vector) {
    std::map<std::string, golden::json> fields;
    for (const auto& [name, json] : vector.fields) fields.emplace(golden::snake_case(name), json);
    std::pair<T, wire::raw<T>> both{};
    wire::visit(both.first, [&]<class Item>(Item, auto& value) {
        const auto found = fields.find(std::string{Item::name()});
        auto& raw = both.second.template slot<Item::key>();
        INFO(Item::name());
        if constexpr (Item::optional) {
            if (found == fields.end()) return;
            put<Item>(found->second, value.emplace(), raw.emplace());
        } else {
            REQUIRE(found != fields.end());
            put<Item>(found->second, value, raw);
        }
        fields.erase(found);
    });
    REQUIRE(fields.empty());
    return both;
}

/// Equal, real values within 1e-12 of their size.
template <class Value> void require_close(const Value& a, const Value& b) {
    if constexpr (requires { a.has_value(); }) {
        REQUIRE(a.has_value() == b.has_value());
        if (a) require_close(*a, *b);
    } else if constexpr (std::floating_point<Value>) {
        REQUIRE(std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)));
    } else {
        REQUIRE(a == b);
    }
}

} // namespace

TEST_CASE("every golden header decodes field for field and encodes to the same bytes") {
    REQUIRE(golden::vectors().size() == 1255);
    for (const auto& vector : golden::vectors()) {
        INFO(vector.name << ": " << to_hex(vector.bytes));
        const auto expected = expected_header(vector);
        jaus::header header{};
        const auto used = wire::decode_prefix(header, vector.bytes);
        REQUIRE(used.size() == header_size);
        REQUIRE(header == expected);
        REQUIRE(header.data_size == vector.bytes.size() - header_size);
        REQUIRE(encoded(expected) == to_hex(std::span{vector.bytes}.first(header_size)));
    }
}

TEST_CASE("every golden message is in the catalogue under its name") {
    for (const auto& vector : golden::vectors()) {
        INFO(vector.name);
        const auto entry = std::ranges::find(jaus::catalog, vector.code, &jaus::catalog_entry::command_code);
        REQUIRE(entry != jaus::catalog.end());
        REQUIRE(entry->name == vector.name);
    }
}

TEMPLATE_LIST_TEST_CASE("every golden body decodes field for field and encodes to the same bytes", "", jaus::messages) {
    using T = TestType;
    int count = 0;
    for (const auto& vector : golden::vectors()) {
        if (vector.code != T::command_code) continue;
        ++count;
        INFO(vector.name << ": " << to_hex(vector.bytes));
        const auto body = std::span{vector.bytes}.subspan(header_size);
        const auto [expected, expected_raw] = expected_body<T>(vector);
        REQUIRE(encoded(expected) == to_hex(body));
        REQUIRE(encoded(expected_raw) == to_hex(body));

        T value{};
        wire::raw<T> raw{};
        REQUIRE(wire::decode(value, body).size() == body.size());
        REQUIRE(wire::decode(raw, body).size() == body.size());
        REQUIRE(raw == expected_raw);
        wire::visit(value, [&, &wanted = expected]<class Item>(Item, const auto& member) {
            INFO(Item::name());
            require_close(member, wire::member_of<Item::key>(wanted));
        });
    }
    REQUIRE(count == 8);
}
