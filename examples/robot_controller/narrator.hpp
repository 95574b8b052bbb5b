// The log of the robot controller: what its node, its bus and its bridge report.
#pragma once
#include "robot_controller/sdo_text.hpp"
#include "support/explain.hpp"
#include "support/message_event.hpp"
#include "support/repeated_lines.hpp"
#include "support/robot_messages.hpp"
#include "support/say.hpp"
#include <jauscat/app/bus_options.hpp>
#include <jauscat/app/node_options.hpp>
#include <jauscat/bridge/component.hpp>
#include <jauscat/ethercat/cia402/error_text.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/packet_status_text.hpp>
#include <jauscat/text/value.hpp>

#include <array>
#include <string>
#include <utility>

namespace example {

namespace bridging = jauscat::bridging;

class narrator {
  public:
    /// `trace_name` stands in front of the lines about SDOs.
    explicit narrator(speaker say, std::string trace_name) : say_{std::move(say)}, trace_name_{std::move(trace_name)} {}
    narrator(const narrator&) = delete;
    narrator& operator=(const narrator&) = delete;

    /// Has the node log here.
    [[nodiscard]] jauscat::node_options of_node(jauscat::node_options options) {
        options.log = [this](std::string_view line) {
            if (const auto times = log_lines_.shown(line))
                say_.warn(events::node_log, {{"line", line}, {"times", *times}}, log_lines_.text(line, *times));
        };
        options.explain_malformed = [](std::uint16_t command_code, std::span<const std::byte> body) {
            return jauscat::text::why_malformed(command_code, body, robot_messages{});
        };
        options.on_received = [this](const auto& component, const auto& head, auto body) {
            if (is_shown(component, head)) received(head, body);
        };
        options.on_handled = [this](const auto& component, const auto& head, auto,
                                    jauscat::jaus::component_outcome what) {
            if (what == jauscat::jaus::component_outcome::repeated && is_shown(component, head))
                say_(events::message_repeated, message_members(head), std::string{describe(what)});
        };
        options.on_sent = [this](std::span<const std::byte> message) {
            const auto head = jauscat::jaus::split(message).header;
            if (is_shown(head.source, head))
                say_(events::message_sent, message_members(head), "sent " + jauscat::text::summary(head));
        };
        return options;
    }
    /// Has the bus log here.
    [[nodiscard]] jauscat::bus_options of_bus(jauscat::bus_options options) {
        options.log = [this, has_names = !options.slaves.empty()](std::string_view line) {
            if (!has_names || line.find(": slave ") == line.npos) return; // a fault, which comes here, too
            if (line.find(" is refused: ") != line.npos) failure_ = line;
            if (line.ends_with(" is there") || line.ends_with(" answers again"))
                say_(events::bus_log, {{"line", line}}, std::string{line});
            else
                say_.warn(events::bus_log, {{"line", line}}, std::string{line});
        };
        options.on_fault = [this](jauscat::link_fault what, std::string_view line) {
            switch (what) {
            case jauscat::link_fault::no_frames:
                return say_.bad(events::link_problem, {{"problem", line}}, std::string{line});
            case jauscat::link_fault::second_master: return say_.bad(events::second_master, {}, std::string{line});
            case jauscat::link_fault::broken_ring: return say_.bad(events::broken_ring, {}, std::string{line});
            }
        };
        options.on_frame = [this](const jauscat::passing_frame& frame) {
            if (frame.is_keep_alive) return;
            const auto* const arrow = frame.is_sent ? "  -> " : "  <- ";
            for_each_sdo(frame.bytes, frame.is_sent, [&](unsigned station, const auto& text, const auto& members) {
                write_limited(trace_name_ + arrow, frame.is_sent ? events::sdo_sent : events::sdo_received,
                              say_.about() + members,
                              trace_name_ + arrow + "station " + std::to_string(station) + ": " + text + "\n");
            });
        };
        return options;
    }
    void ready(const jauscat::net::system_entry& me, unsigned station, bool cyclic, bool is_up) const {
        const auto endpoint = jauscat::net::detail::text(me.endpoint());
        const auto slave = "slave " + std::to_string(station) + (cyclic ? " in OP" : " in PRE-OP");
        say_.good(events::ready,
                  {{"endpoint", endpoint}, {"station", station}, {"cyclic", cyclic}, {"slave_up", is_up}},
                  "ready: JAUS on " + endpoint + ", " + (is_up ? slave : "waiting for its slave: " + failure_) +
                      " (Ctrl-C ends)");
    }
    void peer(const jauscat::jaus::address& who, bool is_there) const {
        const auto name = jauscat::text::to_text(who);
        say_(is_there ? events::peer_heard : events::peer_lost, {{"address", name}},
             name + (is_there ? " is heard" : " is no longer heard"));
    }
    void stopped(unsigned station, bool is_at_rest) const {
        if (!is_at_rest)
            say_.bad(events::not_at_rest, {{"station", station}},
                     "slave " + std::to_string(station) +
                         " has not confirmed that it is at rest: it stops by its own watchdog or not at all");
        say_(events::stopped, {}, "stopped");
    }
    /// Why the slave was not brought up last; empty if it was.
    [[nodiscard]] const std::string& failure() const noexcept { return failure_; }

    /// Refers to this object.
    [[nodiscard]] bridging::observer observer() {
        using jauscat::jaus::bound;
        return {.slave_up = bound<&narrator::slave_up>(*this),
                .bring_up_failed = bound<&narrator::bring_up_failed>(*this),
                .slave_lost = bound<&narrator::slave_lost>(*this),
                .slave_emergency = bound<&narrator::slave_emergency>(*this),
                .no_keep_alive = bound<&narrator::no_keep_alive>(*this),
                .changed_state = bound<&narrator::changed_state>(*this),
                .changed_controller = bound<&narrator::changed_controller>(*this),
                .stop_required = bound<&narrator::stop_required>(*this),
                .stop_refused = bound<&narrator::stop_refused>(*this),
                .settled = bound<&narrator::settled>(*this),
                .faulted = bound<&narrator::faulted>(*this),
                .fault_ended = bound<&narrator::fault_ended>(*this),
                .translated = bound<&narrator::translated>(*this),
                .asks_report = bound<&narrator::asks_report>(*this),
                .into_image = bound<&narrator::into_image>(*this),
                .from_image = bound<&narrator::from_image>(*this),
                .refused = bound<&narrator::refused>(*this)};
    }

    void slave_up(const bridging::slave_front& slave, const jauscat::ethercat::slave_record& record, bool ready) {
        failure_.clear();
        const auto& identity = record.identity;
        if (!ready || !slave.options().cyclic)
            say_(events::slave_up,
                 station(slave) +
                     event_members{{"state", "pre_op"}, {"vendor", identity.vendor}, {"product", identity.product}},
                 name(slave) + " is in PRE-OP: vendor " + jauscat::text::hex_number(identity.vendor, 8) + ", product " +
                     jauscat::text::hex_number(identity.product, 8));
        if (ready && slave.options().cyclic)
            say_(events::slave_up, station(slave) + event_members{{"state", "op"}}, name(slave) + " is in OP");
    }
    void bring_up_failed(const bridging::slave_front& slave, const jauscat::ethercat::master_error& why) {
        const auto text = explain(why);
        if (std::exchange(failure_, text) != text)
            say_.bad(events::bring_up_failed, station(slave) + reason(why),
                     name(slave) + " cannot be brought up: " + text);
    }
    void slave_lost(const bridging::slave_front& slave, bridging::loss what,
                    const jauscat::ethercat::master_error& why) {
        if (!slave.up() && what == bridging::loss::no_process_data) {
            const auto text = explain(why);
            if (std::exchange(failure_, text) != text)
                say_.bad(events::no_process_data, station(slave) + reason(why),
                         name(slave) + ": no process data: " + text);
            return;
        }
        say_.bad(events::slave_lost, station(slave) + event_members{{"loss", loss_name(what)}} + reason(why),
                 name(slave) + ' ' + loss_text(what, slave.options().cyclic) + ": " + explain(why));
    }
    void slave_emergency(const bridging::slave_front& slave, const jauscat::ethercat::coe_emergency& emergency) {
        say_.bad(events::slave_emergency,
                 station(slave) + event_members{{"error_code", emergency.error_code},
                                                {"error_register", emergency.error_register},
                                                {"data", jauscat::text::hex(emergency.data)}},
                 "emergency of " + name(slave) + ": error code " + jauscat::text::hex_number(emergency.error_code, 4) +
                     ", error register " + jauscat::text::hex_number(emergency.error_register, 2) + ", data " +
                     jauscat::text::hex(emergency.data));
    }
    void no_keep_alive(const bridging::slave_front& slave, const bridging::refusal_reason& why) {
        say_.bad(events::no_keep_alive, station(slave) + reason(why),
                 name(slave) + " takes no Report Heartbeat Pulse (" + refusal_text(slave, why) +
                     "): it does not stop by itself if this program ends without a word");
    }

    void changed_state(const bridging::component& unit, jauscat::jaus::primary_status_code from,
                       jauscat::jaus::primary_status_code to) {
        say_(events::state_changed,
             {{"address", name(unit)}, {"from", jauscat::text::to_text(from)}, {"to", jauscat::text::to_text(to)}},
             name(unit) + ": " + jauscat::text::to_text(from) + " -> " + jauscat::text::to_text(to));
    }
    void changed_controller(const bridging::component& unit, jauscat::jaus::control_change) {
        const auto& now = unit.control().controller();
        if (now)
            say_(events::controller_taken,
                 {{"address", name(unit)},
                  {"controller", jauscat::text::to_text(now->address)},
                  {"authority", now->authority_code}},
                 name(unit) + " is controlled by " + jauscat::text::to_text(now->address) + ", authority " +
                     std::to_string(now->authority_code));
        else
            say_(events::controller_gone, {{"address", name(unit)}}, name(unit) + " is controlled by no component");
    }
    void stop_required(const bridging::component& unit, bridging::stop_order what, bridging::stop_cause why) {
        const auto when = unit.front().up() ? ": efforts go to zero" : ": efforts go to zero when the slave is back";
        say_(events::stop_owed,
             {{"address", name(unit)},
              {"order", order_name(what)},
              {"cause", cause_name(why)},
              {"state", jauscat::text::to_text(unit.state())},
              {"slave_up", unit.front().up()}},
             name(unit) + ": " + cause_text(unit, why) + when);
    }
    void stop_refused(const bridging::component& unit, bridging::stop_order what, const bridging::refusal_reason& why,
                      unsigned attempts) {
        if (attempts != 1 && attempts != 10 && attempts % 100 != 0) return;
        say_.bad(events::stop_refused,
                 event_members{{"address", name(unit)}, {"order", order_name(what)}, {"attempt", attempts}} +
                     station(unit.front()) + reason(why),
                 name(unit) + ": the slave has not confirmed " + order_text(what) + ", attempt " +
                     std::to_string(attempts) + ": " + refusal_text(unit.front(), why) + "; it is repeated");
    }
    void settled(const bridging::component& unit) {
        say_(events::stop_confirmed, {{"address", name(unit)}}, name(unit) + ": the slave has confirmed");
    }

    void faulted(const bridging::component& unit, const bridging::drive_fault& what) {
        say_.bad(
            events::drive_fault,
            {{"address", name(unit)}, {"drive", what.slave}, {"error_code", what.code}, {"reason", fault_text(what)}},
            name(unit) + ": fault of the drive " + std::to_string(what.slave) + ": error code " +
                jauscat::text::hex_number(what.code, 4) + ", " + fault_text(what));
    }
    void fault_ended(const bridging::component& unit) {
        say_(events::drive_fault_ended, {{"address", name(unit)}}, name(unit) + ": no drive has a fault any more");
    }

    void translated(const bridging::slave_front&, std::span<const std::byte> packet) {
        say_(events::packet_translated, packet_members(packet), "translated to an SDO download packet",
             packet_text(packet));
    }
    void asks_report(const bridging::slave_front&, std::span<const std::byte> packet) {
        say_(events::report_requested, upload_members(packet),
             "asks for the report by an SDO upload packet, " + upload_text(packet));
    }
    void into_image(const bridging::slave_front&, std::uint32_t count, std::span<const std::byte> outputs) {
        say_(events::image_written, {{"command", count}, {"outputs", jauscat::text::hex(outputs)}},
             "into the process image, command " + std::to_string(count) + ": " + jauscat::text::hex(outputs));
    }
    void from_image(const bridging::slave_front&, std::span<const std::byte> inputs) {
        say_(events::image_read, {{"inputs", jauscat::text::hex(inputs)}},
             "answers from the process image: " + jauscat::text::hex(inputs));
    }
    void refused(const bridging::component& unit, const jauscat::jaus::header& message,
                 const bridging::refusal_reason& why) {
        say_.bad(events::not_delivered,
                 event_members{{"address", name(unit)}, {"code", message.command_code}} + station(unit.front()) +
                     reason(why),
                 "not delivered to " + name(unit) + ": " +
                     (why.why == bridging::refusal::slave_down ? name(unit.front()) + " does not answer"
                                                               : refusal_text(unit.front(), why)));
    }

  private:
    /// Not those of the node manager, and no pulses, which come and go several times a second.
    static bool is_shown(const jauscat::jaus::address& component, const jauscat::jaus::header& head) {
        return !is_node_manager(component) &&
               head.command_code != jauscat::jaus::command_code_of<jauscat::jaus::query_heartbeat_pulse> &&
               head.command_code != jauscat::jaus::command_code_of<jauscat::jaus::report_heartbeat_pulse>;
    }
    void received(const jauscat::jaus::header& head, std::span<const std::byte> body) const {
        std::array<std::byte, jauscat::jaus::header_size + jauscat::jaus::max_body_size> message{};
        const auto made = jauscat::jaus::join(head, body, message);
        if (made)
            say_(events::message_received, message_members(head, body),
                 "received " + jauscat::text::summary(jauscat::jaus::split(*made).header),
                 jauscat::text::annotate_message(*made, robot_messages{}));
        else
            say_(events::message_received, message_members(head) + event_members{{"large_body", body.size()}},
                 "received " + jauscat::text::message_name(head.command_code) + ", a large data set of " +
                     std::to_string(body.size()) + " bytes, from " + jauscat::text::to_text(head.source));
    }

    static std::string name(const bridging::component& unit) { return jauscat::text::to_text(unit.self()); }
    static std::string name(const bridging::slave_front& slave) { return "slave " + std::to_string(slave.station()); }

    // Members of the events.
    static event_members station(const bridging::slave_front& slave) { return {{"station", slave.station()}}; }
    static event_members reason(const jauscat::ethercat::master_error& why) { return {{"reason", explain(why)}}; }
    /// `status` is ulSta, `error` a number of translate::errc; 0 where they say nothing.
    static event_members reason(const bridging::refusal_reason& why) {
        return {{"refusal", refusal_name(why.why)},
                {"status", why.status},
                {"abort_code", abort_code_of(why)},
                {"error", why.error}};
    }
    /// Some abort codes have no status of their own.
    static std::uint32_t abort_code_of(const bridging::refusal_reason& why) {
        const auto code = jauscat::hilscher::abort_of(why.status);
        return static_cast<std::uint32_t>(code == jauscat::ethercat::abort_code::none ? why.of_master.abort : code);
    }
    static const char* loss_name(bridging::loss what) {
        switch (what) {
        case bridging::loss::no_answer: return "no_answer";
        case bridging::loss::no_station: return "no_station";
        case bridging::loss::left_state: return "left_state";
        case bridging::loss::no_process_data: return "no_process_data";
        }
        return "unknown";
    }
    static const char* cause_name(bridging::stop_cause why) {
        switch (why) {
        case bridging::stop_cause::state: return "state";
        case bridging::stop_cause::controller_lost: return "controller_lost";
        case bridging::stop_cause::control_taken: return "control_taken";
        case bridging::stop_cause::sender_lost: return "sender_lost";
        case bridging::stop_cause::slave_absent: return "slave_absent";
        case bridging::stop_cause::slave_returned: return "slave_returned";
        case bridging::stop_cause::not_accepted: return "not_accepted";
        case bridging::stop_cause::program_ends: return "program_ends";
        case bridging::stop_cause::drive_fault: return "drive_fault";
        }
        return "unknown";
    }
    static const char* order_name(bridging::stop_order what) {
        switch (what) {
        case bridging::stop_order::rest: return "rest";
        case bridging::stop_order::emergency: return "emergency";
        case bridging::stop_order::clear_emergency: return "clear_emergency";
        }
        return "unknown";
    }
    static const char* refusal_name(bridging::refusal why) {
        switch (why) {
        case bridging::refusal::slave_down: return "slave_down";
        case bridging::refusal::queue_full: return "queue_full";
        case bridging::refusal::too_large: return "too_large";
        case bridging::refusal::expired: return "expired";
        case bridging::refusal::superseded: return "superseded";
        case bridging::refusal::stopped: return "stopped";
        case bridging::refusal::not_translated: return "not_translated";
        case bridging::refusal::by_slave: return "by_slave";
        case bridging::refusal::not_accepted: return "not_accepted";
        case bridging::refusal::stale: return "stale";
        }
        return "unknown";
    }

    static std::string fault_text(const bridging::drive_fault& what) {
        return std::string{what.reason.empty() ? jauscat::cia402::describe_error_code(what.code) : what.reason};
    }
    static std::string loss_text(bridging::loss what, bool cyclic) {
        switch (what) {
        case bridging::loss::no_answer: return "does not answer";
        case bridging::loss::no_station: return "is no longer there under its station address";
        case bridging::loss::left_state: return cyclic ? "is no longer in OP" : "is no longer in PRE-OP";
        case bridging::loss::no_process_data: return "no longer takes process data";
        }
        return "is lost";
    }
    static std::string cause_text(const bridging::component& unit, bridging::stop_cause why) {
        switch (why) {
        case bridging::stop_cause::state: return jauscat::text::to_text(unit.state());
        case bridging::stop_cause::controller_lost: return "its controller is lost";
        case bridging::stop_cause::control_taken: return "another component has control, and a command waited";
        case bridging::stop_cause::sender_lost: return "the sender of its last command is lost";
        case bridging::stop_cause::slave_absent: return "the slave is away";
        case bridging::stop_cause::slave_returned: return "the slave is back";
        case bridging::stop_cause::not_accepted: return "the slave has not taken a command in time";
        case bridging::stop_cause::program_ends: return "the program ends";
        case bridging::stop_cause::drive_fault: return "a drive has a fault";
        }
        return "stop";
    }
    // What the status does not say: some abort codes have none of their own.
    static std::string reason_text(const bridging::refusal_reason& why) {
        const bool is_said = jauscat::hilscher::abort_of(why.status) != jauscat::ethercat::abort_code::none;
        const bool is_ok = why.of_master == jauscat::ethercat::master_error{};
        return is_ok || is_said ? std::string{} : ": " + explain(why.of_master);
    }
    // The slave may take its JAUS address from its own configuration, and refuse what is sent to another.
    static std::string place_text(const bridging::slave_front& slave, jauscat::hilscher::packet_status status) {
        std::string text = "station address " + std::to_string(slave.station()) + " (" +
                           jauscat::text::hex_number(slave.station(), 4) + ")";
        if (status == jauscat::hilscher::packet_status::sdo_abort_parameter_incompatible)
            text += ": the slave must be JAUS node " + std::to_string(slave.station()) + " of subsystem " +
                    std::to_string(slave.options().identity.subsystem) + ", see robot_arm --node";
        return text;
    }
    static std::string order_text(bridging::stop_order what) {
        switch (what) {
        case bridging::stop_order::rest: return "zero efforts";
        case bridging::stop_order::emergency: return "the emergency";
        case bridging::stop_order::clear_emergency: return "the end of the emergency";
        }
        return "a stop order";
    }
    static std::string refusal_text(const bridging::slave_front& slave, const bridging::refusal_reason& why) {
        switch (why.why) {
        case bridging::refusal::slave_down: return "the slave does not answer";
        case bridging::refusal::queue_full: return "too many messages wait for the slave";
        case bridging::refusal::too_large: return "more bytes than an SDO carries";
        case bridging::refusal::expired: return "it waited too long for the slave";
        case bridging::refusal::superseded: return "a newer command of the same sender came before it was its turn";
        case bridging::refusal::stopped: return "a stop order came before it was its turn";
        case bridging::refusal::not_translated: return std::string{describe(why.error)};
        case bridging::refusal::by_slave:
            return jauscat::text::explain(why.status) + reason_text(why) + ", asked at " +
                   place_text(slave, why.status);
        case bridging::refusal::not_accepted: return "the slave has not taken the command out of its process data";
        case bridging::refusal::stale: return "the slave's inputs are too old to answer from";
        }
        return "refused";
    }

    speaker say_;
    std::string trace_name_;
    repeated_lines log_lines_{};
    std::string failure_{}; ///< of the last attempt to bring a slave up: logged once
};

} // namespace example
