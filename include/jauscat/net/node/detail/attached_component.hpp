// Type-erased component of a node.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/message_sink.hpp>
#include <jauscat/net/node/detail/default_answers.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace jauscat::net::detail {

struct attached_component {
    using bytes = std::span<const std::byte>;

    /// Refers to both. `answers` gets the messages that they do not handle.
    template <class Component, class Application>
    attached_component(Component& component, Application& application,
                       const std::shared_ptr<default_answers>& answers = {})
        : self{component.self()},
          on_message{[&, answers](const jaus::header& head, bytes body, time_point now, jaus::message_sink out) {
              return component.on_message(head, body, now, out, [&](const jaus::header& h, bytes b) {
                  const auto what = jaus::outcome_of(application(h, b));
                  const bool is_left = what == jaus::message_outcome::unhandled && answers != nullptr;
                  return is_left ? answers->on_message(h, b, now, out) : what;
              });
          }},
          on_time{[&](time_point now, jaus::message_sink out) { component.on_time(now, out); }},
          next_event{[&] { return component.next_event(); }},
          on_lost{[&](const jaus::address& who) { component.on_lost(who); }} {}

    jaus::address self;
    std::function<jaus::component_outcome(const jaus::header&, bytes, time_point, jaus::message_sink)> on_message;
    std::function<void(time_point, jaus::message_sink)> on_time;
    std::function<std::optional<time_point>()> next_event;
    std::function<void(const jaus::address&)> on_lost;
};

} // namespace jauscat::net::detail
