// The rows that a translation table is made of. Each says what happens to one field, in both directions. row.hpp lists
// what a row needs.
#pragma once
#include <jauscat/translate/errc.hpp>
#include <jauscat/translate/row.hpp>
#include <jauscat/wire/code_index.hpp>

#include <limits>

namespace jauscat::translate {

namespace detail {

template <class T> [[gnu::always_inline]] constexpr std::uint32_t to_word(T value) noexcept {
    return static_cast<std::uint32_t>(value);
}
/// A packet's word into a narrower field; refused where it would come back as another word.
template <class T> [[gnu::always_inline]] constexpr errc from_word(std::uint32_t word, T& value) noexcept {
    value = static_cast<T>(word);
    return to_word(value) == word ? errc::ok : errc::out_of_range;
}

template <class T> consteval auto integer_of() noexcept {
    if constexpr (std::is_enum_v<T>)
        return std::underlying_type_t<T>{};
    else
        return T{};
}
/// Whether every value of a `From` comes back from a `To` through a word.
template <class From, class To> consteval bool keeps_values() noexcept {
    using from = decltype(integer_of<From>());
    using to = decltype(integer_of<To>());
    constexpr bool whole = std::is_integral_v<from> && std::is_integral_v<to>;
    constexpr bool same_sign = std::is_signed_v<from> == std::is_signed_v<to>;
    constexpr std::size_t word = sizeof(std::uint32_t);
    return whole && sizeof(from) <= sizeof(to) && sizeof(to) <= word && (same_sign || sizeof(to) == word);
}

} // namespace detail

/// The same value on both sides.
template <class From, class To> struct copy {
    using uses = path_list<From>;
    using writes = path_list<To>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, auto& packet, sizes) noexcept {
        static_assert(detail::keeps_values<std::remove_cvref_t<decltype(From::of(header))>, typename To::type>(),
                      "copy: not every value of the message's field comes back from the packet's field");
        To::of(packet) = static_cast<typename To::type>(From::of(header));
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, auto& header, sizes) noexcept {
        return detail::from_word(detail::to_word(To::of(packet)), From::of(header));
    }
};

/// The packet's value is `Base` plus the JAUS value: a component's object index.
template <class From, class To, std::uint32_t Base> struct offset {
    using uses = path_list<From>;
    using writes = path_list<To>;
    using from = From;
    using to = To;
    static constexpr bool gives_index = true;
    static constexpr std::uint32_t largest = Base + std::numeric_limits<typename From::type>::max();
    static_assert(largest <= 0xFFFF, "offset: base plus the largest value does not fit an object index of 16 bits");

    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, auto& packet, sizes) noexcept {
        static_assert(largest <= std::numeric_limits<typename To::type>::max(),
                      "offset: base plus the largest value does not fit the packet's field");
        To::of(packet) = static_cast<typename To::type>(Base + detail::to_word(From::of(header)));
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, auto& header, sizes) noexcept {
        const std::uint32_t index = To::of(packet);
        if (index < Base || index > largest) return errc::unknown_index;
        return detail::from_word(index - Base, From::of(header));
    }
};

/// The packet's value is the code's place in the list `Codes`, counted from 1.
template <class From, class To, const auto& Codes> struct code_rank {
    using uses = path_list<From>;
    using writes = path_list<To>;
    using from = From;
    using to = To;
    static constexpr bool gives_subindex = true;
    static_assert(Codes.size() <= 254,
                  "code_rank: more than 254 command codes do not fit a subindex (255 is reserved)");

    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, auto& packet, sizes) noexcept {
        const std::size_t place = wire::code_index<Codes>::find(From::of(header));
        if (place == wire::code_index<Codes>::npos) return errc::unknown_command_code;
        To::of(packet) = static_cast<typename To::type>(place + 1);
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, auto& header, sizes) noexcept {
        const std::uint32_t subindex = To::of(packet);
        if (subindex == 0 || subindex > Codes.size()) return errc::unknown_subindex;
        From::of(header) = Codes[subindex - 1];
        return errc::ok;
    }
};

/// A pair of equivalent values.
template <auto JausValue, std::uint32_t PacketValue> struct value_pair {
    static constexpr auto jaus_value = JausValue;
    static constexpr std::uint32_t packet_value = PacketValue;
};

/// Maps values by pairs; all others are reserved and refused.
template <class From, class To, class... Pairs> struct map_values {
    using uses = path_list<From>;
    using writes = path_list<To>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, auto& packet, sizes) noexcept {
        const bool known = (... || (From::of(header) == Pairs::jaus_value &&
                                    (To::of(packet) = static_cast<typename To::type>(Pairs::packet_value), true)));
        return known ? errc::ok : errc::reserved_value;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, auto& header, sizes) noexcept {
        const bool known = (... || (detail::to_word(To::of(packet)) == Pairs::packet_value &&
                                    (From::of(header) = Pairs::jaus_value, true)));
        return known ? errc::ok : errc::reserved_value;
    }
};

/// A packet field that always has this value.
template <class To, auto Value> struct constant {
    using uses = path_list<>;
    using writes = path_list<To>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, auto& packet, sizes) noexcept {
        To::of(packet) = static_cast<typename To::type>(Value);
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, const auto&, sizes) noexcept {
        return To::of(packet) == static_cast<typename To::type>(Value) ? errc::ok : errc::wrong_packet;
    }
};

/// A JAUS field that always has this value, and is not carried.
template <class From, auto Value> struct message_constant {
    using uses = path_list<From>;
    using writes = path_list<>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, const auto&, sizes) noexcept {
        return From::of(header) == static_cast<typename From::type>(Value) ? errc::ok : errc::reserved_value;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, auto& header, sizes) noexcept {
        From::of(header) = static_cast<typename From::type>(Value);
        return errc::ok;
    }
};

/// A JAUS field that always has this value, left in `rest` and checked there; `Refusal` is the error for another one.
template <class From, auto Value, errc Refusal = errc::reserved_value> struct constant_in_rest {
    using uses = path_list<>;
    using writes = path_list<>;
    using checks_in_rest = From;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, const auto&, sizes) noexcept {
        return From::of(header) == static_cast<typename From::type>(Value) ? errc::ok : Refusal;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
};

/// A body has at least `Least` bytes.
template <std::size_t Least> struct least_body {
    using uses = path_list<>;
    using writes = path_list<>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, const auto&, sizes s) noexcept {
        return s.body >= Least ? errc::ok : errc::truncated;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes s) noexcept {
        return s.body >= Least ? errc::ok : errc::truncated;
    }
};

/// A packet field that the caller sets, such as a packet number.
template <class To> struct caller_set {
    using uses = path_list<>;
    using writes = path_list<To>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
};

/// The JAUS field that states the size of the body and of `Header` bytes in front of it: not carried, because the
/// packet's data count determines it.
template <class From, std::size_t Header = 0> struct body_size {
    using uses = path_list<From>;
    using writes = path_list<>;
    using states_body_size = From;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, const auto&, sizes s) noexcept {
        return From::of(header) == Header + s.body ? errc::ok : errc::wrong_size;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, auto& header, sizes s) noexcept {
        return detail::from_word(static_cast<std::uint32_t>(Header + s.body), From::of(header));
    }
};

/// The JAUS field that states the body's size, left in `rest` and checked there.
template <class From> struct body_size_in_rest : body_size<From> {
    using uses = path_list<>;
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
};

/// The packet field that counts the bytes of data.
template <class To> struct data_count {
    using uses = path_list<>;
    using writes = path_list<To>;
    using counts_data = To;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, auto& packet, sizes s) noexcept {
        To::of(packet) = static_cast<typename To::type>(s.data);
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
};

/// The packet field that states the length: `Fixed` bytes and the data. A packet may be longer than its data count,
/// because some senders pad the data field; the count decides.
template <class To, std::size_t Fixed> struct packet_length {
    using uses = path_list<>;
    using writes = path_list<To>;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, auto& packet, sizes s) noexcept {
        To::of(packet) = static_cast<typename To::type>(Fixed + s.data);
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, const auto&, sizes s) noexcept {
        return To::of(packet) >= Fixed + s.data ? errc::ok : errc::wrong_size;
    }
};

/// Every JAUS header field that no row uses, then the whole body, in wire order: the packet's data.
struct rest {
    using uses = path_list<>;
    using writes = path_list<>;
    static constexpr bool carries_rest = true;
    [[gnu::always_inline]] static constexpr errc to_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto&, const auto&, sizes) noexcept {
        return errc::ok;
    }
};

} // namespace jauscat::translate
