// A member that a flag of an enclosing structure announces.
#pragma once
#include <jauscat/wire/layout.hpp>

namespace jauscat::wire {

namespace detail {
template <auto Member, class Item> inline constexpr bool may_be_absent = Item::optional;
} // namespace detail

/// `Item`, with a std::optional member, is encoded only if the bool `Flag`, a member of this structure or of an
/// enclosing one, is set. Encoding a value without its flag, or a flag without its value, gives presence_mismatch.
template <auto Flag, class Item> struct gated_by {
    static_assert(detail::checked_item<Item>, "gated_by: the item lacks an operation");
    using gated_item = Item;
    static constexpr auto key = Item::key;
    using keys = typename Item::keys;
    using refers = joined_keys<key_list<Flag>, references_of<Item>>;
    using raw_type = typename Item::raw_type;
    static constexpr bool optional = false; // no presence vector of its own
    static constexpr bool contextual = true;
    static constexpr bool needs_memory = item_needs_memory<Item>;
    static constexpr bool checks_values = item_checks_values<Item>;
    static constexpr std::size_t min_size = 0, max_size = Item::max_size;
    static_assert(detail::may_be_absent<key, Item>, "gated_by: the member must be a std::optional");

    static consteval std::string_view name() { return item_label<Item>(); }

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        return member_of<key>(object).has_value() ? detail::sized<Item>::size(object, here) : 0;
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const bool there = look_up<Flag>(here);
        if (there != member_of<key>(object).has_value()) return {c.at, errc::presence_mismatch};
        if (there) detail::put_item<Item>(object, c, here);
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        if (!look_up<Flag>(here))
            member_of<key>(object).reset();
        else if (detail::spend(c, Item::min_size))
            detail::get_item<Item>(object, c, here);
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        if (look_up<Flag>(here) && detail::spend(c, Item::min_size)) detail::measure_item<Item>(c, here);
        return c;
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return look_up<Flag>(here) ? detail::extent_of_item<Item>(in, here) : 0;
    }
    template <auto Member, reading Mode>
    JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        using value = decltype(Item::template read<Member, Mode>(in, here));
        using found = std::conditional_t<detail::optional_value<value>::is_optional, value, std::optional<value>>;
        return look_up<Flag>(here) ? found{Item::template read<Member, Mode>(in, here)} : found{};
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) { Item::visit(object, visitor); }
};

} // namespace jauscat::wire
