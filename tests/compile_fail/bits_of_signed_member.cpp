// expect: bit_field: the member must be bool, an unsigned integer or an enumeration
#include "small_message.hpp"

struct with_sign {
    std::int8_t offset{};
};

template <> struct jauscat::wire::schema<with_sign> {
    using type = layout<bit_fields<u8, bit_field<&with_sign::offset, 8>>>;
};

static_assert(size_of_wrong<with_sign> != 0);
