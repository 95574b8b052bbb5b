// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/routing/node_description.hpp>

namespace jaus = jauscat::jaus;

constexpr auto note = [](const jaus::header&) {};
const jaus::node_manager_options options{.appeared = note};
