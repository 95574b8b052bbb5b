// expect: flag_bits: the enumeration's underlying type must be the carrier's integer type
#include "small_message.hpp"

enum class lamp : std::uint8_t { left };
struct lamps {
    jauscat::wire::flags<lamp> lit{};
};

template <> struct jauscat::wire::schema<lamps> { using type = layout<field<&lamps::lit, flag_bits<lamp, u16le>>>; };

static_assert(size_of_wrong<lamps> != 0);
