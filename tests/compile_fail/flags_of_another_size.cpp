// expect: bit_set_codec: the enumeration's underlying type must be the carrier's integer type
#include "small_message.hpp"

enum class lamp : std::uint8_t { left };
struct lamps {
    jauscat::wire::bit_set<lamp> lit{};
};

template <> struct jauscat::wire::schema<lamps> {
    using type = layout<field<&lamps::lit, bit_set_codec<lamp, u16le>>>;
};

static_assert(size_of_wrong<lamps> != 0);
