// From a schema to its description: the only part of the generator that is compiled for each message.
#pragma once
#include "part.hpp"
#include <jauscat/text/value.hpp>
#include <jauscat/wire/schema.hpp>

#include <boost/core/demangle.hpp>

#include <limits>
#include <typeinfo>

namespace jauscat::reference {

/// A number for people, with so many digits, or with pi where it is a multiple of it.
std::string number(double value, int digits = 9);
/// With a minus sign in place of the hyphen.
std::string with_minus(std::string number);
/// A type's name without namespaces and template arguments.
std::string plain_name(const std::type_info& type);

template <class T> std::vector<part> parts_of();

namespace detail {

template <class Item> struct describer;
template <class Item> void append(std::vector<part>& out) { describer<Item>::append(out); }

template <auto Member> part member_part(part::kind kind, std::size_t least, std::size_t most) {
    return {.what = kind,
            .name = std::string{wire::name_of<Member>()},
            .owner = plain_name(typeid(wire::owner_t<Member>)),
            .least = least,
            .most = most};
}

template <class Number> std::string type_on_wire() {
    return (std::is_floating_point_v<Number> ? "f"
            : std::is_signed_v<Number>       ? "i"
                                             : "u") +
           std::to_string(sizeof(Number) * 8);
}

template <class Enum> enumeration names_of(unsigned most, bool of_bits) {
    enumeration made{.name = plain_name(typeid(Enum)), .of_bits = of_bits};
    for (unsigned i = 0; i <= most; ++i)
        if (const auto name = text::enumerator_name(static_cast<Enum>(i)); !name.empty())
            made.entries.push_back({i, name});
    return made;
}

/// What a codec says of the value it carries.
template <class Codec> void tell_codec(part& one) {
    using value_type = typename Codec::value_type;
    if constexpr (requires { typename Codec::range_type; }) {
        using range = typename Codec::range_type;
        one.type = type_on_wire<typename Codec::raw_type>();
        one.unit = range::unit;
        one.range = number(range::min) + " to " + number(range::max);
        one.step = number(Codec::to_real(1) - Codec::to_real(0), 3);
        one.scaled = true;
    } else if constexpr (requires { typename value_type::bit_type; }) {
        one.type = type_on_wire<typename value_type::bits_type>();
        one.names = names_of<typename value_type::bit_type>(sizeof(value_type) * 8 - 1, true);
    } else if constexpr (std::is_enum_v<value_type>) {
        one.type = type_on_wire<std::underlying_type_t<value_type>>();
        one.names = names_of<value_type>(255, false);
    } else {
        one.type = type_on_wire<value_type>();
        using limits = std::numeric_limits<value_type>;
        if constexpr (std::is_integral_v<value_type>)
            one.range = with_minus(std::to_string(limits::min())) + " to " + std::to_string(limits::max());
        if constexpr (requires { typename Codec::unit_type; }) one.unit = Codec::unit_type::unit;
    }
}

template <auto... Path> std::string path_name() {
    std::string joined;
    ((joined += (joined.empty() ? "" : ".") + std::string{wire::name_of<Path>()}), ...);
    return joined;
}

/// What a list or a run of octets takes its length from. A count of its own is a part before it.
template <class Count> struct length;
template <wire::label Name, class Codec> struct length<wire::count<Name, Codec>> {
    static std::string tell(std::vector<part>& out) {
        part one{
            .what = part::kind::count, .name = std::string{Name.view()}, .least = Codec::size, .most = Codec::size};
        tell_codec<Codec>(one);
        out.push_back(one);
        return one.name;
    }
};
template <auto... Path> struct length<wire::counted_by<Path...>> {
    static std::string tell(std::vector<part>&) { return path_name<Path...>(); }
};
template <auto... Path> struct length<wire::one_less_than<Path...>> {
    static std::string tell(std::vector<part>&) { return path_name<Path...>() + " − 1"; }
};

template <auto Member, class Codec> struct describer<wire::field<Member, Codec>> {
    static void append(std::vector<part>& out) {
        part one = member_part<Member>(part::kind::value, Codec::size, Codec::size);
        tell_codec<Codec>(one);
        out.push_back(std::move(one));
    }
};

template <class Carrier, class... Fields> struct describer<wire::bit_fields<Carrier, Fields...>> {
    static void append(std::vector<part>& out) {
        part whole{.what = part::kind::packed, .least = Carrier::size, .most = Carrier::size};
        tell_codec<Carrier>(whole);
        unsigned at = 0;
        ((whole.parts.push_back(one_field<Fields>(at)), at += Fields::width), ...);
        out.push_back(std::move(whole));
    }
    template <class Field> static part one_field(unsigned first) {
        part one{.what = part::kind::bits};
        if constexpr (requires { typename Field::value_type; }) {
            one = []<auto Member>(wire::key_list<Member>) {
                return member_part<Member>(part::kind::bits, 0, 0);
            }(typename Field::keys{});
            if constexpr (std::is_enum_v<typename Field::value_type>)
                one.names = names_of<typename Field::value_type>((1U << Field::width) - 1, false);
            else if constexpr (Field::is_signed)
                one.range = with_minus(std::to_string(Field::from_bits(std::uint64_t{1} << (Field::width - 1)))) +
                            " to " + std::to_string((std::uint64_t{1} << (Field::width - 1)) - 1);
            else
                one.range =
                    (Field::width == 1 ? "0 or " : "0 to ") + std::to_string((std::uint64_t{1} << Field::width) - 1);
        }
        one.first_bit = first;
        one.width = Field::width;
        return one;
    }
};

template <auto Member> struct describer<wire::nested<Member>> {
    static void append(std::vector<part>& out) {
        using value_type = wire::member_value_t<Member>;
        part one = member_part<Member>(part::kind::record, wire::min_size<value_type>, wire::max_size<value_type>);
        one.type = plain_name(typeid(value_type));
        one.parts = parts_of<value_type>();
        out.push_back(std::move(one));
    }
};

template <wire::unknown_bits Unknown, class Carrier, class... Items>
struct describer<wire::presence_group<Unknown, Carrier, Items...>> {
    static void append(std::vector<part>& out) {
        part vector{.what = part::kind::presence_vector,
                    .name = "presence_vector",
                    .least = Carrier::size,
                    .most = Carrier::size};
        tell_codec<Carrier>(vector);
        if (Unknown == wire::unknown_bits::tolerated)
            vector.note = "other bits and the bytes they stand for are ignored";
        out.push_back(std::move(vector));
        const std::size_t place = out.size() - 1;
        ((out[place].width += append_one<Items>(out, out[place].width)), ...);
    }
    template <class Item> static unsigned append_one(std::vector<part>& out, unsigned bit) {
        const std::size_t before = out.size();
        detail::append<Item>(out);
        if (!wire::takes_bit<Item>) return 0;
        for (std::size_t i = before; i != out.size(); ++i) out[i].presence = bit;
        return 1;
    }
};

template <auto Member> struct describer<wire::presence_flag<Member>> {
    static void append(std::vector<part>& out) { out.push_back(member_part<Member>(part::kind::flag, 0, 0)); }
};

template <auto Flag, class Item> struct describer<wire::gated_by<Flag, Item>> {
    static void append(std::vector<part>& out) {
        const std::size_t before = out.size();
        detail::append<Item>(out);
        for (std::size_t i = before; i != out.size(); ++i) out[i].gate = wire::name_of<Flag>();
    }
};

template <auto Member, class Count, class Element> struct describer<wire::repeated<Member, Count, Element>> {
    static void append(std::vector<part>& out) {
        using item = wire::repeated<Member, Count, Element>;
        using value_type = typename item::value_type;
        const std::string times = length<Count>::tell(out);
        part one = member_part<Member>(part::kind::list, 0, item::max_size);
        if (one.most != wire::unbounded) one.most -= Count::prefix_size;
        one.times = times;
        if constexpr (item::of_records) {
            one.type = plain_name(typeid(value_type));
            one.parts = parts_of<value_type>();
        } else {
            using codec = typename Element::codec_type;
            part element = member_part<Member>(part::kind::value, codec::size, codec::size);
            tell_codec<codec>(element);
            one.name = Element::name();
            one.owner.clear(); // the member is the value in the element
            one.parts.push_back(std::move(element));
        }
        out.push_back(std::move(one));
    }
};

template <auto Member, class Element> struct describer<wire::array<Member, Element>> {
    static void append(std::vector<part>& out) {
        using item = wire::array<Member, Element>;
        part one = member_part<Member>(part::kind::list, item::min_size, item::max_size);
        one.times = std::to_string(item::length);
        if constexpr (item::of_records) {
            one.type = plain_name(typeid(typename item::value_type));
            one.parts = parts_of<typename item::value_type>();
        } else {
            part element = member_part<Member>(part::kind::value, Element::size, Element::size);
            tell_codec<Element>(element);
            one.owner.clear(); // the member is the value in the element
            one.parts.push_back(std::move(element));
        }
        out.push_back(std::move(one));
    }
};

template <auto Member, auto Children, std::size_t MaxDepth> struct describer<wire::tree<Member, Children, MaxDepth>> {
    static void append(std::vector<part>& out) {
        using node = wire::owner_t<Children>;
        part one = member_part<Member>(part::kind::list, wire::min_size<node>, wire::unbounded);
        one.type = plain_name(typeid(node));
        one.note = "a tree of up to " + std::to_string(MaxDepth) + " levels; each node has `" +
                   std::string{wire::name_of<Children>()} + "` children";
        one.parts = parts_of<node>();
        out.push_back(std::move(one));
    }
};

/// Characters or bytes that are as long as `Item` says.
template <class Item> struct octets_describer {
    static void append_with(std::vector<part>& out, std::string note, std::size_t least, std::size_t most) {
        [&]<auto Member>(wire::key_list<Member>) {
            part one = member_part<Member>(part::kind::octets, least, most);
            one.type = std::is_same_v<typename Item::value_type, std::string_view> ? "characters" : "bytes";
            one.note = std::move(note);
            out.push_back(std::move(one));
        }(typename Item::keys{});
    }
};
template <auto Member, class Count>
struct describer<wire::counted_run<Member, Count>> : octets_describer<wire::counted_run<Member, Count>> {
    static void append(std::vector<part>& out) {
        const std::string times = length<Count>::tell(out);
        describer::append_with(out, {}, 0, wire::unbounded);
        out.back().times = times;
    }
};
template <auto Member> struct describer<wire::run_to_end<Member>> : octets_describer<wire::run_to_end<Member>> {
    static void append(std::vector<part>& out) {
        describer::append_with(out, "to the end of the body", 0, wire::unbounded);
    }
};
template <auto Member, std::size_t Size>
struct describer<wire::fixed_run<Member, Size>> : octets_describer<wire::fixed_run<Member, Size>> {
    static void append(std::vector<part>& out) { describer::append_with(out, "filled with zeros", Size, Size); }
};
template <auto Member, std::size_t Size>
struct describer<wire::lenient_run<Member, Size>> : octets_describer<wire::lenient_run<Member, Size>> {
    static void append(std::vector<part>& out) {
        describer::append_with(out, "filled with zeros; any length is received", Size, Size);
    }
};
template <auto Member> struct describer<wire::terminated_run<Member>> : octets_describer<wire::terminated_run<Member>> {
    static void append(std::vector<part>& out) {
        describer::append_with(out, "to a zero, which counts in the size", 1, wire::unbounded);
    }
};

template <auto Member, class Selector, class... Cases> struct describer<wire::selected<Member, Selector, Cases...>> {
    static void append(std::vector<part>& out) {
        using item = wire::selected<Member, Selector, Cases...>;
        part one = member_part<Member>(part::kind::choice, item::min_size, item::max_size);
        one.selector = selector_name(Selector{});
        (add_case<Cases>(one.parts), ...);
        out.push_back(std::move(one));
    }
    template <auto... Path> static std::string selector_name(wire::by<Path...>) { return path_name<Path...>(); }
    /// Cases of the same form are told together.
    template <class Case> static void add_case(std::vector<part>& cases) {
        using form = typename Case::form;
        part one{.what = part::kind::value,
                 .least = wire::case_form<form>::min_size,
                 .most = wire::case_form<form>::max_size};
        if constexpr (wire::message<form>) {
            one.what = part::kind::record;
            one.parts = parts_of<form>();
            one.type = plain_name(typeid(form));
        } else if constexpr (!std::is_same_v<form, std::monostate>) {
            tell_codec<form>(one);
        }
        const enumeration::entry tag{static_cast<std::uint64_t>(Case::tag), text::enumerator_name(Case::tag)};
        for (part& known : cases) {
            if (known.what == part::kind::record || known.type != one.type || known.range != one.range) continue;
            known.tags.entries.push_back(tag);
            return;
        }
        one.tags.entries.push_back(tag);
        cases.push_back(std::move(one));
    }
};

} // namespace detail

/// The parts of a structure, in wire order.
template <class T> std::vector<part> parts_of() {
    std::vector<part> out;
    wire::layout_of<T>::all_items([&]<class Item>() {
        detail::append<Item>(out);
        return true;
    });
    return out;
}

} // namespace jauscat::reference
