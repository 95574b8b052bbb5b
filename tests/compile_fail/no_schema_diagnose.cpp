// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"

const std::array<std::byte, 8> in{};
const auto why = jauscat::wire::diagnose<small_message>(in);
