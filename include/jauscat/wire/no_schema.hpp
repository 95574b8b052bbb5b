// The codec's functions for types without a schema: one sentence instead of a list of candidates.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <span>

namespace jauscat::wire {

namespace detail {
/// A type without a schema.
template <class T> concept unknown_type = !message<T>;
template <class T> consteval errc refuse_unknown_type() {
    static_assert(message<T>, "the type has no schema: give it a struct schema with its layout as type, or specialise "
                              "jauscat::wire::schema for it");
    return errc::out_of_range;
}
} // namespace detail

template <detail::unknown_type T> constexpr auto encode(const T&, auto&&...) noexcept {
    return detail::refuse_unknown_type<T>();
}
template <detail::unknown_type T> constexpr auto encoded_size(const T&) noexcept {
    return detail::refuse_unknown_type<T>();
}
template <detail::unknown_type T> constexpr auto decode(T&, auto&&...) noexcept {
    return detail::refuse_unknown_type<T>();
}
template <detail::unknown_type T> constexpr auto decode_prefix(T&, auto&&...) noexcept {
    return detail::refuse_unknown_type<T>();
}
template <detail::unknown_type T> constexpr auto diagnose(std::span<const std::byte>) noexcept {
    return detail::refuse_unknown_type<T>();
}
template <detail::unknown_type T> constexpr auto diagnose(const T&, std::size_t = unbounded) noexcept {
    return detail::refuse_unknown_type<T>();
}

} // namespace jauscat::wire
