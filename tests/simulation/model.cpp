#include "simulation/model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace simulation {
namespace {

using jaus::primary_status_code;

constexpr auto slack = std::chrono::milliseconds{150};

bool is_answer_to(const jaus::header& answer, const jaus::header& head) {
    return head.source == answer.destination && head.command_code == answer.command_code &&
           head.sequence_number == answer.sequence_number;
}
bool is_answer_to(const jaus::header& answer, const sent_message& sent) {
    return is_answer_to(answer,
                        {.command_code = sent.code, .source = sent.source, .sequence_number = sent.sequence_number});
}
std::string in_ms(time t) { return std::to_string(t / std::chrono::milliseconds{1}) + " ms"; }

} // namespace

// ---------------------------------------------------------------------------------------------------- senders

std::uint32_t model::hands_over(std::uint8_t sender, bytes message, time must_end_in) {
    jaus::header head{};
    if (!wire::decode_prefix(head, message) || jaus::is_acknowledgement(head)) return 0;
    if (head.command_code >= 0x2000 || !jaus::names_one_component(head.destination)) return 0;
    if (head.experimental && jaus::is_standard(head.command_code)) return 0;
    auto& account = senders_[sender];
    const auto body = message.subspan(jaus::header_size);
    const auto digest = digest_of(body);
    // A message that is sent again is the same one.
    for (std::size_t i = 0; i != std::min<std::size_t>(account.count, account.last.size()); ++i) {
        const auto* known = find(account.last[(account.count - 1 - i) % account.last.size()]);
        if (known != nullptr && !known->closed && known->wants_acknowledgement &&
            head.ack_nak == jaus::ack_nak::request && known->life == account.program->life() &&
            known->code == head.command_code && known->sequence_number == head.sequence_number &&
            known->destination == head.destination && known->digest == digest)
            return known->number;
    }
    const auto number = ++numbers_;
    auto& made = sent_[number % sent_.size()];
    made = {.number = number,
            .sender = sender,
            .life = account.program->life(),
            .source = head.source,
            .destination = head.destination,
            .code = head.command_code,
            .sequence_number = head.sequence_number,
            .wants_acknowledgement = head.ack_nak == jaus::ack_nak::request,
            .digest = digest,
            .at = world_.now()};
    if (moves(head.command_code)) {
        const auto command = motion_in(head.command_code, body);
        made.is_malformed = !command || body.size() != head.data_size;
        made.command = command.value_or(0);
        if (made.command != 0) of_command_[made.command % of_command_.size()] = number;
    }
    account.last[account.count++ % account.last.size()] = number;
    if (must_end_in != time{}) account.open.emplace_back(number, account.program->run_time() + must_end_in);
    return number;
}

void model::learns(std::uint8_t sender, const jaus::header& head, bool acknowledged) {
    auto& account = senders_[sender];
    sent_message* mine = nullptr;
    bool ambiguous = head.sequence_number == 0;
    for (std::size_t i = 0; i != std::min<std::size_t>(account.count, account.last.size()); ++i) {
        auto* known = find(account.last[(account.count - 1 - i) % account.last.size()]);
        if (known == nullptr || !known->wants_acknowledgement || known->code != head.command_code ||
            known->sequence_number != head.sequence_number || known->destination != head.destination)
            continue;
        // Another message of the same number: the acknowledgement does not say whose it is.
        if (mine != nullptr) ambiguous = true;
        if (mine == nullptr && known->life == account.program->life()) mine = known;
    }
    if (mine == nullptr) return;
    mine->closed = true;
    world_.tell({.what = acknowledged ? deed::hears_acknowledged : deed::hears_refused,
                 .who = account.program->number(),
                 .code = head.command_code,
                 .number = head.sequence_number,
                 .message = mine->number});
    if (acknowledged && !ambiguous && !mine->done &&
        std::ranges::find(actuators_, mine->destination, &actuator_account::id) != actuators_.end())
        breaks(contract::s1, account, mine->number, "an acknowledgement only of what was executed",
               "command code " + hex(head.command_code) + " was acknowledged, and not executed");
}

void model::learns_nothing(std::uint8_t sender, const jaus::header& head) {
    auto& account = senders_[sender];
    for (std::size_t i = 0; i != std::min<std::size_t>(account.count, account.last.size()); ++i) {
        auto* known = find(account.last[(account.count - 1 - i) % account.last.size()]);
        if (known == nullptr || !known->wants_acknowledgement || known->closed || known->code != head.command_code ||
            known->sequence_number != head.sequence_number || known->destination != head.destination)
            continue;
        known->closed = true;
        world_.tell({.what = deed::hears_nothing,
                     .who = account.program->number(),
                     .code = head.command_code,
                     .number = head.sequence_number,
                     .message = known->number});
        return;
    }
}

// ---------------------------------------------------------------------------------------------------- large data sets

void model::sends_large(std::uint8_t sender, const jaus::header& head, std::uint64_t identity) {
    auto& account = senders_[sender];
    if (account.large.size() == 32) account.large.erase(account.large.begin());
    account.large.push_back({.identity = identity,
                             .destination = head.destination,
                             .code = head.command_code,
                             .life = account.program->life(),
                             .wants_acknowledgement = head.ack_nak == jaus::ack_nak::request,
                             .at = world_.now()});
    world_.tell({.what = deed::sends_large,
                 .who = account.program->number(),
                 .code = head.command_code,
                 .value = static_cast<std::uint32_t>(identity)});
}

void model::learns_large(std::uint8_t sender, const jaus::header& head, jaus::delivered what) {
    auto& account = senders_[sender];
    for (auto& one : account.large) {
        if (one.closed || !one.wants_acknowledgement || one.life != account.program->life() ||
            one.code != head.command_code || one.destination != head.destination)
            continue;
        one.closed = true;
        world_.tell({.what = what == jaus::delivered::acknowledged ? deed::hears_acknowledged
                             : what == jaus::delivered::refused    ? deed::hears_refused
                                                                   : deed::hears_nothing,
                     .who = account.program->number(),
                     .code = head.command_code,
                     .value = static_cast<std::uint32_t>(one.identity)});
        if (what == jaus::delivered::timed_out && one.delivered == 0 && is_undisturbed(account, one))
            breaks(contract::s1, account, 0, "a large data set of which nothing was lost arrives",
                   "number " + std::to_string(one.identity) + " was given up");
        if (what == jaus::delivered::acknowledged && one.delivered == 0)
            breaks(contract::s1, account, 0, "a large data set is acknowledged when its receiver has all of it",
                   "number " + std::to_string(one.identity) + " was acknowledged, and its receiver has not got it");
        return;
    }
}

// Packets that ask for no acknowledgement are told from those of the data set before by the pause between the two,
// which a sender whose clock leaps does not keep.
bool model::has_not_paused(const jaus::address& source) const {
    const auto from = account_of(source);
    if (!from) return false;
    const auto& sender = senders_[*from];
    const time lately = world_.now() - std::chrono::seconds{2};
    return sender.program->leapt_at() > std::max(lately, time{}) &&
           std::ranges::any_of(sender.large, [&](const sent_large& one) {
               return !one.wants_acknowledgement && one.at > lately - std::chrono::seconds{3};
           });
}

void model::delivers_large(const process& at, const jaus::header& head, bytes body) {
    const auto identity = identity_of_large(body);
    world_.compares(comparison::large_data);
    if (body.size() > 256 * jaus::max_body_size) world_.compares(comparison::long_data);
    world_.tell({.what = deed::delivers_large,
                 .who = at.number(),
                 .code = head.command_code,
                 .value = static_cast<std::uint32_t>(identity.value_or(0))});
    const auto fail = [&](contract point, const std::string& expected, const std::string& found) {
        world_.breaks({.point = point, .who = at.number(), .expected = expected, .found = found});
    };
    if (!identity && has_not_paused(head.source)) return;
    if (!identity)
        return fail(contract::s7, "the bytes of one large data set that was sent",
                    "a body of " + std::to_string(body.size()) + " bytes that nobody has sent as it is");
    const auto from = account_of(head.source);
    if (!from) return fail(contract::s7, "a large data set of its sender", "the sender is another");
    for (auto& one : senders_[*from].large) {
        if (one.identity != *identity || one.code != head.command_code) continue;
        if (one.destination != head.destination)
            fail(contract::s7, "a large data set for this component", "it was sent to another");
        if (one.delivered != 0 && one.wants_acknowledgement && at.jumped_at() <= one.delivered_at)
            fail(contract::s1, "a large data set is delivered once",
                 "number " + std::to_string(*identity) + " was delivered " + in_ms(world_.now() - one.delivered_at) +
                     " ago too");
        ++one.delivered;
        one.delivered_at = world_.now();
        return;
    }
}

// ---------------------------------------------------------------------------------------------------- actuators

void model::starts(std::uint8_t which) {
    auto& a = actuators_[which];
    a.state = {};
    a.not_ready_since = world_.now();
    if (a.wire == nullptr) a.command = 0; // a slave goes on without its program
    a.reset_at = world_.now();
    a.controller.reset();
    a.orphaned_since.reset();
    a.holders.clear();
    a.current = 0;
    a.arrived.clear();
    // What was executed and acknowledged in an earlier life may be executed and acknowledged again.
    for (auto& one : sent_)
        if (one.destination == a.id) one.executed = 0, one.acknowledged = false;
}

void model::arrives(std::uint8_t which, std::uint32_t message, const jaus::header& head) {
    auto& a = actuators_[which];
    a.current = message;
    a.head = head;
    a.acknowledged = a.refused = false;
    auto* sent = find(message);
    if (sent != nullptr && sent->wants_acknowledgement) note_arrival(a, message);
    a.was_repeat = sent != nullptr && sent->done;
    if (sent != nullptr) sent->was_refused = false;
    if (sent != nullptr && sent->arrived_at == time{}) sent->arrived_at = world_.now();
    // A large data set may have waited in its sender's node, which also asks for heartbeats by itself.
    const bool is_life =
        head.command_code != large_code && head.command_code != jaus::command_code_of<jaus::query_heartbeat_pulse>;
    if (is_life && a.controller && senders_[*a.controller].id == head.source) a.controller_heard = world_.now();
    world_.tell({.what = deed::gets,
                 .who = a.number,
                 .whom = sent != nullptr ? senders_[sent->sender].program->number() : std::uint8_t{},
                 .code = head.command_code,
                 .number = head.sequence_number,
                 .message = message,
                 .value = sent != nullptr ? sent->command : 0});
}

// Keeps the last 512, and each earlier one without an acknowledgement: a component acknowledges a stop order when its
// slave has confirmed it, however many messages arrive before that.
void model::note_arrival(actuator_account& a, std::uint32_t message) {
    constexpr std::ptrdiff_t last = 512;
    a.arrived.push_back(message);
    if (std::ssize(a.arrived) <= last) return;
    const auto older = a.arrived.end() - last - 1;
    if (const auto* sent = find(*older); sent == nullptr || sent->acknowledged) a.arrived.erase(older);
}

void model::answers(std::uint8_t which, bytes message) {
    auto& a = actuators_[which];
    const auto m = jaus::split(message);
    if (!m) return;
    const auto& head = m.header;
    if (!jaus::is_acknowledgement(head)) {
        if (head.command_code == jaus::command_code_of<jaus::confirm_component_control>) confirmed(a, head, m.body);
        if (head.command_code == jaus::command_code_of<jaus::reject_component_control>) {
            const auto to = account_of(head.destination);
            if (to && a.controller == to) {
                // A bridge rejects it for its slaves as well, whatever its state.
                if (a.wire == nullptr) check_control_is_kept(a);
                a.controller.reset();
            }
        }
        return reported(a, head, m.body);
    }
    check_asked_for(a, head);
    const bool ack = head.ack_nak == jaus::ack_nak::ack;
    if (a.current != 0 && is_answer_to(head, a.head)) {
        (ack ? a.acknowledged : a.refused) = true;
        return;
    }
    if (ack) later_acknowledged(a, head);
}

// By the message that is being handled, or by one that has arrived.
void model::check_asked_for(const actuator_account& a, const jaus::header& answer) {
    if (answer.command_code >= 0x2000) return; // not followed
    world_.compares(comparison::asked_for);
    const bool is_current = a.head.ack_nak == jaus::ack_nak::request && is_answer_to(answer, a.head);
    const bool is_asked = is_current || std::ranges::any_of(a.arrived, [&](std::uint32_t number) {
                              const auto* sent = find(number);
                              return sent != nullptr && is_answer_to(answer, *sent);
                          });
    if (!is_asked)
        breaks(contract::s1, a, 0, "an acknowledgement or a refusal that somebody asked for",
               "one of command code " + hex(answer.command_code) + ", number " +
                   std::to_string(answer.sequence_number) + ", that nobody asked for");
}

// Of a message that took its time. Of several with the same number it is one that was executed, if there is one. One
// with the number 0 that was refused when it came comes last: the NAK may have been for one before it.
void model::later_acknowledged(actuator_account& a, const jaus::header& head) {
    std::uint32_t latest = 0;
    look(a);
    for (const bool takes_refused : {false, true}) {
        for (auto number = a.arrived.rbegin(); number != a.arrived.rend(); ++number) {
            const auto* sent = find(*number);
            if (sent == nullptr || !is_answer_to(head, *sent) ||
                (!takes_refused && sent->was_refused && !sent->done && sent->sequence_number == 0))
                continue;
            if (latest == 0) latest = sent->number;
            if (sent->done || (!sent->is_malformed && has_effect(a, *sent))) return acknowledged(a, sent->number);
        }
    }
    acknowledged(a, latest);
}

bool model::state_is_right(const actuator_account& a, std::uint16_t code) {
    using enum primary_status_code;
    switch (code) {
    case jaus::command_code_of<jaus::set_emergency>:
        return a.state == emergency || a.state == primary_status_code::shutdown;
    case jaus::command_code_of<jaus::standby>: return a.state != ready;
    case jaus::command_code_of<jaus::shutdown>: return a.state == primary_status_code::shutdown;
    case jaus::command_code_of<jaus::resume>: return a.state == ready;
    default: return true;
    }
}

// What of an actuator need not last until it is acknowledged: another message may have come since.
void model::look(actuator_account& a) const {
    if (a.command == 0) a.rest_seen_at = world_.now();
    const auto* const arm = arm_of(a);
    if (arm == nullptr || arm->in_emergency()) a.emergency_seen_at = world_.now();
}

// Only an arm knows of emergencies: to others they are stop orders.
const arm_unit* model::arm_of(const actuator_account& a) {
    return a.wire == nullptr ? nullptr : (*a.wire)[a.axes.front().slave].arm;
}

// Its drives have, or had, the target 0, and slow down.
bool model::was_told_to_rest(const actuator_account& a, time since) {
    return !a.axes.empty() && std::ranges::all_of(a.axes, [&](const axis_account& each) {
        auto* const drive = (*a.wire)[each.slave].drive;
        return drive != nullptr &&
               (drive->axis(each.axis).values.target_velocity == 0 || drive->was_told_to_rest(each.axis, since));
    });
}

bool model::has_effect(const actuator_account& a, const sent_message& sent) const {
    const bool has_rested = a.rest_seen_at >= sent.arrived_at;
    switch (sent.code) {
    case jaus::command_code_of<jaus::set_joint_velocities>:
        return sent.command == 0 && (has_rested || was_told_to_rest(a, sent.arrived_at));
    case jaus::command_code_of<jaus::set_wrench_effort>: return sent.command == 0 && has_rested;
    case jaus::command_code_of<jaus::set_emergency>: {
        // One that has restarted unseen does not know of its emergency any more.
        const bool just_on = world_.now() - a.program->jumped_at() <= 2 * a.at_rest_in;
        const time unseen = (just_on ? a.program->last_silence() : sent.arrived_at) - 2 * a.at_rest_in;
        const auto* const arm = arm_of(a);
        const bool was_restarted =
            arm != nullptr && ((*a.wire)[a.axes.front().slave].restarted_at >= unseen || arm->denies_objects());
        const bool ended = a.state == primary_status_code::shutdown;
        return sent.state_was_right && has_rested && (ended || was_restarted || a.emergency_seen_at >= sent.arrived_at);
    }
    case jaus::command_code_of<jaus::standby>:
    case jaus::command_code_of<jaus::shutdown>: return sent.state_was_right && has_rested;
    case jaus::command_code_of<jaus::clear_emergency>:
        return arm_of(a) == nullptr || a.state == primary_status_code::emergency || !arm_of(a)->in_emergency();
    default: return sent.state_was_right;
    }
}

void model::acknowledged(actuator_account& a, std::uint32_t number) {
    auto* sent = find(number);
    if (sent == nullptr) return;
    world_.tell({.what = deed::acknowledges,
                 .who = a.number,
                 .whom = senders_[sent->sender].program->number(),
                 .code = sent->code,
                 .number = sent->sequence_number,
                 .message = number});
    sent->acknowledged = true;
    look(a);
    world_.compares(stops(sent->code) ? comparison::stop_confirmed : comparison::acknowledgement);
    if (sent->is_malformed)
        return breaks(contract::s1, a, number, "a NAK, or nothing, for a body that is none of this message",
                      "an acknowledgement");
    if (has_effect(a, *sent)) sent->done = true;
    // A drive has no counter of commands: that its application does nothing cannot be seen.
    if (moves(sent->code) && any_slave(a, [&](const ring_place& each) {
            return each.drive != nullptr && (each.frozen || each.unfrozen_at >= sent->arrived_at);
        }))
        sent->done = true;
    if (sent->stopped_it && any_slave(a, [&](const ring_place& each) {
            return each.unreachable_since && *each.unreachable_since < sent->arrived_at;
        }))
        breaks(contract::s2, a, number, "a stop order is acknowledged when the slave has confirmed it",
               "the slave was not reached since it came");
    if (!sent->done && !is_like_one_before(*sent))
        breaks(stops(sent->code) ? contract::s2 : contract::s1, a, number,
               "command code " + hex(sent->code) + " is executed before it is acknowledged",
               "it was acknowledged, the state is " + text(a.state) +
                   (a.command == 0 ? ", at rest" : ", efforts of command " + std::to_string(a.command)));
}

// A sender that begins again with the same numbers, and with the very same message, repeats for its receiver what that
// still remembers.
bool model::is_like_one_before(const sent_message& sent) const {
    constexpr auto remembered = jaus::component_options{}.memory + std::chrono::seconds{2};
    return sent.sequence_number != 0 && std::ranges::any_of(sent_, [&](const sent_message& one) {
               return one.done && one.life != sent.life && one.source == sent.source && one.code == sent.code &&
                      one.sequence_number == sent.sequence_number && one.destination == sent.destination &&
                      one.digest == sent.digest && sent.arrived_at - one.arrived_at <= remembered;
           });
}

void model::handled(std::uint8_t which, jaus::component_outcome what) {
    auto& a = actuators_[which];
    auto* sent = find(std::exchange(a.current, 0));
    if (sent == nullptr) return;
    tell_choice(a, *sent, what);
    look(a);
    if (!a.refused && state_is_right(a, sent->code)) sent->state_was_right = true;
    if (!moves(sent->code) && !a.was_repeat && !a.refused && has_effect(a, *sent)) sent->done = true;
    // A message numbered 0 is not known from the one before: what is like the last one is taken for its repeat.
    const bool is_in_force = moves(sent->code) ? a.command == sent->command : has_effect(a, *sent);
    if (a.acknowledged && !sent->done && sent->sequence_number == 0 && is_in_force) sent->done = true;
    if (a.acknowledged) acknowledged(a, sent->number);
    if (a.refused) {
        sent->was_refused = true;
        world_.tell({.what = deed::refuses,
                     .who = a.number,
                     .whom = senders_[sent->sender].program->number(),
                     .code = sent->code,
                     .number = sent->sequence_number,
                     .message = sent->number});
        if (a.wire == nullptr && moves(sent->code) && must_be_remembered(a, *sent))
            breaks(contract::s1, a, sent->number, "ACK or nothing for what was executed", "a NAK");
        const bool has_reason = sent->is_malformed || a.state != primary_status_code::ready ||
                                (a.controller && *a.controller != sent->sender);
        if (a.wire == nullptr && moves(sent->code) && !has_reason && !a.was_repeat)
            breaks(contract::s1, a, sent->number, "a refusal has a reason",
                   "a NAK for a motion command that may be executed");
    }
    take_emergency_codes(a, *sent);
    if (sent->code == jaus::command_code_of<jaus::reset>) a.reset_at = world_.now();
    if (sent->code == jaus::command_code_of<jaus::set_emergency> && a.state != primary_status_code::emergency &&
        a.state != primary_status_code::shutdown && a.state != primary_status_code::failure)
        breaks(contract::s2, a, sent->number, "Set Emergency stops, whoever sends it", "the state is " + text(a.state));
    if (sent->code == jaus::command_code_of<jaus::release_component_control> && a.controller == sent->sender &&
        !a.was_repeat && !a.refused)
        a.controller.reset();
}

// What the component has chosen to do with a message.
void model::tell_choice(const actuator_account& a, const sent_message& sent, jaus::component_outcome what) {
    using enum jaus::component_outcome;
    switch (what) {
    case deferred:
    case malformed:
    case not_controller:
    case not_ready:
    case repeated:
    case pending:
    case no_capacity:
    case experimental:
        return world_.tell({.what = what == deferred ? deed::queues : deed::drops,
                            .who = a.number,
                            .whom = senders_[sent.sender].program->number(),
                            .code = sent.code,
                            .number = sent.sequence_number,
                            .message = sent.number,
                            .value = what == deferred ? 0 : sent.command,
                            .why = jaus::describe(what).data()});
    default: return; // executed; or refused, by what has told it
    }
}

void model::drops(std::uint8_t which, const jaus::header& head, const char* why) {
    tell(which, deed::drops, head, why);
}

void model::merges(std::uint8_t which, const jaus::header& head) { tell(which, deed::merges, head, nullptr); }

void model::tell(std::uint8_t which, deed what, const jaus::header& head, const char* why) {
    const auto from = account_of(head.source);
    if (!from) return;
    const auto& account = senders_[*from];
    const sent_message* message = nullptr;
    for (std::size_t i = 0; message == nullptr && i != std::min<std::size_t>(account.count, account.last.size()); ++i) {
        const auto* known = find(account.last[(account.count - 1 - i) % account.last.size()]);
        if (known != nullptr && known->code == head.command_code && known->sequence_number == head.sequence_number &&
            known->destination == actuators_[which].id)
            message = known;
    }
    world_.tell({.what = what,
                 .who = actuators_[which].number,
                 .whom = account.program->number(),
                 .code = head.command_code,
                 .number = head.sequence_number,
                 .message = message != nullptr ? message->number : 0,
                 .value = message != nullptr ? message->command : 0,
                 .why = why});
}

void model::take_emergency_codes(actuator_account& a, const sent_message& sent) {
    const auto held = std::ranges::find(a.holders, sent.source, &emergency_holder::id);
    if (sent.code == jaus::command_code_of<jaus::set_emergency> && a.state == primary_status_code::emergency) {
        if (held == a.holders.end())
            a.holders.push_back({sent.source, world_.now(), false});
        else
            *held = {sent.source, world_.now(), false};
        look_for_lost_holders(a); // it may be given up before the next check
    }
    if (sent.code == jaus::command_code_of<jaus::clear_emergency> && !a.refused && held != a.holders.end())
        a.holders.erase(held);
}

void model::executes(std::uint8_t which, command_number command) {
    auto& a = actuators_[which];
    const auto number = of_command_[command % of_command_.size()];
    auto* sent = command == 0 ? find(a.current) : find(number);
    world_.tell({.what = deed::executes,
                 .who = a.number,
                 .code = sent != nullptr ? sent->code : std::uint16_t{},
                 .number = sent != nullptr ? sent->sequence_number : std::uint16_t{},
                 .message = sent != nullptr ? sent->number : 0,
                 .value = command});
    note_efforts(a, command);
    if ((sent == nullptr || sent->destination != a.id) && has_address_of_another(a)) return;
    obeys(a, sent, command);
    if (sent == nullptr) return;
    a.commander = sent->sender;
    if (a.current != 0 && sent->number != a.current)
        breaks(contract::s7, a, sent->number, "the body of the message that came", "that of another");
    if (sent->wants_acknowledgement && sent->sequence_number != 0 && must_be_remembered(a, *sent))
        breaks(contract::s1, a, sent->number, "a command that asks for an acknowledgement is executed once",
               "it was executed " + in_ms(world_.now() - sent->executed_at) + " ago too");
    ++sent->executed;
    sent->executed_at = world_.now();
    sent->done = true;
}

// Its slave gets the commands of another one, too, until the bridge can have noticed it.
bool model::has_address_of_another(const actuator_account& a) const {
    return a.wire != nullptr && any_slave(a, [&](const ring_place& each) {
               return each.taken_since &&
                      world_.now() - std::max(*each.taken_since, a.program->jumped_at()) <= a.noticed_in;
           });
}

// An actuator, or the first axes of one.
void model::obeys(actuator_account& a, const sent_message* sent, command_number command) {
    world_.compares(comparison::obeyed);
    if (sent == nullptr || (command != 0 && sent->command != command) || sent->destination != a.id)
        return breaks(contract::s7, a, 0, "efforts that somebody sent to this actuator",
                      "command " + std::to_string(command) + ", which nobody has sent");
    // A stop order replaces what drives have not executed yet; a command may wait for the torque of all of them while
    // somebody else gets control.
    constexpr auto in_outputs = std::chrono::milliseconds{30};
    const time limit = a.wire != nullptr && arm_of(a) == nullptr ? in_outputs : a.at_rest_in;
    if (a.state != primary_status_code::ready && !was_on_its_way(a, *sent, a.not_ready_since, limit))
        breaks(contract::s5, a, sent->number, "motion commands are obeyed in Ready only",
               "one was obeyed in " + text(a.state));
    if (a.controller && *a.controller != sent->sender && !was_on_its_way(a, *sent, a.controlled_since, a.at_rest_in))
        breaks(contract::s5, a, sent->number, "motion commands come from the controller",
               "one of " + world_.names()[senders_[sent->sender].program->number()] + " was obeyed under control of " +
                   world_.names()[senders_[*a.controller].program->number()]);
    // What the slave's mailbox has got is executed; what waits behind it is dropped. A frame that is sent again, and
    // what arrives together with the change of control, may be on its way already.
    const auto* const arm = arm_of(a);
    if (arm == nullptr || !a.controller || (*a.wire)[a.axes.front().slave].cyclic) return;
    constexpr time lately = std::chrono::milliseconds{500};
    if (a.wire->frames_disturbed_at() >= sent->arrived_at || sent->arrived_at == a.controlled_since) return;
    if (world_.now() - a.controlled_since < lately) world_.compares(comparison::loser_dropped);
    const auto& slave = (*a.wire)[a.axes.front().slave];
    if (*a.controller != sent->sender && slave.mailbox_written_at > a.controlled_since)
        breaks(contract::s5, a, sent->number, "queued commands of another are dropped when a component gets control",
               "one of " + world_.names()[senders_[sent->sender].program->number()] + " was sent to the slave " +
                   in_ms(slave.mailbox_written_at - a.controlled_since) + " after " +
                   world_.names()[senders_[*a.controller].program->number()] + " had got control");
}

// A command that stands in a slave's mailbox cannot be taken back while the slave cannot be reached or does nothing. A
// stop order follows it.
bool model::was_on_its_way(const actuator_account& a, const sent_message& sent, time changed, time limit) const {
    if (a.wire == nullptr || sent.arrived_at > changed) return false;
    return any_slave(a, [&](const ring_place& each) {
        return world_.now() - std::max({changed, each.disturbed_at, each.unfrozen_at, each.missed_at}) < limit;
    });
}

// Executed, and not so long ago that the actuator's component has forgotten it. Programs that are not of the library
// may repeat a message later than that.
bool model::must_be_remembered(const actuator_account& a, const sent_message& sent) const {
    if (sent.executed == 0 || a.program->jumped_at() > sent.executed_at) return false;
    const bool is_over = world_.now() - sent.executed_at >= jaus::component_options{}.memory;
    return !(is_over && senders_[sent.sender].repeats_late);
}

void model::rests(std::uint8_t which) {
    auto& a = actuators_[which];
    if (a.command != 0) world_.tell({.what = deed::rests, .who = a.number});
    note_efforts(a, 0);
}

void model::note_efforts(actuator_account& a, command_number command) {
    if (command == a.command) return;
    a.command = command;
    a.orphaned_since.reset();
    look(a);
    a.efforts[a.effort_count++ % a.efforts.size()] = {world_.now(), command};
}

// At any instant since then.
template <class Says> bool model::were_in_force(const actuator_account& a, time since, const Says& says) const {
    if (says(a.command)) return true;
    time until = world_.now();
    for (std::size_t i = 0; i != std::min<std::size_t>(a.effort_count, a.efforts.size()); ++i) {
        const auto& [at, what] = a.efforts[(a.effort_count - 1 - i) % a.efforts.size()];
        if (says(what) && until >= since) return true;
        if (at <= since) return false;
        until = at;
    }
    return says(0); // before the first
}

void model::moves_to(std::uint8_t which, std::size_t axis, command_number command) {
    auto& a = actuators_[which];
    a.axes[axis].command = command;
    const bool is_common = std::ranges::all_of(a.axes, [&](const auto& each) { return each.command == command; });
    if (is_common && command == 0) return rests(which);
    if (is_common && (command != a.command || a.axes.size() != 1)) return executes(which, command);
    if (is_common) return;
    // Of several axes some obey already, or still.
    if (command != 0) obeys(a, find(of_command_[command % of_command_.size()]), command);
    if (a.command == 0) note_efforts(a, command);
}

void model::ends(std::uint8_t which, time told) {
    const auto& a = actuators_[which];
    for (const auto& axis : a.axes) {
        world_.compares(comparison::rest_at_end);
        const auto& slave = (*a.wire)[axis.slave];
        const bool was_disturbed = slave.disturbed_at + std::chrono::milliseconds{700} > told || slave.frozen ||
                                   a.wire->trouble_of(axis.slave) || a.program->jumped_at() > told;
        if (axis.command != 0 && !was_disturbed)
            breaks(contract::s6, a, 0, "a program that is told to end brings its actuators to rest first",
                   "efforts of command " + std::to_string(axis.command) + ", " + in_ms(world_.now() - told) + " later");
    }
}

void model::enters(std::uint8_t which, primary_status_code from, primary_status_code to) {
    using enum primary_status_code;
    auto& a = actuators_[which];
    world_.tell({.what = deed::enters_state,
                 .who = a.number,
                 .number = static_cast<std::uint16_t>(from),
                 .message = a.current,
                 .value = static_cast<std::uint32_t>(to)});
    look_for_lost_holders(a);
    if (to == ready && (from == failure || from == initialize))
        check_ready(a, std::max(a.lost_since, a.not_ready_since));
    if (a.state == ready && to != ready) a.not_ready_since = world_.now();
    if (from == ready && to == failure) check_cause(a, "a component stays Ready");
    if (a.state != to && (to == failure || to == initialize)) a.failed_since = world_.now();
    if (a.state != to && to == failure && from != emergency) a.lost_since = world_.now(); // that covers rest
    if (a.state != to) a.entered_at = world_.now();
    a.state = to;
    auto* cause = find(a.current);
    if (cause != nullptr && (from == ready || to == emergency)) cause->stopped_it = true;
    const auto is = [&](std::uint16_t code) { return cause != nullptr && cause->code == code; };
    const bool by_controller = cause != nullptr && (!a.controller || *a.controller == cause->sender);
    if (from == primary_status_code::standby && to == ready &&
        (!is(jaus::command_code_of<jaus::resume>) || !by_controller))
        breaks(contract::s5, a, a.current, "only Resume of the controller leads from Standby to Ready",
               cause == nullptr ? "nobody's message" : "command code " + hex(cause->code));
    if (to == emergency || from != emergency) return;
    if (is(jaus::command_code_of<jaus::clear_emergency>)) {
        const bool others_are_gone = std::ranges::all_of(a.holders, [&](const emergency_holder& holder) {
            return holder.id == cause->source || holder.may_be_lost;
        });
        if (!others_are_gone)
            breaks(contract::s5, a, a.current, "an emergency ends when each who set it has cleared it",
                   "Clear Emergency of one ended it, and another had set it");
    } else if (!is(jaus::command_code_of<jaus::shutdown>) && a.current != 0) {
        breaks(contract::s5, a, a.current, "an emergency ends by Clear Emergency or Shutdown only",
               "it ended with command code " + hex(cause == nullptr ? 0 : cause->code));
    }
    a.holders.clear();
}

void model::hears_lost(std::uint8_t which, const jaus::address& who) {
    auto& a = actuators_[which];
    const auto is_same = [](std::uint8_t level, std::uint8_t lost) { return lost == 255 || level == lost; };
    const auto is_lost = [&](const jaus::address& id) {
        return id.subsystem == who.subsystem && is_same(id.node, who.node) && is_same(id.component, who.component) &&
               is_same(id.instance, who.instance);
    };
    const bool is_of_controller = a.controller && is_lost(senders_[*a.controller].id);
    if (is_of_controller) a.controller_gone = world_.now();
    world_.tell({.what = deed::gives_up,
                 .who = a.number,
                 .value = std::uint32_t{who.subsystem} << 24U | std::uint32_t{who.node} << 16U |
                          std::uint32_t{who.component} << 8U | who.instance});
}

void model::person_clears(std::uint8_t which) {
    world_.tell({.what = deed::person, .who = actuators_[which].number});
    actuators_[which].holders.clear();
}

void model::controlled(std::uint8_t which, const std::optional<jaus::address>& now) {
    auto& a = actuators_[which];
    const auto who = now ? account_of(*now) : std::nullopt;
    world_.tell({.what = deed::controlled_by,
                 .who = a.number,
                 .whom = who ? senders_[*who].program->number() : std::uint8_t{},
                 .message = a.current});
    a.controlled_since = world_.now();
    if (now) return;
    check_control_is_kept(a);
    const auto* cause = find(a.current);
    const bool is_released = cause != nullptr && cause->code == jaus::command_code_of<jaus::release_component_control>;
    if (a.controller && a.command != 0 && !is_released) a.orphaned_since = unreachable_since(*a.controller, a);
    a.controller.reset();
}

// ---------------------------------------------------------------------------------------------------- control, reports

void model::confirmed(actuator_account& a, const jaus::header& head, bytes body) {
    jaus::confirm_component_control m{};
    const auto to = account_of(head.destination);
    if (!to || !wire::decode(m, body) || m.response_code != jaus::component_control_response::control_accepted) return;
    a.controller = *to;
    a.controller_heard = world_.now();
}

// A controller whose messages come keeps control until it releases it, the component confirms another or fails.
void model::check_control_is_kept(const actuator_account& a) {
    using enum primary_status_code;
    if (!a.controller || a.state == failure || a.state == primary_status_code::shutdown) return;
    const auto* cause = find(a.current);
    const auto is = [&](std::uint16_t code) { return cause != nullptr && cause->code == code; };
    const bool is_own = cause != nullptr && cause->sender == *a.controller;
    if (is_own && is(jaus::command_code_of<jaus::release_component_control>)) return;
    if (!is_own && is(jaus::command_code_of<jaus::request_component_control>)) return; // taken over
    world_.compares(comparison::control_kept);
    const time jumped = a.program->jumped_at();
    if (jumped > a.controller_heard || world_.now() - a.controller_heard >= a.control_timeout) return;
    constexpr time of_pulses = std::chrono::milliseconds{1500}, of_node = std::chrono::seconds{4};
    const auto& from = *senders_[*a.controller].program;
    if (a.controller_gone == world_.now() &&
        (world_.now() - network_.pulse_heard(from.port(), a.port) > of_pulses || world_.now() - jumped <= of_node))
        return; // its node is not heard
    breaks(contract::s5, a, a.current, "a controller that is heard keeps control",
           "it was lost " + in_ms(world_.now() - a.controller_heard) + " after the last message of the controller");
}

void model::reported(const actuator_account& a, const jaus::header& head, bytes body) {
    if (head.command_code == jaus::command_code_of<jaus::report_component_status>) {
        world_.compares(comparison::status_reported);
        jaus::report_component_status m{};
        if (wire::decode(m, body) && m.primary_status_code != a.state)
            breaks(contract::s4, a, 0, "the state that is: " + text(a.state),
                   "reported: " + text(m.primary_status_code));
    }
    if (head.command_code == jaus::command_code_of<jaus::report_wrench_effort>) check_efforts(a, body);
    if (head.command_code == jaus::command_code_of<jaus::report_joint_velocities>) check_velocities(a, body);
}

// When anything last happened to its slaves, its frames or its program that makes values old.
time model::last_disturbance(const actuator_account& a) {
    time last = a.program->jumped_at();
    if (a.wire == nullptr) return last;
    last = std::max(last, a.wire->frames_disturbed_at());
    for (const auto& axis : a.axes) {
        const auto& slave = (*a.wire)[axis.slave];
        last = std::max({last, slave.disturbed_at, slave.unfrozen_at, slave.missed_at});
    }
    return last;
}

// A robot reports what is. A slave's inputs are those of the frame before the last one, and an upload takes some
// frames; where something was lost, a value is as old as it may be.
void model::check_efforts(const actuator_account& a, bytes body) {
    wire::raw<jaus::report_wrench_effort> told{};
    if (!wire::decode(told, body)) return;
    constexpr time of_upload = std::chrono::milliseconds{25}, on_its_way = std::chrono::milliseconds{2};
    const bool is_quiet = world_.now() - last_disturbance(a) > a.at_rest_in;
    const time slow = a.wire == nullptr ? time{} : (*a.wire)[a.axes.front().slave].slow;
    const time usual = a.cycle != time{} ? 2 * a.cycle + on_its_way : of_upload + 2 * slow;
    const time age = a.wire == nullptr ? time{} : is_quiet ? usual : a.fresh_for;
    const auto command = command_in<jaus::report_wrench_effort>(body);
    world_.compares(told == wire::raw<jaus::report_wrench_effort>{} ? comparison::no_efforts_reported
                                                                    : comparison::efforts_reported);
    if (!were_in_force(a, world_.now() - age, [&](command_number each) { return are_of(told, each); }))
        breaks(contract::s4, a, 0,
               "the efforts in force, or of the last " + in_ms(age) + ": command " + std::to_string(a.command),
               command ? "reported: command " + std::to_string(*command) : "reported: some of another");
}

void model::check_velocities(const actuator_account& a, bytes body) {
    world_.compares(comparison::velocities_reported);
    jaus::basic_report_joint_velocities<most_joints> told{};
    if (!wire::decode(told, body) || told.joint_velocity.size() != a.axes.size())
        return breaks(contract::s7, a, 0, "the velocities of " + std::to_string(a.axes.size()) + " joints",
                      "those of " + std::to_string(told.joint_velocity.size()));
    for (std::size_t i = 0; i != a.axes.size(); ++i) {
        const auto& axis = a.axes[i];
        const double velocity = told.joint_velocity[i] * increments_per_radian;
        if (!(*a.wire)[axis.slave].drive->had_velocity(axis.axis, velocity, world_.now() - a.fresh_for))
            breaks(contract::s4, a, 0,
                   "a velocity that joint " + std::to_string(i + 1) + " had in the last " + in_ms(a.fresh_for),
                   "reported: " + std::to_string(std::lround(velocity)) + " increments/s");
    }
}

// ---------------------------------------------------------------------------------------------------- checks

void model::check() {
    if (world_.now() - checked_ < std::chrono::milliseconds{10}) return;
    checked_ = world_.now();
    for (auto& a : actuators_) {
        look(a);
        look_for_lost_holders(a);
        check_actuator(a);
    }
    check_senders();
}

void model::check_actuator(actuator_account& a) {
    if (a.wire != nullptr) {
        check_known(a);
        check_watchdog(a);
        check_kept(a);
        check_told(a);
        check_return(a);
        for (const auto& axis : a.axes)
            if (axis.command != 0) check_axis(a, axis);
        return;
    }
    if (!a.program->running()) return;
    if (a.command != 0 && a.state != primary_status_code::ready)
        breaks(contract::s2, a, 0, "at rest in every state but Ready",
               "efforts of command " + std::to_string(a.command) + " in " + text(a.state));
    if (a.command == 0 || !a.controller) return;
    const auto since = unreachable_since(*a.controller, a);
    if (!since) return;
    // What was on its way when the controller was lost still arrives; a program that was away itself has just begun.
    world_.compares(comparison::rest_when_lost);
    const time begin = std::max(*since + network::longest_delay, a.program->jumped_at());
    if (world_.now() - begin > a.controller_limit + slack)
        breaks(contract::s3, a, 0, "at rest " + in_ms(a.controller_limit) + " after the controller is lost",
               "efforts of command " + std::to_string(a.command) + ", " + in_ms(world_.now() - *since) + " after " +
                   world_.names()[senders_[*a.controller].program->number()] + " was lost");
}

void model::check_stop(const actuator_account& a, const axis_account& axis, const char* why, time since, time limit) {
    world_.compares(comparison::rest_when_lost);
    if (world_.now() - since > limit)
        breaks(contract::s3, a, 0, "at rest " + in_ms(limit) + " after " + why,
               "efforts of command " + std::to_string(axis.command) + ", " + in_ms(world_.now() - since) + " later");
}

// A slave that cannot be commanded, or whose state nobody knows, does not run: its component is not Ready.
void model::check_known(const actuator_account& a) {
    if (!a.program->running() || a.state != primary_status_code::ready) return;
    for (const auto& axis : a.axes) {
        world_.compares(comparison::known_to_run);
        const auto& slave = (*a.wire)[axis.slave];
        auto trouble = a.wire->trouble_of(axis.slave);
        if (slave.unknown_since && (!trouble || *slave.unknown_since < trouble->since))
            trouble = {"nobody knows the slave's state", *slave.unknown_since};
        if (!trouble) continue;
        const time since = std::max({trouble->since, a.program->jumped_at(), slave.unfrozen_at});
        if (world_.now() - since > a.noticed_in)
            breaks(contract::s8, a, 0,
                   "a component is not Ready " + in_ms(a.noticed_in) + " after its slave is not known to run",
                   std::string{"Ready, "} + in_ms(world_.now() - since) + " after this: " + trouble->what);
    }
}

time model::quiet_for(std::uint8_t which) const {
    const auto& a = actuators_[which];
    if (a.wire == nullptr || !a.program->running()) return {};
    time last = last_disturbance(a);
    for (std::size_t i = 0; i != a.wire->size(); ++i) {
        const auto& each = (*a.wire)[i];
        const bool is_hurt = each.frozen || each.away || each.state_is_unknown || each.has_drive_fault ||
                             each.reports_error || each.keeps_watchdog || each.unreachable_since || each.taken_since ||
                             each.left_state_since || each.slow != time{} || a.wire->is_elsewhere(i) ||
                             (each.arm != nullptr && each.arm->is_aborting()) ||
                             (each.drive != nullptr && each.drive->has_fault());
        if (is_hurt) return {};
        last = std::max({last, each.left_at, each.shared_at, each.disturbed_at, each.unfrozen_at, each.missed_at});
    }
    return world_.now() - last;
}

// Slaves and components that nothing has happened to for some time stay in use.
void model::check_cause(const actuator_account& a, const char* of) {
    constexpr time some = std::chrono::seconds{1};
    if (a.wire == nullptr) return;
    world_.compares(comparison::kept_in_use);
    time last = a.program->running() ? last_disturbance(a) : world_.now();
    // The process data are exchanged anew without a slave that leaves OP or has lost its station address, a cycle later
    // for all others.
    for (std::size_t i = 0; i != a.wire->size(); ++i) {
        const auto& other = (*a.wire)[i];
        last = std::max({last, other.left_at, other.taken_since.value_or(time{})});
    }
    const bool is_hurt = any_slave(a, [&](const ring_place& each) {
        last = std::max({last, each.shared_at, each.held_up_at});
        return each.frozen || each.away || each.state_is_unknown || each.has_drive_fault || each.reports_error ||
               each.keeps_watchdog || each.unreachable_since || each.taken_since || each.left_state_since ||
               (each.drive != nullptr && each.drive->has_fault());
    });
    const bool is_elsewhere =
        std::ranges::any_of(a.axes, [&](const axis_account& each) { return a.wire->is_elsewhere(each.slave); });
    if (is_hurt || is_elsewhere || world_.now() - last <= some) return;
    breaks(contract::availability, a, a.current, of,
           "it does not, and nothing has happened to it for " + in_ms(world_.now() - last));
}

// That of a component that has failed is reset when the next attempt at it begins; so it is in an emergency that began
// after the failure.
void model::check_kept(actuator_account& a) {
    const bool is_in_use = a.state == primary_status_code::ready || a.state == primary_status_code::standby;
    for (auto& axis : a.axes) {
        const auto& slave = (*a.wire)[axis.slave];
        if (std::exchange(axis.left_seen, slave.left_at) != slave.left_at && is_in_use && slave.left_at > a.entered_at)
            check_cause(a, "a slave stays in its state");
    }
}

// A slave in OP at its own address was taken there by the bridge, which has set its watchdog. Another address may have
// reached it while another slave was brought up.
void model::check_watchdog(const actuator_account& a) {
    for (const auto& axis : a.axes) {
        const auto& slave = (*a.wire)[axis.slave];
        if (!slave.cyclic || slave.told_state != ethercat::al_state::op || slave.taken_since) continue;
        world_.compares(comparison::watchdog);
        if (slave.watchdog == time{} || slave.watchdog > a.at_rest_in)
            breaks(contract::s3, a, 0, "a watchdog of at most " + in_ms(a.at_rest_in) + " in OP",
                   slave.watchdog == time{} ? "none" : "one of " + in_ms(slave.watchdog));
    }
}

// Slaves that are there and left alone are brought up and to rest: nobody waits for them for ever. The fault of a drive
// ends with a Reset.
void model::check_return(const actuator_account& a) {
    const bool waits = a.state == primary_status_code::failure || a.state == primary_status_code::initialize;
    if (!waits || !a.program->running()) return;
    time since = std::max({a.program->jumped_at(), a.not_ready_since, a.failed_since});
    bool is_away = false, has_drives = false;
    for (const auto& axis : a.axes) {
        const auto& slave = (*a.wire)[axis.slave];
        since = std::max({since, slave.disturbed_at, slave.unfrozen_at});
        is_away = is_away || slave.frozen || slave.state_is_unknown || slave.unreachable_since ||
                  a.wire->is_elsewhere(axis.slave) || slave.has_drive_fault || slave.keeps_watchdog ||
                  slave.reports_error;
        has_drives = has_drives || slave.drive != nullptr;
    }
    if (is_away || (has_drives && a.reset_at < since)) return;
    since = std::max(since, a.reset_at);
    constexpr auto long_enough = std::chrono::seconds{10};
    world_.compares(comparison::brought_up);
    if (world_.now() - since > long_enough)
        breaks(contract::s6, a, 0, "a slave that is there is brought up and to rest",
               text(a.state) + " for " + in_ms(world_.now() - since) + " in which nothing has happened to it");
}

// A program that was away does not know yet what has happened to its slaves, and works off what it has received.
time model::sent_unaware_since(const actuator_account& a) {
    const auto& last = a.efforts[(a.effort_count - 1) % a.efforts.size()];
    return a.effort_count != 0 && last.first >= a.program->jumped_at() ? a.program->jumped_at() : time{};
}

// Whatever is lost, an axis that moves must come to rest: told by the bridge or by itself.
void model::check_axis(const actuator_account& a, const axis_account& axis) {
    const auto& slave = (*a.wire)[axis.slave];
    if (slave.frozen) return; // nothing that is outside of it can stop it
    constexpr auto frames_lost = std::chrono::milliseconds{60}, between_checks = std::chrono::milliseconds{10};
    constexpr auto until_sent_again = std::chrono::milliseconds{30}; // each frame that is lost
    if (const auto silent = a.program->silent_since())
        check_stop(a, axis, "its program does nothing any more", std::max(*silent, slave.unfrozen_at),
                   a.at_rest_in + between_checks);
    // Outputs stop when the loss of the address is noticed, the slave when it misses them.
    if (const auto trouble = a.wire->trouble_of(axis.slave))
        check_stop(a, axis, trouble->what, std::max({trouble->since, slave.unfrozen_at, sent_unaware_since(a)}),
                   a.at_rest_in + a.two_cycles + between_checks);
    // What the bridge must tell it: as long as nothing comes in between.
    const time undisturbed = std::max({slave.disturbed_at, a.program->jumped_at(), slave.unfrozen_at});
    if (!a.program->running()) return;
    if (a.state != primary_status_code::ready) {
        const time since = std::max(a.not_ready_since, undisturbed);
        check_stop(a, axis, "its component has left Ready", since,
                   a.at_rest_in + frames_lost + a.wire->frames_disturbed_since(since) * until_sent_again);
    }
    if (const auto since = a.controller ? unreachable_since(*a.controller, a) : a.orphaned_since)
        check_stop(a, axis, "its controller is lost", std::max(*since + network::longest_delay, undisturbed),
                   a.controller_limit + frames_lost);
}

// A slave by mailbox gets each stop order that its component owes it, whatever it refuses in between.
void model::check_told(actuator_account& a) {
    const auto* const arm = arm_of(a);
    if (arm == nullptr) return;
    const auto& slave = (*a.wire)[a.axes.front().slave];
    if (slave.frozen || slave.state_is_unknown || arm->is_aborting() || a.wire->trouble_of(a.axes.front().slave) ||
        !a.program->running())
        a.troubled_at = world_.now();
    const bool owes = a.state == primary_status_code::emergency || a.state == primary_status_code::standby ||
                      a.state == primary_status_code::shutdown;
    if (!owes || a.troubled_at == world_.now()) return;
    // A slave that has come back is brought up first; one that refuses is told again after a pause that grows.
    constexpr time bring_up = std::chrono::seconds{3};
    const bool is_back = world_.now() - a.troubled_at <= 2 * bring_up;
    const time since = std::max({a.entered_at, last_disturbance(a), a.troubled_at});
    if (world_.now() - since <= (is_back ? bring_up : a.at_rest_in + std::chrono::milliseconds{60})) return;
    const auto in = in_ms(world_.now() - since);
    if (a.state == primary_status_code::emergency && !arm->denies_objects()) {
        world_.compares(comparison::told_of_emergency);
        if (!arm->in_emergency() && slave.restarted_at < a.entered_at)
            return breaks(contract::s2, a, 0, "a slave is told of an emergency", "it is not, after " + in);
    }
    if (slave.cyclic) return;
    world_.compares(comparison::told_to_rest);
    if (arm->told_to_rest_at() < a.not_ready_since)
        breaks(contract::s2, a, 0, "a slave is told to rest when its component is in " + text(a.state),
               "it is not, after " + in);
}

// After a failure, or at the start, a component is Ready when its actuator is known to be at rest.
void model::check_ready(const actuator_account& a, time since) {
    if (a.wire == nullptr) return;
    world_.compares(comparison::ready_after_rest);
    const auto* const arm = arm_of(a);
    if (arm != nullptr && !(*a.wire)[a.axes.front().slave].cyclic && !arm->rests_by_order(since))
        breaks(contract::s2, a, 0, "Ready when the slave has confirmed that it is at rest",
               "Ready, and the slave was not told to rest");
    constexpr double standstill = 200; // increments/s
    for (const auto& axis : a.axes) {
        const auto& slave = (*a.wire)[axis.slave];
        if (slave.drive != nullptr && std::abs(slave.drive->axis(axis.axis).velocity()) > standstill)
            breaks(contract::s2, a, 0, "Ready when the drives are at rest", "Ready, and a drive turns");
    }
}

bool model::is_undisturbed(const sender_account& account, const sent_large& one) const {
    constexpr time before = std::chrono::seconds{1};
    const auto to = std::ranges::find(actuators_, one.destination, &actuator_account::id);
    if (to == actuators_.end() || !to->program->running() || !account.program->running() || account.mute_since)
        return false;
    const time quiet = std::max({account.program->jumped_at(), to->program->jumped_at(),
                                 network_.disturbed_at(account.program->port(), to->port)});
    return quiet + before <= one.at;
}

// A set of which no packet was lost or late arrives. One without acknowledgements may be given up for the next one.
void model::check_large(const sender_account& account) {
    for (const auto& one : account.large) {
        constexpr time long_enough = std::chrono::seconds{4};
        const time age = world_.now() - one.at;
        if (!one.wants_acknowledgement || one.life != account.program->life() || age < long_enough ||
            age > long_enough + std::chrono::seconds{1})
            continue;
        if (!is_undisturbed(account, one)) continue;
        world_.compares(comparison::large_data_arrives);
        if (one.delivered == 0 && !one.closed)
            breaks(contract::s1, account, 0, "a large data set of which nothing was lost arrives",
                   "number " + std::to_string(one.identity) + " has not, " + in_ms(age) + " later");
    }
}

void model::check_senders() {
    for (auto& account : senders_) {
        if (!account.program->running()) continue;
        check_large(account);
        std::erase_if(account.open, [&](const auto& one) {
            const auto* sent = find(one.first);
            return sent == nullptr || sent->closed || sent->life != account.program->life();
        });
        for (const auto& [number, until] : account.open) {
            world_.compares(comparison::outcome_learnt);
            if (account.program->run_time() > until)
                return breaks(contract::s6, account, number, "an outcome, or that there is none, in bounded time",
                              "its sender still waits");
        }
    }
}

// ---------------------------------------------------------------------------------------------------- small things

std::optional<std::uint8_t> model::account_of(const jaus::address& id) const noexcept {
    for (std::size_t i = 0; i != senders_.size(); ++i)
        if (senders_[i].id == id) return static_cast<std::uint8_t>(i);
    return std::nullopt;
}

std::optional<time> model::unreachable_since(std::uint8_t sender, const actuator_account& to) const {
    const auto& from = *senders_[sender].program;
    std::optional<time> first = from.silent_since();
    for (const auto& other : {network_.cut_since(from.port(), to.port), senders_[sender].mute_since})
        if (other && (!first || *other < *first)) first = other;
    return first;
}

// The actuator's node gives up whom it has not heard for three seconds of its clock, which may have leapt since;
// heartbeats come once a second.
void model::look_for_lost_holders(actuator_account& a) {
    for (auto& holder : a.holders) {
        const auto who = account_of(holder.id);
        const auto from = who ? senders_[*who].program->port() : std::uint8_t{};
        const auto heard = who ? network_.pulse_heard(from, a.port) : time{};
        // A component that says nothing for 3 s is lost although its node is heard.
        const auto spoke = who ? network_.component_heard(from, a.port) : time{};
        if (world_.now() - heard > std::chrono::milliseconds{1500} ||
            world_.now() - spoke > std::chrono::milliseconds{2500} ||
            a.program->jumped_at() > std::min(heard, holder.since))
            holder.may_be_lost = true;
    }
}

void model::breaks(contract point, const actuator_account& a, std::uint32_t message, std::string expected,
                   std::string found) {
    const auto* sent = find(message);
    const auto other = sent != nullptr ? std::optional{sent->sender} : a.controller;
    world_.breaks({.point = point,
                   .who = a.number,
                   .whom = other ? senders_[*other].program->number() : std::uint8_t{},
                   .message = message,
                   .expected = std::move(expected),
                   .found = std::move(found)});
}
void model::breaks(contract point, const sender_account& s, std::uint32_t message, std::string expected,
                   std::string found) {
    world_.breaks({.point = point,
                   .who = s.program->number(),
                   .message = message,
                   .expected = std::move(expected),
                   .found = std::move(found)});
}

} // namespace simulation
