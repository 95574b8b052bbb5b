#include "subgroups.hpp"
#include <jauscat/schema/jaus/planning.hpp>

const jauscat::catalogue::list& jauscat::catalogue::planning() { return of<jaus::planning_subgroup>(); }
