// Writing schema headers: the text of a service with every kind of element, and names that would be the same.
#include "jsidl/sample.hpp"
#include "support/catch.hpp"
#include "support/paths.hpp"
#include <jauscat/jsidl/facts.hpp>
#include <jauscat/jsidl/write_schemas.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace jauscat;

namespace {

std::string content_of(const std::string& path) {
    std::ifstream file{path};
    return {std::istreambuf_iterator<char>{file}, {}};
}

jsidl::schema_headers headers_of(const std::vector<std::string>& texts, const jsidl::schema_options& options = {}) {
    const auto read = sample::read(texts);
    UNSCOPED_INFO(read.error().message);
    REQUIRE(read);
    const auto made = jsidl::write_schemas(*read, options);
    UNSCOPED_INFO(made.error().message);
    REQUIRE(made);
    return *made;
}

bool has(const std::string& text, const std::string& part) {
    UNSCOPED_INFO(text);
    return text.find(part) != text.npos;
}

std::string record(const std::string& name, const std::string& field) {
    return "<record name=\"" + name + "\"><fixed_field name=\"" + field +
           "\" field_type=\"unsigned byte\" field_units=\"one\"/></record>";
}
std::string sequence(const std::string& text) { return "<sequence name=\"S\">" + text + "</sequence>"; }

} // namespace

TEST_CASE("a service with every kind of element makes the golden header") {
    const auto read = jsidl::read_jsidl({{support::test_data("sonar.xml")}});
    REQUIRE(read);
    const auto made = jsidl::write_schemas(
        *read,
        {.name_space = "acme", .include_prefix = "acme", .capacity = 8, .capacities = {{"ReportEchoes.EchoList", 40}}});
    REQUIRE(made);
    REQUIRE(made->size() == 3);
    CHECK(made->at("survey/sonar.hpp") == content_of(support::test_data("sonar.hpp.golden")));
    CHECK(has(made->at("survey.hpp"), "using messages = jauscat::jaus::message_list<set_sonar, report_echoes>;"));
    CHECK(has(made->at("ranges.hpp"), "struct meter_0_to_10000 "));
}

TEST_CASE("the order of the files does not change the headers") {
    const auto one = sample::service(sample::message(record("A", "x")));
    const auto two = sample::service(sample::message(record("A", "x")), "",
                                     R"(name="Lidar" id="urn:acme:jss:survey:Lidar" version="1.0")");
    CHECK(headers_of({one, two}) == headers_of({two, one}));
}

TEST_CASE("a message that several services define is one type") {
    const auto one = sample::service(sample::message(record("A", "x")));
    const auto two = sample::service(sample::message(record("A", "x")), "",
                                     R"(name="Lidar" id="urn:acme:jss:survey:Lidar" version="1.0")");
    const auto made = headers_of({one, two});
    CHECK(
        has(made.at("survey/shared.hpp"), "/// ReportDepth: ID D101h, input of Lidar, Sonar.\nstruct report_depth {"));
    for (const auto* const name : {"survey/lidar.hpp", "survey/sonar.hpp"}) {
        CHECK(has(made.at(name), "#include <jauscat/schema/sae/survey/shared.hpp>"));
        CHECK(has(made.at(name), "using inputs = jaus::message_list<report_depth>;"));
        CHECK_FALSE(has(made.at(name), "struct report_depth {"));
    }
}

TEST_CASE("types that differ under one name are told apart by their service or message") {
    const auto made = headers_of({sample::service(
        sample::message(sequence(record("A", "x")), R"(name="First" message_id="D101")") +
        sample::message(sequence(record("A", "y")), R"(name="Second" message_id="D102")") +
        sample::message(sequence(record("B", "z") + record("First", "y")), R"(name="Third" message_id="D103")"))});
    const auto& text = made.at("survey/sonar.hpp");
    CHECK(has(text, "struct first_a {"));
    CHECK(has(text, "struct second_a {"));
    CHECK(has(text, "struct b {"));
    CHECK(has(text, "struct sonar_first {")); // First is a message
}

TEST_CASE("a member with the name of its type, or of another one, is qualified") {
    const auto made =
        headers_of({sample::service(sample::message(sequence(record("power", "power") + record("Unit", "x"))))});
    const auto& text = made.at("survey/sonar.hpp");
    CHECK(has(text, "struct power_record {\n    std::uint8_t power{};"));
    CHECK(has(text, "    power_record power{};"));
    CHECK(has(text, "    survey::unit unit{};"));
}

TEST_CASE("value sets are joined, and left out where they are all that the type holds") {
    const auto field = [](const std::string& name, const std::string& values) {
        return "<fixed_field name=\"" + name + "\" field_type=\"unsigned byte\" field_units=\"one\"><value_set>" +
               values + "</value_set></fixed_field>";
    };
    const auto range = [](const std::string& lower, const std::string& upper, const std::string& type) {
        return "<value_range lower_limit=\"" + lower + "\" lower_limit_type=\"" + type + "\" upper_limit=\"" + upper +
               "\" upper_limit_type=\"" + type + "\"/>";
    };
    const auto made = headers_of({sample::fields(
        field("a", range("0", "255", "inclusive")) + field("b", range("0", "10", "exclusive")) +
        field("c", range("0", "3", "inclusive") + range("4", "6", "inclusive") + range("9", "9", "inclusive")))});
    const auto& text = made.at("survey/sonar.hpp");
    CHECK(has(text, "field<&T::a, u8>"));
    CHECK(has(text, "field<&T::b, in_value_set<u8, between<1, 9>>>"));
    CHECK(has(text, "field<&T::c, in_value_set<u8, between<0, 6>, one_of<9>>>"));
}

TEST_CASE("alternatives that are one structure are refused") {
    const auto read = sample::read({sample::service(
        sample::message("<variant name=\"V\"><vtag_field max_count=\"1\" field_type_unsigned=\"unsigned byte\"/>" +
                        record("A", "x") + record("A", "x") + "</variant>"))});
    CHECK_FALSE(read); // of one name
    const auto nested = sample::read({sample::service(
        sample::message("<variant name=\"V\"><vtag_field max_count=\"1\" field_type_unsigned=\"unsigned byte\"/>" +
                        record("a_b", "x") + record("aB", "x") + "</variant>"))});
    CHECK_FALSE(nested);
}

TEST_CASE("lists have the capacity that the user chooses") {
    const auto list = sample::service(
        sample::message("<list name=\"L\"><count_field field_type_unsigned=\"unsigned byte\" max_count=\"200\"/>" +
                        record("A", "x") + "</list>"));
    CHECK(has(headers_of({list}).at("survey/sonar.hpp"), "wire::list<a> l{};"));
    CHECK(has(headers_of({list}, {.capacity = 12}).at("survey/sonar.hpp"), "wire::inline_list<a, 12> l{};"));
    CHECK(has(headers_of({list}, {.capacity = 1000}).at("survey/sonar.hpp"), "wire::inline_list<a, 200> l{};"));
    CHECK(has(headers_of({list}, {.capacity = 12, .capacities = {{"ReportDepth.L", 0}}}).at("survey/sonar.hpp"),
              "wire::list<a> l{};"));
    const auto refused = jsidl::write_schemas(*sample::read({list}), {.capacities = {{"M", 4}}});
    CHECK(refused.error().message == "there is no list \"M\" for a capacity");
}

TEST_CASE("the headers of SAE services are those of the table of facts, and lines are not too long") {
    const auto read = jsidl::read_facts(support::test_data("sae_facts.txt"));
    REQUIRE(read);
    CHECK(read->size() == 61);
    const auto made = jsidl::write_schemas(*read);
    REQUIRE(made);
    for (const auto& [name, text] : *made) {
        INFO(name);
        CHECK(text == content_of(support::source_file("schemas/jauscat/schema/sae/" + name)));
        for (std::size_t at = 0; name != "ranges.hpp" && at < text.size();) {
            const auto end = text.find('\n', at);
            INFO(text.substr(at, end - at));
            CHECK(end - at <= 120);
            at = end + 1;
        }
    }
}
