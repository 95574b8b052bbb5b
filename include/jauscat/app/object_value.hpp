// Values of objects: their bytes on the wire, little-endian.
#pragma once
#include <jauscat/app/bus_error.hpp>
#include <jauscat/app/detail/operation.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

using object_bytes = std::vector<std::byte>;

template <class T>
concept object_scalar =
    (std::integral<T> || std::is_enum_v<T> || std::same_as<T, float> || std::same_as<T, double>) && sizeof(T) <= 8;
template <class T>
concept object_value = object_scalar<T> || std::same_as<T, std::string> || std::same_as<T, object_bytes>;

template <class T> consteval bool require_object_value() {
    constexpr bool is_value = object_value<T>;
    static_assert(is_value, "the value of an object is an integer, a bool, an enumeration, a float, a double,"
                            " a std::string or a std::vector<std::byte>");
    return is_value;
}

/// What is read: bytes of a value, none where they vary, and the name of its type.
struct object_type {
    std::optional<std::size_t> size{};
    std::string_view name{};
};

template <object_value T> [[nodiscard]] constexpr object_type object_type_of() noexcept {
    if constexpr (std::same_as<T, bool>)
        return {sizeof(T), "bool"};
    else if constexpr (std::same_as<T, float>)
        return {sizeof(T), "float"};
    else if constexpr (std::same_as<T, double>)
        return {sizeof(T), "double"};
    else if constexpr (std::is_enum_v<T>)
        return {sizeof(T), "the enumeration"};
    else if constexpr (std::signed_integral<T>)
        return {sizeof(T), std::array{"std::int8_t", "std::int16_t", "std::int32_t",
                                      "std::int64_t"}[std::bit_width(sizeof(T)) - 1]};
    else if constexpr (std::unsigned_integral<T>)
        return {sizeof(T), std::array{"std::uint8_t", "std::uint16_t", "std::uint32_t",
                                      "std::uint64_t"}[std::bit_width(sizeof(T)) - 1]};
    else
        return {};
}

template <object_scalar T> [[nodiscard]] std::uint64_t to_bits(T value) noexcept {
    if constexpr (std::is_enum_v<T>)
        return to_bits(static_cast<std::underlying_type_t<T>>(value));
    else if constexpr (std::same_as<T, float>)
        return std::bit_cast<std::uint32_t>(value);
    else if constexpr (std::same_as<T, double>)
        return std::bit_cast<std::uint64_t>(value);
    else
        return static_cast<std::uint64_t>(value);
}
template <object_scalar T> [[nodiscard]] T from_bits(std::uint64_t bits) noexcept {
    if constexpr (std::is_enum_v<T>)
        return static_cast<T>(from_bits<std::underlying_type_t<T>>(bits));
    else if constexpr (std::same_as<T, bool>)
        return bits != 0;
    else if constexpr (std::same_as<T, float>)
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    else if constexpr (std::same_as<T, double>)
        return std::bit_cast<double>(bits);
    else
        return static_cast<T>(bits);
}

template <class T> [[nodiscard]] object_bytes to_object(const T& value) {
    object_bytes octets;
    if constexpr (std::convertible_to<const T&, std::string_view>) {
        for (const char c : std::string_view{value}) octets.push_back(static_cast<std::byte>(c));
    } else if constexpr (std::convertible_to<const T&, std::span<const std::byte>>) {
        const std::span<const std::byte> all{value};
        octets.assign(all.begin(), all.end());
    } else if constexpr (require_object_value<T>()) {
        for (std::size_t i = 0; i != sizeof(T); ++i)
            octets.push_back(static_cast<std::byte>(to_bits(value) >> 8 * i & 0xFF));
    }
    return octets;
}

/// What a handler gets of the octets that were read: their number is right.
template <object_value T> struct object_conversion {
    std::tuple<error_code, T> operator()(error_code error, object_bytes octets) const {
        if constexpr (std::same_as<T, object_bytes>) {
            return {error, std::move(octets)};
        } else if constexpr (std::same_as<T, std::string>) {
            std::string text;
            for (const auto each : octets) text.push_back(static_cast<char>(each));
            text.erase(text.find_last_not_of('\0') + 1);
            return {error, std::move(text)};
        } else {
            std::uint64_t bits{};
            for (std::size_t i = 0; i != octets.size() && i != sizeof(T); ++i)
                bits |= std::to_integer<std::uint64_t>(octets[i]) << 8 * i;
            return {error, from_bits<T>(bits)};
        }
    }
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
