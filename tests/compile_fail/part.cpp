#include <jauscat/jaus/component/component.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct good_part {
    jaus::message_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink) {
        return jaus::message_outcome::unhandled;
    }
    void on_time(time_point, jaus::message_sink) {}
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
};

// A case hides what it has otherwise than `good_part`.
#ifdef GOOD
// expect: no error
struct lamp : good_part {
    void list_messages(auto&& takes, auto&& sends) const {
        takes(jaus::supported_message{0xD101});
        sends(jaus::supported_message{0xF101});
    }
} one;
static_assert(jaus::component_part<lamp>);
#endif

#ifdef LIST_MESSAGES_NOT_CONST
// expect: component: list_messages of a part is not const, or has other parameters than (takes, sends)
struct lamp : good_part {
    void list_messages(auto&& takes, auto&&) { takes(jaus::supported_message{0xD101}); }
} one;
#endif

#ifdef LIST_MESSAGES_PARAMETERS
// expect: component: list_messages of a part is not const, or has other parameters than (takes, sends)
struct lamp : good_part {
    void list_messages(std::span<jaus::supported_message>) const {}
} one;
#endif

#ifdef NEXT_EVENT_NOT_CONST
// expect: component: a part has no next_event() const that returns a std::optional<time_point>
struct lamp : good_part {
    std::optional<time_point> next_event() { return std::nullopt; }
} one;
#endif

#ifdef NEXT_EVENT_RESULT
// expect: component: a part has no next_event() const that returns a std::optional<time_point>
struct lamp : good_part {
    time_point next_event() const { return time_point::max(); }
} one;
#endif

#ifdef WITHOUT_NEXT_EVENT
// expect: component: a part has no next_event() const that returns a std::optional<time_point>
struct lamp : good_part {
    void next_event() const = delete;
} one;
#endif

#ifdef ON_LOST_PARAMETERS
// expect: component: a part has no on_lost(const address&)
struct lamp : good_part {
    void on_lost(std::uint8_t) {}
} one;
#endif

#ifdef WITHOUT_ON_LOST
// expect: component: a part has no on_lost(const address&)
struct lamp : good_part {
    void on_lost(const jaus::address&) = delete;
} one;
#endif

#ifdef ON_MESSAGE_PARAMETERS
// expect: component: a part has no on_message(const header&, std::span<const std::byte>, time_point,
// message_sink)
struct lamp : good_part {
    jaus::message_outcome on_message(const jaus::header&, std::span<const std::byte>, jaus::message_sink) {
        return jaus::message_outcome::unhandled;
    }
} one;
#endif

#ifdef ON_MESSAGE_MISSPELT
// expect: component: a part has no on_message(const header&, std::span<const std::byte>, time_point,
// message_sink)
struct lamp {
    jaus::message_outcome on_mesage(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink) {
        return jaus::message_outcome::unhandled;
    }
    void on_time(time_point, jaus::message_sink) {}
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
} one;
#endif

#ifdef ON_MESSAGE_RESULT
// expect: component: on_message of a part does not return a message_outcome
struct lamp : good_part {
    bool on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink) { return false; }
} one;
#endif

#ifdef ON_TIME_PARAMETERS
// expect: component: a part has no on_time(time_point, message_sink)
struct lamp : good_part {
    void on_time(time_point) {}
} one;
#endif

#ifdef WITHOUT_ON_TIME
// expect: component: a part has no on_time(time_point, message_sink)
struct lamp : good_part {
    void on_time(time_point, jaus::message_sink) = delete;
} one;
#endif

jaus::component_memory<> memory;
jaus::component core{{}, memory, {}, {}, one};
