// jauscat-ecat beside another master.
#include "ecat/tool.hpp"
#include "nodes/program.hpp"
#include "support/catch.hpp"
#include <jauscat/net/link/run_master.hpp>

using namespace ecat_test;
using ethercat::al_state;

namespace {

const std::vector<std::string> commands{"scan",
                                        "info",
                                        "state",
                                        "state init --yes",
                                        "read 0x1008 --slave 0",
                                        "write 0x2000 1 --type u32 --slave 0 --yes",
                                        "sdos --slave 0",
                                        "sii --slave 0",
                                        "pdos",
                                        "watch",
                                        "monitor --seconds 1"};

} // namespace

TEST_CASE("jauscat-ecat refuses while a master runs slaves in OP, and leaves them in OP") {
    static const std::vector<ethercat::pdo_entry> outputs{
        {.index = 0x7000, .subindex = 1, .bits = 16, .data_type = 6, .name = "target"}};
    auto slaves = three();
    for (auto& each : slaves) each.outputs = outputs;
    emulated_bus ring{slaves};
    const auto port = ring.where().substr(ring.where().rfind(':') + 1);
    nodes::program cyclic{{support::program("cyclic"), "--ethercat-port", port, "--seconds", "600", "--period", "5000",
                           "--watchdog", "5000", "--log-format", "json"}};
    cyclic.wait_for("ready");
    for (const auto& command : commands) {
        INFO(command);
        const auto ended = run(command + on(ring));
        CHECK(ended.code == in_use);
        CHECK(ended.complains("slave 0 is in OP: a master seems to run it; nothing was changed"));
        CHECK(ended.complains("--force"));
        CHECK(ended.out.empty());
    }
    const auto forced = run("scan --force --format json" + on(ring));
    CHECK(forced.code == done);
    CHECK(forced.parsed()[1]["state"] == "OP");
    CHECK(forced.parsed()[1]["station"] == 2);
    CHECK(states(ring) == all_in(al_state::op));
    CHECK(cyclic.count("slave_stopped") == 0);
    cyclic.signal(SIGINT);
    CHECK(cyclic.wait() == 0);
}

TEST_CASE("cyclic takes the slaves back to PRE-OP where it is stopped before they are in OP") {
    static const std::vector<ethercat::pdo_entry> inputs{
        {.index = 0x6000, .subindex = 1, .bits = 16, .data_type = 6, .name = "position"}};
    auto slaves = three();
    for (auto& each : slaves) {
        each.inputs = inputs;
        each.clock = ethercat::clock_width::bits_64;
    }
    emulated_bus ring{slaves};
    // The reference clock seems to jump: no cycles can follow it.
    std::uint64_t time{};
    ring.on_way_back([&time](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) return;
        for (const auto each : view)
            if (each.header.cmd == ethercat::command::frmw)
                static_cast<void>(jauscat::wire::encode(ethercat::dc_time{time += 700'001}, each.data));
    });
    const auto port = ring.where().substr(ring.where().rfind(':') + 1);
    nodes::program cyclic{
        {support::program("cyclic"), "--ethercat-port", port, "--seconds", "600", "--period", "5000", "--clocks"}};
    while (states(ring) != all_in(al_state::safe_op)) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    cyclic.signal(SIGINT);
    CHECK(cyclic.wait() != 0);
    CHECK(states(ring) == all_in(al_state::pre_op));
}

TEST_CASE("slaves that a program has left in PRE-OP are used, and that is said") {
    emulated_bus ring{three()};
    {
        const auto link = jauscat::net::open_link(ring.where());
        ethercat::master_for<16> master;
        REQUIRE(jauscat::net::run(*link, master, ethercat::bring_up{.position = 1, .station = 77}));
    }
    const auto looked = run("scan --format json" + on(ring));
    CHECK(looked.code == done);
    CHECK(looked.complains("slave 1 is in PRE-OP and has the station address 77: a program has left it so"));
    CHECK(looked.parsed()[1]["state"] == "PRE-OP");
    CHECK(looked.parsed()[1]["station"] == 77);
    CHECK(stations(ring)[1] == 77);
    CHECK(run("read 0x1008 --slave 1" + on(ring)).code == done);
    CHECK(states(ring)[1] == al_state::pre_op);
    CHECK(stations(ring)[1] == 77);
    CHECK(run("state init --yes" + on(ring)).code == done);
    CHECK(states(ring)[1] == al_state::init);
}

TEST_CASE("a mailbox in use is noticed") {
    emulated_bus ring{three()};
    std::atomic<bool> stop{};
    std::atomic<bool> is_up{};
    std::thread other{[&] {
        const auto link = jauscat::net::open_link(ring.where());
        ethercat::master_for<16> master;
        is_up = static_cast<bool>(jauscat::net::run(*link, master, ethercat::bring_up{.position = 1, .station = 77}));
        std::array<std::byte, 64> into{};
        while (!stop) static_cast<void>(jauscat::net::run(*link, master, ethercat::upload{77, 0x1008, 0, into}));
    }};
    while (!is_up) std::this_thread::yield();
    const auto ended = run("scan" + on(ring));
    stop = true;
    other.join();
    CHECK(ended.code == in_use);
    CHECK(ended.complains("its mailbox is in use: a master runs it"));
}
