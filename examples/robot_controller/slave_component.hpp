// A JAUS component that stands in front of a slave: state, control and acknowledgement are kept here, what is left of
// its messages is the slave's.
#pragma once
#include "robot_controller/slave_driver.hpp"
#include "support/robot_messages.hpp"
#include <jauscat/jaus/component.hpp>
#include <jauscat/text/value.hpp>

#include <array>
#include <string>

namespace example {

/// To be added to a jaus_node as a component is. It brings the slave to rest, with zero efforts, when it goes to any
/// state but Ready and when its controller is lost (not when that releases control); in an emergency the slave is told
/// of it too, so that it does not obey others either. A slave that is down then is brought to rest when it is back.
class slave_component {
  public:
    using bytes = std::span<const std::byte>;
    using time = std::chrono::nanoseconds;

    slave_component(const jauscat::jaus::address& self, std::uint8_t authority, slave_driver& driver, speaker say)
        : driver_{driver},
          say_{std::move(say)},
          core_{self,
                memory_,
                {.on_state = jauscat::jaus::bound<&slave_component::changed_state>(*this),
                 .on_controller = jauscat::jaus::bound<&slave_component::changed_controller>(*this)},
                {.control = {.authority_code = authority}}} {}
    slave_component(const slave_component&) = delete;
    slave_component& operator=(const slave_component&) = delete;

    [[nodiscard]] const jauscat::jaus::address& self() const noexcept { return core_.self(); }

    /// What `application` leaves is the slave's.
    jauscat::jaus::component_outcome on_message(const jauscat::jaus::header& head, bytes body, time now,
                                                jauscat::jaus::message_sink out, auto&& application) {
        namespace jaus = jauscat::jaus;
        show_received(head, body);
        const auto send = [&](bytes message) {
            out(message);
            say_("sent " + jauscat::text::summary(jaus::split(message).header));
        };
        const auto what = core_.on_message(head, body, now, send, [&](const jaus::header& own, bytes own_body) {
            const jaus::message_outcome answered = application(own, own_body);
            if (answered != jaus::message_outcome::not_mine) return answered;
            return deliver(own, own_body, send) ? jaus::message_outcome::taken : jaus::message_outcome::refused;
        });
        // Whose emergency it was, the slave cannot know: it is told when the last has cleared his.
        if (head.command_code == jaus::clear_emergency::command_code && what == jaus::component_outcome::taken &&
            core_.state() != jaus::primary_status_code::emergency)
            deliver(head, body, send);
        if (what == jaus::component_outcome::repeated) say_(std::string{describe(what)});
        initialize(); // after a Reset
        return what;
    }
    void on_time(time now, jauscat::jaus::message_sink out) { core_.on_time(now, out); }
    [[nodiscard]] std::optional<time> next_event() const { return core_.next_event(); }
    void on_lost(const jauscat::jaus::address& who) { core_.on_lost(who); }

    /// The slave has been brought up.
    void slave_is_up() {
        initialize();
        if (owes_rest_) bring_to_rest("the slave is back");
    }

  private:
    [[nodiscard]] std::string name() const { return jauscat::text::to_text(self()); }

    void initialize() {
        if (driver_.up() && core_.state() == jauscat::jaus::primary_status_code::initialize)
            core_.change(jauscat::jaus::state_event::initialized);
    }

    void show_received(const jauscat::jaus::header& head, bytes body) const {
        std::array<std::byte, jauscat::jaus::header_size + jauscat::jaus::max_body_size> message{};
        const auto size = jauscat::jaus::join(head, body, message);
        if (size)
            say_("received " + jauscat::text::summary(jauscat::jaus::split(bytes{message}.first(size.size())).header),
                 jauscat::text::annotate_message(bytes{message}.first(size.size()), robot_messages{}));
        else
            say_("received " + jauscat::text::message_name(head.command_code) + ", a large data set of " +
                 std::to_string(body.size()) + " bytes, from " + jauscat::text::to_text(head.source));
    }

    /// To the slave, which is meant also where all of a level are.
    bool deliver(jauscat::jaus::header head, bytes body, jauscat::jaus::message_sink out) {
        std::array<std::byte, jauscat::jaus::header_size + jauscat::jaus::max_body_size> message{};
        head.destination = self();
        if (const auto size = jauscat::jaus::join(head, body, message))
            return driver_.deliver(bytes{message}.first(size.size()), out);
        say_.bad("not delivered: more bytes than an SDO carries");
        return false;
    }
    /// A message of the component's own.
    template <class Message> bool tell_slave(const Message& body) {
        std::array<std::byte, jauscat::jaus::header_size + jauscat::wire::max_size<Message>> message{};
        const auto size = jauscat::jaus::make_message(
            {.ack_nak = jauscat::jaus::ack_nak::request, .destination = self(), .source = self()}, body, message);
        return size && driver_.deliver(bytes{message}.first(size.size()), [](bytes) {});
    }

    void bring_to_rest(const std::string& why) {
        using namespace jauscat::jaus;
        owes_rest_ = !driver_.up();
        say_(name() + ": " + why +
             (owes_rest_ ? ": efforts go to zero when the slave is back" : ": efforts go to zero"));
        if (owes_rest_) return;
        set_wrench_effort nothing{};
        jauscat::wire::visit(nothing, [](auto, auto& effort) { effort = 0.0; });
        bool told = tell_slave(nothing);
        if (core_.state() == primary_status_code::emergency) {
            set_emergency stop{};
            stop.emergency_code.set(set_emergency_code::transition_to_emergency);
            told = tell_slave(stop) && told;
        }
        owes_rest_ = !told;
    }
    void changed_state(jauscat::jaus::primary_status_code from, jauscat::jaus::primary_status_code to) {
        say_(name() + ": " + jauscat::text::to_text(from) + " -> " + jauscat::text::to_text(to));
        if (to != jauscat::jaus::primary_status_code::ready) bring_to_rest(jauscat::text::to_text(to));
    }
    void changed_controller(const std::optional<jauscat::jaus::controller>& now, jauscat::jaus::control_change why) {
        if (now)
            return say_(name() + " is controlled by " + jauscat::text::to_text(now->address) + ", authority " +
                        std::to_string(now->authority_code));
        say_(name() + " is controlled by nobody");
        if (why == jauscat::jaus::control_change::lost) bring_to_rest("its controller is lost");
    }

    slave_driver& driver_;
    speaker say_;
    bool owes_rest_{}; ///< the slave has not confirmed that it was brought to rest: once more when it is back
    jauscat::jaus::component_memory<16, 256, 4096> memory_{};
    jauscat::jaus::component<> core_;
};

} // namespace example
