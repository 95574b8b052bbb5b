#include "simulation/component_judge.hpp"

#include <jauscat/jaus/component/component_clock.hpp>
#include <jauscat/jaus/component/component_options.hpp>

#include <algorithm>
#include <array>

namespace simulation {
namespace {

using jaus::component_outcome, jaus::primary_status_code;
using std::chrono::milliseconds;

template <class T> constexpr std::uint16_t code_of = jaus::command_code_of<T>;

constexpr time memory = jaus::component_options{}.memory;
constexpr time to_act = milliseconds{20};

// The rules of the table in docs/safety.md, of the codes below 2000h that are not moving.
constexpr std::array<std::uint16_t, 15> open_codes{0x0006, 0x0008, 0x0009, 0x000A, 0x000B, 0x000C, 0x000D, 0x000F,
                                                   0x0010, 0x01F0, 0x01F1, 0x01F2, 0x01F3, 0x01F4, 0x0A24};
constexpr std::array<std::uint16_t, 13> controlled_codes{0x0001, 0x0002, 0x0003, 0x0004, 0x0005, 0x0007, 0x000E,
                                                         0x0011, 0x0200, 0x0201, 0x0202, 0x0E02, 0x0E03};

constexpr bool has(std::span<const std::uint16_t> codes, std::uint16_t code) {
    return std::ranges::find(codes, code) != codes.end();
}
constexpr bool is_query_or_report(std::uint16_t code) { return code >= 0x2000 && code < 0x6000; }

bool matches(const jaus::address& levels, const jaus::address& one) {
    const auto same = [](std::uint8_t level, std::uint8_t octet) { return level == 255 || level == octet; };
    return same(levels.subsystem, one.subsystem) && same(levels.node, one.node) &&
           same(levels.component, one.component) && same(levels.instance, one.instance);
}

std::string text(const jaus::address& id) {
    return std::to_string(id.subsystem) + "." + std::to_string(id.node) + "." + std::to_string(id.component) + "." +
           std::to_string(id.instance);
}
std::string text(const jaus::header& head) {
    constexpr std::array kinds{"", ", asking for an acknowledgement", ", NAK", ", ACK"};
    return hex(head.command_code) + " to " + text(head.destination) + ", number " +
           std::to_string(head.sequence_number) + kinds.at(static_cast<std::size_t>(head.ack_nak));
}
jaus::header head_of(bytes message) {
    jaus::header head{};
    static_cast<void>(wire::decode_prefix(head, message));
    return head;
}
bool is_acknowledgement_of(const jaus::header& answer, const jaus::header& head) {
    return jaus::is_acknowledgement(answer) && answer.command_code == head.command_code &&
           answer.sequence_number == head.sequence_number && answer.destination == head.source;
}
bool is_done(component_outcome what) {
    using enum component_outcome;
    return what == handled || what == deferred || what == stopped_on_invalid_emergency;
}

} // namespace

void component_judge::starts() {
    is_ = {};
    phase_ = phase::none;
    remembered_.clear();
    unsure_.clear();
}

// ---------------------------------------------------------------------------------------------------- what it does

void component_judge::begin(phase what) {
    phase_ = what;
    next_ = is_;
    expected_ = {};
    sent_.clear();
    entered_.clear();
    control_.clear();
}

void component_judge::sends(bytes message) {
    const auto head = head_of(message);
    if (phase_ == phase::none) return settle(head);
    sent_.push_back({head, {message.begin(), message.end()}, entered_.size() + control_.size()});
}

void component_judge::enters(state_code from, state_code to) {
    const transition one{from, to};
    if (phase_ != phase::none) return entered_.push_back(one);
    if (!is_own_change(one)) breaks(contract::s5, "no change of the state", text(from) + " to " + text(to));
    next_ = is_;
    enter(to);
    is_ = next_;
}

void component_judge::controlled(const std::optional<jaus::controller>& now, jaus::control_change why) {
    if (phase_ != phase::none) return control_.push_back({now, why});
    // A bridge takes control back when it loses a slave.
    if (now || why != jaus::control_change::rejected || is_.state == state_code::ready)
        breaks(contract::s5, "no change of the controller", "there is one");
    is_.controller.reset();
}

// A bridge's component fails and returns by itself, and ends with its program.
bool component_judge::is_own_change(const transition& one) const {
    using enum primary_status_code;
    if (!what_.has_slaves) return false;
    const auto [from, to] = one;
    if (from == primary_status_code::shutdown || from == emergency) return to == primary_status_code::shutdown;
    if (to == failure || to == primary_status_code::shutdown) return true;
    if (from == failure) return to == initialize;
    if (from == initialize) return to == ready;
    return from == ready && to == primary_status_code::standby;
}

// ---------------------------------------------------------------------------------------------------- messages

void component_judge::gets(const jaus::header& head, bytes body) {
    begin(phase::message);
    head_ = head;
    digest_ = digest_of(body);
    hear(head, body);
    if (jaus::is_acknowledgement(head)) {
        expected_.outcome = component_outcome::unmatched_acknowledgement;
        return;
    }
    const auto refused = refused_by_rule(head);
    if (is_tracked(head)) look_for_repeat(head, body);
    if (expected_.is_repeat) return;
    if (refused)
        expected_.outcome = refused;
    else
        handle(head, body);
}

// Every message is a sign of life but a query of the pulse, which nodes send in the name of a component, and a large
// data set, which may have waited.
void component_judge::hear(const jaus::header& head, bytes body) {
    if (head.command_code == code_of<jaus::query_heartbeat_pulse> || body.size() > jaus::max_body_size) return;
    const auto hears = [&](watch& life) {
        life.heard = program_.local();
        life.asked = 0;
    };
    if (controls(head.source)) hears(next_.life), hears(is_.life);
    if (is_.moved_by && is_.moved_by->id == head.source) hears(next_.moved_by->life), hears(is_.moved_by->life);
}

bool component_judge::controls(const jaus::address& who) const {
    return is_.controller && is_.controller->address == who;
}
bool component_judge::is_motion(std::uint16_t code) const {
    return !is_query_or_report(code) && !has(open_codes, code) && !has(controlled_codes, code) &&
           !has(what_.harmless, code);
}

std::optional<component_outcome> component_judge::refused_by_rule(const jaus::header& head) const {
    const auto code = head.command_code;
    if (head.experimental && jaus::is_standard(code)) return component_outcome::experimental;
    const bool is_open = is_query_or_report(code) || has(open_codes, code) || has(what_.harmless, code);
    const bool holds = std::ranges::find(is_.holders, head.source) != is_.holders.end();
    const bool clears_own = code == code_of<jaus::clear_emergency> && holds;
    if (is_.controller && !controls(head.source) && !is_open && !clears_own) return component_outcome::not_controller;
    if (is_motion(code) && is_.state != state_code::ready) return component_outcome::not_ready;
    return std::nullopt;
}

// Set Emergency and queries are executed each time.
bool component_judge::is_tracked(const jaus::header& head) const {
    const bool is_each_time = head.command_code == code_of<jaus::set_emergency> ||
                              (head.command_code >= 0x2000 && head.command_code < 0x4000);
    return head.ack_nak == jaus::ack_nak::request && jaus::names_one_component(head.destination) && !is_each_time;
}

void component_judge::look_for_repeat(const jaus::header& head, bytes body) {
    const time now = program_.local();
    std::erase_if(remembered_, [&](const auto& one) { return !one.is_pending && one.at + memory <= now; });
    std::erase_if(unsure_, [&](const auto& one) { return one.until <= now; });
    const auto digest = digest_of(body);
    const auto is_same = [&](const remembered_message& one) {
        return one.source == head.source && one.number == head.sequence_number && one.code == head.command_code &&
               one.digest == digest;
    };
    const bool is_used_again = std::ranges::any_of(remembered_, [&](const remembered_message& one) {
        return one.source == head.source && one.number == head.sequence_number && !is_same(one);
    });
    const auto found = std::ranges::find_if(remembered_, is_same);
    if (is_used_again && head.sequence_number != 0) unsure_.push_back({head.source, now + memory + milliseconds{500}});
    const bool is_unsure = std::ranges::find(unsure_, head.source, &unsure_source::id) != unsure_.end();
    if (found == remembered_.end()) return; // a new one
    expected_.may_be_repeat = true;
    if (is_unsure || head.sequence_number == 0) return;
    expected_.is_repeat = true;
    expected_.outcome = found->is_pending ? component_outcome::pending : component_outcome::repeated;
    if (!found->is_pending) expected_.answer_before = found->answer;
}

void component_judge::expect_reply(const jaus::header& head, const auto& body) {
    std::array<std::byte, 128> space{};
    const auto made = jaus::make_message(head, body, space);
    if (made) expected_.replies.emplace_back(made->begin(), made->end());
}

void component_judge::handle(const jaus::header& head, bytes body) {
    const auto code = head.command_code;
    if (code >= code_of<jaus::shutdown> && code <= code_of<jaus::clear_emergency>)
        return take_state_command(head, body);
    switch (code) {
    case code_of<jaus::query_component_status>:
        if (!what_.has_slaves) // which tell of stop orders in the secondary status
            expect_reply(jaus::answer_to(head, what_.id), jaus::report_component_status{is_.state, 0});
        expected_.outcome = component_outcome::handled;
        return;
    case code_of<jaus::set_component_authority>:
    case code_of<jaus::request_component_control>:
    case code_of<jaus::release_component_control>:
    case code_of<jaus::query_component_authority>:
    case code_of<jaus::query_component_control>: return take_control_message(head, body);
    case code_of<jaus::set_time>:
    case code_of<jaus::query_time>: return take_time(head, body);
    case code_of<jaus::report_heartbeat_pulse>: {
        const auto takes = [&](watch& life) { return life.pulses != 0 && life.pulses-- != 0; };
        const bool is_asked = (controls(head.source) && takes(next_.life)) ||
                              (next_.moved_by && next_.moved_by->id == head.source && takes(next_.moved_by->life));
        if (is_asked)
            expected_.outcome = component_outcome::handled;
        else if (!what_.has_slaves)
            expected_.outcome = component_outcome::unknown;
        return;
    }
    default:
        if (what_.application) expected_.outcome = what_.application(head, body);
        if (is_motion(code) && !what_.has_slaves && expected_.outcome == component_outcome::handled) {
            const bool is_known = next_.moved_by && next_.moved_by->id == head.source;
            if (!is_known) next_.moved_by = mover{head.source, {.heard = program_.local()}};
        }
    }
}

void component_judge::enter(state_code to) {
    next_.state = to;
    if (to != state_code::ready) next_.moved_by.reset();
    if (to != state_code::emergency) next_.holders.clear(), next_.is_anyones = false;
}

void component_judge::take_state_command(const jaus::header& head, bytes body) {
    using enum primary_status_code;
    using enum component_outcome;
    const auto from = is_.state;
    const bool is_ended = from == primary_status_code::shutdown;
    const bool works = from == ready || from == primary_status_code::standby;
    const auto go = [&](bool is_possible, state_code to) {
        expected_.outcome = is_possible ? handled : refused;
        if (!is_possible || to == from) return;
        if (to == emergency) next_.before = from;
        expected_.entered = transition{from, to};
        enter(to);
    };
    const auto is_well_formed = [&](auto message) { return static_cast<bool>(wire::decode(message, body)); };
    switch (head.command_code) {
    case code_of<jaus::shutdown>:
        if (!is_well_formed(jaus::shutdown{})) break;
        return go(true, primary_status_code::shutdown);
    case code_of<jaus::standby>:
        if (!is_well_formed(jaus::standby{})) break;
        return go(works, primary_status_code::standby);
    case code_of<jaus::resume>:
        if (!is_well_formed(jaus::resume{})) break;
        return go(works, ready);
    case code_of<jaus::reset>:
        if (!is_well_formed(jaus::reset{})) break;
        return go(!is_ended && from != emergency, initialize);
    case code_of<jaus::set_emergency>: {
        jaus::set_emergency order{};
        const bool is_said =
            wire::decode(order, body) && order.emergency_code.test(jaus::set_emergency_code::transition_to_emergency);
        if (is_ended)
            expected_.outcome = handled;
        else
            go(true, emergency);
        if (!is_ended && std::ranges::find(next_.holders, head.source) == next_.holders.end())
            next_.holders.push_back(head.source);
        if (!is_said) expected_.outcome = stopped_on_invalid_emergency;
        return;
    }
    default: {
        jaus::clear_emergency order{};
        if (!wire::decode(order, body)) break;
        expected_.outcome = handled;
        if (!order.emergency_code.test(jaus::clear_emergency_code::clear_emergency) || from != emergency) return;
        const auto held = std::ranges::find(next_.holders, head.source);
        if (held == next_.holders.end() && !next_.is_anyones) {
            expected_.outcome = refused;
            return;
        }
        if (held != next_.holders.end())
            next_.holders.erase(held);
        else
            next_.is_anyones = false;
        if (next_.holders.empty() && !next_.is_anyones)
            go(true, is_.before == ready ? primary_status_code::standby : is_.before);
        return;
    }
    }
    expected_.outcome = malformed;
}

void component_judge::take_control_message(const jaus::header& head, bytes body) {
    const auto answer = jaus::answer_to(head, what_.id);
    expected_.outcome = component_outcome::handled;
    const auto malformed = [&] { expected_.outcome = component_outcome::malformed; };
    switch (head.command_code) {
    case code_of<jaus::set_component_authority>: {
        jaus::set_component_authority order{};
        if (!wire::decode(order, body)) return malformed();
        next_.authority = order.authority_code;
        return;
    }
    case code_of<jaus::request_component_control>: {
        using enum jaus::component_control_response;
        jaus::request_component_control order{};
        if (!wire::decode(order, body)) return malformed();
        const bool is_other = is_.controller && !controls(head.source);
        if (is_other && order.authority_code <= is_.controller->authority_code)
            return expect_reply(answer, jaus::confirm_component_control{control_not_accepted});
        if (is_other)
            expect_reply({.destination = is_.controller->address, .source = what_.id},
                         jaus::reject_component_control{});
        expect_reply(answer, jaus::confirm_component_control{control_accepted});
        const jaus::controller now{head.source, order.authority_code};
        using jaus::control_change;
        if (is_.controller != now)
            expected_.control = control_call{now, is_other ? control_change::taken_over : control_change::granted};
        if (!controls(head.source)) next_.life = {};
        next_.life.heard = program_.local();
        next_.life.asked = 0;
        next_.controller = now;
        return;
    }
    case code_of<jaus::release_component_control>:
        if (jaus::release_component_control order{}; !wire::decode(order, body)) return malformed();
        if (!controls(head.source)) return;
        next_.controller.reset();
        expected_.control = control_call{std::nullopt, jaus::control_change::released};
        return;
    case code_of<jaus::query_component_authority>:
        return expect_reply(answer, jaus::report_component_authority{is_.authority});
    default: {
        const auto [who, authority] = is_.controller.value_or(jaus::controller{});
        expect_reply(answer,
                     jaus::report_component_control{who.subsystem, who.node, who.component, who.instance, authority});
    }
    }
}

// Of a Set Time with both stamps; with one of them the other one stays as it is.
void component_judge::take_time(const jaus::header& head, bytes body) {
    using namespace std::chrono;
    expected_.outcome = component_outcome::handled;
    const auto malformed = [&] { expected_.outcome = component_outcome::malformed; };
    if (head.command_code == code_of<jaus::query_time>) {
        jaus::query_time query{};
        if (!wire::decode(query, body)) return malformed();
        jaus::report_time report{};
        const time shown = is_.clock.value_or(time{}) + program_.local();
        const auto stamps = jaus::stamps_of(jaus::civil_time{shown});
        if (is_.has_time && (query.presence_vector & 1U) != 0) report.time_stamp = stamps.time_stamp;
        if (is_.has_date && (query.presence_vector & 2U) != 0) report.date_stamp = stamps.date_stamp;
        return expect_reply(jaus::answer_to(head, what_.id), report);
    }
    jaus::set_time order{};
    if (!wire::decode(order, body)) return malformed();
    if (!order.time_stamp && !order.date_stamp) return;
    const auto refuse = [&] { expected_.outcome = component_outcome::refused; };
    const sys_days begin{year{2000} / 1 / 1};
    const bool is_set = is_.has_time || is_.has_date;
    const time shown = is_set ? *is_.clock + program_.local() : time{begin.time_since_epoch()};
    auto date = floor<days>(sys_time<nanoseconds>{shown});
    time of_day = shown - time{date.time_since_epoch()};
    if (order.date_stamp) {
        const auto& stamp = *order.date_stamp;
        const year_month_day told{year{2000 + stamp.year}, month{stamp.month}, day{stamp.day}};
        if (!told.ok()) return refuse();
        date = sys_days{told};
    }
    if (order.time_stamp) {
        const auto& stamp = *order.time_stamp;
        if (stamp.hours > 23 || stamp.minutes > 59 || stamp.seconds > 59 || stamp.milliseconds > 999) return refuse();
        of_day =
            hours{stamp.hours} + minutes{stamp.minutes} + seconds{stamp.seconds} + milliseconds{stamp.milliseconds};
        if (stamp.day != 0 && order.date_stamp && stamp.day != order.date_stamp->day) return refuse();
        if (stamp.day != 0 && !order.date_stamp) {
            // The day with this number whose time is nearest to the clock's.
            std::optional<sys_days> best;
            const auto distance = [&](sys_days one) { return abs(time{one.time_since_epoch()} + of_day - shown); };
            for (int i = -62; i <= 62; ++i) {
                const auto one = date + days{i};
                if (year_month_day{one}.day() != day{stamp.day}) continue;
                if (!best || distance(one) < distance(*best)) best = one;
            }
            if (!best) return refuse();
            date = *best;
        }
    }
    next_.clock = time{date.time_since_epoch()} + of_day - program_.local();
    next_.has_time = is_.has_time || order.time_stamp.has_value();
    next_.has_date = is_.has_date || order.date_stamp.has_value();
}

void component_judge::has_handled(component_outcome what) {
    if (phase_ != phase::message) return;
    using enum component_outcome;
    world_.compares(comparison::outcome_ruled);
    if (what == no_capacity) {
        if (has_capacity() || !sent_.empty() || !entered_.empty() || !control_.empty())
            breaks(contract::s1, "a place in memory for " + text(head_), "it is dropped for want of one");
        phase_ = phase::none;
        return;
    }
    const bool is_repeat = what == repeated || what == pending;
    const bool is_repeat_right = expected_.may_be_repeat && (!expected_.is_repeat || expected_.outcome == what);
    const bool is_of_slave = what_.has_slaves && expected_.outcome && is_done(*expected_.outcome);
    // What a bridge cannot keep until its slave has confirmed it, it refuses.
    const bool is_right =
        is_repeat ? is_repeat_right
                  : !expected_.outcome || *expected_.outcome == what ||
                        (is_of_slave &&
                         (what == deferred || (what == refused && (!sent_.empty() || head_.sequence_number == 0))));
    if (!is_right)
        breaks(contract::s5,
               expected_.outcome ? text(head_) + ": " + std::string{jaus::describe(*expected_.outcome)}
                                 : text(head_) + " is a new message",
               std::string{jaus::describe(what)});
    if (is_repeat) {
        expected_.entered.reset();
        expected_.control.reset();
        expected_.replies.clear();
        next_ = is_;
    }
    compare_answer(what);
    compare_replies();
    compare_changes();
    const bool is_ruled_out = what == not_controller || what == not_ready || what == experimental;
    if (is_tracked(head_) && !is_repeat && !is_ruled_out) {
        const auto answer = is_done(what) ? jaus::ack_nak::ack : jaus::ack_nak::nak;
        remembered_.push_back({head_.source, head_.command_code, head_.sequence_number, digest_, program_.local(),
                               what == deferred, answer});
        for (const auto& one : sent_) // it may be refused at once, by what has come before it
            if (is_acknowledgement_of(one.head, head_)) settle(one.head);
    }
    is_ = next_;
    phase_ = phase::none;
}

// Half of the places are for one source, a quarter for the controller.
bool component_judge::has_capacity() const {
    if (what_.remembered == 0) return false;
    const auto of_source =
        static_cast<std::size_t>(std::ranges::count(remembered_, head_.source, &remembered_message::source));
    const bool is_over = 2 * of_source >= what_.remembered || 4 * remembered_.size() >= 3 * what_.remembered;
    return !is_over;
}

// ACK for what was executed, NAK for what was not, nothing where nobody asks or it is executed later.
void component_judge::compare_answer(component_outcome what) {
    using enum component_outcome;
    using jaus::ack_nak;
    std::optional<ack_nak> found;
    std::size_t count = 0, after = 0;
    for (const auto& one : sent_) {
        if (!is_acknowledgement_of(one.head, head_)) continue;
        ++count;
        found = one.head.ack_nak;
        after = one.after;
    }
    const bool is_asked = head_.ack_nak == ack_nak::request && jaus::names_one_component(head_.destination) &&
                          what != pending && what != deferred;
    // Another message of a bridge with the same number may be answered meanwhile; of a number 0 it is not known whether
    // it is new.
    if (head_.sequence_number == 0 && (what_.has_slaves || expected_.may_be_repeat)) return;
    if (what == repeated && !expected_.answer_before) return;
    if (what_.has_slaves && what == stopped_on_invalid_emergency) return; // at once, or later
    const auto right = what == repeated ? *expected_.answer_before : is_done(what) ? ack_nak::ack : ack_nak::nak;
    world_.compares(comparison::answer_ruled);
    const bool is_right = is_asked ? count == 1 && found == right : count == 0 || what_.has_slaves;
    if (!is_right)
        breaks(contract::s1,
               is_asked ? std::string{right == ack_nak::ack ? "ACK" : "NAK"} + " of " + text(head_)
                        : "no answer to " + text(head_),
               count == 0 ? "none, " + std::string{jaus::describe(what)}
                          : std::to_string(count) + ", the last one " + (found == ack_nak::ack ? "ACK" : "NAK"));
    const std::size_t told = std::size_t{expected_.entered.has_value()} + std::size_t{expected_.control.has_value()};
    if (is_asked && count == 1 && after < told)
        breaks(contract::s1, "the application learns of a change before its message is acknowledged", "after it");
}

void component_judge::compare_replies() {
    std::vector<const sent_message*> found;
    for (const auto& one : sent_) {
        if (jaus::is_acknowledgement(one.head)) {
            if (!is_acknowledgement_of(one.head, head_) && !what_.has_slaves)
                breaks(contract::s1, "answers to " + text(head_), text(one.head));
            continue;
        }
        const bool is_of_failure = what_.has_slaves &&
                                   one.head.command_code == code_of<jaus::reject_component_control> &&
                                   expected_.replies.empty();
        const bool is_status = what_.has_slaves && one.head.command_code == code_of<jaus::report_component_status>;
        if (!one.head.service_connection && !is_of_failure && !is_status) found.push_back(&one);
    }
    for (const auto& one : sent_) settle(one.head);
    if (phase_ == phase::message && !expected_.outcome) return; // the application's
    world_.compares(comparison::answer_ruled);
    for (std::size_t i = 0; i != std::max(found.size(), expected_.replies.size()); ++i) {
        if (i < found.size() && i < expected_.replies.size() && found[i]->whole == expected_.replies[i]) continue;
        return breaks(contract::s1,
                      i < expected_.replies.size() ? text(head_of(expected_.replies[i])) + " with the right values"
                                                   : "no further message",
                      i < found.size() ? text(found[i]->head) : "it is missing");
    }
}

void component_judge::compare_changes() {
    world_.compares(comparison::state_ruled);
    std::size_t next = 0;
    if (expected_.entered) {
        const bool is_right = !entered_.empty() && entered_.front() == *expected_.entered;
        // A bridge's component may have failed in its emergency, or come back.
        const bool is_after_emergency =
            what_.has_slaves && !entered_.empty() && expected_.entered->from == state_code::emergency &&
            entered_.front().from == state_code::emergency && entered_.front().to != state_code::ready &&
            entered_.front().to != state_code::shutdown;
        if (!is_right && !is_after_emergency)
            breaks(contract::s5, text(expected_.entered->from) + " to " + text(expected_.entered->to),
                   entered_.empty() ? "no change of the state"
                                    : text(entered_.front().from) + " to " + text(entered_.front().to));
        if (!entered_.empty()) next_.state = entered_.front().to;
        next = 1;
    }
    for (; next < entered_.size(); ++next) {
        const auto& one = entered_[next];
        if (one.from != next_.state || !is_own_change(one))
            breaks(contract::s5, "no change from " + text(next_.state), text(one.from) + " to " + text(one.to));
        enter(one.to);
    }
    world_.compares(comparison::control_ruled);
    next = 0;
    if (expected_.control) {
        if (control_.empty() || control_.front() != *expected_.control)
            breaks(contract::s5,
                   expected_.control->now ? "control of " + text(expected_.control->now->address) : "control ends",
                   control_.empty() ? "no change of the controller"
                   : control_.front().now
                       ? "control of " + text(control_.front().now->address)
                       : "control ends, cause " + std::to_string(static_cast<unsigned>(control_.front().why)));
        next = 1;
    }
    for (; next < control_.size(); ++next) {
        const auto& one = control_[next];
        const bool is_failing = what_.has_slaves && !one.now && one.why == jaus::control_change::rejected;
        if (!is_failing)
            breaks(contract::s5, "no change of the controller",
                   "one of cause " + std::to_string(static_cast<unsigned>(one.why)));
        next_.controller.reset();
    }
}

// Of a message that was executed later.
void component_judge::settle(const jaus::header& answer) {
    if (!jaus::is_acknowledgement(answer)) return;
    const auto found = std::ranges::find_if(remembered_, [&](const remembered_message& one) {
        return one.is_pending && one.source == answer.destination && one.code == answer.command_code &&
               one.number == answer.sequence_number;
    });
    if (found == remembered_.end()) return;
    found->is_pending = false;
    found->answer = answer.ack_nak;
    found->at = program_.local();
}

// ---------------------------------------------------------------------------------------------------- time and losses

void component_judge::look_at_silence(watch& life, const jaus::address& who, auto&& lose) {
    const time silence = program_.local() - life.heard;
    if (silence >= what_.timeout) return lose();
    const auto quarters = silence / (what_.timeout / 4);
    if (quarters <= life.asked) return;
    life.asked = quarters;
    ++life.pulses;
    expect_reply({.destination = who, .source = what_.id}, jaus::query_heartbeat_pulse{});
}

void component_judge::runs() {
    begin(phase::run);
    head_ = {};
    if (what_.timeout == time{}) return;
    if (next_.controller)
        look_at_silence(next_.life, next_.controller->address, [&] {
            expect_reply({.destination = next_.controller->address, .source = what_.id},
                         jaus::reject_component_control{});
            next_.controller.reset();
            next_.moved_by.reset();
            expected_.control = control_call{std::nullopt, jaus::control_change::lost};
        });
    if (next_.moved_by && !(next_.controller && next_.controller->address == next_.moved_by->id))
        look_at_silence(next_.moved_by->life, next_.moved_by->id, [&] {
            next_.moved_by.reset();
            expected_.control = control_call{next_.controller, jaus::control_change::lost};
        });
}

void component_judge::has_run() {
    if (phase_ != phase::run) return;
    if (what_.has_slaves) // which has other senders, of whose commands some wait
        std::erase_if(sent_, [&](const sent_message& one) {
            return one.head.command_code == code_of<jaus::query_heartbeat_pulse> &&
                   !(is_.controller && one.head.destination == is_.controller->address);
        });
    if (!expected_.replies.empty()) world_.compares(comparison::pulse_asked);
    compare_replies();
    compare_changes();
    is_ = next_;
    phase_ = phase::none;
}

void component_judge::loses(const jaus::address& who) {
    begin(phase::loss);
    head_ = {};
    if (std::erase_if(next_.holders, [&](const jaus::address& one) { return matches(who, one); }) != 0)
        next_.is_anyones = true;
    if (next_.controller && matches(who, next_.controller->address)) {
        next_.controller.reset();
        next_.moved_by.reset();
        expected_.control = control_call{std::nullopt, jaus::control_change::lost};
    } else if (next_.moved_by && matches(who, next_.moved_by->id)) {
        next_.moved_by.reset();
        expected_.control = control_call{next_.controller, jaus::control_change::lost};
    }
}

void component_judge::has_lost() {
    if (phase_ != phase::loss) return;
    compare_replies();
    compare_changes();
    is_ = next_;
    phase_ = phase::none;
}

void component_judge::initializes() {
    begin(phase::application);
    head_ = {};
    if (is_.state != state_code::initialize) return;
    expected_.entered = transition{is_.state, state_code::ready};
    enter(state_code::ready);
}

void component_judge::ends_emergency() {
    begin(phase::application);
    head_ = {};
    if (is_.state != state_code::emergency) return;
    const auto to = is_.before == state_code::ready ? state_code::standby : is_.before;
    expected_.entered = transition{is_.state, to};
    enter(to);
}

void component_judge::has_changed() {
    compare_replies();
    compare_changes();
    is_ = next_;
    phase_ = phase::none;
}

// What is due by a time happens then, not with the next message.
void component_judge::check() {
    bool is_late = false;
    const auto look = [&](const watch& life, const jaus::address& who) {
        world_.compares(comparison::pulse_asked);
        const auto quarters = (program_.local() - life.heard) / (what_.timeout / 4);
        if (quarters <= life.asked) return;
        is_late = true;
        if (late_since_ && world_.now() - std::max(*late_since_, program_.jumped_at()) > to_act)
            breaks(contract::s6, "a query of the pulse of " + text(who) + ", or its loss, when it is due", "none");
    };
    if (program_.running() && what_.timeout != time{}) {
        if (is_.controller) look(is_.life, is_.controller->address);
        if (is_.moved_by && !controls(is_.moved_by->id)) look(is_.moved_by->life, is_.moved_by->id);
    }
    if (!is_late)
        late_since_.reset();
    else if (!late_since_)
        late_since_ = world_.now();
}

void component_judge::breaks(contract point, std::string expected, std::string found) {
    world_.breaks({.point = point, .who = what_.number, .expected = std::move(expected), .found = std::move(found)});
}

} // namespace simulation
