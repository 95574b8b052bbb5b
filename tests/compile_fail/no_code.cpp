#include "small_message.hpp"
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/node/node_machine.hpp>

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

#ifdef ANSWER
// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
const auto sent = jauscat::jaus::answer(jauscat::jaus::header{}, jauscat::jaus::address{}, small_message{},
                                        [](std::span<const std::byte>) {});
#endif

#ifdef COMPONENT_SEND
// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
jauscat::jaus::send_result send(jauscat::jaus::component<>& own, jauscat::jaus::message_sink out) {
    return own.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{}, out);
}
#endif

#ifdef MAKE_MESSAGE
// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
std::array<std::byte, 64> out{};
const auto size = jauscat::jaus::make_message(jauscat::jaus::header{}, small_message{}, out);
#endif

#ifdef NODE_SEND
// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
auto send(jauscat::net::node_machine& node) {
    return node.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{});
}
#endif

#ifdef ON
// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
auto handler = jauscat::jaus::on<small_message>([](const jauscat::jaus::header&, const small_message&) {});
#endif

#ifdef PUT
// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
const auto sent = jauscat::jaus::put(jauscat::jaus::header{}, small_message{}, [](std::span<const std::byte>) {});
#endif
