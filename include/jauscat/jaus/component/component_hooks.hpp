// Hooks of a component: functions that it calls on events.
#pragma once
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/component_state.hpp>
#include <jauscat/jaus/message/hook.hpp>

namespace jauscat::jaus {

/// The functions that a component calls, each before the message that caused it is acknowledged. All may be left out.
///
///     const auto rest = [&](jaus::primary_status_code, jaus::primary_status_code to) { ... };
///     jaus::component core{self, memory, {.on_state = rest}, {}};
///     jaus::component core{self, memory, {.on_state = jaus::bound<&driver::rest>(*this)}, {}};
struct component_hooks {
    hook<void(primary_status_code from, primary_status_code to)> on_state{};
    /// The controller has changed; empty if there is none. `why` is the cause. For `lost` bring the actuators to rest:
    /// it is also the cause, without a change, when another sender is lost whose motion command is in force.
    hook<void(const std::optional<controller>& now_it_is, control_change why)> on_controller{};
    /// A message that the component sent was acknowledged, refused or abandoned.
    hook<void(const awaited_message& message, delivered outcome)> on_delivered{};
    /// The state has processed Shutdown, Standby, Resume, Reset, Set or Clear Emergency, with or without a change;
    /// on_state has been called for a change. Returns the outcome of the message: handled, refused, or deferred until
    /// the actuator has executed it.
    hook<message_outcome(const header& head)> on_state_command{};
};

} // namespace jauscat::jaus
