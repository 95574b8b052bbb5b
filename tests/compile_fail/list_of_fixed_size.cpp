// expect: repeated: a std::array has no count (use array)
#include "small_message.hpp"

struct heights {
    std::array<std::uint8_t, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<repeated<&heights::height, count<"heights", u8>, element<"height", u8>>>;
};

static_assert(size_of_wrong<heights> != 0);
