// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"

jauscat::wire::raw<small_message> raw{};
