// expect: component: the application returns neither a message_outcome nor what a dispatcher does
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;

jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}};
void hear(jaus::message_sink out) {
    core.on_message({}, {}, {}, out, [](const jaus::header&, std::span<const std::byte>) { return true; });
}
