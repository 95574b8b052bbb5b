// expect: on_state_comand
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](const jaus::header&) { return jaus::message_outcome::handled; };
const jaus::component_hooks hooks{.on_state_comand = function};
