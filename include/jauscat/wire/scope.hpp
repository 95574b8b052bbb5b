// Scope of an item: the enclosing structures (for counts, tags and flags elsewhere), and the arena for lists.
// Passed by reference to functions that are forced inline; unused parts cost nothing.
#pragma once
#include <jauscat/wire/arena.hpp>
#include <jauscat/wire/item.hpp>

namespace jauscat::wire {

/// The outermost scope of encoding, of a view, and of decoding without memory.
struct plain_root {};
/// The outermost scope of encoding a message in which nothing but variants has value sets: each is checked where it is
/// written, because to look for its alternative a second time took a third of the instructions.
struct checking_root {};
/// The outermost scope of decoding into lists.
struct memory_root {
    arena& memory;
};
/// The outermost scope of decoding that keeps no elements of lists: only its error counts.
struct discarding_root {};
/// A structure as a value, and the scope around it.
template <class Object, class Outer> struct object_scope {
    Object& object;
    const Outer& outer;
};
template <class Object, class Outer> object_scope(Object&, const Outer&) -> object_scope<Object, Outer>;

/// The structure `T` as bytes, where the whole message's bytes end, and the scope around it. Held by value: views keep
/// it.
template <class T, class Outer> struct byte_scope {
    const std::byte* bytes;
    const std::byte* end;
    Outer outer;
};

JAUSCAT_INLINE constexpr const auto& root_of(const auto& scope) noexcept {
    if constexpr (requires { scope.outer; })
        return root_of(scope.outer);
    else
        return scope;
}

template <class Scope> using root_type = std::remove_cvref_t<decltype(root_of(std::declval<const Scope&>()))>;
/// True where elements of lists are decoded one by one and dropped.
template <class Scope> inline constexpr bool discarding = std::is_same_v<root_type<Scope>, discarding_root>;

template <class T> struct schema;
template <class T> struct checked_schema;

namespace detail {

template <class Object> struct owner_of {
    using type = std::remove_const_t<Object>;
};
template <raw_object Object> struct owner_of<Object> {
    using type = typename Object::raw_of;
};

template <auto First, auto... Rest> JAUSCAT_INLINE constexpr auto along(const auto& object) noexcept {
    const auto& member = member_of<First>(object);
    if constexpr (sizeof...(Rest) == 0)
        return member;
    else
        return along<Rest...>(member);
}
template <auto First, auto... Rest> JAUSCAT_INLINE constexpr auto along_view(const auto& view) noexcept {
    if constexpr (sizeof...(Rest) == 0)
        return view.template get_raw<First>();
    else
        return along_view<Rest...>(view.template get<First>());
}
template <class> struct structure_at;
template <class Object, class Outer>
struct structure_at<object_scope<Object, Outer>> : owner_of<std::remove_const_t<Object>> {};
template <class T, class Outer> struct structure_at<byte_scope<T, Outer>> {
    using type = T;
};

} // namespace detail

/// The structure that a scope stands for.
template <class Scope> using structure_of_scope = typename detail::structure_at<Scope>::type;

/// The value of a member of this structure or of one around it; further pointers lead into it.
template <auto First, auto... Rest> JAUSCAT_INLINE constexpr auto look_up(const auto& scope) noexcept {
    using here = std::remove_cvref_t<decltype(scope)>;
    static_assert(requires { scope.outer; }, "layout: a count, tag or flag names a member of no enclosing structure");
    if constexpr (!std::is_same_v<typename detail::structure_at<here>::type, owner_t<First>>) {
        return look_up<First, Rest...>(scope.outer);
    } else if constexpr (requires { scope.object; }) {
        return detail::along<First, Rest...>(scope.object);
    } else {
        using layout = typename checked_schema<owner_t<First>>::type;
        if constexpr (sizeof...(Rest) == 0)
            return layout::template read<First, reading::raw>(scope.bytes, scope);
        else
            return detail::along_view<Rest...>(layout::template read<First, reading::raw>(scope.bytes, scope));
    }
}

} // namespace jauscat::wire
