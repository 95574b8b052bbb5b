// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"
#include <jauscat/net/node/node_machine.hpp>

auto send(jauscat::net::node_machine& node) {
    return node.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{});
}
