// expect: ignoring return
#include <jauscat/jaus/events/service_consumer.hpp>

namespace jaus = jauscat::jaus;

void watch(jaus::service_consumer<1>& consumer, const jaus::address& arm, jaus::message_sink out) {
    consumer.ask(arm, 0x4404, 10, 1, {}, out);
}
