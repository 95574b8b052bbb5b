// expect: layout: the extent(const std::byte*, scope) of a variable item does not return std::size_t
#include "small_message.hpp"

using jauscat::wire::in_cursor;
using jauscat::wire::out_cursor;

struct own {
    std::uint8_t value{};
};

struct own_item {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr std::size_t min_size = 0, max_size = 1;
    static constexpr bool optional = false;
    static constexpr std::size_t size(const auto&, const auto&) { return 0; }
    static constexpr out_cursor put(const auto&, out_cursor c, const auto&) { return c; }
    static constexpr in_cursor get(auto&, in_cursor c, const auto&) { return c; }
    static constexpr in_cursor measure(in_cursor c, const auto&) { return c; }
    static constexpr int extent(const std::byte*, const auto&) { return 0; }
    static constexpr void visit(auto& object, auto&& visitor) { visitor(own_item{}, object.value); }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<own_item>;
};

static_assert(size_of_wrong<own> != 0);
