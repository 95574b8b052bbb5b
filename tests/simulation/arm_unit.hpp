// A slave of the simulated ring: the emulated slave with the robot arm of the examples behind it.
#pragma once

#include "arm_application.hpp"
#include "arm_process_data.hpp"
#include "arm_watch.hpp"
#include "simulation/device.hpp"
#include "simulation/direct_object.hpp"
#include "simulation/messages.hpp"
#include "support/arm_slave.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <functional>
#include <optional>

namespace simulation {

namespace bridging = jauscat::bridging;

/// What the bridge and the arms translate by.
using bridge_table = jauscat::translation::seed_table;

struct arm_settings {
    std::uint32_t answer_delay{}; ///< see coe_options
    bool knows_emergencies{true}; ///< has objects for Set Emergency and Clear Emergency
};

/// The arm and its slave. `moved` hears of the efforts in force whenever they are set; `emergency` of its own
/// emergency.
class arm_unit final : public device {
  public:
    static constexpr std::uint8_t subsystem = 2;

    arm_unit(std::uint32_t serial, std::function<void(command_number)> moved, const arm_settings& what)
        : moved_{std::move(moved)}, what_{what}, direct_{objects_, serial, now_} {
        description_.serial = serial;
        slave_.emplace(description_, dictionary_,
                       ethercat::coe_options{.transfer_memory = memory_, .answer_delay = what.answer_delay});
        power_on({});
    }

    void power_on(time now) override;
    void on_time(time now) override;

    [[nodiscard]] ethercat::slave& slave() noexcept override { return *slave_; }
    [[nodiscard]] const ethercat::slave& slave() const noexcept override { return *slave_; }
    [[nodiscard]] const direct_object& direct() const noexcept { return direct_; }
    [[nodiscard]] bool in_emergency() const noexcept { return emergency_; }
    /// When its supply came, or it last took zero efforts or Set Emergency by mailbox.
    [[nodiscard]] time told_to_rest_at() const noexcept { return told_to_rest_at_; }
    /// Whether it was told so after `since`, or before, and has taken no motion command after that.
    [[nodiscard]] bool rests_by_order(time since) const noexcept {
        return told_to_rest_at_ >= since || told_to_rest_at_ > told_to_move_at_;
    }
    /// From now on its mailbox and its states are worked off once in this time only, as a slave with a busy processor
    /// does; 0: with each frame.
    void set_slow(time each) noexcept { slow_ = each; }
    /// The next writes to objects are aborted so.
    void abort_from_now(unsigned writes, ethercat::abort_code code) noexcept {
        aborts_ = writes;
        abort_ = code;
    }
    /// It has said that it has no such object: who believes that does not tell it of emergencies any more.
    [[nodiscard]] bool denies_objects() const noexcept { return denies_objects_; }
    /// With which it has last refused something.
    [[nodiscard]] ethercat::abort_code last_abort() const noexcept { return direct_.last_abort(); }
    [[nodiscard]] bool is_aborting() const noexcept { return aborts_ != 0; }
    /// Whether there was one since the last call.
    bool take_aborted() noexcept { return std::exchange(aborted_, false); }

    // For listed_objects.
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, bytes data) noexcept;
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept;

  private:
    using application = example::arm_application<bridge_table>;
    using delivery = bridging::delivery<bridge_table>;

    void tell_efforts();
    void note_order(const jaus::header& head, bytes body) noexcept;

    static constexpr std::chrono::milliseconds command_timeout{450}; // that of robot_arm

    std::function<void(command_number)> moved_;
    arm_settings what_;
    std::optional<example::arm> arm_{};
    std::optional<application> application_{};
    std::optional<example::arm_process_data> process_data_{};
    std::optional<example::arm_watch> watch_{};
    bool emergency_{};
    time now_{}, told_to_rest_at_{}, told_to_move_at_{}, slow_{}, work_at_{};
    unsigned aborts_{};
    bool aborted_{}, denies_objects_{};
    ethercat::abort_code abort_{};
    ethercat::slave_description description_ = [] {
        auto made = example::arm_slave;
        made.mailbox_out_size = made.mailbox_in_size = 128;
        return made;
    }();
    bridging::listed_objects objects_{application::objects, *this, bridging::size_rule::up_to_largest};
    direct_object direct_;
    ethercat::standard_objects dictionary_{description_, direct_};
    std::array<std::byte, 4096> memory_{};
    std::optional<ethercat::slave> slave_{};
};

} // namespace simulation
