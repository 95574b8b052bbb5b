// expect: scaled: the range is empty (min must be below max)
#include "small_message.hpp"

struct upside_down {
    static constexpr double min = 100, max = 0;
};

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, upside_down>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
