// expect: when_stopped
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.when_stopped([](int) {});
}
