// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
#include "small_message.hpp"

std::array<std::byte, 8> out{};
const auto written = jauscat::wire::encode(small_message{}, out);
