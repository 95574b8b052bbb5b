// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

struct driver {
    void rest(jaus::primary_status_code) {}
    jaus::component_hooks hooks{.on_state = jaus::bound<&driver::rest>(*this)};
} one;
