// expect: node: the component has no next_event() const that returns a std::optional<time_point>
#include <jauscat/net/node/node_machine.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct lamp {
    jaus::address self() const { return {}; }
    jaus::component_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink,
                                       auto&&) {
        return jaus::component_outcome::handled;
    }
    void on_time(time_point, jaus::message_sink) {}
    time_point next_event() const { return {}; }
    void on_lost(const jaus::address&) {}
} one;
struct nothing {
    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) {
        return jaus::message_outcome::unhandled;
    }
} application;
void add(jauscat::net::node_machine& node) { node.add(one, application); }
