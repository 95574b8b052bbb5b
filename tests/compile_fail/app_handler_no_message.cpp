// expect: on: the parameter of a handler is no message with a command code; is the header of its schema included?
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.on([](int) {});
}
