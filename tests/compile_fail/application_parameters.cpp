// expect: component: the application cannot be called with (const header&, std::span<const std::byte>)
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;

jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}};
void hear(jaus::message_sink out) {
    core.on_message({}, {}, {}, out, [](std::span<const std::byte>) { return jaus::message_outcome::handled; });
}
