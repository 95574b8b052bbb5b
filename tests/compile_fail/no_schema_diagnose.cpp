// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
#include "small_message.hpp"

const std::array<std::byte, 8> in{};
const auto why = jauscat::wire::diagnose<small_message>(in);
