// Reading JSIDL files: numbers, references and constants, and what is refused with file, line and reason.
#include "jsidl/sample.hpp"
#include "support/catch.hpp"
#include <jauscat/jsidl/facts.hpp>
#include <jauscat/jsidl/names.hpp>

#include <sstream>

using namespace jauscat;
using sample::complaint;
using sample::fields;
using sample::message;
using sample::service;

namespace {

constexpr const char* depth =
    R"(<fixed_field name="Depth" optional="false" field_type="unsigned integer" field_units="meter"><scale_range real_lower_limit="0" real_upper_limit="1000" integer_function="round"/></fixed_field>)";

/// The field's limits, or the complaint.
std::string limits(const std::string& lower, const std::string& upper) {
    const auto read = sample::read({fields(
        R"(<fixed_field name="Depth" field_type="unsigned integer" field_units="meter"><scale_range real_lower_limit=")" +
        lower + R"(" real_upper_limit=")" + upper + R"(" integer_function="round"/></fixed_field>)")});
    if (!read) return read.error().message;
    const auto& scale = *read->front().inputs.front().body->children.front().scale;
    std::ostringstream text;
    text.precision(17);
    text << scale.min << ' ' << scale.max;
    return text.str();
}

constexpr const char* types =
    R"(<declared_type_set name="Types" id="urn:acme:types" version="1.0" xmlns="urn:jaus:jsidl:1.0">
<declared_const_set_ref name="consts" id="urn:acme:consts" version="1.0"/>
<fixed_field name="Angle" optional="false" field_type="unsigned short integer" field_units="radian"><scale_range real_lower_limit="-20*consts.PI" real_upper_limit="consts.PI / 2" integer_function="round"/></fixed_field>
<record name="Pair" optional="false"><declared_fixed_field name="First" declared_type_ref="Angle"/></record>
</declared_type_set>)";
constexpr const char* constants =
    R"(<declared_const_set name="Constants" id="urn:acme:consts" version="1.0" xmlns="urn:jaus:jsidl:1.0">
<const_def name="PI" const_type="long float" const_value="3.141592653589793" field_units="one"/>
<const_def name="A" const_type="long float" const_value="2*B" field_units="one"/>
<const_def name="B" const_type="long float" const_value="A" field_units="one"/>
</declared_const_set>)";
const std::string with_types =
    R"(<declared_type_set name="own"><declared_type_set_ref name="t" id="urn:acme:types" version="1.0"/></declared_type_set>
)";

bool has(const std::string& text, const std::string& part) {
    UNSCOPED_INFO(text);
    return text.find(part) != text.npos;
}

} // namespace

TEST_CASE("a service is read with its messages, directions and parent") {
    const auto read = sample::read({service(
        message("<record name=\"DepthRec\">" + std::string{depth} + "</record>") +
            message("", R"(name="Stop" message_id="d102" deprecated="true")"),
        R"(<references><inherits_from name="events" id="urn:jaus:jss:core:Events" version="1.1"/></references>)")});
    REQUIRE(read);
    const auto& made = read->front();
    CHECK(made.id == "urn:acme:jss:survey:Sonar");
    CHECK(made.inherits->id == "urn:jaus:jss:core:Events");
    REQUIRE(made.inputs.size() == 2);
    CHECK(made.outputs.empty());
    CHECK(made.inputs[0].id == 0xD101);
    CHECK(made.inputs[1].id == 0xD102);
    CHECK(made.inputs[1].is_deprecated);
    CHECK_FALSE(made.inputs[1].body);
    CHECK(made.inputs[0].body->children.front().unit == "meter");
}

TEST_CASE("numbers may have white space, thousands separators, products and quotients") {
    CHECK(limits(" 0 ", "1,000,000.5") == "0 1000000.5");
    CHECK(limits("-1 000", "1000000.0") == "-1000 1000000");
    CHECK(limits("-2*(1+3)", "3.14159265358979323846/2") == "-8 1.5707963267948966");
    CHECK(limits("- 1e1", ".5") == "-10 0.5");
}

TEST_CASE("a number that could be read in two ways is refused") {
    for (const auto* const text : {"1,5", "1 5", "10,00", "1,0000", "ten", "1..2", "1/0", "", "1,000 000"}) {
        INFO(text);
        CHECK(has(limits("0", text), "file1.xml:7: <scale_range>: real_upper_limit"));
    }
    CHECK(has(limits("5", "5"), "the lower limit is not below the upper one"));
}

TEST_CASE("types and constants of other files are found through their sets") {
    const auto read =
        sample::read({service(message(R"(<declared_record name="Aim" declared_type_ref="t.Pair"/>)"), with_types),
                      types, constants});
    REQUIRE(read);
    const auto& body = *read->front().inputs.front().body;
    CHECK(body.name == "Aim");
    CHECK(body.children.front().name == "First");
    CHECK(body.children.front().scale->min == -20 * 3.141592653589793);
    CHECK(body.children.front().scale->max == 3.141592653589793 / 2);
}

TEST_CASE("a reference to what no file defines is refused") {
    const auto using_type = [](const std::string& name) {
        return service(message("\n<declared_record name=\"Aim\" declared_type_ref=\"" + name + "\"/>"), with_types);
    };
    CHECK(has(complaint({using_type("t.Pair")}),
              "file1.xml:3: <declared_type_set_ref>: no file that is given defines urn:acme:types version 1.0"));
    CHECK(has(complaint({using_type("t.Pair"), types}),
              "file2.xml:2: <declared_const_set_ref>: no file that is given defines urn:acme:consts"));
    CHECK(has(complaint({using_type("t.None"), types, constants}),
              "file1.xml:8: <declared_record>: declared_type_ref=\"t.None\": there is no \"None\" in \"Types\" of "
              "file2.xml"));
    CHECK(has(complaint({using_type("u.Pair"), types, constants}), "there is no set of types called \"u\""));
    CHECK(has(complaint({using_type("t.Angle"), types, constants}), "is a <fixed_field>, expected a <record>"));
}

TEST_CASE("types, constants and services that refer to themselves are refused") {
    const std::string loop =
        R"(<declared_type_set name="Types" id="urn:acme:types" version="1.0" xmlns="urn:jaus:jsidl:1.0">
<declared_record name="Pair" declared_type_ref="Pair"/>
<list name="Deep" optional="false"><count_field field_type_unsigned="unsigned byte"/><declared_list name="Deeper" declared_type_ref="Deep"/></list>
</declared_type_set>)";
    CHECK(has(
        complaint({service(message(R"(<declared_record name="Aim" declared_type_ref="t.Pair"/>)"), with_types), loop}),
        "refers to itself"));
    CHECK(has(
        complaint({service(message(R"(<declared_list name="Aim" declared_type_ref="t.Deep"/>)"), with_types), loop}),
        "file2.xml:3: <list>: contains itself"));
    const std::string with_constants = R"(<declared_const_set_ref name="c" id="urn:acme:consts" version="1.0"/>)";
    CHECK(has(
        complaint(
            {service(
                 message(
                     R"(<record name="R"><fixed_field name="D" field_type="unsigned byte" field_units="one"><scale_range real_lower_limit="0" real_upper_limit="c.A"/></fixed_field></record>)"),
                 with_constants),
             constants}),
        "<const_def>: the constant refers to itself"));
    const auto child_of = [](const std::string& name, const std::string& parent) {
        return service("",
                       "<references><inherits_from name=\"p\" id=\"urn:acme:jss:survey:" + parent +
                           "\" version=\"1.0\"/></references>",
                       "name=\"" + name + "\" id=\"urn:acme:jss:survey:" + name + "\" version=\"1.0\"");
    };
    CHECK(has(complaint({child_of("A", "B"), child_of("B", "C"), child_of("C", "A")}),
              "urn:acme:jss:survey:A version 1.0 inherits from itself"));
    CHECK(complaint({child_of("A", "B"), child_of("B", "Elsewhere")}) == "accepted");
}

TEST_CASE("a file that is given twice is refused") {
    CHECK(complaint({service(""), service("")}) ==
          "file2.xml:2: <service_def>: defines urn:acme:jss:survey:Sonar version 1.0 again; file1.xml defines it");
}

TEST_CASE("a second version of a service needs a namespace of its own") {
    CHECK(has(complaint({service(""), service("", "", R"(name="Sonar" id="urn:acme:jss:survey:Sonar" version="1.1")")}),
              "version 1.1 beside version 1.0 of file1.xml; write each version into a namespace of its own"));
}

TEST_CASE("other documents are refused") {
    CHECK(has(complaint({"<service_def"}), "file1.xml:1: not well-formed XML"));
    CHECK(has(complaint({"<EtherCATInfo/>"}), "the root element, expected <service_def>"));
    CHECK(has(complaint({R"(<service_def xmlns="urn:jaus:jsidl:2.0"/>)"}), "the namespace is \"urn:jaus:jsidl:2.0\""));
    const auto read = jsidl::read_jsidl({{"/no/such/file.xml"}});
    CHECK(read.error().code == jsidl::errc::unreadable);
}

TEST_CASE("what a schema cannot express is refused with the reason") {
    const auto field = [](const std::string& inside, const std::string& type = "unsigned byte") {
        return fields("<fixed_field name=\"Depth\" field_type=\"" + type + "\" field_units=\"one\">\n" + inside +
                      "</fixed_field>");
    };
    CHECK(
        has(complaint({field(R"(<scale_range real_lower_limit="0" real_upper_limit="1" integer_function="floor"/>)")}),
            "file1.xml:8: <scale_range>: integer_function=\"floor\": only \"round\" is known"));
    CHECK(has(complaint({field(R"(<value_set offset_to_lower_limit="true"/>)")}), "offset_to_lower_limit"));
    CHECK(has(complaint({field(R"(<scale_range real_lower_limit="0" real_upper_limit="1"/>)", "short integer")}),
              "a scaled number in a signed or floating-point type"));
    CHECK(has(complaint({field("", "bit")}), "field_type=\"bit\", expected a type"));
    CHECK(has(complaint({field(R"(<value_set><value_enum enum_index="256" enum_const="Deep"/></value_set>)")}),
              "the value 256 does not fit 8 bits"));
    CHECK(has(
        complaint({field(
            R"(<value_set><value_enum enum_index="1" enum_const="A"/><value_enum enum_index="1" enum_const="B"/></value_set>)")}),
        "the value 1 has two names"));
    CHECK(has(complaint({service(message("", R"(name="A" message_id="10000")"))}),
              "expected up to four hexadecimal digits"));
    CHECK(has(complaint({service(R"(<message_def name="A" message_id="1"><body name="b"/></message_def>)")}),
              "has no header with the message's ID"));
    CHECK(has(complaint({service(message("<list name=\"L\"><count_field field_type_unsigned=\"byte\"/></list>"))}),
              "expected an unsigned type"));
    CHECK(has(complaint({service(message("<list name=\"L\"><count_field field_type_unsigned=\"unsigned byte\" "
                                         "max_count=\"300\"/><record name=\"R\"/></list>"))}),
              "counts from 0 to 300 in a number up to 255"));
    CHECK(has(complaint({fields(
                  "<fixed_field name=\"Depth\" optional=\"true\" field_type=\"unsigned byte\" field_units=\"one\"/>")}),
              "is optional, but \"DepthRec\" has no presence vector"));
    CHECK(has(complaint({fields("<presence_vector field_type_unsigned=\"unsigned byte\"/>" + std::string{depth})}),
              "has a presence vector, but nothing optional"));
    CHECK(has(complaint({fields(std::string{depth} + depth)}), "the name is there twice"));
    CHECK(has(
        complaint({fields(
            R"(<bit_field name="B" field_type_unsigned="unsigned byte"><sub_field name="a"><bit_range from_index="0" to_index="4"/></sub_field><sub_field name="b"><bit_range from_index="4" to_index="7"/></sub_field></bit_field>)")}),
        "bit 4 is in two sub-fields"));
    CHECK(has(complaint({fields(R"(<fixed_field name="?!" field_type="unsigned byte" field_units="one"/>)")}),
              "has neither letters nor digits"));
}

TEST_CASE("a choice among numbers of which one is not scaled is refused") {
    CHECK(has(complaint({fields(
                  R"(<variable_field name="Speed"><type_and_units_field>
<type_and_units_enum name="Raw" index="0" field_type="unsigned byte" field_units="one"/></type_and_units_field></variable_field>)")}),
              "file1.xml:8: <type_and_units_enum>: Raw: a form that is not scaled"));
}

TEST_CASE("a variant may have no alternative, and its tags agree with its alternatives") {
    const auto variant = [](const std::string& last, const std::string& inside) {
        return service(message("<variant name=\"V\"><vtag_field min_count=\"0\" max_count=\"" + last +
                               "\" field_type_unsigned=\"unsigned byte\"/>" + inside + "</variant>"));
    };
    const auto read = sample::read({variant("0", "")});
    REQUIRE(read);
    CHECK(read->front().inputs.front().body->children.empty());
    CHECK(
        has(complaint({variant("3", "<record name=\"R\"/>")}), "tags from 0 to 3 for 1 alternatives, expected 0 to 0"));
}

TEST_CASE("two definitions of one message must be equal") {
    const auto with = [](const std::string& name, const std::string& unit) {
        return service(
            message("<record name=\"R\"><fixed_field name=\"D\" field_type=\"unsigned byte\" field_units=\"" + unit +
                    "\"/></record>"),
            "", "name=\"" + name + "\" id=\"urn:acme:jss:survey:" + name + "\" version=\"1.0\"");
    };
    CHECK(complaint({with("A", "meter"), with("B", "meter")}) == "accepted");
    CHECK(has(complaint({with("A", "meter"), with("B", "second")}),
              "ReportDepth differs from ReportDepth in file1.xml:4"));
}

TEST_CASE("names that are no identifiers become identifiers") {
    using jsidl::identifier;
    CHECK(identifier("GPSFixTimeSeconds", "field") == "gps_fix_time_seconds");
    CHECK(identifier("Periodic (SC)", "value") == "periodic_sc");
    CHECK(identifier("128x96 (sqcif)", "value") == "value_128x96_sqcif");
    CHECK(identifier("2D scan", "value") == "value_2d_scan");
    CHECK(identifier("Joint1Offset", "field") == "joint1_offset");
    CHECK(identifier("False", "value") == "false_value");
    CHECK(identifier("GPS_SpeedOverGround", "field") == "gps_speed_over_ground");
    CHECK(identifier("TIMEOUT_FEATURE _DISABLED", "value") == "timeout_feature_disabled");
    CHECK(identifier("H.263+", "value") == "h_263");
    CHECK(identifier("  ", "value").empty());
    CHECK(jsidl::enumerators({{0, "Reserved"}, {5, "Reserved"}, {7, "--"}, {9, "On"}}) ==
          std::vector<std::string>{"reserved_0", "reserved_5", "value_7", "on"});
}

TEST_CASE("a table of facts reads back as the same services") {
    const auto read =
        sample::read({service(message(R"(<sequence name="S"><presence_vector field_type_unsigned="unsigned byte"/>
<record name="A"><fixed_field name="State" field_type="unsigned byte" field_units="one"><value_set><value_enum enum_index="0" enum_const='"Off" # \ now'/><value_range lower_limit="1" lower_limit_type="exclusive" upper_limit="2.5"/></value_set></fixed_field>
<array name="M"><fixed_field name="e" field_type="float" field_units="one"/><dimension name="r" size="2"/><dimension name="c" size="3"/></array>
<variable_format_field name="Data"><format_field><format_enum index="3" field_format="Raw bytes"/></format_field><count_field field_type_unsigned="unsigned short integer"/></variable_format_field></record>
<list name="L" optional="true"><count_field field_type_unsigned="unsigned byte" min_count="1"/><variant name="V"><vtag_field field_type_unsigned="unsigned byte" max_count="0"/></variant></list></sequence>)"))});
    REQUIRE(read);
    const auto table = jsidl::write_facts(*read);
    const auto again = jsidl::parse_facts(table, "facts");
    INFO(table);
    REQUIRE(again);
    CHECK(*again == *read);
    CHECK(jsidl::write_facts(*again) == table);
}

TEST_CASE("a fault in a table of facts is reported with its line") {
    const std::string head = "# facts\nservice Sonar urn:acme:jss:survey:Sonar 1.0\n input Ping D100\n";
    const auto complaint_about = [&](const std::string& text) {
        const auto read = jsidl::parse_facts(head + text, "facts");
        return read ? std::string{"accepted"} : read.error().message;
    };
    CHECK(complaint_about("") == "accepted");
    CHECK(complaint_about("  record R\n   number D type=u8 unit=one\n") == "accepted");
    CHECK(complaint_about("  thing R\n") == "facts:4: \"thing\" is no kind of element");
    CHECK(complaint_about("  record R\n   number D type=u9 unit=one\n") == "facts:5: \"u9\" is no type");
    CHECK(complaint_about("  record R\n   number D type=u8 unit=\"one\n") ==
          "facts:5: a quotation mark without its second one");
    CHECK(complaint_about("  record R\n     number D type=u8 unit=one\n") == "facts:5: is too far to the right");
    CHECK(complaint_about("  record R\n   number D type=u8 depth=4\n") ==
          "facts:5: \"depth=4\" is no fact of an element");
}
