// expect: component: a part has no next_event() const that returns a std::optional<std::chrono::nanoseconds>
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;
using std::chrono::nanoseconds;

struct lamp {
    jaus::message_outcome on_message(const jaus::header&, std::span<const std::byte>, nanoseconds, jaus::message_sink) {
        return jaus::message_outcome::not_mine;
    }
    void on_time(nanoseconds, jaus::message_sink) {}
    void on_lost(const jaus::address&) {}
} one;
jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}, one};
