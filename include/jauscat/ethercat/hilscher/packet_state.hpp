// Packets that ask for the state of the bus and set it.
#pragma once

#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>

#include <array>

namespace jauscat::ethercat {

/// The lowest state of all slaves in the ring, read at once.
class packet_get_state : public packet_service<hilscher::get_state_request, hilscher::get_state_confirmation> {
  public:
    service_step begin(master& m, const packet_io&) noexcept {
        return service_step::started(
            m.start(exchange_datagram{command::brd, 0, esc_registers::al_status.address, read_}));
    }
    service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept {
        al_status all{}; // of all slaves, or-ed
        static_cast<void>(wire::decode(all, read_));
        const auto bits = static_cast<unsigned>(all.state);
        out.us_current_ec_state = static_cast<hilscher::bus_state>(bits & (~bits + 1)); // the lowest bit
        return {};
    }

  private:
    std::array<std::byte, wire::max_size<al_status>> read_{};
};

/// Takes every slave of the bus to a state: those that are in INIT or were lost are brought up, those above it go down
/// at once, and all the others go up together, one state after the other. A slave that refuses ends it.
class packet_set_state : public packet_service<hilscher::set_state_request, hilscher::set_state_confirmation> {
  public:
    static constexpr bool one_job = false;
    service_step begin(master& m, const packet_io& io) noexcept {
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
        if (io.options.slaves.size() > bus_.size()) return service_step::done(packet_status::coe_no_resource);
        for (const auto& slave : io.options.slaves) bus_[count_++] = {slave.position, slave.station};
        if (count_ == 0)
            for (const auto& known : m.slaves()) bus_[count_++] = {known.position, known.station};
        if (count_ == 0) return service_step::done(packet_status::wrong_internal_state);
        return advance(m, io);
    }

    service_step next(master& m, const packet_io& io) noexcept {
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

    static service_answer answer(confirmation&, const master&, const packet_io&) noexcept { return {}; }

  private:
    enum class stage : std::uint8_t { clear, look, bring_up, lower, configure, safe_op, op };
    struct participant {
        std::uint16_t position{};
        std::uint16_t station{};
        al_state state{}; ///< 0: the slave is lost, or was never brought up
        bool error{};

        void enter(al_state next, bool with_error = false) noexcept {
            state = next;
            error = with_error;
        }
    };

    // A slave's reasons for refusing a state have statuses of their own, but their numbering is not documented.
    [[nodiscard]] static hilscher::packet_status status_of(const master_error& error) noexcept {
        if (error.code == master_errc::al_error || error.code == master_errc::state_timeout)
            return hilscher::packet_status::fail;
        return hilscher::status_of(error);
    }

    // Starts the next job that is due.
    service_step advance(master& m, const packet_io& io) noexcept {
        for (; stage_ <= stage::op; stage_ = static_cast<stage>(static_cast<unsigned>(stage_) + 1), place_ = 0)
            for (; place_ < count_; ++place_)
                if (is_due(m, io, bus_[place_])) return service_step::started(start(m, io, bus_[place_]));
        return service_step::done();
    }

    [[nodiscard]] bool is_due(const master& m, const packet_io& io, const participant& member) const noexcept {
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

    // Configured slaves keep their order.
    [[nodiscard]] identity_check identity_of(const packet_io& io, const participant& member) const noexcept {
        const auto at = static_cast<std::size_t>(&member - bus_.data());
        return at < io.options.slaves.size() ? io.options.slaves[at].identity : identity_check{};
    }
    [[nodiscard]] bool is_known(const master& m, const packet_io& io, const participant& member) const noexcept {
        const auto* record = m.find(member.station);
        return record != nullptr && record->position == member.position &&
               identity_of(io, member).accepts(record->identity);
    }

    master_result<> start(master& m, const packet_io& io, const participant& slave) noexcept {
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

    al_state goal_{};
    static constexpr std::size_t capacity = 256;

    std::array<participant, capacity> bus_{};
    std::size_t count_{};
    stage stage_{};
    std::size_t place_{};
    std::array<std::byte, wire::max_size<al_status>> read_{};
};

} // namespace jauscat::ethercat
