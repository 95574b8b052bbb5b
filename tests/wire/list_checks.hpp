// What holds for every message that has lists, and cannot be asked in a constant expression: an arena hands out memory.
#pragma once
#include "both_ways.hpp"
#include "list_samples.hpp"

using wire::errc;

/// 4 KiB for the lists of one decode.
struct lent_memory {
    alignas(8) std::array<std::byte, 4096> bytes{};
    wire::arena arena{bytes};
};

/// `value` encodes to `expected`, which decodes to it again; the raw message and a view find the same bytes whole.
template <wire::message T> void require_coding(const T& value, std::span<const std::byte> expected) {
    REQUIRE(encodes_to(value, expected));
    lent_memory memory;
    T found{};
    REQUIRE(*wire::decode(found, expected, memory.arena) == expected.size());
    REQUIRE(found == value);
    wire::raw<T> raw{};
    REQUIRE(*wire::decode(raw, expected, memory.arena) == expected.size());
    REQUIRE(encodes_to(raw, expected));
    REQUIRE(wire::view<T>{expected});
    REQUIRE(wire::diagnose<T>(expected));
    REQUIRE(wire::diagnose(value));
}

/// What decode, a view and diagnose say alike.
template <wire::message T> errc decode_error_in_arena(std::span<const std::byte> in) {
    lent_memory memory;
    T found{};
    const auto error = wire::decode(found, in, memory.arena).error();
    REQUIRE(wire::view<T>{in}.error() == error);
    REQUIRE(wire::diagnose<T>(in).error == error);
    return error;
}

/// Nothing shorter than `whole` is complete, and one byte more is too much.
template <wire::message T> void require_exact_length(std::span<const std::byte> whole) {
    for (std::size_t size = 0; size != whole.size(); ++size) {
        CAPTURE(size);
        REQUIRE(decode_error_in_arena<T>(whole.first(size)) == errc::truncated);
        REQUIRE(!wire::diagnose<T>(whole.first(size)).field.empty());
    }
    std::vector<std::byte> longer(whole.begin(), whole.end());
    longer.push_back({});
    REQUIRE(decode_error_in_arena<T>(longer) == errc::trailing_bytes);
}

/// "shape[1].corner[0].x at 9 needs 2, has 1"
inline std::string told(const wire::diagnosis& why) {
    std::string text;
    for (std::size_t i = 0; i != why.depth; ++i) {
        text += why.path[i].name;
        if (why.path[i].element != wire::diagnosis_step::no_element)
            text += "[" + std::to_string(why.path[i].element) + "]";
        text += ".";
    }
    return text + std::string{why.field} + " at " + std::to_string(why.offset) + " needs " +
           std::to_string(why.needed) + ", has " + std::to_string(why.available);
}
