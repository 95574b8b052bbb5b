// expect: ignoring return
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;

void rest(jaus::component<>& unit, const jaus::address& arm, jauscat::time_point now, jaus::message_sink out) {
    unit.send({.destination = arm}, jaus::standby{}, now, out);
}
