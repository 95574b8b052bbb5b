// Encodes messages.
#pragma once
#include <jauscat/wire/layout.hpp>
#include <jauscat/wire/packed_size.hpp>
#include <jauscat/wire/value_set.hpp>

#include <span>

namespace jauscat::wire {

namespace detail {
/// The one function per message that a compiler may keep out of line. All below it is forced inline, so the promise
/// made here, that value and bytes do not overlap, lets neighbouring loads and stores merge.
template <class Root = plain_root, message T>
JAUSCAT_FLATTEN constexpr out_cursor put_message(const T& __restrict value, std::byte* __restrict out) noexcept {
    return layout_of<T>::put(value, {out, errc::ok}, object_scope{value, Root{}});
}
/// The same for a message that may be too long for any buffer; its size is found on the way.
template <class Root = plain_root, message T>
JAUSCAT_FLATTEN constexpr out_cursor put_if_it_fits(const T& __restrict value, std::byte* __restrict out,
                                                    std::size_t space) noexcept {
    const std::size_t size = layout_of<T>::size(value, object_scope{value, plain_root{}});
    if (size > packed_size<errc>::max_size) return {out, errc::too_long};
    if (size > space) return {out, errc::no_space};
    return layout_of<T>::put(value, {out, errc::ok}, object_scope{value, Root{}});
}
} // namespace detail

/// Encoded size of `value` in bytes.
template <message T>
[[nodiscard, gnu::noinline]] JAUSCAT_FLATTEN constexpr std::size_t encoded_size(const T& value) noexcept {
    if constexpr (fixed_message<T>)
        return max_size<T>;
    else
        return layout_of<T>::size(value, object_scope{value, plain_root{}});
}

namespace detail {
/// A message, and where its bytes go; none where they do not fit.
template <message T> struct destination {
    const T* value;
    std::byte* out;
};
/// For a buffer shorter than the longest `T`. It returns its arguments, so that what calls it has nothing to save
/// across the call where the buffer is long enough: six instructions of thirty for a small message.
template <message T>
[[nodiscard, gnu::noinline]] JAUSCAT_FLATTEN constexpr destination<T> if_it_fits(const T* value, std::byte* out,
                                                                                 std::size_t space) noexcept {
    const bool fits = layout_of<T>::size(*value, object_scope{*value, plain_root{}}) <= space;
    return fits ? destination<T>{value, out} : destination<T>{};
}

template <outside_values Outside, message T>
[[gnu::always_inline]] constexpr result<std::span<std::byte>, errc> encode(const T& value,
                                                                           std::span<std::byte> out) noexcept {
    destination<T> to{&value, out.data()};
    if constexpr (fixed_message<T>) {
        if (out.size() < max_size<T>) return errc::no_space;
    } else if constexpr (never_too_long<T>) {
        if (out.size() < max_size<T>) {
            to = if_it_fits(to.value, to.out, out.size());
            if (to.value == nullptr) return errc::no_space;
        }
    }
    constexpr bool checks = Outside == outside_values::refused && layout_of<T>::checks_values;
    using root = std::conditional_t<checks && only_variants_check<T>, checking_root, plain_root>;
    if constexpr (checks && !only_variants_check<T>)
        if (const errc error = check_values(*to.value); error != errc::ok) return error;
    out_cursor end{to.out, errc::ok};
    if constexpr (never_too_long<T>)
        end = put_message<root>(*to.value, to.out);
    else
        end = put_if_it_fits<root>(value, to.out, out.size());
    if (end.error != errc::ok) return end.error;
    return std::span<std::byte>{to.out, end.at};
}
} // namespace detail

/// Writes `value` to the front of `out`, which must not overlap it, and returns the bytes written.
/// Errors: no_space, too_long (nothing was written); outside_value_set, out_of_range, count_above_capacity,
/// count_mismatch, unknown_tag, presence_mismatch, too_deep (`out` is then unspecified).
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::span<std::byte>, errc>
encode(const T& value, std::span<std::byte> out) noexcept {
    return detail::encode<detail::outside_values::refused>(value, out);
}
/// The same, but accepts values outside their value sets.
template <message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::span<std::byte>, errc>
encode(const T& value, std::span<std::byte> out, tolerate_values_tag) noexcept {
    return detail::encode<detail::outside_values::tolerated>(value, out);
}

} // namespace jauscat::wire
