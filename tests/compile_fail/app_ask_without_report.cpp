// expect: async_ask: no report answers this message; the schema of a query names its report
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& unit, const jaus::address& arm) {
    unit.async_ask(arm, jaus::set_wrench_effort{}, [](const auto&...) {});
}
