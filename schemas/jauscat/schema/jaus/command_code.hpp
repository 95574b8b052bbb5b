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
template <coded_message T>
inline constexpr std::uint16_t command_code_of = wire::schema<typename detail::real_form<T>::type>::command_code;

} // namespace jauscat::jaus
