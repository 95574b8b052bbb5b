// The list of all command codes. A message's place in it is its rank in the translation tables.
#include "schema/messages.hpp"
#include "schema/vectors.hpp"
#include "support/catch.hpp"
#include <jauscat/schema/jaus/catalog.hpp>

#include <algorithm>
#include <set>

namespace {

namespace jaus = jauscat::jaus;

/// Place in the catalogue, counted from 1; 0 when it is not there.
constexpr std::size_t rank(std::string_view name) {
    for (std::size_t i = 0; i != jaus::catalog.size(); ++i)
        if (jaus::catalog[i].name == name) return i + 1;
    return 0;
}
constexpr std::uint16_t code(std::string_view name) {
    return rank(name) == 0 ? std::uint16_t{} : jaus::catalog[rank(name) - 1].command_code;
}

} // namespace

TEST_CASE("the catalogue lists 157 messages by ascending command code, then the experimental one") {
    STATIC_REQUIRE(jaus::catalog.size() == 158);
    STATIC_REQUIRE(
        std::ranges::is_sorted(jaus::catalog.begin(), jaus::catalog.end() - 1, {}, &jaus::catalog_entry::command_code));
    STATIC_REQUIRE(jaus::catalog.back().command_code == 0x0404);
    STATIC_REQUIRE(jaus::catalog.front().command_code == 0x0001);
}

TEST_CASE("codes and names of the catalogue are distinct") {
    std::set<std::uint16_t> codes;
    std::set<std::string_view> names;
    for (const auto& entry : jaus::catalog) {
        REQUIRE(codes.insert(entry.command_code).second);
        REQUIRE(!entry.name.empty());
        REQUIRE(names.insert(entry.name).second);
    }
}

TEST_CASE("ranks equal those of the translation table") {
    STATIC_REQUIRE(rank("Set Wrench Effort") == 26);
    STATIC_REQUIRE(rank("Query Wrench Effort") == 72);
    STATIC_REQUIRE(rank("Report Wrench Effort") == 121);
    STATIC_REQUIRE(rank("Set Velocity State") == 158);
}

TEST_CASE("the catalogue has the codes of each class") {
    const auto in = [](std::uint16_t low, std::uint16_t high) {
        return std::ranges::count_if(jaus::catalog,
                                     [=](auto& e) { return e.command_code >= low && e.command_code <= high; });
    };
    REQUIRE(in(0x0000, 0x1FFF) == 59);
    REQUIRE(in(0x2000, 0x3FFF) == 48);
    REQUIRE(in(0x4000, 0x5FFF) == 51);
}

TEST_CASE("a message's type has the code and the name of the catalogue") {
    for (const auto& message : messages::all()) {
        INFO(message.name());
        const auto entry = std::ranges::find(jaus::catalog, message.code, &jaus::catalog_entry::command_code);
        REQUIRE(entry != jaus::catalog.end());
        CHECK(golden::snake_case(entry->name) == message.name());
    }
}

TEST_CASE("command codes equal those of the standard") {
    STATIC_REQUIRE(code("Set Component Authority") == 0x0001);
    STATIC_REQUIRE(code("Set Emergency") == 0x0006);
    STATIC_REQUIRE(code("Set Travel Speed") == 0x040A);
    STATIC_REQUIRE(code("Query Global Pose") == 0x2402);
    STATIC_REQUIRE(code("Report Heartbeat Pulse") == 0x4202);
    STATIC_REQUIRE(code("Report Mission Status") == 0x4E01);
}
