// expect: array: the member must be a std::array
#include "small_message.hpp"

struct heights {
    jauscat::wire::inline_list<std::uint8_t, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, u8>>;
};

static_assert(size_of_wrong<heights> != 0);
