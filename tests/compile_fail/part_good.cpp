// expect: no error
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
    void list_messages(auto&& takes, auto&& sends) const {
        takes(jaus::supported_message{0xD101});
        sends(jaus::supported_message{0xF101});
    }
} one;
static_assert(jaus::component_part<lamp>);
jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}, one};
