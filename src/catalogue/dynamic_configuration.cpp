#include "subgroups.hpp"
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

const jauscat::catalogue::list& jauscat::catalogue::dynamic_configuration() {
    return of<jaus::dynamic_configuration_subgroup>();
}
