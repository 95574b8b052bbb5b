#include "subgroups.hpp"
#include <jauscat/schema/jaus/environment_sensor.hpp>

const jauscat::catalogue::list& jauscat::catalogue::environment_sensor() {
    return of<jaus::environment_sensor_subgroup>();
}
