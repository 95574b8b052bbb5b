// Characters and bytes of any length. They are not copied: a decoded value points into the received bytes.
#pragma once
#include <jauscat/wire/count.hpp>
#include <jauscat/wire/list.hpp>

#include <cstring>
#include <type_traits>

namespace jauscat::wire {

namespace detail {

/// Octets of a member that is a std::string_view or a blob; `Extent` determines the length.
template <auto Member, class Extent> struct octet_run {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_value_t<Member>;
    using raw_type = member_t<Member>;
    static constexpr bool optional = is_optional_member<Member>;
    static consteval std::string_view name() { return name_of<Member>(); }

  protected:
    /// The member that points at `size` octets.
    JAUSCAT_INLINE static constexpr value_type pointing_at(const std::byte* in, std::size_t size) noexcept {
        if constexpr (std::is_same_v<value_type, std::string_view>)
            return {reinterpret_cast<const char*>(in), size}; // not in a constant expression
        else
            return value_type{std::span{in, size}};
    }
    JAUSCAT_INLINE static constexpr void copy(const value_type& value, std::byte* out) noexcept {
        if (std::is_constant_evaluated())
            for (const auto octet : value) *out++ = static_cast<std::byte>(octet);
        else if (!value.empty()) // else its pointer may be null
            std::memcpy(out, value.data(), value.size());
    }
    /// Fills up with zeros to `size`.
    JAUSCAT_INLINE static constexpr errc put_filled(const value_type& value, std::byte* out,
                                                    std::size_t size) noexcept {
        if (value.size() > size) return errc::out_of_range;
        copy(value, out);
        for (std::size_t i = value.size(); i != size; ++i) out[i] = std::byte{};
        return errc::ok;
    }
    /// Without the zeros that fill it up.
    JAUSCAT_INLINE static constexpr std::size_t filled(const std::byte* in, std::size_t size) noexcept {
        while (size != 0 && in[size - 1] == std::byte{}) --size;
        return size;
    }
    /// Writes the octets after the preceding items.
    JAUSCAT_INLINE static constexpr out_cursor append(const value_type& value, out_cursor c) noexcept {
        if (c.error != errc::ok) return c;
        copy(value, c.at);
        c.at += value.size();
        return c;
    }
};

} // namespace detail

// The items that `string` and `bytes` stand for, by what tells their length.

/// The length is a count, before it or elsewhere.
template <auto Member, class Count> struct counted_run : detail::octet_run<Member, Count> {
    using base = detail::octet_run<Member, Count>;
    using count_type = Count;
    using refers = references_of<Count>;
    static_assert(detail::checked_count<Count, owner_t<Member>>,
                  "string: the extent is neither fixed, fixed_or_rest, rest and zero_terminated nor a count (it needs "
                  "prefix_size, contextual, put, get and peek)");
    static constexpr bool contextual = Count::contextual;
    static constexpr bool checks_values = requires { typename Count::value_set; };
    static constexpr std::size_t min_size = Count::prefix_size, max_size = unbounded;

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto&) noexcept {
        return Count::prefix_size + value_of<Member>(object).size();
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const auto& value = value_of<Member>(object);
        return base::append(value, Count::put(value.size(), c, here));
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        std::size_t size{};
        if (!Count::get(size, c, here)) return c;
        if (!detail::spend(c, size)) return c;
        emplace_in<Member>(object) = base::pointing_at(c.at, size);
        c.at += size;
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        const std::size_t size = Count::peek(c.at, here);
        if (!detail::spend(c, size)) return c;
        c.at += Count::prefix_size + size;
        return c;
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return Count::prefix_size + Count::peek(in, here);
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        return base::pointing_at(in + Count::prefix_size, Count::peek(in, here));
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(counted_run{}, member_of<Member>(object));
    }
};

/// To the end of the body.
template <auto Member> struct run_to_end : detail::octet_run<Member, rest> {
    using base = detail::octet_run<Member, rest>;
    static constexpr bool to_the_end = true;
    static constexpr std::size_t min_size = 0, max_size = unbounded;

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto&) noexcept {
        return value_of<Member>(object).size();
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto&) noexcept {
        return base::append(value_of<Member>(object), c);
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto&) noexcept {
        emplace_in<Member>(object) = base::pointing_at(c.at, c.slack);
        return {c.at + c.slack, 0};
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto&) noexcept { return {c.at + c.slack, 0}; }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        return base::pointing_at(in, static_cast<std::size_t>(here.end - in));
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(run_to_end{}, member_of<Member>(object));
    }
};

/// Sent with zeros up to `Size`, received to the end of the body.
template <auto Member, std::size_t Size> struct lenient_run : detail::octet_run<Member, fixed_or_rest<Size>> {
    using base = detail::octet_run<Member, fixed_or_rest<Size>>;
    static constexpr bool to_the_end = true;
    static constexpr std::size_t min_size = 0, max_size = Size;

    JAUSCAT_INLINE static constexpr std::size_t size(const auto&, const auto&) noexcept { return Size; }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto&) noexcept {
        const auto& value = value_of<Member>(object);
        c.error = base::put_filled(value, c.at, Size);
        if (c.error == errc::ok) c.at += Size;
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto&) noexcept {
        emplace_in<Member>(object) = base::pointing_at(c.at, base::filled(c.at, c.slack));
        return {c.at + c.slack, 0};
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto&) noexcept { return {c.at + c.slack, 0}; }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        return base::pointing_at(in, base::filled(in, static_cast<std::size_t>(here.end - in)));
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(lenient_run{}, member_of<Member>(object));
    }
};

/// With zeros up to `Size`.
template <auto Member, std::size_t Size> struct fixed_run : detail::octet_run<Member, fixed<Size>> {
    using base = detail::octet_run<Member, fixed<Size>>;
    static constexpr std::size_t min_size = Size, max_size = Size;

    JAUSCAT_INLINE static constexpr errc put(const auto& object, std::byte* out) noexcept {
        return base::put_filled(value_of<Member>(object), out, Size);
    }
    JAUSCAT_INLINE static constexpr errc get(auto& object, const std::byte* in) noexcept {
        emplace_in<Member>(object) = base::pointing_at(in, base::filled(in, Size));
        return errc::ok;
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto&) noexcept {
        return base::pointing_at(in, base::filled(in, Size));
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(fixed_run{}, member_of<Member>(object));
    }
};

/// Up to a zero.
template <auto Member> struct terminated_run : detail::octet_run<Member, zero_terminated> {
    using base = detail::octet_run<Member, zero_terminated>;
    static constexpr std::size_t min_size = 1, max_size = unbounded;

    /// A value that contains no zero itself.
    JAUSCAT_INLINE static constexpr bool legal(const typename base::value_type& value) noexcept {
        for (const auto octet : value)
            if (static_cast<std::byte>(octet) == std::byte{}) return false;
        return true;
    }
    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto&) noexcept {
        return value_of<Member>(object).size() + 1;
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto&) noexcept {
        const auto& value = value_of<Member>(object);
        if (!legal(value)) return {c.at, errc::out_of_range};
        c = base::append(value, c);
        *c.at++ = std::byte{};
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto&) noexcept {
        const std::size_t size = length(c.at, c.slack + 1);
        if (size == c.slack + 1) return in_cursor::failed(errc::truncated);
        emplace_in<Member>(object) = base::pointing_at(c.at, size);
        return {c.at + size + 1, c.slack - size};
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto&) noexcept {
        const std::size_t size = length(c.at, c.slack + 1);
        if (size == c.slack + 1) return in_cursor::failed(errc::truncated);
        return {c.at + size + 1, c.slack - size};
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto&) noexcept {
        return length(in, unbounded) + 1;
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        return base::pointing_at(in, extent(in, here) - 1);
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(terminated_run{}, member_of<Member>(object));
    }

  private:
    /// Octets before the zero, or `most` where there is none among so many.
    JAUSCAT_INLINE static constexpr std::size_t length(const std::byte* in, std::size_t most) noexcept {
        std::size_t size = 0;
        while (size != most && in[size] != std::byte{}) ++size;
        return size;
    }
};

namespace detail {
template <auto Member, class Extent> struct run_of {
    using type = counted_run<Member, Extent>;
};
template <auto Member> struct run_of<Member, rest> {
    using type = run_to_end<Member>;
};
template <auto Member, std::size_t Size> struct run_of<Member, fixed_or_rest<Size>> {
    using type = lenient_run<Member, Size>;
};
template <auto Member, std::size_t Size> struct run_of<Member, fixed<Size>> {
    using type = fixed_run<Member, Size>;
};
template <auto Member> struct run_of<Member, zero_terminated> {
    using type = terminated_run<Member>;
};
template <auto Member, class Extent> struct text_run : run_of<Member, Extent> {
    static_assert(has_type<Member, member_value_t<Member>, std::string_view>,
                  "string: the member must be a std::string_view");
};
template <auto Member, class Extent> struct blob_run : run_of<Member, Extent> {
    static_assert(has_type<Member, member_value_t<Member>, blob>, "bytes: the member must be a blob");
};
} // namespace detail

/// Characters (member: std::string_view): `fixed<N>`, `fixed_or_rest<N>`, `zero_terminated`, `rest`, or a count.
/// A string that is longer than `N` or contains its own terminator does not encode (`out_of_range`).
template <auto Member, class Extent> using string = typename detail::text_run<Member, Extent>::type;

/// Bytes (member: blob): `rest` or a count.
template <auto Member, class Extent> using bytes = typename detail::blob_run<Member, Extent>::type;

} // namespace jauscat::wire
