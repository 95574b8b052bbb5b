// The functions of component.
#pragma once
#include <jauscat/app/component.hpp>
#include <jauscat/app/impl/component_state.hpp>
#include <jauscat/app/impl/node_state.hpp>

#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL component::component(node& of, const component_options& options) {
    auto self = of.manager();
    self.component = options.id;
    self.instance = options.instance;
    state_ = std::make_shared<app::component_state>(of.state(), self, options);
    of.state().add(state_);
}
JAUSCAT_DECL component::~component() { state_->close(); }

JAUSCAT_DECL void
component::on_others(std::function<jaus::message_outcome(const jaus::header& head, app::bytes body)> f) {
    state_->on_others = std::move(f);
}
JAUSCAT_DECL void component::changed() { state_->changed(); }
JAUSCAT_DECL void component::when_stopped(std::function<void()> f) { state_->on_stopped = std::move(f); }
JAUSCAT_DECL void component::when_ready(std::function<void()> f) { state_->on_ready = std::move(f); }
JAUSCAT_DECL void component::when_emergency(std::function<void(bool begins)> f) { state_->on_emergency = std::move(f); }
JAUSCAT_DECL void component::when_controlled(std::function<void(const std::optional<jaus::address>& by)> f) {
    state_->on_controlled = std::move(f);
}
JAUSCAT_DECL void component::every(duration period, std::function<void()> f) {
    if (state_->is_running()) throw std::logic_error{"periodic functions are given before the node starts"};
    if (period <= duration{}) throw std::invalid_argument{"a period is more than 0"};
    state_->periodic.push_back({period, std::move(f)});
}
JAUSCAT_DECL void component::ready() { state_->ready(); }
JAUSCAT_DECL void component::fail(std::string_view why) { state_->fail(why); }
JAUSCAT_DECL void component::reject_control() { state_->reject_control(); }
JAUSCAT_DECL jaus::primary_status_code component::state() const noexcept { return state_->state(); }
JAUSCAT_DECL std::optional<jaus::address> component::controller() const noexcept { return state_->controller(); }
JAUSCAT_DECL const jaus::address& component::address() const noexcept { return state_->self(); }
JAUSCAT_DECL void component::cancel() { app::cancel(state_); }
JAUSCAT_DECL result<void, net::error> component::send(const jaus::address& to, std::uint16_t command_code,
                                                      app::bytes body) {
    if (!state_->has_node())
        return net::error{.code = net::errc::not_running, .reason = {}, .message = "the node has ended"};
    return state_->node().net().send(state_->head_of(command_code, to), body);
}

namespace app {

JAUSCAT_DECL void take(component_state& component, taken_message message) { component.take(std::move(message)); }
JAUSCAT_DECL void give(component_state& component, given_report report) { component.give(std::move(report)); }

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
