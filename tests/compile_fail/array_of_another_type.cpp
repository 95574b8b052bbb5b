// expect: array: the elements are not of the type that their codec carries
#include "small_message.hpp"

struct heights {
    std::array<double, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, u16le>>;
};

static_assert(size_of_wrong<heights> != 0);
