// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"

small_message message{};
const std::array<std::byte, 8> in{};
const auto used = jauscat::wire::decode(message, in);
