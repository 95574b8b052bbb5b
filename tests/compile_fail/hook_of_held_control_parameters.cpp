// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/component/held_control.hpp>

namespace jaus = jauscat::jaus;

constexpr auto changed = [](bool) {};
jaus::held_control control{{}, {}, {}, changed};
