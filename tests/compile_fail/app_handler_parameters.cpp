// expect: on: a handler takes (const T&) or (const T&, const jaus::header&)
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.on([](const jaus::set_wrench_effort&, int) {});
}
