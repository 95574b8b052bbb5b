// One field's value as text: numbers with their unit, enumerations by name, bytes in hex.
#pragma once
#include <jauscat/text/hex.hpp>
#include <jauscat/text/quoted.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace jauscat::text {

namespace detail {

template <class Enum, Enum... Values> consteval std::string_view enumerator_spellings() {
    return __PRETTY_FUNCTION__; // "... Values = {jaus::ack, (jaus)3, ...}" or "<...>"
}
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Names are looked for among the values below `Size`: a quarter of a millisecond of the compiler's time for each. All
// in one spelling, of which little more is read than the names: anything else took longer than the messages themselves.
// An underscore at the end, where the standard's word is a keyword, is omitted.
template <class Enum, std::size_t Size = 256>
inline constexpr auto enumerator_names = [] {
    constexpr std::string_view spelling = []<std::size_t... I>(std::index_sequence<I...>) {
        return enumerator_spellings<Enum, static_cast<Enum>(I)..., Enum{}>(); // a comma behind each of `Size`
    }(std::make_index_sequence<Size>{});
    std::array<std::string_view, Size> names{};
    std::size_t at = spelling.find("Values = ") + 10;
    std::size_t cast = 0; // size of "(jaus)", once one has been seen
    for (std::size_t i = 0; i != names.size(); ++i) {
        const std::size_t first = at;
        if (cast != 0 && spelling[at + cast - 1] == ')' && is_digit(spelling[at + cast]))
            at += cast + (i < 10 ? 1 : i < 100 ? 2 : 3);
        else
            while (spelling[at] != ',') ++at;
        std::size_t last = at; // where digits at the end begin, or the name behind the last colon
        while (is_digit(spelling[last - 1])) --last;
        if (last != at && spelling[last - 1] == ')') {
            cast = last - first;
        } else {
            while (last != first && spelling[last - 1] != ':') --last;
            names[i] = spelling.substr(last, at - last - (spelling[at - 1] == '_' ? 1 : 0));
        }
        at += 2; // over ", "
    }
    return names;
}();

/// A real number in `digits` digits, with a decimal point in every locale.
inline std::string real_text(double value, int digits = 8) {
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), end.ptr};
}
inline std::string named_text(std::string_view name, std::uint64_t number) {
    return name.empty() ? hex_number(number, 1) : std::string{name};
}
/// The names of the bits that are set in `number`; `names` by bit.
inline std::string set_bits(std::span<const std::string_view> names, unsigned bits, std::uint64_t number) {
    std::string text;
    for (unsigned bit = 0; bit != bits; ++bit) {
        if ((number >> bit & 1u) == 0) continue;
        if (!text.empty()) text += " | ";
        const std::string_view known = bit < names.size() ? names[bit] : std::string_view{};
        text += known.empty() ? "bit " + std::to_string(bit) : std::string{known};
    }
    return text.empty() ? "none" : text;
}
/// Marks a value that the standard does not define.
inline constexpr std::string_view outside_mark = " (outside its values)";
inline void append_member(std::string& text, std::string_view separator, std::string_view name,
                          std::string_view value) {
    (((text += separator) += name) += " = ") += value;
}

} // namespace detail

/// The enumerator's name, or empty where the value has none.
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::string_view enumerator_name(Enum value) {
    const auto number = static_cast<std::uint64_t>(value);
    return number < 256 ? detail::enumerator_names<Enum>[static_cast<std::size_t>(number)] : std::string_view{};
}

/// A value without its unit. Flags by the names of their set bits, text in quotes, bytes in hex. Messages: see
/// print.hpp.
template <class T>
requires(!wire::message<T>)
[[nodiscard]] std::string to_text(const T& value);

namespace detail {
/// A structure in one line.
template <wire::message T> std::string in_braces(const T& value) {
    std::string text = "{";
    wire::layout_of<T>::visit(value, [&]<class Item>(Item, const auto& member) {
        append_member(text, text.size() == 1 ? "" : ", ", Item::name(), to_text(member));
    });
    return text + "}";
}
} // namespace detail

template <class T>
requires(!wire::message<T>)
std::string to_text(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_enum_v<T>) {
        return detail::named_text(enumerator_name(value), static_cast<std::uint64_t>(value));
    } else if constexpr (std::floating_point<T>) {
        return detail::real_text(static_cast<double>(value));
    } else if constexpr (std::integral<T>) {
        return std::to_string(value);
    } else if constexpr (std::is_same_v<T, std::string_view>) {
        return quoted(value);
    } else if constexpr (requires { typename T::bit_type; }) {
        return detail::set_bits(detail::enumerator_names<typename T::bit_type>, sizeof(typename T::bits_type) * 8,
                                value.bits());
    } else if constexpr (std::is_same_v<T, wire::embedded_message>) {
        return value.is_to_encode() ? std::to_string(value.size()) + " bytes" : hex(value.bytes());
    } else if constexpr (std::is_same_v<T, std::monostate>) {
        return "none";
    } else if constexpr (wire::is_variant<T>) {
        return std::visit(
            []<class Held>(const Held& held) {
                if constexpr (wire::message<Held>)
                    return detail::in_braces(held);
                else
                    return to_text(held);
            },
            value);
    } else if constexpr (requires { std::tuple_size<T>::value; } &&
                         !std::is_same_v<typename T::value_type, std::byte>) {
        std::string text = "[";
        for (const auto& one : value) {
            if (text.size() != 1) text += ", ";
            if constexpr (wire::message<typename T::value_type>)
                text += detail::in_braces(one);
            else
                text += to_text(one);
        }
        return text + "]";
    } else {
        return hex(value);
    }
}

namespace detail {
/// Empty where a range has none.
template <class Range> consteval std::string_view unit_of_range() {
    if constexpr (requires { Range::unit; })
        return Range::unit;
    else
        return {};
}
} // namespace detail

} // namespace jauscat::text
