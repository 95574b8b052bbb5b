// jauscat-ecat on raw Ethernet: a pair of virtual interfaces, jc0 and jc1, in a network namespace.
#include "ecat/tool.hpp"
#include "support/catch.hpp"
#include <jauscat/net/link/run_master.hpp>

using namespace ecat_test;

TEST_CASE("scan, read and state work on a network interface") {
    emulated_bus ring{three(), "jc1", "jc0"};
    const auto found = run("scan --format json --link jc0");
    INFO(found.err);
    CHECK(found.code == done);
    REQUIRE(found.parsed().size() == 3);
    CHECK(found.parsed()[1]["name"] == "gripper");
    CHECK(run("read 0x1018:1-4 --slave 1 --link jc0").code == done);
    CHECK(run("state pre-op --yes --link jc0").code == done);
    CHECK(states(ring) == all_in(ethercat::al_state::pre_op));
}

TEST_CASE("frames of another master are heard, and refused before anything is sent") {
    emulated_bus ring{three(), "jc1", "jc0"};
    std::atomic<bool> stop{};
    std::thread other{[&] {
        const auto link = jauscat::net::open_link("jc0");
        ethercat::master_for<16> master;
        std::array<std::byte, 2> data{};
        while (!stop) {
            static_cast<void>(
                jauscat::net::run(*link, master, ethercat::exchange_datagram{ethercat::command::brd, 0, 0x130, data}));
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
    }};
    const auto refused = run("scan --link jc0");
    const auto forced = run("scan --force --link jc0");
    stop = true;
    other.join();
    CHECK(refused.code == in_use);
    CHECK(refused.complains("jc0: another master uses the link"));
    CHECK(refused.complains("frames were heard in 100 ms; nothing was changed"));
    CHECK(forced.code == done);
    CHECK(forced.says("gripper"));
}

TEST_CASE("an interface that cannot be used is explained") {
    const auto wrong = run("scan --link jc7");
    CHECK(wrong.code == failed);
    CHECK(wrong.complains("there is no interface jc7"));
    const auto unprivileged = run("scan --link jc0", "setpriv --bounding-set -net_raw --inh-caps -net_raw timeout 60");
    CHECK(unprivileged.code == failed);
    CHECK(unprivileged.complains("setcap cap_net_raw+ep"));
    const auto nobody = run("scan --link jc0 --frame-timeout 5");
    CHECK(nobody.code == failed);
    CHECK(nobody.complains("jc0: frames do not return: check the cable"));
    REQUIRE(std::system("ip link set jc0 down") == 0);
    const auto down = run("scan --link jc0");
    CHECK(down.code == failed);
    CHECK(down.complains("jc0"));
}
