// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](const jaus::header&) { return true; };
const jaus::component_hooks hooks{.on_state_command = function};
