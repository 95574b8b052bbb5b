#include "simulation/drive_unit.hpp"

#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace simulation {
namespace {

template <std::size_t Axes> class drive_of final : public drive_unit {
  public:
    drive_of(std::uint32_t serial, std::size_t first_joint, std::function<void(std::size_t, command_number)> moved,
             const std::optional<ethercat::clock_error>& clock)
        : drive_unit{std::move(moved), first_joint, Axes}, description_{describe(serial, clock.has_value())} {
        slave_.emplace(description_, dictionary_);
        if (clock) slave_->set_clock_error(*clock);
    }
    ethercat::slave& slave() noexcept override { return *slave_; }
    const ethercat::slave& slave() const noexcept override { return *slave_; }
    // Without its supply the brake holds the motor.
    void power_on(time now) override {
        drive_ = {};
        slave_->power_on();
        look(now); // which on_time may not have said for long
    }
    void on_time(time now) override {
        slave_->work();
        slave_->on_time(jauscat::time_point{now});
        work(jauscat::time_point{now});
        look(now);
    }
    std::size_t axis_count() const noexcept override { return Axes; }
    cia402::emulated_axis& axis(std::size_t i) noexcept override { return drive_.axes[i]; }
    bool has_fault() const noexcept override {
        return std::ranges::any_of(drive_.axes, [](const cia402::emulated_axis& each) {
            return each.state() == cia402::state::fault || each.state() == cia402::state::fault_reaction_active;
        });
    }

  private:
    void work(jauscat::time_point now) noexcept {
        if (!is_deaf()) return drive_.work(*slave_, now);
        const bool is_operational = slave_->state() == ethercat::al_state::op;
        if (slave_->take_outputs() && is_operational) {
            std::array<std::uint16_t, Axes> words{};
            for (std::size_t i = 0; i != Axes; ++i) words[i] = drive_.axes[i].values.controlword;
            drive_.take(slave_->outputs());
            for (std::size_t i = 0; i != Axes; ++i) drive_.axes[i].values.controlword = words[i];
        }
        drive_.work(*slave_, now); // without new outputs
    }

    static ethercat::slave_description describe(std::uint32_t serial, bool has_clock) {
        auto made = cia402::drive_description<Axes>;
        made.serial = serial;
        made.clock = has_clock ? ethercat::clock_width::bits_64 : ethercat::clock_width::no_clock;
        made.needs_sync = has_clock;
        return made;
    }

    ethercat::slave_description description_;
    cia402::emulated_drive<Axes> drive_{};
    ethercat::standard_objects dictionary_{description_, drive_};
    std::optional<ethercat::slave> slave_{};
};

} // namespace

bool drive_unit::had_velocity(std::size_t axis, double velocity, time since) const noexcept {
    constexpr double tolerance = 2;
    const auto& all = seen_[axis];
    std::int32_t least = 0, most = 0; // before the first
    const std::size_t kept = std::min(all.count, all.velocities.size());
    for (std::size_t i = 0; i != kept; ++i) {
        const auto& [at, value] = all.velocities[(all.count - 1 - i) % all.velocities.size()];
        least = i == 0 ? value : std::min(least, value);
        most = i == 0 ? value : std::max(most, value);
        if (at <= since) break;
        if (i + 1 == all.count) least = std::min(least, 0), most = std::max(most, 0);
    }
    return velocity >= least - tolerance && velocity <= most + tolerance;
}

void drive_unit::look(time now) {
    for (std::size_t i = 0; i != seen_.size(); ++i) {
        auto& one = seen_[i];
        const auto velocity = static_cast<std::int32_t>(std::lround(axis(i).velocity()));
        if (one.count == 0 || one.velocities[(one.count - 1) % one.velocities.size()].second != velocity)
            one.velocities[one.count++ % one.velocities.size()] = {now, velocity};
        if (axis(i).values.target_velocity == 0) one.told_to_rest_at = now;
        const auto command = command_of(i);
        if (command == one.command) continue;
        one.command = command;
        moved_(i, command);
    }
}

// A target counts while the axis follows it; an axis without one comes to rest, and goes on as it was until then.
command_number drive_unit::command_of(std::size_t i) {
    constexpr double standstill = 10; // increments/s
    auto& one = axis(i);
    const auto last = seen_[i].command;
    const bool follows = one.state() == cia402::state::operation_enabled &&
                         one.values.mode_display == static_cast<std::int8_t>(cia402::mode::cyclic_synchronous_velocity);
    if (follows && one.values.target_velocity != 0) {
        const auto found = command_of_velocity(one.values.target_velocity, first_joint_ + i);
        return found ? *found : last != 0 ? last : no_command;
    }
    if (std::abs(one.velocity()) <= standstill) return 0;
    return last != 0 ? last : no_command;
}

std::unique_ptr<drive_unit> make_drive(std::size_t axes, std::uint32_t serial, std::size_t first_joint,
                                       std::function<void(std::size_t, command_number)> moved,
                                       const std::optional<ethercat::clock_error>& clock) {
    if (axes == 2) return std::make_unique<drive_of<2>>(serial, first_joint, std::move(moved), clock);
    return std::make_unique<drive_of<1>>(serial, first_joint, std::move(moved), clock);
}

} // namespace simulation
