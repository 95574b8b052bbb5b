// The functions of bus_state, and its jobs.
#pragma once
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/app/impl/named_slaves.ipp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <boost/asio/post.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

JAUSCAT_DECL error_code error_of(const ethercat::master_error& error) noexcept {
    using enum ethercat::master_errc;
    switch (error.code) {
    case ok: return {};
    case not_sent:
    case no_space: return bus_errc::not_sent;
    case no_reply: return bus_errc::no_reply;
    case timeout: return bus_errc::stopped;
    case no_slave:
    case wrong_station:
    case duplicate_station:
    case working_counter: return bus_errc::slave_lost;
    case wrong_identity: return bus_errc::wrong_slave;
    case no_mailbox:
    case no_coe: return bus_errc::no_objects;
    case al_error:
        if (error.al_status == ethercat::al_status_code::none) return bus_errc::refused;
        return error.al_status;
    case state_timeout: return bus_errc::state_not_reached;
    case too_many_slaves: return bus_errc::too_many_slaves;
    case sii_busy:
    case sii_error:
    case sii_malformed:
    case no_fmmu:
    case too_many_managers:
    case image_full:
    case watchdog_range:
    case object_not_kept:
    case watchdog_not_kept: return bus_errc::not_configurable;
    case no_clock:
    case clock_topology:
    case clock_delay:
    case clock_unsettled:
    case sync_late: return bus_errc::not_synchronized;
    case not_configured: return bus_errc::needs_cycles;
    case mailbox_full: return bus_errc::not_taken;
    case mailbox_timeout: return bus_errc::no_answer;
    case busy:
    case mailbox_error: return bus_errc::refused;
    case unexpected_reply:
    case toggle_bit:
    case fragment_missing: return bus_errc::malformed_answer;
    case sdo_abort:
    case clear_refused:
        if (error.abort == ethercat::abort_code::none) return bus_errc::refused;
        return error.abort;
    case size_mismatch: return bus_errc::wrong_size;
    case data_too_long: return bus_errc::too_large;
    }
    return bus_errc::refused;
}

inline std::string name_of(const slave_info& slave) {
    if (!slave.configured_name.empty())
        return "slave \"" + slave.configured_name + "\" at position " + std::to_string(slave.position);
    auto name = "slave " + std::to_string(slave.position);
    if (!slave.name.empty()) name += " (" + slave.name + ")";
    return name;
}

inline void identify(bus_slave& slave, const ethercat::slave_record& record) noexcept {
    auto& info = slave.info;
    info.station = record.station;
    info.vendor = record.identity.vendor;
    info.product = record.identity.product;
    info.revision = record.identity.revision;
    info.serial = record.identity.serial;
    info.has_objects = record.mailbox.coe && record.mailbox.receive_size != 0;
    slave.is_identified = true;
}

/// Slaves that are to be brought up at once.
class bring_ups {
  public:
    void add(std::uint16_t position, std::uint16_t station) {
        places_.emplace_back(ethercat::bring_up{.position = position, .station = station});
    }
    [[nodiscard]] bool empty() const noexcept { return places_.empty(); }
    [[nodiscard]] bool start(ethercat::master& master) {
        return master.start(ethercat::bring_up_all{places_}).has_value();
    }
    /// Why it is not; ok if it is, or was not among them.
    [[nodiscard]] ethercat::master_error error_at(std::uint16_t position) const noexcept {
        const auto found = std::ranges::find(places_, position, [](const auto& each) { return each.slave.position; });
        return found == places_.end() ? ethercat::master_error{} : found->error;
    }

  private:
    std::vector<ethercat::bring_up_place> places_{};
};

/// Brings a slave up and reads its alias and its name.
class slave_identification {
  public:
    slave_identification() = default;
    /// Another slave than `required` is not brought up.
    slave_identification(std::uint16_t position, std::uint16_t station, const ethercat::identity_check& required)
        : required_{required} {
        found.info.position = position;
        found.info.station = station;
    }

    /// Of one that was brought up with others, with this outcome.
    slave_identification(std::uint16_t position, std::uint16_t station, const ethercat::master& master,
                         const ethercat::master_error& why)
        : slave_identification{position, station, {}} {
        error = error_of(why);
        step_ = error ? step::done : step::alias;
        if (const auto* const record = master.find(station); record != nullptr && !error) take(*record);
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
        if (!is_brought_up_ && new_.empty())
            for (std::uint16_t i = 0; i != count_; ++i)
                if (const auto* const known = bus.at_position(i); known == nullptr || !known->info.is_served)
                    new_.add(i, station_at(i));
        if (!is_brought_up_ && !new_.empty()) return new_.start(master);
        is_brought_up_ = true;
        for (;;) {
            if (is_identifying_ && one_.begin(bus, master)) return true;
            if (std::exchange(is_identifying_, false)) keep(bus);
            if (found_.size() == count_) break;
            const auto position = static_cast<std::uint16_t>(found_.size());
            const auto* const known = bus.at_position(position);
            if (known == nullptr || !known->info.is_served)
                one_ = {position, station_at(position), master, new_.error_at(position)};
            else if (known->is_identified && !known->info.is_lost)
                one_ = slave_identification{*known};
            else { // it is brought up by its bridge
                found_.push_back(*known);
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
        if (is_brought_up_) return one_.end(bus, master);
        if (const auto error = error_of(master.error())) return fail(error);
        if (is_counted_) {
            is_brought_up_ = true;
            return;
        }
        is_counted_ = true;
        const std::size_t counted = is_serving_ ? master.result<ethercat::exchange_datagram>().value_or(0)
                                                : master.result<ethercat::scan>().value_or(0);
        if (counted == 0) return fail(bus_errc::no_slaves);
        if (counted > bus_state::max_slaves) return fail(bus_errc::too_many_slaves);
        count_ = static_cast<std::uint16_t>(counted);
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

    [[nodiscard]] static std::uint16_t station_at(std::uint16_t position) noexcept {
        return static_cast<std::uint16_t>(bus_state::first_station + position);
    }

    operation_ptr<> done_;
    bool is_serving_{}, is_counted_{}, is_brought_up_{};
    std::array<std::byte, 1> type_{};
    std::uint16_t count_{};
    bring_ups new_{};
    bool is_identifying_{};
    slave_identification one_{};
    std::vector<bus_slave> found_{};
    error_code error_{};
};

/// Finds the slaves of a bus whose options name them: those that have come, gone or moved, or all.
class find_job final : public bus_job {
  public:
    enum class scope : std::uint8_t {
        changes,
        once, ///< all, unless they are known
        all,
    };
    find_job(scope what, operation_ptr<> done) : what_{what}, done_{std::move(done)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        for (;;) switch (step_) {
            case step::clear:
                if (what_ == scope::once && bus.is_started()) return fail({}), false;
                step_ = step::locate;
                if (what_ == scope::changes || (bus.is_serving() && bus.ring().is_cleared())) break;
                step_ = step::clear; // a scan would reset slaves that work
                return master.start(ethercat::scan{}).has_value();
            case step::locate: return master.start(ethercat::locate_slaves{unknown_}).has_value();
            case step::bring_up:
                if (!ups_.empty()) return ups_.start(master);
                step_ = step::name;
                break;
            case step::name:
                if (is_identifying_ && one_.begin(bus, master)) return true;
                if (std::exchange(is_identifying_, false)) keep(bus);
                if (next_ == new_.size()) {
                    step_ = step::identify;
                    break;
                }
                one_ = {new_[next_].first, new_[next_].second, master, ups_.error_at(new_[next_].first)};
                is_identifying_ = true;
                ++next_;
                break;
            case step::identify:
                step_ = step::prepare;
                if (!places_.empty()) {
                    step_ = step::identify;
                    return master.start(ethercat::identify_all{places_, bus.names().has_identification()}).has_value();
                }
                bus.match_names();
                break;
            case step::prepare: {
                const auto* const next = bus.next_to_prepare();
                if (next == nullptr) {
                    bus.set_started();
                    return fail(bus.first_refusal()), false;
                }
                station_ = next->info.station;
                const auto& is = next->info;
                const auto wanted = next->named->station == 0 ? station_ : next->named->station;
                writes_ = next->is_brought_up && station_ == wanted;
                if (writes_)
                    return master
                        .start(ethercat::run_init_commands{station_, next->named->start_up,
                                                           ethercat::state_transition::pre_op_to_safe_op})
                        .has_value();
                return master
                    .start(ethercat::bring_up{
                        next->info.position, wanted, {is.vendor, is.product, is.revision, is.serial}})
                    .has_value();
            }
            case step::done: return false;
            }
    }
    void end(bus_state& bus, ethercat::master& master) override {
        const auto error = error_of(master.error());
        if (error == bus_errc::no_reply || error == bus_errc::not_sent) bus.note_all_lost(error);
        if (error == bus_errc::no_reply || error == bus_errc::not_sent || error == bus_errc::stopped)
            return fail(error);
        switch (step_) {
        case step::clear:
            if (error) return fail(error);
            bus.forget_found();
            step_ = step::locate;
            return;
        case step::locate: return located(bus, master, error);
        case step::bring_up:
            if (error) return fail(error);
            step_ = step::name;
            return;
        case step::name: return one_.end(bus, master);
        case step::identify:
            for (const auto& each : places_)
                if (auto* const slave = bus.at(each.station)) {
                    slave->identity = each.is;
                    slave->is_identified = each.error == ethercat::master_error{};
                    if (!slave->is_identified) bus.note_unprepared(*slave, error_of(each.error));
                }
            places_.clear();
            return;
        case step::prepare: return prepared(bus, master, error);
        case step::done: return;
        }
    }
    [[nodiscard]] bool is_over() const override { return step_ == step::done || (done_ && done_->is_done()); }
    void fail(error_code why) override {
        step_ = step::done;
        if (done_) done_->complete(why);
    }

  private:
    enum class step : std::uint8_t { clear, locate, bring_up, name, identify, prepare, done };

    void located(bus_state& bus, const ethercat::master& master, error_code error) {
        if (error) return fail(error);
        const auto found = *master.result<ethercat::locate_slaves>();
        if (what_ != scope::changes && found.slaves == 0) return fail(bus_errc::no_slaves);
        if (found.slaves > bus_state::max_slaves) return fail(bus_errc::too_many_slaves);
        new_ = bus.note_positions(master, found.unknown);
        for (const auto& [position, station] : new_) ups_.add(position, station);
        step_ = step::bring_up;
    }
    void keep(bus_state& bus) {
        if (bus.note_brought_up(one_.found, one_.error)) places_.emplace_back(one_.found.info.station);
    }
    void prepared(bus_state& bus, const ethercat::master& master, error_code error) {
        auto* const slave = bus.at(station_);
        if (slave == nullptr) return;
        if (error) {
            const auto& objects = slave->named->start_up;
            if (const auto at = master.error().command; writes_ && at < objects.size() && slave->why != error)
                bus.log(name_of(slave->info) + " does not take its start-up object " +
                        numbered("%04Xh:", objects[at].index) + std::to_string(objects[at].subindex));
            return bus.note_unprepared(*slave, error);
        }
        if (!writes_) {
            if (slave->named->station != 0) slave->info.station = slave->named->station;
            slave->is_brought_up = true;
            return;
        }
        bus.note_prepared(*slave, what_ != scope::changes);
    }

    scope what_;
    operation_ptr<> done_;
    step step_{};
    std::array<std::uint16_t, bus_state::max_slaves> unknown_{};
    std::vector<std::pair<std::uint16_t, std::uint16_t>> new_{}; ///< positions, and the station addresses that they get
    bring_ups ups_{};
    std::size_t next_{};
    bool is_identifying_{};
    slave_identification one_{};
    std::vector<ethercat::identify_place> places_{};
    std::uint16_t station_{}; ///< of the slave that is prepared
    bool writes_{};           ///< its start-up objects; else it is brought up
};

/// Looks at the state of a slave, collects its emergencies, and brings it up again after it was reset.
class look_job final : public bus_job {
  public:
    explicit look_job(std::uint16_t station) : station_{station} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        const auto* const slave = bus.at(station_);
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
        auto* const slave = bus.at(station_);
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
        if (error == bus_errc::slave_lost && bus.names().empty()) {
            ethercat::identity_check required{};
            const auto& info = slave.info;
            if (slave.is_identified) required = {info.vendor, info.product, info.revision, info.serial};
            one_ = {info.position, station_, required};
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
        auto* const slave = bus.at(station_);
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

    std::uint16_t station_{};
    step step_{};
    slave_identification one_{};
};

/// One job of the master for a slave. `make(slave)` gives that job, `take(value, done)` completes the operation.
template <class Make, class Take, class... Results> class slave_job final : public bus_job {
    using job_type = std::invoke_result_t<Make&, bus_slave&>;

  public:
    slave_job(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take)
        : which_{which}, done_{std::move(done)}, make_{std::move(make)}, take_{std::move(take)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        error_code error;
        auto* const slave = bus.find(which_, error);
        if (slave == nullptr) {
            fail(error);
            return false;
        }
        station_ = slave->info.station;
        return master.start(make_(*slave)).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        const auto outcome = master.result<job_type>();
        const auto error = outcome ? error_code{} : error_of(outcome.error());
        if (auto* const slave = bus.at(station_)) {
            bus.note_outcome(*slave, error);
            bus.note_emergencies(*slave, master);
        }
        if (error) return fail(error);
        if constexpr (std::is_void_v<typename job_type::result_type::value_type>)
            take_(*done_);
        else
            take_(*outcome, *done_);
    }
    [[nodiscard]] bool is_over() const override { return done_->is_done(); }
    void fail(error_code why) override { done_->complete(why, Results{}...); }

  private:
    slave_choice which_;
    operation_ptr<Results...> done_;
    Make make_;
    Take take_;
    std::uint16_t station_{};
};

/// Takes a slave to a state, and configures its process data before SAFE-OP.
class change_job final : public bus_job {
  public:
    change_job(const slave_choice& which, ethercat::al_state goal, operation_ptr<> done)
        : which_{which}, goal_{goal}, done_{std::move(done)} {}
    change_job(std::uint16_t station, ethercat::al_state goal, operation_ptr<> done)
        : goal_{goal}, done_{std::move(done)}, station_{station} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        error_code error = bus_errc::no_such_slave;
        auto* const slave = station_ != 0 ? bus.at(station_) : bus.find(which_, error);
        if (slave == nullptr) return fail(error), false;
        if (slave->info.is_served) return fail(bus_errc::served), false;
        if (goal_ == ethercat::al_state::op) return fail(bus_errc::needs_cycles), false;
        const auto station = station_ = slave->info.station;
        if (goal_ != ethercat::al_state::safe_op || slave->is_configured) {
            step_ = step::change;
            return master.start(ethercat::change_state{station, goal_}).has_value();
        }
        if (step_ == step::look) return master.start(ethercat::check{station}).has_value();
        if (step_ == step::configure) return master.start(ethercat::configure{station}).has_value();
        return master.start(ethercat::change_state{station, ethercat::al_state::pre_op}).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        auto* const slave = bus.at(station_);
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

    slave_choice which_{};
    ethercat::al_state goal_;
    operation_ptr<> done_;
    step step_{};
    std::uint16_t station_{};
};

/// Shows the frames that it passes on.
class shown_link final : public net::any_link {
  public:
    shown_link(std::unique_ptr<net::any_link> link, const bus_state& to) : link_{std::move(link)}, to_{to} {}

    bool send(std::span<const std::byte> frame) override {
        to_.show_frame(frame, true);
        return link_->send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, duration timeout) override {
        const auto size = link_->receive(buffer, timeout);
        if (size != 0) to_.show_frame(buffer.first(size), false);
        return size;
    }
    int native_handle() override { return link_->native_handle(); }
    [[nodiscard]] const std::string& problem() const override { return link_->problem(); }

  private:
    std::unique_ptr<net::any_link> link_;
    const bus_state& to_;
};

/// An operation whose outcome nobody waits for.
struct unheard final : operation<> {
    void deliver(error_code) override {}
};

// System time of distributed clocks, ns since 2000-01-01, when net::now() was 0; the same for all of this program.
inline std::uint64_t system_time_at_zero() {
    using std::chrono::system_clock, std::chrono::nanoseconds;
    static const std::uint64_t time = [] {
        constexpr std::chrono::sys_days epoch{std::chrono::year{2000} / std::chrono::January / 1};
        const nanoseconds since = system_clock::now() - epoch;
        return static_cast<std::uint64_t>((since - net::now().time_since_epoch()).count());
    }();
    return time;
}

inline bridging::bridge_options timing_of(const bus_options& options) {
    bridging::bridge_options timing{};
    timing.master = {.frame_timeout = options.frame_timeout,
                     .frames_may_be_copied = options.frames_may_be_copied,
                     .retries = options.frame_retries};
    timing.download = {.clear_subindex_0 = options.clear_subindex_0};
    timing.system_time = system_time_at_zero();
    return timing;
}

JAUSCAT_DECL bus_state::bus_state(boost::asio::io_context& context, std::string_view where, bus_options options)
    : context_{context},
      where_{options.name.empty() ? std::string{where} : options.name},
      options_{std::move(options)},
      link_{net::open_link(where)},
      timing_{timing_of(options_)},
      memory_(max_object_size),
      named_{options_.slaves} {
    if (options_.on_frame) link_ = std::make_unique<shown_link>(std::move(link_), *this);
}
JAUSCAT_DECL bus_state::~bus_state() { close(); }

JAUSCAT_DECL void bus_state::log(std::string_view line) const {
    auto whole = where_ + ": " + std::string{line};
    if (!is_own_thread()) return write_line(whole);
    boost::asio::post(context_, [weak = weak_from_this(), text = std::move(whole)] {
        if (const auto self = weak.lock()) self->write_line(text);
    });
}
JAUSCAT_DECL void bus_state::write_line(const std::string& line) const {
    try {
        if (options_.log)
            options_.log(line);
        else
            std::cerr << line + "\n";
    } catch (...) { // of the application's log: frames are under way
    }
}

template <class F, class... Arguments> void bus_state::call_later(F bus_state::* function, Arguments... arguments) {
    if (!(this->*function)) return;
    boost::asio::post(context_, [weak = weak_from_this(), function, arguments...] {
        const auto self = weak.lock();
        if (!self) return;
        auto lock = self->lock();
        if (self->is_closed_) return;
        const auto call = (*self).*function; // it may end the bus
        lock.unlock();
        if (call) call(arguments...);
    });
}

// ---- The queue.

JAUSCAT_DECL void bus_state::open() {
    if (ring_) return;
    ring_ = std::make_unique<ring_type>(timing_);
    ring_->share({.begin = jaus::bound<&bus_state::begin_job>(*this),
                  .done = jaus::bound<&bus_state::end_job>(*this),
                  .cycle = jaus::bound<&bus_state::run_cycle>(*this)});
    if (options_.thread) {
        try {
            thread_ = std::make_unique<ring_thread>(*link_, *ring_, output_, mutex_, [this] {
                look_at_link();
                return look_at_time();
            });
        } catch (...) {
            ring_.reset(); // opened anew by the next operation
            throw;
        }
        work_.emplace(context_.get_executor());
        if (options_.priority == 0) return;
        if (const auto problem = thread_->set_priority(options_.priority); !problem.empty())
            log("the bus works without the priority " + std::to_string(options_.priority) + ": " + problem);
        return;
    }
    runner_.emplace(context_, *link_, *ring_, output_);
    const auto look = [this] {
        if (const auto next = look_at_time(); next != time_point::max()) timer_->arm(next);
    };
    runner_->after_turn = [this, look] {
        look_at_link();
        look();
    };
    timer_.emplace(context_, [this, look] {
        look();
        wake();
    });
    runner_->start();
}
JAUSCAT_DECL void bus_state::wake() {
    if (thread_) thread_->wake()();
    if (runner_) runner_->wake()();
}

JAUSCAT_DECL void bus_state::add(std::unique_ptr<bus_job> job, duration limit) {
    const auto locked = lock();
    if (is_closed_) return job->fail(boost::asio::error::operation_aborted);
    open();
    job->limit = limit;
    queue_.push_back(std::move(job));
    wake();
}

JAUSCAT_DECL bool bus_state::begin_job(ethercat::master& master) {
    const auto now = net::now();
    for (;;) {
        if (!current_) current_ = next_job(now);
        if (!current_) return false;
        if (!current_->is_over() && current_->begin(*this, master)) return true;
        current_.reset();
    }
}
JAUSCAT_DECL void bus_state::end_job(ethercat::master& master) {
    if (current_) current_->end(*this, master);
}

/// Operations and looks at slaves alternate where both wait.
JAUSCAT_DECL std::unique_ptr<bus_job> bus_state::next_job(time_point now) {
    std::erase_if(queue_, [](const auto& each) { return each->is_over(); });
    if (finds_changes() && next_find_ <= now && (queue_.empty() || !looked_last_)) {
        looked_last_ = true;
        next_find_ = now + options_.check_interval;
        return std::make_unique<find_job>(find_job::scope::changes, nullptr);
    }
    bus_slave* seen_last{};
    if (options_.check_interval > duration{} && is_started_)
        for (auto& each : slaves_)
            if (is_watched(each) && each.next_look <= now && (!seen_last || each.next_look < seen_last->next_look))
                seen_last = &each;
    const bool looks = seen_last != nullptr && (queue_.empty() || !looked_last_);
    looked_last_ = looks;
    if (looks) {
        seen_last->next_look = now + options_.check_interval;
        return std::make_unique<look_job>(seen_last->info.station);
    }
    if (queue_.empty()) return nullptr;
    auto next = std::move(queue_.front());
    queue_.pop_front();
    next->due = deadline{now, next->limit}.at();
    return next;
}

JAUSCAT_DECL time_point bus_state::look_at_time() {
    const auto now = net::now();
    auto next = time_point::max();
    std::erase_if(queue_, [](const auto& each) { return each->is_over(); });
    if (current_ && current_->due <= now) current_->fail(bus_errc::timed_out);
    if (current_ && current_->is_over()) {
        if (!ring_->cancel_shared()) current_.reset();
        wake(); // it ends, or the next one begins
    }
    look_at_operated(now);
    if (current_) next = current_->due;
    if (options_.check_interval > duration{} && is_started_ && !current_)
        for (const auto& each : slaves_)
            if (is_watched(each)) next = std::min(next, std::max(each.next_look, now + std::chrono::milliseconds{1}));
    if (finds_changes() && !current_) next = std::min(next, std::max(next_find_, now + std::chrono::milliseconds{1}));
    return next;
}

JAUSCAT_DECL void bus_state::look_at_link() {
    if (const auto& now = link_->problem(); !now.empty() && now != problem_) {
        problem_ = now;
        tell_fault(link_fault::no_frames, problem_);
    }
    const auto seen = ring_->statistics();
    if (seen.foreign != 0 && !std::exchange(has_seen_master_, true))
        tell_fault(link_fault::second_master, "frames of another master are on this link; only one may use it");
    if (seen.circulated != 0 && !std::exchange(has_seen_gap_, true))
        tell_fault(link_fault::broken_ring, "frames return marked as circulating: a cable between two slaves is out");
}
JAUSCAT_DECL void bus_state::tell_fault(link_fault what, std::string_view line) const {
    log(line);
    if (!options_.on_fault) return;
    if (!is_own_thread()) return options_.on_fault(what, line);
    boost::asio::post(context_, [weak = weak_from_this(), what, text = std::string{line}] {
        const auto self = weak.lock();
        if (!self) return;
        auto lock = self->lock();
        if (self->is_closed_) return;
        lock.unlock();
        self->options_.on_fault(what, text);
    });
}
JAUSCAT_DECL void bus_state::show_frame(std::span<const std::byte> frame, bool is_sent) const {
    options_.on_frame({.bytes = frame, .is_sent = is_sent, .is_keep_alive = ring_ && ring_->keeps_alive()});
}

JAUSCAT_DECL void bus_state::abort_all(error_code why) {
    auto all = std::exchange(queue_, {});
    for (const auto& each : all) each->fail(why);
    if (current_) current_->fail(why);
}
JAUSCAT_DECL void bus_state::cancel() {
    const auto locked = lock();
    abort_all(boost::asio::error::operation_aborted);
    if (ring_) static_cast<void>(look_at_time());
}
JAUSCAT_DECL void bus_state::stop() noexcept {
    const auto attempt = [](auto&& work) {
        try {
            work();
        } catch (...) { // no memory to tell of it: the rest must be done
        }
    };
    {
        const auto locked = lock();
        attempt([&] { abort_all(boost::asio::error::operation_aborted); });
        for (auto* const user : users_) user->was_up = user->front().up();
        auto kept = std::exchange(on_cycle, nullptr); // what it refers to may be gone; nothing moves from now on
        attempt([&] {
            if (ring_) bring_to_rest(users_);
        });
        on_cycle.swap(kept);
        end_operations();
        for (auto* const user : std::exchange(users_, {})) user->bus_ends();
        current_.reset();
        is_started_ = false;
        attempt([&] {
            if (runner_) runner_->stop();
        });
    }
    if (thread_) thread_->stop(); // without the lock, which it waits for
    thread_.reset();
    work_.reset();
    runner_.reset();
    timer_.reset();
    ring_.reset();
    slaves_.clear();
}
JAUSCAT_DECL void bus_state::close() noexcept {
    {
        const auto locked = lock();
        if (std::exchange(is_closed_, true)) return;
    }
    stop();
    link_.reset();
    on_cycle = nullptr;
    on_lost = nullptr;
    on_found = nullptr;
    on_changed = nullptr;
    on_emergency = nullptr;
}

// ---- The slaves.

JAUSCAT_DECL std::vector<slave_info> bus_state::infos() const {
    const auto locked = lock();
    std::vector<slave_info> all;
    for (const auto& each : slaves_) all.push_back(each.info);
    return all;
}
JAUSCAT_DECL bus_slave* bus_state::at(std::uint16_t station) {
    const auto found =
        std::ranges::find_if(slaves_, [=](const bus_slave& each) { return each.info.station == station; });
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bus_slave* bus_state::at_position(std::uint16_t position) {
    const auto found = std::ranges::find_if(
        slaves_, [=](const bus_slave& each) { return each.info.position == position && !each.is_absent; });
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bus_slave* bus_state::find(const slave_choice& which, error_code& error) {
    const auto is_same = [](const auto& required, auto value) { return !required || *required == value; };
    const auto& id = which.identity;
    const auto* const name = named(which);
    error = is_started_ ? bus_errc::no_such_slave : bus_errc::not_started;
    if (is_started_ && name != nullptr && name->why) {
        error = name->why;
        return nullptr;
    }
    bus_slave* found{};
    for (auto& each : slaves_) {
        const auto& info = each.info;
        if (name != nullptr && each.named != name) continue;
        if (which.position && (each.is_absent || !is_same(which.position, info.position))) {
            if (name != nullptr) error = bus_errc::wrong_slave;
            continue;
        }
        const bool is_as_required = is_same(which.alias, info.alias) &&
                                    (which.name.empty() || name != nullptr || which.name.view() == info.name) &&
                                    is_same(id.vendor, info.vendor) && is_same(id.product, info.product) &&
                                    is_same(id.revision, info.revision) && is_same(id.serial, info.serial);
        if (!is_as_required) {
            if (which.position) error = bus_errc::wrong_slave;
            continue;
        }
        if (found != nullptr) {
            error = bus_errc::ambiguous;
            return nullptr;
        }
        found = &each;
    }
    if (found != nullptr) error = {};
    return found;
}

JAUSCAT_DECL void bus_state::note_lost(bus_slave& slave, error_code why) {
    const bool is_known = std::exchange(slave.info.is_lost, true);
    if (is_known && slave.why == why) return;
    slave.why = why;
    slave.is_configured = false;
    log(name_of(slave.info) + (is_known ? " is still lost: " : " is lost: ") + why.message());
    if (!is_known) call_later(&bus_state::on_lost, slave.info, why);
}
JAUSCAT_DECL void bus_state::note_all_lost(error_code why) {
    for (auto& each : slaves_)
        if (!each.info.is_served && !each.info.is_lost) note_lost(each, why);
}
JAUSCAT_DECL void bus_state::note_found(bus_slave& slave) {
    if (!is_trusted(slave)) return;
    if (!std::exchange(slave.info.is_lost, false)) return;
    slave.why = {};
    problem_.clear();
    log(name_of(slave.info) + " answers again");
    call_later(&bus_state::on_found, slave.info);
}
JAUSCAT_DECL void bus_state::note_outcome(bus_slave& slave, error_code error) {
    if (slave.info.is_served || error == bus_errc::stopped) return;
    if (error == bus_errc::no_reply || error == bus_errc::not_sent) return note_all_lost(error);
    if (error == bus_errc::slave_lost)
        note_lost(slave, error);
    else if (error != bus_errc::no_objects)
        note_found(slave);
}
JAUSCAT_DECL void bus_state::note_state(bus_slave& slave, const ethercat::al_status& al) {
    const auto before = std::exchange(slave.al, al);
    if (before.state == al.state && before.error == al.error && (!al.error || before.code == al.code)) return;
    if (al.state == ethercat::al_state::init) slave.is_configured = false;
    if (al.error) log(name_of(slave.info) + " has an error: " + make_error_code(al.code).message());
    call_later(&bus_state::on_changed, slave.info, al);
}
JAUSCAT_DECL void bus_state::note_emergencies(bus_slave& slave, ethercat::master& master) {
    const auto* const record = master.find(slave.info.station);
    if (record == nullptr || slave.info.is_served) return;
    for (const auto& each : record->emergencies.kept()) note_emergency(slave, each);
    if (record->emergencies.overflow()) log(name_of(slave.info) + " has reported more emergencies than are kept");
    master.clear_emergencies(slave.info.station);
}
JAUSCAT_DECL void bus_state::note_emergency(const bus_slave& slave, const ethercat::coe_emergency& emergency) {
    log(name_of(slave.info) + " reports an emergency: " + numbered("%04Xh", emergency.error_code) +
        numbered(", error register %02Xh", emergency.error_register));
    call_later(&bus_state::on_emergency, slave.info, emergency);
}

// ---- Named slaves.

JAUSCAT_DECL bool bus_state::finds_changes() const noexcept {
    return is_started_ && !named_.empty() && options_.check_interval > duration{};
}
JAUSCAT_DECL bool bus_state::is_trusted(const bus_slave& slave) const noexcept {
    const bool is_refused = slave.named == nullptr && slave.last_name != nullptr;
    return named_.empty() || (slave.is_prepared && !slave.is_absent && !is_refused);
}
JAUSCAT_DECL bool bus_state::is_watched(const bus_slave& slave) const noexcept {
    return !slave.info.is_served && is_trusted(slave);
}
JAUSCAT_DECL void bus_state::sort_slaves() {
    std::ranges::stable_sort(slaves_, {}, [](const bus_slave& each) { return each.info.position; });
}
JAUSCAT_DECL bus_slave* bus_state::slave_of(const named_slave& which) noexcept {
    const auto found = std::ranges::find(slaves_, &which, &bus_slave::named);
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bool bus_state::await(named_slave& which, bus_user& user, std::uint16_t station) {
    if (which.user != nullptr && which.user != &user) return false;
    which.user = &user;
    auto* const slave = slave_of(which);
    if (std::exchange(which.station, station) != station && slave != nullptr) slave->is_prepared = false;
    if (slave != nullptr && is_watched(*slave) && !slave->info.is_lost) user.slave_ready();
    next_find_ = {};
    wake();
    return true;
}
JAUSCAT_DECL void bus_state::forget(const bus_user& user) noexcept {
    for (auto& each : named_.all())
        if (each.user == &user) each.user = nullptr;
}
JAUSCAT_DECL void bus_state::forget_found() {
    std::erase_if(slaves_, [](const bus_slave& each) { return !each.info.is_served; });
}
/// Returns the positions of slaves that are to be brought up, and the station addresses for it.
JAUSCAT_DECL std::vector<std::pair<std::uint16_t, std::uint16_t>>
bus_state::note_positions(const ethercat::master& master, std::span<const std::uint16_t> unknown) {
    const auto now = net::now();
    const auto is_unknown = [&](std::uint16_t position) { return std::ranges::count(unknown, position) != 0; };
    std::erase_if(slaves_, [&](const bus_slave& each) {
        return !each.is_identified && !each.info.is_served && !is_unknown(each.info.position);
    });
    for (auto& each : slaves_) {
        const auto* const record = master.find(each.info.station);
        const bool is_absent = record == nullptr || record->position == ethercat::slave_record::no_position;
        if (!each.is_identified) continue;
        if (std::exchange(each.is_absent, is_absent) != is_absent) is_match_due_ = true;
        if (is_absent && !each.info.is_served) note_lost(each, bus_errc::slave_lost);
        if (is_absent || record->position == each.info.position) continue;
        is_match_due_ = true;
        const auto before = std::exchange(each.info.position, record->position);
        log(name_of(each.info) + " was at position " + std::to_string(before));
    }
    std::vector<std::pair<std::uint16_t, std::uint16_t>> made;
    for (const auto position : unknown) {
        const auto failed = std::ranges::find_if(slaves_, [=](const bus_slave& each) {
            return each.info.position == position && !each.is_identified && !each.info.is_served;
        });
        if (failed == slaves_.end())
            made.emplace_back(position, next_station_++);
        else if (failed->next_try <= now)
            made.emplace_back(position, failed->info.station);
    }
    for (const auto& each : master.slaves()) // those that were not identified
        if (each.position != ethercat::slave_record::no_position && at(each.station) == nullptr)
            made.emplace_back(each.position, each.station);
    sort_slaves();
    return made;
}
JAUSCAT_DECL bool bus_state::note_brought_up(const bus_slave& made, error_code why) {
    auto* slave = at(made.info.station);
    if (slave == nullptr) slave = &slaves_.emplace_back();
    const auto before = std::exchange(slave->why, why);
    slave->info = made.info;
    slave->al = made.al;
    slave->is_identified = made.is_identified && !why;
    slave->is_brought_up = true;
    slave->info.is_lost = why.failed();
    slave->next_try = net::now() + timing_.bring_up_interval;
    is_match_due_ = true;
    if (why && why != before) log(name_of(slave->info) + " is not brought up: " + why.message());
    sort_slaves();
    return !why;
}
JAUSCAT_DECL void bus_state::refuse(named_slave& which, error_code why, const bus_slave* by) {
    if (std::exchange(which.why, why) == why) return;
    auto* const slave = slave_of(which);
    if (slave != nullptr) {
        note_lost(*slave, why);
        slave->named = nullptr;
        slave->info.configured_name.clear();
    }
    if (which.entry.is_optional && why == bus_errc::missing_slave) return;
    auto line = "slave \"" + which.entry.name + "\" is refused: " + why.message();
    if (by != nullptr)
        line += " (position " + std::to_string(by->info.position) + ": vendor " + numbered("%Xh", by->info.vendor) +
                ", product " + numbered("%Xh", by->info.product) + ", revision " + numbered("%Xh", by->info.revision) +
                ", serial " + std::to_string(by->info.serial) + ")";
    log(line);
}
JAUSCAT_DECL void bus_state::match_names() {
    if (!std::exchange(is_match_due_, false)) return;
    std::vector<ethercat::found_slave> found;
    std::vector<std::uint16_t> stations;
    for (const auto& each : slaves_) {
        if (each.is_absent || !each.is_identified) continue;
        const auto& info = each.info;
        ethercat::slave_identity is{.identity = {info.vendor, info.product, info.revision, info.serial},
                                    .alias = info.alias != 0 ? info.alias : each.identity.stored_alias,
                                    .device_id = each.identity.device_id};
        found.push_back({.position = each.info.position, .is = is});
        stations.push_back(each.info.station);
    }
    const auto matches = named_.match(std::move(found));
    for (std::size_t i = 0; i != matches.size(); ++i) {
        auto& which = named_.all()[i];
        auto* const known = slave_of(which);
        if (known != nullptr && known->info.is_served) {
            is_match_due_ = is_match_due_ || known->is_absent; // its user is about to lose it
            continue;
        }
        const bool is_there = known != nullptr && !known->is_absent;
        using enum ethercat::slave_match;
        const auto match = matches[i].match;
        auto* const by = match == missing || match == doubled ? nullptr : at(stations[matches[i].at]);
        if (match == missing && known != nullptr && known->is_absent)
            continue; // it is lost
        else if (match == missing)
            refuse(which, bus_errc::missing_slave, nullptr);
        else if (match == doubled)
            refuse(which, bus_errc::doubled_slave, nullptr);
        else if (match == foreign)
            refuse(which, bus_errc::foreign_slave, by);
        else if (match == swapped || (is_there && known != by) || (by->last_name != nullptr && by->last_name != &which))
            refuse(which, bus_errc::swapped_slave, by); // its station address says that it is another one
        else if (known != by && may_be(*by, which, known))
            give_name(*by, which, known);
    }
    std::erase_if(slaves_, [](const bus_slave& each) { return each.info.station == 0; });
    for (auto& each : slaves_) {
        if (each.named != nullptr || each.is_absent || !each.is_identified || is_match_due_) continue;
        if (std::exchange(each.is_prepared, true)) continue;
        log(name_of(each.info) + " is none of the named slaves: it is left as it is");
    }
}
JAUSCAT_DECL bool bus_state::may_be(const bus_slave& slave, const named_slave& which, const bus_slave* before) {
    const auto& entry = which.entry;
    if (before == nullptr || entry.alias || entry.identification || entry.serial) return true;
    const bool is_stranger = slave.is_prepared && slave.last_name == nullptr; // it was beside that one
    return !is_stranger && slave.info.vendor == before->info.vendor && slave.info.product == before->info.product;
}
JAUSCAT_DECL void bus_state::give_name(bus_slave& slave, named_slave& which, bus_slave* before) {
    slave.named = &which;
    slave.last_name = &which;
    slave.info.configured_name = which.entry.name;
    slave.is_prepared = slave.info.is_served;
    which.why = {};
    if (before == nullptr) return;
    slave.info.is_lost = before->info.is_lost;
    slave.why = before->why;
    slave.next_look = before->next_look;
    before->named = nullptr;
    before->info.station = 0; // erased
}
JAUSCAT_DECL bus_slave* bus_state::next_to_prepare() {
    const auto now = net::now();
    const auto found = std::ranges::find_if(slaves_, [=](const bus_slave& each) {
        return each.named != nullptr && !each.is_prepared && !each.is_absent && !each.info.is_served &&
               (each.is_brought_up || each.next_try <= now);
    });
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL void bus_state::note_prepared(bus_slave& slave, bool is_start) {
    auto& which = *slave.named;
    which.why = {};
    which.station = slave.info.station;
    slave.is_prepared = true;
    slave.is_brought_up = false; // is done at the next time
    slave.is_configured = false;
    slave.info.is_lost = false;
    slave.why = {};
    slave.next_try = net::now() + timing_.bring_up_interval;
    problem_.clear();
    log(name_of(slave.info) + " is there");
    if (!is_start) call_later(&bus_state::on_found, slave.info);
    note_state(slave, {.state = ethercat::al_state::pre_op});
    if (which.user != nullptr) which.user->slave_ready();
}
JAUSCAT_DECL void bus_state::note_unprepared(bus_slave& slave, error_code why) {
    slave.is_brought_up = false;
    slave.next_try = net::now() + timing_.bring_up_interval;
    note_lost(slave, why);
}
JAUSCAT_DECL error_code bus_state::first_refusal() {
    for (const auto& each : named_.all()) {
        const auto* const slave = slave_of(each);
        if (each.why && !(each.entry.is_optional && each.why == bus_errc::missing_slave)) return each.why;
        if (slave != nullptr && !slave->info.is_served && slave->info.is_lost && !slave->is_absent) return slave->why;
    }
    return {};
}

// ---- Bridges.

JAUSCAT_DECL void bus_state::add_timing(bridging::bridge_options& timing) {
    const auto locked = lock();
    const auto common = timing_of(options_);
    timing.master.frame_timeout = common.master.frame_timeout;
    timing.master.frames_may_be_copied = common.master.frames_may_be_copied;
    timing.master.retries = common.master.retries;
    timing.download = common.download;
    timings_.push_back(&timing);
    apply_timings();
}
JAUSCAT_DECL void bus_state::release_timing(const bridging::bridge_options& timing) noexcept {
    const auto locked = lock();
    std::erase(timings_, &timing);
    apply_timings();
}
JAUSCAT_DECL void bus_state::apply_timings() noexcept {
    auto all = timing_of(options_);
    const auto shorten = [](duration& time, duration other) {
        if (other > duration{} && (time == duration{} || other < time)) time = other;
    };
    for (const auto* const each : timings_) {
        shorten(all.period, each->period);
        shorten(all.check_interval, each->check_interval);
        shorten(all.master.state_timeout, each->master.state_timeout);
        shorten(all.master.mailbox_timeout, each->master.mailbox_timeout);
    }
    timing_ = all;
    if (ring_) ring_->apply_options();
}

JAUSCAT_DECL std::uint16_t bus_state::reserve_station(std::uint16_t node) {
    const auto is_free = [&](std::uint16_t station) { return std::ranges::count(stations_, station) == 0; };
    constexpr std::uint16_t last_node = 254;
    auto station = node;
    if (!is_free(station)) station = last_node;
    while (station != 0 && !is_free(station)) --station;
    if (station == 0) station = last_node + 2; // is no JAUS node: for process data
    while (!is_free(station)) ++station;
    stations_.push_back(station);
    return station;
}
JAUSCAT_DECL std::string bus_state::join(bus_user& user) {
    const auto locked = lock();
    if (is_closed_) return "the bus has ended";
    auto& front = user.front();
    const auto position = front.options().position;
    auto* slave = front.options().is_taken_over ? at(front.station()) : at_position(position);
    if (slave != nullptr && slave->info.is_served) return "another bridge serves it";
    open();
    if (!ring_->add(front)) return "the bus has " + std::to_string(max_slaves) + " slaves already";
    users_.push_back(&user);
    if (slave == nullptr) {
        slaves_.emplace_back().info.position = position;
        sort_slaves();
        slave = at_position(position);
    }
    slave->info.station = front.station();
    slave->info.is_served = true;
    slave->info.is_lost = !front.options().is_taken_over;
    front.on_work(thread_ ? thread_->wake() : runner_->wake());
    wake();
    return {};
}
JAUSCAT_DECL void bus_state::leave(const bus_user& user) noexcept {
    const auto locked = lock();
    const auto found = std::ranges::find(users_, &user);
    if (found == users_.end()) return;
    auto& front = (*found)->front();
    users_.erase(found);
    front.on_work({});
    ring_->remove(front, net::now());
    if (auto* const slave = at(front.station())) slave->info.is_served = false; // it is watched from now on
    is_match_due_ = true;
}
JAUSCAT_DECL void bus_state::send(std::span<const std::byte> message) {
    const auto node = jaus::split(message).header.source.node;
    for (auto* const user : users_)
        if (user->node() == node) return user->send(message);
}

JAUSCAT_DECL void bus_user::begin_rest(time_point now, jaus::message_sink out) {
    for (auto* const unit : front().components()) unit->shut_down(now, out);
}
JAUSCAT_DECL bool bus_user::awaits_rest() const {
    return front().up() &&
           std::ranges::any_of(front().components(), [](const auto* unit) { return unit->stops().stop_is_pending(); });
}
JAUSCAT_DECL void bus_state::bring_to_rest(std::span<bus_user* const> users) {
    const auto locked = lock();
    constexpr duration longest = std::chrono::milliseconds{700}; // Ctrl-C ends a program within a second
    for (auto* const user : users) user->begin_rest(net::now(), output_);
    drive([&] { return std::ranges::none_of(users, &bus_user::awaits_rest); }, longest);
}
JAUSCAT_DECL void bus_state::drive(const std::function<bool()>& is_done, duration limit) {
    std::array<std::byte, ethercat::max_frame_size> frame{};
    const deadline end{net::now(), limit};
    while (!is_done() && !end.is_reached(net::now())) {
        ring_->on_time(net::now(), output_);
        while (const auto size = ring_->next_frame(frame, net::now())) {
            if (link_->send(std::span{frame}.first(size))) continue;
            ring_->not_sent();
            ring_->on_time(net::now(), output_);
        }
        const auto wake = std::min(ring_->next_event().value_or(end.at()), end.at());
        const auto size = link_->receive(frame, std::max(wake - net::now(), duration{}));
        if (size != 0) ring_->on_frame(std::span{frame}.first(size), net::now(), output_);
    }
}

JAUSCAT_DECL void bus_state::note_served(bus_user& user, const ethercat::slave_record& record) {
    auto* const slave = at(user.front().station());
    if (slave == nullptr) return;
    identify(*slave, record);
    slave->info.is_lost = false;
    slave->why = {};
    problem_.clear();
}
JAUSCAT_DECL void bus_state::note_clocks(ethercat::clock_agreement how, std::uint32_t difference) {
    using enum ethercat::clock_agreement;
    if (std::exchange(clocks_, how) == how) return; // each of the slaves tells it
    if (how == good) return log("the distributed clocks agree again");
    log("the distributed clocks differ by up to " + std::to_string(difference) +
        " ns: check for lost frames (jauscat-ecat monitor), and the slaves' clocks");
}
JAUSCAT_DECL void bus_state::note_served_lost(bus_user& user, error_code why) {
    auto* const slave = at(user.front().station());
    if (slave == nullptr) return;
    slave->info.is_lost = true;
    slave->why = why;
    slave->is_prepared = false;
}

// ---- Slaves in operation.

inline bridging::bridge_options timing_of(const operate_options& options) {
    using std::chrono::milliseconds;
    const auto period = options.period;
    const auto watchdog =
        options.watchdog == duration{} ? std::max<duration>(milliseconds{100}, 4 * period) : options.watchdog;
    const auto timeout =
        options.timeout == duration{} ? std::max<duration>(milliseconds{50}, 2 * period) : options.timeout;
    if (period <= duration{}) throw std::invalid_argument{"async_operate: the period is more than 0"};
    if (watchdog < 2 * period || watchdog > milliseconds{6500})
        throw std::invalid_argument{"async_operate: the watchdog is 2 periods to 6.5 s"};
    if (timeout < 2 * period) throw std::invalid_argument{"async_operate: the timeout is at least 2 periods"};
    return {.period = period, .watchdog = watchdog, .longest_silence = timeout, .check_interval = period};
}

inline std::optional<ethercat::sync_settings> sync_of(const bus_slave& which, const operate_options& options) {
    if (options.sync) return options.sync;
    return sync_of(which.named);
}

JAUSCAT_DECL operated_slave::operated_slave(bus_state& on, const bus_slave& which, const operate_options& options,
                                            operation_ptr<> done)
    : bus_{on},
      done_{std::move(done)},
      due_{deadline{net::now(), on.options().timeout + (sync_of(which, options) ? clock_time : duration{})}.at()},
      timing_{timing_of(options)},
      front_{{.position = which.info.position,
              .identity = {.station = which.info.station},
              .cyclic = true,
              .sync = sync_of(which, options).value_or(ethercat::sync_settings{}),
              .is_taken_over = true},
             exchange_,
             timing_,
             memory_,
             {.slave_up = jaus::bound<&operated_slave::slave_up>(*this),
              .slave_lost = jaus::bound<&operated_slave::slave_lost>(*this),
              .slave_emergency = jaus::bound<&operated_slave::slave_emergency>(*this),
              .clocks_agree = jaus::bound<&operated_slave::clocks_agree>(*this)}} {
    bus_.add_timing(timing_);
}
JAUSCAT_DECL operated_slave::~operated_slave() { bus_.release_timing(timing_); }

JAUSCAT_DECL std::optional<bridging::slave_data> operated_slave::data() const {
    if (!front_.up() || resting_since_) return std::nullopt;
    return front_.data();
}
JAUSCAT_DECL void operated_slave::end(ethercat::al_state goal, operation_ptr<> done) {
    const auto replaced = std::exchange(done_, std::move(done));
    if (replaced) replaced->complete(boost::asio::error::operation_aborted);
    goal_ = goal;
    rest();
}
JAUSCAT_DECL operated_slave::progress operated_slave::look(time_point now) {
    if (is_lost_) return progress::lost;
    if (resting_since_) return awaits_rest() && now < due_ ? progress::goes_on : progress::rests;
    if (front_.up() || (!done_->is_done() && now < due_)) return progress::goes_on;
    done_->complete(bus_errc::timed_out);
    return progress::failed;
}
JAUSCAT_DECL void operated_slave::bus_ends() noexcept {
    try {
        if (done_) done_->complete(boost::asio::error::operation_aborted);
    } catch (...) { // no memory to tell of it
    }
}
JAUSCAT_DECL void operated_slave::begin_rest(time_point, jaus::message_sink) { rest(); }
JAUSCAT_DECL void operated_slave::rest() {
    if (resting_since_) return;
    std::ranges::fill(front_.data().outputs, std::byte{});
    resting_since_ = net::now();
    due_ = deadline{*resting_since_, timing_.longest_silence}.at();
}
JAUSCAT_DECL bool operated_slave::awaits_rest() const {
    return front_.up() && front_.data().status.last_running.value_or(time_point::min()) <= resting_since_;
}
JAUSCAT_DECL void operated_slave::slave_up(const bridging::slave_front&, const ethercat::slave_record&, bool ready) {
    if (!ready) return;
    if (auto* const slave = bus_.at(station())) bus_.note_state(*slave, {.state = ethercat::al_state::op});
    done_->complete({});
}
JAUSCAT_DECL void operated_slave::slave_lost(const bridging::slave_front&, bridging::loss,
                                             const ethercat::master_error& why) {
    is_lost_ = true;
    auto error = error_of(why);
    if (!error || error == bus_errc::stopped) error = bus_errc::slave_lost;
    if (auto* const slave = bus_.at(station())) bus_.note_lost(*slave, error);
    done_->complete(error);
}
JAUSCAT_DECL void operated_slave::clocks_agree(const bridging::slave_front&, ethercat::clock_agreement how,
                                               std::uint32_t difference) {
    bus_.note_clocks(how, difference);
}
JAUSCAT_DECL void operated_slave::slave_emergency(const bridging::slave_front&,
                                                  const ethercat::coe_emergency& emergency) {
    if (const auto* const slave = bus_.at(station())) bus_.note_emergency(*slave, emergency);
}

/// The slave is in PRE-OP, or not: it is added to the ring later, not within its turn.
struct bus_state::taking_over final : operation<> {
    taking_over(bus_state& bus, const slave_choice& which, const operate_options& options, operation_ptr<> done)
        : bus_{bus.weak_from_this()}, which_{which}, options_{options}, done_{std::move(done)} {}

  private:
    void deliver(error_code error) override {
        const auto bus = bus_.lock();
        if (error) return done_->complete(error);
        if (!bus) return done_->complete(boost::asio::error::operation_aborted);
        boost::asio::post(bus->context(), [weak = bus_, which = which_, options = options_, done = done_] {
            const auto self = weak.lock();
            if (!self) return done->complete(boost::asio::error::operation_aborted);
            const auto locked = self->lock();
            error_code why;
            const auto* const slave = self->find(which, why);
            if (slave == nullptr || done->is_done()) return done->complete(why);
            self->take_over(*slave, options, done);
        });
    }

    std::weak_ptr<bus_state> bus_;
    slave_choice which_;
    operate_options options_;
    operation_ptr<> done_;
};

JAUSCAT_DECL void bus_state::operate(const slave_choice& which, const operate_options& options, operation_ptr<> done) {
    static_cast<void>(timing_of(options)); // refuses what is out of range
    add(std::make_unique<change_job>(which, ethercat::al_state::pre_op,
                                     std::make_shared<taking_over>(*this, which, options, std::move(done))),
        options_.timeout);
}
JAUSCAT_DECL void bus_state::take_over(const bus_slave& which, const operate_options& options,
                                       const operation_ptr<>& done) {
    if (is_closed_) return done->complete(boost::asio::error::operation_aborted);
    if (which.info.is_served) return done->complete(bus_errc::served);
    auto& made = operated_.emplace_back(std::make_unique<operated_slave>(*this, which, options, done));
    if (join(*made).empty()) return;
    operated_.pop_back();
    done->complete(bus_errc::too_many_slaves);
}
JAUSCAT_DECL std::optional<bridging::slave_data> bus_state::data_of(const slave_choice& which) {
    const auto locked = lock();
    error_code error;
    const auto* const slave = operated_.empty() ? nullptr : find(which, error);
    if (slave == nullptr) return std::nullopt;
    const auto found = std::ranges::find(operated_, slave->info.station, &operated_slave::station);
    return found == operated_.end() ? std::nullopt : (*found)->data();
}
JAUSCAT_DECL void bus_state::run_cycle() {
    if (!on_cycle || operated_.empty()) return;
    try {
        on_cycle();
        return;
    } catch (const std::exception& e) {
        log("every_cycle has thrown, all slaves in operation are brought to rest: " + std::string{e.what()});
    } catch (...) {
        log("every_cycle has thrown, all slaves in operation are brought to rest");
    }
    for (const auto& each : operated_)
        if (each->data()) each->end(ethercat::al_state::pre_op, std::make_shared<unheard>());
}
JAUSCAT_DECL void bus_state::look_at_operated(time_point now) {
    using enum operated_slave::progress;
    for (std::size_t i = 0; i != operated_.size();) {
        const auto how = operated_[i]->look(now);
        if (how == goes_on) {
            ++i;
            continue;
        }
        const auto ended = std::move(operated_[i]);
        operated_.erase(operated_.begin() + static_cast<std::ptrdiff_t>(i));
        leave(*ended);
        const auto goal = how == rests ? ended->goal() : ethercat::al_state::pre_op;
        auto done = how == rests ? ended->done() : nullptr;
        if (!done) done = std::make_shared<unheard>();
        queue_change(ended->station(), goal, std::move(done));
    }
}
JAUSCAT_DECL void bus_state::queue_change(std::uint16_t station, ethercat::al_state goal, operation_ptr<> done) {
    auto job = std::make_unique<change_job>(station, goal, std::move(done));
    job->limit = options_.timeout;
    queue_.push_back(std::move(job));
    wake();
}
/// They are at rest. Takes their slaves to PRE-OP.
JAUSCAT_DECL void bus_state::end_operations() noexcept {
    constexpr duration longest = std::chrono::milliseconds{200};
    try {
        const auto all = std::exchange(operated_, {});
        for (const auto& each : all) {
            const bool is_up = each->front().up();
            leave(*each);
            each->bus_ends();
            if (is_up) queue_change(each->station(), ethercat::al_state::pre_op, std::make_shared<unheard>());
        }
        const auto is_done = [this] {
            static_cast<void>(look_at_time());
            return !current_ && queue_.empty();
        };
        if (!all.empty() && ring_) drive(is_done, longest);
        abort_all(boost::asio::error::operation_aborted);
    } catch (...) { // no memory for it: their watchdogs end OP
    }
}

// ---- The operations.

template <class... Results, class Make, class Take>
void bus_state::ask(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take) {
    using job = slave_job<Make, Take, Results...>;
    add(std::make_unique<job>(which, std::move(done), std::move(make), std::move(take)), options_.timeout);
}

JAUSCAT_DECL void bus_state::start(operation_ptr<> done) {
    if (named_.empty()) return add(std::make_unique<start_job>(std::move(done)), options_.start_timeout);
    add(std::make_unique<find_job>(find_job::scope::all, std::move(done)), options_.start_timeout);
}
JAUSCAT_DECL void bus_state::start_once(operation_ptr<> done) {
    add(std::make_unique<find_job>(find_job::scope::once, std::move(done)), options_.start_timeout);
}
JAUSCAT_DECL void bus_state::read(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                  std::optional<std::size_t> size, operation_ptr<object_bytes> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) {
            return ethercat::upload{slave.info.station, index, subindex, memory_, {.size = size}};
        },
        [](auto value, auto& to) { to.complete({}, {value.begin(), value.end()}); });
}
JAUSCAT_DECL void bus_state::write(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                   object_bytes value, operation_ptr<> done) {
    ask(
        which, std::move(done),
        [=, this, data = std::move(value)](const bus_slave& slave) {
            return ethercat::download{slave.info.station, index, subindex, data, download_options()};
        },
        [](auto& to) { to.complete({}); });
}
JAUSCAT_DECL void bus_state::list_objects(const slave_choice& which, ethercat::object_list_type list,
                                          operation_ptr<std::vector<std::uint16_t>> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) { return ethercat::list_objects{slave.info.station, list, memory_}; },
        [](const auto& indices, auto& to) {
            std::vector<std::uint16_t> all;
            for (const auto index : indices) all.push_back(index);
            to.complete({}, std::move(all));
        });
}
JAUSCAT_DECL void bus_state::describe(const slave_choice& which, std::uint16_t index,
                                      operation_ptr<object_information> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) { return ethercat::describe_object{slave.info.station, index, memory_}; },
        [](const auto& found, auto& to) { to.complete({}, {found.object, std::string{found.name}}); });
}
JAUSCAT_DECL void bus_state::describe_entry(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                            operation_ptr<entry_information> done) {
    constexpr std::uint8_t all_values = 0x7F;
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) {
            return ethercat::describe_entry{slave.info.station, index, subindex, all_values, memory_};
        },
        [](const auto& found, auto& to) {
            const auto copy = [](auto value) { return object_bytes(value.begin(), value.end()); };
            to.complete({}, {found.entry, std::string{found.name}, found.unit, copy(found.default_value),
                             copy(found.minimum), copy(found.maximum)});
        });
}
JAUSCAT_DECL void bus_state::state(const slave_choice& which, operation_ptr<ethercat::al_status> done) {
    ask(
        which, std::move(done), [](const bus_slave& slave) { return ethercat::check{slave.info.station}; },
        [](const ethercat::al_status& al, auto& to) { to.complete({}, al); });
}
JAUSCAT_DECL void bus_state::change(const slave_choice& which, ethercat::al_state goal, operation_ptr<> done) {
    {
        const auto locked = lock();
        error_code error;
        const auto* const slave = operated_.empty() ? nullptr : find(which, error);
        const auto operated = slave == nullptr
                                  ? operated_.end()
                                  : std::ranges::find(operated_, slave->info.station, &operated_slave::station);
        if (operated != operated_.end() && goal != ethercat::al_state::op) {
            (*operated)->end(goal, std::move(done));
            return wake();
        }
    }
    add(std::make_unique<change_job>(which, goal, std::move(done)), options_.timeout);
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
