#include "kinds_of.hpp"

std::vector<message_kind> query_kinds() { return kinds_of<0x2000, 0x3FFF>(jauscat::jaus::messages{}); }
