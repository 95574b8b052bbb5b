#include "simulation/robot.hpp"

#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>

namespace simulation {

actuator::actuator(const jaus::address& self, node_program& program, model& m, std::uint8_t account,
                   time controller_timeout)
    : program_{program},
      model_{m},
      account_{account},
      connections_{self, reports, filler_, report_},
      core{self,
           memory_,
           {.on_state = jaus::bound<&actuator::on_state>(*this),
            .on_controller = jaus::bound<&actuator::on_controller>(*this)},
           {.control = {.harmless = harmless, .timeout = controller_timeout}},
           connections_} {}

jaus::message_outcome actuator::operator()(const jaus::header& head, bytes body) {
    using jaus::message_outcome;
    switch (head.command_code) {
    case jaus::command_code_of<jaus::set_wrench_effort>: {
        const auto command = command_in<jaus::set_wrench_effort>(body);
        if (!command) return message_outcome::malformed;
        command_ = *command;
        model_.executes(account_, command_);
        return message_outcome::handled;
    }
    case jaus::command_code_of<jaus::query_wrench_effort>: {
        jaus::query_wrench_effort query{};
        if (!wire::decode(query, body)) return message_outcome::malformed;
        report_efforts(head, query.presence_vector);
        return message_outcome::handled;
    }
    case large_code: model_.delivers_large(program_, head, body); return message_outcome::handled;
    default: return message_outcome::unhandled;
    }
}

void actuator::on_state(jaus::primary_status_code from, jaus::primary_status_code to) {
    model_.enters(account_, from, to);
    if (judge != nullptr) judge->enters(from, to);
    if (to != jaus::primary_status_code::ready) rest();
}

void actuator::on_controller(const std::optional<jaus::controller>& now, jaus::control_change why) {
    if (judge != nullptr) judge->controlled(now, why);
    model_.controlled(account_, now ? std::optional{now->address} : std::nullopt);
    rest();
}

void actuator::rest() {
    command_ = 0;
    model_.rests(account_);
}

void actuator::report_efforts(const jaus::header& query, std::uint16_t presence_vector) {
    auto report = efforts_of<jaus::report_wrench_effort>(command_);
    jaus::keep_requested(report, presence_vector);
    static_cast<void>(jaus::put({.destination = query.source, .source = core.self()}, report, [this](bytes message) {
        model_.answers(account_, message);
        program_.node().put(message, program_.now());
    }));
}

std::optional<std::size_t> actuator::filler::operator()(std::uint16_t, std::uint32_t, std::span<std::byte> body) const {
    const auto encoded = wire::encode(efforts_of<jaus::report_wrench_effort>(mine.command_), body);
    return encoded ? std::optional<std::size_t>{encoded->size()} : std::nullopt;
}

// What its application makes of a message.
std::optional<jaus::component_outcome> robot::outcome_of(const jaus::header& head, bytes body) {
    using enum jaus::component_outcome;
    jaus::query_wrench_effort query{};
    switch (head.command_code) {
    case jaus::command_code_of<jaus::set_wrench_effort>:
        return command_in<jaus::set_wrench_effort>(body) ? handled : malformed;
    case jaus::command_code_of<jaus::query_wrench_effort>: return wire::decode(query, body) ? handled : malformed;
    case large_code: return handled;
    default: return std::nullopt;
    }
}

robot::robot(world& w, network& n, model& m, const std::vector<place>& places, std::size_t which)
    : node_program{w, n, m, places, which} {
    const std::uint8_t count = 1 + static_cast<std::uint8_t>(w.stream(1002 + which).below(2));
    for (std::uint8_t i = 1; i <= count; ++i) {
        auto& made = *seats_.emplace_back(std::make_unique<seat>());
        made.id = {.instance = i, .component = 33, .node = 1, .subsystem = places[which].jausip.subsystem};
        made.account =
            m.add_actuator(*this, made.id, i == 1 ? number() : w.add(places[which].name + ", instance 2"), timeout);
        made.judge.emplace(w, *this,
                           judged_component{.id = made.id,
                                            .number = m.actuator(made.account).number,
                                            .timeout = timeout,
                                            .harmless = actuator::harmless,
                                            .remembered = 256,
                                            .application = outcome_of});
    }
}

void robot::seat::initialize() {
    judge->initializes();
    unit->core.change(jaus::state_event::initialized);
    judge->has_changed();
}

void robot::check() {
    for (auto& each : seats_) each->judge->check();
}

void robot::add_components(net::node_machine& node) {
    static const auto nothing = [](const jaus::header&, bytes) { return jaus::message_outcome::unhandled; };
    for (auto& each : seats_) {
        auto& one = *each;
        model_.starts(one.account);
        one.stuck_since = world_.now();
        one.judge->starts();
        one.unit.emplace(one.id, *this, model_, one.account, timeout);
        one.watched.emplace(one.unit->core, *one.unit);
        one.watched->seen_in = [this, &one](const jaus::header& head, bytes) {
            model_.arrives(one.account, current_message(), head);
        };
        one.watched->seen_out = [this, &one](bytes message) { model_.answers(one.account, message); };
        one.watched->seen_lost = [this, &one](const jaus::address& who) { model_.hears_lost(one.account, who); };
        one.watched->seen_done = [this, &one](jaus::component_outcome what) { model_.handled(one.account, what); };
        one.watched->judge = &one.judge.value();
        one.unit->judge = &one.judge.value();
        node.add(*one.watched, nothing);
        one.initialize();
    }
}

void robot::remove_components() {
    for (auto& each : seats_) {
        each->watched.reset();
        each->unit.reset();
    }
}

void robot::act() {
    for (auto& each : seats_)
        if (running()) look_after(*each);
}

// Somebody looks after the machine.
void robot::look_after(seat& one) {
    using enum jaus::primary_status_code;
    const auto state = one.unit->core.state();
    if (state == initialize) one.initialize();
    if (state != emergency && state != jaus::primary_status_code::shutdown) one.stuck_since = world_.now();
    if (world_.now() - one.stuck_since < std::chrono::seconds{15}) return;
    if (state == jaus::primary_status_code::shutdown) return die(std::chrono::milliseconds{100});
    model_.person_clears(one.account);
    one.judge->ends_emergency();
    one.unit->core.end_emergency();
    one.judge->has_changed();
    one.stuck_since = world_.now();
}

} // namespace simulation
