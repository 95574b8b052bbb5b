// From bytes to a value.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <span>

namespace jauscat::wire {

namespace detail {
/// See put_message. The slack that is left counts the bytes behind the message.
template <message T>
constexpr in_cursor get_message(T& __restrict value, const std::byte* __restrict in, std::size_t slack) noexcept {
    return layout_of<T>::get(value, {in, slack});
}
} // namespace detail

/// Reads a `T` from the front of `in`, which must not overlap `value`, and returns the bytes it took; what follows is
/// the caller's. After an error `value` is valid but unspecified. Errors: truncated, out_of_range,
/// unknown_presence_bit.
template <message T> constexpr result decode_prefix(T& value, std::span<const std::byte> in) noexcept {
    if (in.size() < min_size<T>) return errc::truncated;
    const in_cursor end = detail::get_message(value, in.data(), in.size() - min_size<T>);
    if (end.at == nullptr) return end.error();
    return in.size() - end.slack;
}

/// Reads a `T` that fills `in` exactly. Errors: those of decode_prefix, and trailing_bytes.
template <message T> constexpr result decode(T& value, std::span<const std::byte> in) noexcept {
    if (in.size() < min_size<T>) return errc::truncated;
    const in_cursor end = detail::get_message(value, in.data(), in.size() - min_size<T>);
    if (end.at == nullptr) return end.error();
    if (end.slack != 0) return errc::trailing_bytes;
    return in.size();
}

} // namespace jauscat::wire
