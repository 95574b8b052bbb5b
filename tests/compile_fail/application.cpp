#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;

jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}};

#ifdef GOOD
// expect: no error
void hear(jaus::message_sink out) {
    core.on_message({}, {}, {}, out,
                    [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::refused; });
    jaus::dispatcher own{jaus::on_unknown([](const jaus::header&, auto) {})};
    static_assert(jaus::component_application<decltype(own)>);
    core.on_message({}, {}, {}, out, own);
}
#endif

#ifdef PARAMETERS
// expect: component: the application cannot be called with (const header&, std::span<const std::byte>)
void hear(jaus::message_sink out) {
    core.on_message({}, {}, {}, out, [](std::span<const std::byte>) { return jaus::message_outcome::handled; });
}
#endif

#ifdef RESULT
// expect: component: the application returns neither a message_outcome nor what a dispatcher does
void hear(jaus::message_sink out) {
    core.on_message({}, {}, {}, out, [](const jaus::header&, std::span<const std::byte>) { return true; });
}
#endif
