#include "page.hpp"

#include "table.hpp"
#include "words.hpp"
#include <jauscat/wire/item.hpp>

#include <algorithm>
#include <array>
#include <regex>
#include <set>

namespace jauscat::reference {

namespace {

std::string class_of(const message& one) {
    static constexpr std::array names{"command", "query", "inform"};
    return names.at(one.code / 0x2000U);
}

} // namespace

std::string body_size(const message& one) {
    if (one.most == 0) return "none";
    return one.most == wire::unbounded ? counted(one.least, "byte") + " or more"
                                       : amount(one.least, one.most) + (one.most == 1 ? " byte" : " bytes");
}

namespace {

std::string heading(const message& one) { return code_text(one.code) + " " + std::string{one.name}; }

/// A member's remark without the unit and limits at its beginning, which the table has in a column of their own.
struct split_remark {
    std::string limits{}, meaning{};
};
split_remark split(const std::string& remark, const part& one) {
    static const std::regex real{R"(^(?:[A-Za-z ]+(\([^)]*\))?, )?-?[0-9.pi ]+ to -?[0-9.pi ]+(?:; (.*))?$)"};
    static const std::regex whole{R"(^(-?[0-9]+ to -?[0-9]+)(?:[,;] (.*))?$)"};
    static const std::regex unit{"[a-z]+( per second)?"};
    std::smatch match;
    if (!one.unit.empty() && std::regex_match(remark, unit)) return {one.range, {}};
    if (one.scaled && std::regex_match(remark, match, real))
        return {one.range, match.str(1) + (match.length(1) != 0 && match.length(2) != 0 ? " " : "") + match.str(2)};
    if (!one.scaled && std::regex_match(remark, match, whole)) return {match[1], match[2]};
    return {one.range, remark};
}

/// Makes the table of a message's fields and what is explained below it.
class writer {
  public:
    explicit writer(const remarks& from) : from_{from} {}
    /// Rows for parts that begin at byte `at`, in the message or, after a prefix, in an element.
    void add(const std::vector<part>& parts, const std::string& indent, std::string_view prefix,
             std::optional<std::size_t> at);
    [[nodiscard]] std::string text() const {
        return fields_.text() + "\n" + explained_ + (explained_.empty() ? "" : "\n");
    }

  private:
    void add_bits(const part& packed, const std::string& indent, const std::string& where);
    void explain(const std::string& name, const std::string& text) {
        if (seen_.insert(name).second) explained_ += "- " + name + ": " + text + "\n";
    }
    void explain_names(const enumeration& names);
    void explain_cases(const part& choice);

    const remarks& from_;
    table fields_{{"Where", "Field", "Type", "Bytes", "Values", "Meaning"}};
    std::string explained_{};
    std::set<std::string> seen_{};
};

/// The column of values: names, limits, unit, step, what counts it, what ends it.
std::string values_of(const part& one, const std::string& limits) {
    if (one.names) return code(one.names->name);
    if (!one.note.empty()) return one.note;
    if (!one.times.empty()) {
        const auto end = std::min(one.times.find(' '), one.times.size());
        return "× " + code(one.times.substr(0, end)) + one.times.substr(end);
    }
    return limits + (limits.empty() || one.unit.empty() ? "" : " ") + one.unit +
           (one.step.empty() ? "" : ", step " + one.step);
}

void writer::explain_names(const enumeration& names) {
    std::string text;
    for (const auto& [number, name] : names.entries) {
        const std::string& remark = from_.of_member(names.name, std::string{name});
        text += std::string{text.empty() ? "" : ", "} + (names.of_bits ? "bit " : "") + std::to_string(number) + " " +
                code(name) + (remark.empty() ? "" : " (" + remark + ")");
    }
    explain(code(names.name), text + ". " + from_.of_type(names.name));
}

void writer::explain_cases(const part& choice) {
    std::string cases;
    for (const part& each : choice.parts)
        cases += (cases.empty() ? "" : ", ") + numbers_of(each.tags) + " " +
                 (each.type.empty()                 ? "nothing"
                  : each.what == part::kind::record ? code(each.type)
                  : each.scaled                     ? each.type + " (" + values_of(each, each.range) + ")"
                                                    : each.type);
    explain("by " + code(choice.selector), cases + ".");
    for (const part& each : choice.parts)
        if (each.what == part::kind::record) explain(code(each.type), from_.of_type(each.type));
}

void writer::add_bits(const part& packed, const std::string& indent, const std::string& where) {
    for (const part& field : packed.parts) {
        if (field.names) explain_names(*field.names);
        const auto [limits, remark] = split(from_.of_member(field.owner, field.name), field);
        fields_.add({where, indent + (field.name.empty() ? "reserved" : code(field.name)),
                     packed.type + ", " + bits_of(field), counted(field.width, "bit"), values_of(field, limits),
                     field.name.empty() ? "sent as 0, ignored on receipt" : remark});
    }
}

void writer::add(const std::vector<part>& parts, const std::string& indent, std::string_view prefix,
                 std::optional<std::size_t> at) {
    for (const part& one : parts) {
        const bool always = condition_of(one).empty();
        const std::string where = always             ? span_of(prefix, at, one)
                                  : one.gate.empty() ? condition_of(one)
                                                     : "if " + code(one.gate);
        if (one.what == part::kind::packed) {
            add_bits(one, indent, where);
            advance(at, one);
            continue;
        }
        const auto [limits, remark] = split(from_.of_member(one.owner, one.name), one);
        const bool known = seen_.contains(code(one.type));
        if (one.names) explain_names(*one.names);
        std::string type = one.type, values = values_of(one, limits);
        const bool many = one.what == part::kind::list, whole = one.what == part::kind::record;
        if (one.what == part::kind::presence_vector) {
            values = one.width == 1 ? "bit 0" : "bits 0–" + std::to_string(one.width - 1);
            if (!one.note.empty()) values += "; " + one.note;
        } else if (one.what == part::kind::flag) {
            type = "flag";
        } else if (one.what == part::kind::choice) {
            type = "by " + code(one.selector);
            explain_cases(one);
        } else if ((many || whole) && !one.type.empty()) {
            type = (many ? "list of " : "") + code(one.type);
            explain(code(one.type), from_.of_type(one.type));
        } else if (many) {
            type = "list";
        }
        fields_.add({where, indent + code(one.name), type, amount(one.least, one.most), values, remark});
        const std::string inner = indent + "&nbsp;&nbsp;&nbsp;&nbsp;";
        if (many) add(one.parts, inner, "+", 0);
        if (whole && !known) add(one.parts, inner, prefix, always ? at : std::nullopt);
        if (one.has_rows_of_cases)
            for (const part& each : one.parts) {
                if (each.parts.empty()) continue;
                fields_.add({"", inner + "in " + code(each.type), "", "", "", ""});
                add(each.parts, inner, "+", 0);
            }
        advance(at, one);
    }
}

} // namespace

std::string field_table(const message& one, const remarks& from) {
    writer fields{from};
    fields.add(one.parts, "", "", 0);
    return fields.text();
}

namespace {

std::string section(const message& one, const remarks& from, const translation& table) {
    const message_remark remark = from.of_message(one.structure, one.name, code_digits(one.code));
    std::string made = "## " + heading(one) + "\n\n";
    if (!remark.meaning.empty()) made += remark.meaning + "\n\n";
    const std::size_t largest = std::min(one.most, table.largest_body);
    made += "**" + class_of(one) + "** · body: " + body_size(one) + " · object " + std::to_string(table.index_base) +
            " + component, subindex " + std::to_string(one.rank) +
            " · SDO packet: " + amount(table.packet + one.least, table.packet + largest) + " bytes · " +
            code("jaus::" + one.structure) + "\n\n";
    if (!remark.notes.empty()) made += "> " + remark.notes + "\n\n";
    if (one.parts.empty()) return made;
    made += "![Bytes of " + std::string{one.name} + "](" + one.diagram + ")\n\n";
    return made + field_table(one, from);
}

/// `Platform subgroup of RA 3.3 part 3: wrench effort, ...`: the name and the rest.
std::pair<std::string, std::string> title_of(const std::string& remark) {
    const auto colon = remark.find(": ");
    return {remark.substr(0, remark.find(" subgroup")), capitalised(remark.substr(colon + 2))};
}

} // namespace

std::string code_text(std::uint16_t code) { return code_digits(code) + "h"; }

std::string page(const std::string& header, const std::vector<message>& messages, const remarks& from,
                 const translation& table) {
    const auto [title, subjects] = title_of(from.of_header(header));
    std::string list, sections;
    for (const message& one : messages) {
        if (from.header_of(one.structure) != header) continue;
        list += "[" + heading(one) + "](#" + anchor(heading(one)) + ")<br>\n";
        sections += section(one, from, table);
    }
    list.erase(list.rfind("<br>"), 4);
    sections.pop_back();
    return std::string{made_by} + "# " + title + " subgroup\n\n" + subjects + " Messages of `schema/jaus/" + header +
           ".hpp`; [README.md](README.md) explains the diagrams.\n\n" + list + "\n" + sections;
}

std::string index_page(const std::vector<message>& messages, const remarks& from, const translation& table) {
    class table list({"Code", "Message", "Class", "Body", "Subindex", "Subgroup"});
    for (const message& one : messages) {
        const std::string file = from.header_of(one.structure) + ".md";
        list.add({code_text(one.code), "[" + std::string{one.name} + "](" + file + "#" + anchor(heading(one)) + ")",
                  class_of(one), body_size(one), std::to_string(one.rank),
                  "[" + title_of(from.of_header(from.header_of(one.structure))).first + "](" + file + ")"});
    }
    const std::string base = std::to_string(table.index_base), packet = std::to_string(table.packet),
                      largest = std::to_string(table.largest_body);
    return std::string{made_by} + R"(# Messages

Every message of JAUS RA 3.3, and the experimental 0404h, as this library declares them in `schemas/jauscat/schema/jaus/`.

## How to read the pages

A diagram shows a message's body from its first byte on. All numbers are little endian: least significant byte first.

![Bytes of Set Discrete Devices](diagrams/0406.svg)

- Each box is a field, with its type: `u` unsigned, `i` signed, `f` floating point, and the number of bits. The cells on
  its top edge are its bytes, if they are few; dots stand for a variable number of bytes.
- The numbers above the left edge of a box are its bytes in the body, counted from 0, if they are the same in every message. `+`
  counts from the start of a list's element.
- Blue boxes describe the layout of other fields: presence vectors with their bits, counts, type codes.
- A dashed box may be absent. `bit 3` above it is the bit of the presence vector that announces it, `if ...` a flag of an
  enclosing structure.
- A frame is a structure, or with × a list. A yellow frame holds one of several forms; `= 7` is the value that selects it.
  A structure is shown in detail only at its first occurrence in a message.
- Bits are counted from the least significant.

In the tables, *where* has the bytes of the field, or the bit or flag that announces it. A value with a *step* is a real number that
travels as an integer; the step is the value of the integer's last bit, rounded. In a `u` type 0 stands for the lower limit and all
ones for the upper one; in an `i` type 0 stands for the middle, and the most negative integer is never sent.

## In an SDO packet

Under the seed table a message for component *c* is written to object )" +
           base + R"( + *c*. The subindex is the message's position in
the list of all command codes, which does not change. The download request packet has )" +
           packet + R"( bytes and the body: 40 of header, 16 of
node, index, subindex and count, 8 of unmapped fields of the JAUS header. One packet carries up to )" +
           largest + R"( bytes of body; larger
bodies are not included in the sizes below. [translation.md](../translation.md) has the table.

## All messages

)" + list.text();
}

} // namespace jauscat::reference
