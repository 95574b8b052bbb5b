// A member pointer is a field's identity: this header reads its type, its owner, its name, and reaches the member in a
// value or in a `raw`.
#pragma once
#include <jauscat/wire/inlining.hpp>

#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace jauscat::wire {

namespace detail {

template <class> struct member_pointer;
template <class Owner, class Member> struct member_pointer<Member Owner::*> {
    using owner = Owner;
    using type = Member;
};

template <class T> struct optional_value {
    using type = T;
    static constexpr bool is_optional = false;
};
template <class T> struct optional_value<std::optional<T>> {
    using type = T;
    static constexpr bool is_optional = true;
};

struct any_member {
    // Only used in requires-expressions, never called; clang requires a body if T has no linkage.
    template <class T> operator T() const noexcept { __builtin_unreachable(); }
};
template <class T, std::size_t... I> consteval bool takes(std::index_sequence<I...>) {
    return requires { T{(static_cast<void>(I), any_member{})...}; };
}

} // namespace detail

template <class T> inline constexpr bool is_optional = detail::optional_value<T>::is_optional;

template <auto Member> using member_t = typename detail::member_pointer<decltype(Member)>::type;
template <auto Member> using owner_t = typename detail::member_pointer<decltype(Member)>::owner;
/// The member's type, or what it holds if it is a std::optional.
template <auto Member> using member_value_t = typename detail::optional_value<member_t<Member>>::type;
template <auto Member> inline constexpr bool is_optional_member = detail::optional_value<member_t<Member>>::is_optional;

namespace detail {
// Conditions of layouts are templates of a member and what it is about: compilers show these with the sentence.
template <auto Member, class Is, class Expected> inline constexpr bool has_type = std::is_same_v<Is, Expected>;
template <auto Member, class Is, class Carried>
inline constexpr bool is_carried =
    std::is_same_v<Is, Carried> || (std::is_floating_point_v<Is> && std::is_floating_point_v<Carried>);
} // namespace detail

namespace detail {
template <auto Member> consteval std::string_view spelling_of() {
    return __PRETTY_FUNCTION__; // "... [with auto Member = &a::b::c; ...]" or "... [Member = &a::b::c]"
}
// Prefix and suffix are the same for all pointers; searching each spelling took a tenth of the compile time of all
// messages.
struct sample {
    int member;
};
inline constexpr std::string_view sample_spelling = spelling_of<&sample::member>();
inline constexpr std::string_view sample_name = "sample::member";
inline constexpr std::size_t spelling_behind =
    sample_spelling.size() - sample_spelling.find(sample_name) - sample_name.size();
} // namespace detail

/// Name of a member, from the compiler's own spelling of the pointer, so that no name is written twice. An underscore
/// at its end, where the standard's word is a keyword, is omitted. Consteval: firmware that uses no names contains no
/// text.
template <auto Member> consteval std::string_view name_of() {
    constexpr std::string_view spelling = detail::spelling_of<Member>();
    std::size_t stop = spelling.size() - detail::spelling_behind;
    while (spelling[stop - 1] == ')' || spelling[stop - 1] == '_') --stop;
    const std::size_t start = spelling.rfind(':', stop) + 1;
    return spelling.substr(start, stop - start);
}

/// The same as a constant, where an expression is evaluated at run time.
template <auto Member> inline constexpr std::string_view member_name = name_of<Member>();

/// Name of a type without its namespaces: `set_wrench_effort`. A template `basic_x<N>` is called `x`.
template <class Type> consteval std::string_view type_name() {
    constexpr std::string_view spelling = __PRETTY_FUNCTION__; // "... [with Type = a::b; ...]" or "[Type = a::b]"
    constexpr auto first = spelling.find("Type = ") + 7;
    constexpr auto end = spelling.find_first_of(";]<", first);
    constexpr auto colon = spelling.rfind(':', end);
    constexpr auto start = colon == std::string_view::npos || colon < first ? first : colon + 1;
    constexpr auto name = spelling.substr(start, end - start);
    return name.starts_with("basic_") ? name.substr(6) : name;
}

/// Whether an aggregate has more than `Count` members. One question and not a count, because each costs the compiler
/// a search for a conversion to every member: counting took a fifth of the time to compile all messages.
template <class T, std::size_t Count>
inline constexpr bool has_more_members_than = detail::takes<T>(std::make_index_sequence<Count + 1>{});

} // namespace jauscat::wire
