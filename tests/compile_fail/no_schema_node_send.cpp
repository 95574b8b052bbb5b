// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
#include "small_message.hpp"
#include <jauscat/net/node/node_machine.hpp>

auto send(jauscat::net::node_machine& node) {
    return node.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{});
}
