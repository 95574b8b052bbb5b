// A small message. Each schema in this folder lays it out with one mistake, good.cpp without.
#pragma once
#include <jauscat/wire/wire.hpp>

struct percent {
    static constexpr double min = 0, max = 100;
};

struct small_message {
    std::uint16_t number{};
    double level{};
    std::optional<std::uint8_t> extra{};
};

/// Forces the checks of the message's schema.
template <class T> constexpr std::size_t size_of_wrong = jauscat::wire::max_size<T>;
