// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](jaus::header&) { return jaus::message_outcome::handled; };
const jaus::component_hooks hooks{.on_state_command = function};
