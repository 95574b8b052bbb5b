#include "operator_unit.hpp"

#include "message_kinds/message_kinds.hpp"
#include "support/component_of.hpp"
#include "support/message_event.hpp"
#include "support/program.hpp"
#include "support/say.hpp"
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <utility>

namespace ocu {

namespace {

namespace events = example::events;
namespace text = jauscat::text;
namespace wire = jauscat::wire;

// The header in one line of hex, for its values are in the summary, and a line for each field of the body.
void show(example::event_kind kind_of_event, const char* verb, std::span<const std::byte> message) {
    const auto parts = jaus::split(message);
    auto lines = example::bold(std::string{"ocu "} + verb + " " + text::summary(parts.header)) + "\n";
    if (!jaus::is_acknowledgement(parts.header)) {
        const auto* const kind = find_kind(parts.header.command_code);
        lines += text::hex_dump(message.first(jaus::header_size));
        lines += kind != nullptr ? kind->to_text(parts.body, jaus::header_size)
                                 : text::hex_dump(parts.body, "  ", jaus::header_size);
    }
    example::write_limited(verb, kind_of_event, example::message_members(parts.header, parts.body), lines);
}

// A line caused by a peer, limited: a peer may send without end.
void tell(const std::string& cause, example::event_kind kind, const example::event_members& members,
          const std::string& line) {
    example::write_limited(cause, kind, members, "ocu: " + line + "\n");
}

jauscat::time_point now() { return net::now(); }

} // namespace

void say(example::event_kind kind, const example::event_members& members, const std::string& line) {
    const bool is_bad = line.starts_with("FAILED") || line.starts_with("LOST"), is_good = line.starts_with("OK");
    const auto shown = is_bad ? example::bad(line) : is_good ? example::good(line) : line;
    example::write_event(kind, members, "ocu: " + shown + "\n");
}

operator_unit::operator_unit(const net::jaus_config& config, const jaus::address& robot,
                             const jauscat::retry_policy& retry, bool acknowledged)
    : self_{example::component_of(config.me())},
      robot_{robot},
      manager_of_robot_{.instance = 1, .component = 1, .node = robot.node, .subsystem = robot.subsystem},
      retry_{retry},
      acknowledged_{acknowledged},
      held_{self_, robot, {.retry = retry, .renewal = std::chrono::seconds{5}}},
      described_{self_,
                 {.name = {.identification = "operator control unit", .type = 60001}},
                 jaus::heartbeat_to_node_manager(self_),
                 services_},
      core_{self_,
            memory_,
            {.on_delivered = jaus::bound<&operator_unit::on_delivered>(*this)},
            {.acknowledgement = {.retry = retry, .first_number = example::any_number()}},
            held_,
            described_},
      node_{context_, config, node_options()} {
    core_.change(jaus::state_event::initialized);
    node_.add(core_, application_);
    node_.start();
}

bool operator_unit::hear_robot(milliseconds patience) {
    if (wait([this] { return heartbeats_ != 0; }, patience)) return true;
    if (!example::stop_requested)
        say(events::no_heartbeat, {{"subsystem", robot_.subsystem}},
            "FAILED: no heartbeat of a component of " + part_of_robot() + " within " +
                text::to_text(std::chrono::duration<double>{patience}.count()) + " s; is robot_controller running?");
    return false;
}

bool operator_unit::take_control(std::uint8_t authority) {
    held_.ask(authority, now(), out_);
    wait([this] { return held_.state() != control_state::asking; });
    if (held_.state() == control_state::refused) tell_why();
    return holds();
}

bool operator_unit::has_lost_control() const noexcept {
    return held_.state() == control_state::lost || held_.state() == control_state::unanswered;
}

reply operator_unit::give(const order& what, bool may_be_obeyed_silently) {
    const auto answer = exchange(what);
    const auto name = text::message_name(what.command_code);
    const example::event_members code{{"code", what.command_code}, {"address", text::to_text(robot_)}};
    if (answer == reply::silence && may_be_obeyed_silently)
        say(events::not_acknowledged, code, name + " is not acknowledged; the report shows whether it is obeyed");
    else if (answer == reply::silence)
        say(events::no_answer, code + example::event_members{{"heard", heartbeats_ != 0}},
            "FAILED: no answer to " + name + "; " + hint());
    else if (answer == reply::refused) {
        say(events::message_refused, code,
            "FAILED: " + name + " was refused (NAK); robot_controller's output says why");
        tell_why();
    }
    return answer;
}

void operator_unit::hold(milliseconds how_long) {
    if (how_long.count() == 0) return;
    const bool held = holds();
    say(events::holding, {{"seconds", std::chrono::duration<double>{how_long}.count()}, {"control", held}},
        (held ? "keeps control for " : "listens for ") +
            text::to_text(std::chrono::duration<double>{how_long}.count()) + " s; Ctrl-C ends");
    wait([&] { return held && !holds(); }, how_long);
}

bool operator_unit::finish() {
    bool released = true;
    if (holds() || held_.state() == control_state::asking) {
        outcome_.reset();
        held_.release([&](bytes message) { released = send(message); });
        if (released && acknowledged_) work([this] { return outcome_.has_value(); }, [] { return false; });
        const auto name = text::to_text(robot_);
        released = released && outcome_ != jaus::delivered::timed_out;
        if (!released)
            say(events::release_unanswered, {{"address", name}},
                "FAILED: nobody acknowledged that control of " + name + " is released");
        else if (!acknowledged_)
            say(events::control_released, {{"address", name}, {"acknowledged", false}},
                "control of " + name + " is released, as far as is known");
        else
            say(events::control_released,
                {{"address", name}, {"acknowledged", outcome_ == jaus::delivered::acknowledged}},
                outcome_ == jaus::delivered::acknowledged ? "control of " + name + " is released"
                                                          : "control of " + name + " is another's already");
    }
    if (heartbeats_ != 0)
        say(events::heartbeats_counted, {{"count", heartbeats_}, {"address", text::to_text(heard_)}},
            "heard " + std::to_string(heartbeats_) + (heartbeats_ == 1 ? " heartbeat" : " heartbeats") + " of " +
                text::to_text(heard_));
    node_.stop();
    return released;
}

void operator_unit::on_delivered(const jaus::awaited_message& m, jaus::delivered what) {
    if (m.sent > 1)
        say(events::copies_sent, {{"code", m.header.command_code}, {"copies", m.sent}},
            text::message_name(m.header.command_code) + " was sent " + std::to_string(m.sent) + " times");
    if (m.header.sequence_number == number_) outcome_ = what;
}

// Reports of the robot are for the operator; commands are for robots.
jaus::message_outcome operator_unit::application_type::operator()(const jaus::header& head, bytes) const noexcept {
    return head.command_code >= 0x4000 ? jaus::message_outcome::handled : jaus::message_outcome::unhandled;
}

void operator_unit::shown_output::operator()(bytes message) const {
    if (!mine.quiet_) show(events::message_sent, "sends", message);
    mine.node_.out()(message);
}

net::jaus_node_options operator_unit::node_options() {
    net::jaus_node_options options{.node = self_.node};
    options.log = [this](std::string_view line) {
        if (const auto times = log_lines_.shown(line)) // the node limits them
            say(events::node_log, {{"line", line}, {"times", *times}}, log_lines_.text(line, *times));
    };
    options.explain_malformed = &why_malformed;
    options.on_message = [this](const jaus::address& component, const jaus::header& head, bytes body, auto) {
        seen(component, head, body);
    };
    options.appeared = [this](const jaus::address& who) { robot_is_there(who, true); };
    options.disappeared = [this](const jaus::address& who) { robot_is_there(who, false); };
    return options;
}

void operator_unit::robot_is_there(const jaus::address& who, bool is_there) {
    if (!is_of_robot(who)) return;
    tell("presence", is_there ? events::robot_heard : events::robot_silent, {{"address", text::to_text(who)}},
         (is_there ? "hears the robot: heartbeat of " : "the robot is silent: no heartbeat of ") + text::to_text(who));
}

void operator_unit::seen(const jaus::address& component, const jaus::header& head, bytes body) {
    if (head.command_code == jaus::command_code_of<jaus::report_heartbeat_pulse>) { // counted: they come all the time
        if (is_of_robot(head.source)) {
            ++heartbeats_;
            heard_ = head.source;
        }
        return;
    }
    if (component != self_) return;
    const bool renews = head.command_code == jaus::command_code_of<jaus::confirm_component_control> &&
                        told_state_ == control_state::held;
    const bool is_second_answer =
        head.ack_nak == jaus::ack_nak::ack && jaus::report_code_of(head.command_code) != 0; // the report is the first
    std::vector<std::byte> message(jaus::header_size + body.size());
    if (!quiet_ && !is_second_answer && !(renews && holds()) && jaus::join(head, body, message))
        show(events::message_received, "receives", message);
    if (head.command_code == awaited_report_ && head.source == robot_ && !jaus::is_acknowledgement(head))
        report_.emplace(body.begin(), body.end());
}

/// Lets the node work until `done()` or `given_up()`. Returns `done()`.
bool operator_unit::work(const std::function<bool()>& done, const std::function<bool()>& given_up) {
    const auto look = [&] {
        tell_control();
        return done();
    };
    bool is_done = look();
    while (!is_done && !given_up()) is_done = net::run_until(context_, milliseconds{10}, look);
    return done();
}
/// For states that end without a message: a request that is not answered is abandoned after its repeats.
void operator_unit::wait(const std::function<bool()>& done) {
    work(done, [] { return example::stop_requested.load(); });
}
bool operator_unit::wait(const std::function<bool()>& done, jauscat::duration how_long) {
    return work(done, [until = now() + how_long] { return example::stop_requested || now() >= until; });
}

reply operator_unit::exchange(const order& what) {
    outcome_.reset();
    report_.reset();
    awaited_report_ = jaus::report_code_of(what.command_code);
    std::vector<std::byte> message(jaus::header_size + what.body.size());
    const jaus::header head{.command_code = what.command_code, .destination = robot_, .source = self_};
    if (const auto made = jaus::join(head, what.body, message); !made) {
        say(events::not_sent, {{"code", what.command_code}}, "FAILED: " + std::string{describe(made.error())});
        return reply::not_sent;
    }
    const bool asks = awaited_report_ != 0;
    if (asks && !acknowledged_)
        wait_for_report(message);
    else if (!send(message))
        return reply::not_sent;
    if (!asks && !acknowledged_) return reply::sent;
    if (acknowledged_) wait([&] { return report_ || outcome_; });
    if (asks && outcome_ == jaus::delivered::acknowledged) // there are components that report later
        wait([&] { return report_.has_value(); }, retry_.total() + retry_.interval);
    if (outcome_ == jaus::delivered::refused) return reply::refused;
    if (asks ? report_.has_value() : outcome_ == jaus::delivered::acknowledged) return reply::taken;
    return example::stop_requested ? reply::stopped : reply::silence;
}

/// Foreign nodes may have their heartbeats sent by another component than the node manager, and by one node for all.
bool operator_unit::is_of_robot(const jaus::address& who) const noexcept {
    return who.subsystem == robot_.subsystem && (who.node == robot_.node || robot_.subsystem != self_.subsystem);
}
std::string operator_unit::part_of_robot() const {
    const auto subsystem = "subsystem " + std::to_string(robot_.subsystem);
    return robot_.subsystem != self_.subsystem ? subsystem : "node " + std::to_string(robot_.node) + " of " + subsystem;
}
bool operator_unit::is_robot_gone() const {
    bool is_heard = false;
    if (const auto* const present = node_.present(); present != nullptr)
        present->for_each([&](const jaus::address& who) { is_heard |= is_of_robot(who); });
    return heartbeats_ != 0 && !is_heard;
}

/// Queries again if no report arrives.
void operator_unit::wait_for_report(bytes message) {
    for (std::uint32_t made = 0; retry_.allows_another(made) && !report_ && !example::stop_requested; ++made) {
        out_(message);
        wait([this] { return report_.has_value(); }, retry_.interval);
    }
}

/// To be acknowledged: the component repeats it. Otherwise it is sent once.
bool operator_unit::send(bytes message) {
    if (!acknowledged_) {
        out_(message);
        return true;
    }
    const auto sent = core_.send(message, now(), [&](bytes numbered) {
        jaus::header head{};
        if (wire::decode_prefix(head, numbered)) number_ = head.sequence_number;
        out_(numbered);
    });
    if (!sent) say(events::not_sent, {}, "FAILED: " + std::string{describe(sent.error())});
    return static_cast<bool>(sent);
}

/// Hints if there is no answer.
std::string operator_unit::hint() const {
    if (heartbeats_ == 0) return "is robot_controller running?";
    const auto who = text::to_text(heard_);
    return heard_ == robot_ ? who + " is heard, but does not answer"
                            : "its node " + who + " is there, so look at the JAUS ID";
}

void operator_unit::tell_control() {
    if (std::exchange(told_state_, held_.state()) == held_.state()) return;
    const auto name = text::to_text(robot_);
    const example::event_members robot{{"address", name}};
    switch (told_state_) {
    case control_state::held: say(events::control_gained, robot, "controls " + name); break;
    case control_state::refused:
        say(events::control_refused, robot, "FAILED: control of " + name + " is refused: another has it");
        break;
    case control_state::unanswered:
        say(events::control_unanswered, robot + example::event_members{{"heard", heartbeats_ != 0}},
            "FAILED: " + name + " does not answer requests for control; " + hint());
        break;
    case control_state::lost:
        say(events::control_lost, robot + example::event_members{{"robot_gone", is_robot_gone()}},
            "LOST control of " + name + (is_robot_gone() ? ": the robot is gone" : ": it was taken away"));
        break;
    case control_state::none:
    case control_state::asking: break;
    }
}

/// The controller of the robot, and its state: mostly the reason of a refusal. Only the results are shown.
void operator_unit::tell_why() {
    quiet_ = true;
    const auto name = text::to_text(robot_);
    jaus::report_component_control control{};
    if (exchange({jaus::command_code_of<jaus::query_component_control>}) == reply::taken &&
        wire::decode(control, report())) {
        const jaus::address who{control.instance_id, control.component_id, control.node_id, control.subsystem_id};
        if (who == jaus::address{})
            say(events::robot_controlled_by, {{"address", name}}, "nobody controls " + name);
        else
            say(events::robot_controlled_by,
                {{"address", name}, {"controller", text::to_text(who)}, {"authority", control.authority_code}},
                name + " is controlled by " + text::to_text(who) + ", authority " +
                    std::to_string(control.authority_code));
    }
    jaus::report_component_status status{};
    if (exchange({jaus::command_code_of<jaus::query_component_status>}) == reply::taken &&
        wire::decode(status, report()))
        say(events::robot_state, {{"address", name}, {"state", text::to_text(status.primary_status_code)}},
            name + " is in the state " + text::to_text(status.primary_status_code));
    quiet_ = false;
}

} // namespace ocu
