// expect: reports: the function returns no report that a query asks for; the schema of a report names its query
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    driver.reports([] { return jaus::set_wrench_effort{}; });
}
