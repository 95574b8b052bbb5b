// expect: layout: a message must be a plain aggregate
#include "small_message.hpp"

class closed {
  public:
    closed() {}
    std::uint8_t value{};
};

template <> struct jauscat::wire::schema<closed> {
    using type = layout<field<&closed::value, u8>>;
};

static_assert(size_of_wrong<closed> != 0);
