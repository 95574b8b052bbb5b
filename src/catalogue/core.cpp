#include "subgroups.hpp"
#include <jauscat/schema/jaus/core.hpp>

const jauscat::catalogue::list& jauscat::catalogue::core() { return of<jaus::core_subgroup>(); }
