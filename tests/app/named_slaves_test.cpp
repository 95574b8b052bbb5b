// A bus whose options name its slaves: identified, refused by name, taken in when they come, or come elsewhere.
#include "app/emulated_bus.hpp"
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include "support/scratch.hpp"
#include "support/until.hpp"
#include <jauscat/app/bus.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using boost::system::error_code;
namespace asio = boost::asio;

namespace {

using jauscat::test::emulated_bus;

constexpr ethercat::pdo_entry told{.index = 0x7000, .subindex = 1, .bits = 16, .name = "told"};
constexpr ethercat::pdo_entry actual{.index = 0x6000, .subindex = 1, .bits = 16, .name = "actual"};

ethercat::slave_description axis(std::uint16_t alias) {
    return {.vendor = 7,
            .product = 1,
            .station_alias = alias,
            .name = "axis",
            .outputs = {&told, 1},
            .inputs = {&actual, 1}};
}
/// Two axes that only their aliases tell apart, a gripper, and a spare axis.
std::vector<ethercat::slave_description> devices() {
    return {axis(17), axis(18), {.vendor = 7, .product = 2, .serial = 11, .name = "gripper"}, axis(19)};
}
/// A mode that is written at the start.
std::vector<net::start_up_sdo> mode(std::uint8_t value) {
    return {{.index = 0x2001, .subindex = 1, .data = {std::byte{value}, std::byte{0}}}};
}
// [names]
std::vector<net::slave_entry> arm() {
    return {{.name = "shoulder", .alias = 17, .start_up = mode(8)},
            {.name = "elbow", .alias = 18, .vendor = 7, .start_up = mode(9)},
            {.name = "gripper", .position = 2, .product = 2},
            {.name = "spare", .alias = 19, .is_optional = true}};
}
// [names end]

struct bench {
    explicit bench(std::vector<std::size_t> order = {0, 1, 2}, std::vector<net::slave_entry> names = arm(),
                   const std::vector<ethercat::slave_description>& of = devices(),
                   duration timeout = bus_options{}.timeout)
        : ring{of} {
        ring.connect(std::move(order));
        for (std::size_t i = 0; i != of.size(); ++i)
            ring.with(i, [](auto& each) {
                each.own.add(0x2001, 1, 2);
                each.application = [](ethercat::slave& device) {
                    if (device.take_outputs() && !device.inputs().empty())
                        std::ranges::copy(device.outputs(), device.inputs().begin());
                };
            });
        bus.emplace(context, ring.where(),
                    bus_options{.slaves = std::move(names),
                                .timeout = timeout,
                                .check_interval = 20ms,
                                .frame_timeout = jauscat::test::frame_timeout,
                                .log = [this](std::string_view line) { lines.emplace_back(line); }});
        bus->when_lost([this](const slave_info& who, error_code why) { lost.emplace_back(who.configured_name, why); });
        bus->when_found([this](const slave_info& who) { found.emplace_back(who.configured_name, who.position); });
    }
    error_code outcome(auto start) {
        std::optional<error_code> error;
        start([&](error_code why) { error = why; });
        REQUIRE(until([&] { return error.has_value(); }));
        return *error;
    }
    error_code start() {
        return outcome([&](auto done) { bus->async_start(done); });
    }
    bool until(auto done) {
        const bool is_done = support::until(context, done);
        for (const auto& line : lines) UNSCOPED_INFO(line);
        return is_done;
    }
    /// The station alias of the slave behind the name, or why there is none.
    std::pair<unsigned, error_code> alias_of(const char* name) {
        error_code error;
        const auto info = bus->slave({.name = name}).info(error);
        return {info.alias, error};
    }
    error_code error_of(const char* name) { return alias_of(name).second; }
    unsigned mode_of(std::size_t i) {
        unsigned value{};
        ring.with(i, [&](auto& each) {
            value = std::to_integer<unsigned>(each.own.entries.at({0x2001, std::uint8_t{1}}).value[0]);
        });
        return value;
    }
    bool has_line(std::string_view part) const {
        return std::ranges::any_of(lines, [&](const auto& line) { return line.find(part) != line.npos; });
    }

    emulated_bus ring;
    asio::io_context context{};
    std::vector<std::string> lines{};
    std::vector<std::pair<std::string, error_code>> lost{};
    std::vector<std::pair<std::string, std::uint16_t>> found{};
    std::optional<class bus> bus{};
};

} // namespace

TEST_CASE("slaves are found by the names of the options, wherever they are") {
    bench b{{1, 0, 2}};
    REQUIRE_FALSE(b.start());
    CHECK(b.alias_of("shoulder") == std::pair{17U, error_code{}});
    CHECK(b.alias_of("elbow") == std::pair{18U, error_code{}});
    const auto elbow = b.bus->slave({.name = "elbow"});
    CHECK(elbow.info().position == 0);
    CHECK(elbow.info().configured_name == "elbow");
    CHECK(elbow.info().name == "axis");
    CHECK(b.bus->slave({.name = "gripper"}).info().serial == 11);
    CHECK(b.bus->slave({.position = 1, .name = "shoulder"}).info().alias == 17);
    error_code error;
    static_cast<void>(b.bus->slave({.position = 0, .name = "shoulder"}).info(error));
    CHECK(error == bus_errc::wrong_slave);
    CHECK(b.error_of("spare") == bus_errc::missing_slave); // it is optional
    CHECK_FALSE(b.has_line("spare"));
    CHECK(b.mode_of(0) == 8); // start-up objects
    CHECK(b.mode_of(1) == 9);
    CHECK(b.has_line("slave \"elbow\" at position 0 is there"));
    CHECK_FALSE(b.start()); // again
    CHECK(b.alias_of("elbow") == std::pair{18U, error_code{}});
    CHECK(b.lost.empty());
}

TEST_CASE("a slave that is not as the options say is refused by its name, and the others run") {
    SECTION("missing") {
        bench b{{0, 2}, {{.name = "shoulder", .alias = 17}, {.name = "elbow", .alias = 18}}};
        CHECK(b.start() == bus_errc::missing_slave);
        CHECK(b.error_of("elbow") == bus_errc::missing_slave);
        CHECK(b.has_line("slave \"elbow\" is refused: the slave is missing"));
        CHECK(b.has_line("slave 1 (gripper) is none of the named slaves"));
        CHECK_FALSE(b.error_of("shoulder"));
        CHECK(b.outcome([&](auto done) {
            b.bus->slave({.name = "elbow"}).async_write(0x2001, 1, std::uint16_t{1}, done);
        }) == bus_errc::missing_slave);
        CHECK_FALSE(b.outcome(
            [&](auto done) { b.bus->slave({.name = "shoulder"}).async_write(0x2001, 1, std::uint16_t{1}, done); }));
    }
    SECTION("swapped") {
        bench b{{0, 2, 1},
                {{.name = "shoulder", .position = 0, .product = 1},
                 {.name = "elbow", .position = 1, .product = 1},
                 {.name = "gripper", .position = 2, .product = 2}}};
        CHECK(b.start() == bus_errc::swapped_slave);
        CHECK(b.error_of("elbow") == bus_errc::swapped_slave);
        CHECK(b.error_of("gripper") == bus_errc::swapped_slave);
        CHECK(b.has_line("slave \"elbow\" is refused: the slave is at another place: exchange the cables, or correct "
                         "the position (position 1: vendor 7h, product 2h, revision 1h, serial 11)"));
        CHECK_FALSE(b.error_of("shoulder"));
    }
    SECTION("doubled") {
        bench b{{0, 1, 2}, {{.name = "shoulder", .alias = 17}, {.name = "gripper", .serial = 11}}, [] {
                    auto all = devices();
                    all[1].station_alias = 17;
                    return all;
                }()};
        CHECK(b.start() == bus_errc::doubled_slave);
        CHECK(b.error_of("shoulder") == bus_errc::doubled_slave);
        CHECK_FALSE(b.error_of("gripper"));
    }
    SECTION("foreign") {
        bench b{{0, 1, 2}, {{.name = "shoulder", .alias = 17, .product = 5}, {.name = "gripper", .product = 2}}};
        CHECK(b.start() == bus_errc::foreign_slave);
        CHECK(b.error_of("shoulder") == bus_errc::foreign_slave);
        CHECK(b.has_line("slave \"shoulder\" is refused: another device is in the place of the slave"));
        CHECK_FALSE(b.error_of("gripper"));
    }
    SECTION("it refuses a start-up object") {
        bench b{{0, 2}, {{.name = "shoulder", .alias = 17, .start_up = {{.index = 0x2FFF, .data = {std::byte{1}}}}}}};
        CHECK(b.start() == ethercat::abort_code::no_object);
        CHECK(b.has_line("slave \"shoulder\" at position 0 does not take its start-up object 2FFFh:0"));
    }
}

TEST_CASE("an optional slave that comes later is taken in, and one that goes disturbs no other") {
    bench b;
    REQUIRE_FALSE(b.start());
    const auto elbow = b.bus->slave({.name = "elbow"});
    REQUIRE_FALSE(
        b.outcome([&](auto done) { elbow.async_operate({.period = 5ms, .watchdog = 1s, .timeout = 500ms}, done); }));
    b.ring.connect({3, 0, 1, 2}); // in front of all others
    REQUIRE(b.until([&] { return !b.found.empty(); }));
    CHECK(b.found[0] == std::pair{std::string{"spare"}, std::uint16_t{0}});
    CHECK(b.alias_of("spare") == std::pair{19U, error_code{}});
    CHECK(b.bus->slave({.name = "gripper"}).info().position == 3);
    CHECK(elbow.info().position == 2);
    CHECK(elbow.is_operating());
    CHECK(b.lost.empty());
    b.ring.connect({0, 1, 2});
    REQUIRE(b.until([&] { return !b.lost.empty(); }));
    CHECK(b.lost == std::vector{std::pair{std::string{"spare"}, error_code{bus_errc::slave_lost}}});
    REQUIRE(b.until([&] { return elbow.info().position == 1; }));
    CHECK(elbow.is_operating());
    b.ring.connect({0, 1, 2, 3}); // at another place
    REQUIRE(b.until([&] { return b.found.size() == 2; }));
    CHECK(b.alias_of("spare") == std::pair{19U, error_code{}});
    CHECK(elbow.is_operating());
    CHECK(b.lost.size() == 1);
}

TEST_CASE("a slave that lost its power gets its start-up objects again") {
    bench b;
    REQUIRE_FALSE(b.start());
    b.ring.with(1, [](auto& each) {
        each.slave.power_on();
        each.own.entries.at({0x2001, std::uint8_t{1}}).value[0] = {};
    });
    REQUIRE(b.until([&] { return b.found.size() == 1; }));
    CHECK(b.found[0].first == "elbow");
    CHECK(b.mode_of(1) == 9);
    CHECK(b.lost.size() == 1);
    CHECK_FALSE(
        b.outcome([&](auto done) { b.bus->slave({.name = "elbow"}).async_write(0x2001, 1, std::uint16_t{1}, done); }));
}

TEST_CASE("slaves whose cables were exchanged are not taken for one another") {
    SECTION("with aliases they are found at their new places") {
        bench b;
        REQUIRE_FALSE(b.start());
        b.ring.connect({2});
        REQUIRE(b.until([&] { return b.lost.size() == 2; }));
        b.ring.with(0, [](auto& each) { each.slave.power_on(); });
        b.ring.connect({1, 0, 2});
        REQUIRE(b.until([&] { return b.found.size() == 2; }));
        CHECK(b.alias_of("shoulder").first == 17);
        CHECK(b.alias_of("elbow").first == 18);
        CHECK(b.bus->slave({.name = "elbow"}).info().position == 0);
    }
    SECTION("with positions alone they are refused while they keep their power") {
        bench b{{0, 1, 2}, {{.name = "shoulder", .position = 0}, {.name = "elbow", .position = 1}}};
        REQUIRE_FALSE(b.start());
        b.ring.connect({2});
        REQUIRE(b.until([&] { return b.lost.size() == 2; }));
        b.context.restart();
        b.context.run_for(100ms); // the gripper at their place is not taken for one of them
        CHECK(b.found.empty());
        b.ring.connect({1, 0, 2});
        REQUIRE(b.until([&] {
            return b.error_of("shoulder") == bus_errc::swapped_slave && b.error_of("elbow") == bus_errc::swapped_slave;
        }));
        CHECK(b.found.empty());
        b.ring.connect({0, 1, 2});
        REQUIRE(b.until([&] { return b.found.size() == 2; }));
        CHECK_FALSE(b.error_of("shoulder"));
        CHECK(b.alias_of("shoulder").first == 17);
    }
}

TEST_CASE("a slave in operation that is lost operates again at another place") {
    bench b;
    REQUIRE_FALSE(b.start());
    const auto elbow = b.bus->slave({.name = "elbow"});
    const auto operate = [&] {
        return b.outcome(
            [&](auto done) { elbow.async_operate({.period = 5ms, .watchdog = 1s, .timeout = 500ms}, done); });
    };
    REQUIRE_FALSE(operate());
    b.ring.connect({0, 2});
    const auto is_elbow = [](const auto& each) { return each.first == "elbow"; };
    REQUIRE(b.until([&] { return std::ranges::any_of(b.lost, is_elbow) && !elbow.is_operating(); }));
    b.ring.with(1, [](auto& each) { each.slave.power_on(); });
    b.ring.connect({1, 0, 2});
    REQUIRE(b.until([&] { return std::ranges::any_of(b.found, is_elbow); }));
    CHECK(elbow.info().position == 0);
    REQUIRE_FALSE(operate());
    CHECK(elbow.is_operating());
    CHECK(b.mode_of(1) == 9);
}

TEST_CASE("a slave is identified by its switch, and by an ESI file") {
    const auto path = std::filesystem::temp_directory_path() / ("jauscat_named_" + std::to_string(::getpid()) + ".xml");
    std::ofstream{path} << jauscat::test::sample_esi();
    auto all = devices();
    all[0].device_id = 5;
    all[1] = jauscat::test::sample_slave;
    bench b{
        {2, 1, 0},
        {{.name = "shoulder", .identification = 5}, {.name = "arm", .esi = path}, {.name = "gripper", .serial = 11}},
        all};
    std::filesystem::remove(path);
    REQUIRE_FALSE(b.start());
    CHECK(b.bus->slave({.name = "shoulder"}).info().position == 2);
    CHECK(b.bus->slave({.name = "arm"}).info().product == 0x21);
    CHECK(b.bus->slave({.name = "gripper"}).info().position == 0);
}

TEST_CASE("a slave that does not answer is given up after its own time, or that of its ESI file") {
    const jauscat::test::scratch folder;
    const std::string type = "</Type>";
    auto text = jauscat::test::sample_esi();
    text.insert(text.find(type, text.find("<Device ")) + type.size(),
                "<Info><Mailbox><Timeout><RequestTimeout>10</RequestTimeout><ResponseTimeout>40</ResponseTimeout>"
                "</Timeout></Mailbox></Info>");
    std::ofstream{folder / "arm.xml"} << text;
    auto all = devices();
    all[1] = jauscat::test::sample_slave;
    constexpr net::timeout_entry::milliseconds short_time{50}, long_time{1500};
    // The master's own time, 1 s, is longer than that of an operation.
    bench b{{0, 1, 2, 3},
            {{.name = "shoulder", .alias = 17},
             {.name = "arm", .esi = folder / "arm.xml"},
             {.name = "gripper", .product = 2, .timeouts = {.mailbox = short_time}},
             {.name = "spare", .alias = 19, .timeouts = {.mailbox = long_time}}},
            all,
            500ms};
    REQUIRE_FALSE(b.start());
    for (std::size_t i = 0; i != 4; ++i) b.ring.with(i, [](auto& each) { each.hangs = true; });
    const auto read = [&](const char* name) {
        error_code why;
        bool is_over = false;
        b.bus->slave({.name = name}).async_read<std::uint32_t>(0x1018, 1, [&](error_code error, std::uint32_t) {
            why = error;
            is_over = true;
        });
        REQUIRE(b.until([&] { return is_over; }));
        return why;
    };
    CHECK(read("shoulder") == bus_errc::timed_out);
    CHECK(read("arm") == bus_errc::no_answer);
    CHECK(read("gripper") == bus_errc::no_answer);
    CHECK(read("spare") == bus_errc::no_answer); // an operation lasts as long as its slave may take
}

TEST_CASE("slaves that cannot be told apart are refused at once") {
    asio::io_context context;
    const auto opens = [&](std::vector<net::slave_entry> names) {
        const bus never{context, "udp:127.0.0.1:1", {.slaves = std::move(names)}};
    };
    CHECK_THROWS_AS(opens({{.name = "", .position = 0}}), std::invalid_argument);
    CHECK_THROWS_AS(opens({{.name = "a"}}), std::invalid_argument);
    CHECK_THROWS_AS(opens({{.name = "a", .position = 0}, {.name = "a", .position = 1}}), std::invalid_argument);
    CHECK_THROWS_AS(opens({{.name = "a", .esi = "no-such-file.xml"}}), std::invalid_argument);

    const jauscat::test::scratch folder;
    std::ofstream{folder / "a.xml"} << jauscat::test::sample_esi_with_pdos();
    const auto mode = [&](const char* name) { opens({{.name = "a", .esi = folder / "a.xml", .sync_mode = name}}); };
    CHECK_NOTHROW(mode("Free run"));
    CHECK_THROWS_WITH(mode("DC sync"), Catch::Contains("no OpMode \"DC sync\"; it has Free run, DC"));
    CHECK_THROWS_WITH(mode("DC"), Catch::Contains("depend on the period; give them as numbers"));
}
