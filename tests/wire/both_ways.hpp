// The codec takes other branches in the compiler than at run time; a check goes both ways.
#pragma once
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include <jauscat/wire/wire.hpp>

using support::bytes;
using support::equal;
namespace wire = jauscat::wire;

/// `check` is a lambda without captures; it must hold as a constant expression and as a call.
template <class Check> void both_ways(Check check) {
    STATIC_REQUIRE(Check{}());
    REQUIRE(check());
}

/// Room for a `T` that a test encodes.
template <wire::message T>
inline constexpr std::size_t room_for = wire::max_size<T> == wire::unbounded ? 400 : wire::max_size<T> + 1;

/// `value` encodes to exactly `expected`.
template <wire::message T> constexpr bool encodes_to(const T& value, std::span<const std::byte> expected) {
    std::array<std::byte, room_for<T>> out{};
    const auto written = wire::encode(value, out);
    return written && written->size() == expected.size() && wire::encoded_size(value) == expected.size() &&
           equal(*written, expected);
}

/// `in` decodes to exactly `expected`.
template <wire::message T> constexpr bool decodes_to(std::span<const std::byte> in, const T& expected) {
    T value{};
    const auto used = wire::decode(value, in);
    return used && *used == in.size() && value == expected;
}

template <wire::message T> constexpr wire::errc encode_error(const T& value) {
    std::array<std::byte, room_for<T>> out{};
    return wire::encode(value, out).error();
}

template <wire::message T> constexpr wire::errc decode_error(std::span<const std::byte> in) {
    T value{};
    return wire::decode(value, in).error();
}
