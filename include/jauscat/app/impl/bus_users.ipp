// What has slaves of a bus served in its cycles: bridges, and slaves in operation.
#pragma once
#include <jauscat/app/impl/bus_jobs.hpp>
#include <jauscat/base/stable_sort.hpp>
#include <jauscat/ethercat/code_texts.hpp>

#include <boost/asio/post.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

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
    if (all.period == duration{}) all.period = operate_period_;
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
JAUSCAT_DECL void bus_state::bring_to_rest(std::span<bus_user* const> users, duration longest) {
    const auto locked = lock();
    for (auto* const user : users) user->begin_rest(net::now(), output_);
    drive([&] { return std::ranges::none_of(users, &bus_user::awaits_rest); }, longest);
}
JAUSCAT_DECL void bus_state::bring_cycle_users_to_rest(duration longest) {
    for (const auto& each : cycle_users_) each->begin_rest();
    drive([&] { return std::ranges::all_of(cycle_users_, [](const auto& each) { return each->is_at_rest(); }); },
          longest);
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
    slave->identify(record);
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
    if (period <= duration{}) throw std::invalid_argument{"async_operate: the period is more than 0"};
    if (period > milliseconds{3250})
        throw std::invalid_argument{
            "async_operate: the period is at most 3.25 s: a watchdog of 2 periods is 6.5 s at most"};
    const auto watchdog =
        options.watchdog == duration{} ? std::max<duration>(milliseconds{100}, 4 * period) : options.watchdog;
    const auto timeout =
        options.timeout == duration{} ? std::max<duration>(milliseconds{50}, 2 * period) : options.timeout;
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
      due_{deadline{net::now(), saturating_add(on.options().timeout, sync_of(which, options) ? clock_time : duration{})}
               .at()},
      timing_{timing_of(options)},
      front_{{.position = which.info.position,
              .identity = {.station = which.info.station},
              .cyclic = true,
              .sync = sync_of(which, options).value_or(ethercat::sync_settings{}),
              .is_taken_over = true,
              .objects = options.objects},
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
    const auto error = error_of_loss(ethercat::al_state::op, why);
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
        const auto locked = bus->lock();
        bus->prepared_.push_back({which_, options_, done_});
        if (bus->prepared_.size() != 1) return;
        boost::asio::post(bus->context(), [weak = bus_] {
            if (const auto self = weak.lock()) self->take_over_prepared();
        });
    }

    std::weak_ptr<bus_state> bus_;
    slave_choice which_;
    operate_options options_;
    operation_ptr<> done_;
};

JAUSCAT_DECL void bus_state::operate(const slave_choice& which, const operate_options& options, operation_ptr<> done) {
    static_cast<void>(timing_of(options)); // refuses what is out of range
    {
        const auto locked = lock();
        operate_period_ = options.period;
        has_cycle_thrown_ = false;
        apply_timings();
        keep_cycling();
    }
    add(make_change_job(which, ethercat::al_state::pre_op,
                        std::make_shared<taking_over>(*this, which, options, std::move(done))),
        options_.timeout);
}
/// All at once, so that the ring brings them to OP together.
JAUSCAT_DECL void bus_state::take_over_prepared() {
    const auto locked = lock();
    for (const auto& each : std::exchange(prepared_, {})) {
        error_code why;
        const auto* const slave = find(each.which, why);
        if (slave == nullptr || each.done->is_done())
            each.done->complete(why);
        else
            take_over(*slave, each.options, each.done);
    }
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
    return data_at(slave->info.station);
}
JAUSCAT_DECL std::optional<bridging::slave_data> bus_state::data_at(std::uint16_t station) const {
    const auto found = std::ranges::find(operated_, station, &operated_slave::station);
    return found == operated_.end() ? std::nullopt : (*found)->data();
}
JAUSCAT_DECL std::span<const ethercat::process_object> bus_state::objects_of(std::uint16_t station) const {
    const auto found = std::ranges::find_if(cycle_users_, [=](const auto& each) { return each->uses(station); });
    return found == cycle_users_.end() ? std::span<const ethercat::process_object>{} : (*found)->objects();
}
JAUSCAT_DECL bool bus_state::is_current(const bridging::slave_data& data) const {
    const auto begun = ring_ ? ring_->cycle_begun() : std::nullopt;
    return begun && data.status.last_inputs && *data.status.last_inputs >= *begun;
}
JAUSCAT_DECL void bus_state::add(const std::shared_ptr<cycle_user>& user) {
    const auto locked = lock();
    if (std::ranges::count(cycle_users_, user) == 0) cycle_users_.push_back(user);
    keep_cycling();
}
JAUSCAT_DECL bus_statistics bus_state::statistics() const {
    const auto locked = lock();
    if (!ring_) return {};
    const auto& data = ring_->process_data();
    const auto& counts = data.statistics();
    const auto& times = ring_->times();
    return {.cycles = counts.sent,
            .incomplete = counts.incomplete,
            .lost = counts.lost,
            .working_counter = data.working_counter(),
            .expected_working_counter = data.expected_working_counter(),
            .round_trip = times.round_trip,
            .longest_round_trip = times.longest_round_trip,
            .late = times.late,
            .longest_late = times.longest_late,
            .foreign_frames = ring_->statistics().foreign,
            .period = counts.sent != 0 ? timing_.period : duration{},
            .late_cycles = late_cycles_,
            .clocks = clocks()};
}
JAUSCAT_DECL std::optional<bus_clocks> bus_state::clocks() const {
    const auto& cycle = ring_->clocks();
    if (!cycle) return {};
    return bus_clocks{.reference = cycle->reference_station(),
                      .error = cycle->control().mean_error(),
                      .is_locked = cycle->control().is_locked()};
}
JAUSCAT_DECL std::vector<slave_status> bus_state::statuses() const {
    const auto locked = lock();
    std::vector<slave_status> all;
    for (const auto& each : slaves_) {
        slave_status made{.info = each.info, .is_at_rest = true};
        if (!each.info.is_lost && ethercat::is_known(each.al.state)) made.state = each.al.state;
        if (each.info.is_lost)
            made.problem = each.why.message();
        else if (each.al.error)
            made.problem = std::string{ethercat::describe(each.al.code)};
        all.push_back(std::move(made));
    }
    for (const auto* const user : users_) {
        const auto& front = user->front();
        auto found = std::ranges::find(all, front.station(), [](const auto& one) { return one.info.station; });
        if (found == all.end()) { // of a bridge, on a bus that was not searched
            all.push_back({.info = {.position = front.options().position, .station = front.station()}});
            found = all.end() - 1;
        }
        found->info.is_served = true;
        found->wanted = front.options().cyclic ? ethercat::al_state::op : ethercat::al_state::pre_op;
        found->is_in_service = front.up();
        found->is_at_rest =
            std::ranges::none_of(front.components(), [](const auto* unit) { return unit->stops().stop_is_pending(); });
        if (const auto* const record = ring_->master().find(front.station()); front.up() && record != nullptr) {
            const auto state = ring_->process_data().status(*record).al.state;
            if (ethercat::is_known(state)) found->state = state;
        }
        const auto& why = ring_->bring_up_error(front);
        if (!front.up() && found->problem.empty() && why != ethercat::master_error{})
            found->problem = std::string{ethercat::describe(why)};
    }
    jauscat::stable_sort(all, [](const auto& one) { return one.info.position; });
    return all;
}
JAUSCAT_DECL void bus_state::keep_cycling() noexcept {
    if (!ring_) return;
    ring_->keep_cycling((on_cycle || !cycle_users_.empty()) && operate_period_ != duration{}, net::now());
    wake();
}
JAUSCAT_DECL void bus_state::run_cycle() {
    const auto late = std::ranges::lower_bound(bus_statistics::late_limits, ring_->times().late, {},
                                               [](unsigned limit) { return std::chrono::microseconds{limit}; });
    ++late_cycles_[static_cast<std::size_t>(late - bus_statistics::late_limits.begin())];
    if (operate_period_ == duration{}) return;
    const auto now = net::now();
    for (const auto& each : cycle_users_) each->on_cycle(now);
    if (!on_cycle || has_cycle_thrown_) return;
    try {
        on_cycle();
        return;
    } catch (const std::exception& e) {
        log("every_cycle has thrown, all slaves in operation are brought to rest: " + std::string{e.what()});
    } catch (...) {
        log("every_cycle has thrown, all slaves in operation are brought to rest");
    }
    has_cycle_thrown_ = true;
    for (const auto& each : cycle_users_) each->begin_rest();
    for (const auto& each : operated_) {
        const auto drives = [&](const auto& user) { return user->uses(each->station()); };
        if (each->data() && std::ranges::none_of(cycle_users_, drives))
            each->end(ethercat::al_state::pre_op, std::make_shared<unheard>());
    }
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
    auto job = make_change_job(station, goal, std::move(done));
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

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
