// An operator's messages to a component whose actuator is six drives on one ring.
#include "bridge/rig.hpp"
#include "cia402/joint_arm.hpp"
#include <jauscat/bridge/joints/joint_part.hpp>

using namespace test;
using jaus::primary_status_code;
using jauscat::test::joint_arm;
using jauscat::test::joint_device;

namespace {

constexpr std::size_t joints = 6;
using set_positions = jaus::basic_set_joint_positions<joints>;
using set_velocities = jaus::basic_set_joint_velocities<joints>;
using report_velocities = jaus::basic_report_joint_velocities<joints>;

/// One component in front of six drives; time is simulated.
class drives {
  public:
    static constexpr jaus::address self{.instance = 1, .component = 56, .node = 2, .subsystem = 2};

    explicit drives(const bridging::bridge_options& options = bridging::at_rest_within(100ms, 2ms),
                    const std::array<bridging::joint_options, joints>& arm = joint_arm<1>())
        : part{arm}, options_{options} {
        std::vector<bridging::slave_front*> all;
        for (std::uint16_t i = 0; i != joints; ++i) {
            const bridging::slave_identity identity{.subsystem = 2, .station = static_cast<std::uint16_t>(2 + i)};
            exchanges_.emplace_back(identity);
            memories_.emplace_back();
            fronts_.emplace_back(bridging::slave_options{.position = i, .identity = identity, .cyclic = true},
                                 exchanges_.back(), options_, memories_.back(), watcher.observer());
            REQUIRE(bus_.add(fronts_.back()));
            all.push_back(&fronts_.back());
        }
        unit_.emplace(self, all, part, core_options_);
        run_until([&] {
            const auto state = unit().state();
            return state != primary_status_code::initialize && unit().stops().settled();
        });
    }
    drives(const drives&) = delete;
    drives& operator=(const drives&) = delete;

    bridging::component& unit() { return *unit_; }
    jauscat::cia402::emulated_axis& motor(std::size_t i) { return devices[i].drive.axes[0]; }

    void run_until(auto&& done, std::chrono::nanoseconds limit = 20s) {
        const auto begun = now_;
        while (!done() && now_ - begun < limit) step(begun + limit);
        REQUIRE(done());
    }
    void run(std::chrono::nanoseconds time) {
        for (const auto end = now_ + time; now_ < end;) step(end);
    }
    template <class T> std::uint16_t tell(const T& body, jaus::ack_nak ack = jaus::ack_nak::request) {
        return tell_as(rig::operator_unit, body, ack);
    }
    template <class T>
    std::uint16_t tell_as(const jaus::address& who, const T& body, jaus::ack_nak ack = jaus::ack_nak::request) {
        const jaus::header head{.ack_nak = ack,
                                .command_code = jaus::command_code_of<T>,
                                .destination = self,
                                .source = who,
                                .sequence_number = ++number_};
        std::array<std::byte, 128> buffer{};
        const auto encoded = jauscat::wire::encode(body, buffer);
        REQUIRE(encoded);
        static_cast<void>(unit_->on_message(
            head, *encoded, now_, out_, [](const jaus::header&, bytes) { return jaus::message_outcome::unhandled; }));
        bus_.on_time(now_, out_);
        return number_;
    }
    std::uint16_t turn(double rate) {
        return tell(set_velocities{.joint_velocity = {rate, rate, rate, rate, rate, rate}});
    }
    [[nodiscard]] std::optional<jaus::ack_nak> answer(std::uint16_t number) const {
        for (const auto& each : messages) {
            const auto head = jaus::split(each).header;
            if (jaus::is_acknowledgement(head) && head.sequence_number == number) return head.ack_nak;
        }
        return std::nullopt;
    }
    void run_until_turning(double rate) {
        run_until([&, number = turn(rate)] { return answer(number) == jaus::ack_nak::ack; });
        run(200ms);
    }
    /// Another user of the bus has begun or ended.
    void change_period(jauscat::duration period) {
        options_.period = period;
        bus_.apply_options();
    }
    [[nodiscard]] double fastest() {
        double most = 0;
        for (std::size_t i = 0; i != joints; ++i) most = std::max(most, std::abs(motor(i).velocity()));
        return most;
    }
    [[nodiscard]] jauscat::time_point now() const { return now_; }
    [[nodiscard]] const jauscat::ethercat::master_error& bring_up_error(std::size_t i) const {
        return bus_.bring_up_error(fronts_[i]);
    }
    [[nodiscard]] bool all_at_rest() {
        for (std::size_t i = 0; i != joints; ++i)
            if (std::abs(motor(i).velocity()) > 10) return false;
        return true;
    }

    /// A closed brake keeps its drive from operation enabled.
    void close_brake(std::size_t i, bool closed) {
        motor(i).disturbed.refused = closed ? std::optional{jauscat::cia402::state::operation_enabled} : std::nullopt;
    }
    void close_brakes(bool closed) {
        for (std::size_t i = 0; i != joints; ++i) close_brake(i, closed);
    }

    unsigned frames_to_lose{};
    std::array<joint_device<1>, joints> devices{};
    bridging::joint_part<joints> part;
    notes watcher{};
    std::vector<std::vector<std::byte>> messages{};
    std::function<void()> on_message{};
    std::function<void()> on_step{};

  private:
    struct flight {
        std::vector<std::byte> frame;
        jauscat::time_point at;
    };
    struct sink {
        drives& mine;
        void operator()(bytes message) const {
            mine.messages.emplace_back(message.begin(), message.end());
            if (mine.on_message) mine.on_message();
        }
    };

    void step(jauscat::time_point limit) {
        std::array<std::byte, ethercat::max_frame_size> buffer{};
        while (const auto size = bus_.next_frame(buffer, now_)) {
            const auto frame = std::span{buffer}.first(size);
            if (frames_to_lose != 0) {
                --frames_to_lose;
                continue;
            }
            for (auto& each : devices) {
                if (!each.connected) continue;
                each.slave.process(frame);
                each.drive.work(each.slave, now_);
            }
            flights_.push_back({{frame.begin(), frame.end()}, now_ + 100us});
        }
        auto next = std::min(limit, now_ + 1ms); // the drives have time of their own
        if (const auto event = bus_.next_event()) next = std::min(next, *event);
        if (const auto event = unit_->next_event()) next = std::min(next, *event);
        for (const auto& each : flights_) next = std::min(next, each.at);
        now_ = std::max(now_ + 1us, next);
        while (!flights_.empty() && flights_.front().at <= now_) {
            const auto back = std::move(flights_.front().frame);
            flights_.pop_front();
            bus_.on_frame(back, now_, out_);
        }
        for (auto& each : devices) {
            each.slave.on_time(now_);
            each.drive.work(each.slave, now_);
        }
        if (on_step) on_step();
        if (now_ >= pulse_at_) { // the operator is there
            pulse_at_ = now_ + 50ms;
            tell(jaus::report_heartbeat_pulse{}, jaus::ack_nak::none);
        }
        unit_->on_time(now_, out_);
        bus_.on_time(now_, out_);
    }

    bridging::bridge_options options_;
    jaus::component_options core_options_{};
    std::deque<bridging::exchange_under<actuator::table>> exchanges_{};
    std::deque<bridging::order_memory<16, 256>> memories_{};
    std::deque<bridging::slave_front> fronts_{};
    std::optional<bridging::component> unit_{};
    bridging::ring_for<joints, 1024> bus_{options_};
    sink sink_{*this};
    jaus::message_sink out_{sink_};
    std::deque<flight> flights_{};
    jauscat::time_point now_{1s}, pulse_at_{};
    std::uint16_t number_{100};
};

} // namespace

TEST_CASE("a joint message moves six drives, is acknowledged then, and is reported") {
    drives d;
    d.run_until_turning(2.0);
    for (std::size_t i = 0; i != joints; ++i) CHECK(std::abs(d.motor(i).velocity()) == Approx(20'000).margin(200));
    d.tell(jaus::query_joint_velocities{}, jaus::ack_nak::none);
    d.run(20ms);
    std::optional<report_velocities> report;
    for (const auto& each : d.messages) {
        const auto parts = jaus::split(each);
        if (parts.header.command_code != jaus::command_code_of<report_velocities>) continue;
        CHECK(parts.header.destination == rig::operator_unit);
        REQUIRE(jauscat::wire::decode(report.emplace(), parts.body));
    }
    REQUIRE(report);
    REQUIRE(report->joint_velocity.size() == joints);
    CHECK(report->joint_velocity[5] == Approx(2.0).margin(0.02));
    const auto five = d.tell(set_velocities{.joint_velocity = {0, 0, 0, 0, 0}});
    d.run_until([&] { return d.answer(five).has_value(); });
    CHECK(d.answer(five) == jaus::ack_nak::nak);
    CHECK(!d.all_at_rest());
}

TEST_CASE("a joint message is acknowledged after all drives have got its targets") {
    drives d;
    const unsigned lost = GENERATE(0u, 1u);
    const bool moves = GENERATE(false, true); // drives that are enabled take it in the next cycle
    if (moves) d.run_until_turning(1.0);
    const auto have_targets = [&d, lowest = moves ? 10'100 : 1] {
        for (std::size_t i = 0; i != joints; ++i)
            if (std::abs(d.motor(i).values.target_velocity) < lowest) return false;
        return true;
    };
    const auto number = d.turn(3.0);
    std::optional<bool> had_targets;
    d.on_message = [&] {
        if (!had_targets && d.answer(number) == jaus::ack_nak::ack) had_targets = have_targets();
    };
    d.run_until([&] { return d.part.group().has_targets(); });
    CHECK(!have_targets());
    d.frames_to_lose = lost;
    d.run_until([&] { return had_targets.has_value(); }, 20ms);
    CHECK(had_targets == true);
}

TEST_CASE("a joint message is not acknowledged when its targets were replaced before they were sent") {
    drives d;
    bool had_targets = false;
    d.on_step = [&] {
        for (std::size_t i = 0; i != joints; ++i) had_targets |= d.motor(i).values.target_velocity != 0;
    };
    const auto first = d.turn(1.0);
    d.run(std::chrono::milliseconds{GENERATE(range(2, 20, 2))});
    d.frames_to_lose = 3;
    d.run_until([&] { return d.frames_to_lose == 0; });
    d.run(2ms);
    const bool was_sent = had_targets;
    const auto second = d.turn(2.0);
    d.run_until([&] { return d.answer(second).has_value(); }, 100ms);
    CHECK(d.answer(second) == jaus::ack_nak::ack);
    CHECK(d.answer(first) == (was_sent ? jaus::ack_nak::ack : jaus::ack_nak::nak));
}

TEST_CASE("each drive gets the period of the ring as its interpolation time before it comes to OP") {
    drives d;
    for (std::size_t i = 0; i != joints; ++i) {
        CHECK(d.motor(i).values.interpolation_time == 2); // 2 ms; the default is 1 ms
        CHECK(d.motor(i).values.interpolation_index == -3);
    }
    d.devices[3].connected = false;
    d.run_until([&] { return d.watcher.lost != 0; }, 200ms);
    d.motor(3).values.interpolation_time = 7;
    d.devices[3].connected = true;
    d.run_until([&] { return d.unit().state() == primary_status_code::ready; });
    CHECK(d.motor(3).values.interpolation_time == 2);
}

TEST_CASE("a drive that does not keep its interpolation time does not come to OP") {
    drives d;
    d.devices[3].connected = false;
    d.run_until([&] { return d.watcher.lost != 0; }, 200ms);
    d.on_step = [&] { d.motor(3).values.interpolation_time = 7; };
    d.devices[3].connected = true;
    d.run_until([&] { return d.bring_up_error(3).code == jauscat::ethercat::master_errc::object_not_kept; });
    CHECK(d.devices[3].slave.state() == jauscat::ethercat::al_state::pre_op);
}

TEST_CASE("Set Joint Motion is refused, and the command in force stays") {
    drives d;
    d.run_until_turning(2.0);
    const std::array<jaus::joint_motion, joints> still{};
    const std::array<jaus::joint_motion_pose, 1> poses{{{.pose_time = 1.0, .joint = still}}};
    const auto number = d.tell(jaus::set_joint_motion{.number_of_joints = joints, .pose = poses});
    d.run_until([&] { return d.answer(number).has_value(); }, 1s);
    CHECK(d.answer(number) == jaus::ack_nak::nak);
    for (std::size_t i = 0; i != joints; ++i) CHECK(std::abs(d.motor(i).velocity()) == Approx(20'000).margin(200));
}

TEST_CASE("an emergency brings six drives to rest, and is acknowledged then") {
    drives d;
    d.run_until_turning(2.0);
    const auto number = d.tell(rig::stop());
    d.run_until([&] { return d.answer(number) == jaus::ack_nak::ack; }, 200ms);
    CHECK(d.all_at_rest());
    CHECK(d.unit().state() == primary_status_code::emergency);
    const auto refused = d.turn(1.0);
    d.run(200ms);
    CHECK(d.answer(refused) != jaus::ack_nak::ack);
    CHECK(d.all_at_rest());
}

TEST_CASE("a drive's fault is the component's failure, until it is reset") {
    drives d;
    d.run_until_turning(2.0);
    d.motor(3).disturbed.fault = jauscat::cia402::error_codes::over_current;
    d.run_until([&] { return d.unit().state() == primary_status_code::failure; }, 20ms);
    d.run_until([&] { return d.all_at_rest(); }, 200ms);
    REQUIRE(d.watcher.faults.size() == 1);
    CHECK(d.watcher.faults[0] == bridging::drive_fault{3, jauscat::cia402::error_codes::over_current});
    d.motor(3).disturbed.fault = 0;
    d.tell(jaus::reset{});
    d.run_until([&] { return d.watcher.ended_faults == 1; }, 2s);
    d.run_until([&] { return d.unit().state() != primary_status_code::failure; }, 2s);
    CHECK(d.all_at_rest());
}

TEST_CASE("a drive that no longer follows its target brings all joints to rest, and the component says so") {
    drives d;
    set_positions far{};
    for (std::size_t i = 0; i != joints; ++i) static_cast<void>(far.joint_position.push_back(3.0));
    const auto number = d.tell(far);
    d.run_until([&] { return d.answer(number) == jaus::ack_nak::ack; });
    d.run(50ms);
    REQUIRE(!d.all_at_rest());
    d.motor(2).disturbed.holds = true;
    d.run_until([&] { return !d.watcher.faults.empty(); }, 10ms);
    CHECK(d.watcher.faults.front().slave == 2);
    CHECK(d.watcher.faults.front().reason == "the drive no longer follows its target");
    CHECK(d.unit().state() == primary_status_code::failure);
    d.motor(2).disturbed.holds = false;
    d.run(200ms);
    CHECK(d.all_at_rest());
    CHECK(d.watcher.ended_faults == 1);
    CHECK(d.unit().state() == primary_status_code::ready);
    CHECK(d.watcher.lost == 0);
}

TEST_CASE("drives that are silent for less than their time-out move on") {
    drives d;
    d.run_until_turning(2.0);
    d.frames_to_lose = 8; // 16 ms
    d.run_until([&] { return d.frames_to_lose == 0; }, 100ms);
    d.run(20ms);
    CHECK(d.watcher.lost == 0);
    CHECK(d.watcher.faults.empty());
    CHECK(d.unit().state() == primary_status_code::ready);
    for (std::size_t i = 0; i != joints; ++i) CHECK(std::abs(d.motor(i).velocity()) == Approx(20'000).margin(200));
}

TEST_CASE("a drive that is lost brings the others to rest") {
    drives d;
    d.run_until_turning(2.0);
    d.devices[2].connected = false;
    d.run_until([&] { return d.watcher.lost != 0; }, 100ms);
    d.run_until([&] { return d.all_at_rest(); }, 300ms);
    CHECK(d.unit().state() == primary_status_code::failure);
}

TEST_CASE("joints whose ramp takes longer than the limit are refused with a sentence, and stay at rest") {
    auto arm = joint_arm<1>();
    arm[3].axis.deceleration = 1'500'000; // 134 ms from 200,000
    drives d{bridging::at_rest_within(100ms, 2ms), arm};
    const auto number = d.turn(2.0);
    d.run_until([&] { return d.answer(number).has_value(); }, 1s);
    CHECK(d.answer(number) == jaus::ack_nak::nak);
    CHECK(d.unit().state() == primary_status_code::failure);
    REQUIRE(d.watcher.faults.size() == 1);
    CHECK(d.watcher.faults[0].reason ==
          "joint 4 needs 134 ms from max_velocity to rest by its deceleration, longer than "
          "the 100 ms in which it has to be at rest");
    d.tell(jaus::reset{});
    d.run(500ms);
    CHECK(d.unit().state() == primary_status_code::failure);
    CHECK(d.watcher.lost == 0);
    CHECK(d.all_at_rest());
}

TEST_CASE("a stop whose ramp would take too long is a quick stop in time, and the drives stay in OP") {
    const double rate = GENERATE(0.5, 3.0, 10.0);
    auto arm = joint_arm<1>();
    for (auto& each : arm) each.axis.acceleration = each.axis.deceleration = 1'000'000; // 100 ms from 100,000
    drives d{bridging::at_rest_within(200ms, 5ms), arm};
    d.run_until_turning(rate);
    d.run(200ms);
    CHECK(d.fastest() == Approx(rate * 10'000).margin(200));
    bool has_quick_stop = false;
    d.on_step = [&] {
        has_quick_stop = has_quick_stop || d.motor(0).state() == jauscat::cia402::state::quick_stop_active;
    };
    const auto begun = d.now();
    const auto number = d.tell(jaus::standby{});
    d.run_until([&] { return d.answer(number).has_value(); });
    CHECK(d.answer(number) == jaus::ack_nak::ack);
    CHECK(d.now() - begun < 100ms);
    CHECK(d.all_at_rest());
    CHECK(has_quick_stop == (rate > 5));
    CHECK(d.watcher.lost == 0);
    CHECK(d.watcher.faults.empty());
}

TEST_CASE("drives that brake for longer than the limit stay in OP, and the stop is acknowledged at rest") {
    drives d;
    for (std::size_t i = 0; i != joints; ++i) d.motor(i).values.quick_stop_deceleration = 100'000; // 200 ms from 20,000
    d.run_until_turning(2.0);
    const auto begun = d.now();
    const auto number = d.tell(rig::stop());
    d.run_until([&] { return d.answer(number).has_value(); }, 1s);
    CHECK(d.answer(number) == jaus::ack_nak::ack);
    CHECK(d.now() - begun > 150ms);
    CHECK(d.all_at_rest());
    CHECK(d.watcher.lost == 0);
    CHECK(d.watcher.faults.empty());
}

TEST_CASE("drives that do not brake are taken out of OP within the limit") {
    drives d;
    for (std::size_t i = 0; i != joints; ++i) d.motor(i).values.quick_stop_deceleration = 1'000; // 20 s
    d.run_until_turning(2.0);
    d.tell(rig::stop());
    d.run_until([&] { return d.watcher.lost != 0; }, 100ms);
    CHECK(d.watcher.last_loss == bridging::loss::no_process_data);
}

TEST_CASE("drives that do not go on braking are taken out of OP within the limit, too") {
    drives d;
    for (std::size_t i = 0; i != joints; ++i) d.motor(i).values.quick_stop_deceleration = 100'000; // 200 ms from 20,000
    d.run_until_turning(2.0);
    d.tell(rig::stop());
    d.run(90ms); // by then they have been looked at once
    CHECK(d.watcher.lost == 0);
    CHECK(d.fastest() < 12'000);
    for (std::size_t i = 0; i != joints; ++i) d.motor(i).values.quick_stop_deceleration = 1'000;
    d.run_until([&] { return d.watcher.lost != 0; }, 100ms);
    CHECK(d.watcher.last_loss == bridging::loss::no_process_data);
}

TEST_CASE("commands are executed by drives that need long to enable, and the last one wins") {
    drives d;
    const auto open_in = GENERATE(150ms, 900ms);
    std::array<jauscat::time_point, joints> closed_since{};
    d.on_step = [&] {
        for (std::size_t i = 0; i != joints; ++i) {
            if (d.motor(i).state() != jauscat::cia402::state::switched_on) closed_since[i] = d.now();
            d.close_brake(i, d.now() - closed_since[i] < open_in);
        }
    };
    d.run(10ms);
    std::vector<std::uint16_t> numbers;
    for (unsigned i = 0; i != 40; ++i) {
        numbers.push_back(d.turn(i == 39 ? 2.0 : 1.0));
        d.run(2ms);
    }
    d.run_until([&] { return d.answer(numbers.back()).has_value(); }, 2s);
    CHECK(d.answer(numbers.back()) == jaus::ack_nak::ack);
    for (const auto each : numbers)
        if (each != numbers.back()) CHECK(d.answer(each) == jaus::ack_nak::nak);
    d.run(200ms);
    CHECK(d.fastest() == Approx(20'000).margin(200));
    CHECK(d.watcher.lost == 0);
    const auto next = d.turn(1.0);
    d.run_until([&] { return d.answer(next).has_value(); }, 100ms);
    CHECK(d.answer(next) == jaus::ack_nak::ack);
}

TEST_CASE("commands that come faster than drives confirm them are executed, or replaced by the next") {
    drives d{bridging::at_rest_within(100ms, 20ms)};
    d.run_until_turning(1.0);
    const auto between = GENERATE(5ms, 21ms, 35ms, 55ms);
    const auto stops = d.watcher.stop_causes.size();
    std::vector<std::uint16_t> numbers;
    for (unsigned i = 0; i != 40; ++i) {
        numbers.push_back(d.turn(1.0 + 0.01 * i));
        d.run(between);
    }
    d.run_until([&] { return d.answer(numbers.back()).has_value(); }, 200ms);
    CHECK(d.answer(numbers.back()) == jaus::ack_nak::ack);
    const auto executed =
        std::ranges::count_if(numbers, [&](std::uint16_t each) { return d.answer(each) == jaus::ack_nak::ack; });
    CHECK(executed >= (between < 20ms ? 10 : 40)); // one in each cycle
    CHECK(d.watcher.stop_causes.size() == stops);
}

TEST_CASE("a command that is replaced while its drives prepare is answered in time, however often others follow") {
    drives d;
    d.close_brakes(true);
    d.run(10ms);
    const auto first = d.turn(1.0);
    std::uint16_t last = first;
    for (int i = 0; i != 10; ++i) {
        d.run(100ms);
        last = d.turn(2.0);
    }
    CHECK(d.answer(first) == jaus::ack_nak::nak);
    CHECK(!d.answer(last)); // the drives have their time
    CHECK(d.unit().state() == primary_status_code::ready);
    CHECK(d.watcher.lost == 0);
}

TEST_CASE("a command that waits for its drives is not executed when another component gets control") {
    drives d;
    d.close_brakes(true);
    d.run(10ms);
    const auto number = d.turn(2.0);
    d.run(100ms);
    REQUIRE(!d.answer(number));
    auto taker = rig::operator_unit;
    ++*GENERATE_REF(&taker.instance, &taker.component, &taker.node, &taker.subsystem);
    d.tell_as(taker, jaus::request_component_control{100});
    d.run_until([&] { return d.answer(number).has_value(); }, 100ms);
    CHECK(d.answer(number) == jaus::ack_nak::nak);
    CHECK(d.watcher.stop_causes.back() == bridging::stop_cause::control_taken);
    d.close_brakes(false);
    d.run(500ms);
    CHECK(d.all_at_rest());
    CHECK(d.unit().state() == primary_status_code::ready);
}

TEST_CASE("commands are executed with every period that the limit allows") {
    const auto period = GENERATE(5ms, 8ms, 10ms, 20ms, 50ms);
    drives d{bridging::at_rest_within(std::max<std::chrono::nanoseconds>(100ms, 4 * period), period)};
    for (unsigned i = 0; i != 5; ++i) {
        const auto go = d.turn(1.0);
        d.run_until([&] { return d.answer(go).has_value(); });
        CHECK(d.answer(go) == jaus::ack_nak::ack);
        const auto stop = d.tell(jaus::standby{});
        d.run_until([&] { return d.answer(stop).has_value(); });
        CHECK(d.answer(stop) == jaus::ack_nak::ack);
        CHECK(d.all_at_rest());
        const auto resume = d.tell(jaus::resume{});
        d.run_until([&] { return d.answer(resume).has_value(); });
        CHECK(d.unit().state() == primary_status_code::ready);
    }
    CHECK(d.watcher.lost == 0);
}

TEST_CASE("joints keep their velocity when another user of the bus changes its period") {
    auto arm = joint_arm<1>();
    for (auto& each : arm) each.axis.max_velocity = 20'000;
    drives d{bridging::at_rest_within(500ms, 10ms), arm};
    const auto number = d.tell(jaus::basic_set_joint_positions<joints>{.joint_position = {9, 9, 9, 9, 9, 9}});
    d.run_until([&] { return d.answer(number) == jaus::ack_nak::ack; });
    for (const auto period : {10ms, 1ms, 10ms, 2ms}) {
        d.change_period(period);
        for (unsigned i = 0; i != 25; ++i) {
            const double from = d.motor(0).position();
            const auto begun = d.now();
            d.run(20ms); // a drive that waits for the next target makes up for it
            const double seconds = std::chrono::duration<double>{d.now() - begun}.count();
            CHECK((d.motor(0).position() - from) / seconds == Approx(20'000).epsilon(0.05));
        }
    }
}

TEST_CASE("set-points keep to 60C2h where the period has changed between a drive's bring-up and its start") {
    std::array<std::byte, 64> outputs{}, inputs{};
    bridging::joint_part<joints> part{joint_arm<1>()};
    const std::vector<bridging::slave_data> slaves(joints, {.outputs = outputs, .inputs = inputs});
    for (std::size_t i = 0; i != joints; ++i) REQUIRE(!part.start_up(i, 1ms).empty());
    REQUIRE(part.start(slaves, 10ms));
    for (std::size_t i = 0; i != joints; ++i) CHECK(part.group().axis(i).options().cycle == 1ms);
    bridging::joint_part<joints> other{joint_arm<1>()};
    REQUIRE(other.start(slaves, 10ms));
    CHECK(other.group().axis(0).options().cycle == 10ms);
}

TEST_CASE("an emergency is acknowledged at rest where the drives do not report their velocity") {
    auto arm = joint_arm<1>();
    for (auto& each : arm) each.places.velocity = {};
    drives d{bridging::at_rest_within(500ms, 5ms), arm};
    for (std::size_t i = 0; i != joints; ++i) d.motor(i).values.quick_stop_deceleration = 100'000;
    const auto go = d.tell(jaus::basic_set_joint_positions<joints>{.joint_position = {12, 12, 12, 12, 12, 12}});
    d.run_until([&] { return d.answer(go) == jaus::ack_nak::ack && d.fastest() > 50'000; });
    const auto number = d.tell(rig::stop());
    d.run_until([&] { return d.answer(number).has_value(); }, 2s);
    CHECK(d.answer(number) == jaus::ack_nak::ack);
    CHECK(d.all_at_rest());
    CHECK(d.watcher.lost == 0);
}

TEST_CASE("a component is in Failure until its drive has left the fault, also after Reset") {
    drives d;
    d.motor(3).disturbed.fault = jauscat::cia402::error_codes::over_current; // stays
    d.run_until([&] { return d.unit().state() == primary_status_code::failure; }, 100ms);
    d.tell(jaus::reset{});
    bool was_ready = false;
    d.on_step = [&] { was_ready = was_ready || d.unit().state() == primary_status_code::ready; };
    d.run(2s);
    CHECK(!was_ready);
    CHECK(d.unit().state() == primary_status_code::failure);
    CHECK(d.unit().fault().has_value());
    d.on_step = nullptr;
    d.motor(3).disturbed.fault = 0;
    d.tell(jaus::reset{});
    d.run_until(
        [&] {
            return d.unit().state() == primary_status_code::standby || d.unit().state() == primary_status_code::ready;
        },
        2s);
}
