// The reader of JSIDL files.
#pragma once
#include <jauscat/jsidl/check.hpp>
#include <jauscat/jsidl/document.hpp>
#include <jauscat/jsidl/read_jsidl.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <deque>
#include <set>

namespace jauscat::jsidl {
namespace detail {

/// Names of types in JSIDL.
inline constexpr std::array<std::pair<std::string_view, scalar>, 10> scalar_names{{
    {"unsigned byte", scalar::u8},
    {"unsigned short integer", scalar::u16},
    {"unsigned integer", scalar::u32},
    {"unsigned long integer", scalar::u64},
    {"byte", scalar::i8},
    {"short integer", scalar::i16},
    {"integer", scalar::i32},
    {"long integer", scalar::i64},
    {"float", scalar::f32},
    {"long float", scalar::f64},
}};

/// Reads one service definition.
class service_reader {
  public:
    service_reader(const document& file, const definitions& known) : file_{file}, known_{known} {}

    service read() {
        const auto root = file_.root();
        service made{.name = file_.attribute(root, "name"),
                     .id = file_.attribute(root, "id"),
                     .version = file_.attribute(root, "version"),
                     .source = file_.source(),
                     .line = file_.line_of(root)};
        if (const auto references = file_.child(root, "references")) {
            for (const auto each : references->children()) {
                const auto name = local_name(each);
                if (name == "inherits_from") {
                    if (made.inherits)
                        file_.fail(errc::unsupported, each, "the second parent; a service has one at most here");
                    made.inherits = reference(each);
                } else if (name == "client_of") {
                    made.uses.push_back(reference(each));
                }
            }
        }
        const located set{&file_, root};
        const auto messages = file_.needed_child(root, "message_set");
        if (const auto inputs = file_.child(messages, "input_set")) made.inputs = read_messages(*inputs, set);
        if (const auto outputs = file_.child(messages, "output_set")) made.outputs = read_messages(*outputs, set);
        return made;
    }

  private:
    service_reference reference(pugi::xml_node node) const {
        return {file_.attribute(node, "name"), file_.attribute(node, "id"), file_.attribute(node, "version")};
    }

    std::vector<message> read_messages(pugi::xml_node list, located set) const {
        std::vector<message> made;
        for (const auto each : list.children())
            if (kind_name(each) == "message_def") made.push_back(read_message({&file_, each}, set));
        return made;
    }

    message read_message(located written, located from) const {
        const auto [at, set] = known_.resolve(written, from);
        message made{.name = written.file->attribute(written.node, "name"),
                     .id = message_id(at),
                     .is_command = at.file->boolean(at.node, "is_command"),
                     .is_deprecated = at.file->boolean(at.node, "deprecated"),
                     .line = at.file->line_of(at.node)};
        check_header(at, set);
        made.body = content(at, set, "body");
        if (content(at, set, "footer")) at.file->fail(errc::unsupported, at.node, "has a footer that is not empty");
        return made;
    }

    static std::uint16_t message_id(located at) {
        const auto written = at.file->attribute(at.node, "message_id");
        std::uint16_t id{};
        const auto* const end = written.data() + written.size();
        const auto [stop, error] = std::from_chars(written.data(), end, id, 16);
        if (error != std::errc{} || stop != end)
            at.file->fail(errc::invalid_value, at.node,
                          "message_id=" + text::quoted(written) + ", expected up to four hexadecimal digits");
        return id;
    }

    /// The record, list, variant or sequence in a header, body or footer.
    std::optional<element> content(located message, located from, std::string_view name) const {
        const auto part = message.file->child(message.node, name);
        if (!part) return std::nullopt;
        const auto [at, set] = known_.resolve({message.file, *part}, from);
        std::optional<element> made;
        for (const auto each : at.node.children()) {
            if (!is_composite(kind_name(each))) continue;
            if (made) at.file->fail(errc::unexpected, each, "the second element here, expected one at most");
            made = read_element({at.file, each}, set);
        }
        if (made && made->optional)
            at.file->fail(errc::inconsistent, at.node,
                          "the element in it is optional, but no presence vector is before it");
        return made;
    }

    /// Every header is the message's ID alone: what else one has would be lost.
    void check_header(located at, located set) const {
        const auto header = content(at, set, "header");
        if (!header) at.file->fail(errc::unsupported, at.node, "has no header with the message's ID");
        const auto is_id = [](const element& each) {
            return each.kind == kind::number && each.type == scalar::u16 && !each.optional && !each.scale;
        };
        if (header->kind != kind::record || header->presence || header->children.size() != 1 ||
            !is_id(header->children.front()))
            at.file->fail(errc::unsupported, at.node,
                          "has a header that is more than the message's ID, one unsigned short integer");
    }

    static bool is_composite(std::string_view name) {
        return name == "record" || name == "list" || name == "variant" || name == "sequence";
    }
    static bool is_field(std::string_view name) {
        return name == "array" || name == "fixed_field" || name == "variable_field" || name == "bit_field" ||
               name == "fixed_length_string" || name == "variable_length_string" || name == "variable_length_field" ||
               name == "variable_format_field";
    }

    element read_element(located written, located from) const {
        const auto [at, set] = known_.resolve(written, from);
        element made{.name = written.file->attribute(written.node, "name"),
                     .optional = written.file->boolean(written.node, "optional"),
                     .line = written.file->line_of(written.node)};
        const open_element guard{*this, at};
        const auto name = kind_name(at.node);
        if (name == "record" || name == "sequence")
            read_members(made, at, set);
        else if (name == "list")
            read_list(made, at, set);
        else if (name == "variant")
            read_variant(made, at, set);
        else if (name == "array")
            read_array(made, at, set);
        else if (name == "fixed_field")
            read_number(made, at, set);
        else if (name == "variable_field")
            read_choice(made, at, set);
        else if (name == "bit_field")
            read_bits(made, at, set);
        else if (name == "fixed_length_string") {
            made.kind = kind::fixed_string;
            made.max_count = integer(at, set, "string_length");
        } else if (name == "variable_length_string") {
            made.kind = kind::string;
            read_count(made, at, set, "count_field");
        } else if (name == "variable_length_field") {
            made.kind = kind::blob;
            made.format = at.file->attribute(at.node, "field_format");
            read_count(made, at, set, "count_field");
        } else if (name == "variable_format_field") {
            read_formatted(made, at, set);
        } else {
            at.file->fail(errc::unexpected, at.node, "no element of a message");
        }
        return made;
    }

    void read_members(element& made, located at, located set) const {
        const bool is_record = kind_name(at.node) == "record";
        made.kind = is_record ? kind::record : kind::sequence;
        for (const auto each : at.node.children()) {
            const auto name = kind_name(each);
            if (name == "presence_vector") {
                if (made.presence) at.file->fail(errc::unexpected, each, "the second one here, expected one at most");
                made.presence = unsigned_type({at.file, each}, "field_type_unsigned");
            } else if (is_record ? is_field(name) : is_composite(name)) {
                made.children.push_back(read_element({at.file, each}, set));
            } else if (name != "description") {
                at.file->fail(errc::unexpected, each,
                              is_record ? "a record has fields only"
                                        : "a sequence has records, lists, variants and sequences only");
            }
        }
    }
    void read_list(element& made, located at, located set) const {
        made.kind = kind::list;
        read_count(made, at, set, "count_field");
        read_composites(made, at, set);
        if (made.children.size() != 1)
            at.file->fail(errc::unexpected, at.node,
                          "has " + std::to_string(made.children.size()) + " elements, expected one");
    }
    void read_variant(element& made, located at, located set) const {
        made.kind = kind::variant;
        read_count(made, at, set, "vtag_field");
        read_composites(made, at, set);
    }
    void read_composites(element& made, located at, located set) const {
        for (const auto each : at.node.children()) {
            const auto name = kind_name(each);
            if (is_composite(name))
                made.children.push_back(read_element({at.file, each}, set));
            else if (name != "description" && name != "count_field" && name != "vtag_field")
                at.file->fail(errc::unexpected, each, "expected a record, list, variant or sequence");
        }
    }
    void read_array(element& made, located at, located set) const {
        made.kind = kind::array;
        for (const auto each : at.node.children()) {
            const auto name = kind_name(each);
            if (name == "dimension") {
                const auto size = integer({at.file, each}, set, "size");
                if (size == 0 || size > 0xFFFF)
                    at.file->fail(errc::invalid_value, each, "expected a size from 1 to 65535");
                made.dimensions.push_back(static_cast<std::uint32_t>(size));
            } else if (is_field(name)) {
                if (!made.children.empty())
                    at.file->fail(errc::unexpected, each, "the second field here, expected one");
                made.children.push_back(read_element({at.file, each}, set));
            } else if (name != "description") {
                at.file->fail(errc::unexpected, each, "an array has a field and dimensions only");
            }
        }
        if (made.children.empty()) at.file->fail(errc::missing, at.node, "expected a field in it");
        if (made.dimensions.empty()) at.file->fail(errc::missing, at.node, "expected a <dimension> in it");
        if (made.children.front().optional)
            at.file->fail(errc::inconsistent, at.node, "its field is optional, but no presence vector is before it");
    }

    void read_number(element& made, located at, located set) const {
        made.kind = kind::number;
        made.type = number_type(at, "field_type");
        made.unit = at.file->attribute(at.node, "field_units");
        read_values(made, at, set);
    }
    void read_choice(element& made, located at, located set) const {
        made.kind = kind::choice;
        made.type = scalar::u8;
        const auto forms = at.file->needed_child(at.node, "type_and_units_field");
        for (const auto each : forms.children()) {
            if (local_name(each) != "type_and_units_enum") continue;
            const located one{at.file, each};
            element form{.kind = kind::choice_form,
                         .name = at.file->attribute(each, "name"),
                         .type = number_type(one, "field_type"),
                         .unit = at.file->attribute(each, "field_units"),
                         .index = index_in(one, set, "index"),
                         .line = at.file->line_of(each)};
            read_values(form, one, set);
            made.children.push_back(std::move(form));
        }
    }
    void read_bits(element& made, located at, located set) const {
        made.kind = kind::bits;
        made.type = unsigned_type(at, "field_type_unsigned");
        for (const auto each : at.node.children()) {
            if (kind_name(each) == "description") continue;
            if (local_name(each) != "sub_field") at.file->fail(errc::unexpected, each, "expected a <sub_field>");
            const auto range = at.file->needed_child(each, "bit_range");
            element part{.kind = kind::bit_part,
                         .name = at.file->attribute(each, "name"),
                         .first_bit = index_in({at.file, range}, set, "from_index"),
                         .last_bit = index_in({at.file, range}, set, "to_index"),
                         .line = at.file->line_of(each)};
            read_values(part, {at.file, each}, set);
            made.children.push_back(std::move(part));
        }
    }
    void read_formatted(element& made, located at, located set) const {
        made.kind = kind::formatted_blob;
        read_count(made, at, set, "count_field");
        const auto formats = at.file->needed_child(at.node, "format_field");
        for (const auto each : formats.children()) {
            if (local_name(each) != "format_enum") continue;
            made.children.push_back({.kind = kind::format,
                                     .index = index_in({at.file, each}, set, "index"),
                                     .format = at.file->attribute(each, "field_format"),
                                     .line = at.file->line_of(each)});
        }
    }

    /// The limits and named values of a number.
    void read_values(element& made, located at, located set) const {
        if (const auto range = at.file->child(at.node, "scale_range")) {
            const located one{at.file, *range};
            const auto rounding = with_single_spaces(range->attribute("integer_function").value());
            if (rounding != "round" && !rounding.empty())
                at.file->fail(errc::unsupported, *range,
                              "integer_function=" + text::quoted(rounding) + ": only \"round\" is known");
            made.scale = {known_.real(one, set, "real_lower_limit"), known_.real(one, set, "real_upper_limit")};
            if (!(made.scale->min < made.scale->max))
                at.file->fail(errc::invalid_value, *range, "the lower limit is not below the upper one");
        }
        const auto values = at.file->child(at.node, "value_set");
        if (!values) return;
        if (at.file->boolean(*values, "offset_to_lower_limit"))
            at.file->fail(errc::unsupported, *values,
                          "offset_to_lower_limit=\"true\": implementations disagree what is on the wire");
        for (const auto each : values->children()) {
            const located one{at.file, each};
            const auto name = local_name(each);
            if (name == "value_enum") {
                const double value = known_.real(one, set, "enum_index");
                if (value != std::floor(value) || std::abs(value) > 0x1p53)
                    at.file->fail(errc::invalid_value, each, "enum_index is no whole number");
                made.names.push_back({static_cast<std::int64_t>(value), at.file->attribute(each, "enum_const")});
            } else if (name == "value_range") {
                value_range range{.min = known_.real(one, set, "lower_limit"),
                                  .max = known_.real(one, set, "upper_limit"),
                                  .with_min = with_limit(one, "lower_limit_type"),
                                  .with_max = with_limit(one, "upper_limit_type")};
                if (range.min > range.max)
                    at.file->fail(errc::invalid_value, each, "the lower limit is above the upper one");
                made.ranges.push_back(range);
            } else if (name != "description") {
                at.file->fail(errc::unexpected, each, "expected a <value_enum> or <value_range>");
            }
        }
    }
    static bool with_limit(located at, const char* name) {
        const auto written = with_single_spaces(at.node.attribute(name).value());
        if (written.empty() || written == "inclusive") return true;
        if (written == "exclusive") return false;
        at.file->fail(errc::invalid_value, at.node,
                      std::string{name} + "=" + text::quoted(written) + ", expected inclusive or exclusive");
    }

    void read_count(element& made, located at, located set, std::string_view name) const {
        const auto [count, from] = known_.resolve({at.file, at.file->needed_child(at.node, name)}, set);
        made.type = unsigned_type(count, "field_type_unsigned");
        if (count.node.attribute("min_count")) made.min_count = integer(count, from, "min_count");
        made.max_count = count.node.attribute("max_count") ? integer(count, from, "max_count") : most_of(made.type);
    }
    std::uint64_t integer(located at, located set, const char* attribute) const {
        const double value = known_.real(at, set, attribute);
        if (value != std::floor(value) || value < 0 || value > 0x1p63)
            at.file->fail(errc::invalid_value, at.node, std::string{attribute} + " is no whole number from 0");
        return static_cast<std::uint64_t>(value);
    }
    std::uint32_t index_in(located at, located set, const char* attribute) const {
        const auto value = integer(at, set, attribute);
        if (value > 255) at.file->fail(errc::invalid_value, at.node, std::string{attribute} + " is above 255");
        return static_cast<std::uint32_t>(value);
    }
    static scalar number_type(located at, const char* attribute) {
        const auto written = at.file->attribute(at.node, attribute);
        for (const auto& [name, type] : scalar_names)
            if (name == written) return type;
        at.file->fail(errc::invalid_value, at.node,
                      std::string{attribute} + "=" + text::quoted(written) +
                          ", expected a type such as \"unsigned byte\" or \"float\"");
    }
    static scalar unsigned_type(located at, const char* attribute) {
        const auto type = number_type(at, attribute);
        if (type > scalar::u64)
            at.file->fail(errc::invalid_value, at.node, std::string{attribute} + ": expected an unsigned type");
        return type;
    }

    /// A type that contains itself would not end.
    struct open_element {
        open_element(const service_reader& of, located at) : reader{of} {
            const std::pair key{at.file, at.node.offset_debug()};
            if (!reader.open_.insert(key).second) at.file->fail(errc::cycle, at.node, "contains itself");
            where = key;
        }
        ~open_element() { reader.open_.erase(where); }
        open_element(const open_element&) = delete;
        open_element& operator=(const open_element&) = delete;

        const service_reader& reader;
        std::pair<const document*, std::ptrdiff_t> where{};
    };

    const document& file_;
    const definitions& known_;
    mutable std::set<std::pair<const document*, std::ptrdiff_t>> open_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL result<std::vector<service>, error> parse_jsidl(std::span<const jsidl_text> texts) {
    return detail::caught([&] {
        std::deque<detail::document> files;
        detail::definitions known;
        for (const auto& each : texts) known.add(files.emplace_back(each.text, each.source));
        std::vector<service> services;
        for (const auto& each : files)
            if (detail::local_name(each.root()) == "service_def")
                services.push_back(detail::service_reader{each, known}.read());
        std::ranges::sort(services, {}, [](const service& each) { return std::tie(each.id, each.version); });
        check_services(services);
        return services;
    });
}

JAUSCAT_DECL result<std::vector<service>, error> read_jsidl(std::span<const std::filesystem::path> files) {
    std::vector<jsidl_text> texts;
    const auto read = detail::caught([&] {
        for (const auto& each : files) texts.push_back({detail::text_of(each), each.string()});
        return true;
    });
    if (!read) return read.error();
    return parse_jsidl(texts);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl
