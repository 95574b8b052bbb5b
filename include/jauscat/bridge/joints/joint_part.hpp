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
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

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
            cycles_[i] = period;
            start_up_[i] = cia402::axis_start_up{period, joints_[i].places, joints_[i].drive_axis};
            for (const auto& each : start_up_[i].values())
                commands_[count++] = {.index = each.index, .subindex = each.subindex, .data = each.data};
        }
        return std::span{commands_}.first(count);
    }
    /// Those whose places name them: see cia402::pdo_layout::find.
    [[nodiscard]] std::span<ethercat::process_object> objects(std::size_t slave) override {
        const auto first = first_object_of(slave);
        std::size_t count = 0;
        for_each_object([&](std::size_t of, const cia402::pdo_place& at, bool is_output) {
            if (of == slave)
                objects_[first + count++] = {.index = at.index, .subindex = at.subindex, .is_output = is_output};
        });
        return std::span{objects_}.subspan(first, count);
    }
    /// Each has to be where the places have it.
    [[nodiscard]] ethercat::master_error check_objects(std::size_t slave) override {
        ethercat::master_error error{};
        auto next = first_object_of(slave);
        for_each_object([&](std::size_t of, const cia402::pdo_place& at, bool) {
            if (of != slave) return;
            const auto& found = objects_[next++];
            if (error.code != ethercat::master_errc::ok || (found.bits == at.bits && found.first_bit == at.first_bit))
                return;
            error = {.code = ethercat::master_errc::wrong_mapping,
                     .index = at.index,
                     .subindex = at.subindex,
                     .bits = at.bits,
                     .found_bits = found.bits,
                     .first_bit = static_cast<std::uint16_t>(at.first_bit),
                     .found_at = static_cast<std::uint16_t>(found.first_bit)};
        });
        return error;
    }
    /// The ramp from the highest velocity of each joint has to end within the limit. A stop whose ramp takes longer
    /// than `ramp_limit` is a quick stop.
    [[nodiscard]] std::string_view use_times(const process_times& times) override {
        ramp_limit_ = times.ramp_limit == duration{} ? duration::max() : times.ramp_limit;
        if (times.rest_limit == duration{} || !has_ramps()) return {};
        for (std::size_t i = 0; i != Joints; ++i) {
            const auto& axis = joints_[i].axis;
            const double needed = axis.deceleration > 0 ? axis.max_velocity / axis.deceleration : most_seconds;
            if (needed > std::chrono::duration<double>{times.rest_limit}.count())
                return misfit(i, needed, times.rest_limit);
        }
        return {};
    }
    /// Errors: wrong_size (process data that lack a joint's object, or its slave), out_of_range (parameters of a joint,
    /// a period that 60C2h cannot have).
    [[nodiscard]] result<void> start(slave_group slaves, duration period) override {
        for (auto& each : joints_) {
            if (each.slave >= slaves.size() || each.slave >= most_drives ||
                !fits(each.places, slaves[each.slave].outputs.size(), slaves[each.slave].inputs.size()))
                return translate::errc::wrong_size;
        }
        auto joints = joints_;
        for (std::size_t i = 0; i != Joints; ++i) {
            auto& axis = joints[i].axis;
            axis.cycle = cycles_[i] == duration{} ? period : cycles_[i]; // as 60C2h, though the period is another now
            axis.ramp_time = std::min(axis.ramp_time, ramp_limit_);
        }
        group_ = joint_group<Joints>{joints};
        group_.change_period(period);
        if (!group_.is_usable() || !cia402::interpolation_period_of(period)) return translate::errc::out_of_range;
        period_ = period;
        forget_progress();
        return {};
    }
    void change_period(duration period) override { group_.change_period(period); }
    [[nodiscard]] bool takes(std::uint16_t command_code) const override {
        return group_.serves(command_code) || group_.is_report(report_of(command_code));
    }
    [[nodiscard]] bool uses_mailbox() const override { return false; }

    [[nodiscard]] result<std::uint32_t> command(const jaus::header& head, std::span<const std::byte> body, slave_group,
                                                time_point) override {
        group_.clear_emergency(); // the component has left it
        if (const auto taken = group_.command(head.command_code, body); !taken) return errc_of(taken.error());
        is_stop_ = false;
        return ++number_;
    }
    /// Until all axes are enabled in the mode of the command; axis_options::step_time bounds each step.
    [[nodiscard]] bool is_preparing() const override { return group_.state() == joint_group_state::starting; }
    std::uint32_t stop(stop_order what, slave_group slaves) override {
        if (what == stop_order::emergency)
            group_.emergency();
        else
            group_.stop();
        forget_progress();
        is_stop_ = true;
        ++number_;
        exchange(slaves, last_); // the outputs of the next frame
        for (std::size_t i = 0; i != Joints; ++i) speeds_[i] = speed_of(i);
        return number_;
    }
    [[nodiscard]] bool is_braking(slave_group slaves) override {
        bool all = is_stop_ && answered_ == number_;
        for (std::size_t i = 0; i != Joints; ++i) {
            const bool is_at_rest = slaves[joints_[i].slave].outputs.empty() || group_.is_at_rest(i);
            const double speed = speed_of(i);
            all = all &&
                  (is_at_rest || (group_.axis(i).error().code == cia402::axis_errc::ok && speed < speeds_[i] * 3 / 4));
            speeds_[i] = speed;
        }
        return all;
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
        if (!is_stop_ || (answered_ == number_ && is_at_rest(slaves))) executed_ = answered_;
        for (std::size_t i = 0; i != Joints; ++i)
            if (const auto fault = fault_of(i)) return fault;
        if (const auto joint = group_.joint_without_target())
            return drive_fault{joints_[*joint].slave, 0, "the drive no longer follows its target"};
        return std::nullopt;
    }
    [[nodiscard]] std::size_t faults(std::span<drive_fault> out) const override {
        std::size_t count = 0;
        for (std::size_t i = 0; i != Joints && count != out.size(); ++i)
            if (const auto fault = fault_of(i)) out[count++] = *fault;
        return count;
    }
    void reset() override { group_.reset(); }

  private:
    static constexpr std::size_t most_drives = Joints;
    static constexpr double most_seconds = 1e9;

    struct place_of_order {
        std::uint32_t number{}; ///< of the command or stop order
        time_point since{};
    };

    // f(slave, place, is_output)
    void for_each_object(auto&& f) const {
        for (const auto& each : joints_)
            each.places.for_each([&](const cia402::pdo_place& at, bool is_output) {
                if (at.is_mapped() && at.index != 0) f(each.slave, at, is_output);
            });
    }
    // Those of the slaves before it come first.
    [[nodiscard]] std::size_t first_object_of(std::size_t slave) const {
        std::size_t first = 0;
        for_each_object([&](std::size_t of, const cia402::pdo_place&, bool) { first += of < slave ? 1 : 0; });
        return first;
    }
    /// With the drive's present error code, which may be another one than when the axis failed.
    [[nodiscard]] std::optional<drive_fault> fault_of(std::size_t joint) const noexcept {
        const auto& axis = group_.axis(joint);
        const auto& error = axis.error();
        if (error.code == cia402::axis_errc::ok) return std::nullopt;
        const auto state = axis.drive_state();
        const bool is_in_fault = state == cia402::state::fault || state == cia402::state::fault_reaction_active;
        const auto present = is_in_fault ? axis.feedback().error_code : cia402::error_codes::none;
        const auto code = present != cia402::error_codes::none ? present : error.drive_code;
        const bool is_of_drive = code != cia402::error_codes::none || error.code == cia402::axis_errc::drive_fault;
        return drive_fault{joints_[joint].slave, code, is_of_drive ? std::string_view{} : describe(error)};
    }
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
        bool all = true;
        at.for_each([&](const cia402::pdo_place& each, bool is_output) {
            all = all && each.fits(is_output ? outputs : inputs);
        });
        return all;
    }
    /// In a mode that has the ramp of axis_options::deceleration.
    [[nodiscard]] bool has_ramps() const noexcept {
        return group_.serves(jaus::command_code_of<jaus::set_joint_positions>) ||
               group_.serves(jaus::command_code_of<jaus::set_joint_velocities>);
    }
    [[nodiscard]] double speed_of(std::size_t joint) const noexcept {
        const double velocity = group_.axis(joint).velocity();
        return velocity < 0 ? -velocity : velocity;
    }
    /// "joint 2 needs 250 ms from max_velocity to rest by its deceleration, longer than the 200 ms that it may take".
    [[nodiscard]] std::string_view misfit(std::size_t joint, double needed, duration limit) noexcept {
        std::size_t size = 0;
        const auto put = [&](std::string_view text) {
            for (const char each : text.substr(0, misfit_.size() - size)) misfit_[size++] = each;
        };
        const auto put_number = [&](std::int64_t number) {
            std::array<char, 20> digits{};
            put({digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr});
        };
        put("joint ");
        put_number(static_cast<std::int64_t>(joint + 1));
        put(" needs ");
        put_number(static_cast<std::int64_t>(std::min(needed, most_seconds) * 1000 + 0.999));
        put(" ms from max_velocity to rest by its deceleration, longer than the ");
        put_number(std::chrono::duration_cast<std::chrono::milliseconds>(limit).count());
        put(" ms in which it has to be at rest");
        return {misfit_.data(), size};
    }
    [[nodiscard]] bool is_at_rest(slave_group slaves) const noexcept {
        for (std::size_t i = 0; i != Joints; ++i)
            if (!slaves[joints_[i].slave].outputs.empty() && !group_.is_at_rest(i)) return false;
        return true;
    }
    /// An order is executed when inputs are later than its delivery to all drives, also where the next one has replaced
    /// it in the outputs since then.
    void advance(slave_group slaves, time_point now) noexcept {
        if (!is_stop_ && !group_.is_following()) {
            in_outputs_.number = delivered_.number = answered_;
            return;
        }
        if (delivered_.number != answered_ && have_run_since(slaves, delivered_.since)) answered_ = delivered_.number;
        if (in_outputs_.number != delivered_.number && have_run_since(slaves, in_outputs_.since))
            delivered_ = {in_outputs_.number, now};
        if (number_ != in_outputs_.number && (is_stop_ || group_.has_targets())) in_outputs_ = {number_, now};
    }
    void forget_progress() noexcept { in_outputs_.number = delivered_.number = answered_ = executed_ = number_; }
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
    std::array<ethercat::process_object, Joints * cia402::axis_places::capacity> objects_{};
    joint_group<Joints> group_;
    duration period_{}, ramp_limit_{duration::max()};
    std::array<duration, Joints> cycles_{}; // 60C2h, where it was asked for
    std::array<double, Joints> speeds_{};   // at the last stop order, or since is_braking was asked
    std::array<char, 160> misfit_{};
    time_point last_{};
    std::uint32_t number_{};                    // of the last command or stop order
    place_of_order in_outputs_{}, delivered_{}; // in the outputs of all frames sent since then; to all drives
    std::uint32_t answered_{}, executed_{};     // the last before the last inputs; and a stop order only at rest
    bool is_stop_{};
};

} // namespace jauscat::bridging
