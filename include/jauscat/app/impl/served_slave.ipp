// A slave of a bridge: what is done for it, and what is said of it.
#pragma once
#include <jauscat/app/impl/bridge_state.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/ethercat/cia402/error_text.hpp>
#include <jauscat/schema/ethercat/cia402.hpp>
#include <jauscat/text/jaus.hpp>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

template <class F, class... Arguments>
void bridge_state::call_later(F bridge_state::* function, Arguments... arguments) {
    if (!(this->*function)) return;
    boost::asio::post(node_.context(), [weak = weak_from_this(), function, arguments...] {
        const auto self = weak.lock();
        if (!self) return;
        auto locked = self->bus_->lock();
        if (self->is_closed_) return;
        const auto call = (*self).*function; // it may end the bridge
        locked.unlock();
        if (call) call(arguments...);
    });
}

// ---- Start and end of a slave.

JAUSCAT_DECL void served_slave::check_place() const {
    if (components_.size() == bridging::component_capacity)
        throw std::invalid_argument{"bridge: more than " + std::to_string(bridging::component_capacity) +
                                    " components in front of one slave"};
}
JAUSCAT_DECL bool served_slave::at_rest() const noexcept {
    return std::ranges::none_of(components_,
                                [](const auto* each) { return each->unit && each->unit->stops().stop_is_pending(); });
}
JAUSCAT_DECL std::uint8_t served_slave::node() const noexcept { return bridge_.node().net().manager().node; }
JAUSCAT_DECL void served_slave::log(std::string_view line) {
    if (!bridge_.bus()->is_own_thread()) return bridge_.node().log(line);
    boost::asio::post(bridge_.node().context(), [weak = bridge_.weak_from_this(), text = std::string{line}] {
        if (const auto alive = weak.lock()) alive->node().log(text);
    });
}
JAUSCAT_DECL void served_slave::log_event(std::string_view line) {
    if (!bridge_.watcher) log(line);
}
JAUSCAT_DECL const bridging::observer& served_slave::watcher() const noexcept {
    static constexpr bridging::observer nothing{};
    return bridge_.watcher ? *bridge_.watcher : nothing;
}
JAUSCAT_DECL std::string served_slave::name() const {
    if (bridge_.bus()->named(which_) != nullptr) return "slave \"" + std::string{which_.name.view()} + '"';
    return "slave " + (which_.position       ? std::to_string(*which_.position)
                       : which_.alias        ? "with the alias " + std::to_string(*which_.alias)
                       : which_.name.empty() ? "with the required identity"
                                             : std::string{which_.name.view()});
}

JAUSCAT_DECL void served_slave::start() {
    if (works_) return;
    auto& node = bridge_.node().net();
    const auto* const named = bridge_.bus()->named(which_);
    front_.emplace(bridging::slave_options{.position = which_.position.value_or(0),
                                           .identity = {.subsystem = node.manager().subsystem, .station = station_},
                                           .cyclic = bridge_.options().period > duration{},
                                           .node = node.manager().node,
                                           .sync = sync_of(named).value_or(ethercat::sync_settings{}),
                                           .is_taken_over = named != nullptr},
                   *exchange_, bridge_.timing(), memory_, observer());
    works_ = true;
    has_been_up_ = false;
    last_problem_.clear();
}
JAUSCAT_DECL void served_slave::leave() noexcept {
    if (!std::exchange(works_, false)) return;
    timer_.reset();
    bridge_.bus()->forget(*this);
    if (std::exchange(is_served_, false)) bridge_.bus()->leave(*this);
}

JAUSCAT_DECL bool served_slave::check_rest() {
    if (is_up() && at_rest()) return true;
    log(name() + " has not confirmed that it is at rest: it stops by its own watchdog or not at all");
    return false;
}

JAUSCAT_DECL void served_slave::send(bytes message) { bridge_.send(message); }
JAUSCAT_DECL void served_slave::bus_ends() noexcept {
    is_served_ = false;
    if (!front_) return;
    front_->on_work({});
    try {
        if (was_up || may_move()) bridge_.note_rest(check_rest());
    } catch (...) { // of the log: it is not at rest
        bridge_.note_rest(false);
    }
    has_been_up_ = false; // what it said is noted
    const bool is_up = front_->up();
    front_->set_up(false);
    if (!is_up) return;
    try {
        const auto out = [this](bytes message) { send(message); };
        for (auto* const each : components_)
            if (each->unit) each->unit->on_slave_lost(net::now(), out);
        bridge_.call_later(&bridge_state::on_lost, which_, error_code{bus_errc::not_started});
    } catch (...) { // no memory to tell of it
    }
}

// ---- The slave.

/// Ends a start of the bus for a bridge.
struct served_slave::search final : operation<> {
    explicit search(served_slave& of) : slave{of}, bridge{of.bridge_.weak_from_this()} {}
    void deliver(error_code) override {
        if (const auto still = bridge.lock())
            slave.post([&of = slave] {
                if (!of.is_served_) of.retry();
            });
    }
    served_slave& slave; ///< lives as long as its bridge
    std::weak_ptr<bridge_state> bridge;
};

template <class F> void served_slave::post(F what) {
    boost::asio::post(bridge_.node().context(), [this, what, weak = bridge_.weak_from_this()] {
        const auto alive = weak.lock();
        if (!alive) return;
        const auto locked = alive->bus()->lock();
        if (works_) what();
    });
}
JAUSCAT_DECL void served_slave::await(named_slave& which) {
    if (!bridge_.bus()->await(which, *this, station_)) return log(name() + " is not served: another bridge serves it");
    bridge_.bus()->start_once(std::make_shared<search>(*this));
}
JAUSCAT_DECL void served_slave::slave_ready() {
    post([this] {
        error_code error;
        const auto* const slave = bridge_.bus()->find(which_, error);
        if (!is_served_ && slave != nullptr && slave->is_prepared) found(slave->info.position, {});
    });
}

JAUSCAT_DECL void served_slave::find() {
    if (!works_ || is_served_) return;
    if (auto* const named = bridge_.bus()->named(which_)) return await(*named);
    const auto& id = which_.identity;
    ethercat::identity_check expected{id.vendor, id.product, id.revision, id.serial};
    const bool is_by_position = which_.position && !which_.alias && which_.name.empty();
    if (is_by_position) return found(*which_.position, expected);
    error_code error;
    if (bridge_.bus()->find(which_, error) != nullptr) return retry();
    bridge_.bus()->start(std::make_shared<search>(*this), true);
}
/// The slaves of the bus are known, or not.
JAUSCAT_DECL void served_slave::retry() {
    error_code error;
    const auto* const slave = bridge_.bus()->find(which_, error);
    if (bridge_.bus()->named(which_) != nullptr && bridge_.bus()->is_started()) return; // `slave_ready` tells
    if (slave != nullptr) {
        const auto& info = slave->info;
        return found(info.position, {info.vendor, info.product, info.revision, info.serial});
    }
    const std::string problem = // the bridge starts the bus itself
        error == bus_errc::not_started ? "no slave of the bus has answered yet" : error.message();
    if (problem != last_problem_) {
        last_problem_ = problem;
        log(name() + " is not found: " + problem);
    }
    timer_.emplace(bridge_.node().context(), std::chrono::seconds{1});
    timer_->async_wait([this, weak = bridge_.weak_from_this()](error_code cancelled) {
        if (cancelled) return;
        const auto alive = weak.lock();
        if (!alive) return;
        const auto locked = alive->bus()->lock();
        if (works_ && !is_served_) find();
    });
}
JAUSCAT_DECL void served_slave::found(std::uint16_t position, const ethercat::identity_check& expected) {
    front_->place_at(position, expected);
    if (const auto problem = bridge_.bus()->join(*this); !problem.empty())
        return log(name() + " is not served: " + problem);
    is_served_ = true;
}

// ---- What happens.

JAUSCAT_DECL bridging::observer served_slave::observer() noexcept {
    auto all = watcher(); // what is not handled here is the application's alone
    all.slave_up = jaus::bound<&served_slave::slave_up>(*this);
    all.bring_up_failed = jaus::bound<&served_slave::bring_up_failed>(*this);
    all.slave_lost = jaus::bound<&served_slave::slave_lost>(*this);
    all.slave_emergency = jaus::bound<&served_slave::slave_emergency>(*this);
    all.clocks_agree = jaus::bound<&served_slave::clocks_agree>(*this);
    all.no_keep_alive = jaus::bound<&served_slave::no_keep_alive>(*this);
    all.changed_state = jaus::bound<&served_slave::changed_state>(*this);
    all.stop_refused = jaus::bound<&served_slave::stop_refused>(*this);
    all.settled = jaus::bound<&served_slave::settled>(*this);
    all.faulted = jaus::bound<&served_slave::faulted>(*this);
    all.fault_ended = jaus::bound<&served_slave::fault_ended>(*this);
    all.refused = jaus::bound<&served_slave::refused>(*this);
    return all;
}

inline std::string_view text_of(bridging::loss what) noexcept {
    switch (what) {
    case bridging::loss::no_answer: return "it does not answer";
    case bridging::loss::no_station: return "it does not answer to its station address: it was reset";
    case bridging::loss::left_state: return "it has left its state";
    case bridging::loss::no_process_data: return "it does not take part in the process data";
    }
    return "it is lost";
}
inline std::string_view text_of(bridging::refusal why) noexcept {
    switch (why) {
    case bridging::refusal::slave_down: return "the slave does not answer";
    case bridging::refusal::queue_full: return "too many messages wait for the slave";
    case bridging::refusal::too_large: return "it has more bytes than an object";
    case bridging::refusal::expired: return "it has waited too long";
    case bridging::refusal::superseded: return "a newer command has replaced it";
    case bridging::refusal::stopped: return "the actuator was stopped";
    case bridging::refusal::not_translated: return "it is not translated";
    case bridging::refusal::by_slave: return "the slave has refused it";
    case bridging::refusal::not_accepted: return "the slave has not executed it in time";
    case bridging::refusal::stale: return "the slave's inputs are too old";
    }
    return "refused";
}
inline std::string text_of(const bridging::refusal_reason& why) {
    std::string text{text_of(why.why)};
    if (why.why == bridging::refusal::not_translated && why.error != translate::errc::ok)
        text += ": " + std::string{describe(why.error)};
    if (why.why == bridging::refusal::by_slave && why.of_master.code != ethercat::master_errc::ok)
        text += ": " + error_of(why.of_master).message();
    return text;
}
inline std::string text_of(const bridging::drive_fault& what) {
    if (what.code != cia402::error_codes::none)
        return numbered("%04Xh", what.code) + " (" + std::string{cia402::describe_error_code(what.code)} + ")";
    return what.reason.empty() ? "no error code (603Fh is 0, or not in the process data)" : std::string{what.reason};
}
inline std::string_view text_of(bridging::stop_order what) noexcept {
    switch (what) {
    case bridging::stop_order::rest: return "to rest";
    case bridging::stop_order::emergency: return "emergency";
    case bridging::stop_order::clear_emergency: return "end of the emergency";
    }
    return "stop";
}

/// The state in which its components work.
inline ethercat::al_state goal_of(const bridging::slave_front& slave) noexcept {
    return slave.options().cyclic ? ethercat::al_state::op : ethercat::al_state::pre_op;
}

JAUSCAT_DECL void served_slave::slave_up(const bridging::slave_front& slave, const ethercat::slave_record& record,
                                         bool ready) {
    watcher().slave_up(slave, record, ready);
    bridge_.bus()->note_served(*this, record);
    if (!ready) return;
    has_been_up_ = true;
    last_problem_.clear();
    log_event(name() + " answers, in " + std::string{describe(goal_of(slave))});
    bridge_.call_later(&bridge_state::on_up, which_);
}
JAUSCAT_DECL void served_slave::bring_up_failed(const bridging::slave_front& slave, const ethercat::master_error& why) {
    watcher().bring_up_failed(slave, why);
    const auto error = error_of(why);
    bridge_.bus()->note_served_lost(*this, error);
    if (const auto problem = error.message(); problem != last_problem_) {
        last_problem_ = problem;
        log_event(name() + " is not brought up: " + problem);
    }
}
JAUSCAT_DECL void served_slave::slave_lost(const bridging::slave_front& slave, bridging::loss what,
                                           const ethercat::master_error& why) {
    watcher().slave_lost(slave, what, why);
    const auto error = error_of_loss(goal_of(slave), why);
    bridge_.bus()->note_served_lost(*this, error);
    const auto problem = error.message();
    if (std::exchange(last_problem_, problem) != problem) // it comes again each time it is brought up
        log_event(name() + " is lost: " + std::string{text_of(what)} + " (" + problem + ")");
    bridge_.call_later(&bridge_state::on_lost, which_, error);
    if (!slave.options().is_taken_over) return;
    post([this] { // the bus brings it up again
        if (!std::exchange(is_served_, false)) return;
        bridge_.bus()->leave(*this);
        find();
    });
}
JAUSCAT_DECL void served_slave::slave_emergency(const bridging::slave_front& slave,
                                                const ethercat::coe_emergency& emergency) {
    watcher().slave_emergency(slave, emergency);
    limited_(net::now(), [&] {
        return name() + " reports an emergency: " + numbered("%04Xh", emergency.error_code) +
               numbered(", error register %02Xh", emergency.error_register);
    });
    bridge_.call_later(&bridge_state::on_emergency, which_, emergency);
}
JAUSCAT_DECL void served_slave::clocks_agree(const bridging::slave_front& slave, ethercat::clock_agreement how,
                                             std::uint32_t difference) {
    watcher().clocks_agree(slave, how, difference);
    bridge_.bus()->note_clocks(how, difference);
}
JAUSCAT_DECL void served_slave::no_keep_alive(const bridging::slave_front& slave, const bridging::refusal_reason& why) {
    watcher().no_keep_alive(slave, why);
    log_event(name() + " does not take Report Heartbeat Pulse (" + text_of(why) +
              "): nothing stops it when this program ends without a word");
}
JAUSCAT_DECL void served_slave::changed_state(const bridging::component& unit, jaus::primary_status_code from,
                                              jaus::primary_status_code to) {
    watcher().changed_state(unit, from, to);
    bridge_.call_later(&bridge_state::on_changed, unit.self(), to);
}
JAUSCAT_DECL void served_slave::stop_refused(const bridging::component& unit, bridging::stop_order what,
                                             const bridging::refusal_reason& why, unsigned attempts) {
    watcher().stop_refused(unit, what, why, attempts);
    limited_(net::now(), [&] {
        return name() + " has refused the stop order of " + net::to_jausip(unit.self()) + " (" +
               std::string{text_of(what)} + ", attempt " + std::to_string(attempts) + "): " + text_of(why);
    });
}
JAUSCAT_DECL void served_slave::settled(const bridging::component& unit) {
    watcher().settled(unit);
    bridge_.call_later(&bridge_state::on_at_rest, unit.self());
}
JAUSCAT_DECL std::string served_slave::name_of_drive(const bridging::component& unit, std::size_t slave) const {
    for (const auto* const each : components_)
        if (each->unit && &*each->unit == &unit && slave < each->slaves().size()) return each->slaves()[slave]->name();
    return "slave " + std::to_string(slave) + " of the component";
}
JAUSCAT_DECL void served_slave::faulted(const bridging::component& unit, const bridging::drive_fault& what) {
    watcher().faulted(unit, what);
    limited_(net::now(), [&] {
        return net::to_jausip(unit.self()) + ": " + name_of_drive(unit, what.slave) +
               " has a drive fault: " + text_of(what);
    });
    bridge_.call_later(&bridge_state::on_faulted, unit.self(), what);
}
JAUSCAT_DECL void served_slave::fault_ended(const bridging::component& unit) {
    watcher().fault_ended(unit);
    limited_(net::now(), [&] { return net::to_jausip(unit.self()) + ": no drive has a fault any more"; });
    bridge_.call_later(&bridge_state::on_fault_ended, unit.self());
}
JAUSCAT_DECL void served_slave::refused(const bridging::component& unit, const jaus::header& message,
                                        const bridging::refusal_reason& why) {
    watcher().refused(unit, message, why);
    limited_(net::now(), [&] {
        return net::to_jausip(unit.self()) + " refuses " + text::message_name(message.command_code) + " of " +
               net::to_jausip(message.source) + ": " + text_of(why);
    });
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
