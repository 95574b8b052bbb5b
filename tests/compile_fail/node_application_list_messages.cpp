// expect: node: list_messages of the application is not const, or has other parameters than (takes, sends)
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
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
} one;
struct nothing {
    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) {
        return jaus::message_outcome::unhandled;
    }
    void list_messages(auto&& takes, auto&&) { takes(jaus::supported_message{0xD101}); }
} application;
void add(jauscat::net::node_machine& node) { node.add(one, application); }
