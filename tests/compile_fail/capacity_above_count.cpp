// expect: repeated: the list's capacity exceeds what its count can say
#include "small_message.hpp"

struct long_list {
    jauscat::wire::inline_list<std::uint8_t, 256> number{};
};

template <> struct jauscat::wire::schema<long_list> {
    using type = layout<repeated<&long_list::number, count<"numbers", u8>, element<"number", u8>>>;
};

static_assert(size_of_wrong<long_list> != 0);
