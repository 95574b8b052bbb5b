// All headers needed to declare a schema.
#pragma once
#include <jauscat/wire/array.hpp>
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/bit_set.hpp>
#include <jauscat/wire/constant.hpp>
#include <jauscat/wire/embedded.hpp>
#include <jauscat/wire/field.hpp>
#include <jauscat/wire/gated_by.hpp>
#include <jauscat/wire/layout.hpp>
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/presence.hpp>
#include <jauscat/wire/repeated.hpp>
#include <jauscat/wire/scalar.hpp>
#include <jauscat/wire/scaled.hpp>
#include <jauscat/wire/selected.hpp>
#include <jauscat/wire/string.hpp>
#include <jauscat/wire/tree.hpp>
#include <jauscat/wire/value_set.hpp>
#include <jauscat/wire/variant.hpp>
#include <jauscat/wire/view.hpp> // a count inside a nested structure is read through a view

namespace jauscat::wire {

/// The words of layouts, for the schema of a message: in `struct schema : wire::items`, a layout says
/// `field<&T::speed, u16le>`, and the namespace of the message stays free of them.
struct items {
    template <class... Items> using layout = wire::layout<Items...>;
    template <auto Member, class Codec> using field = wire::field<Member, Codec>;
    template <auto Member> using nested = wire::nested<Member>;
    template <auto Member, class Element = wire::record> using array = wire::array<Member, Element>;
    template <auto Member> using not_on_wire = wire::not_on_wire<Member>;

    template <class Carrier, class... Items> using presence = wire::presence<Carrier, Items...>;
    template <class Carrier, class... Items> using lenient_presence = wire::lenient_presence<Carrier, Items...>;
    template <class Carrier, class... Items> using open_presence = wire::open_presence<Carrier, Items...>;
    template <auto Member> using presence_flag = wire::presence_flag<Member>;
    template <auto Flag, class Item> using gated_by = wire::gated_by<Flag, Item>;

    template <class Carrier, class... Fields> using bit_fields = wire::bit_fields<Carrier, Fields...>;
    template <auto Member, std::size_t Width> using bit_field = wire::bit_field<Member, Width>;
    template <std::size_t Width> using reserved = wire::reserved<Width>;
    template <class Bit, class Carrier> using bit_set_codec = wire::bit_set_codec<Bit, Carrier>;

    template <auto Member, class Extent> using string = wire::string<Member, Extent>;
    template <auto Member, class Extent> using bytes = wire::bytes<Member, Extent>;
    template <std::size_t Size> using fixed = wire::fixed<Size>;
    template <std::size_t Size> using fixed_or_rest = wire::fixed_or_rest<Size>;
    using rest = wire::rest;
    using zero_terminated = wire::zero_terminated;

    template <auto Member, class Count, class Element = wire::record>
    using repeated = wire::repeated<Member, Count, Element>;
    template <wire::label Name, class Codec> using element = wire::element<Name, Codec>;
    using record = wire::record;
    template <wire::label Name, class Codec> using count = wire::count<Name, Codec>;
    template <auto... Path> using counted_by = wire::counted_by<Path...>;
    template <auto... Path> using one_less_than = wire::one_less_than<Path...>;
    template <auto Member, auto Children, std::size_t MaxDepth> using tree = wire::tree<Member, Children, MaxDepth>;

    template <auto Member, class Selector, class... Cases> using selected = wire::selected<Member, Selector, Cases...>;
    template <auto Member, class Tag> using variant = wire::variant<Member, Tag>;
    template <wire::label Name, class Codec, auto Value> using constant = wire::constant<Name, Codec, Value>;
    template <auto Member, class Count> using embedded = wire::embedded<Member, Count>;
    template <class Codec, class... Parts> using in_value_set = wire::in_value_set<Codec, Parts...>;
    template <auto Member, std::size_t Width, class... Parts>
    using bit_field_in_set = wire::bit_field_in_set<Member, Width, Parts...>;
    template <auto Least, auto Most> using between = wire::between<Least, Most>;
    template <auto... Values> using one_of = wire::one_of<Values...>;
    template <wire::label Name, class Codec, std::size_t Least, std::size_t Most>
    using count_between = wire::count_between<Name, Codec, Least, Most>;
    template <auto Tag, class Form = std::monostate> using when = wire::when<Tag, Form>;
    template <auto... Path> using by = wire::by<Path...>;

    template <class Raw, wire::real_range Range> using scaled = wire::scaled<Raw, Range>;
    template <class Enum, class Carrier> using enumeration = wire::enumeration<Enum, Carrier>;
    template <class Codec, class Unit> using in_units = wire::in_units<Codec, Unit>;
    template <std::size_t Size> using octets = wire::octets<Size>;
    using u8 = wire::u8;
    using i8 = wire::i8;
    using u16le = wire::u16le;
    using u32le = wire::u32le;
    using u64le = wire::u64le;
    using i16le = wire::i16le;
    using i32le = wire::i32le;
    using i64le = wire::i64le;
    using f32le = wire::f32le;
    using f64le = wire::f64le;
    using u16be = wire::u16be;
    using u32be = wire::u32be;
    using u64be = wire::u64be;
    using i16be = wire::i16be;
    using i32be = wire::i32be;
    using i64be = wire::i64be;
    using f32be = wire::f32be;
    using f64be = wire::f64be;
};

} // namespace jauscat::wire
