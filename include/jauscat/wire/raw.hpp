// A message with every scaled field as the integer on the wire: exact for every byte pattern, without floating point.
#pragma once
#include <jauscat/wire/layout.hpp>

namespace jauscat::wire {

namespace detail {

template <auto Member, class Value> struct slot {
    Value value{};
    friend constexpr bool operator==(const slot&, const slot&) = default;
};

// The slots of an item: one for each leaf that carries a member.
template <class Item> struct slots_of : slot<Item::key, typename Item::raw_type> {
    friend constexpr bool operator==(const slots_of&, const slots_of&) = default;
};
template <std::size_t Width> struct slots_of<reserved<Width>> {
    friend constexpr bool operator==(const slots_of&, const slots_of&) = default;
};
template <class Carrier, class... Fields> struct slots_of<bits<Carrier, Fields...>> : slots_of<Fields>... {
    friend constexpr bool operator==(const slots_of&, const slots_of&) = default;
};
template <unknown_bits Unknown, class Carrier, class... Items>
struct slots_of<presence_group<Unknown, Carrier, Items...>> : slots_of<Items>... {
    friend constexpr bool operator==(const slots_of&, const slots_of&) = default;
};
template <class... Items> struct slots_of<layout<Items...>> : slots_of<Items>... {
    friend constexpr bool operator==(const slots_of&, const slots_of&) = default;
};

} // namespace detail

/// The raw form of the message `T`, generated from its layout, under the same member pointers:
/// `r.get<&T::speed>()`, `r.set<&T::speed>(raw)`. Optional members are std::optional, nested messages are raw
/// themselves. Encodes and decodes like `T`, but any raw value is legal.
template <class T> class raw : detail::slots_of<layout_of<T>> {
  public:
    using raw_of = T;

    template <auto Member> [[nodiscard]] constexpr const auto& get() const noexcept { return find<Member>(*this); }
    template <auto Member> constexpr void set(const auto& value) noexcept { find<Member>(*this) = value; }
    /// The stored value itself, to be changed in place.
    template <auto Member> [[nodiscard]] constexpr auto& slot() noexcept { return find<Member>(*this); }
    template <auto Member> [[nodiscard]] constexpr const auto& slot() const noexcept { return find<Member>(*this); }

    friend constexpr bool operator==(const raw&, const raw&) = default;

  private:
    template <auto Member, class Value>
    [[gnu::always_inline]] static constexpr Value& find(detail::slot<Member, Value>& s) noexcept {
        return s.value;
    }
    template <auto Member, class Value>
    [[gnu::always_inline]] static constexpr const Value& find(const detail::slot<Member, Value>& s) noexcept {
        return s.value;
    }
};

template <message T> struct schema<raw<T>> { using type = layout_of<T>; };
template <message T> struct checked_schema<raw<T>> : schema<raw<T>> {};

} // namespace jauscat::wire
