// expect: no error
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;

bool rest(jaus::component<>& unit, const jaus::address& arm, jauscat::time_point now, jaus::message_sink out) {
    return static_cast<bool>(unit.send({.destination = arm}, jaus::standby{}, now, out));
}
