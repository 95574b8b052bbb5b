// expect: arena: its elements are never destroyed
#include "small_message.hpp"

#include <string>

auto make(jauscat::wire::arena& memory) { return memory.allocate<std::string>(1); }
