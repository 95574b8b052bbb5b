// expect: no error
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;

jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}};
void hear(jaus::message_sink out) {
    core.on_message({}, {}, {}, out,
                    [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::refused; });
    jaus::dispatcher own{jaus::on_unknown([](const jaus::header&, auto) {})};
    static_assert(jaus::component_application<decltype(own)>);
    core.on_message({}, {}, {}, out, own);
}
