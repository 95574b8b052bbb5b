#include "simulation/joint_system.hpp"

#include "simulation/motor_judge.hpp"
#include <jauscat/bridge/any_exchange.hpp>
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/bridge/packet_exchange.hpp>
#include <jauscat/bridge/ring.hpp>
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <span>
#include <type_traits>
#include <vector>

namespace simulation {
namespace {

namespace bridging = jauscat::bridging;
namespace cia402 = jauscat::cia402;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using bytes = std::span<const std::byte>;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr double increments = 10'000; // of a radian
constexpr jaus::address self{.instance = 1, .component = 56, .node = 2, .subsystem = 2};
constexpr jaus::address operator_control_unit{.instance = 1, .component = 32, .node = 1, .subsystem = 2};

/// Drawn from the seed.
struct joint_settings {
    milliseconds limit{}, period{}, brake{};
    joint_limits limits{};
    bool has_velocity{true};

    joint_settings(generator random, joint_trial what) {
        constexpr std::array periods{2, 5, 10};
        period = milliseconds{periods[random.below(periods.size())]};
        limit = milliseconds{random.below(2) == 0 ? 200 : 500};
        limits.velocity = 10'000 + random.below(10'000);
        limits.acceleration = 200'000;
        limits.max_position = 50'000;
        limits.min_position = -limits.max_position;
        if (what == joint_trial::long_ramp) {
            limit = milliseconds{200};
            limits.velocity = 50'000;
            limits.max_position = 1e9; // so that nothing but a stop order ends the motion
            limits.min_position = -limits.max_position;
        }
        if (what == joint_trial::slow_enabling) {
            limit = milliseconds{100};
            brake = milliseconds{100 + random.below(200)};
        }
        has_velocity = what != joint_trial::no_velocity;
        if (!has_velocity) limits.quick_stop = 50'000; // takes long: rest must not be assumed
    }
    [[nodiscard]] bridging::joint_options joint() const {
        auto places = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs);
        if (!has_velocity) places.velocity = {};
        return {.slave = 0,
                .places = places,
                .axis = {.min_position = static_cast<std::int32_t>(limits.min_position),
                         .max_position = static_cast<std::int32_t>(limits.max_position),
                         .max_velocity = limits.velocity,
                         .acceleration = limits.acceleration,
                         .deceleration = limits.acceleration},
                .scale = {.increments_per_radian = increments}};
    }
};

class joint_system final : public actor {
  public:
    joint_system(world& w, joint_trial what)
        : world_{w},
          what_{what},
          random_{w.stream(3000)},
          settings_{w.stream(3001), what},
          number_{w.add("joint")},
          part_{{settings_.joint()}},
          options_{bridging::at_rest_within(settings_.limit, settings_.period)},
          judge_{settings_.limits} {
        motor().values.quick_stop_deceleration = static_cast<std::uint32_t>(settings_.limits.quick_stop);
        static_cast<void>(bus_.add(front_));
        std::array<bridging::slave_front*, 1> all{&front_};
        component_.emplace(self, all, part_, jaus::component_options{.control = {.timeout = options_.control_timeout}});
        world_.at({}, *this, step);
        world_.at(seconds{4}, *this, command);
        if (what == joint_trial::period_changes) world_.at(seconds{5}, *this, other_user);
        if (what == joint_trial::lasting_fault) world_.at(seconds{6}, *this, fails);
        if (what == joint_trial::stops_following) world_.at(seconds{5}, *this, holds);
        constexpr std::array lasting{joint_trial::no_velocity, joint_trial::long_ramp, joint_trial::mode_refused};
        if (std::ranges::find(lasting, what) != lasting.end()) world_.faults.note(*fault_of_trial(what));
    }

    void on_event(std::uint8_t what, std::uint32_t) override {
        switch (what) {
        case step: return work();
        case command: return give_command();
        case other_user:
            world_.in(random_.between(milliseconds{300}, seconds{2}), *this, other_user);
            world_.faults.note(fault::joint_period_changed);
            options_.period = options_.period == settings_.period ? milliseconds{1} : settings_.period;
            return bus_.apply_options();
        case fails:
            world_.faults.note(fault::joint_lasting_fault);
            motor().disturbed.fault = cia402::error_codes::over_current;
            return;
        case holds:
            // That it holds must be seen: two cycles later its targets are where it is.
            if (world_.now() - mode_since_ < 3 * settings_.period) return world_.in(3 * settings_.period, *this, holds);
            motor().disturbed.holds = !motor().disturbed.holds;
            if (!motor().disturbed.holds) return world_.in(random_.between(seconds{1}, seconds{3}), *this, holds);
            world_.faults.note(fault::joint_stops_following);
            return world_.in(random_.between(milliseconds{40}, seconds{2}), *this, holds);
        default: return;
        }
    }

  private:
    enum : std::uint8_t { step, command, other_user, fails, holds };
    struct flight {
        std::vector<std::byte> frame{};
        time at{};
    };
    struct sink_type {
        joint_system& mine;
        void operator()(bytes message) const { mine.hears(message); }
    };

    [[nodiscard]] cia402::emulated_axis& motor() noexcept { return drive_.axes[0]; }
    [[nodiscard]] jauscat::time_point now() const noexcept { return jauscat::time_point{seconds{1} + world_.now()}; }
    [[nodiscard]] bool is_ready() const { return component_->state() == jaus::primary_status_code::ready; }

    void breaks(contract point, std::string expected, std::string found) {
        world_.breaks({.point = point, .who = number_, .expected = std::move(expected), .found = std::move(found)});
    }

    // Whenever something is due, or 500 us have passed: what has returned, then the drive, then the program.
    void work() {
        while (!flights_.empty() && flights_.front().at <= world_.now()) {
            const auto back = std::move(flights_.front().frame);
            flights_.pop_front();
            bus_.on_frame(back, now(), out_);
        }
        disturb();
        slave_.on_time(now());
        drive_.work(slave_, now());
        look();
        component_->on_time(now(), out_);
        bus_.on_time(now(), out_);
        std::array<std::byte, ethercat::max_frame_size> buffer{};
        while (const auto size = bus_.next_frame(buffer, now())) {
            const auto frame = std::span{buffer}.first(size);
            world_.sees("a frame", frame);
            slave_.process(frame);
            drive_.work(slave_, now());
            look();
            flights_.push_back({{frame.begin(), frame.end()}, world_.now() + std::chrono::microseconds{100}});
        }
        if (!is_silent_ && world_.now() >= pulse_at_) {
            pulse_at_ = world_.now() + milliseconds{10};
            tell(jaus::report_heartbeat_pulse{}, jaus::ack_nak::none);
        }
        world_.at(next_step(), *this, step);
    }
    [[nodiscard]] time next_step() const {
        auto next = now() + std::chrono::microseconds{500};
        for (const auto due : {bus_.next_event(), component_->next_event()})
            if (due)
                next =
                    std::min(next, std::max(*due, now())); // what is due at once has no time that can be counted with
        auto at = next.time_since_epoch() - seconds{1};
        if (!flights_.empty()) at = std::min(at, flights_.front().at);
        return std::max(at, world_.now() + std::chrono::microseconds{1});
    }
    void disturb() {
        auto& hurt = motor().disturbed;
        if (what_ == joint_trial::slow_enabling) {
            if (motor().state() != cia402::state::switched_on)
                brake_since_ = world_.now();
            else if (brake_since_ != std::exchange(brake_told_, brake_since_))
                world_.faults.note(fault::joint_late_brake);
            const bool is_closed = world_.now() - brake_since_ < settings_.brake;
            hurt.refused = is_closed ? std::optional{cia402::state::operation_enabled} : std::nullopt;
        }
        if (what_ == joint_trial::mode_refused)
            motor().values.supported_modes = cia402::supported_modes(cia402::mode::cyclic_synchronous_velocity);
    }

    void look() {
        // What a drive does because it has left OP is no excuse.
        const bool is_disturbed = motor().disturbed.fault != cia402::error_codes::none;
        const auto found = judge_.look({.at = world_.now(),
                                        .position = motor().position(),
                                        .velocity = motor().velocity(),
                                        .state = motor().state(),
                                        .mode = static_cast<cia402::mode>(motor().values.mode_display),
                                        .target_position = motor().values.target_position,
                                        .is_operational = slave_.state() == ethercat::al_state::op,
                                        .is_disturbed = is_disturbed,
                                        .holds = motor().disturbed.holds});
        world_.compares(comparison::motor_limits);
        if (found) breaks(contract::limits, found->expected, found->found);
        look_at_rest();
        look_at_motion();
        look_at_waits();
        tell_state();
        look_at_fault();
        look_at_following();
        if (component_->state() != jaus::primary_status_code::initialize) initialize_since_ = world_.now();
        if (initialize_since_ != world_.now()) world_.compares(comparison::axis_wait);
        if (world_.now() - initialize_since_ > seconds{10})
            breaks(contract::s6, "an end of Initialize, with a slave that answers", "none for 10 s");
        // A few cycles, in which the loss is told to the drive, belong to the limit.
        const bool is_late = is_silent_ && world_.now() - silent_since_ > settings_.limit;
        if (is_late) world_.compares(comparison::sender_silent);
        if (is_late && motor_judge::turns(motor().velocity()))
            breaks(contract::s3, "rest within the limit after the sender's last message", velocity_text());
    }
    void tell_state() {
        const auto state = component_->state();
        if (state == told_state_) return;
        world_.tell({.what = deed::enters_state,
                     .who = number_,
                     .number = static_cast<std::uint16_t>(told_state_),
                     .value = static_cast<std::uint32_t>(state)});
        told_state_ = state;
    }
    void look_at_fault() {
        const bool is_faulty =
            motor().state() == cia402::state::fault || motor().state() == cia402::state::fault_reaction_active;
        if (is_faulty) world_.compares(comparison::drive_fault_told);
        if (is_untold(is_faulty && is_ready(), faulty_since_))
            breaks(contract::s8, "Failure while the drive is in fault", "Ready");
    }
    void look_at_following() {
        const auto mode = motor().values.mode_display;
        if (std::exchange(mode_, mode) != mode) mode_since_ = world_.now();
        has_position_ = has_position_ && is_ready();
        const bool is_off = motor().disturbed.holds && has_position_;
        if (is_off) world_.compares(comparison::following_told);
        if (is_untold(is_off, off_since_))
            breaks(contract::s8, "Failure while the drive does not follow its target", "Ready");
    }
    // Whether it has lasted for longer than it takes the component to leave Ready.
    bool is_untold(bool lasts, time& since) const {
        if (!lasts) since = world_.now();
        return world_.now() - since > 3 * settings_.period + milliseconds{10};
    }
    // Outside of Ready it brakes by its ramp or by quick stop, and stands still.
    void look_at_rest() {
        if (is_ready()) ready_at_ = world_.now();
        const double slowest = std::min(settings_.limits.acceleration, settings_.limits.quick_stop);
        const std::chrono::duration<double> braking{settings_.limits.velocity / slowest};
        const time most = settings_.limit + std::chrono::duration_cast<time>(braking);
        if (world_.now() - ready_at_ <= most) return;
        world_.compares(comparison::motor_stays);
        if (motor_judge::turns(motor().velocity()))
            breaks(contract::s2, "a motor that stands still outside of Ready", velocity_text());
    }
    // What was acknowledged and not replaced since: the velocity after the ramp, or the position after the way.
    void look_at_motion() {
        if (!wish_ || !is_ready()) return wish_.reset();
        const bool is_disturbed =
            motor().state() != cia402::state::operation_enabled || (what_ == joint_trial::silent_sender && is_silent_);
        if (is_disturbed) return wish_.reset();
        const auto& most = settings_.limits;
        const double ramp = most.velocity / most.acceleration;
        const double way = std::abs(wish_->target - wish_->from);
        const double takes = wish_->is_position ? way / most.velocity + 2 * ramp + 0.3 : 2 * ramp + 0.2;
        if (std::chrono::duration<double>(world_.now() - wish_->since).count() < takes) return;
        const double is = wish_->is_position ? motor().position() : motor().velocity();
        const bool is_at_limit = !wish_->is_position && std::abs(motor().position()) > 0.9 * most.max_position;
        constexpr double of_position = 100;
        const double tolerance = wish_->is_position ? of_position : 0.05 * most.velocity + motor_judge::standstill;
        if (!is_at_limit) world_.compares(comparison::motor_moves);
        if (!is_at_limit && std::abs(is - wish_->target) > tolerance)
            breaks(contract::s1,
                   std::string{"the motor at the acknowledged "} + (wish_->is_position ? "position " : "velocity ") +
                       std::to_string(std::llround(wish_->target)),
                   "it is at " + std::to_string(std::llround(is)));
        wish_.reset();
    }
    // A message that asks for it has its acknowledgement or refusal in time.
    void look_at_waits() {
        if (asked_.empty()) return;
        world_.compares(comparison::axis_wait);
        constexpr auto long_enough = seconds{5};
        if (world_.now() - asked_.front().at > long_enough)
            breaks(contract::s6, "an answer to each message within 5 s",
                   "none to command code " + std::to_string(asked_.front().code));
    }
    [[nodiscard]] std::string velocity_text() {
        return "the motor turns at " + std::to_string(std::llround(motor().velocity())) + "/s";
    }

    template <class T> void tell(const T& body, jaus::ack_nak acknowledgement = jaus::ack_nak::request) {
        const jaus::header head{.ack_nak = acknowledgement,
                                .command_code = jaus::command_code_of<T>,
                                .destination = self,
                                .source = operator_control_unit,
                                .sequence_number = ++sequence_};
        if (acknowledgement == jaus::ack_nak::request) {
            wish_.reset();
            has_position_ = false; // the drive may have to change its mode, for which it has a time
            asked_.push_back({head.sequence_number, head.command_code, world_.now(), wish_of(body)});
        }
        std::array<std::byte, 128> space{};
        const auto encoded = wire::encode(body, space);
        static_cast<void>(component_->on_message(
            head, *encoded, now(), out_, [](const jaus::header&, bytes) { return jaus::message_outcome::unhandled; }));
        bus_.on_time(now(), out_);
    }

    struct wish {
        double target{}, from{};
        bool is_position{};
        time since{};
    };
    struct asked {
        std::uint16_t number{}, code{};
        time at{};
        std::optional<wish> wanted{};
    };
    [[nodiscard]] std::optional<wish> wish_of(const auto&) const { return std::nullopt; }
    [[nodiscard]] std::optional<wish> wish_of(const jaus::basic_set_joint_positions<1>& body) const {
        const auto& most = settings_.limits;
        return wish{.target = std::clamp(body.joint_position[0] * increments, most.min_position, most.max_position),
                    .is_position = true};
    }
    [[nodiscard]] std::optional<wish> wish_of(const jaus::basic_set_joint_velocities<1>& body) const {
        return wish{.target = body.joint_velocity[0] * increments};
    }

    void give_command() {
        const bool is_quick = random_.below(4) == 0;
        world_.in(is_quick ? random_.between(milliseconds{1}, milliseconds{40})
                           : random_.between(milliseconds{200}, seconds{2}),
                  *this, command);
        if (what_ == joint_trial::silent_sender && motor_judge::turns(motor().velocity()) && random_.below(3) == 0) {
            if (!std::exchange(is_silent_, true)) {
                silent_since_ = world_.now();
                world_.faults.note(fault::joint_sender_silent);
            }
            return;
        }
        is_silent_ = false;
        switch (component_->state()) {
        case jaus::primary_status_code::ready: return move();
        case jaus::primary_status_code::standby: return tell(jaus::resume{});
        case jaus::primary_status_code::emergency: {
            jaus::clear_emergency body{};
            body.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
            return tell(body);
        }
        case jaus::primary_status_code::failure: return tell(jaus::reset{});
        default: return;
        }
    }
    void move() {
        const double part = (static_cast<double>(random_.below(2001)) - 1000) / 1000;
        if (what_ == joint_trial::long_ramp) return run_fast();
        const auto which = random_.below(8);
        if (which < 4) {
            constexpr double most = 1.5; // beyond the position limits, too
            return tell(jaus::basic_set_joint_positions<1>{
                .joint_position = {most * part * settings_.limits.max_position / increments}});
        }
        if (which < 6)
            return tell(
                jaus::basic_set_joint_velocities<1>{.joint_velocity = {part * settings_.limits.velocity / increments}});
        if (which == 6) return tell(jaus::standby{});
        jaus::set_emergency body{};
        body.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
        tell(body);
    }

    // In one direction, and stops.
    void run_fast() {
        if (motor().velocity() > 0.9 * settings_.limits.velocity) return tell(jaus::standby{});
        tell(jaus::basic_set_joint_velocities<1>{.joint_velocity = {settings_.limits.velocity / increments}});
    }

    // An acknowledged stop: the motor stands still.
    void hears(bytes message) {
        world_.sees("a message", message);
        const auto head = jaus::split(message).header;
        if (!jaus::is_acknowledgement(head)) return;
        const bool is_acknowledged = head.ack_nak == jaus::ack_nak::ack;
        const auto code = head.command_code;
        bool is_last = true; // no other message has been sent since
        if (const auto of = std::ranges::find(asked_, head.sequence_number, &asked::number); of != asked_.end()) {
            is_last = std::next(of) == asked_.end();
            if (is_acknowledged && is_last) wish_ = of->wanted;
            has_position_ = is_acknowledged && is_last && wish_ && wish_->is_position;
            if (wish_) wish_->since = world_.now(), wish_->from = motor().position();
            asked_.erase(of);
        }
        const bool is_stop =
            code == jaus::command_code_of<jaus::standby> || code == jaus::command_code_of<jaus::set_emergency>;
        if (is_stop && is_acknowledged) world_.compares(comparison::motor_rests);
        if (is_stop && is_acknowledged && motor_judge::turns(motor().velocity()) && !judge_.is_settling(world_.now()))
            breaks(contract::s2, "rest when a stop order is acknowledged", velocity_text());
        const bool is_motion = code == jaus::command_code_of<jaus::set_joint_velocities> ||
                               code == jaus::command_code_of<jaus::set_joint_positions>;
        const bool must_obey = what_ == joint_trial::plain || what_ == joint_trial::slow_enabling;
        if (!is_motion || !is_last || !must_obey) return;
        refusals_ = is_acknowledged ? 0 : refusals_ + 1;
        if (refusals_ == 3) breaks(contract::s6, "commands that are executed in Ready", "three refused in turn");
    }

    world& world_;
    joint_trial what_;
    generator random_;
    joint_settings settings_;
    std::uint8_t number_;
    cia402::emulated_drive<1> drive_{cia402::motor_model{.rated_acceleration = 1e7}};
    ethercat::standard_objects dictionary_{cia402::drive_description<1>, drive_};
    ethercat::slave slave_{cia402::drive_description<1>, dictionary_};
    bridging::joint_part<1> part_;
    bridging::bridge_options options_;
    bridging::slave_identity identity_{.subsystem = 2, .station = 2};
    bridging::exchange_under<jauscat::translation::seed_table> exchange_{identity_};
    bridging::order_memory<16, 256> memory_{};
    bridging::slave_front front_{
        {.position = 0, .identity = identity_, .cyclic = true}, exchange_, options_, memory_, {}};
    bridging::ring_for<1, 1024> bus_{options_};
    std::optional<bridging::component> component_{};
    sink_type sink_{*this};
    jaus::message_sink out_{sink_};
    motor_judge judge_;
    std::deque<flight> flights_{};
    std::uint16_t sequence_{};
    unsigned refusals_{};
    jaus::primary_status_code told_state_{};
    bool is_silent_{};
    bool has_position_{}; // that of the last message is in force
    time off_since_{}, mode_since_{};
    std::int8_t mode_{};
    time silent_since_{}, pulse_at_{}, faulty_since_{}, initialize_since_{}, brake_since_{}, brake_told_{}, ready_at_{};
    std::optional<wish> wish_{};
    std::deque<asked> asked_{};
};

} // namespace

std::unique_ptr<actor> make_joint_system(world& w, joint_trial what) { return std::make_unique<joint_system>(w, what); }

} // namespace simulation
