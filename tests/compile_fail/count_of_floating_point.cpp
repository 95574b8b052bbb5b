// expect: count: the carrier must be an unsigned integer
#include "small_message.hpp"

struct counted_by_float {
    jauscat::wire::list<std::uint8_t> number{};
};

template <> struct jauscat::wire::schema<counted_by_float> {
    using type = layout<repeated<&counted_by_float::number, count<"numbers", f32le>, element<"number", u8>>>;
};

static_assert(size_of_wrong<counted_by_float> != 0);
