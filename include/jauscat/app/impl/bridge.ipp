// The functions of bridge, and the exchanges under the library's tables.
#pragma once
#include <jauscat/app/bridge.hpp>
#include <jauscat/app/impl/bridge_state.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

#include <stdexcept>
#include <utility>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL bridge::bridge(node& of, bus& on, app::exchange_maker make, const bridge_options& options) {
    state_ = std::make_shared<app::bridge_state>(of.state(), on.state(), make, options);
    of.state().add(state_->as_part());
}
JAUSCAT_DECL bridge::~bridge() { state_->close(); }

JAUSCAT_DECL void bridge::serve(const served_component& component, const slave& by) {
    serve(component, std::vector{by}, nullptr);
}
JAUSCAT_DECL void bridge::serve(const served_component& component, const slave& by,
                                std::unique_ptr<bridging::process_part> part) {
    serve(component, std::vector{by}, std::move(part));
}
JAUSCAT_DECL void bridge::serve(const served_component& component, const std::vector<slave>& group,
                                std::unique_ptr<bridging::process_part> part) {
    std::vector<slave_choice> choices;
    for (const auto& each : group) {
        if (each.bus() != state_->bus()) throw std::invalid_argument{"bridge: a slave of another bus"};
        choices.push_back(each.choice());
    }
    state_->serve(component, choices, std::move(part));
}
JAUSCAT_DECL void bridge::when_up(std::function<void(const slave_choice&)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_up = std::move(f);
}
JAUSCAT_DECL void bridge::when_lost(std::function<void(const slave_choice&, boost::system::error_code)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_lost = std::move(f);
}
JAUSCAT_DECL void bridge::when_changed(std::function<void(const jaus::address&, jaus::primary_status_code)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_changed = std::move(f);
}
JAUSCAT_DECL void bridge::when_at_rest(std::function<void(const jaus::address&)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_at_rest = std::move(f);
}
JAUSCAT_DECL void bridge::when_emergency(std::function<void(const slave_choice&, const ethercat::coe_emergency&)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_emergency = std::move(f);
}
JAUSCAT_DECL void bridge::when_faulted(std::function<void(const jaus::address&, const bridging::drive_fault&)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_faulted = std::move(f);
}
JAUSCAT_DECL void bridge::when_fault_ended(std::function<void(const jaus::address&)> f) {
    const auto locked = state_->bus()->lock();
    state_->on_fault_ended = std::move(f);
}
JAUSCAT_DECL void bridge::observe(const bridging::observer& by) { state_->watcher = by; }
JAUSCAT_DECL bool bridge::at_rest() const { return state_->at_rest(); }
JAUSCAT_DECL bool bridge::is_up() const { return state_->is_up(); }

namespace app {

#ifdef JAUSCAT_SEPARATE_COMPILATION
template std::unique_ptr<bridging::any_exchange>
make_exchange<translation::seed_table>(const bridging::slave_identity&);
template std::unique_ptr<bridging::any_exchange>
make_exchange<translation::seed_table_at_2000h>(const bridging::slave_identity&);
template std::unique_ptr<bridging::any_exchange>
make_exchange<translation::seed_table_at_6900h>(const bridging::slave_identity&);
template std::unique_ptr<bridging::any_exchange>
make_exchange<translation::self_contained_table>(const bridging::slave_identity&);
template std::unique_ptr<bridging::any_exchange>
make_exchange<translation::self_contained_table_at_2000h>(const bridging::slave_identity&);
template std::unique_ptr<bridging::any_exchange>
make_exchange<translation::self_contained_table_at_6900h>(const bridging::slave_identity&);
#endif

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
