// A slave of the simulated ring that is a CiA 402 drive: what its axes do, seen from outside.
#pragma once

#include "simulation/device.hpp"
#include "simulation/messages.hpp"
#include <jauscat/ethercat/cia402/emulated_axis.hpp>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace simulation {

namespace cia402 = jauscat::cia402;

/// `moved(axis, command)`: hears of the command in force of an axis whenever that changes; 0: it has neither a target
/// nor speed.
class drive_unit : public device {
  public:
    [[nodiscard]] virtual std::size_t axis_count() const noexcept = 0;
    [[nodiscard]] virtual cia402::emulated_axis& axis(std::size_t i) noexcept = 0;
    /// While it is, its axes keep the controlwords that they have.
    void set_deaf(bool deaf) noexcept { is_deaf_ = deaf; }
    /// Needs a reset before it moves again.
    [[nodiscard]] virtual bool has_fault() const noexcept = 0;
    /// Whether an axis has had this velocity, in its units, at some instant since then.
    [[nodiscard]] bool had_velocity(std::size_t axis, double velocity, time since) const noexcept;
    /// Whether the target of an axis has been 0 at some instant since then.
    [[nodiscard]] bool was_told_to_rest(std::size_t axis, time since) const noexcept {
        return seen_[axis].told_to_rest_at >= since;
    }

  protected:
    /// `first_joint`: the number of its first axis in the arm.
    drive_unit(std::function<void(std::size_t, command_number)> moved, std::size_t first_joint, std::size_t axes)
        : moved_{std::move(moved)}, first_joint_{first_joint}, seen_(axes) {}
    /// To be called whenever an axis may have changed.
    void look(time now);
    [[nodiscard]] bool is_deaf() const noexcept { return is_deaf_; }

  private:
    struct seen {
        command_number command{};
        time told_to_rest_at{};
        std::array<std::pair<time, std::int32_t>, 256> velocities{};
        std::size_t count{};
    };
    [[nodiscard]] command_number command_of(std::size_t i);

    std::function<void(std::size_t, command_number)> moved_;
    std::size_t first_joint_;
    std::vector<seen> seen_;
    bool is_deaf_{};
};

/// A drive of 1 or 2 axes; with a clock it is in OP only while it has SYNC signals.
[[nodiscard]] std::unique_ptr<drive_unit> make_drive(std::size_t axes, std::uint32_t serial, std::size_t first_joint,
                                                     std::function<void(std::size_t, command_number)> moved,
                                                     const std::optional<ethercat::clock_error>& clock);

} // namespace simulation
