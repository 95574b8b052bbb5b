// expect: reports: the function takes nothing, or the query of its report
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.reports([](const jaus::query_travel_speed&) { return jaus::report_wrench_effort{}; });
}
