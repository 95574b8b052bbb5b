// The checks of service definitions.
#pragma once
#include <jauscat/jsidl/check.hpp>
#include <jauscat/jsidl/names.hpp>
#include <jauscat/jsidl/source.hpp>
#include <jauscat/text/quoted.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace jauscat::jsidl {
namespace detail {

constexpr std::size_t bits_of(scalar type) noexcept {
    switch (type) {
    case scalar::u8:
    case scalar::i8: return 8;
    case scalar::u16:
    case scalar::i16: return 16;
    case scalar::u32:
    case scalar::i32:
    case scalar::f32: return 32;
    default: return 64;
    }
}
constexpr bool is_floating(scalar type) noexcept { return type == scalar::f32 || type == scalar::f64; }

/// The element's name in JSIDL.
constexpr std::string_view name_of(kind kind) noexcept {
    switch (kind) {
    case kind::number: return "fixed_field";
    case kind::choice: return "variable_field";
    case kind::choice_form: return "type_and_units_enum";
    case kind::bits: return "bit_field";
    case kind::bit_part: return "sub_field";
    case kind::fixed_string: return "fixed_length_string";
    case kind::string: return "variable_length_string";
    case kind::blob: return "variable_length_field";
    case kind::formatted_blob: return "variable_format_field";
    case kind::format: return "format_enum";
    case kind::array: return "array";
    case kind::record: return "record";
    case kind::sequence: return "sequence";
    case kind::list: return "list";
    case kind::variant: return "variant";
    }
    return "";
}

/// The checks of one service.
class service_check {
  public:
    explicit service_check(const service& of) : service_{of} {}

    void run() const {
        if (set_of(service_.id).empty() || identifier(service_.name, "service").empty())
            fail(errc::invalid_value, service_.line, "service_def",
                 "id=" + text::quoted(service_.id) + ", expected a URI such as urn:jaus:jss:core:Events");
        std::map<std::string, const message*> names;
        std::map<std::uint16_t, const message*> ids;
        for (const auto* const list : {&service_.inputs, &service_.outputs})
            for (const auto& each : *list) {
                check_message(each);
                const auto [same_name, new_name] = names.emplace(identifier(each.name, "message"), &each);
                const auto [same_id, new_id] = ids.emplace(each.id, &each);
                if ((!new_name || !new_id) && !(*same_name->second == each && same_id->second == &*same_name->second))
                    fail(errc::duplicate, each.line, "message_def",
                         each.name + " has the name or the ID of " +
                             (new_id ? same_name : names.find(identifier(same_id->second->name, "message")))
                                 ->second->name +
                             ", which is another message");
            }
    }

  private:
    [[noreturn]] void fail(errc code, std::size_t line, std::string_view element, const std::string& what) const {
        detail::fail(code, service_.source, line, element, what);
    }
    [[noreturn]] void fail(errc code, const element& at, const std::string& what) const {
        fail(code, at.line, name_of(at.kind), (at.name.empty() ? "" : at.name + ": ") + what);
    }

    void check_message(const message& each) const {
        if (identifier(each.name, "message").empty())
            fail(errc::invalid_value, each.line, "message_def",
                 "the name " + text::quoted(each.name) + " has neither letters nor digits");
        if (each.body) check_element(*each.body);
    }
    void check_element(const element& each) const {
        if (each.kind != kind::format && identifier(each.name, "field").empty())
            fail(errc::invalid_value, each, "the name has neither letters nor digits");
        switch (each.kind) {
        case kind::number:
        case kind::choice_form: check_number(each); break;
        case kind::bit_part: check_names(each, each.last_bit - each.first_bit + 1); break;
        case kind::bits: check_bits(each); break;
        case kind::array:
            if (each.children.front().kind != kind::number)
                fail(errc::unsupported, each, "an array of other elements than numbers");
            break;
        case kind::fixed_string:
            if (each.max_count == 0) fail(errc::invalid_value, each, "the length is 0");
            break;
        case kind::choice:
        case kind::formatted_blob: check_indices(each); break;
        case kind::variant: check_variant(each); break;
        case kind::list:
            if (each.children.front().optional)
                fail(errc::inconsistent, each.children.front(), "the element of a list cannot be optional");
            break;
        case kind::record:
        case kind::sequence: check_presence(each); break;
        default: break;
        }
        if (each.kind == kind::list || each.kind == kind::string || each.kind == kind::blob ||
            each.kind == kind::formatted_blob)
            if (each.min_count > each.max_count || each.max_count > most_of(each.type))
                fail(errc::inconsistent, each,
                     "counts from " + std::to_string(each.min_count) + " to " + std::to_string(each.max_count) +
                         " in a number up to " + std::to_string(most_of(each.type)));
        std::set<std::string> names;
        for (const auto& child : each.children) {
            check_element(child);
            if (child.kind != kind::format && !names.insert(identifier(child.name, "field")).second)
                fail(errc::duplicate, child, "the name is there twice in " + text::quoted(each.name));
        }
    }
    void check_number(const element& each) const {
        if (each.scale && (is_floating(each.type) || each.type > scalar::u64))
            fail(errc::unsupported, each,
                 "a scaled number in a signed or floating-point type: implementations disagree on its value");
        const bool has_values = !each.names.empty() || !each.ranges.empty();
        if (has_values && (each.scale || is_floating(each.type)))
            fail(errc::unsupported, each, "a value set of a number that is no integer on its own");
        if (each.kind == kind::choice_form && !each.scale) fail(errc::unsupported, each, "a form that is not scaled");
        check_names(each, bits_of(each.type));
    }
    void check_names(const element& each, std::size_t bits) const {
        const bool is_signed = each.kind != kind::bit_part && each.type > scalar::u64;
        const double most =
            is_signed ? std::ldexp(1.0, static_cast<int>(bits) - 1) : std::ldexp(1.0, static_cast<int>(bits));
        std::set<std::int64_t> values;
        for (const auto& named : each.names) {
            const auto value = static_cast<double>(named.value);
            if (value >= most || value < (is_signed ? -most : 0.0))
                fail(errc::inconsistent, each,
                     "the value " + std::to_string(named.value) + " does not fit " + std::to_string(bits) + " bits");
            if (!values.insert(named.value).second)
                fail(errc::duplicate, each, "the value " + std::to_string(named.value) + " has two names");
        }
    }
    void check_bits(const element& each) const {
        if (each.children.empty()) fail(errc::missing, each, "has no <sub_field>");
        std::vector<bool> taken(bits_of(each.type));
        for (const auto& part : each.children) {
            if (part.first_bit > part.last_bit || part.last_bit >= taken.size())
                fail(errc::inconsistent, part,
                     "bits " + std::to_string(part.first_bit) + " to " + std::to_string(part.last_bit) + " of " +
                         std::to_string(taken.size()));
            for (auto bit = part.first_bit; bit <= part.last_bit; ++bit) {
                if (taken[bit]) fail(errc::inconsistent, part, "bit " + std::to_string(bit) + " is in two sub-fields");
                taken[bit] = true;
            }
        }
    }
    void check_indices(const element& each) const {
        if (each.children.empty()) fail(errc::missing, each, "has nothing to choose among");
        std::set<std::uint32_t> indices;
        for (const auto& child : each.children)
            if (!indices.insert(child.index).second)
                fail(errc::duplicate, child, "the index " + std::to_string(child.index) + " is there twice");
    }
    void check_variant(const element& each) const {
        // A variant without alternative is its tag alone.
        const auto last = each.children.empty() ? 0 : each.children.size() - 1;
        if (each.min_count != 0 || each.max_count != last || last > most_of(each.type))
            fail(errc::inconsistent, each,
                 "tags from " + std::to_string(each.min_count) + " to " + std::to_string(each.max_count) + " for " +
                     std::to_string(each.children.size()) + " alternatives, expected 0 to " + std::to_string(last));
        for (const auto& child : each.children)
            if (child.optional) fail(errc::inconsistent, child, "an alternative cannot be optional");
    }
    void check_presence(const element& each) const {
        const auto optionals = static_cast<std::size_t>(std::ranges::count_if(each.children, &element::optional));
        if (!each.presence && optionals != 0)
            fail(errc::inconsistent, *std::ranges::find_if(each.children, &element::optional),
                 "is optional, but " + text::quoted(each.name) + " has no presence vector");
        if (!each.presence) return;
        if (optionals == 0) fail(errc::unsupported, each, "has a presence vector, but nothing optional");
        if (optionals > bits_of(*each.presence))
            fail(errc::inconsistent, each,
                 std::to_string(optionals) + " optional elements, but " + std::to_string(bits_of(*each.presence)) +
                     " bits in the presence vector");
    }

    const service& service_;
};

inline void check_inheritance(std::span<const service> services) {
    std::map<std::pair<std::string, std::string>, const service*> by_id;
    for (const auto& each : services) by_id.emplace(std::pair{each.id, each.version}, &each);
    for (const auto& each : services) {
        std::size_t steps = 0;
        for (const auto* at = &each; at->inherits; ++steps) {
            const auto parent = by_id.find({at->inherits->id, at->inherits->version});
            if (parent == by_id.end()) break; // defined elsewhere
            at = parent->second;
            if (at == &each || steps > services.size())
                fail(errc::cycle, each.source, each.line, "service_def",
                     each.id + " version " + each.version + " inherits from itself, through " + each.inherits->id);
        }
    }
}

/// Within a set a message has one definition, whichever services have it.
inline void check_sets(std::span<const service> services) {
    using key = std::pair<std::string, std::string>;
    std::map<std::pair<std::string, std::uint16_t>, std::pair<const service*, const message*>> by_id;
    std::map<key, std::pair<const service*, const message*>> by_name;
    std::map<std::string, std::pair<std::string, const service*>> versions;
    for (const auto& one : services) {
        const auto set = set_of(one.id);
        const auto [version, is_new] = versions.emplace(one.id, std::pair{one.version, &one});
        if (!is_new)
            fail(errc::duplicate, one.source, one.line, "service_def",
                 one.id + " version " + one.version + " beside version " + version->second.first + " of " +
                     version->second.second->source + "; write each version into a namespace of its own");
        for (const auto* const list : {&one.inputs, &one.outputs})
            for (const auto& each : *list) {
                const std::pair here{&one, &each};
                for (const auto& known :
                     {by_id.emplace(std::pair{set, each.id}, here).first->second,
                      by_name.emplace(key{set, identifier(each.name, "message")}, here).first->second})
                    if (!(*known.second == each))
                        fail(errc::inconsistent, one.source, each.line, "message_def",
                             each.name + " differs from " + known.second->name + " in " + known.first->source + ':' +
                                 std::to_string(known.second->line) + ", which has the same name or ID");
            }
    }
}

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::uint64_t most_of(scalar type) noexcept {
    const auto bits = detail::bits_of(type);
    return bits == 64 ? ~std::uint64_t{} : (std::uint64_t{1} << bits) - 1;
}

JAUSCAT_DECL std::string set_of(std::string_view service_id) {
    const auto last = service_id.rfind(':');
    if (last == service_id.npos || last == 0) return {};
    const auto before = service_id.rfind(':', last - 1);
    if (before == service_id.npos) return {};
    return identifier(service_id.substr(before + 1, last - before - 1), "set");
}

JAUSCAT_DECL void check_services(std::span<const service> services) {
    for (const auto& each : services) detail::service_check{each}.run();
    detail::check_inheritance(services);
    detail::check_sets(services);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl
