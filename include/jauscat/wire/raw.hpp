// A message with every scaled field as the integer on the wire: exact for every byte pattern, without floating point.
#pragma once
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/constant.hpp>
#include <jauscat/wire/gated_by.hpp>
#include <jauscat/wire/layout.hpp>
#include <jauscat/wire/presence.hpp>

namespace jauscat::wire {

namespace detail {

template <auto Member, class Value> struct slot {
    Value value{};
    friend constexpr bool operator==(const slot&, const slot&) = default;
};

// A list, so that items without members, of which a layout may hold equal ones, leave nothing behind.
template <class... Slots> struct slot_list : Slots... {
    friend constexpr bool operator==(const slot_list&, const slot_list&) = default;
};
template <class... Lists> struct joined_slots {
    using type = slot_list<>;
};
template <class... A> struct joined_slots<slot_list<A...>> {
    using type = slot_list<A...>;
};
template <class... A, class... B, class... More>
struct joined_slots<slot_list<A...>, slot_list<B...>, More...> : joined_slots<slot_list<A..., B...>, More...> {};

// The slots of an item: one for each leaf that carries a member.
template <class Item> struct slots_of {
    using type = slot_list<slot<Item::key, typename Item::raw_type>>;
};
template <std::size_t Width> struct slots_of<reserved<Width>> : joined_slots<> {};
template <label Name, class Codec, auto Value> struct slots_of<constant<Name, Codec, Value>> : joined_slots<> {};
template <auto Flag, class Item> struct slots_of<gated_by<Flag, Item>> : slots_of<Item> {};
template <class Carrier, class... Fields>
struct slots_of<bit_fields<Carrier, Fields...>> : joined_slots<typename slots_of<Fields>::type...> {};
template <unknown_bits Unknown, class Carrier, class... Items>
struct slots_of<presence_group<Unknown, Carrier, Items...>> : joined_slots<typename slots_of<Items>::type...> {};
template <class... Items> struct slots_of<layout<Items...>> : joined_slots<typename slots_of<Items>::type...> {};

} // namespace detail

/// The place of one member in a `raw`: its only member is `value`. Also for types like `raw` (see member_of).
template <auto Member, class Value> using raw_slot = detail::slot<Member, Value>;
template <class... Slots> using raw_slot_list = detail::slot_list<Slots...>;
/// The list of the places of all members of `T`.
template <class T> using raw_slots_of = typename detail::slots_of<layout_of<T>>::type;

/// The raw form of the message `T`, generated from its layout, under the same member pointers:
/// `r.get<&T::speed>()`, `r.set<&T::speed>(raw)`. Optional members are std::optional, nested messages are raw
/// themselves. Encodes and decodes like `T`, but any raw value is legal.
template <class T> class raw : raw_slots_of<T> {
    template <auto Member, class Value> static consteval Value raw::* find(const detail::slot<Member, Value>*) {
        return &detail::slot<Member, Value>::value;
    }

  public:
    using raw_of = T;

    /// The pointer to the slot of `Member`.
    template <auto Member> static constexpr auto place = raw::find<Member>(static_cast<raw*>(nullptr));

    template <auto Member> [[nodiscard]] constexpr const auto& get() const noexcept { return this->*place<Member>; }
    /// Sets a member's integer; no check against its limits.
    template <auto Member> constexpr void set(const auto& value) noexcept { this->*place<Member> = value; }
    /// The stored value itself, to be changed in place.
    template <auto Member> [[nodiscard]] constexpr auto& slot() noexcept { return this->*place<Member>; }
    /// Position of a member's integer.
    template <auto Member> [[nodiscard]] constexpr const auto& slot() const noexcept { return this->*place<Member>; }

    friend constexpr bool operator==(const raw&, const raw&) = default;
};

template <message T> struct schema<raw<T>> {
    using type = layout_of<T>;
};
template <message T> struct checked_schema<raw<T>> : schema<raw<T>> {};

} // namespace jauscat::wire
