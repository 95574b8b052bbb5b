// expect: bit_fields: the widths must fill the carrier exactly
#include "small_message.hpp"

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<bit_fields<u32le, bit_field<&T::number, 16>, reserved<15>>,
                        field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
