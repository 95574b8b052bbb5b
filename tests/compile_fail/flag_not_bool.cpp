// expect: presence_flag: the member must be a bool
#include "small_message.hpp"

struct numeric_flag {
    std::uint8_t present{};
};

template <> struct jauscat::wire::schema<numeric_flag> {
    using type = layout<presence<u8, presence_flag<&numeric_flag::present>>>;
};

static_assert(size_of_wrong<numeric_flag> != 0);
