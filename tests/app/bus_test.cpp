// A bus of emulated slaves: found, read, written, watched; and every way in which that fails.
#include "app/cancellation_slots.hpp"
#include "app/emulated_bus.hpp"
#include "support/catch.hpp"
#include "support/until.hpp"
#include <jauscat/app/bus.hpp>
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/ethercat/code_texts.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/use_future.hpp>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using boost::system::error_code;
namespace asio = boost::asio;

namespace {

using jauscat::test::emulated_bus;

/// Three slaves, of two kinds.
std::vector<ethercat::slave_description> three() {
    return {{.vendor = 7, .product = 1, .serial = 10, .name = "axis"},
            {.vendor = 7, .product = 2, .serial = 11, .station_alias = 300, .name = "gripper"},
            {.vendor = 7, .product = 1, .serial = 12, .name = "axis"}};
}

/// The slaves, and a bus that has lines and callbacks noted.
struct bench {
    explicit bench(const std::vector<ethercat::slave_description>& slaves = three(), bus_options options = {},
                   bool are_described = false)
        : ring{slaves, are_described} {
        options.log = [this](std::string_view line) { lines.emplace_back(line); };
        bus.emplace(context, ring.where(), options);
        bus->when_lost([this](const slave_info& who, error_code why) { lost.emplace_back(who.position, why); });
        bus->when_found([this](const slave_info& who) { found.push_back(who.position); });
        bus->when_changed(
            [this](const slave_info& who, const ethercat::al_status& al) { changed.emplace_back(who.position, al); });
        bus->when_emergency([this](const slave_info& who, const ethercat::coe_emergency& what) {
            emergencies.emplace_back(who.position, what);
        });
        for (std::size_t i = 0; i != slaves.size(); ++i)
            ring.with(i, [&](auto& each) {
                each.own.add(0x2000, 0, 4);
                each.own.add(0x2001, 1, 2);
            });
    }

    /// Starts an operation and waits for its outcome.
    template <class... Results, class Start> std::tuple<error_code, Results...> outcome(Start start) {
        std::optional<std::tuple<error_code, Results...>> all;
        start([&](error_code error, Results... results) { all.emplace(error, std::move(results)...); });
        CHECK_FALSE(all); // never at once
        REQUIRE(support::until(context, [&] { return all.has_value(); }));
        return *all;
    }
    error_code start() {
        return std::get<0>(outcome<>([&](auto done) { bus->async_start(done); }));
    }
    template <class T> std::tuple<error_code, T> read(const slave& of, std::uint16_t index, std::uint8_t subindex) {
        return outcome<T>([&](auto done) { of.async_read<T>(index, subindex, done); });
    }
    template <class T> error_code write(const slave& of, std::uint16_t index, std::uint8_t subindex, const T& value) {
        return std::get<0>(outcome<>([&](auto done) { of.async_write(index, subindex, value, done); }));
    }
    error_code change(const slave& of, ethercat::al_state goal) {
        return std::get<0>(outcome<>([&](auto done) { of.async_change(goal, done); }));
    }
    bool has_line(std::string_view part) const {
        return std::ranges::any_of(lines, [&](const auto& line) { return line.find(part) != line.npos; });
    }

    emulated_bus ring;
    asio::io_context context{};
    std::optional<class bus> bus{};
    std::vector<std::string> lines{};
    std::vector<std::pair<std::uint16_t, error_code>> lost{};
    std::vector<std::uint16_t> found{};
    std::vector<std::pair<std::uint16_t, ethercat::al_status>> changed{};
    std::vector<std::pair<std::uint16_t, ethercat::coe_emergency>> emergencies{};
};

const slave_choice first{.position = 0};

enum class mode : std::int8_t { position = 1, torque = -4 };

} // namespace

TEST_CASE("the slaves of a bus are brought up at once") {
    constexpr std::size_t count = 64;
    // A busy machine must not repeat frames, which are counted.
    bench b{std::vector<ethercat::slave_description>(count, {.vendor = 7, .product = 1, .name = "axis"}),
            {.start_timeout = 60s, .frame_timeout = 1s}};
    REQUIRE_FALSE(b.start());
    const auto all = b.bus->slaves();
    REQUIRE(all.size() == count);
    CHECK(std::ranges::all_of(all, [](const auto& each) { return each.name == "axis" && !each.is_lost; }));
    CHECK(b.ring.frames() < count * 12); // 27 and more one after the other, and those for alias and name
}

TEST_CASE("a bus finds its slaves and identifies them") {
    bench b;
    CHECK(b.bus->slaves().empty());
    REQUIRE_FALSE(b.start());
    const auto all = b.bus->slaves();
    REQUIRE(all.size() == 3);
    CHECK(all[1].position == 1);
    CHECK(all[1].alias == 300);
    CHECK(all[1].name == "gripper");
    CHECK(all[1].vendor == 7);
    CHECK(all[1].product == 2);
    CHECK(all[1].revision == 1);
    CHECK(all[1].serial == 11);
    CHECK(all[1].has_objects);
    CHECK_FALSE(all[1].is_lost);
    CHECK(all[0].alias == 0);
    const auto [error, al] = b.outcome<ethercat::al_status>([&](auto done) { b.bus->slave(first).async_state(done); });
    CHECK_FALSE(error);
    CHECK(al.state == ethercat::al_state::pre_op);
    const auto [why, counted] =
        b.outcome<ethercat::error_counters>([&](auto done) { b.bus->slave(first).async_error_counters(done); });
    CHECK_FALSE(why);
    CHECK(counted == ethercat::error_counters{});
    CHECK_FALSE(b.start()); // again
    CHECK(b.bus->slaves().size() == 3);
}

TEST_CASE("a slave is chosen by position, alias, name and identity") {
    bench b;
    error_code error;
    static_cast<void>(b.bus->slave(first).info(error));
    CHECK(error == bus_errc::not_started);
    REQUIRE_FALSE(b.start());
    CHECK(b.bus->slave({.position = 2}).info().serial == 12);
    CHECK(b.bus->slave({.alias = 300}).info().position == 1);
    CHECK(b.bus->slave({.name = "gripper"}).info().position == 1);
    CHECK(b.bus->slave({.identity = {.product = 1, .serial = 12}}).info().position == 2);
    CHECK(b.bus->slave({.position = 1, .name = "gripper"}).info().position == 1);
    const auto why = [&](const slave_choice& which) {
        static_cast<void>(b.bus->slave(which).info(error));
        return error;
    };
    CHECK(why({.position = 3}) == bus_errc::no_such_slave);
    CHECK(why({.alias = 301}) == bus_errc::no_such_slave);
    CHECK(why({.name = "axis"}) == bus_errc::ambiguous);
    CHECK(why({.position = 0, .name = "gripper"}) == bus_errc::wrong_slave);
    CHECK_THROWS_AS(b.bus->slave({.position = 3}).info(), boost::system::system_error);
    CHECK_THROWS_AS(b.bus->slave({}), std::invalid_argument);
    CHECK(std::get<0>(b.read<bool>(b.bus->slave({.name = "axis"}), 0x2000, 0)) == bus_errc::ambiguous);
}

TEST_CASE("values of every type are written and read") {
    bench b;
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave({.position = 1});
    const auto keeps = [&]<class T>(std::uint16_t index, const T& value) {
        b.ring.with(1, [&](auto& each) { each.own.add(index, 0, app::to_object(value).size()); });
        CHECK_FALSE(b.write(drive, index, 0, value));
        CHECK(b.read<T>(drive, index, 0) == std::tuple{error_code{}, value});
    };
    keeps(0x3000, true);
    keeps(0x3001, std::int8_t{-9});
    keeps(0x3002, std::uint16_t{0xFFFE});
    keeps(0x3003, std::int32_t{-70'000});
    keeps(0x3004, std::uint64_t{0x0102'0304'0506'0708});
    keeps(0x3005, 1.5f);
    keeps(0x3006, -2.25);
    keeps(0x3007, mode::torque);
    keeps(0x3008, std::string{"a text"});
    keeps(0x3009, jauscat::test::counting(1000)); // in segments
    b.ring.with(1,
                [](auto& each) { CHECK(each.own.entries.at({0x3002, 0}).value == jauscat::test::counting(2, 0xFE)); });
    b.ring.with(1, [](auto& each) { each.own.add(0x300A, 0, 8); });
    CHECK_FALSE(b.write(drive, 0x300A, 0, "12345678"));
    b.ring.with(1, [](auto& each) { each.own.entries.at({0x300A, 0}).value[7] = {}; });
    CHECK(std::get<1>(b.read<std::string>(drive, 0x300A, 0)) == "1234567");
}

TEST_CASE("an object of another size than the type is an error") {
    bench b;
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    const auto error = std::get<0>(b.read<std::uint16_t>(drive, 0x2000, 0));
    CHECK(error == bus_errc::wrong_size);
    CHECK(error != bus_errc::too_large);
    CHECK(error.message() == "slave 0 (axis), object 0x2000:0 has 4 bytes, and std::uint16_t has 2");
    CHECK(std::get<0>(b.read<std::uint64_t>(drive, 0x2000, 0)) == bus_errc::wrong_size);
    CHECK(std::get<0>(b.read<double>(drive, 0x2000, 0)).message().ends_with(" has 4 bytes, and double has 8"));
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)));
    CHECK(b.write(drive, 0x2000, 0, std::int8_t{1}) == ethercat::abort_code::length_mismatch);
}

TEST_CASE("an object that is not as large as announced is told by both sizes") {
    const ethercat::master_error found{.code = ethercat::master_errc::size_mismatch, .bytes = 10, .found_bytes = 3};
    const auto error = app::error_of({.position = 3, .name = "axis"}, found, app::object{0x2000, std::uint8_t{1}});
    CHECK(error == bus_errc::wrong_size);
    CHECK(error.message().starts_with("slave 3 (axis), object 0x2000:1: "));
    CHECK(error.message().ends_with(" (10 bytes expected, 3 found)"));
}

TEST_CASE("an abort code of the slave reaches the caller") {
    bench b;
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    const auto [error, value] = b.read<std::uint16_t>(drive, 0x6041, 0);
    CHECK(error == ethercat::abort_code::no_object);
    CHECK(error.value() == 0x06020000);
    CHECK(error.category() == abort_category());
    CHECK(error.message() == "slave 0 (axis), object 0x6041:0: abort code 06020000h: " +
                                 std::string{ethercat::describe(ethercat::abort_code::no_object)});
    CHECK(std::get<0>(b.read<std::uint16_t>(drive, 0x6041, 0)) == error);
    CHECK(std::string_view{error.category().name()} == "jauscat.abort");
    CHECK(value == 0);
    const auto refused = b.write(drive, 0x1018, 1, std::uint32_t{1});
    CHECK(refused == ethercat::abort_code::read_only);
    CHECK(refused != error);
    CHECK(refused.message().starts_with("slave 0 (axis), object 0x1018:1: abort code 06010002h: "));
    std::map<error_code, int> counted; // by category and number
    ++counted[error], ++counted[ethercat::abort_code::no_object], ++counted[refused];
    CHECK(counted.size() == 2);
}

TEST_CASE("a slave lists and describes its objects") {
    bench b{three(), {}, true};
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    const auto list = [&](ethercat::object_list_type which) {
        return b.outcome<std::vector<std::uint16_t>>([&](auto done) { drive.async_list_objects(which, done); });
    };
    const auto [no_list, all] = list(ethercat::object_list_type::all);
    CHECK_FALSE(no_list);
    CHECK(std::ranges::count(all, 0x1018) == 1);
    CHECK(all.back() == 0x3000);
    CHECK(std::get<1>(list(ethercat::object_list_type::settings)) == std::vector<std::uint16_t>{0x2003});
    const auto [no_object, object] =
        b.outcome<object_information>([&](auto done) { drive.async_describe(0x3000, done); });
    CHECK_FALSE(no_object);
    CHECK(object.object.index == 0x3000);
    CHECK(object.object.code == ethercat::object_code::record);
    CHECK(object.object.highest_subindex == 4);
    CHECK(object.name == "mixture");
    const auto [no_entry, entry] =
        b.outcome<entry_information>([&](auto done) { drive.async_describe_entry(0x3000, 3, done); });
    CHECK_FALSE(no_entry);
    CHECK(entry.entry.bits == 16);
    CHECK(entry.entry.access.read_pre_op);
    CHECK(entry.name == "part");
    CHECK(std::get<0>(b.outcome<object_information>([&](auto done) { drive.async_describe(0x4000, done); })) ==
          ethercat::abort_code::no_object);
}

TEST_CASE("a slave that describes no objects refuses") {
    bench b;
    REQUIRE_FALSE(b.start());
    CHECK(std::get<0>(b.outcome<object_information>(
              [&](auto done) { b.bus->slave(first).async_describe(0x1018, done); })) == bus_errc::refused);
}

TEST_CASE("operations are coroutines, futures and callbacks, and are executed in order") {
    bench b;
    std::vector<int> order;
#ifdef BOOST_ASIO_HAS_CO_AWAIT
    bool is_done = false;
    asio::co_spawn(
        b.context,
        [&]() -> asio::awaitable<void> {
            co_await b.bus->async_start();
            auto drive = b.bus->slave({.position = 2});
            co_await drive.async_write(0x2000, 0, std::uint32_t{5});
            CHECK(co_await drive.async_read<std::uint32_t>(0x2000, 0) == 5);
            try {
                co_await drive.async_read<std::uint32_t>(0x2FFF, 0);
                FAIL_CHECK("an object that is not there was read");
            } catch (const boost::system::system_error& error) {
                CHECK(error.code() == ethercat::abort_code::no_object);
            }
            is_done = true;
        },
        asio::detached);
    REQUIRE(support::until(b.context, [&] { return is_done; }));
#else
    REQUIRE_FALSE(b.start());
#endif
    const auto drive = b.bus->slave(first);
    auto future = drive.async_read<std::uint16_t>(0x2001, 1, asio::use_future);
    for (int i = 0; i != 5; ++i)
        drive.async_write(0x2000, 0, i, [&, i](error_code error) {
            CHECK_FALSE(error);
            order.push_back(i);
        });
    REQUIRE(support::until(b.context, [&] { return order.size() == 5; }));
    CHECK(order == std::vector{0, 1, 2, 3, 4});
    CHECK(future.get() == 0);
    CHECK(std::get<1>(b.read<int>(drive, 0x2000, 0)) == 4);
}

TEST_CASE("states are changed, refused and reported") {
    static constexpr ethercat::pdo_entry word{.index = 0x7000, .subindex = 1, .bits = 16, .name = "word"};
    bench b{{{.outputs = {&word, 1}}, {}}};
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    using enum ethercat::al_state;
    CHECK_FALSE(b.change(drive, safe_op));
    b.ring.with(0, [](auto& each) { CHECK(each.slave.state() == ethercat::al_state::safe_op); });
    CHECK(b.change(drive, op) == bus_errc::needs_cycles);
    CHECK_FALSE(b.change(drive, init));
    CHECK_FALSE(b.change(drive, safe_op)); // from INIT, through PRE-OP
    CHECK_FALSE(b.change(drive, pre_op));
    CHECK_FALSE(b.change(b.bus->slave({.position = 1}), safe_op)); // without process data
    CHECK(b.change(drive, boot) == ethercat::al_status_code::boot_not_supported);
    CHECK(b.change(b.bus->slave({.position = 4}), init) == bus_errc::no_such_slave);
    REQUIRE(support::until(b.context, [&] { return b.changed.size() == 6; }));
    CHECK(b.changed[0].second.state == safe_op);
    CHECK(b.has_line("AL status code 0013h"));
}

TEST_CASE("a slave that leaves its state by itself is reported") {
    bench b;
    REQUIRE_FALSE(b.start());
    b.ring.with(1, [](auto& each) {
        each.hangs = false;
        each.slave.power_on(); // it has lost its address, too
    });
    REQUIRE(support::until(b.context, [&] { return !b.found.empty(); }));
    REQUIRE(b.lost.size() == 1);
    CHECK(b.lost[0].first == 1);
    CHECK(b.lost[0].second == bus_errc::slave_lost);
    CHECK(b.found == std::vector<std::uint16_t>{1});
    CHECK(b.has_line("slave 1 (gripper) is lost"));
    CHECK(b.has_line("slave 1 (gripper) answers again"));
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(b.bus->slave({.position = 1}), 0x2000, 0)));
}

TEST_CASE("a slave without objects has the name of its SII, also when it has come back") {
    bench b{{{.vendor = 7, .product = 1, .serial = 10, .name = "axis"},
             {.vendor = 7, .product = 3, .mailbox_out_size = 0, .mailbox_in_size = 0, .name = "1 \xB5s coupler"}}};
    REQUIRE_FALSE(b.start());
    const auto names = [&] {
        std::vector<std::string> all;
        for (const auto& each : b.bus->slaves()) all.push_back(each.name);
        return all;
    };
    CHECK(names() == std::vector<std::string>{"axis", "1 \u00B5s coupler"});
    CHECK_FALSE(b.bus->slave({.name = "1 \u00B5s coupler"}).info().has_objects);
    b.ring.with(1, [](auto& each) { each.slave.power_on(); });
    REQUIRE(support::until(b.context, [&] { return b.found.size() == 1; }));
    CHECK(names() == std::vector<std::string>{"axis", "1 \u00B5s coupler"});
}

TEST_CASE("emergencies of slaves are called back") {
    bench b;
    REQUIRE_FALSE(b.start());
    b.ring.with(2, [](auto& each) { CHECK(each.slave.send_emergency({.error_code = 0x4230, .error_register = 8})); });
    REQUIRE(support::until(b.context, [&] { return !b.emergencies.empty(); }));
    CHECK(b.emergencies[0].first == 2);
    CHECK(b.emergencies[0].second.error_code == 0x4230);
    CHECK(b.emergencies[0].second.error_register == 8);
    CHECK(b.has_line("slave 2 (axis) reports an emergency: 4230h, error register 08h"));
    CHECK(b.emergencies.size() == 1);
}

TEST_CASE("a pulled cable is reported at once, and work goes on when it is back") {
    bench b{three(),
            {.timeout = 1s, .check_interval = 20ms, .frame_timeout = jauscat::test::frame_timeout, .frame_retries = 3}};
    REQUIRE_FALSE(b.start());
    b.ring.is_silent = true;
    const auto drive = b.bus->slave(first);
    REQUIRE(support::until(b.context, [&] { return b.lost.size() == 3; }));
    CHECK(b.lost[0].second == bus_errc::no_reply);
    CHECK(b.bus->slaves()[2].is_lost);
    CHECK(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)) == bus_errc::no_reply);
    b.ring.is_silent = false;
    REQUIRE(support::until(b.context, [&] { return b.found.size() == 3; }));
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)));
    CHECK_FALSE(b.bus->slaves()[2].is_lost);
    CHECK(b.lost.size() == 3);
}

TEST_CASE("a cable between two slaves that is pulled loses those behind it") {
    bench b{three(), {.check_interval = 20ms}};
    REQUIRE_FALSE(b.start());
    b.ring.cut_behind(1);
    REQUIRE(support::until(b.context, [&] { return b.lost.size() == 2; }));
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(b.bus->slave(first), 0x2000, 0)));
    CHECK(std::get<0>(b.read<std::uint32_t>(b.bus->slave({.position = 2}), 0x2000, 0)) == bus_errc::slave_lost);
    // A frame that has passed no slave is no sign of life of one.
    const auto counted = b.outcome<ethercat::error_counters>(
        [&](auto done) { b.bus->slave({.position = 2}).async_error_counters(done); });
    CHECK(std::get<0>(counted) == bus_errc::slave_lost);
    CHECK(b.found.empty());
    const auto statuses = b.bus->statuses();
    REQUIRE(statuses.size() == 3);
    CHECK(statuses[0].state == ethercat::al_state::pre_op);
    CHECK(statuses[0].problem.empty());
    CHECK_FALSE(statuses[2].state);
    CHECK_FALSE(statuses[2].problem.empty());
    b.ring.cut_behind(3);
    REQUIRE(support::until(b.context, [&] { return b.found.size() == 2; }));
}

TEST_CASE("a slave is not taken for another one that came to its place") {
    bench b{three(), {.check_interval = 20ms}};
    REQUIRE_FALSE(b.start());
    b.ring.with(1, [](auto& each) {
        each.description.product = 99;
        std::destroy_at(&each.slave);
        std::construct_at(&each.slave, each.description, each.all);
    });
    REQUIRE(support::until(b.context, [&] { return b.has_line("still lost"); }));
    CHECK(b.found.empty());
    CHECK(b.bus->slaves()[1].is_lost);
    REQUIRE_FALSE(b.start());
    CHECK(b.bus->slaves()[1].product == 99);
}

TEST_CASE("a start without slaves, without answers and with garbage fails") {
    SECTION("no slaves") {
        bench b{{}};
        CHECK(b.start() == bus_errc::no_slaves);
        CHECK(std::get<0>(b.read<bool>(b.bus->slave(first), 0x2000, 0)) == bus_errc::not_started);
    }
    SECTION("silence") {
        bench b{three(), {.frame_timeout = jauscat::test::frame_timeout, .frame_retries = 3}};
        b.ring.is_silent = true;
        CHECK(b.start() == bus_errc::no_reply);
    }
    SECTION("garbage") {
        bench b{three(), {.frame_timeout = jauscat::test::frame_timeout, .frame_retries = 3}};
        b.ring.is_garbage = true;
        CHECK(b.start() == bus_errc::no_reply);
        b.ring.is_garbage = false;
        CHECK_FALSE(b.start());
        b.ring.is_garbage = true;
        CHECK(std::get<0>(b.read<std::uint32_t>(b.bus->slave(first), 0x2000, 0)) == bus_errc::no_reply);
    }
    SECTION("too many") {
        bench b{std::vector<ethercat::slave_description>(257), {.frame_timeout = 2s}};
        CHECK(b.start() == bus_errc::too_many_slaves);
    }
    SECTION("nobody at the port") {
        asio::io_context context;
        bus alone{context, "udp:127.0.0.1:9", {.frame_timeout = 5ms, .frame_retries = 2, .log = [](auto) {}}};
        std::optional<error_code> error;
        alone.async_start([&](error_code why) { error = why; });
        REQUIRE(support::until(context, [&] { return error.has_value(); }));
        CHECK((error == bus_errc::no_reply || error == bus_errc::not_sent));
    }
    SECTION("one slave that hangs") {
        bench b;
        b.ring.with(1, [](auto& each) { each.hangs = true; });
        CHECK(b.start() == bus_errc::not_configurable); // its SII does not answer
        CHECK(b.has_line("slave 1 is not brought up"));
        CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(b.bus->slave({.position = 2}), 0x2000, 0)));
        CHECK(b.bus->slaves()[1].is_lost);
    }
    SECTION("no time") {
        bench b{three(), {.start_timeout = 0ms}};
        CHECK(b.start() == bus_errc::timed_out);
    }
}

TEST_CASE("a slave that is silent in its mailbox times out, and does not disturb the others") {
    bench b{three(), {.timeout = 300ms}};
    REQUIRE_FALSE(b.start());
    b.ring.with(1, [](auto& each) { each.hangs = true; });
    std::optional<error_code> error;
    const auto hanging = b.bus->slave({.position = 1});
    hanging.async_read<std::uint32_t>(0x2000, 0, [&](error_code why, std::uint32_t) { error = why; });
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(b.bus->slave(first), 0x2000, 0)));
    CHECK(error == bus_errc::timed_out);
    b.ring.with(1, [](auto& each) { each.hangs = false; });
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(hanging, 0x2000, 0)));
}

TEST_CASE("a slave that takes a request and never answers is reported") {
    bench b{three(), {.timeout = 10s}};
    REQUIRE_FALSE(b.start());
    b.ring.with(1, [](auto& each) { each.hangs = true; });
    const auto hanging = b.bus->slave({.position = 1});
    CHECK(std::get<0>(b.read<std::uint32_t>(hanging, 0x2000, 0)) == bus_errc::no_answer);
    CHECK(std::get<0>(b.read<std::uint32_t>(hanging, 0x2000, 0)) == bus_errc::not_taken);
    CHECK(b.write(hanging, 0x2000, 0, std::uint32_t{1}) == bus_errc::not_taken);
}

TEST_CASE("operations end with the bus, by cancel and by stop") {
    bench b;
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    std::vector<error_code> errors;
    const auto begin = [&] {
        errors.clear();
        for (int i = 0; i != 3; ++i)
            drive.async_read<std::uint32_t>(0x2000, 0, [&](error_code why, std::uint32_t) { errors.push_back(why); });
        drive.async_change(ethercat::al_state::safe_op, [&](error_code why) { errors.push_back(why); });
        b.bus->async_start([&](error_code why) { errors.push_back(why); });
    };
    const auto are_aborted = [&] {
        return support::until(b.context, [&] { return errors.size() == 5; }) &&
               std::ranges::all_of(errors, [](auto e) { return e == asio::error::operation_aborted; });
    };
    begin();
    b.bus->cancel();
    CHECK(are_aborted());
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)));

    begin();
    REQUIRE(support::until(b.context, [&] { return errors.size() == 1; })); // the next is under way
    b.bus->cancel();
    REQUIRE(support::until(b.context, [&] { return errors.size() == 5; }));
    CHECK(errors.back() == asio::error::operation_aborted);
    // A start that was cancelled may have cleared the slave's address: then the bus brings it up again.
    auto why = std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0));
    for (int tries = 0; why == bus_errc::slave_lost && tries != 100; ++tries) {
        b.context.run_for(20ms);
        why = std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0));
    }
    CHECK(why == error_code{});

    begin();
    b.bus->stop();
    CHECK(are_aborted());
    CHECK(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)) == bus_errc::not_started);
    CHECK_FALSE(b.start());
    CHECK_FALSE(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)));

    begin();
    b.bus.reset();
    CHECK(are_aborted());
    CHECK(std::get<0>(b.read<std::uint32_t>(drive, 0x2000, 0)) == asio::error::operation_aborted);
    b.context.restart();
    CHECK(b.context.run() == 0); // nothing keeps it at work
}

TEST_CASE("a bus may end in its own callbacks, and with its io_context before its handlers") {
    bench b{three(), {.check_interval = 10ms}};
    REQUIRE_FALSE(b.start());
    bool has_ended = false;
    b.bus->when_lost([&](const slave_info&, error_code) {
        b.bus.reset();
        has_ended = true;
    });
    b.ring.with(0, [](auto& each) { each.slave.power_on(); });
    CHECK(support::until(b.context, [&] { return has_ended; }));

    std::optional<slave> handle;
    {
        asio::io_context context;
        bus other{context, b.ring.where()};
        handle = other.slave(first);
        other.async_start([](error_code) {});
        handle->async_read<bool>(1, 1, [](error_code, bool) {});
        context.run_for(2ms);
    }
}

TEST_CASE("a bus in a thread of its own") {
    bench b{three(),
            {.check_interval = 10ms,
             .frame_timeout = jauscat::test::frame_timeout,
             .frame_retries = 3,
             .thread = true,
             .priority = 1}};
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    CHECK_FALSE(b.write(drive, 0x2000, 0, std::uint32_t{7}));
    CHECK(std::get<1>(b.read<std::uint32_t>(drive, 0x2000, 0)) == 7);
    b.ring.is_silent = true;
    REQUIRE(support::until(b.context, [&] { return b.lost.size() == 3; }));
    b.ring.is_silent = false;
    REQUIRE(support::until(b.context, [&] { return b.found.size() == 3; }));
    std::vector<error_code> errors;
    for (int i = 0; i != 5; ++i)
        drive.async_read<std::uint32_t>(0x2000, 0, [&](error_code why, std::uint32_t) { errors.push_back(why); });
    SECTION("ends with operations pending") { b.bus.reset(); }
    SECTION("stops with operations pending") { b.bus->stop(); }
    SECTION("cancels") { b.bus->cancel(); }
    REQUIRE(support::until(b.context, [&] { return errors.size() == 5; }));
}

#if BOOST_VERSION >= 107700

TEST_CASE("an operation of a bus is cancelled through its cancellation slot, and the others go on") {
    bench b{three(), {.thread = GENERATE(false, true)}};
    REQUIRE_FALSE(b.start());
    const auto drive = b.bus->slave(first);
    asio::cancellation_signal signal;
    std::optional<error_code> cancelled, other;
    b.ring.is_silent = true;
    const auto token = [&] {
        return asio::bind_cancellation_slot(signal.slot(), [&](error_code why, auto&&...) { cancelled = why; });
    };
    SECTION("a read") { drive.async_read<std::uint32_t>(0x2000, 0, token()); }
    SECTION("a write") { drive.async_write(0x2000, 0, std::uint32_t{1}, token()); }
    SECTION("a change of state") { drive.async_change(ethercat::al_state::safe_op, token()); }
    SECTION("a list of objects") { drive.async_list_objects(ethercat::object_list_type::all, token()); }
    SECTION("a start") { b.bus->async_start(token()); }
    drive.async_read<std::uint32_t>(0x2000, 0, [&](error_code why, std::uint32_t) { other = why; });
    signal.emit(asio::cancellation_type::all);
    REQUIRE(support::until(b.context, [&] { return cancelled.has_value(); }));
    CHECK(*cancelled == asio::error::operation_aborted);
    b.ring.is_silent = false;
    REQUIRE(support::until(b.context, [&] { return other.has_value(); }));
    CHECK(*other != asio::error::operation_aborted);
}

#endif

TEST_CASE("a bus may be stopped by its own report of a fault") {
    const bool has_thread = GENERATE(false, true);
    bus* stopped{};
    int faults = 0;
    bench b{three(),
            {.frame_timeout = jauscat::test::frame_timeout,
             .thread = has_thread,
             .on_fault = [&](link_fault, std::string_view) {
                 ++faults;
                 stopped->stop();
             }}};
    stopped = &*b.bus;
    REQUIRE_FALSE(b.start());
    b.ring.on_way_back([](std::span<std::byte> frame) { frame[23] |= std::byte{0x40}; }); // the circulating bit
    std::vector<error_code> errors;
    b.bus->slave(first).async_read<std::uint32_t>(0x2000, 0,
                                                  [&](error_code why, std::uint32_t) { errors.push_back(why); });
    REQUIRE(support::until(b.context, [&] { return faults == 1 && errors.size() == 1; }));
    b.ring.on_way_back({});
    CHECK_FALSE(b.start());
}

TEST_CASE("a bus in a thread of its own is stopped at any time") {
    bench b{three(), {.thread = true}};
    int aborted = 0, done = 0;
    for (int i = 0; i != 20; ++i) {
        REQUIRE_FALSE(b.start());
        const auto drive = b.bus->slave(first);
        for (int k = 0; k != 8; ++k) {
            drive.async_write(0x2000, 0, std::uint32_t{7}, [&](error_code why) { ++(why ? aborted : done); });
            drive.async_read<std::string>(0x1008, 0,
                                          [&](error_code why, const std::string&) { ++(why ? aborted : done); });
        }
        REQUIRE(support::until(b.context, [&] { return aborted + done > 16 * i; }));
        b.bus->stop(); // the next one is under way
        REQUIRE(support::until(b.context, [&] { return aborted + done == 16 * (i + 1); }));
    }
    CHECK(aborted > 0);
}

TEST_CASE("a link that cannot be opened says why") {
    asio::io_context context;
    const auto opening = [&](const char* where) { const bus never{context, where}; };
    CHECK_THROWS_AS(opening("udp:"), net::open_error);
    CHECK_THROWS_AS(opening("udp:127.0.0.1:"), net::open_error);
    CHECK_THROWS_AS(opening("udp:127.0.0.1:0"), net::open_error);
    CHECK_THROWS_AS(opening("udp:127.0.0.1:65536"), net::open_error);
    CHECK_THROWS_AS(opening("udp:127.0.0.1:x"), net::open_error);
    CHECK_THROWS_AS(opening("udp:[::1"), net::open_error);
    CHECK_THROWS_AS(opening("no-such-interface"), net::open_error);
    CHECK_NOTHROW(opening("udp:127.0.0.1"));
    CHECK_NOTHROW(opening("udp:[::1]:34980"));
}

TEST_CASE("the errors of a bus have texts") {
    for (int i = 0; i <= static_cast<int>(bus_errc::stopped); ++i) CHECK(bus_category().message(i) != "unknown error");
    CHECK(bus_category().message(99) == "unknown error");
    CHECK(make_error_code(ethercat::al_status_code::no_outputs).message().starts_with("AL status code 0019h: "));
}

TEST_CASE("a bus works with timeouts that are never over") {
    constexpr auto ever = duration::max();
    bench b{three(), {.timeout = ever, .start_timeout = ever, .check_interval = ever, .frame_timeout = ever}};
    CHECK(b.start() == error_code{});
    CHECK_THROWS_WITH(b.bus->slave({.position = 0}).async_operate({.period = ever}, [](error_code) {}),
                      Catch::Contains("the period is at most 3.25 s"));
}
