// expect: on_unknown: the handler cannot be called with (const header&, std::span<const std::byte>)
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{jaus::on_unknown([](const jaus::header&) {})};
