#include "kinds_of.hpp"

std::vector<message_kind> command_kinds() { return kinds_of<0x0000, 0x1FFF>(jauscat::jaus::messages{}); }
