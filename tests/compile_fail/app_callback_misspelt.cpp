// expect: when_stoped
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.when_stoped([] {});
}
