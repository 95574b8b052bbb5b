#include "subgroups.hpp"
#include <jauscat/schema/jaus/platform.hpp>

const jauscat::catalogue::list& jauscat::catalogue::platform() { return of<jaus::platform_subgroup>(); }
