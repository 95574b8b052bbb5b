// expect: no error
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

void use(jauscat::component& driver) {
    jaus::report_wrench_effort effort{};
    driver.on([&](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); },
              [](const jaus::set_travel_speed&, const jaus::header&) { return jaus::message_outcome::refused; },
              [](const jaus::query_travel_speed&) { return jaus::report_travel_speed{}; });
    driver.reports([&] { return effort; });
    driver.when_stopped([&] { effort = {}; });
}
