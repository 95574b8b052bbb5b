// Judges what a bridge tells of its slaves: each of its words has a cause in the ring, errors are those of the slave,
// attempts have their pauses, and emergencies are told once.
#pragma once

#include "simulation/model.hpp"
#include <jauscat/bridge/bridge_options.hpp>
#include <jauscat/bridge/observer.hpp>

#include <optional>
#include <string>
#include <vector>

namespace simulation {

namespace bridging = jauscat::bridging;

/// How a judged slave is used.
struct judged_slave {
    std::size_t place{};    ///< in the ring
    std::uint8_t account{}; ///< of the model: its component's
    bool is_cyclic{}, is_shared{}, checks_serial{}, has_clock{};
    time period{};
    bridging::bridge_options timing{};
};

class slave_judge {
  public:
    slave_judge(world& w, const model& m, const ring& wire, const process& program, judged_slave what)
        : world_{w}, model_{m}, wire_{wire}, program_{program}, what_{what} {}

    void starts();

    // What the bridge's observer hears; `kept`: the error that the ring keeps of this slave.
    void up(const ethercat::slave_record& record, bool ready, const ethercat::master_error& kept);
    void failed(const ethercat::master_error& why, const ethercat::master_error& kept);
    void lost(bridging::loss what, const ethercat::master_error& why, const ethercat::master_error& kept);
    void emergency(const ethercat::coe_emergency& what);
    void no_keep_alive(const bridging::refusal_reason& why);
    void agrees(ethercat::clock_agreement how, std::uint32_t difference);
    void packet(bytes packet, bool asks_report);
    void into_image(std::uint32_t count, bytes outputs, bytes data);
    void from_image(bytes inputs, bytes data);

    void check();

  private:
    enum class phase : std::uint8_t { absent, pre_op, up };

    [[nodiscard]] const ring_place& slave() const { return wire_[what_.place]; }
    [[nodiscard]] bool is_quiet_for(time some) const {
        return !what_.is_shared && model_.quiet_for(what_.account) > some;
    }
    /// Whether a slave that may have answered for it has reported this state lately.
    [[nodiscard]] bool was_in(const ethercat::master_error& what) const;
    [[nodiscard]] bool was_not_at_its_station() const;
    [[nodiscard]] bool was_doubled() const;
    /// Literals; nullptr: nothing is wrong with it.
    [[nodiscard]] const char* wrong_with_loss(bridging::loss what, const ethercat::master_error& why) const;
    void attempt_ends();
    void check_start_up();
    void says(bool is_right, const char* expected, const std::string& found);
    void breaks(contract point, std::string expected, std::string found);

    world& world_;
    const model& model_;
    const ring& wire_;
    const process& program_;
    judged_slave what_;
    phase phase_{};
    time next_try_{}, up_at_{}, checked_at_{}; // next_try_: of the program's clock
    std::optional<time> returns_from_{};       ///< it was used until then
    std::optional<ethercat::clock_agreement> agreement_{};
    std::optional<std::uint32_t> last_count_{};
    std::uint32_t last_emergency_{};
};

} // namespace simulation
