// A JAUS component: a primitive driver that stores the commanded wrench effort, and reports it.
//     primitive_driver --config JausConfig.xml --this b
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace jaus = jauscat::jaus;

int main(int argc, char** argv) {
    jauscat::node node{argc, argv};
    jauscat::component driver{node, {.id = 33, .name = "Primitive Driver"}};

    constexpr auto at_rest = jaus::all_zero<jaus::report_wrench_effort>();
    auto effort = at_rest;
    // Where the effort changes, the motors are set, too.
    driver.on([&](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
    driver.reports([&] { return effort; });
    driver.when_stopped([&] { effort = at_rest; }); // not Ready, emergency, controller lost
    driver.ready();
    return node.run();
}
