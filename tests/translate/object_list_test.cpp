// Object lists made of message types.
#include "samples.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/translate/fixed_length.hpp>

#include <set>

using namespace jauscat;
using namespace jauscat::test;
using bridging::object_list;
using bridging::sub_object;

namespace {

/// Private messages, the second with a body of any length.
struct set_gripper {
    std::uint8_t opening{}; ///< percent
    std::uint16_t force{};  ///< N
};
struct report_gripper_log {
    std::string_view text{};
};

} // namespace

template <> struct jauscat::wire::schema<set_gripper> {
    static constexpr std::uint16_t command_code = 0xD123;
    using type = layout<field<&set_gripper::opening, u8>, field<&set_gripper::force, u16le>>;
};
template <> struct jauscat::wire::schema<report_gripper_log> {
    static constexpr std::uint16_t command_code = 0xD124;
    using type = layout<string<&report_gripper_log::text, rest>>;
};

namespace {

constexpr auto codes_with_private_messages = [] {
    std::array<std::uint16_t, 160> codes{};
    std::ranges::copy(translation::ra_command_codes, codes.begin());
    codes[158] = jaus::command_code_of<set_gripper>;
    codes[159] = jaus::command_code_of<report_gripper_log>;
    return codes;
}();
using private_table = translation::seed_table_of<0x2000, codes_with_private_messages>::type;

/// Not in the order of their ranks.
using wrench_efforts =
    jaus::message_list<jaus::report_wrench_effort, jaus::set_wrench_effort, jaus::query_wrench_effort>;

} // namespace

TEST_CASE("a component's object has one subobject for each message, at its rank, with its maximum size and access") {
    using list = object_list<translation::seed_table, 33, wrench_efforts>;
    STATIC_REQUIRE(list::index == 6933);
    STATIC_REQUIRE(list::component == 33);
    STATIC_REQUIRE(list::entries.size() == 3);
    CHECK(list::entries[0] == sub_object{26, 0x0405, "set_wrench_effort", 28, false, true});
    CHECK(list::entries[1] == sub_object{72, 0x2405, "query_wrench_effort", 10, false, true});
    CHECK(list::entries[2] == sub_object{121, 0x4405, "report_wrench_effort", 28, true, true});
}

TEST_CASE("sizes depend on the table, and the index on its base") {
    using list = object_list<translation::self_contained_table_of<0x2000>::type, 38, wrench_efforts>;
    STATIC_REQUIRE(list::index == 0x2026);
    CHECK(list::entries[0].max_size == 32);
    CHECK(list::entries[1].max_size == 14);
    CHECK(list::entries[2].max_size == 32);
    STATIC_REQUIRE(!list::exact_size);
}

TEST_CASE("under a table with fixed lengths the sizes are exact and include the real length") {
    using table = translate::fixed_length<translation::seed_table, wrench_efforts>;
    using list = object_list<table, 33, wrench_efforts>;
    STATIC_REQUIRE(list::exact_size);
    CHECK(list::entries[0].max_size == 30);
    CHECK(list::entries[1].max_size == 12);
    CHECK(list::entries[2].max_size == 30);
    CHECK(list::entries[0].max_size == table::object_size(jaus::header{.command_code = 0x0405}));
}

TEST_CASE("a list may be given by messages, and be empty") {
    using list = object_list<translation::seed_table, 33, jaus::query_wrench_effort, jaus::set_wrench_effort>;
    CHECK(list::entries.size() == 2);
    CHECK(list::entries[0].subindex == 26);
    using none = object_list<translation::seed_table, 33>;
    STATIC_REQUIRE(none::entries.empty());
    STATIC_REQUIRE(none::description.highest_subindex() == 0);
    CHECK(none::description.find(0) == nullptr);
}

TEST_CASE("the type-erased description has the same content, and finds a subobject") {
    const bridging::object_description& object = object_list<translation::seed_table, 33, wrench_efforts>::description;
    CHECK(object.index == 6933);
    CHECK(object.component == 33);
    CHECK(object.name == "component 33");
    CHECK_FALSE(object.exact_size);
    CHECK(object.highest_subindex() == 121);
    REQUIRE(object.find(72) != nullptr);
    CHECK(object.find(72)->command_code == 0x2405);
    for (const int absent : {0, 1, 25, 27, 120, 122, 255})
        CHECK(object.find(static_cast<std::uint8_t>(absent)) == nullptr);
    CHECK(object_list<translation::seed_table, 7, wrench_efforts>::name == "component 7");
    CHECK(object_list<translation::seed_table, 255, wrench_efforts>::name == "component 255");
    CHECK(object_list<translation::seed_table, 0, wrench_efforts>::name == "component 0");
}

TEST_CASE("a component that accepts all messages has the subindices 1 to 158 in the order of the catalogue") {
    using list = object_list<translation::seed_table, 1, jaus::messages>;
    REQUIRE(list::entries.size() == jaus::catalog.size());
    std::set<std::string_view> names;
    for (std::size_t i = 0; i != list::entries.size(); ++i) {
        const auto& entry = list::entries[i];
        CAPTURE(entry.name);
        CHECK(entry.subindex == i + 1);
        CHECK(entry.command_code == jaus::catalog[i].command_code);
        CHECK(entry.max_size >= 8);
        CHECK(entry.max_size <= 1540);
        CHECK(entry.writable);
        CHECK(entry.readable == (entry.command_code >= 0x4000));
        CHECK(names.insert(entry.name).second);
    }
    const auto size_of = [](std::uint8_t subindex) { return list::description.find(subindex)->max_size; };
    CHECK(size_of(1) == 9);   // Set Component Authority: 1 byte
    CHECK(size_of(2) == 8);   // Shutdown: none
    CHECK(size_of(26) == 28); // Set Wrench Effort: 20
    CHECK(list::description.find(158)->name == "set_velocity_state");
    const auto image = std::ranges::find(list::entries, 0x4807, &sub_object::command_code);
    CHECK(image->max_size == 1540); // Report Image has no limit but the packet's
}

TEST_CASE("private messages have readable and writable objects after those of the standard") {
    using list = object_list<private_table, 33, report_gripper_log, set_gripper, jaus::set_wrench_effort>;
    STATIC_REQUIRE(list::index == 0x2021);
    CHECK(list::entries[0].subindex == 26);
    CHECK(list::entries[1] == sub_object{159, 0xD123, "set_gripper", 11, true, true});
    CHECK(list::entries[2] == sub_object{160, 0xD124, "report_gripper_log", 1540, true, true});
}
