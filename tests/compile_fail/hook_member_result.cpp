// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

struct driver {
    bool rest(jaus::primary_status_code, jaus::primary_status_code) { return true; }
    jaus::component_hooks hooks{.on_state = jaus::bound<&driver::rest>(*this)};
} one;
