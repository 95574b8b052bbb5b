// expect: on: a handler names its message: [](const jaus::set_wrench_effort& effort) { ... }
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.on([](const auto&) {});
}
