#include "subgroups.hpp"
#include <jauscat/schema/jaus/manipulator.hpp>

const jauscat::catalogue::list& jauscat::catalogue::manipulator() { return of<jaus::manipulator_subgroup>(); }
