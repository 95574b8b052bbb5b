// expect: component: a part has no next_event() const that returns a std::optional<time_point>
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct lamp {
    jaus::message_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink) {
        return jaus::message_outcome::unhandled;
    }
    void on_time(time_point, jaus::message_sink) {}
    void on_lost(const jaus::address&) {}
} one;
jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}, one};
