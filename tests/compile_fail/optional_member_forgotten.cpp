// expect: layout: a member of the message is missing from its layout
// and: extra
#include "small_message.hpp"

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>>;
};

static_assert(size_of_wrong<small_message> != 0);
