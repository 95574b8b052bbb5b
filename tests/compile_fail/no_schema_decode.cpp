// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
#include "small_message.hpp"

small_message message{};
const std::array<std::byte, 8> in{};
const auto used = jauscat::wire::decode(message, in);
