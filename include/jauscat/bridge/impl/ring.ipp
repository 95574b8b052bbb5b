// The functions of ring.
#pragma once
#include <jauscat/bridge/ring.hpp>

namespace jauscat::bridging {

JAUSCAT_FUNCTION ring::ring(const bridge_options& options, const ring_memory& memory) noexcept
    : options_{options},
      master_{memory.records},
      data_{memory.slots, memory.image.first(std::min(memory.image.size(), max_image))},
      memory_{memory.places},
      lanes_{memory.lanes},
      records_{memory.exchanged},
      bring_ups_{memory.bring_ups},
      configurations_{memory.configurations},
      state_changes_{memory.state_changes},
      positions_{memory.positions},
      clocks_{memory.clock_records} {}

JAUSCAT_FUNCTION bool ring::add(slave_front& front) noexcept {
    if (place_count_ == memory_.size()) return false;
    memory_[place_count_] = {};
    memory_[place_count_].at = front.options().is_taken_over ? phase::pre_op : phase::absent;
    memory_[place_count_++].front = &front;
    return true;
}

JAUSCAT_FUNCTION void ring::remove(const slave_front& front, time_point now) {
    const auto found = std::ranges::find(places(), &front, &place::front);
    if (found == places().end()) return;
    place* const gone = &*found;
    if (auto* const lane = lane_of(*gone)) lane->drop(master_);
    if (work_ != work::none && work_ != work::shared && served_ == gone) {
        master_.cancel(ethercat::master_errc::timeout);
        work_ = work::none;
    } else if (served_ > gone) {
        --served_;
    }
    std::move(found + 1, places().end(), found);
    --place_count_;
    last_served_ = 0;
    if (std::ranges::none_of(places(), has_sync)) clocks_.stop();
    rebuild_process_data(now);
}

JAUSCAT_FUNCTION void ring::apply_options() {
    auto config = options_.master;
    config.logical_base = logical_base_;
    master_.set_config(config);
    for (message_lane& each : lanes_) each.master().set_config(config);
    clocks_.set_period(options_.period);
}

JAUSCAT_FUNCTION void ring::tell_period() {
    if (std::exchange(told_period_, options_.period) == options_.period) return;
    for (place& each : places())
        for (component* unit : each.front->components())
            if (auto* const process = unit->process()) process->part().change_period(options_.period);
}

JAUSCAT_FUNCTION bool ring::cancel_shared() noexcept {
    if (work_ != work::shared) return false;
    master_.cancel(ethercat::master_errc::timeout);
    return true;
}

JAUSCAT_FUNCTION bool ring::on_frame(bytes frame, time_point now, jaus::message_sink out) {
    const bool waited = data_.waits();
    const bool was_taken = clocks_.on_frame(frame) || data_.on_frame(frame) || take(frame, now);
    if (waited && !data_.waits()) {
        is_step_due_ = true;
        if (cycle_begun_) times_.round_trip = now - *cycle_begun_;
        times_.longest_round_trip = std::max(times_.longest_round_trip, times_.round_trip);
    }
    turn(now, out);
    return was_taken;
}

JAUSCAT_FUNCTION void ring::on_time(time_point now, jaus::message_sink out) {
    if (is_cycle_due(now)) {
        end_cycle(now);
        is_step_due_ = is_step_due_ || exchanged_ == 0;
    }
    turn(now, out);
}

JAUSCAT_FUNCTION std::size_t ring::next_frame(std::span<std::byte> frame, time_point now) {
    if (is_cycle_due(now)) {
        end_cycle(now);
        is_cycle_ended_ = false;
        cycle_begun_ = now;
        times_.late = now - next_cycle_;
        times_.longest_late = std::max(times_.longest_late, times_.late);
        skip_to_next_cycle(now);
        clocks_.begin_cycle();
        is_step_due_ = is_step_due_ || data_.waits(); // a frame of the last cycle is lost
        data_.begin_cycle();
    }
    sender_ = nullptr;
    if (const auto size = clocks_.next_frame(frame, now, times_.late)) return size;
    if (const auto size = data_.next_frame(frame, now)) return size;
    if (cycles() && next_cycle_ - now <= reserve()) return 0; // the process data must not wait behind it
    const auto send = [&](ethercat::master& from) {
        const auto size = from.next_frame(frame, now);
        if (size != 0) sender_ = &from;
        return size;
    };
    for (message_lane& each : lanes_)
        if (const auto size = send(each.master())) return size;
    return send(master_);
}

JAUSCAT_FUNCTION void ring::not_sent() noexcept {
    if (sender_ != nullptr) sender_->cancel(ethercat::master_errc::not_sent);
}

JAUSCAT_FUNCTION std::optional<time_point> ring::next_event() const {
    std::optional<time_point> next;
    const auto consider = [&](std::optional<time_point> other) {
        if (other && (!next || *other < *next)) next = other;
    };
    const auto consider_frame = [&](const ethercat::master& from) {
        // A frame may be overdue and still delayed in favour of the process data.
        const auto frame = from.next_event();
        if (!frame) return;
        const auto at = std::max(*frame, last_turn_);
        consider(cycles() && next_cycle_ - at <= reserve() ? std::max(at, next_cycle_) : at);
    };
    consider_frame(master_);
    for (const message_lane& each : lanes_) consider_frame(each.master());
    if (const auto hindered = hindered_until()) consider(*hindered);
    if (cycles()) consider(next_cycle_);
    for (const place& each : places()) {
        consider(each.front->orders().next_expiry());
        if (each.at != phase::up) {
            if (master_.idle() && !is_carried(each)) consider(next_work_of(each));
        } else if (!master_.serves(each.front->station())) {
            if (const auto next_work = next_work_of(each)) {
                if (const auto from = lane_from(each)) consider(std::max(*next_work, *from));
            }
        }
    }
    return next;
}

JAUSCAT_FUNCTION bool ring::at_rest() const noexcept {
    return std::ranges::all_of(places(), [](const place& each) {
        return std::ranges::none_of(each.front->components(),
                                    [](const component* unit) { return unit->stops().stop_is_pending(); });
    });
}

JAUSCAT_FUNCTION void ring::shut_down(time_point now, jaus::message_sink out) {
    for (place& each : places())
        for (component* unit : each.front->components()) unit->shut_down(now, out);
}

JAUSCAT_FUNCTION bool ring::keeps_alive() const noexcept {
    const auto is_busy = [](const message_lane& each) { return each.is_busy(); };
    return master_.idle() && std::ranges::any_of(lanes_, is_busy) &&
           std::ranges::all_of(lanes_, [&](const message_lane& each) {
               return !is_busy(each) || each.current().what == purpose::keep_alive;
           });
}

JAUSCAT_FUNCTION ethercat::master_statistics ring::statistics() const noexcept {
    auto sum = master_.statistics();
    for (const message_lane& each : lanes_) sum += each.master().statistics();
    return sum;
}

JAUSCAT_FUNCTION const ethercat::master_error& ring::bring_up_error(const slave_front& front) const noexcept {
    const auto found = std::ranges::find(places(), &front, &place::front);
    static constexpr ethercat::master_error none{};
    return found == places().end() ? none : found->bring_up;
}

JAUSCAT_FUNCTION ring::place* ring::place_of(std::uint16_t station) const noexcept {
    const auto all = memory_.first(place_count_);
    const auto found = std::ranges::find(all, station, [](const place& each) { return each.front->station(); });
    return found == all.end() ? nullptr : &*found;
}

JAUSCAT_FUNCTION duration ring::interval() const noexcept {
    return is_periodic() ? options_.period : options_.check_interval;
}

JAUSCAT_FUNCTION void ring::begin(time_point now) {
    const auto start = static_cast<std::uint64_t>(now.time_since_epoch() / std::chrono::microseconds{1});
    const auto window = start * 0x9E37'79B9'7F4A'7C15U >> (32 + window_bits); // spreads starts that are close
    logical_base_ = static_cast<std::uint32_t>(window << window_bits);
    auto config = options_.master;
    config.logical_base = logical_base_;
    master_.reset(config);
    for (message_lane& each : lanes_) each.master().reset(config);
    has_begun_ = true;
}

JAUSCAT_FUNCTION void ring::turn(time_point now, jaus::message_sink out) {
    if (!has_begun_) begin(now);
    drop_after_pause(now);
    last_turn_ = now;
    master_.on_time(now);
    for (message_lane& each : lanes_) each.master().on_time(now);
    watch_cycles(now, out);
    watch_clocks(now, out);
    refuse_expired(now, out);
    use_process_data(now, out);
    stop_what_hinders(now);
    // By turns: a message for a slave goes between two jobs of others for it.
    bool is_changed = true;
    while (is_changed) {
        is_changed = master_.idle() && advance(now, out);
        is_changed = carry(now, out) || is_changed;
    }
}

JAUSCAT_FUNCTION bool ring::take(bytes frame, time_point now) {
    const auto is_taken = [&](message_lane& each) { return each.master().take(frame, now); };
    const auto is_late = [&](message_lane& each) { return each.master().claim(frame); };
    if (std::ranges::any_of(lanes_, is_taken) || master_.take(frame, now)) return true;
    return !std::ranges::any_of(lanes_, is_late) && master_.on_frame(frame, now);
}

JAUSCAT_FUNCTION bool ring::advance(time_point now, jaus::message_sink out) {
    if (work_ != work::none) {
        complete(now, out);
        return true;
    }
    // Round robin: no slave waits for more than one job of each of the others. The last turn is the shared jobs'.
    const std::size_t turns = place_count_ + 1;
    for (std::size_t i = 0; i != turns; ++i) {
        const auto turn = (last_served_ + 1 + i) % turns;
        if (turn == place_count_ ? !begin_shared() : !begin_step(memory_[turn], now)) continue;
        last_served_ = turn;
        return true;
    }
    return false;
}

JAUSCAT_FUNCTION bool ring::begin_shared() {
    if (!shared_.begin || !shared_.begin(master_)) return false;
    work_ = work::shared;
    return true;
}

JAUSCAT_FUNCTION void ring::end_shared() {
    const bool has_scanned = master_.result<ethercat::scan>().value_or(0) != 0;
    if (has_scanned) is_cleared_ = true;
    if (has_scanned || master_.result<ethercat::bring_up>() || master_.result<ethercat::bring_up_all>())
        clocks_.leave_out_none();
    shared_.done(master_);
}

JAUSCAT_FUNCTION bool ring::begin_step(place& at, time_point now) {
    if (is_carried(at)) return false; // a transfer from before its loss ends first
    switch (at.at) {
    case phase::absent: return now >= at.next_try && !at.front->options().is_taken_over && begin_bring_up(at, now);
    case phase::pre_op:
        if (!at.front->options().cyclic) return reach_pre_op(at), true; // it was taken over
        if (const auto* const object = next_start_up_object(at)) return begin_start_up(at, *object);
        return begin_configure(at);
    case phase::configured:
        if (has_sync(at) && !at.clock_is_set) return begin_clocks(at, now);
        if (has_sync(at)) return follow_clock(at, now), true;
        [[fallthrough]];
    case phase::has_sync:
        return begin_state(at, work::safe_op, work::safe_op_all, ethercat::al_state::safe_op,
                           [](const place& each) { return goes_to_safe_op(each); });
    case phase::has_clock: return is_in_time(at) ? begin_sync(at, now) : begin_clock_look(at, now);
    case phase::safe_op:
        if (has_sync(at) && !is_synchronized(at)) return false;
        return begin_state(at, work::op, work::op_all, ethercat::al_state::op, [this](const place& each) {
            return each.at == phase::safe_op && (!has_sync(each) || is_synchronized(each));
        });
    case phase::in_state: return begin_place_check(at);
    case phase::settling:
    case phase::up: break;
    }
    return false;
}

JAUSCAT_FUNCTION bool ring::begin_place_check(place& at) {
    if (const auto all = gather(
            at, positions_, [](const place& each) { return each.at == phase::in_state; },
            [](const place& each) { return ethercat::position_place{each.front->station()}; });
        !all.empty())
        return begin_job(at, work::place_all, ethercat::check_positions{all});
    one_position_ = ethercat::position_place{at.front->station()};
    return begin_job(at, work::place, ethercat::check_positions{{&one_position_, 1}});
}

JAUSCAT_FUNCTION bool ring::has_sync(const place& at) noexcept {
    return at.front->options().cyclic && at.front->options().sync.assign_activate != 0;
}

JAUSCAT_FUNCTION std::uint64_t ring::system_time(time_point now) const noexcept {
    return options_.system_time + static_cast<std::uint64_t>(now.time_since_epoch().count());
}

JAUSCAT_FUNCTION bool ring::begin_clocks(place& at, time_point now) {
    clocks_.choose(
        master_.slaves(),
        [this](const ethercat::slave_record& slave) {
            const auto* const found = place_of(slave.station);
            return slave.position != ethercat::slave_record::no_position &&
                   (found == nullptr || found->at != phase::absent);
        },
        [this](const ethercat::slave_record& slave) {
            const auto* const found = place_of(slave.station);
            return found != nullptr && found->clock_is_set && has_sync(*found);
        });
    // Looks at each clock decide, while the cycles bring the reference time.
    auto how = options_.clocks;
    how.limit = std::numeric_limits<std::uint32_t>::max();
    if (clocks_.runs()) how.drift_frames = 0;
    return begin_job(
        at, work::clocks,
        ethercat::set_up_clocks{.slaves = clocks_.chosen(), .system_time = system_time(now), .options = how});
}

JAUSCAT_FUNCTION void ring::clocks_set_up(place& at, const ethercat::master_error& error, time_point now,
                                          jaus::message_sink out) {
    if (error != ethercat::master_error{}) {
        if (is_of_other(at, error)) return leave_out(error, now, out);
        return set_up(at, error, phase::configured, now, out);
    }
    const bool has_cycles = is_periodic();
    clocks_.use(*master_.result<ethercat::set_up_clocks>(), system_time(now), options_.period);
    if (!has_cycles) {
        next_cycle_ = now;
        cycle_begun_.reset();
    }
    for (place& each : places()) {
        if (each.at == phase::absent || each.clock_is_set || !has_sync(each)) continue;
        const auto* const clock = clocks_.find(each.front->station());
        if (clock == nullptr) continue; // it was brought up meanwhile
        each.clock_is_set = clock->has_clock();
        each.good_looks = 0;
        each.next_look = now;
    }
    if (!at.clock_is_set)
        set_up(at, {.code = ethercat::master_errc::no_clock, .station = at.front->station()}, phase::configured, now,
               out);
}

JAUSCAT_FUNCTION void ring::follow_clock(place& at, time_point now) {
    at.at = phase::has_clock;
    at.settling_until = saturating_add(now, options_.clock_timeout);
}

JAUSCAT_FUNCTION bool ring::is_of_other(const place& at, const ethercat::master_error& error) noexcept {
    using enum ethercat::master_errc;
    const bool is_of_one = error.code == working_counter || error.code == duplicate_station;
    return is_of_one && error.station != 0 && error.station != at.front->station();
}

JAUSCAT_FUNCTION void ring::leave_out(const ethercat::master_error& error, time_point now, jaus::message_sink out) {
    place* const found = place_of(error.station);
    if (found == nullptr) return clocks_.leave_out(error.station);
    found->bring_up = error;
    lose(*found, loss::no_station, error, now, out);
}

JAUSCAT_FUNCTION bool ring::begin_clock_look(place& at, time_point now) {
    if (now < at.next_look) return false;
    return begin_job(at, work::clock_look,
                     ethercat::exchange_datagram{ethercat::command::fprd, at.front->station(),
                                                 ethercat::esc_registers::dc_difference.address, difference_});
}

JAUSCAT_FUNCTION void ring::clock_looked_at(place& at, const ethercat::master_error& error, time_point now,
                                            jaus::message_sink out) {
    ethercat::dc_difference is{};
    const bool has_answer = error == ethercat::master_error{};
    const std::uint16_t answers = has_answer ? *master_.result<ethercat::exchange_datagram>() : std::uint16_t{};
    if (has_answer && answers != 1) {
        at.bring_up = {.code = ethercat::master_errc::working_counter, .working_counter = answers};
        return lose(at, loss::no_station, at.bring_up, now, out);
    }
    const bool is_read = has_answer && wire::decode(is, difference_);
    at.next_look = saturating_add(now, looks_apart * options_.period);
    at.good_looks = is_read && is.magnitude <= options_.clocks.limit ? at.good_looks + 1 : 0;
    if (is_in_time(at) || now < at.settling_until) return;
    set_up(
        at,
        {.code = ethercat::master_errc::clock_unsettled, .station = at.front->station(), .nanoseconds = is.magnitude},
        phase::has_clock, now, out);
}

JAUSCAT_FUNCTION bool ring::begin_sync(place& at, time_point now) {
    for (auto& clock : clocks_.records()) {
        clock.sync = {};
        const auto* const found = place_of(clock.station);
        if (found == nullptr || found->at != phase::has_clock || !is_in_time(*found)) continue;
        clock.sync = found->front->options().sync;
        if (clock.sync.sync0_cycle == 0) clock.sync.sync0_cycle = static_cast<std::uint32_t>(options_.period.count());
    }
    return begin_job(at, work::sync,
                     ethercat::start_sync{.slaves = clocks_.records(), .system_time = system_time(now)});
}

JAUSCAT_FUNCTION void ring::sync_started(place& at, const ethercat::master_error& error, time_point now,
                                         jaus::message_sink out) {
    if (error != ethercat::master_error{}) return set_up(at, error, phase::has_clock, now, out);
    for (place& each : places()) {
        const auto* const clock = clocks_.find(each.front->station());
        if (each.at == phase::has_clock && is_in_time(each) && clock != nullptr && clock->sync.assign_activate != 0)
            each.at = phase::has_sync;
    }
}

JAUSCAT_FUNCTION bool ring::is_synchronized(const place& at) const noexcept {
    const auto& cycle = clocks_.cycle();
    const auto* const clock = clocks_.find(at.front->station());
    return cycle && cycle->control().is_locked() && clock != nullptr && cycle->reference_time() > clock->start_time;
}

JAUSCAT_FUNCTION void ring::watch_waiting(place& at, time_point now, jaus::message_sink out) {
    using enum ethercat::slave_condition;
    const auto seen = at.status == nullptr ? silent : at.status->condition;
    if (seen == absent || seen == duplicate) {
        at.bring_up = {.code = ethercat::master_errc::wrong_station, .station = at.front->station()};
        return lose(at, loss::no_station, at.bring_up, now, out);
    }
    if (now < at.settling_until) return;
    set_up(at, {.code = ethercat::master_errc::clock_unsettled, .station = at.front->station()}, phase::safe_op, now,
           out);
}

JAUSCAT_FUNCTION void ring::watch_clocks(time_point now, jaus::message_sink out) {
    if (!clocks_.runs()) return;
    const auto& cycle = *clocks_.cycle();
    for (place& each : places())
        if (each.at == phase::safe_op && has_sync(each) && !is_synchronized(each)) watch_waiting(each, now, out);
    // A slave whose clock is not set up yet counts in the difference as well.
    const bool is_known =
        std::ranges::all_of(places(), [](const place& each) { return !has_sync(each) || each.at >= phase::has_sync; });
    if (!is_known || std::exchange(agreement_, cycle.agreement()) == cycle.agreement()) return;
    for (const place& each : places())
        if (has_sync(each)) each.front->watcher().clocks_agree(*each.front, cycle.agreement(), cycle.difference());
}

JAUSCAT_FUNCTION bool ring::begin_bring_up(place& at, time_point now) {
    if (!is_cleared_) return begin_job(at, work::scan, ethercat::scan{});
    const auto wanted = [](const place& each) {
        const auto& slave = each.front->options();
        return ethercat::bring_up{slave.position, slave.identity.station, slave.expected};
    };
    const auto joins = [&](const place& each) {
        return each.at == phase::absent && now >= each.next_try && !each.front->options().is_taken_over;
    };
    if (const auto all =
            gather(at, bring_ups_, joins, [&](const place& each) { return ethercat::bring_up_place{wanted(each)}; });
        !all.empty())
        return begin_job(at, work::bring_up_all, ethercat::bring_up_all{all});
    return begin_job(at, work::bring_up, wanted(at));
}

JAUSCAT_FUNCTION bool ring::begin_configure(place& at) {
    const auto watchdog = at.front->timing().watchdog;
    const auto joins = [&](const place& each) {
        return each.at == phase::pre_op && each.front->options().cyclic && each.front->timing().watchdog == watchdog &&
               next_start_up_object(each) == nullptr;
    };
    if (const auto all = gather(
            at, configurations_, joins,
            [](const place& each) { return ethercat::configure_place{each.front->station(), objects_of(each)}; });
        !all.empty())
        return begin_job(at, work::configure_all, ethercat::configure_all{all, watchdog});
    return begin_job(at, work::configure, ethercat::configure{at.front->station(), watchdog, objects_of(at)});
}

JAUSCAT_FUNCTION bool ring::goes_to_safe_op(const place& at) noexcept {
    return at.at == phase::has_sync || (at.at == phase::configured && !has_sync(at));
}

JAUSCAT_FUNCTION bool ring::is_slow(const ethercat::master_error& error) noexcept {
    using enum ethercat::master_errc;
    return error.code == state_timeout || error.code == mailbox_timeout || error.code == mailbox_full ||
           error.code == sii_busy;
}

JAUSCAT_FUNCTION void ring::brought_up_all(time_point now) {
    complete_all(
        bring_ups_, [](const auto& each) { return each.slave.station; },
        [](const place& at) { return at.at == phase::absent; },
        [&](place& at, const ethercat::master_error& error) { brought_up(at, error, now); }, now);
}

JAUSCAT_FUNCTION ring::part_place ring::part_of(const place& at, std::size_t which) {
    for (const component* unit : at.front->components()) {
        auto* const process = unit->process();
        if (process == nullptr || which-- != 0) continue;
        const auto fronts = process->fronts();
        return {&process->part(), static_cast<std::size_t>(std::ranges::find(fronts, at.front) - fronts.begin())};
    }
    return {};
}

JAUSCAT_FUNCTION std::span<ethercat::process_object> ring::objects_of(const place& at) {
    const auto in = part_of(at, at.checked_parts);
    if (in.part != nullptr) return in.part->objects(in.slave);
    return at.checked_parts == 0 ? at.front->options().objects : std::span<ethercat::process_object>{};
}

JAUSCAT_FUNCTION void ring::configured(place& at, ethercat::master_error error, time_point now,
                                       jaus::message_sink out) {
    const auto in = part_of(at, at.checked_parts);
    if (error == ethercat::master_error{} && in.part != nullptr) error = in.part->check_objects(in.slave);
    ++at.checked_parts;
    set_up(at, error, objects_of(at).empty() ? phase::configured : phase::pre_op, now, out);
}

JAUSCAT_FUNCTION const ethercat::init_command* ring::next_start_up_object(const place& at) const {
    std::size_t which = at.start_up_object;
    for (std::size_t i = 0;; ++i) {
        const auto in = part_of(at, i);
        if (in.part == nullptr) break;
        const auto objects = in.part->start_up(in.slave, options_.period);
        if (which < objects.size()) return &objects[which];
        which -= objects.size();
    }
    return nullptr;
}

JAUSCAT_FUNCTION bool ring::begin_start_up(place& at, const ethercat::init_command& object) {
    if (at.start_up == place::start_up_step::write)
        return begin_job(
            at, work::start_up,
            ethercat::download{at.front->station(), object.index, object.subindex, object.data, object.options});
    return begin_job(at, work::start_up,
                     ethercat::upload{at.front->station(), object.index, object.subindex, start_up_value_});
}

JAUSCAT_FUNCTION void ring::started_up(place& at, const ethercat::master_error& error, time_point now,
                                       jaus::message_sink out) {
    using step = place::start_up_step;
    const auto next = [&at] {
        ++at.start_up_object;
        at.start_up = step::read;
    };
    const auto* const object = next_start_up_object(at);
    if (object == nullptr) return;
    if (error != ethercat::master_error{}) {
        const bool is_absent =
            error.code == ethercat::master_errc::sdo_abort &&
            (error.abort == ethercat::abort_code::no_object || error.abort == ethercat::abort_code::no_subindex);
        if (is_absent && at.start_up == step::read) return next();
        return set_up(at, error, phase::pre_op, now, out);
    }
    if (at.start_up == step::write) {
        at.start_up = step::verify;
    } else if (const auto is = master_.result<ethercat::upload>(); is && std::ranges::equal(*is, object->data)) {
        next();
    } else if (at.start_up == step::read) {
        at.start_up = step::write;
    } else {
        const auto command = static_cast<std::uint16_t>(at.start_up_object);
        set_up(at, {.code = ethercat::master_errc::object_not_kept, .command = command}, phase::pre_op, now, out);
    }
}

JAUSCAT_FUNCTION void ring::complete(time_point now, jaus::message_sink out) {
    if (work_ == work::shared) {
        work_ = work::none;
        return end_shared();
    }
    place& at = *served_;
    const auto result = master_.error();
    switch (std::exchange(work_, work::none)) {
    case work::scan: return cleared(at, master_.result<ethercat::scan>().value_or(0), now);
    case work::bring_up: return brought_up(at, result, now);
    case work::start_up: return started_up(at, result, now, out);
    case work::configure: return configured(at, result, now, out);
    case work::clocks: return clocks_set_up(at, result, now, out);
    case work::clock_look: return clock_looked_at(at, result, now, out);
    case work::sync: return sync_started(at, result, now, out);
    case work::safe_op: return set_up(at, result, phase::safe_op, now, out);
    case work::op: return set_up(at, result, phase::in_state, now, out);
    case work::place: return placed(at, result != ethercat::master_error{} ? result : one_position_.error, now, out);
    case work::place_all:
        return complete_all(
            positions_, [](const auto& each) { return each.station; },
            [](const place& each) { return each.at == phase::in_state; },
            [&](place& each, const ethercat::master_error& error) { placed(each, error, now, out); }, now);
    case work::bring_up_all: return brought_up_all(now);
    case work::configure_all:
        return complete_all(
            configurations_, [](const auto& each) { return each.station; },
            [](const place& each) { return each.at == phase::pre_op; },
            [&](place& each, const ethercat::master_error& error) { configured(each, error, now, out); }, now);
    case work::safe_op_all:
        return set_up_all(
            state_changes_, phase::safe_op, [](const place& each) { return goes_to_safe_op(each); }, now, out);
    case work::op_all:
        return set_up_all(
            state_changes_, phase::in_state, [](const place& each) { return each.at == phase::safe_op; }, now, out);
    default: return;
    }
}

JAUSCAT_FUNCTION void ring::cleared(place& at, std::size_t slaves, time_point now) {
    is_cleared_ = true;
    static_cast<void>(begin_bring_up(at, now));
    is_cleared_ = slaves != 0;
}

JAUSCAT_FUNCTION void ring::brought_up(place& at, const ethercat::master_error& error, time_point now) {
    at.bring_up = error;
    at.is_slow = at.is_slow || is_slow(error);
    at.next_try = saturating_add(now, at.front->timing().bring_up_interval);
    if (error != ethercat::master_error{}) return at.front->watcher().bring_up_failed(*at.front, error);
    is_cleared_ = true;
    clocks_.leave_out_none();
    reach_pre_op(at);
}

JAUSCAT_FUNCTION void ring::reach_pre_op(place& at) {
    at.takes_keep_alive = true;
    at.has_reply = false;
    at.at = at.front->options().cyclic ? phase::pre_op : phase::in_state;
    if (at.at == phase::pre_op) at.front->watcher().slave_up(*at.front, *master_.find(at.front->station()), false);
}

JAUSCAT_FUNCTION void ring::placed(place& at, const ethercat::master_error& error, time_point now,
                                   jaus::message_sink out) {
    if (error != ethercat::master_error{}) {
        at.bring_up = error;
        return lose(at, loss::no_station, error, now, out);
    }
    set_up(at, {}, phase::settling, now, out);
}

JAUSCAT_FUNCTION void ring::set_up(place& at, const ethercat::master_error& error, phase next, time_point now,
                                   jaus::message_sink out) {
    if (at.at == phase::absent) return; // it was lost meanwhile
    if (error != ethercat::master_error{}) {
        at.bring_up = error;
        at.is_slow = at.is_slow || is_slow(error);
        return lose(at, loss::no_process_data, error, now, out);
    }
    at.at = next;
    const bool is_cyclic = at.front->options().cyclic;
    if (next == (is_cyclic ? phase::safe_op : phase::settling)) rebuild_process_data(now);
    if (next == phase::safe_op) at.settling_until = saturating_add(now, options_.clock_timeout);
    if (next != phase::settling) return;
    at.settling_until = saturating_add(now, options_.master.state_timeout);
    if (!is_cyclic && !is_periodic()) next_cycle_ = now; // its state is read at once
}

JAUSCAT_FUNCTION void ring::ready(place& at, time_point now) {
    at.at = phase::up;
    at.is_slow = false;
    at.up_since = now;
    at.silence = {};
    at.front->set_up(true);
    for (component* unit : at.front->components())
        if (unit->is_up()) unit->on_slave_up();
}

JAUSCAT_FUNCTION message_lane* ring::lane_of(const place& at) const noexcept {
    const auto found = std::ranges::find(lanes_, at.front, &message_lane::front);
    return found == lanes_.end() ? nullptr : &*found;
}

JAUSCAT_FUNCTION bool ring::is_carried(const place& at) const noexcept {
    const auto* const lane = lane_of(at);
    return lane != nullptr && lane->is_busy();
}

JAUSCAT_FUNCTION message_lane* ring::free_lane(const place& at, time_point now) const noexcept {
    if (auto* const own = lane_of(at)) return own->is_busy() ? nullptr : own;
    const auto found = std::ranges::find_if(
        lanes_, [&](const message_lane& each) { return !each.is_busy() && now >= each.master().settled_at(); });
    return found == lanes_.end() ? nullptr : &*found;
}

JAUSCAT_FUNCTION std::optional<time_point> ring::lane_from(const place& at) const noexcept {
    if (const auto* const own = lane_of(at)) return own->is_busy() ? std::nullopt : std::optional{last_turn_};
    std::optional<time_point> first;
    for (const message_lane& each : lanes_)
        if (!each.is_busy()) first = std::min(first.value_or(time_point::max()), each.master().settled_at());
    return first;
}

JAUSCAT_FUNCTION bool ring::carry(time_point now, jaus::message_sink out) {
    bool is_changed = false;
    for (message_lane& each : lanes_)
        if (each.advance()) {
            end_message(each, now, out);
            is_changed = true;
        }
    for (place& each : places()) is_changed = begin_stop(each, now) || is_changed;
    for (std::size_t i = 0; i != place_count_; ++i) {
        const auto turn = (last_carried_ + 1 + i) % place_count_;
        if (!begin_other(memory_[turn], now)) continue;
        last_carried_ = turn;
        is_changed = true;
    }
    return is_changed;
}

JAUSCAT_FUNCTION bool ring::begin_stop(place& at, time_point now) {
    if (!at.front->up() || master_.serves(at.front->station())) return false;
    for (component* unit : at.front->components()) {
        const auto what = unit->stops().next();
        if (!what || unit->stops().next_attempt() > now || stops_by_process_data(*unit, *what)) continue;
        auto* const lane = free_lane(at, now);
        if (lane == nullptr) return false;
        const auto size = unit->stop_message(*what, lane->message());
        return begin_message(*lane, {at.front, purpose::stop, unit, *what, {}}, size);
    }
    return false;
}

JAUSCAT_FUNCTION bool ring::begin_other(place& at, time_point now) {
    if (at.at != phase::up || master_.serves(at.front->station())) return false;
    if (next_work_of(at).value_or(time_point::max()) > now) return false; // most of the time, for most slaves
    auto* const lane = free_lane(at, now);
    if (lane == nullptr) return false;
    if (at.has_reply) return begin_message(*lane, {.front = at.front, .what = purpose::emergencies}, 0);
    return begin_order(at, *lane) || begin_keep_alive(at, *lane, now);
}

JAUSCAT_FUNCTION bool ring::is_held_back(const order& each) noexcept {
    return each.unit->stops().next() && !is_query(each.header);
}

JAUSCAT_FUNCTION bool ring::may_go_by_mailbox(const order& each) {
    return !is_held_back(each) && !goes_by_process_data(each);
}

JAUSCAT_FUNCTION const order* ring::next_order(place& at) {
    const auto units = at.front->components();
    for (std::size_t i = 0; i != units.size(); ++i) {
        const auto turn = (at.last_unit + 1 + i) % units.size();
        const order* const found = at.front->orders().first(
            [&](const order& each) { return each.unit == units[turn] && may_go_by_mailbox(each); });
        if (found == nullptr) continue;
        at.last_unit = turn;
        return found;
    }
    return nullptr;
}

JAUSCAT_FUNCTION bool ring::begin_order(place& at, message_lane& lane) {
    auto& orders = at.front->orders();
    const order* const next = next_order(at);
    if (next == nullptr) return false;
    const order taken = *next;
    jaus::header head = taken.header;
    head.destination = taken.unit->self(); // also where all of a level are meant
    const auto made = jaus::join(head, orders.body(*next), lane.message());
    orders.remove(*next);
    return begin_message(lane, {at.front, purpose::order, taken.unit, {}, taken}, made ? made->size() : 0);
}

JAUSCAT_FUNCTION bool ring::begin_keep_alive(place& at, message_lane& lane, time_point now) {
    if (at.front->options().cyclic || at.front->timing().keep_alive == duration{} || !at.takes_keep_alive ||
        now < at.next_keep_alive || at.front->components().empty())
        return false;
    auto* const unit = at.front->components().front();
    const auto made = jaus::make_message({.destination = unit->self(), .source = unit->self()},
                                         jaus::report_heartbeat_pulse{}, lane.message());
    return begin_message(lane, {at.front, purpose::keep_alive, unit, {}, {}}, made->size());
}

JAUSCAT_FUNCTION bool ring::begin_message(message_lane& lane, const message_lane::task& what, std::size_t size) {
    lane.begin(what, size, master_, {.download = options_.download});
    return true;
}

JAUSCAT_FUNCTION void ring::end_message(message_lane& lane, time_point now, jaus::message_sink out) {
    const auto& task = lane.current();
    const auto ended = lane.take_outcome(master_);
    place& at = *std::ranges::find(places(), task.front, &place::front);
    if (task.what == purpose::emergencies) {
        at.has_reply = false;
        return tell_emergencies(at);
    }
    if (ended.was_withdrawn) {
        task.unit->on_not_executed(task.message.header, {.why = refusal::stopped}, now, out);
        return tell_emergencies(at);
    }
    const auto& exchange = at.front->exchange();
    const refusal_reason why{.why =
                                 exchange.error() != translate::errc::ok ? refusal::not_translated : refusal::by_slave,
                             .error = exchange.error(),
                             .status = exchange.status(),
                             .of_master = ended.error};
    const bool answers = ended.is_done || is_of_slave(ended.error);
    const bool has_got_it = answers && why.why != refusal::not_translated;
    if (has_got_it) at.next_keep_alive = saturating_add(now, at.front->timing().keep_alive);
    switch (task.what) {
    case purpose::order: end_order(task, ended, why, now, out); break;
    case purpose::stop: end_stop(task, ended.is_done, why, now, out); break;
    default:
        if (ended.is_done || !answers) break;
        at.takes_keep_alive = false;
        at.front->watcher().no_keep_alive(*at.front, why);
    }
    tell_emergencies(at);
    if (!answers) lose(at, loss::no_answer, ended.error, now, out);
}

JAUSCAT_FUNCTION bool ring::is_of_slave(const ethercat::master_error& error) noexcept {
    using enum ethercat::master_errc;
    return error.code == ok || error.code == sdo_abort || error.code == clear_refused || error.code == mailbox_error ||
           error.code == data_too_long;
}

JAUSCAT_FUNCTION void ring::end_order(const message_lane::task& task, const message_lane::outcome& ended,
                                      const refusal_reason& why, time_point now, jaus::message_sink out) {
    if (!ended.is_done) return task.unit->on_not_executed(task.message.header, why, now, out);
    if (!ended.report.empty()) out(ended.report);
    task.unit->on_executed(task.message.header, now, out);
}

JAUSCAT_FUNCTION void ring::end_stop(const message_lane::task& task, bool was_executed, const refusal_reason& why,
                                     time_point now, jaus::message_sink out) {
    // A confirmation from before the slave's loss does not count: the order is sent again when the slave is back.
    if (was_executed && !task.front->up()) return;
    if (was_executed) return task.unit->on_confirmed(task.stop, now, out);
    using enum ethercat::abort_code;
    const auto code = why.of_master.abort;
    const bool is_unknown =
        (why.of_master.code == ethercat::master_errc::sdo_abort && (code == no_object || code == no_subindex)) ||
        why.error == translate::errc::unknown_index;
    task.unit->on_refused(task.stop, is_unknown, why, now, out);
}

JAUSCAT_FUNCTION void ring::tell_emergencies(place& at) {
    const auto* const record = master_.find(at.front->station());
    if (record == nullptr) return;
    for (const auto& each : record->emergencies.kept()) at.front->watcher().slave_emergency(*at.front, each);
    master_.clear_emergencies(at.front->station());
}

JAUSCAT_FUNCTION std::optional<time_point> ring::hindered_until() const {
    if (!hindered_since_) return std::nullopt;
    return saturating_add(*hindered_since_, options_.stop_timeout);
}

JAUSCAT_FUNCTION void ring::stop_what_hinders(time_point now) {
    const auto* const waiting = hindered(now);
    if (waiting == nullptr) return hindered_since_.reset();
    if (!hindered_since_) hindered_since_ = now;
    if (now - *hindered_since_ < options_.stop_timeout) return;
    hindered_since_.reset();
    // A late reply could be mistaken for the next one's, so a slave whose transfer is cancelled counts as lost and
    // is brought up again.
    if (master_.serves(waiting->front->station())) return master_.cancel(ethercat::master_errc::timeout);
    const auto found = std::ranges::find_if(
        lanes_, [](const message_lane& each) { return each.is_busy() && each.current().what != purpose::stop; });
    if (found != lanes_.end()) found->cancel();
}

JAUSCAT_FUNCTION const ring::place* ring::hindered(time_point now) const {
    const auto waits = [&](const component* unit) {
        const auto what = unit->stops().next();
        return unit->stops().stop_is_pending() && unit->stops().next_attempt() <= now &&
               !stops_by_process_data(*unit, *what);
    };
    const auto found = std::ranges::find_if(places(), [&](const place& each) {
        return each.front->up() && std::ranges::any_of(each.front->components(), waits) && !is_carried(each) &&
               (master_.serves(each.front->station()) || free_lane(each, now) == nullptr);
    });
    return found == places().end() ? nullptr : &*found;
}

JAUSCAT_FUNCTION void ring::drop_after_pause(time_point now) {
    for (message_lane& each : lanes_)
        if (each.is_busy() && each.current().what == purpose::order &&
            now - last_turn_ >= each.current().front->timing().data_limit)
            each.cancel();
}

JAUSCAT_FUNCTION void ring::refuse_expired(time_point now, jaus::message_sink out) {
    for (place& each : places())
        each.front->orders().remove_if(
            [&](const order& waiting) { return waiting.expires.is_reached(now); },
            [&](const order& late) { late.unit->on_not_executed(late.header, {.why = refusal::expired}, now, out); });
}

JAUSCAT_FUNCTION std::optional<time_point> ring::next_work_of(const place& at) const {
    switch (at.at) {
    case phase::absent: return at.front->options().is_taken_over ? std::nullopt : std::optional{at.next_try};
    case phase::has_clock: return is_in_time(at) ? time_point::min() : at.next_look;
    case phase::safe_op:
        if (has_sync(at) && !is_synchronized(at)) return at.settling_until;
        [[fallthrough]];
    case phase::pre_op:
    case phase::configured:
    case phase::has_sync:
    case phase::in_state: return time_point::min();
    case phase::settling: return at.settling_until;
    case phase::up: break;
    }
    if (at.has_reply || at.front->orders().first(may_go_by_mailbox) != nullptr) return time_point::min();
    std::optional<time_point> next;
    const auto consider = [&](time_point other) { next = next ? std::min(*next, other) : other; };
    for (const component* unit : at.front->components())
        if (const auto what = unit->stops().next(); what && !stops_by_process_data(*unit, *what))
            consider(unit->stops().next_attempt());
    if (!at.front->options().cyclic && at.takes_keep_alive && at.front->timing().keep_alive != duration{})
        consider(at.next_keep_alive);
    return next;
}

JAUSCAT_FUNCTION void ring::lose(place& at, loss what, const ethercat::master_error& why, time_point now,
                                 jaus::message_sink out) {
    if (at.at == phase::absent) return; // its last job has ended only now
    const bool was_up = at.front->up();
    at.at = phase::absent;
    at.clock_is_set = false;
    at.start_up_object = 0;
    at.checked_parts = 0;
    at.start_up = {};
    at.next_try = was_up ? now : saturating_add(now, at.front->timing().bring_up_interval);
    std::array<bool, component_capacity> were_up{};
    std::ranges::transform(at.front->components(), were_up.begin(), [](auto* unit) { return unit->is_up(); });
    at.front->set_up(false);
    at.front->set_data({});
    clocks_.lost(at.front->station());
    at.front->watcher().slave_lost(*at.front, what, why);
    // What it carries would be requested again, and reach a slave that returns. Its sender learns that it is refused
    // before it learns that it has no control.
    if (is_carried(at)) {
        auto& lane = *lane_of(at);
        lane.cancel();
        if (lane.advance()) end_message(lane, now, out);
    }
    for (std::size_t i = 0; i != at.front->components().size(); ++i) {
        component& unit = *at.front->components()[i];
        unit.front().orders().remove_if(
            [&](const order& each) { return each.unit == &unit; },
            [&](const order& each) { unit.on_not_executed(each.header, {.why = refusal::slave_down}, now, out); });
        if (auto* const process = unit.process()) process->leave_out(*at.front);
        if (were_up[i]) unit.on_slave_lost(now, out);
    }
    rebuild_process_data(now);
}

JAUSCAT_FUNCTION bool ring::is_exchanged(const place& at) noexcept {
    return at.at >= (at.front->options().cyclic ? phase::safe_op : phase::settling);
}

JAUSCAT_FUNCTION void ring::rebuild_process_data(time_point now) {
    if (holds_rebuild_) {
        is_rebuild_due_ = true;
        return;
    }
    std::size_t count = 0;
    for (place& each : places()) {
        const auto* const record = master_.find(each.front->station());
        if (is_exchanged(each) && record != nullptr) records_[count++] = *record;
    }
    const bool is_interrupted = data_.waits();
    data_.set_slaves(records_.first(count),
                     {.watch_slaves = true, .watch_together = true, .logical_base = logical_base_});
    // The outputs are those of the cycle that is due next: it keeps its time, also where the next ones are shorter.
    const bool had_process_data = std::exchange(has_process_data_, data_.image().size != 0);
    if (!cycles()) cycle_begun_.reset();
    // A look at the states that is forgotten is taken again at once: the next one may be too late for the others.
    const bool looks_again = is_interrupted && !is_periodic();
    if (!cycles() || looks_again || (!had_process_data && next_cycle_ > saturating_add(now, interval())))
        next_cycle_ = now;
    exchanged_ = count;
    for (place& each : places()) {
        const auto* const record = is_exchanged(each) ? master_.find(each.front->station()) : nullptr;
        each.outputs = record == nullptr ? std::span<std::byte>{} : data_.outputs(*record);
        each.inputs = record == nullptr ? bytes{} : data_.inputs(*record);
        each.status = record == nullptr ? nullptr : &data_.status(*record);
        show_data(each);
    }
}

JAUSCAT_FUNCTION void ring::show_data(place& at) {
    if (at.at != phase::up || at.status == nullptr || !at.front->options().cyclic) return at.front->set_data({});
    at.front->set_data({at.outputs, at.inputs, *at.status});
}

JAUSCAT_FUNCTION bool ring::stops_by_process_data(const component& unit, stop_order what) {
    const auto* const process = unit.process();
    return process != nullptr && (what == stop_order::rest || !process->part().uses_mailbox());
}

JAUSCAT_FUNCTION bool ring::goes_by_process_data(const order& each) {
    const auto* const process = each.unit->process();
    return process != nullptr && process->takes(each.header);
}

JAUSCAT_FUNCTION void ring::watch_cycles(time_point now, jaus::message_sink out) {
    for (place& each : places()) {
        if (!is_exchanged(each) || each.status == nullptr) continue;
        const auto& seen = *each.status;
        using enum ethercat::slave_condition;
        if (each.at == phase::settling) {
            const bool is_cyclic = each.front->options().cyclic;
            if (is_cyclic ? seen.condition == running : is_seen(seen) && works_in(each, seen.al))
                start_process_data(each, now, out);
            else if (has_lost_station(each) || now >= each.settling_until) // later another slave may have its address
                give_up_settling(each, now, out);
            continue;
        }
        if (each.at != phase::up) continue;
        if (std::exchange(each.looked_at, seen.last_frame) != seen.last_frame)
            each.has_reply = seen.reply_waiting && !is_carried(each); // which takes it itself
        show_data(each);
        const ethercat::master_error state{
            .code = ethercat::master_errc::al_error, .state = seen.al.state, .al_status = seen.al.code};
        if (seen.condition == absent)
            lose(each, loss::no_station, {.code = ethercat::master_errc::working_counter}, now, out);
        else if (seen.condition == duplicate)
            lose(each, loss::no_station, {.code = ethercat::master_errc::duplicate_station}, now, out);
        else if (seen.condition != silent && !works_in(each, seen.al))
            lose(each, loss::left_state, state, now, out);
        else if (each.silence >= each.front->timing().longest_silence)
            lose(each, loss::no_answer, {.code = ethercat::master_errc::no_reply}, now, out);
    }
    // Another user of the bus has scanned it: the slave has no station address any more.
    for (place& each : places())
        if (is_exchanged(each) && each.status == nullptr)
            lose(each, loss::no_station,
                 {.code = ethercat::master_errc::wrong_station, .station = each.front->station()}, now, out);
}

JAUSCAT_FUNCTION void ring::skip_to_next_cycle(time_point now) noexcept {
    const auto soonest = now + interval() / 2;
    next_cycle_ += interval();
    tell_period(); // the next outputs are sent then
    if (next_cycle_ >= soonest) return;
    next_cycle_ = clocks_.runs() ? next_cycle_ + ((soonest - next_cycle_) / interval() + 1) * interval() : soonest;
}

JAUSCAT_FUNCTION void ring::end_cycle(time_point now) {
    if (std::exchange(is_cycle_ended_, true)) return;
    next_cycle_ += clocks_.end_cycle();
    if (!cycle_begun_) return;
    const auto lasted = std::min(now - *cycle_begun_, interval());
    for (place& each : places()) {
        if (each.status == nullptr || each.up_since > *cycle_begun_) continue; // of one that is not up it is not used
        const auto last = last_working(each, *each.status);
        each.silence = last && *last >= *cycle_begun_ ? duration{} : each.silence + lasted;
    }
}

// Whether its state is known: one slave, and not several, has answered at its station address.
JAUSCAT_FUNCTION bool ring::is_seen(const ethercat::slave_status& seen) noexcept {
    using enum ethercat::slave_condition;
    return seen.condition != silent && seen.condition != absent && seen.condition != duplicate;
}

// In a frame of its settling, and not in one that was sent before it was brought up.
JAUSCAT_FUNCTION bool ring::has_lost_station(const place& at) const noexcept {
    using enum ethercat::slave_condition;
    const auto& seen = *at.status;
    return (seen.condition == absent || seen.condition == duplicate) && seen.last_frame &&
           saturating_add(*seen.last_frame, options_.master.state_timeout) >= at.settling_until;
}

JAUSCAT_FUNCTION void ring::give_up_settling(place& at, time_point now, jaus::message_sink out) {
    const auto& seen = *at.status;
    const bool is_cyclic = at.front->options().cyclic;
    if (!is_cyclic && is_seen(seen) && !works_in(at, seen.al)) {
        at.bring_up = {.code = ethercat::master_errc::al_error, .state = seen.al.state, .al_status = seen.al.code};
        return lose(at, loss::left_state, at.bring_up, now, out);
    }
    at.bring_up = {.code = ethercat::master_errc::working_counter};
    lose(at, is_cyclic ? loss::no_process_data : loss::no_station, at.bring_up, now, out);
}

JAUSCAT_FUNCTION bool ring::works_in(const place& at, const ethercat::al_status& al) noexcept {
    using enum ethercat::al_state;
    if (at.front->options().cyclic) return al.state == op;
    return !al.error && (al.state == op || al.state == pre_op || al.state == safe_op);
}

JAUSCAT_FUNCTION std::optional<time_point> ring::last_working(const place& at,
                                                              const ethercat::slave_status& seen) noexcept {
    if (at.front->options().cyclic) return seen.last_running;
    return works_in(at, seen.al) ? seen.last_frame : std::nullopt;
}

JAUSCAT_FUNCTION void ring::start_process_data(place& at, time_point now, jaus::message_sink out) {
    if (at.front->options().cyclic) at.front->set_data({at.outputs, at.inputs, *at.status});
    for (component* unit : at.front->components()) {
        auto* const process = unit->process();
        if (process == nullptr || std::ranges::any_of(process->fronts(), [&](const slave_front* each) {
                return each != at.front && !each->up();
            }))
            continue;
        const auto& timing = unit->front().timing();
        if (!process->start({options_.period, timing.rest_limit, timing.ramp_limit}))
            return lose(at, loss::no_process_data, {.code = ethercat::master_errc::size_mismatch}, now, out);
    }
    at.front->watcher().slave_up(*at.front, *master_.find(at.front->station()), true);
    ready(at, now);
}

JAUSCAT_FUNCTION void ring::use_process_data(time_point now, jaus::message_sink out) {
    const bool steps = std::exchange(is_step_due_, false);
    for (place& each : places()) {
        if (!each.front->options().cyclic) continue;
        for (component* unit : each.front->components()) {
            auto* const process = unit->process();
            if (process == nullptr || process->fronts().front() != each.front || !process->has_begun()) continue;
            if (steps) {
                put_stop(*unit, *process, now, out); // a command that came before is not in these outputs
                unit->on_step(process->step(now), now, out);
            }
            take_confirmations(*unit, *process, now, out);
            put_stop(*unit, *process, now, out);
            if (process->is_started()) put_orders(*unit, *process, now, out);
        }
    }
    if (steps) shared_.cycle();
}

JAUSCAT_FUNCTION void ring::put_stop(component& unit, process_channel& process, time_point now,
                                     jaus::message_sink out) {
    const auto& stops = unit.stops();
    const auto next = stops.next();
    if (next == stop_order::clear_emergency && !process.part().uses_mailbox())
        return unit.on_confirmed(stop_order::clear_emergency, now, out);
    if (!stops.stop_is_pending() || !process.has_slaves()) return;
    const bool is_awaited = process.is_started() && stops_by_process_data(unit, *next) && stops.next_attempt() <= now;
    const auto what = is_awaited ? *next : stop_order::rest;
    const auto waiting = process.waiting_stop();
    if (waiting == what || waiting == stop_order::emergency || (process.has_rest_outputs() && !is_awaited)) return;
    // While one of the slaves is lost the others have the same time, though the order counts as executed by all alone.
    const bool is_limited = is_awaited || !process.is_started();
    const auto limit = is_limited ? std::optional{unit.front().timing().data_limit} : std::nullopt;
    const auto number = process.stop(what, limit, now, [&](const jaus::header& head) {
        unit.on_not_executed(head, {.why = refusal::stopped}, now, out);
    });
    unit.front().watcher().into_image(unit.front(), number, unit.front().data().outputs);
}

JAUSCAT_FUNCTION void ring::put_orders(component& unit, process_channel& process, time_point now,
                                       jaus::message_sink out) {
    auto& orders = unit.front().orders();
    while (const order* const next = orders.first([&](const order& each) {
        return each.unit == &unit && goes_by_process_data(each) && !is_held_back(each);
    })) {
        jaus::header head = next->header;
        const auto body = orders.body(*next);
        orders.remove(*next);
        if (is_query(head))
            answer(unit, process, head, body, now, out);
        else if (const auto why = put_command(unit, process, head, body, now, out))
            unit.on_not_executed(head, *why, now, out);
    }
}

JAUSCAT_FUNCTION std::optional<refusal_reason> ring::put_command(component& unit, process_channel& process,
                                                                 const jaus::header& head, bytes body, time_point now,
                                                                 jaus::message_sink out) {
    if (const auto first = process.make_room()) unit.on_not_executed(*first, {.why = refusal::superseded}, now, out);
    const auto& watcher = unit.front().watcher();
    const bool is_merged = watcher.merged && process.merges_next();
    const auto number = process.command(head, body, unit.front().timing().data_limit, now);
    if (!number) return refusal_reason{.why = refusal::not_translated, .error = number.error()};
    while (const auto older = process.drop_overdue(now))
        unit.on_not_executed(*older, {.why = refusal::superseded}, now, out);
    watcher.into_image(unit.front(), *number, unit.front().data().outputs);
    if (is_merged) watcher.merged(unit, head);
    return std::nullopt;
}

JAUSCAT_FUNCTION void ring::answer(component& unit, process_channel& process, const jaus::header& query, bytes body,
                                   time_point now, jaus::message_sink out) {
    if (!process.has_inputs_within(unit.front().timing().data_limit, now))
        return unit.on_not_executed(query, {.why = refusal::stale}, now, out);
    jaus::header head = query;
    head.destination = unit.self();                          // also where all of a level are meant
    std::array<std::byte, any_exchange::buffer_size> report; // not packet_, which a running transfer may use
    const auto made = process.answer(head, body, report);
    if (!made) return unit.on_not_executed(query, {.why = refusal::not_translated, .error = made.error()}, now, out);
    unit.front().watcher().from_image(unit.front(), unit.front().data().inputs);
    out(*made);
    unit.on_executed(query, now, out);
}

JAUSCAT_FUNCTION void ring::take_confirmations(component& unit, process_channel& process, time_point now,
                                               jaus::message_sink out) {
    using enum process_channel::outcome;
    bool takes_stops = true;
    while (const auto over = process.next_ended(now)) {
        if (over->stop && over->how == executed) {
            if (process.is_started()) unit.on_confirmed(*over->stop, now, out);
        } else if (over->stop) {
            if (process.is_started()) unit.on_refused(*over->stop, false, {.why = refusal::not_accepted}, now, out);
            takes_stops = false;
        } else if (over->how == executed) {
            unit.on_executed(over->header, now, out);
        } else if (over->how == superseded) {
            unit.on_not_executed(over->header, {.why = refusal::superseded}, now, out);
        } else {
            unit.on_not_accepted(over->header, now, out);
        }
    }
    if (takes_stops) return;
    for (place& each : places())
        if (each.front->up() && std::ranges::count(process.fronts(), each.front) != 0)
            lose(each, loss::no_process_data, {.code = ethercat::master_errc::timeout}, now, out);
}

} // namespace jauscat::bridging
