#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

int components_of(jauscat::node& node) {
    jauscat::component driver{node, {.id = 33}};
    driver.on([](const jauscat::jaus::set_wrench_effort&) {});
    return driver.address().component == 33 ? 1 : 0;
}
