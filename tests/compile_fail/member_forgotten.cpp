// expect: layout: a member of the message is missing from its layout
// and: level
#include "small_message.hpp"

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
