#include "subgroups.hpp"
#include <jauscat/schema/jaus/world_model.hpp>

const jauscat::catalogue::list& jauscat::catalogue::world_model() { return of<jaus::world_model_subgroup>(); }
