// The live view of a node and its bus.
#pragma once
#include "support/live_view.hpp"
#include <jauscat/app/bus.hpp>
#include <jauscat/app/component_status.hpp>
#include <jauscat/app/node_options.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/text/value.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace example {

/// Has `feed` get the messages, too; nullptr: nothing.
inline jauscat::node_options watched(jauscat::node_options options, jauscat::net::live_feed* feed) {
    using jauscat::net::live_way;
    if (feed == nullptr) return options;
    options.on_received = [feed, more = std::move(options.on_received)](const auto& component, const auto& head,
                                                                        auto body) {
        feed->message(live_way::received, head, body);
        if (more) more(component, head, body);
    };
    options.on_sent = [feed, more = std::move(options.on_sent)](std::span<const std::byte> message) {
        feed->message(live_way::sent, message);
        if (more) more(message);
    };
    return options;
}

inline std::vector<jauscat::net::live_system> live_systems(const jauscat::net::jaus_config& config,
                                                           std::span<const jauscat::component_status> components) {
    std::vector<jauscat::net::live_system> all;
    for (const auto& system : config.systems) {
        const auto& id = system.jausip;
        const auto covers = [&](const jauscat::component_status& one) {
            return one.id.subsystem == id.subsystem && (id.node == 0 || one.id.node == id.node) &&
                   (id.component == 0 || one.id.component == id.component);
        };
        if (system.has_ra)
            all.push_back({.subsystem = id.subsystem,
                           .name = system.name,
                           .address = jauscat::net::detail::text(system.endpoint()),
                           .is_alive = std::ranges::any_of(components, covers)});
        else if (system.sae)
            all.push_back({.subsystem = system.sae->id.subsystem, .name = system.name, .is_sae = true});
    }
    return all;
}
inline std::vector<jauscat::net::live_component>
live_components(std::span<const jauscat::component_status> components) {
    std::vector<jauscat::net::live_component> all;
    for (const auto& one : components)
        all.push_back({.id = one.id,
                       .is_own = one.is_own,
                       .name = one.name,
                       .state = one.state ? jauscat::text::to_text(*one.state) : std::string{},
                       .controller = one.controller,
                       .authority = one.authority,
                       .age = one.age});
    return all;
}
/// The error counters of the slaves of a bus. Each slave is asked at most once a second.
class live_errors {
  public:
    /// `bus` must outlive it.
    explicit live_errors(const jauscat::bus& bus) : bus_{bus} {}

    /// To be called ten times a second, while a viewer is there.
    void ask(std::span<const jauscat::slave_status> slaves) {
        const std::size_t turn = calls_++ % std::max(calls_of_second, slaves.size());
        if (turn >= slaves.size() || known_->is_asking) return;
        const auto position = slaves[turn].info.position;
        if (!slaves[turn].is_in_service) { // an operation would begin to look for it
            known_->of.erase(position);
            return;
        }
        known_->is_asking = true;
        bus_.slave({.position = position})
            .async_error_counters([known = known_, position](auto error, const auto& counted) {
                known->is_asking = false;
                if (error)
                    known->of.erase(position);
                else
                    known->of[position] = sums_of(counted);
            });
    }
    [[nodiscard]] std::optional<jauscat::net::live_slave_errors> of(std::uint16_t position) const {
        const auto found = known_->of.find(position);
        if (found == known_->of.end()) return {};
        return found->second;
    }

  private:
    static constexpr std::size_t calls_of_second = 10;
    /// Is left to an operation that outlives this.
    struct known {
        bool is_asking{};
        std::map<std::uint16_t, jauscat::net::live_slave_errors> of{};
    };
    static jauscat::net::live_slave_errors sums_of(const jauscat::ethercat::error_counters& counted) {
        jauscat::net::live_slave_errors made{};
        for (const auto& port : counted.ports) made.invalid_frames += port.invalid_frames;
        for (const unsigned count : counted.forwarded_errors) made.forwarded += count;
        for (const unsigned count : counted.lost_links) made.lost_links += count;
        return made;
    }

    const jauscat::bus& bus_;
    std::shared_ptr<known> known_{std::make_shared<known>()};
    std::size_t calls_{};
};
inline jauscat::net::live_bus live_bus_of(std::string name, const jauscat::bus_statistics& counts,
                                          std::span<const jauscat::slave_status> slaves, const live_errors& errors) {
    using jauscat::ethercat::al_state;
    jauscat::net::live_bus made{.name = std::move(name),
                                .period = counts.period,
                                .cycles = counts.cycles,
                                .working_counter = counts.working_counter,
                                .expected_working_counter = counts.expected_working_counter,
                                .wrong_working_counters = counts.incomplete,
                                .frames_lost = counts.lost};
    if (counts.clocks) {
        const auto& clocks = *counts.clocks;
        made.clock = {.reference = jauscat::text::hex_word(clocks.reference),
                      .offset_ns = std::chrono::nanoseconds{clocks.error}.count(),
                      .is_in_step = clocks.is_locked};
    }
    if (counts.period > jauscat::duration{}) {
        made.lateness_limits_us.assign(counts.late_limits.begin(), counts.late_limits.end());
        made.lateness_counts.assign(counts.late_cycles.begin(), counts.late_cycles.end());
    }
    const auto text = [](const std::optional<al_state>& state) {
        return state ? std::string{jauscat::text::enumerator_name(*state)} : std::string{};
    };
    std::optional<al_state> lowest;
    for (const auto& one : slaves) {
        const auto& info = one.info;
        if (one.state && (!lowest || *one.state < *lowest)) lowest = one.state;
        made.slaves.push_back({.position = info.position,
                               .station = info.station,
                               .name = !info.configured_name.empty() ? info.configured_name : info.name,
                               .state = text(one.state),
                               .wanted = text(one.wanted),
                               .al_status = one.problem,
                               .errors = errors.of(info.position),
                               .is_in_service = one.is_in_service,
                               .is_at_rest = one.is_at_rest});
    }
    made.state = text(lowest);
    return made;
}

/// Gives a feed the state of a node ten times a second, while a viewer is there.
class live_reporter {
  public:
    using maker = std::function<jauscat::net::live_state()>;

    /// `feed`: nullptr: none. `make` is called by the io_context, which must outlive this.
    live_reporter(boost::asio::io_context& context, jauscat::net::live_feed* feed, maker make)
        : timer_{context}, feed_{feed}, make_{std::move(make)} {
        if (feed_ != nullptr) wait();
    }

  private:
    void wait() {
        timer_.expires_after(std::chrono::milliseconds{100});
        timer_.async_wait([this](boost::system::error_code error) {
            if (error) return;
            if (feed_->is_watched()) feed_->set_state(make_());
            wait();
        });
    }

    boost::asio::steady_timer timer_;
    jauscat::net::live_feed* feed_;
    maker make_;
};

} // namespace example
