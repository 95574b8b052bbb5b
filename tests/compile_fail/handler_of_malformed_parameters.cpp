// expect: on_malformed: the handler cannot be called with (const header&, std::span<const std::byte>, wire::errc)
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{jaus::on_malformed([](const jaus::header&, std::span<const std::byte>) {})};
