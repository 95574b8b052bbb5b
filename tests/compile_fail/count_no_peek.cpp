// expect: count: it has no peek(const std::byte*, scope) that returns std::size_t
#include "small_message.hpp"

struct own {
    jauscat::wire::list<std::uint8_t> value{};
};

struct pairs {
    static constexpr std::size_t prefix_size = 0;
    static constexpr bool contextual = false;
    static constexpr auto put(std::size_t, jauscat::wire::out_cursor c, const auto&) { return c; }
    static constexpr bool get(std::size_t& elements, jauscat::wire::in_cursor&, const auto&) {
        elements = 2;
        return true;
    }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<repeated<&own::value, pairs, element<"value", u8>>>;
};

static_assert(size_of_wrong<own> != 0);
