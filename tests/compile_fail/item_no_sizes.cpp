// expect: layout: an item has no min_size and max_size, the bytes it takes
#include "small_message.hpp"

using jauscat::wire::errc;
using jauscat::wire::u8;

struct own {
    std::uint8_t value{};
};

struct own_item {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr bool optional = false;
    static constexpr errc put(const auto& object, std::byte* out) { return u8::store(out, object.value); }
    static constexpr errc get(auto& object, const std::byte* in) { return u8::load(in, object.value); }
    static constexpr void visit(auto& object, auto&& visitor) { visitor(own_item{}, object.value); }
    template <auto, jauscat::wire::reading> static constexpr auto read(const std::byte* in, const auto&) {
        std::uint8_t value{};
        u8::load(in, value);
        return value;
    }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<own_item>;
};

static_assert(size_of_wrong<own> != 0);
