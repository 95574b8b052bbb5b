// The jobs of a bus, and the operations that queue them.
#pragma once
#include <jauscat/app/impl/bus_jobs.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/text/master_error_text.hpp>
#include <jauscat/text/quoted.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// Looks whether a slave is in OP, before the slaves are reset.
class occupancy_look {
  public:
    explicit occupancy_look(bool takes_over) noexcept : is_done_{takes_over} {}

    /// False: there is nothing to look at any more.
    [[nodiscard]] bool begin(const bus_state& bus, ethercat::master& master) {
        if (is_done_ || bus.was_started()) return false;
        return master
            .start(ethercat::exchange_datagram{ethercat::command::brd, 0, ethercat::esc_registers::al_status.address,
                                               states_})
            .has_value();
    }
    /// Whether this was its job.
    [[nodiscard]] bool ends(const bus_state& bus, const ethercat::master& master) {
        if (is_done_ || bus.was_started()) return false;
        is_done_ = true;
        const auto seen = master.result<ethercat::exchange_datagram>().value_or(0);
        constexpr auto op = static_cast<unsigned>(ethercat::al_state::op); // a bit; the states of all are or-ed
        is_occupied_ = seen != 0 && (std::to_integer<unsigned>(states_[0]) & op) != 0;
        return true;
    }
    [[nodiscard]] bool is_occupied() const noexcept { return is_occupied_; }

  private:
    std::array<std::byte, wire::max_size<ethercat::al_status>> states_{};
    bool is_done_, is_occupied_{};
};

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

/// A slave that was brought up with others, or why it was not.
inline bus_slave brought_up(std::uint16_t position, std::uint16_t station, const ethercat::master& master,
                            const ethercat::master_error& why) {
    bus_slave made{};
    made.info.position = position;
    made.info.station = station;
    made.why = error_of(why);
    const auto* const record = made.why ? nullptr : master.find(station);
    if (record == nullptr) return made;
    made.identify(*record);
    made.al.state = ethercat::al_state::pre_op;
    return made;
}

/// Reads the names of slaves at once: object 1008h, or that of the SII.
class device_names {
  public:
    void add(const bus_slave& slave) {
        if (slave.why) return;
        stations_.push_back(slave.info.station);
        if (slave.info.has_objects)
            places_.emplace_back(ethercat::upload{.station = slave.info.station, .index = device_name});
    }
    /// The next of its jobs. False: all is done.
    [[nodiscard]] bool start(ethercat::master& master) {
        constexpr std::size_t longest = 512;
        if (step_ == step::objects && !places_.empty()) {
            step_ = step::sii;
            memory_.resize(places_.size() * longest);
            for (std::size_t i = 0; i != places_.size(); ++i)
                places_[i].object.into = std::span{memory_}.subspan(i * longest, longest);
            return master.start(ethercat::upload_all{places_}).has_value();
        }
        if (std::exchange(step_, step::done) == step::done) return false;
        for (const auto station : stations_)
            if (object_of(station).empty()) sii_.emplace_back(station);
        return !sii_.empty() && master.start(ethercat::read_names{sii_}).has_value();
    }
    /// Empty: it has none.
    [[nodiscard]] std::string of(const bus_slave& slave) const {
        const auto found = std::ranges::find(sii_, slave.info.station, &ethercat::name_place::station);
        return found == sii_.end() ? object_of(slave.info.station) : text::as_utf8(found->name.view());
    }

  private:
    static constexpr std::uint16_t device_name = ethercat::standard_indices::device_name;
    enum class step : std::uint8_t { objects, sii, done };

    [[nodiscard]] std::string object_of(std::uint16_t station) const {
        const auto found =
            std::ranges::find(places_, station, [](const ethercat::upload_place& each) { return each.object.station; });
        if (found == places_.end() || found->error != ethercat::master_error{}) return {};
        const auto name = found->object.into.first(found->size);
        return std::get<1>(object_conversion<std::string>{}({}, {name.begin(), name.end()}));
    }

    step step_{};
    std::vector<std::uint16_t> stations_{};
    std::vector<ethercat::upload_place> places_{};
    std::vector<std::byte> memory_{};
    std::vector<ethercat::name_place> sii_{};
};

/// Brings a slave up again and reads its name.
class slave_identification {
  public:
    slave_identification() = default;
    /// Another slave than `required` is not brought up.
    slave_identification(std::uint16_t position, std::uint16_t station, const ethercat::identity_check& required)
        : required_{required} {
        found.info.position = position;
        found.info.station = station;
    }

    bool begin(ethercat::master& master) {
        if (step_ == step::bring_up)
            return master.start(ethercat::bring_up{found.info.position, found.info.station, required_}).has_value();
        if (names_.start(master)) return true;
        found.info.name = names_.of(found);
        return false;
    }
    void end(ethercat::master& master) {
        if (std::exchange(step_, step::name) != step::bring_up) return;
        found = brought_up(found.info.position, found.info.station, master, master.error());
        names_.add(found);
    }

    bus_slave found{};

  private:
    enum class step : std::uint8_t { bring_up, name };

    step step_{};
    ethercat::identity_check required_{};
    device_names names_{};
};

/// Finds all slaves.
class start_job final : public bus_job {
  public:
    start_job(operation_ptr<> done, bool takes_over) : done_{std::move(done)}, look_{takes_over} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        is_serving_ = bus.is_serving() && bus.ring().is_cleared(); // a scan would reset its slaves
        if (!is_counted_ && is_serving_)
            return master
                .start(ethercat::exchange_datagram{ethercat::command::brd, 0, ethercat::esc_registers::type.address,
                                                   type_})
                .has_value();
        if (!is_counted_ && look_.begin(bus, master)) return true;
        if (!is_counted_) return master.start(ethercat::scan{}).has_value();
        if (!is_brought_up_ && new_.empty())
            for (std::uint16_t i = 0; i != count_; ++i)
                if (const auto* const known = bus.at_position(i); known == nullptr || !known->info.is_served)
                    new_.add(i, station_at(i));
        if (!is_brought_up_ && !new_.empty()) return new_.start(master);
        is_brought_up_ = true;
        for (auto i = static_cast<std::uint16_t>(found_.size()); i != count_; ++i) {
            const auto* const known = bus.at_position(i);
            const bool is_served = known != nullptr && known->info.is_served;
            found_.push_back(is_served ? *known : brought_up(i, station_at(i), master, new_.error_at(i)));
            const auto& made = found_.back();
            if (!is_served || (made.is_identified && !made.info.is_lost)) names_.add(made);
        }
        if (names_.start(master)) return true;
        error_code first;
        for (auto& each : found_) {
            if (const auto name = names_.of(each); !name.empty()) each.info.name = name;
            if (!each.info.is_served) each.info.is_lost = each.why.failed();
            if (each.info.is_served || !each.why) continue;
            bus.log(name_of(each.info) + " is not brought up: " + each.why.message());
            if (!first) first = each.why;
        }
        bus.slaves() = std::move(found_);
        bus.set_started();
        done_->complete(first);
        return false;
    }
    void end(bus_state& bus, ethercat::master& master) override {
        if (const auto error = error_of(master.error())) return fail(error);
        if (is_brought_up_) return;
        if (!is_counted_ && !is_serving_ && look_.ends(bus, master)) {
            if (look_.is_occupied()) fail(bus_errc::in_use);
            return;
        }
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
    [[nodiscard]] static std::uint16_t station_at(std::uint16_t position) noexcept {
        return static_cast<std::uint16_t>(bus_state::first_station + position);
    }

    operation_ptr<> done_;
    occupancy_look look_;
    bool is_serving_{}, is_counted_{}, is_brought_up_{};
    std::array<std::byte, 1> type_{};
    std::uint16_t count_{};
    bring_ups new_{};
    std::vector<bus_slave> found_{};
    device_names names_{};
};

inline ethercat::slave_timeouts times_of(const net::timeout_entry& entry) {
    const auto time = [](const auto& given) { return given.value_or(ethercat::slave_timeouts::milliseconds{}); };
    return {time(entry.pre_op), time(entry.safe_op_op), time(entry.back_to_init), time(entry.back_to_safe_op),
            time(entry.mailbox)};
}

/// Finds the slaves of a bus whose options name them: those that have come, gone or moved, or all.
class find_job final : public bus_job {
  public:
    find_job(find_scope what, operation_ptr<> done, bool takes_over)
        : look_{takes_over}, what_{what}, done_{std::move(done)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        for (;;) switch (step_) {
            case step::clear:
                if (what_ == find_scope::once && bus.is_started()) return fail({}), false;
                step_ = step::locate;
                if (what_ == find_scope::changes || (bus.is_serving() && bus.ring().is_cleared())) break;
                step_ = step::clear; // a scan would reset slaves that work
                if (look_.begin(bus, master)) return true;
                return master.start(ethercat::scan{}).has_value();
            case step::locate: return master.start(ethercat::locate_slaves{unknown_}).has_value();
            case step::bring_up:
                if (!ups_.empty()) return ups_.start(master);
                step_ = step::name;
                break;
            case step::name:
                if (found_.empty())
                    for (const auto& [position, station] : new_) {
                        found_.push_back(brought_up(position, station, master, ups_.error_at(position)));
                        names_.add(found_.back());
                    }
                if (names_.start(master)) return true;
                for (auto& each : found_) {
                    each.info.name = names_.of(each);
                    if (bus.note_brought_up(each, each.why)) places_.emplace_back(each.info.station);
                }
                step_ = step::identify;
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
                static_cast<void>(master.set_timeouts(station_, times_of(next->named->entry.timeouts)));
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
            if (look_.ends(bus, master)) {
                if (look_.is_occupied()) fail(bus_errc::in_use);
                return;
            }
            bus.forget_found();
            step_ = step::locate;
            return;
        case step::locate: return located(bus, master, error);
        case step::bring_up:
            if (error) return fail(error);
            step_ = step::name;
            return;
        case step::name: return;
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
        if (error == bus_errc::slave_lost && ++changes_ != most_changes) return; // the ring changes: once more
        if (error) return fail(error);
        const auto found = *master.result<ethercat::locate_slaves>();
        if (what_ != find_scope::changes && found.slaves == 0) return fail(bus_errc::no_slaves);
        if (found.slaves > bus_state::max_slaves) return fail(bus_errc::too_many_slaves);
        new_ = bus.note_positions(master, found.unknown);
        for (const auto& [position, station] : new_) ups_.add(position, station);
        step_ = step::bring_up;
    }
    void prepared(bus_state& bus, const ethercat::master& master, error_code error) {
        auto* const slave = bus.at(station_);
        if (slave == nullptr) return;
        if (error) {
            const auto& objects = slave->named->start_up;
            if (const auto at = master.error().command; writes_ && at < objects.size() && slave->why != error)
                bus.log(name_of(slave->info) + " does not take its start-up object " +
                        numbered("%04Xh:", objects[at].index) + std::to_string(objects[at].subindex) + ": " +
                        error.message());
            return bus.note_unprepared(*slave, error);
        }
        if (!writes_) {
            if (slave->named->station != 0) slave->info.station = slave->named->station;
            slave->is_brought_up = true;
            return;
        }
        bus.note_prepared(*slave, what_ != find_scope::changes);
    }

    occupancy_look look_;
    find_scope what_;
    operation_ptr<> done_;
    step step_{};
    static constexpr int most_changes = 10;
    int changes_{};
    std::array<std::uint16_t, bus_state::max_slaves> unknown_{};
    std::vector<std::pair<std::uint16_t, std::uint16_t>> new_{}; ///< positions, and the station addresses that they get
    bring_ups ups_{};
    std::vector<bus_slave> found_{};
    device_names names_{};
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
        case step::identify: return one_.begin(master) || (identified(bus), false);
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
        case step::identify: return one_.end(master);
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
        if (one_.found.why) return bus.note_lost(*slave, one_.found.why);
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
    slave_job(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take, std::string_view type)
        : which_{which}, done_{std::move(done)}, make_{std::move(make)}, take_{std::move(take)}, type_{type} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        error_code error;
        auto* const slave = bus.find(which_, error);
        if (slave == nullptr) {
            fail(error);
            return false;
        }
        station_ = slave->info.station;
        const auto job = make_(*slave);
        if constexpr (requires { job.subindex; })
            about_ = object{job.index, job.subindex};
        else if constexpr (requires { job.index; })
            about_ = object{job.index};
        return master.start(job).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        auto outcome = master.result<job_type>();
        if constexpr (std::is_same_v<job_type, ethercat::exchange_datagram>)
            if (outcome && *outcome != 1) // no slave, or several, have this station address
                outcome = ethercat::master_error{
                    .code = ethercat::master_errc::working_counter, .station = station_, .working_counter = *outcome};
        auto error = outcome ? error_code{} : error_of(outcome.error());
        if (auto* const slave = bus.at(station_)) {
            bus.note_outcome(*slave, error);
            bus.note_emergencies(*slave, master);
            if (error) error = error_of(slave->info, outcome.error(), about_, type_);
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
    std::string_view type_; ///< of the value that is read
    std::optional<object> about_{};
    std::uint16_t station_{};
};

/// A slave that is to be in another state: chosen by the application, or known.
struct state_request {
    slave_choice which{};
    std::uint16_t station{}; ///< 0: `which` says it
    operation_ptr<> done{};

    /// The slave, or nullptr and the error.
    [[nodiscard]] bus_slave* find(bus_state& bus, error_code& error) const {
        error = bus_errc::no_such_slave;
        auto* const found = station != 0 ? bus.at(station) : bus.find(which, error);
        if (found == nullptr || !found->info.is_served) return found;
        error = bus_errc::served;
        return nullptr;
    }
};

/// Takes slaves to INIT or PRE-OP, all those at once whose requests follow each other.
class state_job final : public bus_job {
  public:
    state_job(state_request first, ethercat::al_state goal) : goal_{goal} { requests_.push_back(std::move(first)); }

    [[nodiscard]] bool takes_along(bus_job& next) override {
        auto* const other = dynamic_cast<state_job*>(&next);
        if (other == nullptr || other->goal_ != goal_ || requests_.size() == bus_state::max_slaves) return false;
        std::ranges::move(other->requests_, std::back_inserter(requests_));
        return true;
    }
    bool begin(bus_state& bus, ethercat::master& master) override {
        if (has_begun_) return false;
        has_begun_ = true;
        std::erase_if(requests_, [](const state_request& each) { return each.done->is_done(); });
        for (auto& each : requests_) {
            error_code error;
            const auto* const slave = each.find(bus, error);
            if (slave == nullptr)
                each.done->complete(error);
            else if (each.station = slave->info.station; place_of(each.station) == nullptr)
                places_.emplace_back(each.station);
        }
        return !places_.empty() && master.start(ethercat::change_states{places_, goal_}).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        for (const auto& each : places_) {
            auto* const slave = bus.at(each.station);
            if (slave == nullptr) continue;
            const auto& why = each.error == ethercat::master_error{} ? master.error() : each.error;
            bus.note_outcome(*slave, error_of(why));
            if (goal_ == ethercat::al_state::init && !error_of(why)) slave->is_configured = false;
            if (!error_of(why)) bus.note_state(*slave, {.state = goal_});
            tell(each.station, error_of(why) ? error_of(slave->info, why) : error_code{});
        }
        fail(bus_errc::no_such_slave);
    }
    [[nodiscard]] bool is_over() const override {
        return std::ranges::all_of(requests_, [](const state_request& each) { return each.done->is_done(); });
    }
    /// Those that are there already have not failed.
    void fail(error_code why) override {
        for (const auto& each : requests_) {
            const auto* const place = has_begun_ ? place_of(each.station) : nullptr;
            const bool is_there = place != nullptr && place->has_ended() && place->error == ethercat::master_error{};
            each.done->complete(is_there ? error_code{} : why);
        }
    }

  private:
    [[nodiscard]] const ethercat::state_place* place_of(std::uint16_t station) const {
        const auto found = std::ranges::find(places_, station, &ethercat::state_place::station);
        return found == places_.end() ? nullptr : &*found;
    }
    void tell(std::uint16_t station, error_code outcome) {
        for (const auto& each : requests_)
            if (each.station == station) each.done->complete(outcome);
    }

    std::vector<state_request> requests_{};
    ethercat::al_state goal_;
    std::vector<ethercat::state_place> places_{};
    bool has_begun_{};
};

/// Takes a slave to SAFE-OP, with its process data configured.
class safe_op_job final : public bus_job {
  public:
    explicit safe_op_job(state_request request) : request_{std::move(request)} {}

    bool begin(bus_state& bus, ethercat::master& master) override {
        error_code error;
        const auto* const slave = request_.find(bus, error);
        if (slave == nullptr) return fail(error), false;
        const auto station = request_.station = slave->info.station;
        if (slave->is_configured) step_ = step::change;
        switch (step_) {
        case step::look: return master.start(ethercat::check{station}).has_value();
        case step::pre_op: return master.start(ethercat::change_state{station, ethercat::al_state::pre_op}).has_value();
        case step::configure: return master.start(ethercat::configure{station}).has_value();
        case step::change: break;
        }
        return master.start(ethercat::change_state{station, goal}).has_value();
    }
    void end(bus_state& bus, ethercat::master& master) override {
        auto* const slave = bus.at(request_.station);
        const auto error = error_of(master.error());
        if (slave == nullptr) return fail(bus_errc::no_such_slave);
        bus.note_outcome(*slave, error);
        if (error) {
            if (step_ == step::configure)
                bus.log(name_of(slave->info) + " is not configured: " + text::explain(master.error()));
            return fail(error_of(slave->info, master.error()));
        }
        switch (step_) {
        case step::look:
            if (const auto al = master.result<ethercat::check>()) {
                if (al->state == goal && !al->error) break;
                step_ = al->state == ethercat::al_state::pre_op && !al->error ? step::configure : step::pre_op;
            }
            return;
        case step::pre_op: step_ = step::configure; return;
        case step::configure: slave->is_configured = true; return;
        case step::change: break;
        }
        bus.note_state(*slave, {.state = goal});
        request_.done->complete({});
    }
    [[nodiscard]] bool is_over() const override { return request_.done->is_done(); }
    void fail(error_code why) override { request_.done->complete(why); }

  private:
    enum class step : std::uint8_t { look, pre_op, configure, change };
    static constexpr auto goal = ethercat::al_state::safe_op;

    state_request request_;
    step step_{};
};

/// Ends with needs_cycles.
class op_job final : public bus_job {
  public:
    explicit op_job(state_request request) : request_{std::move(request)} {}

    bool begin(bus_state& bus, ethercat::master&) override {
        error_code error;
        return fail(request_.find(bus, error) == nullptr ? error : bus_errc::needs_cycles), false;
    }
    void end(bus_state&, ethercat::master&) override {}
    [[nodiscard]] bool is_over() const override { return request_.done->is_done(); }
    void fail(error_code why) override { request_.done->complete(why); }

  private:
    state_request request_;
};

inline std::unique_ptr<bus_job> change_job(state_request request, ethercat::al_state goal) {
    if (goal == ethercat::al_state::op) return std::make_unique<op_job>(std::move(request));
    if (goal == ethercat::al_state::safe_op) return std::make_unique<safe_op_job>(std::move(request));
    return std::make_unique<state_job>(std::move(request), goal);
}

JAUSCAT_DECL std::unique_ptr<bus_job> make_start_job(operation_ptr<> done, bool takes_over) {
    return std::make_unique<start_job>(std::move(done), takes_over);
}
JAUSCAT_DECL std::unique_ptr<bus_job> make_find_job(find_scope what, operation_ptr<> done, bool takes_over) {
    return std::make_unique<find_job>(what, std::move(done), takes_over);
}
JAUSCAT_DECL std::unique_ptr<bus_job> make_look_job(std::uint16_t station) {
    return std::make_unique<look_job>(station);
}
JAUSCAT_DECL std::unique_ptr<bus_job> make_change_job(const slave_choice& which, ethercat::al_state goal,
                                                      operation_ptr<> done) {
    return change_job({.which = which, .done = std::move(done)}, goal);
}
JAUSCAT_DECL std::unique_ptr<bus_job> make_change_job(std::uint16_t station, ethercat::al_state goal,
                                                      operation_ptr<> done) {
    return change_job({.station = station, .done = std::move(done)}, goal);
}

// ---- The operations.

template <class... Results, class Make, class Take>
void bus_state::ask(const slave_choice& which, operation_ptr<Results...> done, Make make, Take take,
                    std::string_view type) {
    using job = slave_job<Make, Take, Results...>;
    add(std::make_unique<job>(which, std::move(done), std::move(make), std::move(take), type), timeout_of(which));
}

JAUSCAT_DECL void bus_state::start(operation_ptr<> done, bool takes_over) {
    if (named_.empty()) return add(make_start_job(std::move(done), takes_over), options_.start_timeout);
    add(make_find_job(find_scope::all, std::move(done), takes_over), options_.start_timeout);
}
JAUSCAT_DECL void bus_state::start_once(operation_ptr<> done) {
    add(make_find_job(find_scope::once, std::move(done)), options_.start_timeout);
}
JAUSCAT_DECL void bus_state::read(const slave_choice& which, std::uint16_t index, std::uint8_t subindex,
                                  const object_type& type, operation_ptr<object_bytes> done) {
    ask(
        which, std::move(done),
        [=, this](const bus_slave& slave) {
            return ethercat::upload{slave.info.station, index, subindex, memory_, {.size = type.size}};
        },
        [](auto value, auto& to) { to.complete({}, {value.begin(), value.end()}); }, type.name);
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
JAUSCAT_DECL void bus_state::error_counters(const slave_choice& which, operation_ptr<ethercat::error_counters> done) {
    constexpr auto registers = ethercat::esc_registers::error_counters;
    const auto read = std::span{memory_}.first(registers.size);
    ask(
        which, std::move(done),
        [=](const bus_slave& slave) {
            return ethercat::exchange_datagram{ethercat::command::fprd, slave.info.station, registers.address, read};
        },
        [read](std::uint16_t, auto& to) {
            ethercat::error_counters counted{};
            static_cast<void>(wire::decode(counted, read)); // of its size
            to.complete({}, counted);
        });
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
    add(make_change_job(which, goal, std::move(done)), timeout_of(which));
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
