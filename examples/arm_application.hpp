// What the robot arm does: every object written to the slave becomes its JAUS message again and reaches a handler; a
// query prepares the report that the master uploads next. The slave's dictionary is made of the messages it accepts.
#pragma once
#include "support/message_event.hpp"
#include "support/robot_messages.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/copy_present.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/jaus.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace example {

/// What the arm made of a message.
enum class obedience : std::uint8_t {
    obeyed,
    refused, ///< it would move, in an emergency
    unknown,
    malformed,
};

/// The arm: JAUS messages in, and the report that the last query requested. In an emergency it refuses motion commands;
/// it always executes stop orders.
class arm {
  public:
    using said = std::function<void(event_kind, const event_members&, const std::string& line)>;

    /// `say` gets an event for each thing that happens; `moved` is called when the efforts in force have changed.
    arm(said say, std::function<void()> moved) : say_{std::move(say)}, moved_{std::move(moved)} {}

    /// The efforts in force; every field is there, 0 until commanded.
    [[nodiscard]] const jauscat::jaus::report_wrench_effort& efforts() const noexcept { return efforts_; }
    /// The report that the last query requested, as a message; empty before the first query.
    [[nodiscard]] std::span<const std::byte> report() const noexcept { return report_; }

    /// Number of received messages: while it increases, there is a controller.
    [[nodiscard]] std::uint64_t messages() const noexcept { return messages_; }
    /// Efforts or a speed are in force.
    [[nodiscard]] bool moves() const noexcept { return any(efforts_) || travel_speed_.desired_speed != 0; }
    /// The last efforts were in the process data.
    [[nodiscard]] bool driven_by_process_data() const noexcept { return by_process_data_; }

    void say(event_kind kind, const event_members& members, const std::string& line) const {
        say_(kind, members, line);
    }

    obedience receive(std::span<const std::byte> bytes) {
        const auto message = jauscat::jaus::split(bytes);
        if (!message) {
            say_(events::message_malformed, {{"reason", describe(message.error)}},
                 "refused a message: " + std::string{describe(message.error)});
            return obedience::malformed;
        }
        ++messages_;
        if (message.header.command_code != jauscat::jaus::command_code_of<jauscat::jaus::report_heartbeat_pulse>)
            say_(events::message_received, message_members(message.header, message.body),
                 "received " + jauscat::text::summary(message.header));
        refused_ = false;
        switch (dispatch(message.header, message.body)) {
        case jauscat::jaus::dispatched::unknown: return obedience::unknown;
        case jauscat::jaus::dispatched::malformed: return obedience::malformed;
        default: return refused_ ? obedience::refused : obedience::obeyed;
        }
    }

    /// Obeys the body of a Set Wrench Effort out of the process data.
    obedience drive_by(std::span<const std::byte> body) {
        jauscat::jaus::set_wrench_effort command{};
        if (const auto size = jauscat::wire::decode(command, body); !size) {
            say_(events::message_malformed,
                 {{"code", jauscat::jaus::command_code_of<jauscat::jaus::set_wrench_effort>},
                  {"reason", describe(size.error())}},
                 "refused efforts: " + std::string{describe(size.error())});
            return obedience::malformed;
        }
        refused_ = false;
        drive(command, true);
        return refused_ ? obedience::refused : obedience::obeyed;
    }
    /// Sets all efforts to zero, if there are any, and logs it, also if process data have set them to zero.
    /// `cause` is the event's member.
    void rest(const char* cause, const std::string& why) {
        if (moves() || by_process_data_) halt(cause, why);
        by_process_data_ = false;
    }

  private:
    using header = jauscat::jaus::header;

    jauscat::jaus::dispatched dispatch(const header& head, std::span<const std::byte> body) {
        namespace jaus = jauscat::jaus;
        jaus::dispatcher handlers{
            jaus::on<jaus::set_wrench_effort>([&](const header&, const auto& command) { drive(command, false); }),
            jaus::on<jaus::set_travel_speed>([&](const header&, const auto& command) {
                if (refuses(command.desired_speed != 0)) return;
                travel_speed_.desired_speed = command.desired_speed;
                say_(events::travel_speed_set, {{"speed", command.desired_speed}},
                     "travel speed " + jauscat::text::to_text(command.desired_speed) + " m/s");
            }),
            jaus::on<jaus::set_emergency>([&](const header&, const auto& command) {
                if (!command.emergency_code.test(jaus::set_emergency_code::transition_to_emergency))
                    say_(events::emergency_code_missing, {{"code", jaus::command_code_of<jaus::set_emergency>}},
                         "Set Emergency without a code: obeyed all the same");
                enter_emergency();
            }),
            jaus::on<jaus::clear_emergency>([&](const header&, const auto& command) {
                if (!command.emergency_code.test(jaus::clear_emergency_code::clear_emergency))
                    return say_(events::emergency_code_missing,
                                {{"code", jaus::command_code_of<jaus::clear_emergency>}},
                                "Clear Emergency without its code: ignored");
                status_.primary_status_code = jaus::primary_status_code::ready;
                say_(events::emergency_cleared, {}, "emergency cleared");
            }),
            jaus::on<jaus::set_component_authority>([&](const header&, const auto& command) {
                authority_ = command.authority_code;
                say_(events::authority_set, {{"authority", authority_}}, "authority " + std::to_string(authority_));
            }),
            jaus::on<jaus::query_component_status>([&](const header& query, const auto&) { prepare(query, status_); }),
            jaus::on<jaus::query_travel_speed>(
                [&](const header& query, const auto&) { prepare(query, travel_speed_); }),
            jaus::on<jaus::query_wrench_effort>([&](const header& query, const auto& asked) {
                auto report = efforts_;
                jaus::keep_requested(report, asked.presence_vector);
                prepare(query, report);
            }),
            jaus::on<jaus::query_global_pose>([&](const header& query, const auto& asked) {
                auto report = pose_;
                jaus::keep_requested(report, asked.presence_vector);
                prepare(query, report);
            }),
            // Reports reach an arm from other components of the robot; it stores the pose of its own platform, and
            // shows the others.
            jaus::on<jaus::report_global_pose>([&](const header& from, const auto& report) {
                pose_ = report;
                say_taken(from, "pose of the robot updated");
            }),
            jaus::on<jaus::report_wrench_effort>(
                [&](const header& from, const auto&) { say_taken(from, "efforts of another arm"); }),
            jaus::on<jaus::report_travel_speed>(
                [&](const header& from, const auto&) { say_taken(from, "speed of another component"); }),
            jaus::on<jaus::report_component_status>([&](const header& from, const auto& report) {
                say_taken(from, jauscat::text::to_text(from.source) + " is " +
                                    jauscat::text::to_text(report.primary_status_code));
            }),
            jaus::on<jaus::report_heartbeat_pulse>([](const header&, const auto&) {}), // see messages()
            jaus::on_unknown([&](const header& unknown, auto) {
                say_(events::message_unknown, {{"code", unknown.command_code}},
                     "no handler for " + jauscat::text::message_name(unknown.command_code));
            }),
            jaus::on_malformed([&](const header& bad, auto bytes, jauscat::wire::errc) {
                const auto why = jauscat::text::why_malformed(bad.command_code, bytes, robot_messages{});
                say_(events::message_malformed, {{"code", bad.command_code}, {"reason", why}},
                     "refused the body of " + jauscat::text::message_name(bad.command_code) + ": " + why);
            })};
        return handlers(head, body);
    }

    // What moves is refused in an emergency.
    bool refuses(bool moves) {
        if (!moves || status_.primary_status_code != jauscat::jaus::primary_status_code::emergency) return false;
        say_(events::refused_in_emergency, {}, "in an emergency: refused");
        return refused_ = true;
    }
    void drive(const jauscat::jaus::set_wrench_effort& command, bool by_process_data) {
        if (refuses(any(command))) return;
        by_process_data_ = by_process_data;
        jauscat::jaus::copy_present(command, efforts_); // fields that a command leaves out keep their effort
        moved_();
    }
    void halt(const char* cause, const std::string& why) {
        efforts_ = no_effort();
        travel_speed_ = {};
        say_(events::efforts_zeroed, {{"cause", cause}}, why + ": all efforts to zero");
        moved_();
    }
    void enter_emergency() {
        status_.primary_status_code = jauscat::jaus::primary_status_code::emergency;
        halt("emergency", "EMERGENCY");
    }

    static bool any(const auto& efforts) noexcept {
        bool found = false;
        jauscat::wire::visit(efforts, [&](auto, const auto& effort) { found = found || effort.value_or(0) != 0; });
        return found;
    }
    static jauscat::jaus::report_wrench_effort no_effort() {
        jauscat::jaus::report_wrench_effort none{};
        jauscat::wire::visit(none, [](auto, auto& effort) { effort = 0.0; });
        return none;
    }

    // A report is in the object of the arm's own component, so it is a message from the arm to itself.
    template <class Report> void prepare(const header& query, const Report& report) {
        report_.clear();
        auto head = jauscat::jaus::answer_to(query);
        head.destination = query.destination;
        head.source = query.destination;
        std::array<std::byte, 256> message{};
        const auto made = jauscat::jaus::make_message(head, report, message);
        if (!made) {
            say_(events::report_failed, {{"reason", describe(made.error())}},
                 "cannot report: " + std::string{describe(made.error())});
            return;
        }
        report_.assign(made->begin(), made->end());
        constexpr auto code = jauscat::jaus::command_code_of<Report>;
        say_(events::report_prepared, {{"code", code}}, "prepared " + jauscat::text::message_name(code));
    }
    void say_taken(const header& report, const std::string& line) {
        say_(events::report_taken, message_members(report), line);
    }

    said say_;
    std::function<void()> moved_;
    std::vector<std::byte> report_{};
    jauscat::jaus::report_wrench_effort efforts_{no_effort()};
    jauscat::jaus::report_travel_speed travel_speed_{};
    jauscat::jaus::report_global_pose pose_{};
    jauscat::jaus::report_component_status status_{.primary_status_code = jauscat::jaus::primary_status_code::ready};
    std::uint8_t authority_{};
    std::uint64_t messages_{};
    bool by_process_data_{};
    bool refused_{}; ///< the message that is being dispatched
};

/// The arm behind an EtherCAT slave, under one translation table.
template <class Table> class arm_application {
  public:
    /// JAUS component ID of a Primitive Driver.
    static constexpr std::uint8_t component = 33;
    /// The objects of the slave's dictionary, with a subobject for each message that the arm accepts: the one of its
    /// component, and the one of all components of the node.
    static constexpr std::array objects{jauscat::bridging::object_list<Table, component, robot_messages>::description,
                                        jauscat::bridging::object_list<Table, 255, robot_messages>::description};

    /// `node` is the arm's JAUS node; without it, it is the station address that the master gives the slave.
    arm_application(std::uint8_t subsystem, arm& behind, std::optional<std::uint8_t> node = {})
        : self_{.subsystem = subsystem, .station = node.value_or(0)}, has_own_node_{node.has_value()}, arm_{behind} {}

    /// The station address that the master gave the slave.
    void set_station(std::uint16_t station) noexcept {
        if (!has_own_node_) self_.station = station;
    }

    /// An SDO download: the object as a JAUS message.
    jauscat::ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex,
                                        std::span<const std::byte> data) noexcept {
        using jauscat::ethercat::abort_code;
        namespace translate = jauscat::translate;
        if (self_.station == 0 || self_.station > highest_node) {
            arm_.say(events::object_refused, {{"index", index}, {"subindex", subindex}, {"station", self_.station}},
                     "refused an object: the station address " + std::to_string(self_.station) + " (" +
                         jauscat::text::hex_number(self_.station, 4) +
                         ") is not a JAUS node, 1 to 254: give the node with --node");
            return abort_code::parameter_incompatible;
        }
        const auto restored = delivery::message_of({self_.station, index, subindex, data}, self_, message_);
        if (!restored) {
            arm_.say(events::object_refused,
                     {{"index", index}, {"subindex", subindex}, {"reason", describe(restored.error())}},
                     "refused an object: " + std::string{describe(restored.error())});
            switch (restored.error()) {
            case translate::errc::unknown_index: return abort_code::no_object;
            case translate::errc::unknown_subindex: return abort_code::no_subindex;
            case translate::errc::wrong_size: return abort_code::length_mismatch;
            case translate::errc::truncated: return abort_code::length_too_low;
            case translate::errc::too_large:
            case translate::errc::no_space: return abort_code::length_too_high;
            default: return abort_code::parameter_incompatible;
            }
        }
        switch (arm_.receive(*restored)) {
        case obedience::obeyed: return abort_code::none;
        case obedience::refused: return abort_code::device_state;
        case obedience::unknown: return abort_code::no_subindex;
        case obedience::malformed: return abort_code::value_range;
        }
        return abort_code::general;
    }

    /// An SDO upload: the report that the last query prepared.
    jauscat::ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        using jauscat::ethercat::abort_code;
        if (arm_.report().empty()) return {abort_code::no_data, 0};
        std::array<std::byte, delivery::translator::max_packet_size> packet{};
        const auto translated = delivery::translator::to_packet(arm_.report(), packet);
        if (!translated) {
            arm_.say(events::report_failed, {{"reason", describe(translated.error())}},
                     "cannot report: " + std::string{describe(translated.error())});
            return {abort_code::cannot_store, 0};
        }
        const auto object = delivery::object_of(*translated);
        if (object.index != index || object.subindex != subindex) return {abort_code::no_data, 0};
        if (object.data.size() > out.size()) return {abort_code::exceeds_mailbox, 0};
        std::ranges::copy(object.data, out.begin());
        return {abort_code::none, object.data.size()};
    }

  private:
    using delivery = jauscat::bridging::delivery<Table>;
    static constexpr std::uint16_t highest_node = 254;

    jauscat::bridging::slave_identity self_;
    bool has_own_node_{};
    arm& arm_;
    std::array<std::byte, delivery::translator::max_message_size> message_{};
};

} // namespace example
