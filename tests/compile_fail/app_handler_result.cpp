// expect: on: a handler returns nothing, a message as the answer, or a message_outcome
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.on([](const jaus::set_wrench_effort&) { return 1; });
}
