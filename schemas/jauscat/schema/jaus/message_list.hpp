// Message types, for code that is the same for each of them.
#pragma once

namespace jauscat::jaus {

/// A list of message types.
template <class... Messages> struct message_list {};

namespace detail {
template <class List, class... Others> struct joined_lists {
    using type = List;
};
template <class... A, class... B, class... Others>
struct joined_lists<message_list<A...>, message_list<B...>, Others...>
    : joined_lists<message_list<A..., B...>, Others...> {};
} // namespace detail

/// The messages of several lists, in one.
template <class... Lists> using joined_lists = typename detail::joined_lists<Lists...>::type;

} // namespace jauscat::jaus
