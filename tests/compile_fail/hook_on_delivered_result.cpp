// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](const jaus::awaited_message&, jaus::delivered) { return 0; };
const jaus::component_hooks hooks{.on_delivered = function};
