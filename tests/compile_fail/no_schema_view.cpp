// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"

const std::array<std::byte, 8> in{};
const jauscat::wire::view<small_message> view{in};
