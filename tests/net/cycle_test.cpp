// Process data and a master on one link, over slaves in memory: what a cycle carries, loses and leaves time for.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/ethercat/slave/image_entries.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/cycle_runner.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

#include <algorithm>
#include <deque>
#include <functional>
#include <thread>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;

namespace {

using translation::wrench_effort_image;
constexpr std::uint16_t station = 7;

/// Frames pass through the slaves at once and are there to be received; some can be lost. Waits where a real link
/// would.
class lossy_link {
  public:
    explicit lossy_link(std::span<ethercat::slave> slaves) : slaves_{slaves} {}
    std::function<bool(ethercat::command)> loses = [](auto) { return false; };
    std::size_t process_frames{}, other_frames{};
    std::size_t max_waiting{}; ///< frames that were there to be received at a time

    bool send(std::span<const std::byte> frame) {
        ethercat::frame_view view;
        REQUIRE(view.parse(frame));
        const auto cmd = (*view.begin()).header.cmd;
        ++(cmd == ethercat::command::lrw ? process_frames : other_frames);
        std::vector<std::byte> passing(frame.begin(), frame.end());
        for (auto& device : slaves_) device.process(passing, net::now());
        if (!loses(cmd)) back_.push_back(std::move(passing));
        max_waiting = std::max(max_waiting, back_.size());
        return true;
    }
    std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) {
        if (back_.empty()) {
            std::this_thread::sleep_for(timeout);
            return 0;
        }
        const auto frame = std::move(back_.front());
        back_.pop_front();
        std::ranges::copy(frame, buffer.begin());
        return frame.size();
    }

  private:
    std::span<ethercat::slave> slaves_;
    std::deque<std::vector<std::byte>> back_{};
};
static_assert(ethercat::link<lossy_link>);

/// One slave with the process data of a robot arm, in OP.
struct robot {
    static constexpr ethercat::slave_description description{
        .outputs = ethercat::image_entries<wrench_effort_image, ethercat::image_objects::outputs>,
        .inputs = ethercat::image_entries<wrench_effort_image, ethercat::image_objects::inputs>,
        .clock = ethercat::clock_width::bits_64};
    test::objects objects{};
    ethercat::standard_objects dictionary{description, objects};
    std::array<ethercat::slave, 1> slaves{ethercat::slave{description, dictionary}};
    lossy_link link{slaves};
    ethercat::master_for<16> master;
    ethercat::process_data_for<1, 64> data{};
    net::cycle_runner<lossy_link> cycles;

    explicit robot(const net::cycle_config& config = {.period = 10ms}, std::chrono::nanoseconds frame_timeout = 1s)
        : master{{.frame_timeout = frame_timeout, .frame_lifetime = 5ms, .retries = 3}},
          cycles{link, data, master, config} {
        done(ethercat::bring_up{0, station});
        done(ethercat::configure{station});
        done(ethercat::change_state{station, ethercat::al_state::safe_op});
        data.set_slaves(master.slaves());
        done(ethercat::change_state{station, ethercat::al_state::op});
        link.process_frames = link.other_frames = 0;
    }
    void done(const auto& job) { REQUIRE(net::run(link, master, job)); }
    ethercat::slave& slave() { return slaves.front(); }
    const ethercat::slave_record& record() { return *master.find(station); }
};

const auto nothing = [](auto&&...) {};

} // namespace

TEST_CASE("a JAUS command is in the slave's outputs one cycle after its arrival, and its report in the inputs") {
    using exchange =
        bridging::image_exchange<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;
    robot r;
    exchange jaus{{.subsystem = 2, .station = station}, 33};
    const auto outputs = [&] { return r.data.outputs(r.record()); };
    const auto inputs = [&] { return r.data.inputs(r.record()); };
    r.cycles.run(nothing);
    REQUIRE(r.data.is_complete());
    REQUIRE(jaus.start(outputs(), inputs()));

    const jaus::header head{.ack_nak = jaus::ack_nak::request,
                            .command_code = exchange::command_code,
                            .destination = {.instance = 1, .component = 33, .node = station, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1}};
    REQUIRE(jaus.takes(head));
    const auto report = r.cycles.run([&] { // what comes before the cycle's frame goes with it
        REQUIRE(jaus.on_command(head, test::from_hex("0200 0180"), outputs(), inputs(), {}) == translate::errc::ok);
    });
    CHECK(report.sent);
    CHECK(report.back);
    CHECK(report.round_trip > 0ns);
    REQUIRE(r.slave().take_outputs());
    CHECK(test::to_hex(r.slave().outputs()) == "01 00 02 00 00 00 01 80 00 00 00 00 00 00 00 00 00 00 00 00 00 00");

    std::ranges::copy(r.slave().outputs(), r.slave().inputs().begin()); // the slave has it in force
    std::array<std::byte, 16> answer{};
    CHECK(jaus.acknowledgement(inputs(), {}, answer) == 0);
    r.cycles.run(nothing);
    CHECK(jaus.acknowledgement(inputs(), {}, answer) == 16);
    CHECK(jaus::split(answer).header.ack_nak == jaus::ack_nak::ack);
}

TEST_CASE("a job without a time limit runs to its end") {
    robot r;
    CHECK(net::run(r.link, r.master, ethercat::check{station}, std::chrono::nanoseconds::max()));
    CHECK(r.cycles.run_job(ethercat::check{station}, std::chrono::nanoseconds::max(), nothing, nothing));
}

TEST_CASE("process data that do not return are lost, and the next cycle runs nevertheless") {
    robot r;
    bool lose = false;
    r.link.loses = [&](auto) { return lose; };
    for (int i = 0; i != 9; ++i) {
        lose = i % 3 == 1;
        const auto report = r.cycles.run(nothing);
        CHECK(report.sent);
        CHECK(report.back == !lose);
    }
    r.cycles.run(nothing);
    CHECK(r.data.statistics().sent == 10);
    CHECK(r.data.statistics().complete == 7);
    CHECK(r.data.statistics().lost == 3);
}

TEST_CASE("an upload continues in the time between cycles, without delaying them") {
    robot r;
    std::array<std::byte, 4> vendor{};
    std::size_t cycles = 0;
    for (int i = 0; i != 5; ++i) {
        REQUIRE(r.cycles.run_job(ethercat::upload{station, 0x1018, 1, vendor}, 1s, nothing, [&](const auto& report) {
            ++cycles;
            CHECK(report.back);
        }));
    }
    CHECK(r.data.statistics().complete == cycles);
    CHECK(r.link.process_frames == cycles);
    CHECK(r.link.other_frames >= 10);
}

TEST_CASE("a job without answers is abandoned while cycles continue") {
    robot r{{.period = 10ms}, 30ms};
    r.link.loses = [](ethercat::command cmd) { return cmd != ethercat::command::lrw; };
    std::array<std::byte, 4> vendor{};
    CHECK(r.cycles.run_job(ethercat::upload{station, 0x1018, 1, vendor}, 10s, nothing, nothing).error().code ==
          ethercat::master_errc::no_reply);
    CHECK(r.cycles.run_job(ethercat::upload{station, 0x1018, 1, vendor}, 6ms, nothing, nothing).error().code ==
          ethercat::master_errc::timeout);
    CHECK(r.data.statistics().complete == r.data.statistics().sent);
}

TEST_CASE("a job continues while no process data return") {
    robot r;
    r.link.loses = [](ethercat::command cmd) { return cmd == ethercat::command::lrw; };
    std::array<std::byte, 4> vendor{};
    CHECK(r.cycles.run_job(ethercat::upload{station, 0x1018, 1, vendor}, 5s, nothing, nothing));
    CHECK(r.data.statistics().complete == 0);
    // Where the master's frames are lost, too, it learns so.
    robot silent{{.period = 10ms}, 20ms};
    silent.link.loses = [](auto) { return true; };
    CHECK(silent.cycles.run_job(ethercat::upload{station, 0x1018, 1, vendor}, 5s, nothing, nothing).error().code ==
          ethercat::master_errc::no_reply);
}

TEST_CASE("process data that arrived while the thread was preempted are received before the master sends") {
    robot r;
    r.link.loses = [](ethercat::command cmd) {
        if (cmd == ethercat::command::lrw) std::this_thread::sleep_for(6ms); // past the master's turn at 5 ms
        return false;
    };
    r.link.max_waiting = 0;
    std::array<std::byte, 4> vendor{};
    CHECK(r.cycles.run_job(ethercat::upload{station, 0x1018, 1, vendor}, 5s, nothing, nothing));
    CHECK(r.link.max_waiting == 1);
}

TEST_CASE("a job that could not start between cycles does not return the running job's result") {
    robot r;
    std::array<std::byte, 4> vendor{};
    REQUIRE(r.master.start(ethercat::upload{station, 0x1018, 1, vendor}));
    const auto refused = r.cycles.run_job(ethercat::bring_up{0, station}, 1s, nothing, nothing);
    CHECK(refused.error().code == ethercat::master_errc::busy);
    CHECK(r.data.statistics().sent == 0);
    CHECK(r.cycles.run_job(1s, nothing, nothing));
    CHECK(r.slave().state() == ethercat::al_state::op);
}

TEST_CASE("lost process data do not delay the next cycle") {
    robot r{{.period = 40ms}};
    r.link.loses = [](auto) { return true; };
    constexpr unsigned count = 10;
    for (unsigned i = 0; i != count; ++i) r.cycles.run(nothing);
    CHECK(r.data.statistics().sent == count);
    CHECK(r.cycles.overruns() < count / 2); // a busy machine may leave out one or two
}

TEST_CASE("the master sends no frame in the part of a cycle that is reserved for the next") {
    robot r{{.period = 10ms, .reserve = 1}}; // all of it
    std::array<std::byte, 4> vendor{};
    REQUIRE(r.master.start(ethercat::upload{station, 0x1018, 1, vendor}));
    for (int i = 0; i != 5; ++i) CHECK(r.cycles.run(nothing).back);
    CHECK(r.cycles.run_job(1ns, nothing, nothing).error().code == ethercat::master_errc::timeout);
    CHECK(r.link.other_frames == 0);
}

TEST_CASE("the frames of a cycle are exchanged back to back, also over a link that holds one at a time") {
    static std::array<ethercat::pdo_entry, 128> many{};
    many.fill(ethercat::pdo_entry{0x7000, 1, 32, 7, "word"});
    test::objects objects{};
    const ethercat::slave_description description{.outputs = many, .inputs = many};
    ethercat::standard_objects dictionary{description, objects};
    std::vector<ethercat::slave> slaves(3, ethercat::slave{description, dictionary});
    ethercat::loopback_link link{slaves};
    ethercat::master_for<3> master;
    for (std::uint16_t i = 0; i != 3; ++i) {
        const auto at = static_cast<std::uint16_t>(i + 1);
        REQUIRE(net::run(link, master, ethercat::bring_up{i, at}));
        REQUIRE(net::run(link, master, ethercat::configure{at}));
        REQUIRE(net::run(link, master, ethercat::change_state{at, ethercat::al_state::safe_op}));
    }
    ethercat::process_data_for<3, 3072> data{master.slaves(), {.watch_slaves = true}};
    REQUIRE(data.frame_count() == 3);
    net::cycle_runner cycles{link, data, master, {.period = 5ms}};
    for (auto& each : slaves) each.inputs()[511] = std::byte{0x5A};
    for (int i = 0; i != 3; ++i) {
        const auto report = cycles.run(nothing);
        CHECK(report.sent);
        CHECK(report.back);
    }
    CHECK(data.is_complete());
    CHECK(data.statistics().complete == 3);
    CHECK(data.statistics().frames == 9);
    CHECK(data.statistics().lost == 0);
    for (const auto& slave : master.slaves()) CHECK(data.inputs(slave)[511] == std::byte{0x5A});
}

TEST_CASE("a cycle that receives first has the inputs of the cycle before, and waits for nothing") {
    robot r{{.period = 10ms, .order = net::cycle_order::receive_first}};
    r.slave().inputs()[3] = std::byte{0x5A};
    const auto input = [&] { return r.data.inputs(r.record())[3]; };
    auto report = r.cycles.run([&] { CHECK(input() == std::byte{}); });
    CHECK(report.sent);
    CHECK_FALSE(report.back); // there was none before
    CHECK(input() == std::byte{});
    report = r.cycles.run([&] { CHECK(input() == std::byte{0x5A}); });
    CHECK(report.back);
    CHECK(report.round_trip == 0ns);
    CHECK(r.data.is_complete());

    bool lose = true;
    r.link.loses = [&](auto) { return lose; };
    CHECK(r.cycles.run(nothing).back); // the last one that was not lost
    lose = false;
    CHECK_FALSE(r.cycles.run(nothing).back);
    CHECK(r.cycles.run(nothing).back);
    CHECK(r.data.statistics().lost == 1);
    // The master's jobs go between cycles, as in the other order.
    CHECK(r.cycles.run_job(ethercat::check{station}, 1s, nothing, nothing));
    CHECK(r.data.statistics().lost == 1);
}

TEST_CASE("cycles carry the reference clock's time and follow it") {
    const auto order = GENERATE(net::cycle_order::send_first, net::cycle_order::receive_first);
    robot r{{.period = 10ms, .order = order}};
    std::array clocks{ethercat::clock_record{.station = station}};
    const auto network =
        net::run(r.link, r.master, ethercat::set_up_clocks{.slaves = clocks, .options = {.drift_frames = 10}});
    REQUIRE(network);
    ethercat::clock_cycle clock{
        clocks, *network, 0, {.control = {.period = 10ms, .phase = 5ms, .proportional = 2, .largest_correction = 5ms}}};
    r.cycles.set_clocks(&clock);
    duration least = 10ms;
    const auto cycle = [&](bool has_before) {
        CHECK(r.cycles
                  .run([&] {
                      if (!has_before) return; // the frames of the cycle before are back in both orders
                      CHECK(clock.is_complete());
                      CHECK(r.data.is_complete());
                      least = std::min(least, std::chrono::abs(clock.control().error()));
                  })
                  .sent);
    };
    for (int i = 0; i != 30; ++i) cycle(i != 0);
    CHECK(least < 1ms);
    CHECK(clock.statistics().sent == 30);
    CHECK(clock.statistics().lost == 0);
    r.link.loses = [](ethercat::command cmd) { return cmd == ethercat::command::frmw; };
    for (int i = 0; i != 3; ++i) CHECK(r.cycles.run([] {}).sent);
    CHECK(clock.statistics().lost == 2);
    r.cycles.set_clocks(nullptr);
    CHECK(r.cycles.run([&] { CHECK(r.data.is_complete()); }).back); // process data go nevertheless
    CHECK(clock.statistics().sent == 33);
}
