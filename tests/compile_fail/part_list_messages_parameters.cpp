// expect: component: list_messages of a part is not const, or has other parameters than (takes, sends)
#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct lamp {
    jaus::message_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink) {
        return jaus::message_outcome::unhandled;
    }
    void on_time(time_point, jaus::message_sink) {}
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
    void list_messages(std::span<jaus::supported_message>) const {}
} one;
jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}, one};
