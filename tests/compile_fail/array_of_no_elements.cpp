// expect: array: the member has no elements
#include "small_message.hpp"

struct heights {
    std::array<std::uint8_t, 0> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, u8>>;
};

static_assert(size_of_wrong<heights> != 0);
