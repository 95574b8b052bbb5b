// expect: on_acknowledgement: the handler cannot be called with (const header&)
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{jaus::on_acknowledgement([](std::uint16_t) {})};
