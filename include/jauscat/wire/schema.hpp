// All headers needed to declare a schema.
#pragma once
#include <jauscat/wire/array.hpp>
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/bit_set.hpp>
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
#include <jauscat/wire/view.hpp> // a count inside a nested structure is read through a view

/// The words of schemas: `using namespace wire::items` lets the messages of a namespace say `field<&T::speed, u16le>`.
namespace jauscat::wire::items {

using wire::array, wire::bit_field, wire::bit_fields, wire::bit_set, wire::bit_set_codec, wire::by, wire::bytes,
    wire::count, wire::counted_by, wire::element, wire::enumeration, wire::field, wire::fixed, wire::fixed_or_rest,
    wire::gated_by, wire::in_units, wire::layout, wire::nested, wire::not_on_wire, wire::octets, wire::one_less_than,
    wire::open_presence, wire::presence, wire::presence_flag, wire::record, wire::repeated, wire::reserved, wire::rest,
    wire::scaled, wire::selected, wire::string, wire::tree, wire::when, wire::zero_terminated;
using wire::f32be, wire::f32le, wire::f64be, wire::f64le, wire::i16be, wire::i16le, wire::i32be, wire::i32le,
    wire::i64be, wire::i64le, wire::i8, wire::u16be, wire::u16le, wire::u32be, wire::u32le, wire::u64be, wire::u64le,
    wire::u8;

} // namespace jauscat::wire::items
