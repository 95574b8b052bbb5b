// The writer of schema headers.
#pragma once
#include <jauscat/jsidl/expression.hpp>
#include <jauscat/jsidl/schema_plan.hpp>
#include <jauscat/jsidl/write_schemas.hpp>

#include <charconv>
#include <cmath>
#include <numbers>

namespace jauscat::jsidl {
namespace detail {

inline constexpr std::size_t line_length = 120;

/// A template with its arguments, which stand in one line or in a line each.
struct term {
    std::string head{};
    std::vector<term> arguments{};
    bool in_lines{};    ///< even if it would fit one line
    std::size_t kept{}; ///< arguments that stay in the first line

    [[nodiscard]] bool is_broken() const { return in_lines || std::ranges::any_of(arguments, &term::is_broken); }
    [[nodiscard]] std::string in_one_line() const {
        if (arguments.empty()) return head;
        std::string made = head + '<';
        for (const auto& each : arguments) (made += &each == &arguments.front() ? "" : ", ") += each.in_one_line();
        return made + '>';
    }
    /// The head as a template with its arguments.
    [[nodiscard]] term parsed() const {
        const auto open = head.find('<');
        term made{.head = head.substr(0, open)};
        int depth = 0;
        std::string argument;
        for (const char c : head.substr(open + 1, head.size() - open - 2)) {
            depth += c == '<' ? 1 : c == '>' ? -1 : 0;
            if (c == ',' && depth == 0) {
                made.arguments.push_back({.head = std::exchange(argument, {})});
            } else if (c != ' ' || !argument.empty()) {
                argument += c;
            }
        }
        made.arguments.push_back({.head = argument});
        made.kept = made.arguments.size() == 2 ? 1 : 0; // a member, a tag
        return made;
    }
    /// `end` is what stands behind it.
    void print(std::string& out, std::size_t indent, const std::string& end) const {
        const auto line = std::string(indent, ' ') + in_one_line() + end;
        if (arguments.empty() && line.size() > line_length && head.ends_with('>'))
            return parsed().print(out, indent, end);
        if (arguments.empty() || (!is_broken() && line.size() <= line_length)) {
            out += line + '\n';
            return;
        }
        out += std::string(indent, ' ') + head + '<';
        for (std::size_t i = 0; i != kept; ++i) (out += i == 0 ? "" : " ") += arguments[i].in_one_line() + ',';
        out += '\n';
        for (std::size_t i = kept; i != arguments.size(); ++i)
            arguments[i].print(out, indent + 4, i + 1 == arguments.size() ? '>' + end : std::string{","});
    }
};

/// A number without exponent where that is short.
inline std::string decimal(double value) {
    std::array<char, 64> digits{};
    const bool is_plain = std::abs(value) < 1e15 && (value == 0 || std::abs(value) >= 1e-5);
    const auto written =
        is_plain ? std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed)
                 : std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), written.ptr};
}
/// The same with multiples of pi as such: `8 pi`, `pi / 2`.
inline std::string with_pi(double value) {
    const std::string sign = value < 0 ? "-" : "";
    const double size = std::abs(value);
    if (size == std::numbers::pi / 2) return sign + "pi / 2";
    for (int factor = 1; factor != 65; ++factor)
        if (size == factor * std::numbers::pi) return sign + (factor == 1 ? "" : std::to_string(factor) + ' ') + "pi";
    return decimal(value);
}
/// A part of an identifier: `minus_327_68`, `8_pi`.
inline std::string number_word(double value) {
    std::string made;
    for (const char c : with_pi(value)) {
        if (c == '-')
            made += "minus_";
        else if (c == '/')
            made += "by";
        else
            made += c == ' ' || c == '.' || c == '+' ? '_' : c;
    }
    return made;
}
inline std::string range_name(const std::string& unit, const scale& limits) {
    return identifier(unit, "unit") + '_' + number_word(limits.min) + "_to_" + number_word(limits.max);
}

inline std::string_view type_name(scalar type) {
    constexpr std::array<std::string_view, 10> names{"std::uint8_t", "std::uint16_t", "std::uint32_t", "std::uint64_t",
                                                     "std::int8_t",  "std::int16_t",  "std::int32_t",  "std::int64_t",
                                                     "float",        "double"};
    return names[static_cast<std::size_t>(type)];
}
inline std::string_view codec_name(scalar type) {
    constexpr std::array<std::string_view, 10> names{"u8",    "u16le", "u32le", "u64le", "i8",
                                                     "i16le", "i32le", "i64le", "f32le", "f64le"};
    return names[static_cast<std::size_t>(type)];
}
inline std::string hexadecimal(std::uint16_t value) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string made;
    for (int shift = 12; shift >= 0; shift -= 4) made += digits[value >> shift & 0xF];
    return made;
}

/// Ranges and units of all sets, by name.
struct units {
    std::map<std::string, std::pair<std::string, scale>> ranges{};
    std::map<std::string, std::string> plain{}; ///< of numbers that are not scaled

    void add(const element& of) {
        if (of.scale) ranges.emplace(range_name(of.unit, *of.scale), std::pair{of.unit, *of.scale});
        if ((of.kind == kind::number || of.kind == kind::choice_form) && !of.scale && of.names.empty() &&
            of.unit != "one")
            plain.emplace(identifier(of.unit, "unit"), of.unit);
        for (const auto& each : of.children) add(each);
    }
};

/// Writes the headers of one set.
class set_writer {
  public:
    set_writer(const schema_plan& plan, const schema_options& options) : plan_{plan}, options_{options} {
        const auto colons = options.name_space.rfind("::");
        outer_ = colons == std::string::npos ? options.name_space : options.name_space.substr(colons + 2);
        library_ = options.name_space.starts_with("jauscat::") ? "" : "jauscat::";
    }

    void write(schema_headers& out) {
        for (const auto* const one : plan_.services)
            out[plan_.set + '/' + schema_plan::file_of(*one) + ".hpp"] = service_header(*one);
        if (plan_.has_shared()) out[plan_.set + "/shared.hpp"] = shared_header();
        out[plan_.set + ".hpp"] = set_header();
    }

  private:
    struct member {
        std::string type{};
        std::string name{};
        std::string comment{};
        term item{};
    };

    static std::string note(const std::string& what) {
        return "// " + what + "\n// Written by jauscat-jsidl: do not edit it, write it again.\n#pragma once\n";
    }
    std::string include(const std::string& path) const {
        return "#include <" + options_.include_prefix + '/' + path + ">\n";
    }
    std::string opened() const {
        return "// One line per field, as in the standard's tables.\n// clang-format off\nnamespace " +
               options_.name_space + "::" + plan_.set + " {\n";
    }
    std::string closed() const { return "\n} // namespace " + options_.name_space + "::" + plan_.set + "\n"; }

    std::string types_header(const std::string& file, const std::string& title, bool with_shared,
                             const std::string& more) {
        std::string types;
        written_.clear();
        for (const auto& each : plan_.messages) {
            for (const auto* const one : each.parts) write_part(types, *one, file);
            if (each.file == file) write_message(types, each);
        }
        std::string made = note(title) + "#include <jauscat/schema/jaus/message_list.hpp>\n";
        made += with_shared ? include(plan_.set + "/shared.hpp") : include("ranges.hpp");
        made += "#include <jauscat/wire/schema.hpp>\n\n#include <array>\n#include <cstdint>\n#include "
                "<optional>\n#include <string_view>\n#include <variant>\n\n";
        return made + opened() + types + more + closed();
    }
    std::string service_header(const service& one) {
        return types_header(schema_plan::file_of(one), one.name + ' ' + one.version + ", " + one.id + ".",
                            plan_.has_shared(), service_type(one));
    }
    std::string shared_header() {
        return types_header(std::string{schema_plan::shared_file},
                            "Messages and types that several services of the set " + plan_.set + " have.", false, "");
    }
    std::string set_header() const {
        std::string made = note("All services of the set " + plan_.set + ", and the list of their messages.");
        made += "#include <jauscat/schema/jaus/message_list.hpp>\n";
        std::set<std::string> files;
        for (const auto* const one : plan_.services) files.insert(schema_plan::file_of(*one));
        for (const auto& each : files) made += include(plan_.set + '/' + each + ".hpp");
        std::vector<std::pair<std::uint16_t, std::string>> sorted;
        for (const auto& each : plan_.messages) sorted.emplace_back(each.of->id, each.name);
        std::ranges::sort(sorted);
        std::vector<std::string> names;
        for (const auto& [id, name] : sorted) names.push_back(name);
        made += '\n' + opened() + "\n/// Each message once, by its ID.\n";
        made += list_of("messages", names, 0);
        return made + closed();
    }

    std::string list_of(const std::string& name, const std::vector<std::string>& types, std::size_t indent) const {
        std::string made;
        term list{
            .head = "using " + name + " = " + library_ + "jaus::message_list", .arguments = {}, .in_lines = false};
        for (const auto& each : types) list.arguments.push_back({.head = each});
        if (types.empty()) return std::string(indent, ' ') + list.head + "<>;\n";
        if (list.in_one_line().size() + indent + 1 <= line_length) {
            list.print(made, indent, ";");
            return made;
        }
        made = std::string(indent, ' ') + list.head + "<\n";
        for (const auto& each : types)
            made += std::string(indent + 4, ' ') + each + (&each == &types.back() ? ">;\n" : ",\n");
        return made;
    }
    std::string service_type(const service& one) const {
        const auto names = [&](const std::vector<message>& list) {
            std::vector<std::string> made;
            for (const auto& each : list) made.push_back(plan_.planned(each).name);
            return made;
        };
        const auto text = [](const std::string& name, const std::string& value) {
            return "    static constexpr std::string_view " + name +
                   (value.empty() ? "{}" : " = " + text::quoted(value)) + ";\n";
        };
        std::string made = "\nnamespace services {\n\n/// " + one.name +
                           ": what it is called, and its messages.\nstruct " + schema_plan::file_of(one) + " {\n";
        made += text("name", one.name) + text("uri", one.id) + text("version", one.version);
        made += text("parent_uri", one.inherits ? one.inherits->id : "");
        made += text("parent_version", one.inherits ? one.inherits->version : "");
        made += list_of("inputs", names(one.inputs), 4) + list_of("outputs", names(one.outputs), 4);
        made += "    using messages = " + library_ +
                "jaus::joined_lists<inputs, outputs>;\n};\n\n} // namespace services\n";
        return made;
    }

    void write_part(std::string& out, const part& use, const std::string& file) {
        const auto& one = plan_.type_of(*use.of, use.role);
        for (const auto* const inner : one.parts) write_part(out, *inner, file);
        if (plan_.file_of(one) != file || !written_.insert(one.name()).second) return;
        if (one.role == role::enumeration)
            write_enumeration(out, one);
        else
            write_structure(out, one);
    }
    static void write_enumeration(std::string& out, const part& one) {
        out += "\n/// Values of " + one.of->name + ".\nenum class " + one.name() + " : " +
               std::string{type_name(one.shape.type)} + " {\n";
        const auto names = enumerators(one.shape.names);
        const auto line = [&](std::size_t i) {
            return "    " + names[i] + " = " + std::to_string(one.shape.names[i].value) + ',';
        };
        std::size_t width = 0;
        for (std::size_t i = 0; i != names.size(); ++i)
            if (needs_name(one.shape.names[i].name, names[i])) width = std::max(width, line(i).size());
        for (std::size_t i = 0; i != names.size(); ++i) {
            auto text = line(i);
            if (needs_name(one.shape.names[i].name, names[i])) {
                text.resize(width, ' ');
                text += " ///< " + one.shape.names[i].name;
            }
            out += text + '\n';
        }
        out += "};\n";
    }
    /// Whether the identifier does not show the name.
    static bool needs_name(const std::string& name, const std::string& made) {
        return snake_case(name) != made ||
               !std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c) || c == ' '; });
    }

    static std::string title_of(const element& of) {
        switch (of.kind) {
        case kind::bits: return "Bits of " + of.name + '.';
        case kind::choice: return of.name + ": a number in the form that is named before it.";
        case kind::formatted_blob: return of.name + ": octets in the format that is named before them.";
        case kind::list: return "List " + of.name + '.';
        case kind::variant: return "Variant " + of.name + (of.children.empty() ? ", which has no alternative." : ".");
        case kind::sequence: return "Sequence " + of.name + '.';
        default: return "Record " + of.name + '.';
        }
    }
    void write_structure(std::string& out, const part& one) {
        const auto& of = *one.of;
        owner_ = one.name();
        std::vector<member> members;
        std::vector<term> items;
        note_members(of);
        switch (of.kind) {
        case kind::list: {
            auto made = list_member(of, "elements");
            items.push_back(made.item);
            members.push_back(std::move(made));
            break;
        }
        case kind::variant:
            if (of.children.empty()) {
                items.push_back({.head = "constant<\"index\", " + std::string{codec_name(of.type)} + ", 0>"});
            } else {
                auto made = variant_member(of, "value");
                items.push_back(made.item);
                members.push_back(std::move(made));
            }
            break;
        case kind::choice: write_choice(of, members, items); break;
        case kind::formatted_blob: write_formatted(of, members, items); break;
        case kind::bits: write_bits(of, members, items); break;
        default: write_members(of, members, items); break;
        }
        out += "\n/// " + title_of(of) + '\n';
        write_type(out, "", members, items);
    }
    void write_message(std::string& out, const planned_message& each) {
        owner_ = each.name;
        std::vector<member> members;
        std::vector<term> items;
        if (const auto& body = each.of->body) {
            if (body->kind == kind::record || body->kind == kind::sequence) {
                note_members(*body);
                write_members(*body, members, items);
            } else {
                member_names_ = {member_name(*body, owner_)};
                members.push_back(member_for(*body));
                items.push_back(members.back().item);
            }
        }
        out += '\n' + message_title(each);
        items.insert(items.begin(), {.head = "constant<\"message_id\", u16le, message_id>"});
        std::string facts = "        static constexpr std::uint16_t message_id = 0x" + hexadecimal(each.of->id) + ";\n";
        facts += std::string{"        static constexpr bool is_command = "} + (each.of->is_command ? "true" : "false") +
                 ", is_deprecated = " + (each.of->is_deprecated ? "true" : "false") + ";\n";
        write_type(out, facts, members, items);
    }
    static std::string message_title(const planned_message& each) {
        std::string made;
        std::string line = "/// " + each.of->name + ": ID " + hexadecimal(each.of->id) + 'h' +
                           (each.of->is_command ? ", command" : "") + (each.of->is_deprecated ? ", deprecated" : "");
        const auto add = [&](const std::string& word) {
            if (line.size() + 2 + word.size() > line_length) { // and a full stop
                made += line + '\n';
                line = "///";
            }
            line += ' ' + word;
        };
        const auto add_services = [&](const std::string& direction, const std::vector<const service*>& services) {
            if (services.empty()) return;
            line += ',';
            add(direction);
            add("of");
            for (const auto* const one : services) add(one->name + (one == services.back() ? "" : ","));
        };
        add_services("input", each.inputs);
        add_services("output", each.outputs);
        return made + line + ".\n";
    }

    void write_type(std::string& out, const std::string& facts, const std::vector<member>& members,
                    const std::vector<term>& items) const {
        out += "struct " + owner_ + " {\n";
        std::size_t width = 0;
        for (const auto& each : members)
            if (!each.comment.empty()) width = std::max(width, declaration(each).size());
        for (const auto& each : members) {
            auto line = "    " + declaration(each);
            if (!each.comment.empty()) {
                const auto aligned = line + std::string(width + 4 - line.size(), ' ') + " ///< " + each.comment;
                line = aligned.size() <= line_length ? aligned : line + " ///< " + each.comment;
                if (line.size() > line_length) {
                    out += "    /// " + each.comment + '\n';
                    line = "    " + declaration(each);
                }
            }
            out += line.size() > line_length ? in_lines(each) : line + '\n';
        }
        const std::string type = "const " + owner_ + '&';
        auto equal = "    friend constexpr bool operator==(" + type + ", " + type + ") = default;\n";
        if (equal.size() - 1 > line_length)
            equal = "    friend constexpr bool operator==(\n        " + type + ",\n        " + type + ") = default;\n";
        out += equal + "\n    struct schema : " + library_ + "wire::items {\n" + facts;
        if (!members.empty()) out += "        using T = " + owner_ + ";\n";
        const term layout{.head = "using type = layout", .arguments = items, .in_lines = items.size() > 1};
        layout.print(out, 8, ";");
        out += "    };\n};\n";
    }
    /// A declaration that one line does not hold.
    static std::string in_lines(const member& each) {
        std::string made;
        term{.head = each.type}.print(made, 4, ' ' + each.name + "{};");
        const auto last = made.rfind('\n', made.size() - 2);
        if (made.size() - 1 - (last + 1) <= line_length) return made;
        made.clear();
        term{.head = each.type}.print(made, 4, "");
        return made + "        " + each.name + "{};\n";
    }
    static std::string declaration(const member& each) { return each.type + ' ' + each.name + "{};"; }

    void note_members(const element& of) {
        member_names_.clear();
        switch (of.kind) {
        case kind::list: member_names_ = {"elements"}; return;
        case kind::variant: member_names_ = {"value"}; return;
        case kind::choice: member_names_ = {"index", "value"}; return;
        case kind::formatted_blob: member_names_ = {"format", "data"}; return;
        default: break;
        }
        for (const auto& each : of.children) member_names_.insert(member_name(each, owner_));
    }
    /// The name of a type of the set, where a member may have the same name.
    std::string type_in_set(const std::string& name) const {
        return member_names_.contains(name) ? plan_.set + "::" + name : name;
    }
    std::string structure(const element& of) const { return type_in_set(plan_.type_of(of, role::structure).name()); }
    std::string enumeration(const element& of) const {
        return type_in_set(plan_.type_of(of, role::enumeration).name());
    }
    /// The name of a range or unit, which are outside of the set.
    std::string unit_name(const std::string& name) const {
        return member_names_.contains(name) || plan_.is_type(name) ? outer_ + "::" + name : name;
    }

    void write_members(const element& of, std::vector<member>& members, std::vector<term>& items) {
        std::vector<term> made;
        for (const auto& each : of.children) {
            members.push_back(member_for(each));
            made.push_back(members.back().item);
        }
        if (!of.presence) {
            items = std::move(made);
            return;
        }
        made.insert(made.begin(), {.head = std::string{codec_name(*of.presence)}});
        items.push_back(
            {.head = "lenient_presence", .arguments = std::move(made), .in_lines = of.children.size() > 1, .kept = 1});
    }
    void write_bits(const element& of, std::vector<member>& members, std::vector<term>& items) const {
        auto parts = of.children;
        std::ranges::sort(parts, {}, &element::first_bit);
        std::vector<term> made{{.head = std::string{codec_name(of.type)}}};
        std::uint32_t next = 0;
        const auto reserve = [&](std::uint32_t until) {
            if (until != next) made.push_back({.head = "reserved<" + std::to_string(until - next) + '>'});
        };
        for (const auto& sorted : parts) {
            const auto& each = *std::ranges::find(of.children, sorted.first_bit, &element::first_bit);
            reserve(each.first_bit);
            next = each.last_bit + 1;
            const auto width = width_of(each);
            members.push_back(
                {.type = each.names.empty() ? std::string{type_name(unsigned_of(width))} : enumeration(each),
                 .name = member_name(each, owner_),
                 .comment = limits_of(each)});
            const auto values = value_set(each, 0, std::ldexp(1.0, static_cast<int>(width)) - 1);
            made.push_back({.head = (values.empty() ? "bit_field<&T::" : "bit_field_in_set<&T::") +
                                    members.back().name + ", " + std::to_string(width) + values + '>'});
        }
        reserve(static_cast<std::uint32_t>(bits_of(of.type)));
        items.push_back({.head = "bit_fields", .arguments = std::move(made), .in_lines = true, .kept = 1});
    }
    member variant_member(const element& of, const std::string& name) const {
        std::string types;
        std::set<std::string> different;
        for (const auto& each : of.children) {
            const auto alternative = structure(each);
            if (!different.insert(alternative).second)
                fail(errc::unsupported, plan_.services.front()->source, of.line, name_of(of.kind),
                     of.name + ": two alternatives are the same structure, " + alternative);
            types += (types.empty() ? "" : ", ") + alternative;
        }
        return {.type = "std::variant<" + types + '>',
                .name = name,
                .item = {.head = "variant<&T::" + name + ", " + std::string{codec_name(of.type)} + '>'}};
    }
    void write_choice(const element& of, std::vector<member>& members, std::vector<term>& items) const {
        const auto form = enumeration(of);
        members.push_back({.type = form, .name = "index"});
        items.push_back({.head = "field<&T::index, enumeration<" + form + ", u8>>"});
        std::vector<named_value> values;
        for (const auto& each : of.children) values.push_back({each.index, each.name});
        const auto names = enumerators(values);
        std::vector<term> cases{{.head = "&T::value"}, {.head = "by<&T::index>"}};
        std::string comment;
        for (std::size_t i = 0; i != names.size(); ++i) {
            const auto& each = of.children[i];
            cases.push_back({.head = "when<" + form + "::" + names[i] + ", " + codec(each) + '>'});
            const auto one = limits_of(each);
            if (comment.empty())
                comment = one;
            else if (comment != one)
                comment = "as its form says";
        }
        members.push_back({.type = "double", .name = "value", .comment = comment});
        items.push_back({.head = "selected", .arguments = std::move(cases), .in_lines = true, .kept = 2});
    }
    void write_formatted(const element& of, std::vector<member>& members, std::vector<term>& items) const {
        const auto format = enumeration(of);
        members.push_back({.type = format, .name = "format"});
        const bool has_message = std::ranges::any_of(of.children, is_message, &element::format);
        std::vector<named_value> formats;
        for (const auto& each : of.children) formats.push_back({each.index, each.format});
        const element values{.kind = kind::number, .type = scalar::u8, .names = std::move(formats)};
        items.push_back({.head = "field<&T::format, " + with_values("enumeration<" + format + ", u8>", values) + '>'});
        members.push_back({.type = library_ + (has_message ? "wire::embedded_message" : "wire::blob"),
                           .name = "data",
                           .comment = count_of(of, "octets")});
        items.push_back(
            {.head = (has_message ? "embedded<&T::data, " : "bytes<&T::data, ") + count("data_size", of) + '>'});
    }
    static bool is_message(const std::string& format) { return format == "JAUS MESSAGE"; }

    /// A count, with its limits where they are narrower than its type.
    static std::string count(const std::string& name, const element& of) {
        const auto head = '"' + name + "\", " + std::string{codec_name(of.type)};
        if (of.min_count == 0 && of.max_count == most_of(of.type)) return "count<" + head + '>';
        return "count_between<" + head + ", " + std::to_string(of.min_count) + ", " + std::to_string(of.max_count) +
               '>';
    }
    /// The value set as arguments of a template: `, between<0, 5>, one_of<9>`; empty for all numbers from `least` to
    /// `most`.
    static std::string value_set(const element& of, double least, double most) {
        std::vector<std::pair<double, double>> ranges;
        for (const auto& each : of.names)
            ranges.emplace_back(static_cast<double>(each.value), static_cast<double>(each.value));
        for (const auto& each : of.ranges) {
            const double first = each.with_min ? std::ceil(each.min) : std::floor(each.min) + 1;
            const double last = each.with_max ? std::floor(each.max) : std::ceil(each.max) - 1;
            ranges.emplace_back(std::max(first, least), std::min(last, most));
        }
        std::erase_if(ranges, [](const auto& each) { return each.first > each.second; });
        std::ranges::sort(ranges);
        std::vector<std::pair<double, double>> joined;
        for (const auto& each : ranges) {
            if (!joined.empty() && each.first <= joined.back().second + 1)
                joined.back().second = std::max(joined.back().second, each.second);
            else
                joined.push_back(each);
        }
        if (joined.empty() || joined.front() == std::pair{least, most}) return {};
        std::string made, single;
        for (const auto& [first, last] : joined) {
            if (first == last)
                single += (single.empty() ? "" : ", ") + decimal(first);
            else
                made += ", between<" + decimal(first) + ", " + decimal(last) + '>';
        }
        return made + (single.empty() ? "" : ", one_of<" + single + '>');
    }
    static std::string with_values(const std::string& codec, const element& of) {
        const auto bits = static_cast<int>(bits_of(of.type));
        const bool is_signed = of.type > scalar::u64;
        const double most = std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1;
        const auto values = value_set(of, is_signed ? -most - 1 : 0, most);
        return values.empty() ? codec : "in_value_set<" + codec + values + '>';
    }
    static std::string count_of(const element& of, const std::string& what) {
        return (of.min_count == 0 ? "up to " : std::to_string(of.min_count) + " to ") + std::to_string(of.max_count) +
               ' ' + what;
    }
    static std::string limits_of(const element& of) {
        std::string made = of.unit.empty() || of.unit == "one" ? "" : of.unit;
        const auto add = [&](const std::string& what) { made += (made.empty() ? "" : ", ") + what; };
        if (of.scale) add(with_pi(of.scale->min) + " to " + with_pi(of.scale->max));
        for (const auto& each : of.ranges)
            add(each.min == each.max ? with_pi(each.min)
                                     : (each.with_min ? "" : "above ") + with_pi(each.min) + " to " +
                                           (each.with_max ? "" : "below ") + with_pi(each.max));
        return made;
    }
    std::string codec(const element& of) const {
        const std::string plain{codec_name(of.type)};
        if (of.scale) return "scaled<" + plain + ", " + unit_name(range_name(of.unit, *of.scale)) + '>';
        if (!of.names.empty()) return with_values("enumeration<" + enumeration(of) + ", " + plain + '>', of);
        if (of.unit != "one")
            return with_values("in_units<" + plain + ", " + unit_name(identifier(of.unit, "unit")) + '>', of);
        return with_values(plain, of);
    }
    std::string number_type(const element& of) const {
        if (of.scale) return "double";
        return of.names.empty() ? std::string{type_name(of.type)} : enumeration(of);
    }
    member list_member(const element& of, const std::string& name) const {
        const auto inner = structure(of.children.front());
        const auto type = of.capacity == 0
                              ? library_ + "wire::list<" + inner + '>'
                              : library_ + "wire::inline_list<" + inner + ", " + std::to_string(of.capacity) + '>';
        return {.type = type,
                .name = name,
                .comment = count_of(of, "elements"),
                .item = {.head = "repeated<&T::" + name + ", " + count("number_of_" + name, of) + '>'}};
    }
    member member_for(const element& of) const {
        member made{.name = member_name(of, owner_)};
        const auto with_name = [&](const std::string& item, const std::string& more) {
            return term{.head = item + "<&T::" + made.name + (more.empty() ? "" : ", ") + more + '>'};
        };
        switch (of.kind) {
        case kind::number:
            made.type = number_type(of);
            made.comment = limits_of(of);
            made.item = with_name("field", codec(of));
            break;
        case kind::fixed_string:
            made.type = "std::string_view";
            made.comment = "up to " + std::to_string(of.max_count) + " characters";
            made.item = with_name("string", "fixed<" + std::to_string(of.max_count) + '>');
            break;
        case kind::string:
            made.type = "std::string_view";
            made.comment = count_of(of, "characters");
            made.item = with_name("string", count(made.name + "_size", of));
            break;
        case kind::blob:
            made.type = library_ + (is_message(of.format) ? "wire::embedded_message" : "wire::blob");
            made.comment = of.format + ", " + count_of(of, "octets");
            made.item = with_name(is_message(of.format) ? "embedded" : "bytes", count(made.name + "_size", of));
            break;
        case kind::array: {
            const auto& inner = of.children.front();
            std::uint64_t size = 1;
            std::string sizes;
            for (const auto each : of.dimensions) {
                size *= each;
                sizes += (sizes.empty() ? "" : " by ") + std::to_string(each);
            }
            made.type = "std::array<" + number_type(inner) + ", " + std::to_string(size) + '>';
            made.comment = limits_of(inner);
            if (of.dimensions.size() > 1)
                made.comment += (made.comment.empty() ? "" : "; ") + sizes + ", the last dimension first";
            made.item = with_name("array", codec(inner));
            break;
        }
        case kind::list: made = list_member(of, made.name); break;
        case kind::variant:
            if (!of.children.empty()) {
                made = variant_member(of, made.name);
                break;
            }
            [[fallthrough]];
        default:
            made.type = structure(of);
            made.item = with_name("nested", "");
            break;
        }
        if (of.optional) made.type = "std::optional<" + made.type + '>';
        return made;
    }

    const schema_plan& plan_;
    const schema_options& options_;
    std::string outer_{};
    std::string library_{};
    std::string owner_{};
    std::set<std::string> member_names_{};
    std::set<std::string> written_{};
};

inline std::string ranges_header(const units& used, const schema_options& options) {
    std::string made =
        "// Ranges and units of the messages.\n// Written by jauscat-jsidl: do not edit it, write it again.\n"
        "#pragma once\n#include <string_view>\n\n"
        "// One line per range: the limits of a scaled number and its unit.\n// clang-format off\nnamespace " +
        options.name_space + " {\n\n";
    const auto unit = [](const std::string& name) {
        return "static constexpr std::string_view unit" + (name == "one" ? "{}" : " = " + text::quoted(name)) +
               "; };\n";
    };
    std::size_t name_width = 0, min_width = 0, max_width = 0;
    for (const auto& [name, range] : used.ranges) {
        name_width = std::max(name_width, name.size());
        min_width = std::max(min_width, decimal(range.second.min).size());
        max_width = std::max(max_width, decimal(range.second.max).size());
    }
    const auto padded = [](std::string text, std::size_t width) {
        text.resize(std::max(width, text.size()), ' ');
        return text;
    };
    for (const auto& [name, range] : used.ranges)
        made += "struct " + padded(name, name_width) +
                " { static constexpr double min = " + padded(decimal(range.second.min) + ',', min_width + 1) +
                " max = " + padded(decimal(range.second.max) + ';', max_width + 1) + ' ' + unit(range.first);
    if (!used.plain.empty()) made += "\n// Units of numbers that are not scaled.\n";
    for (const auto& [name, is] : used.plain) made += "struct " + name + " { " + unit(is);
    return made + "\n} // namespace " + options.name_space + "\n";
}

/// Gives lists their capacities.
class capacity_setter {
  public:
    explicit capacity_setter(const schema_options& options) : options_{options} {}
    void set(service& one) {
        for (auto* const list : {&one.inputs, &one.outputs})
            for (auto& each : *list)
                if (each.body) set(*each.body, each.name);
    }
    void check_all_used() const {
        for (const auto& [name, capacity] : options_.capacities)
            if (!used_.contains(name))
                throw jsidl_error{{.code = errc::unknown_reference,
                                   .message = "there is no list " + text::quoted(name) + " for a capacity"}};
    }

  private:
    void set(element& of, const std::string& message) {
        for (auto& each : of.children) set(each, message);
        if (of.kind != kind::list) return;
        std::size_t capacity = options_.capacity.value_or(0);
        for (const auto& name : {of.name, message + '.' + of.name})
            if (const auto found = options_.capacities.find(name); found != options_.capacities.end()) {
                capacity = found->second;
                used_.insert(name);
            }
        of.capacity = static_cast<std::size_t>(std::min<std::uint64_t>(capacity, of.max_count));
    }

    const schema_options& options_;
    std::set<std::string> used_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL result<schema_headers, error> write_schemas(std::span<const service> services,
                                                         const schema_options& options) {
    return detail::caught([&] {
        std::vector<service> sized{services.begin(), services.end()};
        std::ranges::sort(sized, {}, [](const service& each) { return std::tie(each.id, each.version); });
        detail::capacity_setter capacities{options};
        detail::units used;
        std::map<std::string, std::vector<const service*>> sets;
        for (auto& each : sized) {
            capacities.set(each);
            for (const auto* const list : {&each.inputs, &each.outputs})
                for (const auto& one : *list)
                    if (one.body) used.add(*one.body);
            sets[set_of(each.id)].push_back(&each);
        }
        capacities.check_all_used();
        schema_headers made;
        for (auto& [name, members] : sets) {
            const detail::schema_plan plan{name, std::move(members)};
            detail::set_writer{plan, options}.write(made);
        }
        made["ranges.hpp"] = detail::ranges_header(used, options);
        return made;
    });
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl
