#include "subgroups.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>

// By the CMake variable of the same name: those of the subgroups that a program needs.
#ifndef JAUSCAT_CATALOGUE_SUBGROUPS
#    define JAUSCAT_CATALOGUE_SUBGROUPS                                                                                \
        core(), event(), communications(), platform(), manipulator(), environment_sensor(), world_model(),             \
            dynamic_configuration(), payload(), planning()
#endif

const jauscat::catalogue::list& jauscat::catalogue::ra_3_3() {
    static const list all{JAUSCAT_CATALOGUE_SUBGROUPS};
    return all;
}
