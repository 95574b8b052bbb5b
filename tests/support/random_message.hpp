// Random messages of any schema, for property tests and benchmarks.
#pragma once
#include <jauscat/wire/visit.hpp>
#include <jauscat/wire/wire.hpp>

#include <limits>
#include <random>
#include <span>

namespace support {

namespace wire = jauscat::wire;

/// Seeded by each test with a number of its own, so that a failure repeats.
using generator = std::mt19937_64;

inline bool chance(generator& g, double probability) { return std::bernoulli_distribution{probability}(g); }

/// 0 to `limit` - 1.
inline std::size_t below(generator& g, std::size_t limit) { return static_cast<std::size_t>(g() % limit); }

inline void fill(generator& g, std::span<std::byte> out) {
    for (auto& byte : out) byte = static_cast<std::byte>(g());
}

/// What a random message is made of.
struct odds {
    double present = 0.5; ///< probability that an optional field is there
    double illegal = 0;   ///< probability that a value that can be illegal is
};

namespace detail {

template <class Range> double real(generator& g, double illegal) {
    using limits = std::numeric_limits<double>;
    if (chance(g, illegal)) {
        const std::array wrong{limits::quiet_NaN(), limits::infinity(), -limits::infinity(), Range::min - 1.0,
                               Range::max + 1.0};
        return wrong[below(g, wrong.size())];
    }
    const auto which = g() % 16;
    if (which == 0) return Range::min;
    if (which == 1) return Range::max;
    return std::uniform_real_distribution<double>{Range::min, Range::max}(g);
}

template <wire::message T> void randomise(T& message, generator& g, const odds& o);

template <class Item, class Value> void randomise_member(Value& value, generator& g, const odds& o) {
    if constexpr (requires { Item::width; }) {
        constexpr auto mask = Item::width >= 64 ? ~std::uint64_t{} : (std::uint64_t{1} << (Item::width & 63)) - 1;
        value = static_cast<Value>(chance(g, o.illegal) ? ~std::uint64_t{} : g() & mask);
    } else if constexpr (wire::message<Value>) {
        randomise(value, g, o);
    } else if constexpr (requires { typename Item::codec_type::range_type; } && std::floating_point<Value>) {
        value = static_cast<Value>(real<typename Item::codec_type::range_type>(g, o.illegal));
    } else if constexpr (std::floating_point<Value>) {
        value = static_cast<Value>(std::normal_distribution<double>{0, 1e6}(g));
    } else if constexpr (std::integral<Value> || std::is_enum_v<Value>) {
        value = static_cast<Value>(g());
    } else if constexpr (requires { typename Value::bits_type; }) {
        value = Value::from_bits(static_cast<typename Value::bits_type>(g()));
    } else {
        fill(g, value);
    }
}

template <wire::message T> void randomise(T& message, generator& g, const odds& o) {
    wire::visit(message, [&]<class Item>(Item, auto& member) {
        if constexpr (requires { member.emplace(); }) {
            if (chance(g, o.present))
                randomise_member<Item>(member.emplace(), g, o);
            else
                member.reset();
        } else {
            randomise_member<Item>(member, g, o);
        }
    });
}

} // namespace detail

/// A random `T`; unless `o` allows illegal values, one that encodes.
template <wire::message T> T random_message(generator& g, const odds& o = {}) {
    T message{};
    detail::randomise(message, g, o);
    return message;
}

} // namespace support
