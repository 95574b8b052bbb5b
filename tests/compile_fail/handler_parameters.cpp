// expect: on: the handler of a message cannot be called with (const header&, const T&)
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{jaus::on<jaus::standby>([](const jaus::standby&) {})};
