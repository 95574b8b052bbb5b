// Decodes messages.
#pragma once
#include <jauscat/wire/layout.hpp>
#include <jauscat/wire/packed_size.hpp>
#include <jauscat/wire/value_set.hpp>

#include <span>

namespace jauscat::wire {

namespace detail {
/// See put_message. The slack that is left counts the bytes behind the message.
template <message T, class Root = plain_root>
JAUSCAT_FLATTEN constexpr in_cursor get_message(T& __restrict value, const std::byte* __restrict in, std::size_t slack,
                                                Root root = {}) noexcept {
    return layout_of<T>::get(value, {in, slack}, object_scope{value, root});
}

/// `ToTheEnd`: no bytes may be left.
template <bool ToTheEnd, outside_values Outside = outside_values::refused, message T, class Root>
[[gnu::always_inline]] constexpr result<std::size_t, errc> decode(T& value, std::span<const std::byte> in,
                                                                  Root root) noexcept {
    if (in.size() < min_size<T>) return errc::truncated;
    if constexpr (!never_too_long<T>) {
        if (in.size() > packed_size<errc>::max_size) return errc::too_long;
    }
    const in_cursor end = get_message(value, in.data(), in.size() - min_size<T>, root);
    if (end.at == nullptr) return end.error();
    if (ToTheEnd && end.slack != 0) return errc::trailing_bytes;
    if constexpr (Outside == outside_values::refused && layout_of<T>::checks_values) {
        if (const errc error = check_values(value); error != errc::ok) return error;
    }
    return in.size() - end.slack;
}
} // namespace detail

/// Reads a `T` from the front of `in`, which must not overlap `value`, and returns the number of bytes it took; what
/// follows is the caller's. After an error `value` is valid but unspecified. Errors: truncated, out_of_range,
/// unknown_presence_bit, unknown_tag, count_above_capacity, too_deep, too_long; outside_value_set, after which `value`
/// is complete.
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc>
decode_prefix(T& value, std::span<const std::byte> in) noexcept {
    static_assert(!needs_memory<T>, "decode: the message has lists; give an arena as the third argument");
    return detail::decode<false>(value, in, plain_root{});
}
/// The same for a message with lists; the elements are stored in `memory`. Errors: also arena_full.
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc>
decode_prefix(T& value, std::span<const std::byte> in, arena& memory) noexcept {
    return detail::decode<false>(value, in, memory_root{memory});
}

/// Reads a `T` that fills `in` exactly. Errors: those of decode_prefix, and trailing_bytes.
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc> decode(T& value,
                                                                             std::span<const std::byte> in) noexcept {
    static_assert(!needs_memory<T>, "decode: the message has lists; give an arena as the third argument");
    return detail::decode<true>(value, in, plain_root{});
}
/// The same for a message with lists; the elements are stored in `memory`.
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc> decode(T& value, std::span<const std::byte> in,
                                                                             arena& memory) noexcept {
    return detail::decode<true>(value, in, memory_root{memory});
}

// With `tolerate_values` as the last argument values outside their value sets are accepted.
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc>
decode_prefix(T& value, std::span<const std::byte> in, tolerate_values_tag) noexcept {
    static_assert(!needs_memory<T>, "decode: the message has lists; give an arena as the third argument");
    return detail::decode<false, detail::outside_values::tolerated>(value, in, plain_root{});
}
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc>
decode_prefix(T& value, std::span<const std::byte> in, arena& memory, tolerate_values_tag) noexcept {
    return detail::decode<false, detail::outside_values::tolerated>(value, in, memory_root{memory});
}

template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc> decode(T& value, std::span<const std::byte> in,
                                                                             tolerate_values_tag) noexcept {
    static_assert(!needs_memory<T>, "decode: the message has lists; give an arena as the third argument");
    return detail::decode<true, detail::outside_values::tolerated>(value, in, plain_root{});
}
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::size_t, errc>
decode(T& value, std::span<const std::byte> in, arena& memory, tolerate_values_tag) noexcept {
    return detail::decode<true, detail::outside_values::tolerated>(value, in, memory_root{memory});
}

} // namespace jauscat::wire
