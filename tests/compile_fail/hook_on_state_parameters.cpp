// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](jaus::primary_status_code) {};
const jaus::component_hooks hooks{.on_state = function};
