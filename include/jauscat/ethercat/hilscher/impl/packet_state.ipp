// The functions of packet_state.
#pragma once
#include <jauscat/ethercat/hilscher/packet_state.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION service_step packet_get_state::begin(master& m, const packet_io&) noexcept {
    return service_step::started(m.start(exchange_datagram{command::brd, 0, esc_registers::al_status.address, read_}));
}

JAUSCAT_FUNCTION service_answer packet_get_state::answer(confirmation& out, const master&,
                                                         const packet_io&) const noexcept {
    al_status all{}; // of all slaves, or-ed
    static_cast<void>(wire::decode(all, read_));
    const auto bits = static_cast<unsigned>(all.state);
    out.us_current_ec_state = static_cast<hilscher::bus_state>(bits & (~bits + 1)); // the lowest bit
    return {};
}

JAUSCAT_FUNCTION service_step packet_set_state::begin(master& m, const packet_io& io) noexcept {
    using hilscher::bus_state, hilscher::packet_status;
    switch (asked.us_new_ec_state) {
    case bus_state::init:
    case bus_state::pre_op:
    case bus_state::safe_op:
    case bus_state::op: break;
    default: return service_step::done(packet_status::invalid_target_phase);
    }
    goal_ = static_cast<al_state>(asked.us_new_ec_state);
    if (!m.idle()) return service_step::done(packet_status::state_change_busy);
    const auto count = io.options.slaves.empty() ? m.slaves().size() : io.options.slaves.size();
    if (count > capacity) return service_step::done(packet_status::coe_no_resource);
    for (const auto& slave : io.options.slaves) bus_[count_++] = {slave.position, slave.station};
    if (io.options.slaves.empty())
        for (const auto& known : m.slaves()) bus_[count_++] = {known.position, known.station};
    if (count_ == 0) return service_step::done(packet_status::wrong_internal_state);
    return advance(m, io);
}

JAUSCAT_FUNCTION service_step packet_set_state::next(master& m, const packet_io& io) noexcept {
    if (m.error() != master_error{}) return service_step::done(status_of(m.error()));
    auto& member = bus_[place_];
    switch (stage_) {
    case stage::clear: // the slaves are in INIT, and the master has forgotten them
        place_ = count_;
        break;
    case stage::look:
        if (*m.result<exchange_datagram>() != 0) {
            al_status status{};
            static_cast<void>(wire::decode(status, read_));
            member.enter(status.state, status.error);
        }
        break;
    case stage::bring_up: member.enter(al_state::pre_op); break;
    case stage::lower: member.enter(goal_); break;
    case stage::configure: break;
    case stage::safe_op: member.enter(al_state::safe_op); break;
    case stage::op: break;
    }
    ++place_;
    return advance(m, io);
}

JAUSCAT_FUNCTION void packet_set_state::participant::enter(al_state next, bool with_error) noexcept {
    state = next;
    error = with_error;
}

JAUSCAT_FUNCTION hilscher::packet_status packet_set_state::status_of(const master_error& error) noexcept {
    if (error.code == master_errc::al_error || error.code == master_errc::state_timeout)
        return hilscher::packet_status::fail;
    return hilscher::status_of(error);
}

JAUSCAT_FUNCTION service_step packet_set_state::advance(master& m, const packet_io& io) noexcept {
    for (; stage_ <= stage::op; stage_ = static_cast<stage>(static_cast<unsigned>(stage_) + 1), place_ = 0)
        for (; place_ < count_; ++place_)
            if (is_due(m, io, bus_[place_])) return service_step::started(start(m, io, bus_[place_]));
    return service_step::done();
}

JAUSCAT_FUNCTION bool packet_set_state::is_due(const master& m, const packet_io& io,
                                               const participant& member) const noexcept {
    const auto state = member.state;
    const bool error = member.error;
    switch (stage_) {
    case stage::clear: return goal_ == al_state::init && !is_known(m, io, member);
    case stage::look: return is_known(m, io, member);
    case stage::bring_up:
        return goal_ != al_state::init &&
               (!ethercat::is_known(state) || state == al_state::init || state == al_state::boot);
    case stage::lower: return state > goal_ || (state == goal_ && error);
    case stage::configure:
    case stage::safe_op: return goal_ > al_state::pre_op && state == al_state::pre_op;
    default: return goal_ == al_state::op && state != al_state::op;
    }
}

JAUSCAT_FUNCTION identity_check packet_set_state::identity_of(const packet_io& io,
                                                              const participant& member) const noexcept {
    const auto at = static_cast<std::size_t>(&member - bus_.data());
    return at < io.options.slaves.size() ? io.options.slaves[at].identity : identity_check{};
}

JAUSCAT_FUNCTION bool packet_set_state::is_known(const master& m, const packet_io& io,
                                                 const participant& member) const noexcept {
    const auto* record = m.find(member.station);
    return record != nullptr && record->position == member.position &&
           identity_of(io, member).accepts(record->identity);
}

JAUSCAT_FUNCTION master_result<> packet_set_state::start(master& m, const packet_io& io,
                                                         const participant& slave) noexcept {
    switch (stage_) {
    case stage::clear: return m.start(scan{});
    case stage::look:
        return m.start(exchange_datagram{command::fprd, slave.station, esc_registers::al_status.address, read_});
    case stage::bring_up: return m.start(bring_up{slave.position, slave.station, identity_of(io, slave)});
    case stage::lower: return m.start(change_state{slave.station, goal_});
    case stage::configure: return m.start(configure{slave.station});
    case stage::safe_op: return m.start(change_state{slave.station, al_state::safe_op});
    default: return m.start(change_state{slave.station, al_state::op});
    }
}

} // namespace jauscat::ethercat
