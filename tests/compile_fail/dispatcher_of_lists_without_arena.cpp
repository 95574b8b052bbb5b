// expect: dispatcher: a message has lists; give an arena as the third argument
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

jauscat::jaus::dispatcher handlers{jauscat::jaus::on<jauscat::jaus::report_services>([](const auto&, const auto&) {})};
const auto done = handlers(jauscat::jaus::header{}, {});
