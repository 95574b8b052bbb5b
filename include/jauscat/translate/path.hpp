// A field of a message, reached through the messages that nest it; and all such fields of a message.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace jauscat::translate {

/// `at<&header::destination, &address::node>`: the field that these member pointers lead to, outermost first, in a
/// message or in its raw.
template <auto First, auto... Rest> struct at {
    using type = typename at<Rest...>::type;
    static consteval std::string_view field() noexcept { return at<Rest...>::field(); }
    /// The outermost member; empty where the field is a member of the message itself.
    static consteval std::string_view parent() noexcept { return wire::name_of<First>(); }
    template <auto Outer> using within = at<Outer, First, Rest...>;
    [[gnu::always_inline]] static constexpr auto& of(auto& object) noexcept {
        return at<Rest...>::of(wire::member_of<First>(object));
    }
};
/// The last step of a path.
template <auto Member> struct at<Member> {
    using type = wire::member_t<Member>;
    static consteval std::string_view field() noexcept { return wire::name_of<Member>(); }
    static consteval std::string_view parent() noexcept { return {}; }
    template <auto Outer> using within = at<Outer, Member>;
    [[gnu::always_inline]] static constexpr auto& of(auto& object) noexcept { return wire::member_of<Member>(object); }
};

namespace detail {
template <class T> inline constexpr bool is_path = false;
template <auto First, auto... Rest> inline constexpr bool is_path<at<First, Rest...>> = true;
} // namespace detail

/// A field that a row names: an `at<...>`.
template <class T> concept path = detail::is_path<T>;

/// The fields that a row reads or fills.
template <class... Paths> struct path_list {
    static_assert((path<Paths> && ...), "path_list: a row names what is no field; write at<&T::member>");
    static constexpr std::size_t size = sizeof...(Paths);
    template <class Path> static constexpr std::size_t count = (std::size_t{std::is_same_v<Path, Paths>} + ... + 0);
    template <auto Outer> using within = path_list<typename Paths::template within<Outer>...>;
    /// How many of these are in `Other` at least once.
    template <class Other>
    static constexpr std::size_t found_in = (std::size_t{Other::template count<Paths> != 0} + ... + 0);
    template <class Other> static constexpr bool each_once_in = ((Other::template count<Paths> == 1) && ... && true);
    static constexpr bool distinct = ((count<Paths> == 1) && ... && true);
};

namespace detail {

template <class... Lists> struct joined {
    using type = path_list<>;
};
template <class... A> struct joined<path_list<A...>> {
    using type = path_list<A...>;
};
template <class... A, class... B, class... More>
struct joined<path_list<A...>, path_list<B...>, More...> : joined<path_list<A..., B...>, More...> {};

template <class Item> struct leaves; // no specialisation: a table does not reach into lists, strings and variants
template <auto Member, class Codec> struct leaves<wire::field<Member, Codec>> {
    using type = path_list<at<Member>>;
};
template <auto Member, std::size_t Width> struct leaves<wire::bit_field<Member, Width>> {
    using type = path_list<at<Member>>;
};
template <std::size_t Width> struct leaves<wire::reserved<Width>> {
    using type = path_list<>;
};
template <class Carrier, class... Fields>
struct leaves<wire::bit_fields<Carrier, Fields...>> : joined<typename leaves<Fields>::type...> {};
template <wire::unknown_bits Unknown, class Carrier, class... Items>
struct leaves<wire::presence_group<Unknown, Carrier, Items...>> : joined<typename leaves<Items>::type...> {};
template <class... Items> struct leaves<wire::layout<Items...>> : joined<typename leaves<Items>::type...> {};
template <auto Member> struct leaves<wire::nested<Member>> {
    using type = typename leaves<typename wire::nested<Member>::inner>::type::template within<Member>;
};

} // namespace detail

template <class... Lists> using joined_paths = typename detail::joined<Lists...>::type;

/// The paths of every field of the message `T`, in wire order.
template <wire::fixed_message T> using paths_of = typename detail::leaves<wire::layout_of<T>>::type;

} // namespace jauscat::translate
