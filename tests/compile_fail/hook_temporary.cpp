// expect: hook: the function must outlive the component: give it a name
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

const jaus::component_hooks hooks{.on_state = [](auto, auto) {}};
