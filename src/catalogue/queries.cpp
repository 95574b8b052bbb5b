#include "part.hpp"

jauscat::catalogue::list jauscat::catalogue::queries() { return part<0x2000, 0x3FFF>(jaus::messages{}); }
