// Type-erased component of a node.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component_application.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/message/message_sink.hpp>

#include <optional>
#include <span>

namespace jauscat::net::detail {

/// Refers to a component and its application.
struct attached_component {
    using bytes = std::span<const std::byte>;
    /// Gets the messages that component and application do not handle.
    using unhandled = jaus::hook<jaus::message_outcome(const jaus::header&, bytes)>;

    template <class Component, class Application>
    attached_component(Component& component, Application& application)
        : self{component.self()},
          component_{&component},
          application_{const_cast<void*>(static_cast<const void*>(&application))},
          on_message_{[](void* to, void* own, const jaus::header& head, bytes body, time_point now,
                         jaus::message_sink out, unhandled rest) {
              auto& mine = *static_cast<Application*>(own);
              const auto use = [&](const jaus::header& h, bytes b) {
                  const auto what = jaus::outcome_of(mine(h, b));
                  return what == jaus::message_outcome::unhandled && rest ? rest(h, b) : what;
              };
              return static_cast<Component*>(to)->on_message(head, body, now, out, unhandled{use});
          }},
          on_time_{
              [](void* to, time_point now, jaus::message_sink out) { static_cast<Component*>(to)->on_time(now, out); }},
          next_event_{[](void* of) { return static_cast<Component*>(of)->next_event(); }},
          on_lost_{[](void* to, const jaus::address& who) { static_cast<Component*>(to)->on_lost(who); }},
          answer_query_{[](void* of, const jaus::header& query, bytes body, time_point now, jaus::message_sink out) {
              using jaus::message_outcome;
              auto& one = *static_cast<Component*>(of);
              if constexpr (requires { one.answer_query(query, body, now, out); }) {
                  return one.answer_query(query, body, now, out);
              } else {
                  const auto nothing = [](const jaus::header&, bytes) { return message_outcome::unhandled; };
                  const auto what = one.on_message(query, body, now, out, unhandled{nothing});
                  return what == jaus::component_outcome::handled ? message_outcome::handled
                                                                  : message_outcome::unhandled;
              }
          }} {}

    jaus::component_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out,
                                       unhandled rest) {
        return on_message_(component_, application_, head, body, now, out, rest);
    }
    void on_time(time_point now, jaus::message_sink out) { on_time_(component_, now, out); }
    [[nodiscard]] std::optional<time_point> next_event() { return next_event_(component_); }
    void on_lost(const jaus::address& who) { on_lost_(component_, who); }
    /// Of the core service. A component without such a function gets it as a message.
    jaus::message_outcome answer_query(const jaus::header& query, bytes body, time_point now,
                                       jaus::message_sink out) const {
        return answer_query_(component_, query, body, now, out);
    }

    jaus::address self;

  private:
    void* component_;
    void* application_;
    jaus::component_outcome (*on_message_)(void*, void*, const jaus::header&, bytes, time_point, jaus::message_sink,
                                           unhandled);
    void (*on_time_)(void*, time_point, jaus::message_sink);
    std::optional<time_point> (*next_event_)(void*);
    void (*on_lost_)(void*, const jaus::address&);
    jaus::message_outcome (*answer_query_)(void*, const jaus::header&, bytes, time_point, jaus::message_sink);
};

} // namespace jauscat::net::detail
