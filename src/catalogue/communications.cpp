#include "subgroups.hpp"
#include <jauscat/schema/jaus/communications.hpp>

const jauscat::catalogue::list& jauscat::catalogue::communications() { return of<jaus::communications_subgroup>(); }
