// The functions of bus.
#pragma once
#include <jauscat/app/bus.hpp>
#include <jauscat/app/impl/bus_state.hpp>

#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL bus::bus(boost::asio::io_context& context, std::string_view where, const bus_options& options)
    : state_{std::make_shared<app::bus_state>(context, where, options)} {}
JAUSCAT_DECL bus::~bus() { state_->close(); }

JAUSCAT_DECL slave bus::slave(const slave_choice& which) const {
    const auto& id = which.identity;
    if (!which.position && !which.alias && which.name.empty() && !id.vendor && !id.product && !id.revision &&
        !id.serial)
        throw std::invalid_argument{"a slave is chosen by its position, alias, name or identity"};
    return {state_, which};
}
JAUSCAT_DECL std::vector<slave_info> bus::slaves() const { return state_->infos(); }
JAUSCAT_DECL std::vector<slave_status> bus::statuses() const { return state_->statuses(); }
JAUSCAT_DECL void bus::cancel() { state_->cancel(); }
JAUSCAT_DECL void bus::stop() { state_->stop(); }
JAUSCAT_DECL bus_statistics bus::statistics() const { return state_->statistics(); }
JAUSCAT_DECL void bus::every_cycle(std::function<void()> f) {
    const auto locked = state_->lock();
    state_->on_cycle = std::move(f);
    state_->keep_cycling();
}
JAUSCAT_DECL void bus::when_lost(std::function<void(const slave_info&, boost::system::error_code)> f) {
    const auto locked = state_->lock();
    state_->on_lost = std::move(f);
}
JAUSCAT_DECL void bus::when_found(std::function<void(const slave_info&)> f) {
    const auto locked = state_->lock();
    state_->on_found = std::move(f);
}
JAUSCAT_DECL void bus::when_changed(std::function<void(const slave_info&, const ethercat::al_status&)> f) {
    const auto locked = state_->lock();
    state_->on_changed = std::move(f);
}
JAUSCAT_DECL void bus::when_emergency(std::function<void(const slave_info&, const ethercat::coe_emergency&)> f) {
    const auto locked = state_->lock();
    state_->on_emergency = std::move(f);
}
JAUSCAT_DECL boost::asio::io_context& bus::context() const noexcept { return state_->context(); }
JAUSCAT_DECL void bus::start(app::operation_ptr<> done) {
    state_->start(std::move(done), state_->options().takes_over);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
