// expect: on: the handler of a message returns something, which would be ignored
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{jaus::on<jaus::standby>([](const auto&, const auto&) { return jaus::message_outcome::refused; })};
