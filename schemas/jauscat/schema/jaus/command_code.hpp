// The command code of a message, which its schema states.
#pragma once
#include <jauscat/wire/raw.hpp>

#include <concepts>
#include <cstdint>

namespace jauscat::jaus {

namespace detail {
template <class T> struct real_form {
    using type = T;
};
template <wire::raw_object T> struct real_form<T> {
    using type = typename T::raw_of;
};
} // namespace detail

/// A message of the standard or of a user, or the raw of one: its schema has a layout and a command code.
template <class T>
concept coded_message = wire::message<T> && requires {
    { wire::schema<typename detail::real_form<T>::type>::command_code } -> std::convertible_to<std::uint16_t>;
};
/// A type that the functions for messages refuse, with one sentence instead of a list of candidates.
template <class T> concept uncoded_type = !coded_message<T>;
/// The sentence.
template <class T> consteval void refuse_uncoded_type() noexcept {
    static_assert(wire::message<T>, "the type has no schema: give it a struct schema with its layout as type, or "
                                    "specialise jauscat::wire::schema for it");
    static_assert(!wire::message<T>,
                  "the message has no command code: add it to its jauscat::wire::schema, as command_code");
}

template <coded_message T>
inline constexpr std::uint16_t command_code_of = wire::schema<typename detail::real_form<T>::type>::command_code;

/// A message whose schema names the report that answers it, as `report`.
template <class T> concept query_message = coded_message<T> && requires { typename wire::schema<T>::report; };
template <query_message Query> using report_of = typename wire::schema<Query>::report;
/// A message whose schema names the query that it answers, as `query`.
template <class T> concept report_message = coded_message<T> && requires { typename wire::schema<T>::query; };
template <report_message Report> using query_of = typename wire::schema<Report>::query;

} // namespace jauscat::jaus
