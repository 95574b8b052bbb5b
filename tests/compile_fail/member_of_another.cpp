// expect: layout: a field names a member of another struct
#include "small_message.hpp"

struct stranger {
    std::uint16_t number{};
};

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>,
                        presence<u8, field<&T::extra, u8>>, field<&stranger::number, u16le>>;
};

static_assert(size_of_wrong<small_message> != 0);
