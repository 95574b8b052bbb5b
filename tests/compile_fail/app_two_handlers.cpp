// expect: on: two handlers of one message
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.on([](const jaus::set_wrench_effort&) {}, [](const jaus::set_travel_speed&) {},
              [](const jaus::set_wrench_effort&) {});
}
