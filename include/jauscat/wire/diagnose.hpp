// Explains a failed encode or decode: field, element, byte and cause. It walks over the message once more, part by
// part, so that the hot path returns only an error code.
#pragma once
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/trace.hpp>

namespace jauscat::wire {

namespace detail {
/// The error of `decode` with enough memory.
template <message T> constexpr errc decode_error(std::span<const std::byte> in) noexcept {
    using root = std::conditional_t<needs_memory<T>, discarding_root, plain_root>;
    T scratch{};
    return decode<true, outside_values::tolerated>(scratch, in, root{}).error();
}
/// The first value outside its value set, of bytes that decode.
template <message T> constexpr diagnosis value_outside(std::span<const std::byte> in) noexcept {
    if constexpr (layout_of<T>::checks_values) {
        T scratch{};
        decode_trace trace{in, errc::outside_value_set};
        if (!decode_traced(scratch, trace)) return trace.found(trace.error());
    }
    return {};
}
template <message T> constexpr diagnosis value_outside(const T& value) noexcept {
    if constexpr (layout_of<T>::checks_values) {
        encode_trace trace{errc::outside_value_set};
        if (!encode_traced(value, trace)) return trace.found(trace.error());
    }
    return {};
}
} // namespace detail

/// Explains the error that `decode` has found in `in`: the first field in wire order with that error.
template <message T> [[nodiscard]] constexpr diagnosis diagnose(std::span<const std::byte> in, errc error) noexcept {
    if (error == errc::ok || error == errc::outside_value_set) return detail::value_outside<T>(in);
    if (error == errc::too_long) return {.error = error, .needed = in.size(), .available = packed_size<errc>::max_size};
    T scratch{};
    decode_trace trace{in, error};
    decode_traced(scratch, trace);
    if (error != errc::trailing_bytes) return trace.found(error);
    return {.error = error, .offset = in.size() - trace.remaining(), .available = trace.remaining()};
}
/// The same without knowing the error. `error` is ok when the bytes are valid (arena_full depends on the memory).
template <message T> [[nodiscard]] constexpr diagnosis diagnose(std::span<const std::byte> in) noexcept {
    return diagnose<T>(in, detail::decode_error<T>(in));
}

/// Explains the error of `encode` for `value` and `space` bytes; `error` is ok without one.
template <message T>
[[nodiscard]] constexpr diagnosis diagnose(const T& value, std::size_t space = unbounded) noexcept {
    const std::size_t needed = encoded_size(value);
    if (!never_too_long<T> && needed > packed_size<errc>::max_size)
        return {.error = errc::too_long, .needed = needed, .available = packed_size<errc>::max_size};
    if (space < needed) return {.error = errc::no_space, .needed = needed, .available = space};
    encode_trace trace;
    return encode_traced(value, trace) ? detail::value_outside(value) : trace.found(trace.error());
}

} // namespace jauscat::wire
