#include "simulation/ring.hpp"

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/watchdog.hpp>

namespace simulation {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
namespace registers = ethercat::esc_registers;

constexpr time tick_time = milliseconds{10};
constexpr time hop_time = std::chrono::nanoseconds{700}; // from a slave to the next one
constexpr std::byte safe_op_with_error{0x14};
constexpr std::array ring_faults{fault::cable_out,    fault::slave_frozen,     fault::slave_restarted,
                                 fault::slave_aborts, fault::slave_falls_back, fault::mailbox_recounted,
                                 fault::other_master, fault::unknown_state,    fault::error_reported,
                                 fault::slave_slow,   fault::slave_emergency};
constexpr std::array rough_faults{fault::slaves_swapped, fault::station_doubled};
constexpr std::array drive_faults{fault::drive_fault, fault::drive_unpowered, fault::drive_deaf};

} // namespace

void ring::add(std::string name, std::uint16_t station, bool cyclic) {
    const auto i = places_.size();
    ring_place made{.number = world_.add(std::move(name)), .station = station, .cyclic = cyclic};
    places_.push_back(std::move(made));
    order_.push_back(i);
}

void ring::add_arm(std::string name, std::uint16_t station, bool cyclic, const arm_settings& what) {
    const auto i = places_.size();
    add(std::move(name), station, cyclic);
    auto made =
        std::make_unique<arm_unit>(serial_of(i), [this, i](command_number command) { moved_(i, 0, command); }, what);
    places_.back().arm = made.get();
    places_.back().unit = std::move(made);
}

void ring::add_drive(std::string name, std::uint16_t station, std::size_t axes, std::size_t first_joint,
                     const std::optional<ethercat::clock_error>& clock) {
    has_clocks_ = has_clocks_ || clock;
    const auto i = places_.size();
    add(std::move(name), station, true);
    auto made = make_drive(
        axes, serial_of(i), first_joint,
        [this, i](std::size_t axis, command_number command) { moved_(i, axis, command); }, clock);
    places_.back().drive = made.get();
    places_.back().unit = std::move(made);
}

void ring::start(frame_user& user) {
    user_ = &user;
    world_.in(tick_time, *this, tick);
    for (std::size_t i = 0; i != places_.size(); ++i) {
        give_odd_watchdog(i);
        let_keep_watchdog(i);
    }
    for (const auto kind : ring_faults) try_later(kind);
    if (is_rough_)
        for (const auto kind : rough_faults) try_later(kind);
    if (std::ranges::any_of(places_, [](const ring_place& each) { return each.drive != nullptr; }))
        for (const auto kind : drive_faults) try_later(kind);
}

void ring::try_later(fault kind) {
    world_.in(world_.faults.pause(kind, std::chrono::seconds{2}), *this, trial, static_cast<std::uint32_t>(kind));
}

void ring::tell(std::size_t place, ring_deed what, std::uint32_t value) {
    // What was sent while the cable was out is sent again when it is back.
    constexpr std::array of_frames{ring_deed::frame_lost, ring_deed::frame_delayed, ring_deed::frame_doubled,
                                   ring_deed::frame_damaged, ring_deed::cable_back};
    if (std::ranges::find(of_frames, what) != of_frames.end())
        frames_disturbed_at_[disturbed_frames_++ % frames_disturbed_at_.size()] = world_.now();
    world_.tell(
        {.what = deed::ring, .who = places_[place].number, .number = static_cast<std::uint16_t>(what), .value = value});
}

time ring::frames_disturbed_at() const noexcept {
    return disturbed_frames_ == 0 ? time{}
                                  : frames_disturbed_at_[(disturbed_frames_ - 1) % frames_disturbed_at_.size()];
}

std::ptrdiff_t ring::frames_disturbed_since(time then) const noexcept {
    const auto known = std::span{frames_disturbed_at_}.first(std::min(disturbed_frames_, frames_disturbed_at_.size()));
    return std::ranges::count_if(known, [&](time each) { return each >= then; });
}

// ---------------------------------------------------------------------------------------------------- frames

void ring::send(bytes frame) {
    world_.sees("a frame", frame);
    const bool is_lost = world_.faults.strikes(fault::frame_lost, 3'000);
    const bool before = is_lost && world_.faults.random(fault::frame_lost).below(2) == 0;
    if (is_lost) tell(0, ring_deed::frame_lost, before ? 0 : 1);
    if (before)
        for (auto& each : places_) each.missed_at = world_.now();
    if (before || frame.size() > ethercat::max_frame_size) return;
    if (free_.empty()) {
        free_.push_back(static_cast<std::uint32_t>(flights_.size()));
        flights_.push_back(std::make_unique<flight>());
    }
    const auto place = free_.back();
    flight& one = *flights_[place];
    one.size = frame.size();
    std::ranges::copy(frame, one.bytes.begin());
    auto& random = world_.faults.random(fault::frame_damaged);
    const bool is_damaged = is_rough_ && world_.faults.strikes(fault::frame_damaged, 3'000);
    const bool is_discarded = is_damaged && random.below(2) == 0; // by the slave behind the place
    pass(std::span{one.bytes}.first(one.size), is_discarded ? random.below(places_.size()) : places_.size());
    if (is_damaged && !is_discarded) one.size = random.below(one.size);
    if (is_damaged) tell(0, ring_deed::frame_damaged, is_discarded ? 0 : static_cast<std::uint32_t>(one.size));
    if (is_lost || is_discarded || (cable_out_before_ && *cable_out_before_ == 0)) return;
    free_.pop_back();
    time delay = world_.faults.random(fault::frame_delayed).between(microseconds{30}, microseconds{200});
    if (world_.faults.strikes(fault::frame_delayed, 1'000)) {
        delay = world_.faults.random(fault::frame_delayed).between(milliseconds{1}, milliseconds{60});
        tell(0, ring_deed::frame_delayed, static_cast<std::uint32_t>(delay / microseconds{1}));
    }
    if (is_rough_ && world_.faults.strikes(fault::frame_doubled, 3'000)) {
        const time later = world_.faults.random(fault::frame_doubled).between(microseconds{1}, milliseconds{30});
        tell(0, ring_deed::frame_doubled, static_cast<std::uint32_t>(later / microseconds{1}));
        world_.in(delay, *this, returns, place | is_copy);
        delay += later;
    }
    world_.in(delay, *this, returns, place);
}

void ring::pass(std::span<std::byte> frame, std::size_t end) {
    const auto first_unreachable = std::ranges::find_if(order_, [&](std::size_t i) { return !is_reachable(i); });
    const auto count = std::min(end, static_cast<std::size_t>(first_unreachable - order_.begin()));
    for (std::size_t k = 0; k != count; ++k) {
        const auto i = order_[k];
        auto& at = places_[i];
        if (has_clocks_)
            at.unit->slave().set_connected(1, order_.begin() + static_cast<std::ptrdiff_t>(k) + 1 != first_unreachable);
        at.unit->pass(frame, world_.now(), static_cast<std::int64_t>(k) * hop_time, at.frozen);
        at.passed_at = world_.now();
        alter(at, frame);
        if (at.arm != nullptr && at.arm->take_aborted()) at.disturbed_at = world_.now();
        look(at);
    }
    for (std::size_t k = count; k != order_.size(); ++k) places_[order_[k]].missed_at = world_.now();
    if (!has_clocks_ || count != static_cast<std::size_t>(first_unreachable - order_.begin())) return;
    for (std::size_t k = count; k-- > 1;) // back past the slaves before it
        places_[order_[k - 1]].unit->slave().frame_returned(
            1, jauscat::time_point{world_.now() + static_cast<std::int64_t>(2 * count - k) * hop_time});
}

// What other slaves answer in its place: mailbox counters that are its own, an AL state that nobody knows.
void ring::alter(ring_place& at, std::span<std::byte> frame) {
    ethercat::mutable_frame_view view;
    if (!view.parse(frame)) return;
    constexpr std::uint16_t mailbox_out = ethercat::slave_description{}.mailbox_out_offset;
    constexpr std::uint16_t mailbox_in = ethercat::slave_description{}.mailbox_in_offset;
    for (auto one : view) {
        if (at.reports_error && one.header.cmd == ethercat::command::brd &&
            one.header.ado == registers::al_status.address && !one.data.empty())
            one.data[0] |= safe_op_with_error;
        if (one.header.adp != at.unit->slave().station_address() || one.working_counter == 0) continue;
        if (at.keeps_watchdog && one.header.cmd == ethercat::command::fpwr) keep_watchdog(at, one);
        if (one.header.cmd == ethercat::command::fpwr && one.header.ado == mailbox_out)
            at.mailbox_written_at = world_.now();
        if (one.header.cmd != ethercat::command::fprd) continue;
        if (one.header.ado == mailbox_in && one.data.size() >= at.last_reply.size()) {
            const auto reply = one.data.first(at.last_reply.size());
            if (!std::ranges::equal(reply, at.last_reply)) {
                std::ranges::copy(reply, at.last_reply.begin());
                at.last_reply_recount = at.recount;
            }
            if (at.last_reply_recount == 0) continue;
            const auto old = std::to_integer<unsigned>(one.data[5]);
            const unsigned counter = ((old >> 4U) + at.last_reply_recount) % 7 + 1;
            one.data[5] = static_cast<std::byte>((old & 0x0FU) | counter << 4U);
        }
        if (at.state_is_unknown && one.header.ado == registers::al_status.address && !one.data.empty())
            one.data[0] &= std::byte{0xF0};
        if (at.reports_error && one.header.ado == registers::al_status.address && !one.data.empty())
            one.data[0] = safe_op_with_error;
    }
}

std::size_t ring::position_of(std::size_t i) const noexcept {
    return static_cast<std::size_t>(std::ranges::find(order_, i) - order_.begin());
}
bool ring::is_reachable(std::size_t i) const noexcept {
    const auto position = position_of(i);
    if (cable_out_before_ && position >= *cable_out_before_) return false;
    return std::ranges::none_of(std::span{order_}.first(position + 1), [&](std::size_t k) { return places_[k].away; });
}

// ---------------------------------------------------------------------------------------------------- what is wrong

// A slave by mailbox works in PRE-OP, too; one that reports an error has left the state that the bridge has asked for.
bool ring::works(const ring_place& at) {
    const auto status = at.unit->slave().status();
    if (at.reports_error) return false;
    if (at.cyclic) return status.state == ethercat::al_state::op;
    return !status.error && status.state != ethercat::al_state::init && status.state != ethercat::al_state::boot;
}

void ring::look(ring_place& at) {
    const auto i = static_cast<std::size_t>(&at - places_.data());
    const auto note = [&](std::optional<time>& since, bool is_wrong) {
        if (!is_wrong)
            since.reset();
        else if (!since)
            since = world_.now();
    };
    const auto state = at.unit->slave().state();
    at.seen_in[static_cast<std::size_t>(state) % at.seen_in.size()] = world_.now();
    if (at.reports_error) at.error_told_at = world_.now();
    if (at.state_is_unknown) at.unknown_told_at = world_.now();
    if (at.reports_error && state != at.error_from) at.reports_error = false; // a master has acknowledged it
    if (state != at.told_state) {
        if (state == ethercat::al_state::op) at.watchdog = watchdog_of(at);
        if (at.cyclic ? at.told_state == ethercat::al_state::op : state == ethercat::al_state::init)
            at.left_at = world_.now();
        at.told_state = state;
        tell(i, ring_deed::al_state, static_cast<std::uint32_t>(state));
    }
    note(at.unreachable_since, !is_reachable(i));
    note(at.left_state_since, !works(at));
    note(at.taken_since, at.unit->slave().station_address() != at.station);
    note(at.unknown_since, at.state_is_unknown);
}

std::optional<trouble> ring::trouble_of(std::size_t i) const {
    const auto& at = places_[i];
    std::optional<trouble> worst;
    const auto consider = [&](const char* what, const std::optional<time>& since) {
        if (since && (!worst || *since < worst->since)) worst = trouble{what, *since};
    };
    consider("the link is lost", at.unreachable_since);
    consider("the slave has left its state", at.left_state_since);
    consider("the slave has lost its station address", at.taken_since);
    return worst;
}

void ring::on_event(std::uint8_t what, std::uint32_t argument) {
    switch (what) {
    case returns: {
        const flight& one = *flights_[argument & ~is_copy];
        user_->frame_returns(bytes{one.bytes}.first(one.size));
        if ((argument & is_copy) == 0) free_.push_back(argument);
        return;
    }
    case tick:
        world_.in(tick_time, *this, tick);
        for (auto& at : places_) {
            if (world_.now() - at.passed_at < tick_time) continue; // a frame has had it work
            if (!at.frozen && !at.away) at.unit->on_time(world_.now());
            look(at);
        }
        return;
    case trial: return suffer(static_cast<fault>(argument));
    default: return mend(static_cast<fault>(argument >> 8U), argument & 0xFFU);
    }
}

void ring::suffer(fault kind) {
    try_later(kind);
    if (!world_.faults.strikes(kind, kind == fault::slave_emergency ? 300'000 : 100'000)) return;
    auto& random = world_.faults.random(kind);
    const std::size_t i = random.below(places_.size());
    auto& at = places_[i];
    const time some =
        random.between(milliseconds{2}, random.below(4) == 0 ? time{std::chrono::seconds{3}} : time{milliseconds{300}});
    const auto ms = static_cast<std::uint32_t>(some / milliseconds{1});
    const auto mend_later = [&] {
        world_.in(some, *this, repair, static_cast<std::uint32_t>(kind) << 8U | static_cast<std::uint32_t>(i));
    };
    switch (kind) {
    case fault::slave_emergency: return send_emergency(i); // nothing is wrong with it
    case fault::cable_out:
        if (cable_out_before_) return;
        cable_out_before_ = position_of(i);
        tell(i, ring_deed::cable_out);
        mend_later();
        break;
    case fault::slave_frozen:
        if (at.frozen) return;
        at.frozen = true;
        tell(i, ring_deed::freezes, ms);
        mend_later();
        break;
    case fault::slave_restarted:
        if (at.away) return;
        at.away = true;
        tell(i, ring_deed::restarts, ms);
        at.unit->power_on(world_.now());
        at.restarted_at = world_.now();
        mend_later();
        break;
    case fault::slave_aborts: {
        if (at.arm == nullptr) return;
        constexpr std::array codes{ethercat::abort_code::general,   ethercat::abort_code::device_state,
                                   ethercat::abort_code::no_object, ethercat::abort_code::value_range,
                                   ethercat::abort_code::timeout,   ethercat::abort_code::cannot_store};
        const unsigned count = random.below(8) == 0 ? 50 : 1 + random.below(4);
        at.arm->abort_from_now(count, codes[random.below(codes.size())]);
        tell(i, ring_deed::aborts_next, count);
        break;
    }
    case fault::slave_falls_back: {
        constexpr std::array<std::uint16_t, 5> states{1, 2, 3, 4, 0x11};
        const auto to = states[random.below(states.size())];
        tell(i, ring_deed::falls_back, to);
        write(at, registers::al_control.address, to);
        break;
    }
    case fault::mailbox_recounted:
        at.recount = static_cast<std::uint8_t>(random.below(7));
        at.recounted_at = world_.now();
        tell(i, ring_deed::recounts);
        break;
    case fault::other_master:
        tell(i, ring_deed::taken);
        write(at, registers::station_address.address, static_cast<std::uint16_t>(1000 + random.below(8)));
        if (random.below(2) == 0) write(at, registers::al_control.address, 0x11);
        break;
    case fault::slaves_swapped: return swap(i, random.below(places_.size()));
    case fault::station_doubled: {
        const auto& other =
            places_[(i + 1 + random.below(std::max<std::size_t>(places_.size(), 2) - 1)) % places_.size()];
        tell(i, ring_deed::doubled, other.number);
        write(at, registers::station_address.address, other.station);
        places_[static_cast<std::size_t>(&other - places_.data())].shared_at = world_.now();
        break;
    }
    case fault::drive_fault:
    case fault::drive_unpowered:
    case fault::drive_deaf: return suffer_of_drive(kind, i, some);
    case fault::slave_slow:
        if (at.arm == nullptr || at.cyclic || at.slow != time{}) return;
        at.slow = random.between(milliseconds{20}, milliseconds{60});
        at.arm->set_slow(at.slow);
        tell(i, ring_deed::slow, static_cast<std::uint32_t>(at.slow / milliseconds{1}));
        world_.in(random.between(std::chrono::seconds{1}, std::chrono::seconds{10}), *this, repair,
                  static_cast<std::uint32_t>(kind) << 8U | static_cast<std::uint32_t>(i));
        break;
    case fault::error_reported:
        if (at.reports_error) return;
        at.reports_error = true;
        at.error_from = at.unit->slave().state();
        tell(i, ring_deed::reports_error, ms);
        mend_later();
        break;
    default:
        if (at.state_is_unknown) return;
        at.state_is_unknown = true;
        tell(i, ring_deed::unknown_state, ms);
        mend_later();
    }
    at.disturbed_at = world_.now();
    for (auto& each : places_) look(each);
}

// Two slaves are unplugged and plugged in at each other's places, sometimes without losing their supply: those keep
// their station addresses. Some time later they are put back.
void ring::swap(std::size_t i, std::size_t other) {
    auto& random = world_.faults.random(fault::slaves_swapped);
    if (i == other || is_elsewhere(i) || is_elsewhere(other)) return;
    const bool has_own_supply = random.below(4) == 0;
    tell(i, ring_deed::swapped, places_[other].number);
    std::swap(order_[i], order_[other]);
    for (const std::size_t each : {i, other}) {
        if (!has_own_supply) {
            places_[each].unit->power_on(world_.now());
            places_[each].restarted_at = world_.now();
        }
        places_[each].disturbed_at = world_.now();
    }
    const auto both = static_cast<std::uint32_t>(i << 4U | other);
    world_.in(random.between(milliseconds{20}, std::chrono::seconds{4}), *this, repair,
              static_cast<std::uint32_t>(fault::slaves_swapped) << 8U | both);
}

std::uint32_t ring::number_of(const ethercat::coe_emergency& what) noexcept {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i != 4; ++i) number |= std::to_integer<std::uint32_t>(what.data[i]) << 8U * i;
    return number;
}

// Up to three, one after the other.
void ring::send_emergency(std::size_t i) {
    auto& at = places_[i];
    auto& random = world_.faults.random(fault::slave_emergency);
    for (auto left = 1 + random.below(3); left != 0; --left) {
        const auto number = ++emergency_count_;
        ethercat::coe_emergency what{.error_code = static_cast<std::uint16_t>(0x8000 + random.below(0x1000)),
                                     .error_register = static_cast<std::uint8_t>(random.below(256))};
        for (std::size_t k = 0; k != 4; ++k) what.data[k] = static_cast<std::byte>(number >> 8U * k);
        if (!at.unit->slave().send_emergency(what)) return;
        if (at.emergencies.size() == 32) at.emergencies.erase(at.emergencies.begin());
        at.emergencies.push_back({number, world_.now(), what});
        tell(i, ring_deed::emergency, number);
    }
}

void ring::suffer_of_drive(fault kind, std::size_t i, time some) {
    auto& at = places_[i];
    if (at.drive == nullptr || at.has_drive_fault) return;
    auto& random = world_.faults.random(kind);
    constexpr std::array codes{cia402::error_codes::over_current, cia402::error_codes::following_error};
    auto& hurt = at.drive->axis(random.below(at.drive->axis_count())).disturbed;
    switch (kind) {
    case fault::drive_fault: hurt.fault = codes[random.below(codes.size())]; break;
    case fault::drive_unpowered: hurt.no_voltage = true; break;
    default: at.drive->set_deaf(true);
    }
    at.has_drive_fault = true;
    at.disturbed_at = world_.now();
    tell(i,
         kind == fault::drive_fault       ? ring_deed::drive_fault
         : kind == fault::drive_unpowered ? ring_deed::unpowered
                                          : ring_deed::deaf,
         static_cast<std::uint32_t>(some / milliseconds{1}));
    world_.in(some, *this, repair, static_cast<std::uint32_t>(kind) << 8U | static_cast<std::uint32_t>(i));
}

void ring::mend(fault kind, std::size_t i) {
    if (kind == fault::slaves_swapped) {
        const std::size_t first = i >> 4U, second = i & 0xFU;
        std::swap(order_[first], order_[second]);
        tell(first, ring_deed::swapped, places_[second].number);
        for (const std::size_t each : {first, second}) {
            places_[each].unit->power_on(world_.now());
            places_[each].restarted_at = world_.now();
        }
        for (auto& each : places_) {
            each.disturbed_at = world_.now();
            look(each);
        }
        return;
    }
    auto& at = places_[i];
    switch (kind) {
    case fault::cable_out:
        cable_out_before_.reset();
        tell(i, ring_deed::cable_back);
        break;
    case fault::slave_frozen:
        at.frozen = false;
        at.unfrozen_at = world_.now();
        tell(i, ring_deed::goes_on);
        break;
    case fault::slave_restarted:
        at.away = false;
        tell(i, ring_deed::comes_back);
        give_odd_watchdog(i);
        let_keep_watchdog(i);
        break;
    case fault::watchdog_kept: at.keeps_watchdog = false; break;
    case fault::error_reported: at.reports_error = false; break;
    case fault::slave_slow:
        at.arm->set_slow({});
        at.slow = {};
        tell(i, ring_deed::repaired);
        break;
    case fault::drive_fault:
    case fault::drive_unpowered:
    case fault::drive_deaf:
        at.has_drive_fault = false;
        at.drive->set_deaf(false);
        for (std::size_t k = 0; k != at.drive->axis_count(); ++k) at.drive->axis(k).disturbed = {};
        tell(i, ring_deed::repaired);
        break;
    default: at.state_is_unknown = false;
    }
    for (auto& each : places_) {
        each.disturbed_at = world_.now(); // a cable is that of all behind it
        look(each);
    }
}

void ring::give_odd_watchdog(std::size_t i) {
    if (!world_.faults.strikes(fault::odd_watchdog, 300'000)) return;
    auto& random = world_.faults.random(fault::odd_watchdog);
    constexpr std::array<std::uint16_t, 5> dividers{0, 1, 2498, 10'000, 0xFFFF};
    constexpr std::array<std::uint16_t, 5> times{0, 1, 1000, 30'000, 0xFFFF};
    const auto divider = dividers[random.below(dividers.size())], units = times[random.below(times.size())];
    write(places_[i], registers::watchdog_divider.address, divider);
    write(places_[i], registers::process_data_watchdog.address, units);
    tell(i, ring_deed::odd_watchdog, std::uint32_t{divider} << 16U | units);
}

// For some time it ignores that its watchdog is written: it takes the datagram, or does not even count it.
void ring::let_keep_watchdog(std::size_t i) {
    auto& at = places_[i];
    if (!at.cyclic || at.keeps_watchdog || !world_.faults.strikes(fault::watchdog_kept, 200'000)) return;
    auto& random = world_.faults.random(fault::watchdog_kept);
    constexpr std::array<watchdog_registers, 4> all{{{2498, 0}, {2498, 10'000}, {0xFFFF, 900}, {10'000, 0xFFFF}}};
    at.kept_watchdog = all[random.below(all.size())];
    at.refuses_watchdog = random.below(2) == 0;
    at.keeps_watchdog = true;
    const time some = random.between(milliseconds{50}, std::chrono::seconds{3});
    tell(i, ring_deed::keeps_watchdog, static_cast<std::uint32_t>(some / milliseconds{1}));
    world_.in(some, *this, repair,
              static_cast<std::uint32_t>(fault::watchdog_kept) << 8U | static_cast<std::uint32_t>(i));
}

void ring::keep_watchdog(ring_place& at, const ethercat::basic_datagram<std::byte>& write) {
    const bool is_divider = write.header.ado == registers::watchdog_divider.address;
    if (!is_divider && write.header.ado != registers::process_data_watchdog.address) return;
    this->write(at, write.header.ado, is_divider ? at.kept_watchdog.divider : at.kept_watchdog.units);
    if (!at.refuses_watchdog) return;
    auto& counter = write.bytes[write.bytes.size() - 2];
    counter = static_cast<std::byte>(std::to_integer<unsigned>(counter) - 1);
}

time ring::watchdog_of(ring_place& at) {
    std::array<std::byte, 96> frame{};
    ethercat::frame_builder made{frame, 0xEE};
    for (const auto address : {registers::watchdog_divider.address, registers::process_data_watchdog.address})
        made.add(ethercat::command::aprd, 0, address, 2);
    at.unit->slave().pass(*made.finish(), jauscat::time_point{world_.now()});
    ethercat::frame_view back;
    if (!back.parse(frame)) return {};
    const auto first = back.begin();
    const auto divider = (*first).value(registers::watchdog_divider).value;
    return ethercat::watchdog_time(divider, (*std::next(first)).value(registers::process_data_watchdog).value);
}

// As somebody else on the wire, who reaches this slave alone.
void ring::write(ring_place& at, std::uint16_t address, std::uint16_t value) {
    std::array<std::byte, 64> frame{};
    ethercat::frame_builder made{frame, 0xEE};
    made.add(ethercat::command::apwr, 0, address, ethercat::esc_word{value});
    const auto whole = made.finish();
    at.unit->pass(*whole, world_.now(), {}, at.frozen);
}

} // namespace simulation
