#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/events/service_consumer.hpp>
#include <jauscat/wire/list.hpp>

#ifdef OF_SEND_GOOD
// expect: no error
namespace jaus = jauscat::jaus;

bool rest(jaus::component<>& unit, const jaus::address& arm, jauscat::time_point now, jaus::message_sink out) {
    return static_cast<bool>(unit.send({.destination = arm}, jaus::standby{}, now, out));
}
#endif

#ifdef OF_ASK_IGNORED
// expect: ignoring return
namespace jaus = jauscat::jaus;

void watch(jaus::service_consumer<1>& consumer, const jaus::address& arm, jaus::message_sink out) {
    consumer.ask(arm, 0x4404, 10, 1, {}, out);
}
#endif

#ifdef OF_LINK_SEND_IGNORED
// expect: ignoring return
void pass_on(jauscat::ethercat::loopback_link& link, std::span<const std::byte> frame) { link.send(frame); }
#endif

#ifdef OF_PUSH_BACK_IGNORED
// expect: ignoring return
void add(jauscat::wire::inline_list<int, 4>& numbers) { numbers.push_back(1); }
#endif

#ifdef OF_SEND_IGNORED
// expect: ignoring return
namespace jaus = jauscat::jaus;

void rest(jaus::component<>& unit, const jaus::address& arm, jauscat::time_point now, jaus::message_sink out) {
    unit.send({.destination = arm}, jaus::standby{}, now, out);
}
#endif
