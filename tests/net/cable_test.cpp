// A master and a slave on a pair of virtual Ethernet interfaces, jc0 and jc1, with a cable that is unplugged and
// plugged in again: see support/in_veth.sh; and other faults of a wire.
#include "ethercat/objects.hpp"
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/interfaces.hpp"
#include "support/slave_thread.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <atomic>
#include <string>

using namespace jauscat;
using namespace std::chrono_literals;
using ethercat::master_errc;
using support::ip;

namespace {

constexpr std::uint16_t station = 2;

std::vector<std::byte> numbered(std::size_t size) {
    std::vector<std::byte> data(size);
    for (std::size_t i = 0; i != size; ++i) data[i] = static_cast<std::byte>(i * 7 + 1);
    return data;
}

/// One slave with one object of 1000 bytes, which takes 10 messages, and a master at the other end.
struct bench {
    test::objects objects{};
    std::array<std::byte, 1000> memory{};
    std::array<ethercat::slave, 1> slaves{
        ethercat::slave{ethercat::slave_description{}, objects, {.transfer_memory = memory}}};
    net::raw_link link{"jc0"};
    // The slave is a thread, and the machine may be busy.
    ethercat::master_for<16> master{{.retries = 24, .mailbox_timeout = 5s}};
    std::vector<std::byte> data = numbered(1000);

    bench() { objects.add(0x2000, 1, 1000); }

    ethercat::bring_up::result_type bring_up() { return net::run(link, master, ethercat::bring_up{0, station}); }
    ethercat::download::result_type download() {
        return net::run(link, master, ethercat::download{station, 0x2000, 1, data});
    }
    ethercat::upload::result_type upload(std::span<std::byte> into) {
        return net::run(link, master, ethercat::upload{station, 0x2000, 1, into});
    }

    /// Brings the slave up, writes the object and reads it back.
    void works() {
        REQUIRE(bring_up().error().code == master_errc::ok);
        REQUIRE(download().error().code == master_errc::ok);
        std::vector<std::byte> read(data.size());
        const auto result = upload(read);
        REQUIRE(result.error().code == master_errc::ok);
        CHECK(result->size() == data.size());
        CHECK(read == data);
    }
};

} // namespace

TEST_CASE("the interface goes down during a transfer and comes back", "[veth]") {
    bench b;
    std::atomic<unsigned> until_down = ~0u;
    test::slave_thread slave{"jc1", b.slaves, [&](auto&) {
                                 if (--until_down == 0) ip("link set jc0 down");
                             }};
    b.works();
    std::ranges::reverse(b.data);
    until_down = 6;
    CHECK(b.download().error().code == master_errc::not_sent);
    CHECK(b.link.problem() == "interface jc0 is down; run: sudo ip link set jc0 up");
    CHECK(b.bring_up().error().code == master_errc::not_sent);
    REQUIRE(ip("link set jc0 up"));
    b.works();
}

TEST_CASE("the cable is unplugged during a transfer and plugged in again", "[veth]") {
    bench b;
    std::atomic<unsigned> until_down = ~0u;
    test::slave_thread slave{"jc1", b.slaves, [&](auto&) {
                                 if (--until_down == 0) ip("link set jc1 down");
                             }};
    b.works();
    std::ranges::reverse(b.data);
    until_down = 6;
    CHECK(b.download().error().code == master_errc::no_reply);
    CHECK(b.link.problem() == "no link on jc0: is the cable in, and the other end on?");
    CHECK(b.bring_up().error().code == master_errc::no_reply);
    CHECK(b.link.problem() == "no link on jc0: is the cable in, and the other end on?");
    REQUIRE(ip("link set jc1 up"));
    b.works();
}

TEST_CASE("a frame that the interface drops is lost, as on the wire, and is no refusal", "[veth]") {
    bench b;
    test::slave_thread slave{"jc1", b.slaves, [](auto&) {}};
    b.works();
    REQUIRE(ip("link set jc1 mtu 68")); // the kernel drops longer frames: "No buffer space available"
    std::vector<std::byte> frame(200, std::byte{0xFF});
    CHECK(b.link.send(frame));
    std::array<std::byte, ethercat::max_frame_size> buffer{};
    CHECK(b.link.receive(buffer, 1ms) == 0);
    CHECK(b.link.problem() == "interface jc0: No buffer space available");
    CHECK(b.download().error().code == master_errc::no_reply);
    REQUIRE(ip("link set jc1 mtu 1500"));
    b.works();
    CHECK(b.link.problem().empty());
}

TEST_CASE("a short interruption of the cable costs only time", "[veth]") {
    bench b;
    // It is out for as long as the machine needs for two commands.
    b.master.reset({.retries = 1000, .mailbox_timeout = 20s});
    std::atomic<unsigned> until_down = ~0u;
    test::slave_thread slave{"jc1", b.slaves, [&](auto&) {
                                 if (--until_down == 0) ip("link set jc1 down && sleep 0.05 && ip link set jc1 up");
                             }};
    b.works();
    std::ranges::reverse(b.data);
    until_down = 6;
    const auto lost = b.master.statistics().lost;
    CHECK(b.download().error().code == master_errc::ok);
    CHECK(b.master.statistics().lost > lost);
    CHECK(b.objects.entries.at({0x2000, 1}).value == b.data);
}

TEST_CASE("a slave's replies may have a VLAN tag and another source address", "[veth]") {
    bench b;
    using support::bytes;
    for (const auto& tag : {bytes(0x81, 0x00, 0x00, 0x00), bytes(0x81, 0x00, 0xA0, 0x05)}) {
        b.master.reset({.frame_timeout = 2s}); // nothing is asked twice
        test::slave_thread slave{"jc1", b.slaves, [&](auto& frame) {
                                     frame[6] |= std::byte{0x02}; // as a slave controller does
                                     frame.insert(frame.begin() + 12, tag.begin(), tag.end());
                                 }};
        b.works();
        CHECK(slave.frames() == b.master.statistics().sent);
        CHECK(b.master.statistics().ignored == 0);
    }
}

TEST_CASE("late and duplicate replies are ignored", "[veth]") {
    bench b;
    std::vector<std::byte> before;
    unsigned frame_number = 0;
    net::raw_link injector{"jc1"};
    test::slave_thread slave{"jc1", b.slaves, [&](auto& frame) {
                                 // In front of each reply the one before, once more; each tenth comes in that way only.
                                 if (!before.empty()) static_cast<void>(injector.send(before));
                                 before = frame;
                                 if (++frame_number % 10 == 0) frame.clear();
                             }};
    b.works();
    const auto& seen = b.master.statistics();
    CHECK(seen.lost >= 5);
    CHECK(seen.ignored > 50);
    CHECK(seen.foreign == 0);
}
