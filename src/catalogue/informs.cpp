#include "part.hpp"

jauscat::catalogue::list jauscat::catalogue::informs() { return part<0x4000, 0x5FFF>(jaus::messages{}); }
