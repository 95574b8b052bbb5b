// expect: layout: an item that takes the rest of the body must be the last one
#include "small_message.hpp"

struct early_rest {
    jauscat::wire::blob bytes{};
    std::uint8_t number{};
};

template <> struct jauscat::wire::schema<early_rest> {
    using T = early_rest;
    using type = layout<bytes<&T::bytes, rest>, field<&T::number, u8>>;
};

static_assert(size_of_wrong<early_rest> != 0);
