// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
#include "small_message.hpp"
#include <jauscat/net/node/node_machine.hpp>

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

auto send(jauscat::net::node_machine& node) {
    return node.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{});
}
