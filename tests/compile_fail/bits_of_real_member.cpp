// expect: bit_field: the member must be bool, an integer or an enumeration
#include "small_message.hpp"

struct with_fraction {
    float offset{};
};

template <> struct jauscat::wire::schema<with_fraction> {
    using type = layout<bit_fields<u8, bit_field<&with_fraction::offset, 8>>>;
};

static_assert(size_of_wrong<with_fraction> != 0);
