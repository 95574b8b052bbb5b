// The functions of node_manager.
#pragma once
#include <jauscat/jaus/routing/node_manager.hpp>

namespace jauscat::jaus {

JAUSCAT_FUNCTION node_manager::node_manager(const address& self, const node_description& description,
                                            const node_manager_memory& memory,
                                            const node_manager_options& options) noexcept
    : self_{self},
      description_{description},
      memory_{memory},
      options_{options},
      own_{self, {description.manager, description.services}, options.beat, memory.report},
      present_{memory.presences} {}

JAUSCAT_FUNCTION message_outcome node_manager::on_message(const header& head, std::span<const std::byte> body,
                                                          time_point now, message_sink out) noexcept {
    if (is_acknowledgement(head)) return message_outcome::unhandled;
    switch (head.command_code) {
    case command_code_of<report_heartbeat_pulse>:
        return decode_for<report_heartbeat_pulse>(body, [&](const auto&) { return on_heartbeat(head, now, out); });
    case command_code_of<report_configuration>: return on_configuration(head, body, now);
    case command_code_of<query_identification>:
        return decode_for<query_identification>(
            body, [&](const query_identification& query) { return identify(query.query_type, head, body, out); });
    case command_code_of<query_configuration>:
        return decode_for<query_configuration>(body, [&](const query_configuration& query) {
            return done(with_components(query.query_field, [&](const report_configuration& report) {
                return answer(head, self_, report, memory_.report, out).has_value();
            }));
        });
    case command_code_of<query_subsystem_list>:
        return decode_for<query_subsystem_list>(body, [&](const auto&) { return report_subsystems(head, out); });
    default: return own_.on_message(head, body, now, out);
    }
}

JAUSCAT_FUNCTION void node_manager::on_time(time_point now, message_sink out) noexcept {
    own_.on_time(now, out);
    std::bitset<256> lost; // nodes of the own subsystem
    present_.on_time(now, [&](const address& who) {
        if (who.subsystem == self_.subsystem && is_node_manager(who)) lost[who.node] = true;
        tell(options_.disappeared, who);
    });
    if (lost.any())
        present_.remove_if(
            [&](const liveness_table::place& one) {
                return one.address.subsystem == self_.subsystem && lost[one.address.node];
            },
            [&](const address& who) { tell(options_.disappeared, who); });
    if (options_.survey <= duration{} || now < next_survey_) return;
    next_survey_ = saturating_add(now, options_.survey);
    present_.for_each([&](const address& who) { ask(who, out); });
}

JAUSCAT_FUNCTION std::optional<time_point> node_manager::next_event() const noexcept {
    std::optional<time_point> next = own_.next_event();
    const auto earlier = [&](time_point other) { next = next ? std::min(*next, other) : other; };
    if (const auto check = present_.next_event()) earlier(*check);
    if (options_.survey > duration{}) earlier(next_survey_);
    return next;
}

JAUSCAT_FUNCTION std::optional<std::size_t> node_manager::configuration(query_field what,
                                                                        std::span<std::byte> body) const noexcept {
    std::optional<std::size_t> used;
    with_components(what, [&](const report_configuration& report) {
        if (const auto encoded = wire::encode(report, body)) used = encoded->size();
        return used.has_value();
    });
    return used;
}

JAUSCAT_FUNCTION void node_manager::tell(const hook<void(const address&)>& whom, const address& who) noexcept {
    if (whom) whom(who);
}

JAUSCAT_FUNCTION message_outcome node_manager::done(bool sent) noexcept {
    return sent ? message_outcome::handled : message_outcome::refused;
}

JAUSCAT_FUNCTION heard node_manager::remember(const address& who, time_point now, duration timeout) noexcept {
    const heard what = present_.on_heard(who, now, timeout);
    if (what == heard::no_capacity) ++not_remembered_;
    if (what == heard::appeared) tell(options_.appeared, who);
    return what;
}

JAUSCAT_FUNCTION message_outcome node_manager::on_heartbeat(const header& head, time_point now,
                                                            message_sink out) noexcept {
    if (head.source == self_) return message_outcome::handled; // our own to all
    const heard what = remember(head.source, now, options_.timeout);
    if (what == heard::appeared) ask(head.source, out);
    return done(what != heard::no_capacity);
}

JAUSCAT_FUNCTION void node_manager::ask(const address& who, message_sink out) const noexcept {
    if (who.subsystem != self_.subsystem || who.node == self_.node || !is_node_manager(who)) return;
    static_cast<void>(
        put({.destination = who, .source = self_}, query_configuration{query_field::node_configuration}, out));
}

JAUSCAT_FUNCTION message_outcome node_manager::on_configuration(const header& head, std::span<const std::byte> body,
                                                                time_point now) noexcept {
    const auto& from = head.source;
    const bool is_asked = from.subsystem == self_.subsystem && from.node != self_.node && is_node_manager(from);
    if (!is_asked || present_.find(from) == nullptr) return message_outcome::refused;
    wire::arena lists{memory_.lists};
    report_configuration report{};
    const auto read = wire::decode(report, body, lists);
    if (!read) return read.error() == wire::errc::arena_full ? message_outcome::refused : message_outcome::malformed;
    const duration timeout = options_.survey > duration{}
                                 ? saturating_add(saturating_add(options_.survey, options_.survey), options_.survey)
                                 : duration::max();
    bool all = true;
    for (const configured_node& node : report.node)
        for (const auto& [component, instance] : node.component) {
            const address who{instance, component, node.node_id, from.subsystem};
            if (who.node != from.node || who == from || !names_one_component(who)) continue;
            all = remember(who, now, timeout) != heard::no_capacity && all;
        }
    return done(all);
}

JAUSCAT_FUNCTION message_outcome node_manager::identify(query_type whose, const header& head,
                                                        std::span<const std::byte> body, message_sink out) noexcept {
    const auto with = [&](const identity& name) {
        return done(answer(head, self_, described_component::identification(whose, name), out).has_value());
    };
    switch (whose) {
    case query_type::system_identification: return with(description_.system);
    case query_type::subsystem_identification: return with(description_.subsystem);
    case query_type::node_identification: return with(description_.node);
    default: return own_.on_message(head, body, {}, out);
    }
}

JAUSCAT_FUNCTION std::span<const configured_component>
node_manager::most_of_node(std::span<configured_component> of_node) const noexcept {
    constexpr std::size_t most = 255;
    if (of_node.size() <= most) return of_node;
    std::partition(of_node.begin(), of_node.end(), [&](const configured_component& one) {
        return std::ranges::find(description_.components, one) != description_.components.end();
    });
    const auto listed = of_node.first(most);
    std::ranges::sort(listed, {}, [](const auto& one) { return std::pair{one.component_id, one.instance_id}; });
    return listed;
}

JAUSCAT_FUNCTION message_outcome node_manager::report_subsystems(const header& head, message_sink out) noexcept {
    wire::arena lists{memory_.lists};
    const auto all = collect(
        lists, [&](const address& who) { return who.subsystem != self_.subsystem; },
        [this](const address& who) {
            return std::tuple{who.subsystem, who != self_,  !is_node_manager(who),
                              who.node,      who.component, who.instance};
        });
    auto* const subsystems = lists.allocate<listed_subsystem>(all.size());
    if (all.empty() || subsystems == nullptr) return message_outcome::refused;
    std::size_t count = 0;
    for (const address& who : all)
        if (count == 0 || subsystems[count - 1].subsystem_id != who.subsystem)
            subsystems[count++] = {who.subsystem, who.node, who.component, who.instance};
    const report_subsystem_list report{std::span<const listed_subsystem>{subsystems, count}};
    return done(answer(head, self_, report, memory_.report, out).has_value());
}

} // namespace jauscat::jaus
