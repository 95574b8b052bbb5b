#include "subgroups.hpp"
#include <jauscat/schema/jaus/event.hpp>

const jauscat::catalogue::list& jauscat::catalogue::event() { return of<jaus::event_subgroup>(); }
