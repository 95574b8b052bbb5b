// Judges what a bridge's component does with the messages for its slaves: each ends, in time where nothing has
// happened, and is refused for a cause; its status says what its stop orders and slaves are like.
#pragma once

#include "simulation/model.hpp"
#include <jauscat/bridge/observer.hpp>
#include <jauscat/bridge/pending_stops.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simulation {

namespace bridging = jauscat::bridging;

/// How a judged component of a bridge is made.
struct judged_orders {
    std::uint8_t account{}; ///< of the model
    std::vector<std::size_t> slaves{};
    std::size_t axes{}; ///< of each slave that is a drive
    bool is_cyclic{}, is_shared{}, has_clocks{};
    bool waits_for_lanes{}; ///< the ring has fewer of them than slaves
    time order_timeout{}, keep_alive{}, stop_interval{};
};

class order_judge {
  public:
    order_judge(world& w, const model& m, const process& program, judged_orders what)
        : world_{w}, model_{m}, program_{program}, what_{std::move(what)} {}

    void starts();
    void gets(const jaus::header& head, bytes body);
    void has_handled(jaus::component_outcome what);
    void sends(bytes message);

    // What the bridge's observer hears.
    void refused(const jaus::header& head, const bridging::refusal_reason& reason);
    void merged(const jaus::header& head);
    void reads_inputs();
    void stop_required(bridging::stop_order what, bridging::stop_cause why);
    void ends() { ends_ = true; }
    void stop_refused(bridging::stop_order what, const bridging::refusal_reason& why, unsigned attempts);
    void settled();
    void changed_controller(jaus::control_change why) {
        changed_control_at_ = world_.now();
        control_change_ = why;
    }
    void faulted(const bridging::drive_fault& what);
    void fault_ended();
    void slave_up(std::size_t slave);
    void slave_lost(std::size_t slave);
    void bring_up_failed();
    void no_keep_alive() { takes_keep_alive_ = false; }

    /// For process data, an attempt at a refused stop order comes with the next cycle.
    [[nodiscard]] bool waits_for_attempt() const { return what_.is_cyclic && repeat_from_.has_value(); }
    /// Its actuator comes to rest.
    void rests();
    void check();

  private:
    struct order {
        jaus::header head{};
        time at{}, local_at{};
        std::size_t size{};
        bool is_well_formed{}, stops{}; ///< a motion command: without motion
    };

    [[nodiscard]] bool is_up() const { return up_.size() == what_.slaves.size(); }
    /// For how long nothing has happened to any slave, frame or program.
    [[nodiscard]] time quiet() const { return model_.quiet_for(what_.account); }
    [[nodiscard]] bool is_quiet() const { return !what_.is_shared && quiet() > std::chrono::seconds{1}; }
    [[nodiscard]] const char* cause_missing(const order& one, bridging::refusal why) const;
    [[nodiscard]] bool has_cause(bridging::stop_cause why) const;
    [[nodiscard]] bool is_in_emergency() const;
    void check_status(bytes body);
    void check_reason(const bridging::refusal_reason& why);
    void check_repeat();
    void check_keep_alive();
    void check_return();
    void check_rest();
    void breaks(contract point, std::string expected, std::string found);

    world& world_;
    const model& model_;
    const process& program_;
    judged_orders what_;
    order current_{};
    std::vector<order> open_{}, seen_{};
    std::set<std::size_t> up_{};
    time stopped_at_{}, changed_control_at_{}, checked_at_{}, up_at_{}, lost_at_{}, not_accepted_at_{};
    jaus::control_change control_change_{};
    time emergency_at_{}, hindered_at_{}; // last in an emergency; the same or faulted
    std::optional<time> rested_at_{};
    bool ends_{};
    bool is_owed_{}, may_be_settled_{}, is_faulted_{}, takes_keep_alive_{};
    // Of the message that is being handled.
    bool has_ended_{}, is_handled_{};
    bool has_replaced_{}; ///< an older one that waited; that they are merged was not told yet
    // Stop orders that were refused, since the last one was required.
    bool needs_emergency_{};
    unsigned attempts_{};
    bridging::stop_order refused_order_{};
    time refused_at_{};                 ///< of the program's clock
    std::optional<time> repeat_from_{}; ///< since when nothing hinders the next attempt
    std::optional<bridging::drive_fault> fault_{};
    time fault_at_{};
    bool has_read_inputs_{};
};

} // namespace simulation
