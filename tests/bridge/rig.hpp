// A bridge between an operator's messages and a chain of emulated slaves, in simulated time.
#pragma once
#include "actuator.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/ring.hpp>
#include <jauscat/bridge/wrench_effort_part.hpp>
#include <jauscat/ethercat/slave/slave_tree.hpp>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace test {

using namespace std::chrono_literals;
namespace bridging = jauscat::bridging;
using bytes = std::span<const std::byte>;

/// Records the bridge's events.
struct notes {
    unsigned up{}, lost{}, settled_debts{}, stops_refused{}, failed_bring_ups{}, ended_faults{};
    std::vector<std::uint16_t> merged_numbers{};
    std::vector<bridging::drive_fault> faults{};
    std::optional<bridging::loss> last_loss{};
    std::vector<bridging::refusal> refusals{};
    std::vector<bridging::stop_cause> stop_causes{};
    std::vector<std::uint16_t> emergencies{};
    std::vector<ethercat::clock_agreement> agreements{};

    void slave_up(const bridging::slave_front&, const ethercat::slave_record&, bool ready) { up += ready; }
    void bring_up_failed(const bridging::slave_front&, const ethercat::master_error&) { ++failed_bring_ups; }
    void slave_lost(const bridging::slave_front&, bridging::loss what, const ethercat::master_error&) {
        ++lost;
        last_loss = what;
    }
    void slave_emergency(const bridging::slave_front&, const ethercat::coe_emergency& what) {
        emergencies.push_back(what.error_code);
    }
    void clocks_agree(const bridging::slave_front&, ethercat::clock_agreement how, std::uint32_t) {
        agreements.push_back(how);
    }
    void settled(const bridging::component&) { ++settled_debts; }
    void stop_required(const bridging::component&, bridging::stop_order, bridging::stop_cause why) {
        stop_causes.push_back(why);
    }
    void stop_refused(const bridging::component&, bridging::stop_order, const bridging::refusal_reason&, unsigned) {
        ++stops_refused;
    }
    void faulted(const bridging::component&, const bridging::drive_fault& what) { faults.push_back(what); }
    void fault_ended(const bridging::component&) { ++ended_faults; }
    void merged(const bridging::component&, const jaus::header& message) {
        merged_numbers.push_back(message.sequence_number);
    }
    void refused(const bridging::component&, const jaus::header&, const bridging::refusal_reason& why) {
        refusals.push_back(why.why);
    }
    bridging::observer observer() {
        return {.slave_up = jaus::bound<&notes::slave_up>(*this),
                .bring_up_failed = jaus::bound<&notes::bring_up_failed>(*this),
                .slave_lost = jaus::bound<&notes::slave_lost>(*this),
                .slave_emergency = jaus::bound<&notes::slave_emergency>(*this),
                .clocks_agree = jaus::bound<&notes::clocks_agree>(*this),
                .stop_required = jaus::bound<&notes::stop_required>(*this),
                .stop_refused = jaus::bound<&notes::stop_refused>(*this),
                .settled = jaus::bound<&notes::settled>(*this),
                .faulted = jaus::bound<&notes::faulted>(*this),
                .fault_ended = jaus::bound<&notes::fault_ended>(*this),
                .merged = jaus::bound<&notes::merged>(*this),
                .refused = jaus::bound<&notes::refused>(*this)};
    }
};

/// Translates by the actuator's table, as if it had no object for one message.
class partial_exchange final : public bridging::any_exchange {
  public:
    std::uint16_t lacks{}; ///< its code; 0: none

    explicit partial_exchange(const bridging::slave_identity& slave) : whole_{slave} {}

    bridging::exchange_step begin(bytes message, std::span<std::byte> buffer) override {
        is_lacking_ = lacks != 0 && jaus::split(message).header.command_code == lacks;
        return is_lacking_ ? bridging::exchange_step{bridging::exchange_progress::failed, 0}
                           : whole_.begin(message, buffer);
    }
    bridging::exchange_step on_confirmation(bytes confirmation, std::span<std::byte> buffer) override {
        return whole_.on_confirmation(confirmation, buffer);
    }
    [[nodiscard]] jauscat::hilscher::packet_status status() const override { return whole_.status(); }
    [[nodiscard]] jauscat::translate::errc error() const override {
        return is_lacking_ ? jauscat::translate::errc::unknown_index : whole_.error();
    }

  private:
    bridging::exchange_under<actuator::table> whole_;
    bool is_lacking_{};
};

/// One operator, one ring. Each frame takes `round_trip`; a cable that is out loses it.
class rig {
  public:
    static constexpr jaus::address operator_unit{.instance = 1, .component = 32, .node = 1, .subsystem = 1};
    static constexpr jaus::address stranger{.instance = 1, .component = 32, .node = 1, .subsystem = 3};

    /// With `groups` each part has a unit in front of its share of the slaves: 2.2.33.1, 2.3.33.1, ...
    /// With `has_clocks` they are to have SYNC signals; `without_clock` cannot.
    explicit rig(std::size_t slaves = 1, bool cyclic = false, const std::vector<bridging::process_part*>& groups = {},
                 bool has_clocks = false, std::size_t without_clock = 1000)
        : options{cyclic ? bridging::at_rest_within(bridging::at_rest_in_cycles, 10ms)
                         : bridging::at_rest_within(bridging::at_rest_by_mailbox)} {
        for (std::size_t i = 0; i != slaves; ++i) {
            const auto station = static_cast<std::uint16_t>(2 + i);
            actuators.emplace_back(std::uint8_t{2}, station,
                                   has_clocks && i != without_clock ? ethercat::clock_width::bits_64
                                                                    : ethercat::clock_width::no_clock);
            memories_.emplace_back();
            exchanges.emplace_back(bridging::slave_identity{.subsystem = 2, .station = station});
            fronts.emplace_back(bridging::slave_options{.position = static_cast<std::uint16_t>(i),
                                                        .identity = {.subsystem = 2, .station = station},
                                                        .cyclic = cyclic,
                                                        .sync = has_clocks ? sync0 : ethercat::sync_settings{}},
                                exchanges.back(), options, memories_.back(), watcher.observer());
            REQUIRE(bus.add(fronts.back()));
            if (!groups.empty()) continue;
            if (cyclic)
                units.emplace_back(unit_address(i), fronts.back(), process_parts.emplace_back(), core_options);
            else
                units.emplace_back(unit_address(i), fronts.back(), core_options);
        }
        for (std::size_t i = 0; i != groups.size(); ++i) {
            std::vector<bridging::slave_front*> share;
            for (std::size_t k = 0; k != slaves / groups.size(); ++k)
                share.push_back(&fronts[i * slaves / groups.size() + k]);
            units.emplace_back(unit_address(i), share, *groups[i], core_options);
        }
    }

    /// One slave, whose component is ready.
    struct ready {};
    explicit rig(ready) : rig{} { run_until_ready(); }
    /// One slave, driven by the operator: by mailbox, or in cycles.
    struct driving {
        double percent;
        bool cyclic{};
    };
    explicit rig(driving at) : rig{1, at.cyclic} {
        run_until_ready();
        run_until_acknowledged(drive(at.percent));
    }
    /// One slave in an emergency.
    struct stopped {};
    explicit rig(stopped) : rig{ready{}} { run_until_acknowledged(tell(stop())); }

    static constexpr ethercat::sync_settings sync0{.assign_activate = 0x0300};
    static jaus::address unit_address(std::size_t i) {
        return {.instance = 1, .component = 33, .node = static_cast<std::uint8_t>(2 + i), .subsystem = 2};
    }
    /// One more component in front of a slave. Its index.
    std::size_t add_unit(std::size_t slave, std::uint8_t component) {
        auto address = unit_address(slave);
        address.component = component;
        units.emplace_back(address, fronts[slave], core_options);
        return units.size() - 1;
    }
    bridging::component& unit(std::size_t i = 0) { return units[i]; }
    actuator& motor(std::size_t i = 0) { return actuators[i].behind; }

    /// Time passes: frames, events, messages.
    void run(std::chrono::nanoseconds duration) {
        const auto end = now + duration;
        while (now < end) step(end);
    }
    /// Until `done()`, at most for `limit`; how long it took.
    std::chrono::nanoseconds run_until(auto&& done, std::chrono::nanoseconds limit = 20s) {
        const auto begun = now;
        while (!done() && now - begun < limit) step(begun + limit);
        INFO("still not after " << limit.count() / 1'000'000 << " ms");
        REQUIRE(done());
        return now - begun;
    }
    void run_until_ready() {
        run_until([&] {
            return std::ranges::all_of(units, [](const auto& each) {
                return each.state() == jaus::primary_status_code::ready && each.stops().settled();
            });
        });
    }

    std::chrono::nanoseconds run_until_acknowledged(std::uint16_t number, std::chrono::nanoseconds limit = 20s) {
        return run_until([&] { return is_acknowledged(number); }, limit);
    }
    /// Until the loss of the slaves is noticed.
    void pull_cable() {
        cable_is_out = true;
        run_until([&, before = watcher.lost] { return watcher.lost != before; });
    }

    /// A message from `source` to the unit; returns its sequence number.
    template <class T>
    std::uint16_t tell(const T& body, std::size_t to = 0, jaus::ack_nak ack = jaus::ack_nak::request,
                       const jaus::address& source = operator_unit) {
        ++number_;
        repeat(body, number_, to, ack, source);
        return number_;
    }
    template <class T>
    void repeat(const T& body, std::uint16_t number, std::size_t to = 0, jaus::ack_nak ack = jaus::ack_nak::request,
                const jaus::address& source = operator_unit) {
        const jaus::header head{.ack_nak = ack,
                                .command_code = jaus::command_code_of<T>,
                                .destination = units[to].self(),
                                .source = source,
                                .sequence_number = number};
        std::array<std::byte, 1532> buffer{};
        const auto encoded = jauscat::wire::encode(body, buffer);
        REQUIRE(encoded);
        last_outcome = units[to].on_message(
            head, *encoded, now, out_, [](const jaus::header&, bytes) { return jaus::message_outcome::unhandled; });
        bus.on_time(now, out_);
    }
    std::uint16_t drive(double percent, std::size_t to = 0, jaus::ack_nak ack = jaus::ack_nak::request) {
        return tell(jaus::set_wrench_effort{.propulsive_linear_effort_x = percent}, to, ack);
    }
    static jaus::set_emergency stop() {
        jaus::set_emergency message{};
        message.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
        return message;
    }
    static jaus::clear_emergency clear() {
        jaus::clear_emergency message{};
        message.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
        return message;
    }
    /// The answer to the message of this number, if one has come.
    [[nodiscard]] std::optional<jaus::ack_nak> answer(std::uint16_t number) const {
        for (const auto& message : messages) {
            const auto head = jaus::split(message).header;
            if (jaus::is_acknowledgement(head) && head.sequence_number == number) return head.ack_nak;
        }
        return std::nullopt;
    }
    bool is_acknowledged(std::uint16_t number) const { return answer(number) == jaus::ack_nak::ack; }
    bool is_refused(std::uint16_t number) const { return answer(number) == jaus::ack_nak::nak; }
    /// Messages of this type that were sent.
    template <class T> [[nodiscard]] std::vector<T> received() const {
        std::vector<T> all;
        for (const auto& message : messages) {
            const auto parts = jaus::split(message);
            T body{};
            if (!jaus::is_acknowledgement(parts.header) && parts.header.command_code == jaus::command_code_of<T> &&
                jauscat::wire::decode(body, parts.body))
                all.push_back(body);
        }
        return all;
    }
    void lose(const jaus::address& who) {
        for (auto& each : units) each.on_lost(who);
        for (auto& each : units) each.on_time(now, out_);
        bus.on_time(now, out_);
    }
    void shut_down() { bus.shut_down(now, out_); }

    bridging::bridge_options options;
    jaus::component_options core_options{};
    notes watcher{};
    std::deque<emulated_actuator> actuators{};
    std::deque<partial_exchange> exchanges{};
    std::deque<bridging::slave_front> fronts{};
    std::deque<bridging::wrench_effort_part> process_parts{};
    std::deque<bridging::component> units{};
    bridging::ring_for<256, 16384, 16, 64> bus{options};
    std::vector<std::vector<std::byte>> messages{};
    jaus::component_outcome last_outcome{};
    jauscat::time_point now{1s};
    std::chrono::nanoseconds round_trip{200us};
    bool cable_is_out{};
    std::optional<ethercat::slave_tree> wires{};       ///< that frames pass, if they are not next to one another
    std::size_t dead_from{1000};                       ///< slaves from here on do not get frames
    unsigned frames_to_lose{};                         ///< the next frames
    std::function<bool(std::span<std::byte>)> takes{}; ///< the link takes a frame; empty: all
    std::function<void(std::span<std::byte>)> on_way_back{};
    std::uint64_t frames{};

  private:
    struct flight {
        std::vector<std::byte> frame;
        jauscat::time_point at;
    };

    void step(jauscat::time_point limit) {
        std::array<std::byte, ethercat::max_frame_size> frame{};
        while (const auto size = bus.next_frame(frame, now)) {
            const auto next = std::span{frame}.first(size);
            if (takes && !takes(next))
                bus.not_sent();
            else
                send(next);
        }
        auto next = limit;
        if (const auto event = bus.next_event()) next = std::min(next, *event);
        for (auto& each : units)
            if (const auto event = each.next_event()) next = std::min(next, *event);
        for (const auto& each : flights_) next = std::min(next, each.at);
        now = std::max(now + 1us, next); // a node's wake-up takes time, and nothing here may stand still
        const auto is_back = [&](const flight& each) { return each.at <= now; };
        for (auto at = flights_.begin(); (at = std::ranges::find_if(flights_, is_back)) != flights_.end();) {
            const auto back = std::move(at->frame);
            flights_.erase(at);
            bus.on_frame(back, now, out_);
        }
        for (auto& each : actuators) each.on_time(now);
        for (auto& each : units) each.on_time(now, out_);
        bus.on_time(now, out_);
    }
    void send(std::span<std::byte> frame) {
        ++frames;
        if (cable_is_out) return;
        if (frames_to_lose != 0) {
            --frames_to_lose;
            return;
        }
        if (wires)
            wires->pass(frame, now);
        else
            for (std::size_t i = 0; i != actuators.size() && i < dead_from; ++i) actuators[i].pass(frame, now);
        if (on_way_back) on_way_back(frame);
        flights_.push_back({{frame.begin(), frame.end()}, now + round_trip});
    }
    void take(bytes message) { messages.emplace_back(message.begin(), message.end()); }

    struct sink {
        rig& mine;
        void operator()(bytes message) const { mine.take(message); }
    };
    sink sink_{*this};
    jaus::message_sink out_{sink_};
    std::deque<flight> flights_{};
    std::deque<bridging::order_memory<16, 1532>> memories_{};
    std::uint16_t number_{100};
};

} // namespace test
