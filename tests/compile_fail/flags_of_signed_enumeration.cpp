// expect: bit_set: the enumeration's underlying type must be unsigned
#include "small_message.hpp"

enum class direction : std::int8_t { left };

jauscat::wire::bit_set<direction> set{};
