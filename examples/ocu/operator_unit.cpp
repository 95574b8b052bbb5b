#include "operator_unit.hpp"

#include "support/component_of.hpp"
#include "support/known_messages.hpp"
#include "support/message_event.hpp"
#include "support/program.hpp"
#include "support/say.hpp"
#include <jauscat/net/node/run_until.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <algorithm>
#include <utility>

namespace ocu {

namespace {

namespace events = example::events;
namespace text = jauscat::text;
namespace wire = jauscat::wire;

// The header in one line of hex, for its values are in the summary, and a line for each field of the body.
void show(example::event_kind kind_of_event, const char* verb, std::span<const std::byte> message) {
    const auto parts = jaus::split(message);
    auto lines = example::bold(std::string{"ocu "} + verb + " " + example::summary(parts.header)) + "\n";
    if (!jaus::is_acknowledgement(parts.header)) {
        lines += text::hex_dump(message.first(jaus::header_size));
        lines += example::body_lines(parts.header.command_code, parts.body, jaus::header_size);
    }
    example::write_limited(
        verb, kind_of_event,
        example::message_members(parts.header, parts.body, example::message_name(parts.header.command_code)), lines);
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
    if (is_bad) example::tell_fault(true, line);
}

operator_unit::operator_unit(const net::jaus_config& config, const jaus::address& robot,
                             const jauscat::retry_policy& retry, bool acknowledged,
                             std::optional<jaus::subsystem_type> type, net::live_feed* feed)
    : self_{example::component_of(config.me())},
      robot_{robot},
      retry_{retry},
      acknowledged_{acknowledged},
      node_{context_, example::watched(node_options(config, type), feed)},
      unit_{node_,
            {.id = self_.component, .instance = self_.instance, .name = "operator control unit", .retry = retry}},
      config_{config},
      reporter_{context_, feed, [this] { return live_state(); }} {
    // Reports of the robot are for the operator; commands are for robots.
    unit_.on_others([](const jaus::header& head, bytes) {
        return head.command_code >= 0x4000 ? jaus::message_outcome::handled : jaus::message_outcome::unhandled;
    });
    node_.when_appeared([this](const jaus::address& who) { robot_is_there(who, true); });
    node_.when_disappeared([this](const jaus::address& who) { robot_is_there(who, false); });
    unit_.ready();
    node_.start();
}

net::live_state operator_unit::live_state() const {
    const auto components = node_.components();
    return {.systems = example::live_systems(config_, components), .components = example::live_components(components)};
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
    asks_control_ = true;
    will_send(jaus::command_code_of<jaus::request_component_control>);
    unit_.async_control(robot_, {.authority = authority, .retry = retry_, .renewal = std::chrono::seconds{5}},
                        [this](error_code error, jauscat::control made) { on_control(error, std::move(made)); });
    wait([this] { return !asks_control_; });
    if (is_refused_) tell_why();
    return holds();
}

void operator_unit::on_control(error_code error, jauscat::control made) {
    asks_control_ = false;
    has_control_ = !error;
    control_ = std::move(made);
    const auto name = text::to_text(robot_);
    const example::event_members robot{{"address", name}};
    if (has_control_)
        say(events::control_gained, robot, "controls " + name);
    else if (error == jauscat::node_errc::control_refused)
        say(events::control_refused, robot, "FAILED: control of " + name + " is refused: another has it");
    else
        tell_unanswered();
    is_refused_ = error == jauscat::node_errc::control_refused;
}

reply operator_unit::give(const order& what, bool may_be_obeyed_silently) {
    const auto answer = exchange(what);
    const auto name = example::message_name(what.command_code);
    const example::event_members code{{"code", what.command_code}, {"address", text::to_text(robot_)}};
    if (answer == reply::silence && may_be_obeyed_silently)
        say(events::not_acknowledged, code,
            text::to_text(robot_) + (has_spoken_ ? " answers, but does not acknowledge " : " does not acknowledge ") +
                name + ": the report shows whether it is obeyed");
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
    const auto never = [] { return false; };
    work([this] { return !asks_control_; }, never); // what is confirmed after Ctrl-C is released, too
    bool released = true;
    if (holds()) {
        const auto name = text::to_text(robot_);
        has_control_ = false;
        will_send(jaus::command_code_of<jaus::release_component_control>);
        if (acknowledged_) {
            control_.async_release([this](error_code error) { release_outcome_ = error; });
            work([this] { return release_outcome_.has_value(); }, never);
            tell_copies();
        } else
            node_.stop(); // releases once, without acknowledgement
        const bool is_acknowledged = release_outcome_ == error_code{};
        released = release_outcome_ != make_error_code(jauscat::node_errc::no_answer);
        if (!released)
            say(events::release_unanswered, {{"address", name}},
                "FAILED: nobody acknowledged that control of " + name + " is released");
        else
            say(events::control_released, {{"address", name}, {"acknowledged", is_acknowledged}},
                "control of " + name +
                    (is_acknowledged ? " is released"
                     : acknowledged_ ? " is another's already"
                                     : " is released, as far as is known"));
    }
    if (heartbeats_ != 0)
        say(events::heartbeats_counted, {{"count", heartbeats_}, {"address", text::to_text(heard_)}},
            "heard " + std::to_string(heartbeats_) + (heartbeats_ == 1 ? " heartbeat" : " heartbeats") + " of " +
                text::to_text(heard_));
    node_.stop();
    return released;
}

jauscat::node_options operator_unit::node_options(const net::jaus_config& config,
                                                  std::optional<jaus::subsystem_type> type) {
    jauscat::node_options options{
        .config = config.source, .this_system = config.this_system, .node = self_.node, .type = type};
    options.log = [this](std::string_view line) {
        const auto times = log_lines_.shown(line); // the node limits them
        if (!times) return;
        say(events::node_log, {{"line", line}, {"times", *times}}, log_lines_.text(line, *times));
        example::tell_fault(false, log_lines_.text(line, *times));
    };
    options.explain_malformed = example::known_messages().explainer();
    options.on_received = [this](const auto& component, const auto& head, bytes body) { seen(component, head, body); };
    options.on_sent = [this](bytes message) { sent(message); };
    return options;
}

void operator_unit::robot_is_there(const jaus::address& who, bool is_there) {
    if (!is_of_robot(who)) return;
    std::erase(present_, who);
    if (is_there) present_.push_back(who);
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
    has_spoken_ = has_spoken_ || head.source == robot_;
    jaus::confirm_component_control answer{};
    const bool is_answer = head.command_code == jaus::command_code_of<jaus::confirm_component_control>;
    const bool confirms = is_answer && wire::decode(answer, body) &&
                          answer.response_code == jaus::component_control_response::control_accepted;
    const bool rejects = head.command_code == jaus::command_code_of<jaus::reject_component_control>;
    if (holds() && head.source == robot_ && (rejects || (is_answer && !confirms))) is_taken_away_ = true;
    const bool is_second_answer =
        head.ack_nak == jaus::ack_nak::ack && jaus::report_code_of(head.command_code) != 0; // the report is the first
    std::vector<std::byte> message(jaus::header_size + body.size());
    if (!quiet_ && !is_second_answer && !(confirms && holds()) && jaus::join(head, body, message))
        show(events::message_received, "receives", message);
}

/// The first copy of each message that the operator has asked for.
void operator_unit::sent(bytes message) {
    const auto head = jaus::split(message).header;
    if (head.source != self_ || head.destination != robot_ || head.command_code != sent_code_) return;
    if (++copies_ == 1 && !quiet_) show(events::message_sent, "sends", message);
}
void operator_unit::will_send(std::uint16_t command_code) {
    sent_code_ = command_code;
    copies_ = 0;
}
void operator_unit::tell_copies() const {
    if (copies_ > 1)
        say(events::copies_sent, {{"code", sent_code_}, {"copies", copies_}},
            example::message_name(sent_code_) + " was sent " + std::to_string(copies_) + " times");
}

/// Lets the node work until `done()` or `given_up()`. Returns `done()`.
bool operator_unit::work(const std::function<bool()>& done, const std::function<bool()>& given_up) {
    const auto look = [&] {
        tell_loss();
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
    report_.clear();
    will_send(what.command_code);
    const auto not_sent = [&](std::string_view why) {
        say(events::not_sent, {{"code", what.command_code}}, "FAILED: " + std::string{why});
        return reply::not_sent;
    };
    const auto done = [this](error_code error, std::vector<std::byte> report = {}) {
        outcome_ = error;
        report_ = std::move(report);
    };
    if (jaus::report_code_of(what.command_code) != 0) {
        // There are components that report after the acknowledgement.
        const auto patience = acknowledged_ ? 2 * retry_.total() + retry_.interval : retry_.total();
        unit_.async_ask(robot_, what.command_code, what.body, {.timeout = patience, .acknowledged = acknowledged_},
                        done);
    } else if (acknowledged_) {
        unit_.async_send(robot_, what.command_code, what.body, done);
    } else {
        const auto sent = unit_.send(robot_, what.command_code, what.body);
        return sent ? reply::sent : not_sent(sent.error().message);
    }
    wait([this] { return outcome_.has_value(); });
    tell_copies();
    if (!outcome_) return reply::stopped;
    if (!*outcome_) return reply::taken;
    if (*outcome_ == jauscat::node_errc::refused) return reply::refused;
    return *outcome_ == jauscat::node_errc::no_answer ? reply::silence : not_sent(outcome_->message());
}

/// Foreign nodes may have their heartbeats sent by another component than the node manager, and by one node for all.
bool operator_unit::is_of_robot(const jaus::address& who) const noexcept {
    return who.subsystem == robot_.subsystem && (who.node == robot_.node || robot_.subsystem != self_.subsystem);
}
std::string operator_unit::part_of_robot() const {
    const auto subsystem = "subsystem " + std::to_string(robot_.subsystem);
    return robot_.subsystem != self_.subsystem ? subsystem : "node " + std::to_string(robot_.node) + " of " + subsystem;
}
/// None of its components is heard any more.
bool operator_unit::is_robot_gone() const { return heartbeats_ != 0 && present_.empty(); }

/// Hints if there is no answer.
std::string operator_unit::hint() const {
    if (has_spoken_)
        return text::to_text(robot_) + " has answered other messages; --unacknowledged requests no acknowledgement";
    if (heartbeats_ == 0) return "is robot_controller running?";
    const auto who = text::to_text(heard_);
    return heard_ == robot_ ? who + " is heard, but does not answer"
                            : "its node " + who + " is there, so look at the JAUS ID";
}

void operator_unit::tell_unanswered() const {
    const auto name = text::to_text(robot_);
    say(events::control_unanswered, {{"address", name}, {"heard", heartbeats_ != 0}},
        "FAILED: " + name + " does not answer requests for control; " + hint());
}
void operator_unit::tell_loss() {
    if (!has_control_ || holds()) return;
    has_control_ = false;
    has_lost_control_ = true;
    const auto name = text::to_text(robot_);
    const bool is_gone = is_robot_gone();
    if (!is_gone && !is_taken_away_) return tell_unanswered();
    say(events::control_lost, {{"address", name}, {"robot_gone", is_gone}},
        "LOST control of " + name + (is_gone ? ": the robot is gone" : ": it was taken away"));
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
