// A walk over a message's members in wire order: what text output, comparison and tests build on.
#pragma once
#include <jauscat/wire/layout.hpp>

namespace jauscat::wire {

/// Calls `visitor(item, member)` for each member of `object` (a message or its raw). `item` is the empty descriptor
/// that carries the member: a `field` (codec_type, optional), `bit_field` (width), `nested` (visit the member in turn),
/// or any other that carries one, such as `repeated`; each has `name()` and `key`.
template <class Object>
requires message<std::remove_const_t<Object>>
JAUSCAT_INLINE constexpr void visit(Object& object, auto&& visitor) {
    layout_of<std::remove_const_t<Object>>::visit(object, visitor);
}

} // namespace jauscat::wire
