// The rows that only a table into a process image needs: a process image has a fixed size and is sent again and again,
// while elements of a message may be absent and a message comes once.
#pragma once
#include <jauscat/translate/image_message.hpp>
#include <jauscat/translate/rows.hpp>
#include <jauscat/wire/visit.hpp>

namespace jauscat::translate {

/// An optional element of the message, as the integer on the wire. If absent, the image's value does not change: the
/// last one commanded. In reverse it is present, unless its bit in `presence_bits` is clear.
template <class From, class To> struct element {
    using uses = path_list<From>;
    using writes = path_list<To>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto& message, auto& image, sizes) noexcept {
        check<std::remove_cvref_t<decltype(From::of(message))>>();
        To::of(image) = From::of(message).last();
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& image, auto& message, sizes) noexcept {
        check<std::remove_cvref_t<decltype(From::of(message))>>();
        From::of(message) = To::of(image);
        return errc::ok;
    }
    /// Sets the value of the element while it is absent.
    [[gnu::always_inline]] static constexpr void keep(const auto& image, auto& message) noexcept {
        check<std::remove_cvref_t<decltype(From::of(message))>>();
        From::of(message).keep(To::of(image));
    }

  private:
    template <class Element> static consteval void check() noexcept {
        static_assert(std::is_same_v<Element, lasting<typename To::type>>,
                      "element: the image's field has not the type that the optional element has on the wire");
    }
};

/// The image's field with one bit for each optional element of the message, in their order, from the least significant
/// up: set where the message has the element. Like the presence vector of a message with one.
template <class To> struct presence_bits {
    using uses = path_list<>;
    using writes = path_list<To>;
    using says_presence = To;
    static_assert(std::is_unsigned_v<typename To::type>, "presence_bits: the image's field must be unsigned");

    [[gnu::always_inline]] static constexpr errc to_packet(const auto& message, auto& image, sizes) noexcept {
        check<std::remove_cvref_t<decltype(message)>>();
        To::of(image) = static_cast<typename To::type>(message.presence);
        return errc::ok;
    }
    /// Runs after the rows that set the elements. Error: reserved_value, a bit without an element.
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& image, auto& message, sizes) noexcept {
        using type = std::remove_cvref_t<decltype(message)>;
        check<type>();
        std::uint64_t bits = To::of(image);
        wire::visit(message, [&]<class Item>(Item, auto& member) {
            if constexpr (Item::optional) {
                if ((bits & 1) == 0) member.reset();
                bits >>= 1;
            }
        });
        return bits == 0 ? errc::ok : errc::reserved_value;
    }

  private:
    template <class Message> static consteval void check() noexcept {
        constexpr auto optional = []<auto... Members>(wire::key_list<Members...>) {
            return (std::size_t{wire::is_optional_member<Members>} + ... + 0);
        };
        static_assert(optional(typename wire::layout_of<Message>::keys{}) <= sizeof(typename To::type) * 8,
                      "presence_bits: the message has more optional elements than the image's field has bits");
    }
};

/// The image's field that each message increments, so that the receiver distinguishes a new command from the last one
/// sent again. 0 means "none yet" and is skipped when the counter wraps.
template <class To> struct counter {
    using uses = path_list<>;
    using writes = path_list<To>;
    using counts_messages = To;
    static_assert(std::is_unsigned_v<typename To::type>, "counter: the image's field must be unsigned");

    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, auto& image, sizes) noexcept {
        auto& count = To::of(image);
        count = static_cast<typename To::type>(count + 1u);
        if (count == 0) count = 1;
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
};

} // namespace jauscat::translate
