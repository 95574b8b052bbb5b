// A bridge: its components, and their start and end.
#pragma once
#include <jauscat/app/impl/bridge_state.hpp>
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/net/node/detail/configured_identity.hpp>
#include <jauscat/schema/translation/command_ranks.hpp>

#include <boost/asio/post.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

inline void slave_messages::list_messages(auto&& takes, auto&& sends) const {
    constexpr std::uint32_t all_fields = 0xFFFF'FFFF;
    if (part != nullptr)
        for (const auto code : translation::ra_command_codes) {
            if (!part->takes(code)) continue;
            takes(jaus::supported_message{code, all_fields});
            if (const auto report = jaus::report_code_of(code); report != 0)
                sends(jaus::supported_message{report, all_fields});
        }
    if (part != nullptr) return;
    takes(jaus::supported_message{jaus::command_code_of<jaus::set_wrench_effort>,
                                  jaus::presence_bits_of<jaus::set_wrench_effort>});
    takes(jaus::supported_message{jaus::command_code_of<jaus::query_wrench_effort>,
                                  jaus::presence_bits_of<jaus::query_wrench_effort>});
    sends(jaus::supported_message{jaus::command_code_of<jaus::report_wrench_effort>,
                                  jaus::presence_bits_of<jaus::report_wrench_effort>});
}

constexpr std::uint8_t primitive_driver = 33;

/// The times of the ring.
inline bridging::bridge_options timing_of(const bridge_options& options) {
    using std::chrono::milliseconds;
    const auto period = options.period;
    const bool cycles = period > duration{};
    const duration longest = cycles ? milliseconds{6500} : milliseconds{60'000};
    if (period < duration{}) throw std::invalid_argument{"bridge: the period is negative"};
    if (period > longest / 4) throw std::invalid_argument{"bridge: the period is at most 1.625 s"};
    const duration usual =
        std::max<duration>(cycles ? bridging::at_rest_in_cycles : bridging::at_rest_by_mailbox, 4 * period);
    const duration limit = options.at_rest_within == duration{} ? usual : options.at_rest_within;
    if (limit < milliseconds{20} || limit > longest)
        throw std::invalid_argument{"bridge: at_rest_within is 20 ms to 60 s, with process data to 6.5 s"};
    if (limit < 4 * period) throw std::invalid_argument{"bridge: at_rest_within is at least 4 periods"};
    return bridging::at_rest_within(limit, period);
}

JAUSCAT_DECL bridge_state::bridge_state(node_state& of, std::shared_ptr<bus_state> on, exchange_maker make,
                                        const bridge_options& options)
    : node_{of}, bus_{std::move(on)}, make_{make}, options_{options}, timing_{timing_of(options)} {
    if (&node_.context() != &bus_->context())
        throw std::invalid_argument{"bridge: node and bus have different io_contexts"};
    bus_->add_timing(timing_);
}

JAUSCAT_DECL void bridge_state::serve(const served_component& component, std::span<const slave_choice> by,
                                      std::unique_ptr<bridging::process_part> part) {
    if (is_closed_) throw std::logic_error{"bridge: its node has ended"};
    auto self = node_.net().manager();
    self.component = component.component;
    self.instance = component.instance;
    if (node_.net().running())
        throw std::logic_error{"the component " + net::to_jausip(self) + " is served after the start of its node"};
    if (!jaus::names_one_component(self))
        throw std::invalid_argument{"component ID and instance are 1 to 254, not " + net::to_jausip(self)};
    if (node_.has(self)) throw std::invalid_argument{"the node has a component " + net::to_jausip(self) + " already"};
    const bool cycles = options_.period > duration{};
    if (part && !cycles) throw std::invalid_argument{"bridge: process data need a period in the bridge's options"};
    if (part)
        if (const auto why = part->use_times({options_.period, timing_.rest_limit, timing_.ramp_limit}); !why.empty())
            throw std::invalid_argument{"bridge: " + std::string{why}};
    if (by.empty() || by.size() > bridging::group_capacity)
        throw std::invalid_argument{"bridge: a component has 1 to " + std::to_string(bridging::group_capacity) +
                                    " slaves"};
    if (by.size() > 1 && (!part || part->uses_mailbox()))
        throw std::invalid_argument{"bridge: a component with several slaves needs process data for all its messages"};
    for (auto each = by.begin(); each != by.end(); ++each)
        if (std::find(by.begin(), each, *each) != each)
            throw std::invalid_argument{"bridge: a slave stands in a group twice"};
    const slave_messages messages{part.get()};
    if (!part && cycles && self.component == primitive_driver) part = make_wrench_effort_part();
    std::vector<served_slave*> slaves;
    for (const auto& each : by) slaves.push_back(&slave_of(each));
    for (const auto* const each : slaves) each->check_place();
    auto& added = components_.emplace_back(self, component, *bus_, slaves, std::move(part), messages);
    node_.net().add(added, added.messages);
    for (auto* const each : slaves) each->add(added);
}
JAUSCAT_DECL served_slave& bridge_state::slave_of(const slave_choice& which) {
    const auto known = std::ranges::find(slaves_, which, &served_slave::choice);
    if (known != slaves_.end()) return *known;
    const auto& self = node_.net().manager();
    const auto station = bus_->reserve_station(self.node);
    auto exchange = make_({.subsystem = self.subsystem, .station = station});
    if (station != self.node)
        exchange =
            std::make_unique<renumbered_exchange>(std::move(exchange), self.node, static_cast<std::uint8_t>(station));
    return slaves_.emplace_back(*this, which, std::move(exchange), station);
}

JAUSCAT_DECL node_part bridge_state::as_part() {
    using jaus::bound;
    return {.owner = shared_from_this(),
            .start = bound<&bridge_state::start>(*this),
            .stop = bound<&bridge_state::stop>(*this),
            .end = bound<&bridge_state::close>(*this),
            .has = bound<&bridge_state::has>(*this),
            .list = bound<&bridge_state::list>(*this)};
}
JAUSCAT_DECL void bridge_state::list(std::vector<component_status>& all) const {
    const auto locked = bus_->lock();
    for (const auto& one : components_) {
        component_status made{.id = one.self(), .is_own = true};
        if (one.unit) {
            made.state = one.unit->state();
            if (const auto& by = one.unit->control().controller()) {
                made.controller = by->address;
                made.authority = by->authority_code;
            }
        }
        all.push_back(std::move(made));
    }
}
JAUSCAT_DECL void bridge_state::start() {
    const auto locked = bus_->lock();
    if (is_closed_) return;
    ended_at_rest_.reset();
    for (auto& each : slaves_) each.start();
    for (auto& each : components_) each.start(*this);
    for (auto& each : slaves_) each.find();
}
JAUSCAT_DECL void bridge_state::stop() noexcept {
    auto locked = bus_->lock();
    try {
        std::vector<bus_user*> served;
        std::vector<served_slave*> moving;
        for (auto& each : slaves_)
            if (each.is_served()) served.push_back(&each);
        for (auto& each : slaves_)
            if (each.may_move()) moving.push_back(&each);
        bus_->bring_to_rest(served);
        note_rest(true);
        for (auto* const each : moving) note_rest(each->check_rest());
    } catch (...) { // of the log, or no memory: what is not known is not confirmed
        note_rest(false);
    }
    for (auto& each : slaves_) each.leave();
    for (auto& each : components_) each.unit.reset();
    for (auto& each : slaves_) each.stop();
    locked.unlock();
    try {
        flush();
    } catch (...) { // of the application's log
    }
}
JAUSCAT_DECL void bridge_state::close() noexcept {
    if (is_closed_) return;
    stop();
    const auto locked = bus_->lock();
    is_closed_ = true;
    for (const auto& each : slaves_) bus_->release_station(each.station());
    bus_->release_timing(timing_);
    on_up = nullptr;
    on_lost = nullptr;
    on_changed = nullptr;
    on_at_rest = nullptr;
    on_emergency = nullptr;
    on_faulted = nullptr;
    on_fault_ended = nullptr;
}
JAUSCAT_DECL bool bridge_state::has(const jaus::address& component) const {
    return std::ranges::any_of(components_, [&](const auto& each) { return each.self() == component; });
}
JAUSCAT_DECL bool bridge_state::at_rest() const noexcept {
    const auto locked = bus_->lock();
    if (ended_at_rest_) return *ended_at_rest_;
    return std::ranges::all_of(slaves_, [](const auto& each) { return each.at_rest(); });
}
JAUSCAT_DECL bool bridge_state::is_up() const noexcept {
    const auto locked = bus_->lock();
    return std::ranges::all_of(slaves_, [](const auto& each) { return each.is_up(); });
}

JAUSCAT_DECL void bridge_state::send(bytes message) {
    outbox_.emplace_back(message.begin(), message.end());
    if (outbox_.size() == 1)
        boost::asio::post(node_.context(), [weak = weak_from_this()] {
            if (const auto self = weak.lock()) self->flush();
        });
}
JAUSCAT_DECL void bridge_state::flush() {
    auto locked = bus_->lock();
    const auto messages = std::exchange(outbox_, {});
    locked.unlock();
    for (const auto& message : messages)
        if (node_.net().running()) node_.net().out()(message);
}
JAUSCAT_DECL void bridged_component::start(bridge_state& of) {
    if (unit) return;
    const auto identity =
        net::detail::identity_of(of.node().net().config(), self_, {.authority_code = options_.authority});
    const jaus::component_options options{.control = {.authority_code = identity.authority_code,
                                                      .timeout = of.timing().control_timeout,
                                                      .without_control = options_.without_control}};
    std::vector<bridging::slave_front*> fronts;
    for (auto* const each : slaves_) fronts.push_back(&each->front());
    if (part_)
        unit.emplace(self_, fronts, *part_, options);
    else
        unit.emplace(self_, *fronts.front(), options);
}

// ---- A slave whose station address is not the number of the node.

JAUSCAT_DECL bridging::exchange_step renumbered_exchange::begin(bytes message, std::span<std::byte> buffer) {
    message_.assign(message.begin(), message.end());
    jaus::header head{};
    if (wire::decode_prefix(head, message)) {
        if (head.destination.node == node_) head.destination.node = station_;
        static_cast<void>(wire::encode(head, message_));
    }
    return under_->begin(message_, buffer);
}
JAUSCAT_DECL bridging::exchange_step renumbered_exchange::on_confirmation(bytes confirmation,
                                                                          std::span<std::byte> buffer) {
    const auto step = under_->on_confirmation(confirmation, buffer);
    jaus::header head{};
    if (step.what == bridging::exchange_progress::done && step.size != 0 && wire::decode_prefix(head, buffer)) {
        head.source.node = node_; // of a report
        static_cast<void>(wire::encode(head, buffer));
    }
    return step;
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
