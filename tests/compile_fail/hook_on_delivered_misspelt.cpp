// expect: on_deliverd
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](const jaus::awaited_message&, jaus::delivered) {};
const jaus::component_hooks hooks{.on_deliverd = function};
