// expect: on_sate
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](jaus::primary_status_code, jaus::primary_status_code) {};
const jaus::component_hooks hooks{.on_sate = function};
