#include "part.hpp"

jauscat::catalogue::list jauscat::catalogue::commands() { return part<0x0000, 0x1FFF>(jaus::messages{}); }
