#include "simulation/bridge_program.hpp"

#include "simulation/joint_parts.hpp"
#include <jauscat/text/master_error_text.hpp>

namespace simulation {
namespace {

using std::chrono::milliseconds;

constexpr auto nothing_more = [](const jaus::header&, bytes) { return jaus::message_outcome::unhandled; };

/// What a queue, a merge or a choice did to a command.
const char* text_of(bridging::refusal why) {
    using enum bridging::refusal;
    switch (why) {
    case slave_down: return "the slave is lost";
    case queue_full: return "the queue of the slave is full";
    case too_large: return "it is too large";
    case expired: return "it has waited in the queue for too long";
    case superseded: return "a newer command of the same sender has replaced it";
    case stopped: return "a stop order or a change of control came before it";
    case not_translated: return "it has no translation";
    case by_slave: return "the slave or the master has refused it";
    case not_accepted: return "the slave has not executed it in time";
    case stale: return "the inputs of the slave are too old";
    }
    return "of an unknown cause";
}

const char* text_of(bridging::stop_cause why) {
    using enum bridging::stop_cause;
    switch (why) {
    case state: return "the component has left Ready";
    case controller_lost: return "its controller is lost";
    case control_taken: return "it has got another controller, and a command of the one before waits";
    case sender_lost: return "the sender of its command is lost";
    case slave_absent: return "its slave is lost";
    case slave_returned: return "its slave is there";
    case not_accepted: return "its slave has not executed a command in time";
    case drive_fault: return "its drive has a fault";
    case program_ends: return "the program ends";
    }
    return "of an unknown cause";
}
const char* text_of(bridging::loss why) {
    using enum bridging::loss;
    switch (why) {
    case no_answer: return "it does not answer";
    case no_station: return "nobody answers at its station address";
    case left_state: return "it has left its state";
    case no_process_data: return "it takes no part in the process data";
    }
    return "of an unknown cause";
}

std::string reason_text(const bridging::refusal_reason& why) {
    return std::string{text_of(why.why)} + ": " + jauscat::text::explain(why.of_master);
}

jaus::address unit_id(const place& at) {
    return {.instance = 1, .component = 33, .node = at.jausip.node, .subsystem = at.jausip.subsystem};
}

} // namespace

/// A component, its slaves and its node.
struct bridge_program::unit {
    unit(bridge_program& program, std::size_t i, const bridging::observer& watcher)
        : what{program.settings_.units[i]},
          options{program.settings_.options(what)},
          part{what.axes != 0 ? make_joint_part(what.joints(), what.axes) : nullptr},
          component{make_component(program, i, watcher)},
          watched{component, nothing_more},
          node{configuration_of(program.places_, i),
               {},
               [&program, i](bytes message, const net::node_machine::endpoint& to, jaus::framing) {
                   program.does("a message of a node");
                   program.network_.send(static_cast<std::uint8_t>(i), port_of(to), message, 0);
               },
               program.random_.next()} {
        node.add(watched, nothing_more);
    }

    bridging::component make_component(bridge_program& program, std::size_t i, const bridging::observer& watcher) {
        for (const std::size_t slave : what.slaves) {
            const bridging::slave_identity identity{.subsystem = arm_unit::subsystem,
                                                    .station = program.wire_[slave].station};
            bridging::slave_options made{
                .position = static_cast<std::uint16_t>(slave), .identity = identity, .cyclic = what.cyclic};
            if (program.settings_.has_clocks && what.axes != 0) made.sync.assign_activate = 0x0300;
            if (program.settings_.checks_serials) made.expected.serial = ring::serial_of(slave);
            exchanges.emplace_back(identity);
            orders.emplace_back();
            fronts.emplace_back(made, exchanges.back(), options, orders.back(), watcher);
            fronts.back().on_work(program.on_work_);
            group.push_back(&fronts.back());
        }
        const auto id = unit_id(program.places_[i]);
        const jaus::component_options core{.control = {.timeout = options.control_timeout}};
        if (part) return bridging::component{id, group, *part, core};
        if (what.cyclic) return bridging::component{id, fronts.front(), efforts, core};
        return bridging::component{id, fronts.front(), core};
    }

    const unit_settings& what;
    bridging::bridge_options options;
    bridging::wrench_effort_part efforts{};
    std::unique_ptr<bridging::process_part> part;
    std::deque<bridging::exchange_under<bridge_table>> exchanges{};
    std::deque<bridging::order_memory<16, 256>> orders{};
    std::deque<bridging::slave_front> fronts{};
    std::vector<bridging::slave_front*> group{};
    bridging::component component;
    watched_component<bridging::component, const decltype(nothing_more)> watched;
    net::node_machine node;
    std::uint32_t current_message{};
    time stuck_since{};
};

/// What a life of the program has.
struct bridge_program::life_data {
    // The ring has the shortest times of all.
    explicit life_data(bridge_program& program)
        : mine{program},
          options{program.settings_.options(
              *std::ranges::min_element(program.settings_.units, {}, &unit_settings::limit))} {}
    void changed_state(const bridging::component& who, jaus::primary_status_code from, jaus::primary_status_code to) {
        mine.does(__func__);
        mine.model_.enters(account(who), from, to);
        judge(who).enters(from, to);
    }
    void changed_controller(const bridging::component& who, jaus::control_change why) {
        mine.does(__func__);
        const auto& now = who.control().controller();
        judge(who).controlled(now, why);
        orders(who).changed_controller(why);
        mine.model_.controlled(account(who), now ? std::optional{now->address} : std::nullopt);
    }
    void refused(const bridging::component& who, const jaus::header& message, const bridging::refusal_reason& why) {
        if (why.why == bridging::refusal::not_accepted) mine.has_more_ = true;
        mine.does(__func__);
        mine.model_.drops(account(who), message, text_of(why.why));
        orders(who).refused(message, why);
    }
    void merged(const bridging::component& who, const jaus::header& message) {
        mine.does(__func__);
        mine.model_.merges(account(who), message);
        orders(who).merged(message);
    }
    void stop_required(const bridging::component& who, bridging::stop_order what, bridging::stop_cause why) {
        mine.has_more_ = true;
        mine.does(__func__);
        tell({.what = deed::owes_stop,
              .who = number(who),
              .number = static_cast<std::uint16_t>(what),
              .why = text_of(why)});
        orders(who).stop_required(what, why);
    }
    void stop_refused(const bridging::component& who, bridging::stop_order what, const bridging::refusal_reason& why,
                      unsigned attempts) {
        mine.has_more_ = true;
        mine.does(__func__, reason_text(why));
        tell({.what = deed::stop_refused,
              .who = number(who),
              .number = static_cast<std::uint16_t>(what),
              .value = attempts});
        orders(who).stop_refused(what, why, attempts);
    }
    void settled(const bridging::component& who) {
        mine.has_more_ = true;
        mine.does(__func__);
        tell({.what = deed::settled, .who = number(who)});
        orders(who).settled();
    }
    void faulted(const bridging::component& who, const bridging::drive_fault& what) {
        mine.does(__func__, std::to_string(what.slave) + ": " + std::to_string(what.code) + std::string{what.reason});
        orders(who).faulted(what);
    }
    void fault_ended(const bridging::component& who) {
        mine.does(__func__);
        orders(who).fault_ended();
    }
    void bring_up_failed(const bridging::slave_front& slave, const ethercat::master_error& why) {
        mine.has_more_ = true;
        mine.does(__func__, jauscat::text::explain(why));
        orders(slave).bring_up_failed();
        judge(slave).failed(why, bus->bring_up_error(slave));
    }
    void slave_up(const bridging::slave_front& slave, const ethercat::slave_record& record, bool ready) {
        mine.has_more_ = true;
        mine.does(__func__, ready ? "ready" : "not ready");
        slaves_changed_at = mine.world_.now();
        judge(slave).up(record, ready, bus->bring_up_error(slave));
        if (!ready) return;
        tell({.what = deed::uses_slave, .who = mine.number(), .whom = number(slave)});
        orders(slave).slave_up(slave.options().position);
    }
    void slave_emergency(const bridging::slave_front& slave, const ethercat::coe_emergency& what) {
        mine.does(__func__);
        judge(slave).emergency(what);
    }
    void clocks_agree(const bridging::slave_front& slave, ethercat::clock_agreement how, std::uint32_t difference) {
        mine.does(__func__, std::to_string(static_cast<unsigned>(how)) + ": " + std::to_string(difference));
        judge(slave).agrees(how, difference);
    }
    void translated(const bridging::slave_front& slave, bytes packet) {
        mine.does(__func__);
        judge(slave).packet(packet, false);
    }
    void asks_report(const bridging::slave_front& slave, bytes packet) {
        mine.does(__func__);
        judge(slave).packet(packet, true);
    }
    void into_image(const bridging::slave_front& slave, std::uint32_t count, bytes outputs) {
        mine.does(__func__);
        judge(slave).into_image(count, outputs, slave.data().outputs);
    }
    void from_image(const bridging::slave_front& slave, bytes inputs) {
        mine.does(__func__);
        judge(slave).from_image(inputs, slave.data().inputs);
        orders(slave).reads_inputs();
    }
    void no_keep_alive(const bridging::slave_front& slave, const bridging::refusal_reason& why) {
        mine.does(__func__, reason_text(why));
        orders(slave).no_keep_alive();
        judge(slave).no_keep_alive(why);
    }
    void slave_lost(const bridging::slave_front& slave, bridging::loss what, const ethercat::master_error& why) {
        mine.has_more_ = true;
        mine.does(__func__, jauscat::text::explain(why));
        judge(slave).lost(what, why, bus->bring_up_error(slave));
        tell({.what = deed::loses_slave, .who = mine.number(), .whom = number(slave), .why = text_of(what)});
        slaves_changed_at = mine.world_.now();
        orders(slave).slave_lost(slave.options().position);
    }
    void tell(const happening& one) const { mine.world_.tell(one); }
    [[nodiscard]] std::uint8_t number(const bridging::component& who) const {
        return mine.model_.actuator(account(who)).number;
    }
    [[nodiscard]] std::uint8_t number(const bridging::slave_front& slave) const {
        return mine.wire_[slave.options().position].number;
    }
    [[nodiscard]] bridging::observer observer() {
        return {.slave_up = jaus::bound<&life_data::slave_up>(*this),
                .bring_up_failed = jaus::bound<&life_data::bring_up_failed>(*this),
                .slave_lost = jaus::bound<&life_data::slave_lost>(*this),
                .slave_emergency = jaus::bound<&life_data::slave_emergency>(*this),
                .clocks_agree = jaus::bound<&life_data::clocks_agree>(*this),
                .no_keep_alive = jaus::bound<&life_data::no_keep_alive>(*this),
                .changed_state = jaus::bound<&life_data::changed_state>(*this),
                .changed_controller = jaus::bound<&life_data::changed_controller>(*this),
                .stop_required = jaus::bound<&life_data::stop_required>(*this),
                .stop_refused = jaus::bound<&life_data::stop_refused>(*this),
                .settled = jaus::bound<&life_data::settled>(*this),
                .faulted = jaus::bound<&life_data::faulted>(*this),
                .fault_ended = jaus::bound<&life_data::fault_ended>(*this),
                .translated = jaus::bound<&life_data::translated>(*this),
                .asks_report = jaus::bound<&life_data::asks_report>(*this),
                .into_image = jaus::bound<&life_data::into_image>(*this),
                .merged = jaus::bound<&life_data::merged>(*this),
                .from_image = jaus::bound<&life_data::from_image>(*this),
                .refused = jaus::bound<&life_data::refused>(*this)};
    }
    [[nodiscard]] std::size_t index(const bridging::component& who) const {
        for (std::size_t i = 0; i != mine.accounts_.size(); ++i)
            if (unit_id(mine.places_[i]) == who.self()) return i;
        return 0;
    }
    [[nodiscard]] std::uint8_t account(const bridging::component& who) const { return mine.accounts_[index(who)]; }
    [[nodiscard]] component_judge& judge(const bridging::component& who) const { return *mine.judges_[index(who)]; }

    [[nodiscard]] slave_judge& judge(const bridging::slave_front& slave) const {
        return *mine.slaves_[slave.options().position];
    }
    [[nodiscard]] order_judge& orders(const bridging::component& who) const { return *mine.orders_[index(who)]; }
    [[nodiscard]] order_judge& orders(const bridging::slave_front& slave) const {
        const auto account = mine.places_of_slaves_[slave.options().position].first;
        const auto found = std::ranges::find(mine.accounts_, account);
        return *mine.orders_[static_cast<std::size_t>(found - mine.accounts_.begin())];
    }

    bridge_program& mine;
    bridging::bridge_options options;
    std::deque<unit> units{};
    void cycle() const {
        ++mine.cycles_of_others_;
        mine.does(__func__);
    }
    /// With fewer lanes, or without memory for steps of many slaves at once.
    [[nodiscard]] bridging::ring_memory some_memory() {
        auto made = memory.spans();
        made.lanes = made.lanes.first(mine.settings_.lanes);
        if (mine.settings_.is_one_by_one) {
            made.bring_ups = {};
            made.configurations = {};
            made.state_changes = {};
            made.positions = {};
        }
        return made;
    }
    bridging::ring_memory_for<16, 4096, bridge_settings::most_lanes, 16> memory{};
    std::optional<bridging::ring> bus{};
    bool ends{};
    time ends_since{}, slaves_changed_at{};
};

bridge_program::bridge_program(world& w, network& n, model& m, const std::vector<place>& places, ring& wire,
                               const bridge_settings& what)
    : process{w, n, "bridge"}, model_{m}, places_{places}, wire_{wire}, settings_{what}, idle_random_{w.stream(1013)} {
    if (what.is_shared) application_.emplace(w, wire, *this, number(), to_give_up);
    places_of_slaves_.resize(wire.size());
    for (std::size_t i = 0; i != what.units.size(); ++i) {
        const auto& one = what.units[i];
        if (i != 0) side_ports_.push_back(std::make_unique<side_port>(*this, n));
        accounts_.push_back(m.add_actuator(*this, unit_id(places[i]), wire[one.slaves.front()].number, one.limit));
        std::vector<axis_account> axes;
        for (const std::size_t slave : one.slaves) {
            places_of_slaves_[slave] = {accounts_.back(), axes.size()};
            for (std::size_t axis = 0; axis != std::max<std::size_t>(one.axes, 1); ++axis)
                axes.push_back({.slave = slave, .axis = axis});
        }
        judges_.push_back(
            std::make_unique<component_judge>(w, *this,
                                              judged_component{.id = unit_id(places[i]),
                                                               .number = m.actuator(accounts_.back()).number,
                                                               .timeout = what.options(one).control_timeout,
                                                               .remembered = 4096,
                                                               .has_slaves = true}));
        orders_.push_back(
            std::make_unique<order_judge>(w, m, *this,
                                          judged_orders{.account = accounts_.back(),
                                                        .slaves = one.slaves,
                                                        .axes = one.axes,
                                                        .is_cyclic = one.cyclic,
                                                        .is_shared = what.is_shared,
                                                        .has_clocks = what.has_clocks,
                                                        .waits_for_lanes = what.lanes < wire.size(),
                                                        .order_timeout = what.options(one).order_timeout,
                                                        .keep_alive = what.options(one).keep_alive,
                                                        .stop_interval = what.options(one).stop_interval}));
        m.stands_behind(accounts_.back(), static_cast<std::uint8_t>(i), wire, std::move(axes), what.times(one));
    }
    slaves_.resize(wire.size());
    for (std::size_t i = 0; i != what.units.size(); ++i)
        for (const std::size_t slave : what.units[i].slaves)
            slaves_[slave] =
                std::make_unique<slave_judge>(w, m, wire, *this,
                                              judged_slave{.place = slave,
                                                           .account = accounts_[i],
                                                           .is_cyclic = what.units[i].cyclic,
                                                           .is_shared = what.is_shared,
                                                           .checks_serial = what.checks_serials,
                                                           .has_clock = what.has_clocks && what.units[i].axes != 0,
                                                           .period = what.period,
                                                           .timing = what.options(what.units[i])});
}
bridge_program::~bridge_program() = default;

bridging::bridge_options bridge_settings::options(const unit_settings& of) const {
    const bool any_cyclic = std::ranges::any_of(units, [](const unit_settings& one) { return one.cyclic; });
    auto made = bridging::at_rest_within(of.limit, any_cyclic ? period : time{});
    made.system_time = 800'000'000'000'000'000;
    made.clocks.drift_frames = 500; // a real slave takes more to learn its drift
    return made;
}

ring_times bridge_settings::times(const unit_settings& of) const {
    constexpr auto between_checks = milliseconds{10};
    const auto made = options(of);
    if (of.axes == 0)
        return {.at_rest_in = of.limit,
                .noticed_in = of.limit + milliseconds{150},
                .fresh_for = of.limit,
                .two_cycles = of.cyclic ? 2 * period : time{},
                .cycle = of.cyclic ? period : time{},
                .control_timeout = made.control_timeout};
    const time limit = made.longest_silence + 2 * period + between_checks;
    return {.at_rest_in = of.limit,
            .noticed_in = limit,
            .fresh_for = limit,
            .two_cycles = 2 * period,
            .cycle = period,
            .control_timeout = made.control_timeout};
}

void bridge_program::boot() {
    data_ = std::make_unique<life_data>(*this);
    data_->bus.emplace(data_->options, data_->some_memory());
    bridging::shared_jobs others{};
    if (application_) {
        application_->start();
        others = application_->jobs();
    }
    others.cycle = jaus::bound<&life_data::cycle>(*data_);
    data_->bus->share(others);
    for (auto& each : slaves_) each->starts();
    cycles_of_others_ = 0;
    is_settled_ = has_window_ = false;
    for (std::size_t i = 0; i != accounts_.size(); ++i) {
        auto& one = data_->units.emplace_back(*this, i, data_->observer());
        one.watched.seen_in = [this, &one, i](const jaus::header& head, bytes body) {
            orders_[i]->gets(head, body);
            model_.arrives(accounts_[i], std::exchange(one.current_message, 0), head);
        };
        one.watched.seen_out = [this, i](bytes message) {
            model_.answers(accounts_[i], message);
            orders_[i]->sends(message);
        };
        one.watched.seen_lost = [this, i](const jaus::address& who) { model_.hears_lost(accounts_[i], who); };
        one.watched.seen_done = [this, i](jaus::component_outcome what) {
            model_.handled(accounts_[i], what);
            orders_[i]->has_handled(what);
        };
        one.watched.judge = judges_[i].get();
        judges_[i]->starts();
        orders_[i]->starts();
        model_.starts(accounts_[i]);
        for (auto& front : one.fronts) static_cast<void>(data_->bus->add(front));
        one.stuck_since = world_.now();
        one.node.start(now());
    }
    world_.in(world_.faults.pause(fault::bridge_ended, std::chrono::seconds{10}), *this, to_end, life());
    world_.in(idle_random_.between({}, milliseconds{20}), *this, to_look, life());
}

void bridge_program::kill() { data_.reset(); }

void bridge_program::check() {
    for (auto& each : judges_) each->check();
    for (auto& each : orders_) each->check();
    for (auto& each : slaves_) each->check();
}

void bridge_program::receive(const datagram& one) {
    auto& to = data_->units[one.to];
    to.current_message = one.message;
    to.node.on_datagram(one.content(), endpoint_of(one.from), {}, false, now(), waited(one));
    to.current_message = 0;
    pump();
}

void bridge_program::run() {
    const auto at = now();
    for (auto& one : data_->units)
        if (const auto due = one.node.next_event(); due && *due <= at) one.node.on_time(at);
    pump();
}

std::optional<time> bridge_program::next() {
    auto first = data_->bus->next_event();
    for (auto& one : data_->units)
        if (const auto due = one.node.next_event(); due && (!first || *due < *first)) first = due;
    if (first) first = std::max(*first, now()); // what is due at once has no time that can be counted with
    return since_start(first);
}

void bridge_program::frame_returns(bytes frame) {
    if (!running()) return; // its socket is full of them when it goes on; a frame that old is of no use
    const auto out = [this](bytes message) { put(message); };
    has_more_ = false;
    const bool is_calm = model_.quiet_for(accounts_.front()) > std::chrono::seconds{1} && !application_;
    const bool is_taken = data_->bus->on_frame(frame, now(), out);
    if (is_calm) world_.compares(comparison::frame_taken);
    if (is_calm && !is_taken)
        world_.breaks(
            {.point = contract::told, .who = number(), .expected = "its frame is taken", .found = "it is not"});
    send_frames();
    look_at_idle_turn();
    rearm();
}

// What the ring makes of news.
void bridge_program::pump() {
    const auto out = [this](bytes message) { put(message); };
    has_more_ = false;
    data_->bus->on_time(now(), out);
    send_frames();
    look_at_idle_turn();
}

// A ring that has nothing to do before some time does nothing before, however often it is asked: it has done at once
// what could be done, and says when there is more. What follows from the end of a job is done in the next turn.
void bridge_program::look_at_idle_turn() {
    const auto sum = data_->bus->statistics();
    const auto frames = sum.sent + sum.received + sum.lost;
    const auto begun = data_->bus->cycle_begun();
    is_settled_ = std::exchange(frames_of_jobs_, frames) == frames && std::exchange(cycle_begun_, begun) == begun;
    if (std::exchange(has_more_, false)) is_settled_ = false;
    if (idle_random_.below(4) == 0) drive_idle(false);
}

void bridge_program::drive_idle(bool with_nodes) {
    const auto at = now();
    const auto due = data_->bus->next_event();
    if (due && *due <= at) return;
    if (application_) application_->waits(true);
    const auto before = deeds_;
    const bool waits = std::ranges::any_of(orders_, [](const auto& each) { return each->waits_for_attempt(); });
    has_more_ = false;
    data_->bus->on_time(at, [this](bytes message) { put(message); });
    const auto size = data_->bus->next_frame(frame_, at);
    const char* found = size != 0 ? "a frame" : deeds_ != before ? last_deed_ : nullptr;
    if (found == nullptr && data_->bus->next_event() != due) found = "another time for the next event";
    if (size != 0) wire_.send(bytes{frame_}.first(size));
    if (application_) application_->waits(false);
    const bool was_settled = std::exchange(is_settled_, found == nullptr && !has_more_) && !has_more_ && !waits;
    if (was_settled) world_.compares(comparison::turn_idle);
    if (!was_settled) return send_frames();
    if (found == nullptr && with_nodes) found = drive_nodes();
    if (found == nullptr) return;
    world_.breaks({.point = contract::told,
                   .who = number(),
                   .expected = "nothing to do in a turn in which nothing is due",
                   .found = found});
}

const char* bridge_program::drive_nodes() {
    const auto at = now();
    for (auto& one : data_->units) {
        const auto due = one.node.next_event();
        if (due && *due <= at) continue;
        const auto before = deeds_;
        one.node.on_time(at);
        if (deeds_ != before && !is_woken_) return last_deed_;
    }
    is_woken_ = false;
    return nullptr;
}

void bridge_program::send_frames() {
    while (const auto size = data_->bus->next_frame(frame_, now())) {
        look_at_cycle(bytes{frame_}.first(size));
        look_at_image(bytes{frame_}.first(size));
        look_at_job();
        wire_.send(bytes{frame_}.first(size));
    }
    if (data_->ends && data_->bus->at_rest() && world_.now() - data_->ends_since > milliseconds{50})
        world_.at(world_.now(), *this, to_kill, life());
}

// A life has its process image elsewhere than the ones before, of which one may have it there by chance.
void bridge_program::look_at_image(bytes frame) {
    constexpr std::size_t command_at = 16, window_at = 20;
    const auto command = std::to_integer<unsigned>(frame[command_at]);
    const bool is_logical = command >= 10 && command <= 12;
    if (!is_logical || std::exchange(has_window_, true)) return;
    const std::uint32_t window =
        std::to_integer<unsigned>(frame[window_at]) | std::to_integer<unsigned>(frame[window_at + 1]) << 8U;
    windows_ = windows_ << 16U | window;
    const bool is_known = life() > 2 && (windows_ >> 32U & 0xFFFFU) == window && (windows_ >> 16U & 0xFFFFU) == window;
    if (is_known)
        world_.breaks({.point = contract::told,
                       .who = number(),
                       .expected = "a process image elsewhere than in the lives before",
                       .found = "at " + std::to_string(window) + " again"});
}

// Where all that goes on keeps slaves from stopping, no job does.
void bridge_program::look_at_job() {
    const bool is_idle = data_->bus->master().idle();
    const auto is_carrying = [](const bridging::slave_front& each) { return each.carried().has_value(); };
    const bool carries = std::ranges::any_of(
        data_->units, [&](const unit& one) { return std::ranges::any_of(one.fronts, is_carrying); });
    world_.compares(comparison::keep_alive_told);
    if (data_->bus->keeps_alive() && (!is_idle || carries))
        world_.breaks({.point = contract::told,
                       .who = number(),
                       .expected = "frames that only keep slaves from stopping",
                       .found = "a job or a message that goes on"});
}

// Process data are sent each period, where nothing happens; and the times of the cycle are those that are seen.
void bridge_program::look_at_cycle(bytes frame) {
    constexpr std::size_t command_at = 16;
    const auto command = std::to_integer<unsigned>(frame[command_at]);
    const bool is_logical = command >= 10 && command <= 12;
    if (!is_logical || world_.now() == cycle_at_) return;
    const time last = std::exchange(cycle_at_, world_.now());
    const unsigned cycles = std::exchange(cycles_of_others_, 0);
    if (data_->slaves_changed_at + std::chrono::seconds{1} > world_.now() || data_->ends) return;
    if (model_.quiet_for(accounts_.front()) <= std::chrono::seconds{1}) return;
    world_.compares(comparison::cycle_kept);
    const auto fail = [&](std::string expected, time found) {
        world_.breaks({.point = contract::availability,
                       .who = number(),
                       .expected = std::move(expected),
                       .found = std::to_string(found / std::chrono::microseconds{1}) + " us"});
    };
    const time took = world_.now() - last, off = took - settings_.period;
    if (std::max(off, -off) > settings_.period / 4) fail("process data each period", took);
    world_.compares(comparison::others_called);
    if (cycles != 1)
        world_.breaks({.point = contract::told,
                       .who = number(),
                       .expected = "one cycle of others in each period",
                       .found = std::to_string(cycles)});
    const auto& times = data_->bus->times();
    if (times.late > milliseconds{1} || times.late < time{}) fail("a cycle that begins in time", times.late);
    if (times.round_trip > milliseconds{2} || times.round_trip < std::chrono::microseconds{30})
        fail("a round trip of 30 us to 2 ms", times.round_trip);
    if (times.longest_late < times.late || times.longest_round_trip < times.round_trip)
        fail("the longest time of all", times.longest_round_trip);
}

void bridge_program::put(bytes message) {
    const auto parts = jaus::split(message);
    if (!parts) return;
    for (std::size_t i = 0; i != data_->units.size(); ++i) {
        auto& one = data_->units[i];
        if (one.component.self() != parts.header.source) continue;
        does("put");
        model_.answers(accounts_[i], message);
        judges_[i]->sends(message);
        orders_[i]->sends(message);
        one.node.put(message, now());
    }
}

void bridge_program::moved(std::size_t slave, std::size_t axis, command_number command) {
    const auto& [account, first_axis] = places_of_slaves_[slave];
    const auto which = static_cast<std::size_t>(std::ranges::find(accounts_, account) - accounts_.begin());
    if (command == 0) orders_[which]->rests();
    model_.moves_to(account, first_axis + axis, command);
}

void bridge_program::act() {
    for (auto& one : data_->units) look_after(one);
}

// Somebody looks after the machine.
void bridge_program::look_after(unit& one) {
    const auto state = one.component.state();
    const bool is_stuck = state == jaus::primary_status_code::shutdown || state == jaus::primary_status_code::emergency;
    if (!is_stuck) one.stuck_since = world_.now();
    if (!data_ || data_->ends || world_.now() - one.stuck_since < std::chrono::seconds{15}) return;
    world_.in(milliseconds{1}, *this, to_end, life());
}

// SIGTERM: the program brings its actuators to rest and ends, within a second whatever they say.
void bridge_program::own_event(std::uint8_t what, std::uint32_t argument) {
    if (what == to_give_up) {
        if (running() && application_->gives_up(argument) && data_->bus->cancel_shared()) {
            pump();
            rearm();
        }
        return;
    }
    if (argument != life() || !data_) return;
    if (what == to_look) {
        if (running()) drive_idle(true);
        return world_.in(idle_random_.between({}, milliseconds{20}), *this, to_look, life());
    }
    if (what == to_kill) {
        if (!running()) return world_.in(milliseconds{10}, *this, to_kill, argument);
        for (std::size_t i = 0; i != accounts_.size(); ++i) model_.ends(accounts_[i], data_->ends_since);
        return die(random_.between(milliseconds{5}, std::chrono::seconds{2}));
    }
    world_.in(world_.faults.pause(fault::bridge_ended, std::chrono::seconds{10}), *this, to_end, life());
    if (!running() || data_->ends) return;
    const bool is_stuck = std::ranges::any_of(
        data_->units, [&](const unit& one) { return world_.now() - one.stuck_since >= std::chrono::seconds{15}; });
    if (!is_stuck && !world_.faults.strikes(fault::bridge_ended, 900'000)) return;
    world_.tell({.what = deed::is_ended, .who = number()});
    data_->ends = true;
    data_->ends_since = world_.now();
    for (auto& each : orders_) each->ends();
    const auto out = [this](bytes message) { put(message); };
    data_->bus->shut_down(now(), out);
    pump();
    rearm();
    world_.in(std::chrono::seconds{1}, *this, to_kill, life());
}

} // namespace simulation
