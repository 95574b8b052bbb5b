#include "subgroups.hpp"
#include <jauscat/schema/jaus/payload.hpp>

const jauscat::catalogue::list& jauscat::catalogue::payload() { return of<jaus::payload_subgroup>(); }
