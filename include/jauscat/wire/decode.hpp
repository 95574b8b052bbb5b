// Decodes messages.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <span>

namespace jauscat::wire {

namespace detail {
/// See put_message. The slack that is left counts the bytes behind the message.
template <message T, class Root = plain_root>
JAUSCAT_FLATTEN constexpr in_cursor get_message(T& __restrict value, const std::byte* __restrict in, std::size_t slack,
                                                Root root = {}) noexcept {
    return layout_of<T>::get(value, {in, slack}, object_scope{value, root});
}

template <message T, class Root>
[[gnu::always_inline]] constexpr result decode(T& value, std::span<const std::byte> in, Root root,
                                               bool to_the_end) noexcept {
    if (in.size() < min_size<T>) return errc::truncated;
    if constexpr (!never_too_long<T>) {
        if (in.size() > result::max_size) return errc::too_long;
    }
    const in_cursor end = get_message(value, in.data(), in.size() - min_size<T>, root);
    if (end.at == nullptr) return end.error();
    if (to_the_end && end.slack != 0) return errc::trailing_bytes;
    return in.size() - end.slack;
}
} // namespace detail

/// Reads a `T` from the front of `in`, which must not overlap `value`, and returns the bytes it took; what follows is
/// the caller's. After an error `value` is valid but unspecified. Errors: truncated, out_of_range,
/// unknown_presence_bit, unknown_tag, count_above_capacity, too_deep, too_long.
template <message T> constexpr result decode_prefix(T& value, std::span<const std::byte> in) noexcept {
    static_assert(!needs_memory<T>, "decode: the message has lists; give an arena as the third argument");
    return detail::decode(value, in, plain_root{}, false);
}
/// The same for a message with lists, whose elements are taken from `memory`. Errors: also arena_full.
template <message T> constexpr result decode_prefix(T& value, std::span<const std::byte> in, arena& memory) noexcept {
    return detail::decode(value, in, memory_root{memory}, false);
}

/// Reads a `T` that fills `in` exactly. Errors: those of decode_prefix, and trailing_bytes.
template <message T> constexpr result decode(T& value, std::span<const std::byte> in) noexcept {
    static_assert(!needs_memory<T>, "decode: the message has lists; give an arena as the third argument");
    return detail::decode(value, in, plain_root{}, true);
}
/// The same for a message with lists, whose elements go to `memory`.
template <message T> constexpr result decode(T& value, std::span<const std::byte> in, arena& memory) noexcept {
    return detail::decode(value, in, memory_root{memory}, true);
}

} // namespace jauscat::wire
