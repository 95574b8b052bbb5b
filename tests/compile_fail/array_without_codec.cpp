// expect: array: the second argument is not a codec
#include "small_message.hpp"

struct heights {
    std::array<double, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, percent>>;
};

static_assert(size_of_wrong<heights> != 0);
