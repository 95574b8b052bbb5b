// expect: node: the component has no on_message(const header&, std::span<const std::byte>, time_point,
// message_sink, auto&& application) that returns a component_outcome
#include <jauscat/net/node/node_machine.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct lamp {
    jaus::address self() const { return {}; }
    jaus::component_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point,
                                       jaus::message_sink) {
        return jaus::component_outcome::handled;
    }
    void on_time(time_point, jaus::message_sink) {}
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
} one;
struct nothing {
    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) {
        return jaus::message_outcome::unhandled;
    }
} application;
void add(jauscat::net::node_machine& node) { node.add(one, application); }
