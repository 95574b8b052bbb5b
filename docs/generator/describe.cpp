#include "describe.hpp"

#include "words.hpp"
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/translation/command_ranks.hpp>
#include <jauscat/schema/translation/sae_ranks.hpp>
#include <jauscat/text/value.hpp>
#include <jauscat/wire/item.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jauscat::reference {

namespace {

using text::member;

/// With a minus sign in place of the hyphen.
std::string with_minus(std::string number) {
    if (number.starts_with('-')) number.replace(0, 1, "−");
    return number;
}

std::string limits_of(bool is_signed, unsigned bits) {
    const std::uint64_t most = ~std::uint64_t{} >> (64 - bits + (is_signed ? 1 : 0));
    const std::string least = is_signed ? "−" + std::to_string(most + 1) : "0";
    return least + (bits == 1 ? " or " : " to ") + std::to_string(most);
}
/// The limits, or the value set.
std::string range_of(const text::integer_form& integer) {
    std::string made;
    const auto text_of = [&](std::uint64_t n) {
        return integer.is_signed ? with_minus(std::to_string(static_cast<std::int64_t>(n))) : std::to_string(n);
    };
    for (const auto [least, most] : integer.values)
        made += (made.empty() ? "" : ", ") + text_of(least) + (least == most ? "" : " to " + text_of(most));
    return made.empty() ? limits_of(integer.is_signed, integer.bits) : made;
}
std::string type_on_wire(const char* kind, unsigned bits) { return kind + std::to_string(bits); }

enumeration names_of(const text::integer_form& integer) {
    enumeration made{.name = std::string{integer.type}, .of_bits = integer.what == text::integer_form::meaning::flags};
    const std::size_t most = made.of_bits ? integer.bits : std::uint64_t{1} << std::min(integer.bits, 8U);
    for (std::size_t i = 0; i != std::min(most, integer.names.size()); ++i)
        if (!integer.names[i].empty()) made.entries.push_back({i, integer.names[i]});
    return made;
}

std::vector<part> parts_of(const text::structure& structure);

/// What a form says of a value.
struct teller {
    part& one;

    void operator()(const text::integer_form& integer) const {
        using meaning = text::integer_form::meaning;
        tell_number(integer.is_signed ? "i" : "u", integer.bits);
        one.unit = integer.unit;
        if (integer.what == meaning::flags || integer.what == meaning::enumeration)
            one.names = names_of(integer);
        else
            one.range = range_of(integer);
    }
    void operator()(const text::real_form& real) const {
        tell_number("f", real.bits);
        one.unit = real.unit;
    }
    void operator()(const text::scaled_form& scaled) const {
        tell_number(scaled.is_signed ? "i" : "u", scaled.bits);
        one.unit = scaled.unit;
        one.range = number(scaled.min) + " to " + number(scaled.max);
        one.step = number(scaled.to_real(1) - scaled.to_real(0), 3);
        one.scaled = true;
    }
    void operator()(const text::octets_form& octets) const {
        one.what = part::kind::octets;
        one.type = octets.characters ? "characters" : "bytes";
        if (octets.zero_filled) {
            one.note = octets.to_the_end ? "filled with zeros; any length is received" : "filled with zeros";
            one.least = one.most;
        } else if (octets.to_the_end) {
            one.note = "to the end of the body";
        } else if (octets.zero_terminated) {
            one.note = "to a zero, which counts in the size";
        }
    }
    void operator()(const text::structure_form& inner) const { tell_structure(*inner.of); }
    void operator()(const text::packed_form& inner) const { tell_structure(*inner.of); }
    void operator()(const text::encoded_form& inner) const {
        if (inner.of != nullptr) return tell_structure(*inner.of);
        one.what = part::kind::octets;
        one.type = "bytes";
        one.note = "a message, from its ID on";
    }
    void operator()(const text::list_form& list) const {
        one.what = part::kind::list;
        if (const auto* const of = structure_in(*list.element)) {
            one.type = of->name;
            one.parts = parts_of(*of);
        } else {
            part element{.what = part::kind::value, .name = std::string{list.field}, .owner = one.owner};
            std::visit(teller{element}, list.element->is);
            one.owner.clear(); // the member is the value in the element
            one.parts.push_back(std::move(element));
        }
    }
    void operator()(const text::tree_form& tree) const {
        const auto* const node = structure_in(*tree.nodes.element);
        one.what = part::kind::list;
        one.type = node->name;
        one.note = "a tree of up to " + std::to_string(tree.max_depth) + " levels; each node has `" +
                   std::string{tree.children.name} + "` children";
        one.parts = parts_of(*node);
    }
    void operator()(const text::choice_form& choice) const {
        one.what = part::kind::choice;
        for (const text::choice_case& each : choice.cases) add_case(each);
    }
    void operator()(const text::variant_form& variant) const {
        one.what = part::kind::choice;
        one.has_rows_of_cases = true;
        for (std::size_t i = 0; i != variant.alternatives.size(); ++i) {
            part made{.what = part::kind::value};
            if (variant.alternatives[i].how != nullptr) std::visit(teller{made}, variant.alternatives[i].how->is);
            made.tags.entries.push_back({i, {}});
            one.parts.push_back(std::move(made));
        }
    }

  private:
    void tell_number(const char* kind, unsigned bits) const {
        one.type = type_on_wire(kind, bits);
        one.least = one.most = bits / 8;
    }
    void tell_structure(const text::structure& of) const {
        one.what = part::kind::record;
        one.type = of.name;
        one.least = of.least;
        one.most = of.most;
        one.parts = parts_of(of);
    }
    static const text::structure* structure_in(const text::form& form) {
        if (const auto* const plain = std::get_if<text::structure_form>(&form.is)) return plain->of;
        if (const auto* const packed = std::get_if<text::packed_form>(&form.is)) return packed->of;
        if (const auto* const encoded = std::get_if<text::encoded_form>(&form.is)) return encoded->of;
        return nullptr;
    }
    /// Cases of the same form are told together.
    void add_case(const text::choice_case& each) const {
        part made{.what = part::kind::value};
        if (each.how != nullptr) std::visit(teller{made}, each.how->is);
        const enumeration::entry tag{each.tag, {}};
        for (part& known : one.parts) {
            if (known.what == part::kind::record || known.type != made.type || known.range != made.range ||
                known.unit != made.unit)
                continue;
            known.tags.entries.push_back(tag);
            return;
        }
        made.tags.entries.push_back(tag);
        one.parts.push_back(std::move(made));
    }
};

part bit_field_of(const member& one, const std::string& owner) {
    const auto& integer = std::get<text::integer_form>(one.how->is);
    part made{.what = part::kind::bits,
              .name = std::string{one.name},
              .owner = owner,
              .first_bit = one.first_bit,
              .width = integer.bits};
    if (integer.what == text::integer_form::meaning::enumeration)
        made.names = names_of(integer);
    else
        made.range = range_of(integer);
    return made;
}
void reserve(part& packed, unsigned first, unsigned end) {
    if (first != end) packed.parts.push_back({.what = part::kind::bits, .first_bit = first, .width = end - first});
}

std::vector<part> parts_of(const text::structure& structure) {
    std::vector<part> out;
    const std::string owner{structure.name};
    const auto members = structure.members;
    for (std::size_t i = 0; i != members.size(); ++i) {
        const member& one = members[i];
        if (one.what == member::role::not_on_wire || one.what == member::role::constant) continue;
        if (one.carrier_bits != 0) {
            part packed{.what = part::kind::packed,
                        .least = one.carrier_bits / 8,
                        .most = one.carrier_bits / 8,
                        .type = type_on_wire("u", one.carrier_bits),
                        .range = limits_of(false, one.carrier_bits)};
            unsigned at = 0;
            for (;; ++i) {
                const member& field = members[i];
                reserve(packed, at, field.first_bit);
                packed.parts.push_back(bit_field_of(field, owner));
                at = field.first_bit + packed.parts.back().width;
                if (field.ends_carrier) break;
            }
            reserve(packed, at, one.carrier_bits);
            out.push_back(std::move(packed));
            continue;
        }
        part made{.what = part::kind::value,
                  .name = std::string{one.name},
                  .owner = owner,
                  .least = one.least,
                  .most = one.most,
                  .presence = one.presence_bit,
                  .gate = std::string{one.gate.name}};
        if (one.what == member::role::flag) {
            made.what = part::kind::flag;
            out.push_back(std::move(made));
            continue;
        }
        std::visit(teller{made}, one.how->is);
        switch (one.what) {
        case member::role::presence_vector:
            made.what = part::kind::presence_vector;
            made.width = one.used_bits;
            made.owner.clear();
            if (one.tolerant) made.note = "other bits and the bytes they stand for are ignored";
            break;
        case member::role::count:
            made.what = part::kind::count;
            made.owner.clear();
            made.gate = members[i + 1].gate.name; // that of its list
            break;
        default: break;
        }
        if (made.what == part::kind::list || made.what == part::kind::octets) {
            if (i != 0 && members[i - 1].what == member::role::count)
                made.times = members[i - 1].name;
            else if (!one.counter.name.empty())
                made.times = std::string{one.counter.name} +
                             (one.counter_excess == 0 ? "" : " − " + std::to_string(one.counter_excess));
        }
        made.selector = one.tag.name;
        if (const auto* const variant = std::get_if<text::variant_form>(&one.how->is)) {
            const std::size_t size = variant->bits / 8;
            part number{.what = part::kind::count,
                        .name = made.name + "_number",
                        .least = size,
                        .most = size,
                        .type = type_on_wire("u", variant->bits),
                        .range = "0 to " + std::to_string(variant->alternatives.size() - 1),
                        .presence = made.presence};
            made.selector = number.name;
            made.least -= size;
            if (made.most != wire::unbounded) made.most -= size;
            out.push_back(std::move(number));
        }
        out.push_back(std::move(made));
    }
    return out;
}

} // namespace

std::string number(double value, int digits) {
    const double in_pi = value / std::numbers::pi;
    if (value != 0 && std::abs(in_pi - std::round(in_pi)) < 1e-9) {
        const std::string factor = std::abs(in_pi) < 1.5 ? "" : std::to_string(std::lround(std::abs(in_pi)));
        return (value < 0 ? "−" : "") + factor + "π";
    }
    std::string made = text::detail::real_text(value, digits);
    if (const auto exponent = made.find("e-0"); exponent != std::string::npos) made.erase(exponent + 2, 1);
    return with_minus(made);
}

message described(const catalogue::entry& entry) {
    const std::uint16_t code = entry.command_code();
    const auto known = std::ranges::find(jaus::catalog, code, &jaus::catalog_entry::command_code);
    const auto rank = std::ranges::find(translation::ra_command_codes, code);
    return {.code = code,
            .name = std::string{known->name},
            .structure = std::string{entry.name()},
            .least = entry.min_size(),
            .most = entry.max_size(),
            .rank = static_cast<unsigned>(rank - translation::ra_command_codes.begin() + 1),
            .diagram = entry.fields().members.empty() ? "" : "diagrams/" + code_digits(code) + ".svg",
            .parts = parts_of(entry.fields())};
}

message described_sae(const catalogue::entry& entry, std::string name, std::string_view diagram_prefix) {
    const std::uint16_t code = entry.command_code();
    part id{.what = part::kind::count,
            .name = "message_id",
            .least = sizeof code,
            .most = sizeof code,
            .type = "u16",
            .range = code_digits(code) + "h"};
    message made{.code = code,
                 .name = std::move(name),
                 .structure = std::string{entry.name()},
                 .least = entry.min_size(),
                 .most = entry.takes_rest() ? wire::unbounded : entry.max_size(),
                 .rank = translation::sae_segments::find(code).rank,
                 .diagram = "diagrams/" + std::string{diagram_prefix} + code_digits(code) + ".svg",
                 .parts = parts_of(entry.fields())};
    made.parts.insert(made.parts.begin(), std::move(id));
    return made;
}

} // namespace jauscat::reference
