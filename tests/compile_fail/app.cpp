#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

#ifdef GOOD
// expect: no error
void use(jauscat::component& driver) {
    jaus::report_wrench_effort effort{};
    driver.on([&](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); },
              [](const jaus::set_travel_speed&, const jaus::header&) { return jaus::message_outcome::refused; },
              [](const jaus::query_travel_speed&) { return jaus::report_travel_speed{}; });
    driver.reports([&] { return effort; });
    driver.when_stopped([&] { effort = {}; });
}
#endif

#ifdef ASK_WITHOUT_REPORT
// expect: async_ask: no report answers this message; the schema of a query names its report
void use(jauscat::component& unit, const jaus::address& arm) {
    unit.async_ask(arm, jaus::set_wrench_effort{}, [](const auto&...) {});
}
#endif

#ifdef HANDLER_CHANGES_MESSAGE
// expect: on: a handler takes (const T&) or (const T&, const jaus::header&)
void use(jauscat::component& driver) {
    driver.on([](jaus::set_wrench_effort&) {});
}
#endif

#ifdef HANDLER_GENERIC
// expect: on: a handler names its message: [](const jaus::set_wrench_effort& effort) { ... }
void use(jauscat::component& driver) {
    driver.on([](const auto&) {});
}
#endif

#ifdef HANDLER_NO_MESSAGE
// expect: on: the parameter of a handler is no message with a command code; is the header of its schema included?
void use(jauscat::component& driver) {
    driver.on([](int) {});
}
#endif

#ifdef HANDLER_PARAMETERS
// expect: on: a handler takes (const T&) or (const T&, const jaus::header&)
void use(jauscat::component& driver) {
    driver.on([](const jaus::set_wrench_effort&, int) {});
}
#endif

#ifdef HANDLER_RESULT
// expect: on: a handler returns nothing, a message as the answer, or a message_outcome
void use(jauscat::component& driver) {
    driver.on([](const jaus::set_wrench_effort&) { return 1; });
}
#endif

#ifdef HANDLER_WITHOUT_SCHEMA
// expect: on: the parameter of a handler is no message with a command code; is the header of its schema included?
/// Its schema is in another header.
struct my_message {
    int value{};
};

void use(jauscat::component& driver) {
    driver.on([](const my_message&) {});
}
#endif

#ifdef REPORT_PARAMETERS
// expect: reports: the function takes nothing, or the query of its report
void use(jauscat::component& driver) {
    driver.reports([](const jaus::query_travel_speed&) { return jaus::report_wrench_effort{}; });
}
#endif

#ifdef REPORT_WITHOUT_QUERY
// expect: reports: the function returns no report that a query asks for; the schema of a report names its query
void use(jauscat::component& driver) {
    driver.reports([] { return jaus::set_wrench_effort{}; });
}
#endif

#ifdef TWO_HANDLERS
// expect: on: two handlers of one message
void use(jauscat::component& driver) {
    driver.on([](const jaus::set_wrench_effort&) {}, [](const jaus::set_travel_speed&) {},
              [](const jaus::set_wrench_effort&) {});
}
#endif
