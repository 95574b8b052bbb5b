// A component of any type as its node sees it, with the memory for the large data sets that it receives.
#pragma once

#include <jauscat/jaus/component_outcome.hpp>
#include <jauscat/jaus/dispatcher.hpp>
#include <jauscat/jaus/large_data_set.hpp>
#include <jauscat/jaus/message_sink.hpp>
#include <jauscat/net/detail/default_answers.hpp>

#include <functional>
#include <vector>

namespace jauscat::net::detail {

struct attached_component {
    using time = std::chrono::nanoseconds;
    using bytes = std::span<const std::byte>;

    /// Refers to both. `answers` gets what they leave.
    template <class Component, class Application>
    attached_component(Component& component, Application& application,
                       const std::shared_ptr<default_answers>& answers = {})
        : self{component.self()},
          on_message{[&, answers](const jaus::header& head, bytes body, time now, jaus::message_sink out) {
              return component.on_message(head, body, now, out, [&](const jaus::header& h, bytes b) {
                  const auto what = jaus::outcome_of(application(h, b));
                  const bool is_left = what == jaus::message_outcome::not_mine && answers != nullptr;
                  return is_left ? answers->on_message(h, b, now, out) : what;
              });
          }},
          on_time{[&](time now, jaus::message_sink out) { component.on_time(now, out); }},
          next_event{[&] { return component.next_event(); }},
          on_lost{[&](const jaus::address& who) { component.on_lost(who); }} {}

    jaus::address self;
    std::function<jaus::component_outcome(const jaus::header&, bytes, time, jaus::message_sink)> on_message;
    std::function<void(time, jaus::message_sink)> on_time;
    std::function<std::optional<time>()> next_event;
    std::function<void(const jaus::address&)> on_lost;
};

/// A reassembler and its memory: `size` bytes of bodies, for `sets` at a time.
class large_data_memory {
  public:
    large_data_memory(std::size_t sets, std::size_t size, std::chrono::nanoseconds patience)
        : places_(std::max<std::size_t>(sets, 1)),
          packets_(places_.size() * (size / places_.size() / smallest_packet + 1)),
          bytes_(size),
          reassembler_{places_, packets_, bytes_, patience} {}
    large_data_memory(const large_data_memory&) = delete;
    large_data_memory& operator=(const large_data_memory&) = delete;

    jaus::reassembler& operator*() noexcept { return reassembler_; }
    jaus::reassembler* operator->() noexcept { return &reassembler_; }

  private:
    static constexpr std::size_t smallest_packet = 256; ///< on average, for a data set that fills its place

    std::vector<jaus::partial_data_set> places_;
    std::vector<jaus::held_packet> packets_;
    std::vector<std::byte> bytes_;
    jaus::reassembler reassembler_;
};

} // namespace jauscat::net::detail
