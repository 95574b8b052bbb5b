// A drive of a bus: its axis, the objects that it has in the process data, and the operation that waits for it.
#pragma once
#include <jauscat/app/drive.hpp>
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/ethercat/cia402/axis.hpp>
#include <jauscat/ethercat/cia402/axis_places.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

class drive_state final : public cycle_user, public std::enable_shared_from_this<drive_state> {
  public:
    drive_state(const slave& of, const drive_options& options);

    void operate(const operation_ptr<>& done);
    void enable(const operation_ptr<>& done, cia402::mode mode);
    /// `begin(axis)` tells the axis to do it.
    enum class wish : std::uint8_t { enabled, off, reset, target, homed };
    void begin(operation_ptr<> done, wish what, const std::function<cia402::axis_errc(cia402::axis&)>& begin);
    error_code move_to(double position);
    error_code run_at(double velocity);
    error_code push_with(double torque);
    void halt(bool on);
    [[nodiscard]] drive_feedback feedback() const;
    [[nodiscard]] const cia402::axis& axis() const noexcept { return axis_; }
    [[nodiscard]] boost::asio::io_context& context() const { return slave_.bus()->context(); }
    /// Targets in the drive's units.
    cia402::axis_errc set_position(double position);
    cia402::axis_errc set_velocity(double velocity);

    void on_cycle(time_point now) override;
    void begin_rest() override;
    [[nodiscard]] bool is_at_rest() const override;
    [[nodiscard]] bool uses(std::uint16_t station) const override { return is_operating_ && station_ == station; }
    [[nodiscard]] std::span<const ethercat::process_object> objects() const override { return objects_; }
    void bus_ends() override;

  private:
    [[nodiscard]] auto lock() const { return slave_.bus()->lock(); }
    [[nodiscard]] std::string name() const;
    [[nodiscard]] error_code error_of(const cia402::axis_error& error) const;
    [[nodiscard]] error_code error_of(cia402::axis_errc error) const { return error_of(cia402::axis_error{error}); }
    void replace(operation_ptr<> done);
    void finish(error_code why);
    void settle(time_point now);
    [[nodiscard]] bool is_at_target() const;
    [[nodiscard]] bool is_too_late(time_point now);
    void find_objects();
    void operating();
    /// 60C2h of all axes that the slave has, from this subindex of this axis on.
    struct cycle_time {
        std::size_t axis{};
        std::uint8_t subindex{1};
    };
    [[nodiscard]] static cycle_time after(const cycle_time& which) noexcept;
    void write_cycle_time(cycle_time which, const operation_ptr<>& done);
    void verify_cycle_time(cycle_time which, const operation_ptr<>& done);
    void come_to_op(const operation_ptr<>& done);
    void enable_in_mode(const operation_ptr<>& done, cia402::mode mode);
    template <class F> auto later(const operation_ptr<>& done, F next);

    slave slave_;
    drive_options options_;
    double velocity_units_;
    cia402::axis axis_;
    /// Of all axes that the slave may have: one of its drives takes it to OP for all.
    std::array<ethercat::process_object, cia402::max_axes * cia402::axis_places::capacity> objects_{};
    cia402::axis_places places_{};
    operation_ptr<> done_{}; ///< waits for `wish_`
    wish wish_{};
    std::optional<time_point> settles_since_{}; ///< the motor has had all that should bring it to the target
    std::uint16_t station_{};
    bool is_operating_{}, is_current_{}, is_limited_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
