// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"

std::array<std::byte, 8> out{};
const auto written = jauscat::wire::encode(small_message{}, out);
