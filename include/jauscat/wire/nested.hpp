// A member that is a message itself.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <optional>

namespace jauscat::wire {

template <class T> class raw;
template <message T> class view;

/// The member `Member`, laid out by its own schema.
template <auto Member> struct nested {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_value_t<Member>;
    using inner = layout_of<value_type>;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr std::size_t min_size = inner::min_size, max_size = inner::max_size;
    using raw_type = std::conditional_t<optional, std::optional<raw<value_type>>, raw<value_type>>;
    static_assert(!optional || fixed_item<inner>, "nested: an optional structure must have a fixed size");

    static consteval std::string_view name() { return name_of<Member>(); }

    [[gnu::always_inline]] static constexpr std::size_t size(const auto& object) noexcept {
        return inner::size(member_of<Member>(object));
    }
    [[gnu::always_inline]] static constexpr errc put(const auto& object,
                                                     std::byte* out) noexcept requires fixed_item<inner> {
        const auto& member = member_of<Member>(object);
        if constexpr (optional)
            return inner::put(*member, out_cursor{out, errc::ok}).error;
        else
            return inner::put(member, out_cursor{out, errc::ok}).error;
    }
    [[gnu::always_inline]] static constexpr errc get(auto& object,
                                                     const std::byte* in) noexcept requires fixed_item<inner> {
        auto& member = member_of<Member>(object);
        if constexpr (optional)
            return inner::get(member.emplace(), in_cursor{in, 0}).error();
        else
            return inner::get(member, in_cursor{in, 0}).error();
    }
    [[gnu::always_inline]] static constexpr out_cursor put(const auto& object, out_cursor c) noexcept {
        return inner::put(member_of<Member>(object), c);
    }
    [[gnu::always_inline]] static constexpr in_cursor get(auto& object, in_cursor c) noexcept {
        return inner::get(member_of<Member>(object), c);
    }
    [[gnu::always_inline]] static constexpr in_cursor measure(in_cursor c) noexcept { return inner::measure(c); }
    [[gnu::always_inline]] static constexpr std::size_t extent(const std::byte* in) noexcept {
        return inner::extent(in);
    }
    template <auto, reading> [[gnu::always_inline]] static constexpr auto read(const std::byte* in) noexcept {
        return view<value_type>::of_measured({in, inner::extent(in)});
    }
    static constexpr void visit(auto& object, auto&& visitor) { visitor(nested{}, member_of<Member>(object)); }
};

} // namespace jauscat::wire
