// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
#include "small_message.hpp"

struct around {
    std::array<small_message, 2> message{};
};

template <> struct jauscat::wire::schema<around> {
    using type = layout<array<&around::message>>;
};

static_assert(size_of_wrong<around> != 0);
