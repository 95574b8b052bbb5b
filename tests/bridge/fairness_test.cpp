// Large and small messages to one slave, of several components and of others on the bus; slow and dead slaves beside
// it.
#include "rig.hpp"

using namespace test;

namespace {

using path = jaus::set_end_effector_path_motion;

/// Two components in front of one slave. A path of 47 poses is as large as a message can be: 7 mailboxes of the slave.
struct shared_slave {
    shared_slave() {
        other = r.add_unit(0, 34);
        r.run_until_ready();
    }
    std::uint16_t send_large(std::size_t to) { return r.tell(path{.pose = poses}, to); }
    std::uint16_t send_small(std::size_t to) { return r.tell(jaus::set_travel_speed{.desired_speed = 3}, to); }
    /// How long until it is acknowledged.
    std::chrono::nanoseconds time_of(std::uint16_t number) {
        return r.run_until([&] { return r.is_acknowledged(number); });
    }

    std::array<jaus::end_effector_path_pose, 47> poses{};
    rig r;
    std::size_t other{};
};

/// An application that reads one object of a slave after the other.
struct reader {
    std::uint16_t station{};
    unsigned reads{};
    std::array<std::byte, 64> name{};

    bool begin(ethercat::master& idle) {
        return station != 0 && idle.start(ethercat::upload{station, 0x1008, 0, name}).has_value();
    }
    void done(ethercat::master& idle) {
        CHECK(idle.error() == ethercat::master_error{});
        ++reads;
    }
    void cycle() {}
    [[nodiscard]] bridging::shared_jobs jobs() {
        return {.begin = jaus::bound<&reader::begin>(*this),
                .done = jaus::bound<&reader::done>(*this),
                .cycle = jaus::bound<&reader::cycle>(*this)};
    }
};

} // namespace

TEST_CASE("a small message waits for one large message of another component of its slave, not for all of them") {
    shared_slave s;
    const auto large = s.time_of(s.send_large(0));
    const auto small = s.time_of(s.send_small(s.other));
    CHECK(large > 5 * small);
    std::vector<std::uint16_t> numbers;
    for (int i = 0; i != 10; ++i) numbers.push_back(s.send_large(0));
    s.r.run(1ms); // the first one is on its way
    CHECK(s.time_of(s.send_small(s.other)) <= large + small);
    CHECK(std::ranges::count_if(numbers, [&](auto number) { return s.r.answer(number).has_value(); }) == 1);
    for (const auto number : numbers) s.time_of(number);
}

TEST_CASE("a large message waits for one small message of another component of its slave, not for all of them") {
    shared_slave s;
    const auto large = s.time_of(s.send_large(0));
    const auto small = s.time_of(s.send_small(s.other));
    std::vector<std::uint16_t> numbers;
    for (std::uint8_t i = 0; i != 12; ++i)
        numbers.push_back(s.r.tell(jaus::set_travel_speed{.desired_speed = 3}, s.other, jaus::ack_nak::request,
                                   {.instance = i, .component = 32, .node = 1, .subsystem = 1}));
    CHECK(s.time_of(s.send_large(0)) <= large + 2 * small);
    CHECK(s.r.answer(numbers[0]));
    CHECK_FALSE(s.r.answer(numbers[2]));
    for (const auto number : numbers) s.time_of(number);
}

TEST_CASE("large and small messages of two components to one slave take turns for as long as both send") {
    shared_slave s;
    std::array<std::uint16_t, 2> waiting{};
    std::array<unsigned, 2> executed{};
    for (int i = 0; i != 2000; ++i) {
        for (const std::size_t unit : {std::size_t{0}, s.other}) {
            if (waiting[unit] != 0 && !s.r.answer(waiting[unit])) continue;
            executed[unit] += waiting[unit] != 0 && s.r.is_acknowledged(waiting[unit]);
            waiting[unit] = unit == 0 ? s.send_large(unit) : s.send_small(unit);
        }
        s.r.run(100us);
    }
    CHECK(executed[0] > 20);
    CHECK(executed[1] >= executed[0]);
    CHECK(executed[1] <= executed[0] + 1);
    CHECK(s.r.watcher.refusals.empty());
}

TEST_CASE("a component that fills the queue of its slave leaves a place to each other one") {
    shared_slave s;
    std::vector<std::uint16_t> numbers;
    for (int i = 0; i != 20; ++i) numbers.push_back(s.send_large(0)); // 16 places, and one is on its way
    CHECK(s.r.is_refused(numbers[16]));
    CHECK(s.r.is_refused(numbers.back()));
    CHECK(s.r.watcher.refusals == std::vector(4, bridging::refusal::queue_full));
    const auto number = s.send_small(s.other);
    CHECK_FALSE(s.r.answer(number));
    s.time_of(number);
    for (std::size_t i = 0; i != 16; ++i) s.time_of(numbers[i]);
}

TEST_CASE("a stop order waits for the large message that is on its way to its slave, and for no other") {
    shared_slave s;
    const auto large = s.time_of(s.send_large(0));
    std::vector<std::uint16_t> numbers;
    for (int i = 0; i != 10; ++i) numbers.push_back(s.send_large(0));
    s.r.run(1ms);
    CHECK(s.time_of(s.r.tell(rig::stop(), s.other)) <= large);
    CHECK(s.r.motor().emergency);
    CHECK(std::ranges::count_if(numbers, [&](auto number) { return s.r.answer(number).has_value(); }) == 1);
}

TEST_CASE("messages to a slave pass between the reads of an application that reads its objects all the time") {
    shared_slave s;
    const auto small = s.time_of(s.send_small(0));
    reader all_the_time{.station = 2};
    s.r.bus.share(all_the_time.jobs());
    s.r.run(100ms);
    CHECK(all_the_time.reads > 50);
    for (int i = 0; i != 10; ++i) {
        CHECK(s.time_of(s.send_small(0)) <= 4 * small);
        CHECK(s.time_of(s.send_small(s.other)) <= 4 * small);
    }
    const auto reads = all_the_time.reads;
    s.send_large(0);
    s.send_large(s.other);
    s.r.run_until([&] { return all_the_time.reads > reads + 3; }, 50ms);
    s.r.run(1s);
    CHECK(s.r.watcher.lost == 0);
}

TEST_CASE("a read of an application that its slave does not answer is cancelled for a stop order to that slave") {
    rig r{rig::driving{50}};
    struct one_read {
        bool is_wanted{true};
        std::array<std::byte, 64> name{};
        std::optional<ethercat::master_error> ended{};

        bool begin(ethercat::master& idle) {
            return std::exchange(is_wanted, false) && idle.start(ethercat::upload{2, 0x1008, 0, name});
        }
        void done(ethercat::master& idle) { ended = idle.error(); }
        void cycle() {}
    } read;
    r.actuators[0].hangs = true;
    r.bus.share({.begin = jaus::bound<&one_read::begin>(read),
                 .done = jaus::bound<&one_read::done>(read),
                 .cycle = jaus::bound<&one_read::cycle>(read)});
    r.run(1ms);
    REQUIRE(!read.is_wanted);
    const auto number = r.tell(rig::stop());
    CHECK(r.run_until([&] { return read.ended.has_value(); }) <= r.options.stop_timeout + 1ms);
    CHECK(read.ended->code == ethercat::master_errc::timeout);
    r.actuators[0].hangs = false;
    r.run_until_acknowledged(number, 100ms);
    CHECK(r.motor().emergency);
}

TEST_CASE("a slave whose application hangs while it is brought up does not delay messages to others") {
    rig r{3};
    r.actuators[1].hangs = true;
    r.run_until([&] { return r.fronts[0].up() && r.fronts[2].up(); });
    r.run(100ms);
    for (std::size_t i = 0; i != 20; ++i) {
        const auto took = r.run_until_acknowledged(r.drive(20, 2 * (i % 2)));
        CHECK(took <= 2ms);
        r.run(130ms);
    }
    CHECK(r.watcher.failed_bring_ups > 2);
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("a slave whose answers take long does not delay messages to others") {
    rig r{3};
    r.run_until_ready();
    // Each step of its application takes 20 ms.
    auto next = r.now + 20ms;
    r.on_way_back = [&](std::span<std::byte>) {
        r.actuators[1].hangs = r.now < next;
        if (!r.actuators[1].hangs) next = r.now + 20ms;
    };
    r.actuators[1].hangs = true;
    const auto slow = r.drive(30, 1);
    r.run(1ms);
    for (std::size_t i = 0; i != 5; ++i) {
        CHECK_FALSE(r.answer(slow));
        CHECK(r.run_until_acknowledged(r.drive(20, 2 * (i % 2))) <= 2ms);
    }
    r.run_until([&] { return r.is_acknowledged(slow); });
    CHECK(r.watcher.lost == 0);
}
