// Brings the robot arm to rest when it is no longer commanded.
#pragma once
#include "arm_application.hpp"
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/text/value.hpp>

#include <chrono>
#include <cstdint>
#include <string>

namespace example {

/// The arm stops without a master: when its slave leaves OP or the states that have a mailbox, when it gets another
/// station address, and when efforts by mailbox are not followed by any message for the time of the command timeout.
/// Efforts by process data need no such time: the slave's watchdog takes it out of OP.
class arm_watch {
  public:
    /// `command_timeout`: 0 for none.
    arm_watch(arm& behind, std::chrono::milliseconds command_timeout) : arm_{behind}, timeout_{command_timeout} {}

    /// To be called after each frame and after time has passed.
    void look(const jauscat::ethercat::slave& slave, jauscat::time_point now) {
        look_at_state(slave.state());
        if (std::exchange(station_, slave.station_address()) != slave.station_address())
            arm_.rest("station_address", "another station address");
        if (std::exchange(messages_, arm_.messages()) != arm_.messages()) last_message_ = now;
        const bool by_mailbox = arm_.moves() && !arm_.driven_by_process_data();
        if (by_mailbox && timeout_ != timeout_.zero() && now - last_message_ >= timeout_)
            arm_.rest("command_timeout", "no message for " + std::to_string(timeout_.count()) + " ms");
    }

  private:
    using al_state = jauscat::ethercat::al_state;

    void look_at_state(al_state state) {
        const bool has_mailbox = state == al_state::pre_op || state == al_state::safe_op || state == al_state::op;
        const bool was_in_op = std::exchange(state_, state) == al_state::op;
        if (state != al_state::op && (was_in_op || arm_.driven_by_process_data()))
            arm_.rest("no_process_data", "no process data any more");
        else if (!has_mailbox)
            arm_.rest("state", "state " + jauscat::text::to_text(state));
    }

    arm& arm_;
    std::chrono::milliseconds timeout_;
    al_state state_{};
    std::uint16_t station_{};
    std::uint64_t messages_{};
    jauscat::time_point last_message_{};
};

} // namespace example
