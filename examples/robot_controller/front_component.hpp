// A component of a bridge that logs received and sent messages.
#pragma once
#include "support/message_event.hpp"
#include "support/robot_messages.hpp"
#include "support/say.hpp"
#include <jauscat/bridge/component.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/value.hpp>

#include <array>
#include <string>
#include <utility>

namespace example {

/// Pulses come and go several times a second.
inline bool is_pulse(const jauscat::jaus::header& head) {
    return head.command_code == jauscat::jaus::command_code_of<jauscat::jaus::query_heartbeat_pulse> ||
           head.command_code == jauscat::jaus::command_code_of<jauscat::jaus::report_heartbeat_pulse>;
}

/// Logs the messages that it passes on.
struct said_messages {
    const speaker& say;
    jauscat::jaus::message_sink out;

    void operator()(std::span<const std::byte> message) const {
        const auto head = jauscat::jaus::split(message).header;
        out(message);
        if (!is_pulse(head)) say(events::message_sent, message_members(head), "sent " + jauscat::text::summary(head));
    }
};

/// To be added to a jaus_node.
class front_component {
  public:
    using bytes = std::span<const std::byte>;

    front_component(const jauscat::jaus::address& self, jauscat::bridging::slave_front& front,
                    const jauscat::jaus::component_options& options, speaker say)
        : say_{std::move(say)}, unit_{self, front, options} {}

    [[nodiscard]] const jauscat::jaus::address& self() const noexcept { return unit_.self(); }

    jauscat::jaus::component_outcome on_message(const jauscat::jaus::header& head, bytes body, jauscat::time_point now,
                                                jauscat::jaus::message_sink out, auto&& application) {
        if (!is_pulse(head)) show_received(head, body);
        const said_messages said{say_, out};
        const auto what = unit_.on_message(head, body, now, said, application);
        if (what == jauscat::jaus::component_outcome::repeated)
            say_(events::message_repeated, message_members(head), std::string{describe(what)});
        return what;
    }
    void on_time(jauscat::time_point now, jauscat::jaus::message_sink out) { unit_.on_time(now, out); }
    [[nodiscard]] std::optional<jauscat::time_point> next_event() const { return unit_.next_event(); }
    void on_lost(const jauscat::jaus::address& who) { unit_.on_lost(who); }

  private:
    void show_received(const jauscat::jaus::header& head, bytes body) const {
        std::array<std::byte, jauscat::jaus::header_size + jauscat::jaus::max_body_size> message{};
        const auto made = jauscat::jaus::join(head, body, message);
        if (made)
            say_(events::message_received, message_members(head, body),
                 "received " + jauscat::text::summary(jauscat::jaus::split(*made).header),
                 jauscat::text::annotate_message(*made, robot_messages{}));
        else
            say_(events::message_received, message_members(head) + event_members{{"large_body", body.size()}},
                 "received " + jauscat::text::message_name(head.command_code) + ", a large data set of " +
                     std::to_string(body.size()) + " bytes, from " + jauscat::text::to_text(head.source));
    }

    speaker say_;
    jauscat::bridging::component unit_;
};

} // namespace example
