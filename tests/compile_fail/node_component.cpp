#include <jauscat/net/node/node_machine.hpp>

namespace jaus = jauscat::jaus;
using jauscat::time_point;

struct good_component {
    jaus::address self() const { return {}; }
    jaus::component_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point, jaus::message_sink,
                                       auto&&) {
        return jaus::component_outcome::handled;
    }
    void on_time(time_point, jaus::message_sink) {}
    std::optional<time_point> next_event() const { return std::nullopt; }
    void on_lost(const jaus::address&) {}
};
struct good_application {
    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) {
        return jaus::message_outcome::unhandled;
    }
};

// A case hides what it has otherwise.
#ifdef GOOD
// expect: no error
struct lamp : good_component {
} one;
good_application application;
static_assert(jauscat::net::node_component<lamp>);
#endif

#ifdef APPLICATION_LIST_MESSAGES
// expect: node: list_messages of the application is not const, or has other parameters than (takes, sends)
good_component one;
struct lamp : good_application {
    void list_messages(auto&& takes, auto&&) { takes(jaus::supported_message{0xD101}); }
} application;
#endif

#ifdef NEXT_EVENT_RESULT
// expect: node: the component has no next_event() const that returns a std::optional<time_point>
struct lamp : good_component {
    time_point next_event() const { return {}; }
} one;
good_application application;
#endif

#ifdef ON_MESSAGE_PARAMETERS
// expect: node: the component has no on_message(const header&, std::span<const std::byte>, time_point,
// message_sink, auto&& application) that returns a component_outcome
struct lamp : good_component {
    jaus::component_outcome on_message(const jaus::header&, std::span<const std::byte>, time_point,
                                       jaus::message_sink) {
        return jaus::component_outcome::handled;
    }
} one;
good_application application;
#endif

#ifdef WITHOUT_ON_LOST
// expect: node: the component has no on_lost(const address&)
struct lamp : good_component {
    void on_lost(const jaus::address&) = delete;
} one;
good_application application;
#endif

#ifdef WITHOUT_SELF
// expect: node: the component has no self() const that returns a jaus::address
struct lamp : good_component {
    jaus::address self() const = delete;
} one;
good_application application;
#endif

void add(jauscat::net::node_machine& node) { node.add(one, application); }
