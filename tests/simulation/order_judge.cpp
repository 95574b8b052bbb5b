#include "simulation/order_judge.hpp"

#include <jauscat/bridge/component.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace simulation {
namespace {

using bridging::refusal;
using std::chrono::milliseconds, std::chrono::seconds;

constexpr std::size_t queue_places = 16, queue_share = 256;
constexpr time to_serve = milliseconds{300}; // an order of a slave that is there

std::string text(const jaus::header& head) {
    return "command code " + std::to_string(head.command_code) + ", number " + std::to_string(head.sequence_number);
}
bool is_query(std::uint16_t code) { return code >= 0x2000 && code < 0x4000; }
bool is_state_command(std::uint16_t code) { return code >= 0x0002 && code <= 0x0007; }

// Some senders add bytes, or leave some out.
bool is_as_made(std::uint16_t code, bytes body) {
    const auto command = motion_in(code, body);
    if (!command || code != jaus::command_code_of<jaus::set_wrench_effort>) return command.has_value();
    std::array<std::byte, 64> space{};
    const auto made = wire::encode(efforts_of<jaus::set_wrench_effort>(*command), space);
    return made && std::ranges::equal(*made, body);
}

} // namespace

void order_judge::starts() {
    open_.clear();
    rested_at_.reset();
    seen_.clear();
    up_.clear();
    stopped_at_ = world_.now();
    is_owed_ = true; // what the actuator does is not known
    may_be_settled_ = is_faulted_ = ends_ = needs_emergency_ = has_read_inputs_ = false;
    attempts_ = 0;
    repeat_from_.reset();
    fault_.reset();
    lost_at_ = not_accepted_at_ = time{-1};
    is_handled_ = true;
    has_replaced_ = false;
}

void order_judge::gets(const jaus::header& head, bytes body) {
    const bool is_well_formed = !moves(head.command_code) || is_as_made(head.command_code, body);
    const bool stops = moves(head.command_code) && motion_in(head.command_code, body).value_or(0) == 0;
    current_ = {head, world_.now(), program_.local(), body.size(), is_well_formed, stops};
    std::erase_if(seen_, [&](const order& one) { return world_.now() - one.at > seconds{10}; });
    seen_.push_back(current_);
    has_ended_ = is_handled_ = has_replaced_ = false;
}

void order_judge::has_handled(jaus::component_outcome what) {
    if (std::exchange(has_replaced_, false)) breaks(contract::told, "a merge with " + text(current_.head), "none");
    is_handled_ = true;
    if (what != jaus::component_outcome::deferred || has_ended_) return;
    // Copies of one message are acknowledged together.
    const bool is_known = std::ranges::find(open_, current_.head, &order::head) != open_.end();
    if (!is_known) open_.push_back(current_);
}

// An acknowledgement, or a report, ends the oldest that it may belong to.
void order_judge::sends(bytes message) {
    const auto m = jaus::split(message);
    if (!m) return;
    const auto& head = m.header;
    const auto is_of = [&](const order& one) {
        const auto& of = one.head;
        if (of.source != head.destination) return false;
        if (jaus::is_acknowledgement(head))
            return of.ack_nak == jaus::ack_nak::request && of.command_code == head.command_code &&
                   of.sequence_number == head.sequence_number;
        return is_query(of.command_code) && of.command_code + 0x2000 == head.command_code;
    };
    if (head.command_code == jaus::command_code_of<jaus::report_component_status> && !jaus::is_acknowledgement(head))
        check_status(m.body);
    const bool is_from_image = what_.is_cyclic && !jaus::is_acknowledgement(head) &&
                               (head.command_code == jaus::command_code_of<jaus::report_wrench_effort> ||
                                head.command_code == jaus::command_code_of<jaus::report_joint_velocities>);
    if (is_from_image) {
        world_.compares(comparison::image_told);
        if (!std::exchange(has_read_inputs_, false))
            breaks(contract::told, "a report from inputs that are told", "they are not");
    }
    const auto found = std::ranges::find_if(open_, is_of);
    if (found != open_.end()) open_.erase(found);
}

// ---------------------------------------------------------------------------------------------------- observer

const char* order_judge::cause_missing(const order& one, refusal why) const {
    const auto& head = one.head;
    const bool was_in_emergency = is_in_emergency() || emergency_at_ + milliseconds{20} >= one.at;
    switch (why) {
    case refusal::slave_down: return is_up() ? "its slaves are there" : nullptr;
    case refusal::queue_full: {
        // Copies of a report wait each for itself.
        const auto waiting = std::ranges::count_if(
            seen_, [&](const order& each) { return world_.now() - each.at <= what_.order_timeout; });
        return static_cast<std::size_t>(waiting) < queue_places ? "there are places in the queue" : nullptr;
    }
    case refusal::too_large: return one.size <= queue_share ? "it has a place" : nullptr;
    case refusal::expired:
        return program_.local() - one.local_at < what_.order_timeout ? "it has not waited so long" : nullptr;
    case refusal::superseded: {
        const bool is_newer =
            !is_handled_ && current_.head.source == head.source && current_.head.command_code == head.command_code;
        return what_.axes == 0 && !what_.is_cyclic && !is_newer ? "none has come after it" : nullptr;
    }
    case refusal::stopped: {
        const time last = std::max(stopped_at_, changed_control_at_);
        // One that comes while a stop order is unconfirmed is dropped, too.
        const bool is_before = !is_owed_ && last + milliseconds{100} < one.at && program_.jumped_at() <= last;
        return is_before ? "no stop order has come, and no change of control" : nullptr;
    }
    case refusal::not_translated:
        return moves(head.command_code) && one.is_well_formed && is_quiet() ? "it is well-formed" : nullptr;
    case refusal::by_slave:
        return moves(head.command_code) && one.is_well_formed && is_quiet() && !was_in_emergency
                   ? "nothing has happened to its slave"
                   : nullptr;
    case refusal::not_accepted:
    case refusal::stale: return is_quiet() && !was_in_emergency ? "nothing has happened to its slaves" : nullptr;
    }
    return "there is no such cause";
}

// An arm keeps its emergency when the program of the bridge restarts, which does not know of it then.
bool order_judge::is_in_emergency() const {
    const auto* const arm = (*model_.actuator(what_.account).wire)[what_.slaves.front()].arm;
    return arm != nullptr && arm->in_emergency();
}

// The reason of the slave, where it is the one that refuses.
void order_judge::check_reason(const bridging::refusal_reason& why) {
    world_.compares(comparison::refusal_detailed);
    const auto& of_master = why.of_master;
    const bool has_error = of_master.code != ethercat::master_errc::ok;
    const bool is_ok = why.error == jauscat::translate::errc::ok;
    const auto fail = [&](const char* expected) {
        breaks(contract::told, expected,
               "cause " + std::to_string(static_cast<unsigned>(why.why)) + ", error " +
                   std::to_string(static_cast<unsigned>(why.error)) + ", of the master " +
                   std::string{ethercat::describe(of_master)});
    };
    if (why.why == refusal::not_translated) {
        if (is_ok) fail("the error of a translation");
        return;
    }
    if (!is_ok) return fail("no error of a translation that was made");
    if (why.why != refusal::by_slave) {
        if (has_error) fail("no error of the master");
        return;
    }
    if (!has_error) return fail("the error of the slave or the master");
    const auto& wire = *model_.actuator(what_.account).wire;
    const auto* const arm = wire[what_.slaves.front()].arm;
    if (of_master.code != ethercat::master_errc::sdo_abort || arm == nullptr || wire.is_rough()) return;
    if (of_master.abort != arm->last_abort()) fail("the abort code of the slave");
}

void order_judge::merged(const jaus::header& head) {
    world_.compares(comparison::refusal_caused);
    const bool sets = head.command_code >= 0x0400 && head.command_code < 0x2000;
    if (!sets) breaks(contract::told, "a command that sets something is merged", text(head));
    if (!is_handled_ && !std::exchange(has_replaced_, false))
        breaks(contract::told, "a merge with a command that waited", "none did");
}

void order_judge::reads_inputs() {
    if (has_read_inputs_) breaks(contract::told, "a report from inputs that are told", "there is none");
    has_read_inputs_ = true;
}

// Each once.
void order_judge::faulted(const bridging::drive_fault& what) {
    world_.compares(comparison::refusal_detailed);
    const auto fail = [&](const char* expected) {
        breaks(contract::told, expected, "slave " + std::to_string(what.slave) + ", code " + std::to_string(what.code));
    };
    if (what_.axes == 0) fail("a fault of a drive");
    if (what.slave >= what_.slaves.size()) return fail("a slave of the component");
    if (fault_ == what && fault_at_ == world_.now()) fail("each fault once"); // or again, when another one was there
    fault_ = what;
    fault_at_ = world_.now();
    is_faulted_ = true;
}

void order_judge::fault_ended() {
    if (!is_faulted_) breaks(contract::told, "the end of a fault that was told", "there was none");
    is_faulted_ = false;
    fault_.reset();
}

void order_judge::refused(const jaus::header& head, const bridging::refusal_reason& reason) {
    const refusal why = reason.why;
    check_reason(reason);
    // The message that is being handled, or one that waits.
    const auto is_it = [&](const order& one) {
        return one.head.source == head.source && one.head.command_code == head.command_code &&
               one.head.sequence_number == head.sequence_number;
    };
    auto found = std::ranges::find(open_, head, &order::head); // a sender may use a number twice
    if (found == open_.end() && current_.head != head) found = std::ranges::find_if(open_, is_it);
    if (why == refusal::not_accepted) not_accepted_at_ = world_.now();
    if (why == refusal::superseded && !is_handled_) has_replaced_ = true;
    const bool is_open = found != open_.end();
    if (!is_open && !is_it(current_)) return;
    const order one = is_open ? *found : current_;
    const bool is_known = head.sequence_number != 0 || std::ranges::count_if(seen_, is_it) < 2;
    if (is_open) open_.erase(found);
    if (!is_open) has_ended_ = true;
    world_.compares(comparison::refusal_caused);
    const char* const missing = is_known ? cause_missing(one, why) : nullptr;
    if (missing != nullptr) breaks(contract::availability, "a refusal of " + text(head) + " has a cause", missing);
}

bool order_judge::has_cause(bridging::stop_cause why) const {
    using enum bridging::stop_cause;
    const auto now_in = model_.actuator(what_.account).state;
    const bool is_changed = changed_control_at_ == world_.now();
    using jaus::control_change;
    switch (why) {
    case bridging::stop_cause::state: return now_in != jaus::primary_status_code::ready && !ends_;
    case controller_lost: return is_changed && control_change_ == control_change::lost;
    case control_taken: return is_changed && what_.is_cyclic && control_change_ != control_change::lost;
    case sender_lost: return !is_changed || control_change_ != control_change::lost;
    case slave_absent: return !is_up() && lost_at_ == world_.now();
    case slave_returned: return is_up();
    case not_accepted: return not_accepted_at_ == world_.now();
    case bridging::stop_cause::drive_fault: return what_.axes != 0;
    case program_ends: return ends_;
    }
    return false;
}

void order_judge::stop_required(bridging::stop_order what, bridging::stop_cause why) {
    const bool is_rest = what == bridging::stop_order::rest;
    if (what == bridging::stop_order::clear_emergency)
        breaks(contract::told, "rest or an emergency as a stop order", "the end of an emergency");
    if (!is_rest && model_.actuator(what_.account).state != jaus::primary_status_code::emergency)
        breaks(contract::told, "an emergency is required in that state alone", "it is required");
    needs_emergency_ = needs_emergency_ || !is_rest;
    attempts_ = 0;
    repeat_from_.reset();
    world_.compares(comparison::stop_caused);
    if (!has_cause(why))
        breaks(contract::availability, "a stop order has the cause that is told",
               "it has not: cause " + std::to_string(static_cast<unsigned>(why)));
    stopped_at_ = world_.now();
    is_owed_ = true;
    may_be_settled_ = false;
}

// An order that is refused is repeated after 20 ms, and later each time up to 200 ms; rest and Set Emergency take turns
// where one of them is refused again and again.
void order_judge::stop_refused(bridging::stop_order what, const bridging::refusal_reason& why, unsigned attempts) {
    using bridging::stop_order;
    may_be_settled_ = true;
    check_reason(why);
    world_.compares(comparison::stop_repeated);
    const auto fail = [&](const char* expected) {
        breaks(contract::told, expected,
               "order " + std::to_string(static_cast<unsigned>(what)) + " at attempt " + std::to_string(attempts));
    };
    if (attempts != attempts_ + 1 && attempts != 1) fail("attempts that are counted, or begin again");
    const auto pause = what_.stop_interval * std::min(attempts_, 10U);
    const bool is_next = attempts == attempts_ + 1 && attempts_ != 0 && !what_.is_cyclic; // else by mailbox as well
    if (is_next && program_.local() - refused_at_ < pause) fail("a pause between two attempts of a stop order");
    const bool is_odd = attempts % 2 == 0; // refusals before it
    // The first one may be of an order from before the last one was required; process data have their own.
    const bool has_turns = attempts > 1 && attempts == attempts_ + 1 && !what_.is_cyclic;
    // The emergency may be confirmed, and end, while rest is still refused.
    const bool is_over = model_.actuator(what_.account).state != jaus::primary_status_code::emergency;
    const bool may_be_rest = !needs_emergency_ || is_odd || is_over;
    const bool may_be_emergency = needs_emergency_ || (attempts > 3 && is_odd);
    const bool must_be_emergency = !needs_emergency_ && attempts > 3 && is_odd;
    if (has_turns && what == stop_order::rest && (!may_be_rest || must_be_emergency)) fail("Set Emergency in its turn");
    if (has_turns && what == stop_order::emergency && !may_be_emergency) fail("rest in its turn");
    const bool is_again = attempts == attempts_ + 1 && what == refused_order_;
    if (what == stop_order::clear_emergency && attempts > 3 && is_again) fail("the third attempt as the last");
    attempts_ = attempts;
    refused_order_ = what;
    refused_at_ = program_.local();
    repeat_from_.reset();
    if (what != stop_order::clear_emergency || what_.is_cyclic) // it is given up; another one may wait for a cycle
        repeat_from_ = world_.now() + what_.stop_interval * std::min(attempts, 10U);
}

// The next attempt follows in time, where nothing but refusals comes from the slave.
void order_judge::check_repeat() {
    if (!repeat_from_ || what_.is_shared || what_.waits_for_lanes || !is_up() || what_.is_cyclic) return;
    const auto& wire = *model_.actuator(what_.account).wire;
    const auto& slave = wire[what_.slaves.front()];
    const bool is_hindered = slave.frozen || slave.slow != time{} || slave.unreachable_since || slave.taken_since;
    const time hindered =
        std::max({program_.jumped_at(), wire.frames_disturbed_at(), slave.missed_at, slave.unfrozen_at,
                  slave.recounted_at, up_at_, is_hindered ? world_.now() : time{}});
    constexpr time to_transfer = milliseconds{120}; // with a query before it
    if (world_.now() - std::max(*repeat_from_, hindered) <= to_transfer) return;
    world_.compares(comparison::stop_repeated);
    breaks(contract::told, "a stop order that is refused is repeated in time", "it is not");
}

void order_judge::settled() {
    is_owed_ = may_be_settled_ = needs_emergency_ = false;
    attempts_ = 0;
    repeat_from_.reset();
}

void order_judge::slave_up(std::size_t slave) {
    up_.insert(slave);
    up_at_ = world_.now();
    takes_keep_alive_ = true;
}

void order_judge::slave_lost(std::size_t slave) {
    up_.erase(slave);
    lost_at_ = world_.now();
    world_.compares(comparison::slave_kept);
    if (is_quiet()) breaks(contract::availability, "a slave to which nothing happens is kept", "it counts as lost");
}

void order_judge::bring_up_failed() {
    world_.compares(comparison::slave_kept);
    if (is_quiet())
        breaks(contract::availability, "a slave to which nothing happens is brought up", "an attempt has failed");
}

// ---------------------------------------------------------------------------------------------------- status, times

void order_judge::check_status(bytes body) {
    using namespace bridging::secondary_status;
    jaus::report_component_status status{};
    if (!wire::decode(status, body)) return;
    world_.compares(comparison::orders_reported);
    const auto bits = status.secondary_status_code;
    const auto say = [&](bool is_right, const char* what) {
        if (!is_right)
            breaks(contract::s4, std::string{"a secondary status that says whether "} + what,
                   "the status " + std::to_string(bits));
    };
    say(((bits & slave_absent) != 0) != is_up(), "a slave is lost");
    say(((bits & drive_fault) != 0) == is_faulted_, "a drive has a fault");
    const auto owed = bits & (rest_unconfirmed | emergency_unconfirmed);
    if (!is_owed_) say(owed == 0, "stop orders are unconfirmed");
    if (is_owed_ && !may_be_settled_) say((owed | (bits & clear_unconfirmed)) != 0, "stop orders are unconfirmed");
}

void order_judge::check() {
    if (!program_.running()) return;
    const time now = world_.now(), since = std::max(program_.jumped_at(), time{});
    if (now - checked_at_ < milliseconds{10}) return;
    checked_at_ = now;
    if (is_in_emergency()) emergency_at_ = now;
    const bool has_emergency = model_.actuator(what_.account).state == jaus::primary_status_code::emergency;
    if (is_in_emergency() || has_emergency || is_faulted_) hindered_at_ = now; // the arm may not know of it
    const auto is_awaited = [](const order& one) {
        const bool is_numbered = one.head.sequence_number != 0; // else it may be the repeat of one before
        return is_query(one.head.command_code) || (is_numbered && one.head.ack_nak == jaus::ack_nak::request);
    };
    std::erase_if(open_, [&](const order& one) { return !is_awaited(one) && now - one.at > what_.order_timeout; });
    check_repeat();
    check_keep_alive();
    check_rest();
    check_return();
    for (const auto& one : open_) {
        if (!is_awaited(one)) continue;
        world_.compares(comparison::order_ends);
        const time age = now - std::max(one.at, since);
        const bool is_waited_for = !is_state_command(one.head.command_code);
        // What waits for a slave that is lost is refused.
        if (!is_state_command(one.head.command_code) && one.at < lost_at_ &&
            now - std::max(lost_at_, since) > milliseconds{50})
            return breaks(contract::s6, "an end of each message for a slave that is lost", "none of " + text(one.head));
        if (is_waited_for && age > seconds{3})
            return breaks(contract::s6, "an end of each message for a slave",
                          "none of " + text(one.head) + " for " + std::to_string(age / milliseconds{1}) + " ms");
        const bool is_served = is_up() && now - std::max({one.at, up_at_, emergency_at_}) > to_serve;
        if (is_served && is_quiet() && !is_in_emergency() && quiet() > age)
            return breaks(contract::availability, "a message for a slave to which nothing happens is executed in time",
                          text(one.head) + " is not, after " + std::to_string(age / milliseconds{1}) + " ms");
    }
}

// Efforts stay in force until a stop order, or another command.
void order_judge::rests() {
    const auto& a = model_.actuator(what_.account);
    constexpr time lately = milliseconds{700};
    if (!what_.is_cyclic && !takes_keep_alive_) return; // it stops by itself
    if (a.command == 0 || a.state != jaus::primary_status_code::ready || is_owed_ || is_in_emergency() || !is_quiet())
        return;
    world_.compares(comparison::efforts_kept);
    const bool is_told =
        world_.now() - stopped_at_ < lately ||
        std::ranges::any_of(
            seen_,
            [&](const order& one) { return (one.stops || !one.is_well_formed) && world_.now() - one.at < lately; });
    if (!is_told) rested_at_ = world_.now();
}

// What has happened to the slave at the same time is known now.
void order_judge::check_rest() {
    constexpr time later = milliseconds{20};
    if (!rested_at_ || world_.now() - *rested_at_ < later) return;
    rested_at_.reset();
    if (is_quiet() && stopped_at_ + seconds{1} < world_.now())
        breaks(contract::availability, "efforts stay in force until a stop order or another command",
               "rest, and there was none");
}

// Slaves to which nothing happens are brought up in time, and their component is ready or at rest by order. An
// emergency or a drive's fault has ended before.
void order_judge::check_return() {
    using enum jaus::primary_status_code;
    if (what_.is_shared) return;
    const auto& a = model_.actuator(what_.account);
    const time limit = what_.has_clocks ? seconds{6} : seconds{2};
    const time age = std::min({quiet(), world_.now() - a.reset_at, world_.now() - hindered_at_});
    if (age <= limit) return;
    world_.compares(comparison::slave_returns);
    if (!is_up())
        breaks(contract::availability, "a slave to which nothing happens is used in time",
               "it is not, after " + std::to_string(age / milliseconds{1}) + " ms");
    else if (a.state == failure || a.state == initialize)
        breaks(contract::availability, "a component whose slaves are used is ready in time",
               "it is not, after " + std::to_string(age / milliseconds{1}) + " ms");
}

// A slave by mailbox stops by itself without messages.
void order_judge::check_keep_alive() {
    if (what_.is_cyclic || !takes_keep_alive_ || !is_up() || !is_quiet()) return;
    constexpr time to_transfer = milliseconds{60};
    const auto& slave = (*model_.actuator(what_.account).wire)[what_.slaves.front()];
    world_.compares(comparison::kept_alive);
    const time silence = world_.now() - slave.mailbox_written_at;
    if (silence > what_.keep_alive + to_transfer)
        breaks(contract::availability, "a message each 100 ms for a slave that stops by itself without one",
               "none for " + std::to_string(silence / milliseconds{1}) + " ms");
}

void order_judge::breaks(contract point, std::string expected, std::string found) {
    world_.breaks({.point = point,
                   .who = model_.actuator(what_.account).number,
                   .expected = std::move(expected),
                   .found = std::move(found)});
}

} // namespace simulation
