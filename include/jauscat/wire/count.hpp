// Counts and lengths of lists, strings and bytes.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <algorithm>
#include <limits>

namespace jauscat::wire {

/// A name in a template argument, for what has no member: `count<"number_of_joints", u8>`.
template <std::size_t N> struct label {
    std::array<char, N> text{}; ///< with the zero at its end
    /// Of a string literal.
    consteval label(const char (&literal)[N]) { std::copy_n(literal, N, text.begin()); }
    /// Without the zero at its end.
    [[nodiscard]] constexpr std::string_view view() const noexcept { return {text.data(), N - 1}; }
};

/// A count right before what it counts. It is no member: encoding writes the list's size.
template <label Name, class Codec> struct count {
    static_assert(detail::checked_codec<Codec>,
                  "count: the second argument is not a codec (it needs value_type, size, store and load)");
    using codec_type = Codec;
    using value_type = typename Codec::value_type;
    static constexpr std::size_t prefix_size = Codec::size;
    static constexpr bool contextual = false;
    static_assert(std::unsigned_integral<value_type>, "count: the carrier must be an unsigned integer");
    static constexpr std::size_t limit =
        sizeof(value_type) < sizeof(std::size_t) ? std::numeric_limits<value_type>::max() : ~std::size_t{};
    static consteval std::string_view name() { return Name.view(); }

    JAUSCAT_INLINE static constexpr out_cursor put(std::size_t elements, out_cursor c, const auto&) noexcept {
        if (elements > limit) return {c.at, errc::count_above_capacity};
        c.error = Codec::store(c.at, static_cast<value_type>(elements));
        if (c.error == errc::ok) c.at += Codec::size;
        return c;
    }
    // Reads it and steps over it.
    JAUSCAT_INLINE static constexpr bool get(std::size_t& elements, in_cursor& c, const auto& here) noexcept {
        elements = peek(c.at, here);
        c.at += Codec::size;
        return true;
    }
    JAUSCAT_INLINE static constexpr std::size_t peek(const std::byte* in, const auto&) noexcept {
        value_type value{};
        Codec::load(in, value);
        return static_cast<std::size_t>(value);
    }
};

namespace detail {

/// A count of elements in the structure `T`.
template <class Count, class T>
concept element_count = requires(std::size_t elements, out_cursor out, in_cursor in, const encoding_scope<T>& here,
                                 const decoding_scope<T>& there, const viewing_scope<T>& seen) {
    { Count::prefix_size } -> std::convertible_to<std::size_t>;
    { Count::contextual } -> std::convertible_to<bool>;
    { Count::put(elements, out, here) } -> std::same_as<out_cursor>;
    { Count::get(elements, in, there) } -> std::same_as<bool>;
    { Count::peek(in.at, seen) } -> std::same_as<std::size_t>;
};
/// Says which operation a count lacks.
template <class Count, class T> struct missing_in_count {
    static constexpr bool started = requires { Count::prefix_size; }; // else it is no count at all
    static_assert(
        !started || requires {
            { Count::contextual } -> std::convertible_to<bool>;
        }, "count: it has no contextual, which says whether it looks at what stands around it");
    static_assert(
        !started || requires(out_cursor out, const encoding_scope<T>& here) {
            { Count::put(std::size_t{}, out, here) } -> std::same_as<out_cursor>;
        }, "count: it has no put(std::size_t, out_cursor, scope) that returns out_cursor");
    static_assert(
        !started || requires(std::size_t& elements, in_cursor& in, const decoding_scope<T>& here) {
            { Count::get(elements, in, here) } -> std::same_as<bool>;
        }, "count: it has no get(std::size_t&, in_cursor&, scope) that returns bool");
    static_assert(
        !started || requires(const std::byte* in, const viewing_scope<T>& here) {
            { Count::peek(in, here) } -> std::same_as<std::size_t>;
        }, "count: it has no peek(const std::byte*, scope) that returns std::size_t");
    static constexpr bool complete = false;
};
template <class Count, class T> inline constexpr bool checked_count = true;
template <class Count, class T>
requires(!element_count<Count, T>)
inline constexpr bool checked_count<Count, T> = missing_in_count<Count, T>::complete;

/// Base of counts that are members elsewhere. `Less` is what the count is smaller by.
template <std::size_t Less, auto First, auto... Rest> struct count_elsewhere {
    using refers = key_list<First>;
    static constexpr std::size_t prefix_size = 0;
    static constexpr bool contextual = true;

    JAUSCAT_INLINE static constexpr out_cursor put(std::size_t elements, out_cursor c, const auto& here) noexcept {
        if (elements != peek(nullptr, here)) c.error = errc::count_mismatch;
        return c;
    }
    JAUSCAT_INLINE static constexpr bool get(std::size_t& elements, in_cursor& c, const auto& here) noexcept {
        elements = peek(c.at, here);
        return true;
    }
    JAUSCAT_INLINE static constexpr std::size_t peek(const std::byte*, const auto& here) noexcept {
        const auto value = static_cast<std::size_t>(look_up<First, Rest...>(here));
        return value < Less ? 0 : value - Less;
    }
};
} // namespace detail

/// The common base of `counted_by` (`Less` is 0) and `one_less_than` (1).
template <std::size_t Less, auto... Path> using count_elsewhere = detail::count_elsewhere<Less, Path...>;

/// The count is a member of this structure or of an enclosing one; further pointers lead into it. Encoding a list of
/// another size gives count_mismatch.
template <auto... Path> struct counted_by : detail::count_elsewhere<0, Path...> {};
/// The same where the member counts one more than there are elements; 0 counts none.
template <auto... Path> struct one_less_than : detail::count_elsewhere<1, Path...> {};

/// All bytes to the end of the body; for its last item.
struct rest {};
/// Always `Size` characters, filled with zeros, which are not part of the value.
template <std::size_t Size> struct fixed {};
/// Sent as `fixed<Size>`; any length to the end of the body is received.
template <std::size_t Size> struct fixed_or_rest {};
/// Up to a zero, which is on the wire and not part of the value.
struct zero_terminated {};

} // namespace jauscat::wire
