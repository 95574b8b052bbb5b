// expect: on_controler
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](const std::optional<jaus::controller>&, jaus::control_change) {};
const jaus::component_hooks hooks{.on_controler = function};
