// Every message's schema against the standard's tables: names, order, types, sizes, presence bits, limits and units.
#include "schema/messages.hpp"
#include "schema/vectors.hpp"
#include "support/catch.hpp"
#include "support/paths.hpp"
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/component_id.hpp>
#include <jauscat/text/hex.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>

namespace {

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using golden::snake_case;
using pugi::xml_node;

pugi::xml_node standard() {
    static const auto document = [] {
        auto loaded = std::make_unique<pugi::xml_document>();
        REQUIRE(loaded->load_file(support::test_data("jaus_ra_3_3.xml").c_str()));
        return loaded;
    }();
    return document->child("jaus-ra");
}
xml_node named(const char* part, std::string_view kind, const std::string& name) {
    return standard().child(part).find_child_by_attribute(std::string{kind}.c_str(), "name", name.c_str());
}
std::string name_of(xml_node node) { return snake_case(node.attribute("name").value()); }

const std::map<std::string, std::string> units{
    {"", ""},
    {"bytes", ""},
    {"degrees", "deg"},
    {"degrees Celsius", "deg C"},
    {"frames per second", "1/s"},
    {"hertz", "Hz"},
    {"meters", "m"},
    {"meters per second", "m/s"},
    {"millimeters", "mm"},
    {"milliradians", "mrad"},
    {"newton meters", "N m"},
    {"percent", "%"},
    {"pixels", "px"},
    {"radians", "rad"},
    {"radians per second", "rad/s"},
    {"radians per second squared", "rad/s^2"},
    {"seconds", "s"},
};

/// Collects what differs.
class comparison {
  public:
    std::vector<std::string> differences{};

    void message(xml_node expected, const messages::message& found) {
        path_ = found.name();
        const auto size = [&](const char* which) { return expected.attribute(which).as_uint(); };
        // Shorter identifications are received.
        const bool lenient = found.code == 0x4B00;
        equal("min size", lenient ? size("min-size") - 80 : size("min-size"), found.min_size());
        if (std::string_view{expected.attribute("max-size").value()} != "variable")
            equal("max size", size("max-size"), found.max_size());
        else // an inline list ends at its capacity
            equal("variable size", true, found.max_size() > 2 * found.min_size());
        structure(expected, found.fields());
    }

  private:
    using member = text::member;

    void differ(const std::string& what) { differences.push_back(path_ + ": " + what); }
    template <class A, class B> void equal(const std::string& what, const A& expected, const B& found) {
        if (!(expected == static_cast<A>(found))) {
            std::ostringstream text;
            text << what << ": " << expected << " in the standard, " << found << " here";
            differ(text.str());
        }
    }

    /// The members of a structure against the elements of a message, group or structure, in wire order.
    void structure(xml_node expected, const text::structure& found) {
        announce_flags(found);
        int bit = -1; // of the presence vector, of the last optional member or flag
        std::size_t at = 0;
        const auto skip_flags = [&] {
            for (; at != found.members.size() && found.members[at].what == member::role::flag; ++at) ++bit;
        };
        for (const xml_node node : expected.children()) {
            if (std::string_view{node.name()} == "children") continue; // the tree's own, see tree_form
            skip_flags();
            if (at == found.members.size()) return differ(std::string{node.attribute("name").value()} + " is missing");
            const member& one = found.members[at++];
            const std::string outer = path_;
            path_ += "." + name_of(node);
            equal("name", name_of(node), one.name);
            if (one.what == member::role::presence_vector) {
                presence_vector(node, one, found, at);
            } else if (one.what == member::role::count) {
                const member& counted = found.members[at];
                equal("bit", node.attribute("bit").as_int(-1), counted.optional ? bit + 1 : -1);
                form(node, *one.how);
            } else {
                if (one.gate.owner != nullptr)
                    equal("bit", node.attribute("bit").as_int(-1),
                          gates_[{one.gate.owner, std::string{one.gate.name}}]);
                else
                    equal("bit", node.attribute("bit").as_int(-1), one.optional ? ++bit : -1);
                if (node.attribute("count")) {
                    // Further out or earlier in the structure; else right before.
                    const bool elsewhere = one.counter.owner != nullptr || at < 2;
                    equal("count", snake_case(node.attribute("count").value()),
                          elsewhere ? one.counter.name : found.members[at - 2].name);
                    equal("count's excess", node.attribute("minus").as_uint(), one.counter_excess);
                }
                form(node, *one.how);
            }
            path_ = outer;
        }
        skip_flags();
        if (at != found.members.size()) differ(std::string{found.members[at].name} + " is too much");
    }

    /// Flags may stand behind the list that has the members they announce.
    void announce_flags(const text::structure& found) {
        int bit = 0;
        for (const member& one : found.members) {
            if (one.what == member::role::flag) gates_[{found.id, std::string{one.name}}] = bit;
            bit += one.what == member::role::flag || (one.optional && one.gate.owner == nullptr);
        }
    }

    void presence_vector(xml_node node, const member& one, const text::structure& found, std::size_t at) {
        std::uint64_t mask = 0;
        for (; at != found.members.size(); ++at)
            if (const member& next = found.members[at];
                next.what == member::role::flag || (next.optional && next.gate.owner == nullptr))
                mask = mask << 1 | 1;
        equal("mask", std::stoull(node.attribute("mask").value(), nullptr, 16), mask);
        form(node, *one.how);
    }

    void form(xml_node node, const text::form& found) {
        std::visit([&](const auto& is) { form(node, is); }, found.is);
    }
    void kind(xml_node node, std::initializer_list<std::string_view> allowed) {
        if (std::ranges::find(allowed, node.name()) == allowed.end()) differ("is a " + std::string{node.name()});
    }
    void number(xml_node node, unsigned bits, bool is_signed, std::string_view unit) {
        const std::string type = node.attribute("type").value();
        equal("bits", node.attribute("width").as_uint(node.attribute("size").as_uint() * 8), bits);
        equal("signed", std::string_view{named("data-types", "type", type).attribute("signed").value()} == "yes",
              is_signed);
        equal("unit", units.at(node.attribute("units").value()), unit);
    }

    void form(xml_node node, const text::integer_form& is) {
        kind(node, {"field", "presence-vector"});
        number(node, is.bits, is.is_signed, is.unit);
        equal("scaled", node.attribute("lower").empty(), true);
        using meaning = text::integer_form::meaning;
        if (is.what == meaning::enumeration) values(node, "enum", "value", is);
        if (is.what == meaning::flags) values(node, "bit", "n", is);
        if (is.what == meaning::number) equal("flags", node.child("bit").empty(), true);
    }
    /// Every value that the standard names has that name here, and no other has one.
    void values(xml_node node, const char* element, const char* attribute, const text::integer_form& is) {
        std::map<std::size_t, std::string> expected, found;
        // Types of values are named where they are first told of; that of no value has a case, but no name.
        const bool is_type = name_of(node) == "data_type";
        if (is_type) {
            node = named("structures", "structure", "EventLimit").child("field");
            expected[255] = "none";
        }
        for (const xml_node one : node.children(element))
            if (const std::string_view value = one.attribute(attribute).value();
                value.find('-') == value.npos && name_of(one) != "reserved")
                expected[one.attribute(attribute).as_uint()] = name_of(one);
        for (std::size_t i = 0; i != is.names.size(); ++i)
            if (!is.names[i].empty()) found[i] = is.names[i];
        for (const auto& [value, name] : expected) equal("value " + std::to_string(value), name, found[value]);
        for (const auto& [value, name] : found)
            if (!name.empty() && !expected.contains(value)) differ("the standard has no value " + name);
    }
    void form(xml_node node, const text::scaled_form& is) {
        kind(node, {"field"});
        number(node, is.bits, is.is_signed, is.unit);
        equal("lower limit", node.attribute("lower").as_double(std::numeric_limits<double>::quiet_NaN()), is.min);
        equal("upper limit", node.attribute("upper").as_double(std::numeric_limits<double>::quiet_NaN()), is.max);
    }
    void form(xml_node node, const text::real_form& is) {
        kind(node, {"field"});
        const bool is_single = is.most == static_cast<double>(std::numeric_limits<float>::max());
        equal("type", std::string{node.attribute("type").value()}, is_single ? "Float" : "Long Float");
        equal("unit", units.at(node.attribute("units").value()), is.unit);
    }
    void form(xml_node node, const text::packed_form& is) {
        kind(node, {"field"});
        number(node, is.bits, false, {});
        std::string structure = node.attribute("name").value(); // "Time Stamp" is laid out by TimeStamp
        std::erase(structure, ' ');
        unsigned first = 0;
        std::size_t at = 0;
        for (const xml_node bits : named("structures", "structure", structure).children("bits")) {
            if (at == is.of->members.size()) return differ("bits are missing");
            const member& one = is.of->members[at++];
            const unsigned width = std::get<text::integer_form>(one.how->is).bits;
            equal("bits", name_of(bits), one.name);
            equal("first bit", bits.attribute("first").as_uint(), first);
            equal("width", bits.attribute("width").as_uint(), width);
            first += width;
        }
        equal("packed members", at, is.of->members.size());
    }
    void form(xml_node node, const text::octets_form& is) {
        // Payload elements have types that do not travel with them.
        if (std::string_view{node.name()} == "group") {
            equal("key", std::string{"interface"}, node.child("variant").attribute("key").value());
            return;
        }
        kind(node, {"string", "bytes"});
        equal("characters", std::string_view{node.name()} == "string", is.characters);
        const std::string_view length = node.attribute("length").value();
        equal("fixed", length == "fixed", is.zero_filled);
        equal("zero-terminated", length == "zero-terminated", is.zero_terminated);
        equal("rest", length == "rest", is.most == wire::unbounded && !is.zero_terminated);
        if (length == "fixed") equal("length", node.attribute("size").as_uint(), is.most);
    }
    void form(xml_node node, const text::structure_form& is) {
        if (std::string_view{node.name()} != "struct") return structure(node, *is.of);
        structure(named("structures", "structure", node.attribute("type").value()), *is.of);
    }
    void form(xml_node node, const text::encoded_form&) { kind(node, {"jaus-message"}); }
    void form(xml_node node, const text::list_form& is) {
        kind(node, {"group"});
        if (is.field.empty()) return form(node, *is.element);
        equal("name in the group", name_of(node.first_child()), is.field);
        form(node.first_child(), *is.element);
    }
    void form(xml_node node, const text::tree_form& is) {
        kind(node, {"struct"});
        equal("children", false,
              named("structures", "structure", node.attribute("type").value()).child("children").empty());
        form(node, *is.nodes.element);
    }
    void form(xml_node node, const text::variant_form&) { kind(node, {"no message of RA 3.3 has one"}); }
    void form(xml_node node, const text::choice_form& is) {
        kind(node, {"variant"});
        const xml_node table = named("type-tables", "table", node.attribute("table").value());
        std::set<std::uint64_t> found;
        for (const auto& one : is.cases) {
            found.insert(one.tag);
            const xml_node expected = table.find_child_by_attribute("case", "value", std::to_string(one.tag).c_str());
            const std::string outer = path_;
            path_ += "." + std::to_string(one.tag);
            if (!expected)
                differ("is no case in the standard");
            else if (one.how == nullptr)
                equal("empty", true, expected.first_child().empty());
            else if (std::holds_alternative<text::structure_form>(one.how->is))
                structure(expected, *std::get<text::structure_form>(one.how->is).of);
            else
                form(expected.first_child(), *one.how);
            path_ = outer;
        }
        for (const xml_node one : table.children("case"))
            if (!found.contains(one.attribute("value").as_uint()))
                differ(std::string{"case "} + one.attribute("value").value());
    }

    std::string path_{};
    std::map<std::pair<const void*, std::string>, int> gates_{}; ///< bits by structure and flag
};

} // namespace

TEST_CASE("codes, names and classes equal those of the standard's catalogue") {
    std::size_t count = 0;
    for (const xml_node message : standard().child("messages").children()) {
        INFO(message.attribute("name").value());
        const auto code = static_cast<std::uint16_t>(std::stoul(message.attribute("code").value(), nullptr, 16));
        const auto entry = std::ranges::find(jaus::catalog, code, &jaus::catalog_entry::command_code);
        REQUIRE(entry != jaus::catalog.end());
        CHECK(entry->name == message.attribute("name").value());
        CHECK(message.attribute("class").value() == std::string{code < 0x2000   ? "command"
                                                                : code < 0x4000 ? "query"
                                                                                : "inform"});
        ++count;
    }
    CHECK(count == jaus::catalog.size());
}

TEST_CASE("every field of every message equals the standard's") {
    comparison all;
    for (const auto& message : messages::all()) {
        std::string code = text::hex_number(message.code, 4).substr(2);
        all.message(standard().child("messages").find_child_by_attribute("message", "code", code.c_str()), message);
    }
    for (const auto& difference : all.differences) {
        FAIL_CHECK(difference);
    }
}

TEST_CASE("component IDs have the standard's names") {
    std::size_t count = 0;
    for (const xml_node component : standard().child("components").children("component")) {
        const auto id = static_cast<std::uint8_t>(component.attribute("id").as_uint());
        CHECK(jaus::component_name(id) == component.attribute("name").value());
        ++count;
    }
    CHECK(count == jaus::component_kinds.size());
    STATIC_REQUIRE(jaus::component_name(jaus::component_ids::primitive_driver) == "Primitive Driver");
    STATIC_REQUIRE(jaus::component_name(60).empty());
}
