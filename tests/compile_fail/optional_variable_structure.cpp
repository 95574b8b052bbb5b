// expect: nested: an optional structure must have a fixed size
#include "small_message.hpp"

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);

struct outer {
    std::optional<small_message> inner{};
};

template <> struct jauscat::wire::schema<outer> { using type = layout<presence<u8, nested<&outer::inner>>>; };

static_assert(size_of_wrong<outer> != 0);
