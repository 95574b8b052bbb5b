#include "kinds_of.hpp"

std::vector<message_kind> inform_kinds() { return kinds_of<0x4000, 0x5FFF>(jauscat::jaus::messages{}); }
