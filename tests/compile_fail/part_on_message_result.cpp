// expect: component: on_message of a part does not return a message_outcome
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct lamp {
    bool on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink) { return false; }
    void on_time(time_point, jaus::message_sink) {}
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
} one;
jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}, one};
