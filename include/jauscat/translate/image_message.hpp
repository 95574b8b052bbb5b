// A message during its translation to a process image: integers as on the wire, and an absent element still has a
// value, the last one. So no decision is needed for each value, which made a translation twice as fast.
#pragma once
#include <jauscat/wire/raw.hpp>
#include <jauscat/wire/visit.hpp>

#include <cstdint>
#include <span>

namespace jauscat::translate {

/// An optional element that keeps its value while it is absent. Implements for the codec what std::optional has.
template <class T> class lasting {
  public:
    using value_type = T;

    /// The value while the element is absent.
    constexpr void keep(T value) noexcept { value_ = value; }
    /// The element's value, or the last one.
    [[nodiscard]] constexpr T last() const noexcept { return value_; }

    constexpr lasting& operator=(T value) noexcept {
        value_ = value;
        present_ = true;
        return *this;
    }
    constexpr void reset() noexcept { present_ = false; }
    [[nodiscard]] constexpr bool has_value() const noexcept { return present_; }
    [[nodiscard]] constexpr explicit operator bool() const noexcept { return present_; }
    [[nodiscard]] constexpr const T& operator*() const noexcept { return value_; }

  private:
    T value_{};
    bool present_{};
};

namespace detail {

template <class Value> struct lasting_if_optional {
    using type = Value;
};
template <class T> struct lasting_if_optional<std::optional<T>> {
    using type = lasting<T>;
};

template <class Slots> struct lasting_slots;
template <auto... Members, class... Values>
struct lasting_slots<wire::raw_slot_list<wire::raw_slot<Members, Values>...>> {
    using type = wire::raw_slot_list<wire::raw_slot<Members, typename lasting_if_optional<Values>::type>...>;
};
template <class T> using image_slots = typename lasting_slots<wire::raw_slots_of<T>>::type;

// The presence bits of a message that was decoded from `body`: where it is all one presence vector and what that
// announces, its own.
template <class Layout> struct presence_in {
    [[gnu::always_inline]] static constexpr std::uint64_t of(const auto& message, std::span<const std::byte>) noexcept {
        std::uint64_t bits = 0;
        unsigned at = 0;
        wire::visit(message, [&]<class Item>(Item, const auto& member) {
            if constexpr (Item::optional) bits |= std::uint64_t{member.has_value()} << at++;
        });
        return bits;
    }
};
template <wire::unknown_bits Unknown, class Carrier, class... Items>
requires(Items::optional && ...)
struct presence_in<wire::layout<wire::presence_group<Unknown, Carrier, Items...>>> {
    [[gnu::always_inline]] static constexpr std::uint64_t of(const auto&, std::span<const std::byte> body) noexcept {
        typename Carrier::value_type bits{};
        Carrier::load(body.data(), bits);
        return bits & wire::presence_group<Unknown, Carrier, Items...>::known_bits;
    }
};

} // namespace detail

/// The message `T` like wire::raw<T>, with `lasting` elements for optional ones.
template <class T> class image_message : detail::image_slots<T> {
    template <auto Member, class Value>
    static consteval Value image_message::* find(const wire::raw_slot<Member, Value>*) {
        return &wire::raw_slot<Member, Value>::value;
    }

  public:
    using raw_of = T;
    /// The pointer to the slot of `Member`.
    template <auto Member>
    static constexpr auto place = image_message::find<Member>(static_cast<image_message*>(nullptr));

    /// One bit for each optional element that is there, in their order, from the least significant up.
    std::uint64_t presence{};
};

} // namespace jauscat::translate

template <jauscat::wire::message T> struct jauscat::wire::schema<jauscat::translate::image_message<T>> {
    using type = layout_of<T>;
};
template <jauscat::wire::message T>
struct jauscat::wire::checked_schema<jauscat::translate::image_message<T>>
    : schema<jauscat::translate::image_message<T>> {};
