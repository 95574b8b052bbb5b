// The joints of an arm as the actuator of a component: joint messages by the process data of CiA 402 drives.
#pragma once
#include <jauscat/bridge/joints/joint_group.hpp>
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/ethercat/cia402/start_up.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// The slaves of the component are the drives, in the order of joint_options::slave. Set Joint Positions, Velocities
/// and Efforts are executed when all drives have the targets and follow them by later inputs, stop orders when all
/// axes are at rest without torque; the queries of the three reports are answered from the last inputs.
template <std::size_t Joints> class joint_part final : public process_part {
    template <class T> using result = jauscat::result<T, translate::errc>;

  public:
    explicit joint_part(const std::array<joint_options, Joints>& joints) noexcept : joints_{joints}, group_{joints} {}

    [[nodiscard]] const joint_group<Joints>& group() const noexcept { return group_; }

    /// The interpolation time period of each axis (60C2h), and its mode (6060h) where it is not in the process data.
    [[nodiscard]] std::span<const ethercat::init_command> start_up(std::size_t slave, duration period) override {
        std::size_t count = 0;
        for (std::size_t i = 0; i != Joints; ++i) {
            if (joints_[i].slave != slave) continue;
            start_up_[i] = cia402::axis_start_up{period, joints_[i].places, joints_[i].drive_axis};
            for (const auto& each : start_up_[i].values())
                commands_[count++] = {.index = each.index, .subindex = each.subindex, .data = each.data};
        }
        return std::span{commands_}.first(count);
    }
    /// Errors: wrong_size (process data that lack a joint's object, or its slave), out_of_range (parameters of a joint,
    /// a period that 60C2h cannot have).
    [[nodiscard]] result<void> start(slave_group slaves, duration period) override {
        for (auto& each : joints_) {
            if (each.slave >= slaves.size() || each.slave >= most_drives ||
                !fits(each.places, slaves[each.slave].outputs.size(), slaves[each.slave].inputs.size()))
                return translate::errc::wrong_size;
            each.axis.cycle = period;
        }
        group_ = joint_group<Joints>{joints_};
        if (!group_.is_usable() || !cia402::interpolation_period_of(period)) return translate::errc::out_of_range;
        period_ = period;
        executed_ = number_;
        return {};
    }
    [[nodiscard]] bool takes(std::uint16_t command_code) const override {
        return group_.serves(command_code) || group_.is_report(report_of(command_code));
    }
    [[nodiscard]] bool uses_mailbox() const override { return false; }

    [[nodiscard]] result<std::uint32_t> command(const jaus::header& head, std::span<const std::byte> body, slave_group,
                                                time_point) override {
        group_.clear_emergency(); // the component has left it
        if (const auto taken = group_.command(head.command_code, body); !taken) return errc_of(taken.error());
        progress_ = progress::none;
        is_stop_ = false;
        return ++number_;
    }
    std::uint32_t stop(stop_order what, slave_group slaves) override {
        if (what == stop_order::emergency)
            group_.emergency();
        else
            group_.stop();
        progress_ = progress::none;
        is_stop_ = true;
        executed_ = number_++;
        exchange(slaves, last_); // the outputs of the next frame
        return number_;
    }
    [[nodiscard]] std::uint32_t executed(slave_group) const override { return executed_; }
    [[nodiscard]] result<std::span<std::byte>> answer(const jaus::header& query, std::span<const std::byte>,
                                                      slave_group, std::span<std::byte> out) const override {
        std::array<std::byte, 1 + 4 * Joints> body{};
        const auto code = report_of(query.command_code);
        const auto report = group_.report(code, body);
        if (!report) return errc_of(report.error());
        auto head = jaus::answer_to(query);
        head.command_code = code;
        const auto made = jaus::join(head, *report, out);
        if (!made) return translate::errc::no_space;
        return *made;
    }

    std::optional<drive_fault> step(slave_group slaves, time_point now) override {
        exchange(slaves, now);
        advance(slaves, now);
        if (progress_ == progress::answered && (!is_stop_ || is_at_rest(slaves))) executed_ = number_;
        for (std::size_t i = 0; i != Joints; ++i)
            if (const auto& error = group_.axis(i).error(); error.code != cia402::axis_errc::ok)
                return drive_fault{joints_[i].slave, error.drive_code};
        return std::nullopt;
    }
    void reset() override { group_.reset(); }

  private:
    static constexpr std::size_t most_drives = Joints;

    /// How far the last command or stop order has come.
    enum class progress : std::uint8_t {
        none,       // not in the outputs of all drives
        in_outputs, // of frames sent from now on
        delivered,  // all drives have got it
        answered,   // and the inputs are later than that
    };

    [[nodiscard]] static constexpr std::uint16_t report_of(std::uint16_t query) noexcept {
        return static_cast<std::uint16_t>(query + 0x2000);
    }
    [[nodiscard]] static constexpr translate::errc errc_of(joint_errc error) noexcept {
        switch (error) {
        case joint_errc::ok: return translate::errc::ok;
        case joint_errc::unknown_message: return translate::errc::unknown_command_code;
        case joint_errc::wrong_count: return translate::errc::wrong_size;
        case joint_errc::no_space: return translate::errc::no_space;
        case joint_errc::malformed: return translate::errc::out_of_range;
        case joint_errc::in_emergency:
        case joint_errc::has_failed:
        case joint_errc::not_current: break;
        }
        return translate::errc::actuator_not_ready;
    }
    [[nodiscard]] static bool fits(const cia402::axis_places& at, std::size_t outputs, std::size_t inputs) noexcept {
        const auto all_fit = [](std::size_t size, auto... places) { return (places.fits(size) && ...); };
        return all_fit(outputs, at.controlword, at.mode, at.target_position, at.target_velocity, at.target_torque,
                       at.profile_velocity) &&
               all_fit(inputs, at.statusword, at.mode_display, at.position, at.velocity, at.torque, at.error_code);
    }
    [[nodiscard]] bool is_at_rest(slave_group slaves) const noexcept {
        for (std::size_t i = 0; i != Joints; ++i)
            if (!slaves[joints_[i].slave].outputs.empty() && !group_.is_at_rest(i)) return false;
        return true;
    }
    void advance(slave_group slaves, time_point now) noexcept {
        if (!is_stop_ && !group_.has_targets()) {
            progress_ = progress::none;
        } else if (progress_ == progress::none) {
            progress_ = progress::in_outputs;
            advanced_at_ = now;
        } else if (progress_ != progress::answered && have_run_since(slaves, advanced_at_)) {
            progress_ = progress_ == progress::in_outputs ? progress::delivered : progress::answered;
            advanced_at_ = now;
        }
    }
    /// A frame sent after `then` has returned and found all drives running that are not lost.
    [[nodiscard]] bool have_run_since(slave_group slaves, time_point then) const noexcept {
        return std::ranges::all_of(joints_, [&](const joint_options& each) {
            const auto& slave = slaves[each.slave];
            return slave.outputs.empty() || (slave.status.last_running && *slave.status.last_running > then);
        });
    }
    /// The ring decides when a drive that is silent is lost.
    [[nodiscard]] input_age age_of(const slave_data& slave, time_point now) const noexcept {
        if (slave.outputs.empty()) return input_age::lost;
        return slave.status.ran_within(2 * period_, now) ? input_age::current : input_age::late;
    }
    void exchange(slave_group slaves, time_point now) noexcept {
        last_ = now;
        std::array<drive_image, most_drives> images{};
        for (std::size_t i = 0; i != std::min(slaves.size(), images.size()); ++i)
            images[i] = {slaves[i].outputs, slaves[i].inputs, age_of(slaves[i], now)};
        group_.step(images, now);
    }

    std::array<joint_options, Joints> joints_;
    std::array<cia402::axis_start_up, Joints> start_up_{};
    std::array<ethercat::init_command, Joints * cia402::axis_start_up::capacity> commands_{};
    joint_group<Joints> group_;
    duration period_{};
    time_point last_{};
    std::uint32_t number_{}, executed_{};
    bool is_stop_{};
    progress progress_{};
    time_point advanced_at_{};
};

} // namespace jauscat::bridging
