// expect: presence: no item is optional, so the vector has nothing to announce
#include "small_message.hpp"

struct without_options {
    std::uint8_t value{};
};

template <> struct jauscat::wire::schema<without_options> {
    using type = layout<presence<u8, field<&without_options::value, u8>>>;
};

static_assert(size_of_wrong<without_options> != 0);
