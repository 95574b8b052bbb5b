// The jobs of a bus that find slaves, watch them and take them to a state.
#pragma once
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// Brings a slave up and reads its alias and its name.
class slave_identification {
  public:
    static constexpr std::uint16_t first_station = 1001; // JAUS nodes are up to 254

    slave_identification() = default;
    /// Another slave than `required` is not brought up.
    slave_identification(std::uint16_t position, const ethercat::identity_check& required) : required_{required} {
        found.info.position = position;
        found.info.station = static_cast<std::uint16_t>(first_station + position);
    }

    /// Of one that is in PRE-OP or higher already.
    explicit slave_identification(const bus_slave& known) : found{known}, step_{step::alias} {}

    bool begin(bus_state& bus, ethercat::master& master) {
        const auto station = found.info.station;
        switch (step_) {
        case step::bring_up:
            return master.start(ethercat::bring_up{found.info.position, station, required_}).has_value();
        case step::alias:
            return master
                .start(ethercat::exchange_datagram{ethercat::command::fprd, station,
                                                   ethercat::esc_registers::station_alias.address, alias_})
                .has_value();
        case step::name:
            return master.start(ethercat::upload{station, ethercat::standard_indices::device_name, 0, bus.memory()})
                .has_value();
        case step::done: break;
        }
        return false;
    }
    void end(bus_state& bus, ethercat::master& master) {
        error = error_of(master.error());
        switch (step_) {
        case step::bring_up:
            if (const auto record = master.result<ethercat::bring_up>()) take(*record);
            step_ = error ? step::done : step::alias;
            return;
        case step::alias:
            if (master.result<ethercat::exchange_datagram>().value_or(0) == 1)
                found.info.alias = static_cast<std::uint16_t>(std::to_integer<unsigned>(alias_[0]) |
                                                              std::to_integer<unsigned>(alias_[1]) << 8);
            step_ = found.info.has_objects ? step::name : step::done;
            return;
        case step::name:
            if (const auto name = master.result<ethercat::upload>())
                std::tie(std::ignore, found.info.name) =
                    object_conversion<std::string>{}({}, {name->begin(), name->end()});
            error = {}; // not every slave has one
            static_cast<void>(bus);
            step_ = step::done;
            return;
        case step::done: return;
        }
    }

    enum class step : std::uint8_t { bring_up, alias, name, done };

    bus_slave found{};
    error_code error{};

  private:
    void take(const ethercat::slave_record& record) {
        identify(found, record);
        found.al.state = ethercat::al_state::pre_op;
    }

    step step_{};

    ethercat::identity_check required_{};
    std::array<std::byte, 2> alias_{};
};

/// Finds all slaves.
class start_job final : public bus_job {
  public:
    explicit start_job(operation_ptr<> done) : done_{std::move(done)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        is_serving_ = bus.is_serving() && bus.ring().is_cleared(); // a scan would reset its slaves
        if (!is_counted_ && is_serving_)
            return master
                .start(ethercat::exchange_datagram{ethercat::command::brd, 0, ethercat::esc_registers::type.address,
                                                   type_})
                .has_value();
        if (!is_counted_) return master.start(ethercat::scan{}).has_value();
        for (;;) {
            if (is_identifying_ && one_.begin(bus, master)) return true;
            if (std::exchange(is_identifying_, false)) keep(bus);
            if (found_.size() == count_) break;
            const auto position = static_cast<std::uint16_t>(found_.size());
            const auto* const known = bus.at(position);
            if (bus.user_at(position) == nullptr)
                one_ = {position, {}};
            else if (known != nullptr && known->is_identified && !known->info.is_lost)
                one_ = slave_identification{*known};
            else { // it is brought up by its bridge
                found_.push_back(known != nullptr ? *known : bus_slave{});
                continue;
            }
            is_identifying_ = true;
        }
        bus.slaves() = std::move(found_);
        bus.set_started();
        done_->complete(error_);
        return false;
    }
    void end(bus_state& bus, ethercat::master& master) override {
        if (is_counted_) return one_.end(bus, master);
        is_counted_ = true;
        if (const auto error = error_of(master.error())) return fail(error);
        const std::size_t counted = is_serving_ ? master.result<ethercat::exchange_datagram>().value_or(0)
                                                : master.result<ethercat::scan>().value_or(0);
        if (counted == 0) return fail(bus_errc::no_slaves);
        if (counted > ethercat::slave_capacity) return fail(bus_errc::too_many_slaves);
        count_ = counted;
    }
    [[nodiscard]] bool is_over() const override { return done_->is_done(); }
    void fail(error_code why) override { done_->complete(why); }

  private:
    void keep(bus_state& bus) {
        auto& found = one_.found;
        found.info.is_lost = one_.error.failed();
        found.why = one_.error;
        if (one_.error) {
            bus.log(name_of(found.info) + " is not brought up: " + one_.error.message());
            if (!error_) error_ = one_.error;
        }
        found_.push_back(std::move(found));
    }

    operation_ptr<> done_;
    bool is_serving_{}, is_counted_{};
    std::array<std::byte, 1> type_{};
    std::size_t count_{};
    bool is_identifying_{};
    slave_identification one_{};
    std::vector<bus_slave> found_{};
    error_code error_{};
};

/// Looks at the state of a slave, collects its emergencies, and brings it up again after it was reset.
class look_job final : public bus_job {
  public:
    explicit look_job(std::uint16_t position) : position_{position} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        const auto* const slave = bus.at(position_);
        if (slave == nullptr) return false;
        switch (step_) {
        case step::look: return master.start(ethercat::check{slave->info.station}).has_value();
        case step::collect: return master.start(ethercat::collect_emergencies{slave->info.station}).has_value();
        case step::identify: return one_.begin(bus, master) || (identified(bus), false);
        case step::done: break;
        }
        return false;
    }
    void end(bus_state& bus, ethercat::master& master) override {
        auto* const slave = bus.at(position_);
        if (slave == nullptr) return;
        const auto error = error_of(master.error());
        switch (step_) {
        case step::look: return looked(bus, *slave, master, error);
        case step::collect:
            bus.note_outcome(*slave, error);
            bus.note_emergencies(*slave, master);
            step_ = step::done;
            return;
        case step::identify: return one_.end(bus, master);
        case step::done: return;
        }
    }
    [[nodiscard]] bool is_over() const override { return false; }
    void fail(error_code) override {}

  private:
    enum class step : std::uint8_t { look, collect, identify, done };

    void looked(bus_state& bus, bus_slave& slave, ethercat::master& master, error_code error) {
        step_ = step::done;
        bus.note_outcome(slave, error);
        if (error == bus_errc::slave_lost) {
            ethercat::identity_check required{};
            const auto& info = slave.info;
            if (slave.is_identified) required = {info.vendor, info.product, info.revision, info.serial};
            one_ = {position_, required};
            step_ = step::identify;
        }
        if (error) return;
        const auto* const record = master.find(slave.info.station);
        if (record == nullptr) return;
        bus.note_state(slave, record->al);
        if (record->reply_waiting) step_ = step::collect;
    }
    void identified(bus_state& bus) {
        step_ = step::done;
        auto* const slave = bus.at(position_);
        if (slave == nullptr) return;
        if (one_.error) return bus.note_lost(*slave, one_.error);
        slave->info.alias = one_.found.info.alias; // all else is as it was, or was not known
        const auto lost = *slave;
        *slave = one_.found;
        slave->info.is_lost = lost.info.is_lost;
        slave->why = lost.why;
        slave->next_look = lost.next_look;
        slave->al = lost.al;
        bus.note_found(*slave);
        bus.note_state(*slave, one_.found.al);
    }

    std::uint16_t position_{};
    step step_{};
    slave_identification one_{};
};

/// Takes a slave to a state, and configures its process data before SAFE-OP.
class change_job final : public bus_job {
  public:
    change_job(const slave_choice& which, ethercat::al_state goal, operation_ptr<> done)
        : which_{which}, goal_{goal}, done_{std::move(done)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        error_code error;
        auto* const slave = bus.find(which_, error);
        if (slave == nullptr) return fail(error), false;
        if (slave->info.is_served) return fail(bus_errc::served), false;
        if (goal_ == ethercat::al_state::op) return fail(bus_errc::needs_cycles), false;
        position_ = slave->info.position;
        const auto station = slave->info.station;
        if (goal_ != ethercat::al_state::safe_op || slave->is_configured) {
            step_ = step::change;
            return master.start(ethercat::change_state{station, goal_}).has_value();
        }
        if (step_ == step::look) return master.start(ethercat::check{station}).has_value();
        if (step_ == step::configure) return master.start(ethercat::configure{station}).has_value();
        return master.start(ethercat::change_state{station, ethercat::al_state::pre_op}).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        auto* const slave = bus.at(position_);
        const auto error = error_of(master.error());
        if (slave == nullptr) return fail(bus_errc::no_such_slave);
        bus.note_outcome(*slave, error);
        if (error) return fail(error);
        switch (step_) {
        case step::look:
            if (const auto al = master.result<ethercat::check>()) {
                if (al->state == goal_ && !al->error) break;
                step_ = al->state == ethercat::al_state::pre_op && !al->error ? step::configure : step::pre_op;
            }
            return;
        case step::pre_op: step_ = step::configure; return;
        case step::configure: slave->is_configured = true; return;
        case step::change: break;
        }
        if (goal_ == ethercat::al_state::init) slave->is_configured = false;
        bus.note_state(*slave, {.state = goal_});
        done_->complete({});
    }
    [[nodiscard]] bool is_over() const override { return done_->is_done(); }
    void fail(error_code why) override { done_->complete(why); }

  private:
    enum class step : std::uint8_t { look, pre_op, configure, change };

    slave_choice which_;
    ethercat::al_state goal_;
    operation_ptr<> done_;
    step step_{};
    std::uint16_t position_{};
};

JAUSCAT_DECL std::unique_ptr<bus_job> make_look_job(std::uint16_t position) {
    return std::make_unique<look_job>(position);
}
JAUSCAT_DECL void bus_state::start(operation_ptr<> done) {
    add(std::make_unique<start_job>(std::move(done)), options_.start_timeout);
}
JAUSCAT_DECL void bus_state::change(const slave_choice& which, ethercat::al_state goal, operation_ptr<> done) {
    add(std::make_unique<change_job>(which, goal, std::move(done)), options_.timeout);
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
