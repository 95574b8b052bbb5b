// The functions of described_component.
#pragma once
#include <jauscat/jaus/component/described_component.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR heartbeat heartbeat_to_node_manager(const address& self) noexcept {
    return {.to = {.instance = 1, .component = 1, .node = self.node, .subsystem = self.subsystem}};
}

JAUSCAT_CONSTEXPR heartbeat heartbeat_to_all() noexcept {
    return {.to = {.instance = 1, .component = 1, .node = 255, .subsystem = 255}};
}

JAUSCAT_CONSTEXPR described_component::described_component(const address& self,
                                                           const component_description& description,
                                                           const heartbeat& beat, std::span<std::byte> memory) noexcept
    : self_{self}, description_{description}, beat_{beat}, memory_{memory} {
    // Some nodes repeat Query Services until a service is reported.
    if (description.services.empty()) description_.services = core_messages::services;
}

JAUSCAT_CONSTEXPR message_outcome described_component::on_message(const header& head, std::span<const std::byte> body,
                                                                  time_point, message_sink out) noexcept {
    if (is_acknowledgement(head)) return message_outcome::unhandled;
    const auto done = [](bool sent) { return sent ? message_outcome::handled : message_outcome::refused; };
    switch (head.command_code) {
    case command_code_of<query_heartbeat_pulse>:
        return decode_for<query_heartbeat_pulse>(
            body, [&](const auto&) { return done(answer(head, self_, report_heartbeat_pulse{}, out).has_value()); });
    case command_code_of<query_identification>:
        return decode_for<query_identification>(body, [&](const query_identification& query) {
            return done(query.query_type == query_type::component_identification &&
                        answer(head, self_, identification(query.query_type, description_.name), out).has_value());
        });
    case command_code_of<query_services>:
        return decode_for<query_services>(body, [&](const auto&) {
            return done(answer(head, self_, report_services{description_.services}, memory_, out).has_value());
        });
    default: return message_outcome::unhandled;
    }
}

JAUSCAT_CONSTEXPR void described_component::on_time(time_point now, message_sink out) noexcept {
    if (beat_.period <= duration{} || now < next_) return;
    const time_point following = saturating_add(next_, beat_.period);
    next_ = following > now ? following : saturating_add(now, beat_.period);
    static_cast<void>(
        put({.destination = beat_.to, .source = self_, .sequence_number = beats_++}, report_heartbeat_pulse{}, out));
}

JAUSCAT_CONSTEXPR std::optional<time_point> described_component::next_event() const noexcept {
    if (beat_.period <= duration{}) return std::nullopt;
    return next_;
}

JAUSCAT_CONSTEXPR report_identification described_component::identification(query_type whose,
                                                                            const identity& name) noexcept {
    return {whose, name.authority_code, name.type, name.identification};
}

} // namespace jauscat::jaus
