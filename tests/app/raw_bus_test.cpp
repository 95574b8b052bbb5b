// A bus on raw Ethernet: a pair of virtual interfaces, jc0 and jc1, in a network namespace.
#include "app/emulated_bus.hpp"
#include "support/catch.hpp"
#include "support/until.hpp"
#include <jauscat/app/bus.hpp>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using boost::system::error_code;

namespace {

bool ip(const std::string& arguments) { return std::system(("ip " + arguments).c_str()) == 0; }

} // namespace

TEST_CASE("a bus on a network interface finds its slaves, loses them with the cable, and finds them again") {
    const bool thread = GENERATE(false, true);
    const std::vector<ethercat::slave_description> two{{.vendor = 7, .product = 1, .serial = 10, .name = "axis"},
                                                       {.vendor = 7, .product = 2, .serial = 11, .name = "gripper"}};
    jauscat::test::emulated_bus ring{two, "jc1", "jc0"};
    ring.with(1, [](auto& each) { each.own.add(0x2000, 0, 4); });
    boost::asio::io_context context;
    std::vector<std::string> lines;
    std::vector<std::uint16_t> lost, found;
    std::optional<bus> bus{std::in_place, context, ring.where(),
                           bus_options{.check_interval = 10ms,
                                       .frame_timeout = jauscat::test::frame_timeout,
                                       .thread = thread,
                                       .log = [&](std::string_view line) { lines.emplace_back(line); }}};
    bus->when_lost([&](const slave_info& who, error_code) { lost.push_back(who.position); });
    bus->when_found([&](const slave_info& who) { found.push_back(who.position); });
    const auto wait = [&](auto done) { return support::until(context, done); };

    std::optional<error_code> why;
    bus->async_start([&](error_code error) { why = error; });
    REQUIRE(wait([&] { return why.has_value(); }));
    REQUIRE_FALSE(*why);
    CHECK(bus->slaves().size() == 2);
    const auto gripper = bus->slave({.name = "gripper"});
    gripper.async_write(0x2000, 0, std::uint32_t{7}, [&](error_code error) { why = error; });
    std::optional<std::uint32_t> value;
    gripper.async_read<std::uint32_t>(0x2000, 0, [&](error_code error, std::uint32_t is) {
        why = error;
        value = is;
    });
    REQUIRE(wait([&] { return value.has_value(); }));
    CHECK_FALSE(*why);
    CHECK(*value == 7);

    REQUIRE(ip("link set jc1 down"));
    REQUIRE(wait([&] { return lost.size() == 2; }));
    value.reset();
    gripper.async_read<std::uint32_t>(0x2000, 0, [&](error_code error, std::uint32_t is) {
        why = error;
        value = is;
    });
    REQUIRE(wait([&] { return value.has_value(); }));
    CHECK(why->failed());
    REQUIRE(ip("link set jc1 up"));
    REQUIRE(wait([&] { return found.size() == 2; }));
    CHECK_FALSE(lines.empty());
    bus.reset();
}
