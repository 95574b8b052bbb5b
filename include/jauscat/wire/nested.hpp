// A member that is a message itself.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <type_traits>

namespace jauscat::wire {

template <class T> class raw;
template <class T, class Outer> class view;

namespace detail {
template <class Item> concept copied_item = requires { requires Item::codec_type::as_in_memory; };

// A small structure with the same bytes on the wire and in memory. Clang 14 moves it byte by byte unless it is copied
// as a whole: a JAUS header, with its two addresses, took a third longer. GCC merges the moves by itself, and a copy
// would keep the structure in memory: back through the seed table took a quarter longer.
#ifdef __clang__
inline constexpr std::size_t largest_copied_whole = 8;
#else
inline constexpr std::size_t largest_copied_whole = 0;
#endif
template <class T>
inline constexpr bool copied_whole = [] {
    using layout = layout_of<T>;
    constexpr bool only_copies = layout::all_items([]<class Item>() { return copied_item<Item>; });
    if constexpr (only_copies && sizeof(T) == layout::max_size && sizeof(T) <= largest_copied_whole &&
                  std::has_unique_object_representations_v<T>) {
        // One pattern of distinct bytes shows whether the members are in the order of the layout.
        std::array<std::byte, sizeof(T)> memory{}, wire{};
        for (std::size_t i = 0; i != sizeof(T); ++i) memory[i] = static_cast<std::byte>(i);
        layout::put(std::bit_cast<T>(memory), {wire.data(), errc::ok}, plain_root{});
        return wire == memory;
    } else {
        return false;
    }
}();
} // namespace detail

/// The member `Member`, laid out by its own schema.
template <auto Member> struct nested {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_value_t<Member>;
    using inner = layout_of<value_type>;
    using refers = references_of<inner>;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr std::size_t min_size = inner::min_size, max_size = inner::max_size;
    static constexpr bool contextual = inner::contextual;
    static constexpr bool needs_memory = inner::needs_memory;
    static constexpr bool checks_values = inner::checks_values;
    static constexpr bool to_the_end = inner::to_the_end;
    using raw_type = std::conditional_t<optional, std::optional<raw<value_type>>, raw<value_type>>;

    static consteval std::string_view name() { return name_of<Member>(); }

    JAUSCAT_INLINE static constexpr errc put(const auto& object, std::byte* out) noexcept
    requires fixed_item<inner>
    {
        const auto& value = value_of<Member>(object);
        if constexpr (detail::copied_whole<value_type> && !raw_object<decltype(object)>) {
            if (!std::is_constant_evaluated()) {
                std::memcpy(out, &value, max_size);
                return errc::ok;
            }
        }
        return inner::put(value, out_cursor{out, errc::ok}, plain_root{}).error;
    }
    JAUSCAT_INLINE static constexpr errc get(auto& object, const std::byte* in) noexcept
    requires fixed_item<inner>
    {
        auto& value = emplace_in<Member>(object);
        if constexpr (detail::copied_whole<value_type> && !raw_object<decltype(object)>) {
            if (!std::is_constant_evaluated()) {
                std::memcpy(&value, in, max_size);
                return errc::ok;
            }
        }
        return inner::get(value, in_cursor{in, 0}, plain_root{}).error();
    }
    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        const auto& value = value_of<Member>(object);
        return inner::size(value, object_scope{value, here});
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const auto& value = value_of<Member>(object);
        return inner::put(value, c, object_scope{value, here});
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        auto& value = emplace_in<Member>(object);
        return inner::get(value, c, object_scope{value, here});
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        return inner::measure(c, inside(c.at, here));
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return inner::extent(in, inside(in, here));
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        const std::span<const std::byte> bytes{in, inner::extent(in, inside(in, here))};
        if constexpr (contextual)
            return view<value_type, std::remove_cvref_t<decltype(here)>>::of_measured(bytes, here);
        else
            return view<value_type, plain_root>::of_measured(bytes, plain_root{});
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(nested{}, member_of<Member>(object));
    }

  private:
    JAUSCAT_INLINE static constexpr auto inside(const std::byte* in, const auto& here) noexcept {
        return byte_scope<value_type, std::remove_cvref_t<decltype(here)>>{in, here.end, here};
    }
};

} // namespace jauscat::wire
