// The live view: who may see it, what it shows, and what becomes of slow viewers.
#include "live/web_client.hpp"
#include "support/catch.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/live/live_server.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace jauscat;
using live_test::json;
using live_test::web_client;
using net::live_way;

namespace {

constexpr jaus::address ocu{.instance = 1, .component = 32, .node = 1, .subsystem = 1};
constexpr jaus::address driver{.instance = 1, .component = 33, .node = 2, .subsystem = 2};

/// A live view with one feed.
struct view {
    explicit view(net::live_options options = {}) : server{with_catalogues(std::move(options))} {
        server.add(feed);
        server.start();
    }
    static net::live_options with_catalogues(net::live_options options) {
        options.program = "test";
        options.version = "1.2.3";
        options.name = "robot";
        options.messages = &catalogue::ra_3_3();
        options.sae_messages = &catalogue::sae_core_1_1();
        return options;
    }
    [[nodiscard]] std::uint16_t port() const { return server.port(); }

    net::live_feed feed{};
    net::live_server server;
};

template <class T> std::vector<std::byte> encoded(const T& message) {
    std::vector<std::byte> body(wire::encoded_size(message));
    body.resize(wire::encode(message, body)->size());
    return body;
}
jaus::header head_of(std::uint16_t code, const jaus::address& from = ocu, const jaus::address& to = driver) {
    return {.command_code = code, .destination = to, .source = from};
}
std::vector<std::byte> effort_of(double percent) {
    return encoded(jaus::set_wrench_effort{.propulsive_linear_effort_x = percent});
}

/// Until `done()`: for what no frame shows.
template <class Predicate> void eventually(Predicate done) {
    for (int i = 0; i != 6000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{10});
    REQUIRE(done());
}

} // namespace

TEST_CASE("the page is served, and nothing else") {
    view v;
    const auto page = web_client{v.port()}.request("/");
    CHECK(page.status == 200);
    CHECK(page.header.find("text/html") != std::string::npos);
    CHECK(page.body.starts_with("<!doctype html>"));
    CHECK(page.body.find("/* page.js */") == std::string::npos);
    CHECK(page.body.ends_with("</html>\n"));
    CHECK(web_client{v.port()}.request("/?token=unneeded").status == 200);
    const auto head = web_client{v.port()}.request("/", {}, {}, "HEAD");
    CHECK(head.status == 200);
    CHECK(head.header.find("Content-Length: " + std::to_string(page.body.size())) != std::string::npos);
    CHECK(web_client{v.port()}.request("/other").status == 404);
    CHECK(web_client{v.port()}.request("/live").status == 404); // without an upgrade
    CHECK(web_client{v.port()}.request("/../etc/passwd").status == 404);
    CHECK(web_client{v.port()}.request("/", "Content-Length: 0\r\n", {}, "POST").status == 405);
    CHECK(web_client{v.port()}.request("/", "X: " + std::string(10'000, 'x') + "\r\n").status == 413);
    CHECK(v.server.link() == "http://127.0.0.1:" + std::to_string(v.port()) + "/");
}

TEST_CASE("without a token only pages of this machine's own address are answered") {
    view v;
    const auto port = ":" + std::to_string(v.port());
    for (const std::string& host :
         {"localhost" + port, "127.0.0.1" + port, "127.1.2.3" + port, "[::1]" + port, std::string{"LOCALHOST"}})
        CHECK(web_client{v.port()}.request("/", {}, host).status == 200);
    for (const std::string& host : {"evil.example" + port, "127.evil.example" + port, "192.168.1.2" + port,
                                    "localhost.evil.example" + port, "127.0.0.1" + port + "x", std::string{"[::2]"}})
        CHECK(web_client{v.port()}.request("/", {}, host).status == 403);
    CHECK(web_client{v.port()}.watch("/live", "Origin: http://127.0.0.1" + port + "\r\n").status == 101);
    for (const std::string origin : {"http://evil.example", "http://127.0.0.1:1", "https://127.0.0.1", "null"}) {
        const auto refused = web_client{v.port()}.watch("/live", "Origin: " + origin + "\r\n");
        CHECK(refused.status == 403);
        CHECK(!refused.body.empty());
    }
    CHECK(v.server.counts().refused == 10);
}

TEST_CASE("with a token it alone counts") {
    view v{{.token = "0123-abc_DEF"}};
    CHECK(v.server.link().ends_with("/?token=0123-abc_DEF"));
    CHECK(web_client{v.port()}.request("/").status == 403);
    CHECK(web_client{v.port()}.request("/?token=0123-abc_DEG").status == 403);
    CHECK(web_client{v.port()}.request("/?token=0123").status == 403);
    CHECK(web_client{v.port()}.request("/?token=0123-abc_DEF").status == 200);
    CHECK(web_client{v.port()}.watch().status == 403);
    CHECK(web_client{v.port()}.watch("/live?a=b&token=0123-abc_DEF", "Origin: null\r\n", "robot.example").status ==
          101);
}

TEST_CASE("an address of other machines gets a random token") {
    const net::live_server one{{.address = "0.0.0.0"}}, other{{.address = "0.0.0.0"}};
    const auto token = [](const std::string& link) { return link.substr(link.find("token=") + 6); };
    CHECK(token(one.link()).size() == 32);
    CHECK(token(one.link()) != token(other.link()));
}

TEST_CASE("what cannot be served is refused at once") {
    const net::live_server first{net::live_options{}};
    try {
        const net::live_server second{{.port = first.port()}};
        FAIL("the port was given twice");
    } catch (const net::open_error& error) {
        CHECK(error.code() == net::errc::address_in_use);
        CHECK(std::string{error.what()}.find("ss -ltnp") != std::string::npos);
    }
    CHECK_THROWS_AS(net::live_server{{.address = "no address"}}, net::open_error);
    CHECK_THROWS_AS(net::live_server{{.address = "198.51.100.7"}}, net::open_error); // of no machine
    CHECK_THROWS_AS(net::live_server{{.token = "short"}}, std::invalid_argument);
    CHECK_THROWS_AS(net::live_server{{.token = "with spaces in it"}}, std::invalid_argument);
    CHECK_THROWS_AS(net::live_server{{.page_file = "/no/such/file"}}, std::invalid_argument);
    CHECK_THROWS_AS(net::live_server{{.page_file = "/"}}, std::invalid_argument);         // a folder
    CHECK_THROWS_AS(net::live_server{{.page_file = "/dev/null"}}, std::invalid_argument); // empty
}

TEST_CASE("a viewer gets the newest message of each kind") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    const auto first = viewer.next();
    CHECK(first["hello"] == json{{"program", "test"}, {"version", "1.2.3"}, {"name", "robot"}, {"period", 0.1}});
    CHECK(first["lost"] == 0);
    CHECK(!first.contains("messages"));

    v.feed.message(live_way::received, head_of(0x0405), effort_of(25));
    v.feed.message(live_way::received, head_of(0x0405), effort_of(50));
    auto row = viewer.row("set_wrench_effort");
    CHECK(row["id"] == 1);
    CHECK(row["generation"] == "ra");
    CHECK(row["way"] == "received");
    CHECK(row["code"] == "0405h");
    CHECK(row["from"] == "1.1.32.1");
    CHECK(row["to"] == "2.2.33.1");
    CHECK(row["size"] == 20);
    CHECK(!row.contains("cut"));
    CHECK(!row.contains("error"));
    CHECK(row["hex"] == "06020504012102020120010100000000"
                        "01000040");
    CHECK(row["fields"]["propulsive_linear_effort_x"].get<double>() == Approx(50).margin(0.01));
    CHECK(row["fields"].size() == 1);
    CHECK(row["units"] == json{{"propulsive_linear_effort_x", "%"}});
    CHECK(row["rate"].get<double>() > 0);

    CHECK(!row.contains("acknowledgement"));

    // Another way is another row, and a wrong body has an error.
    v.feed.message(live_way::sent, head_of(0x0405), effort_of(1));
    row = viewer.row("set_wrench_effort");
    while (row["way"] != "sent") row = viewer.row("set_wrench_effort"); // the rate of the other changes
    CHECK(row["id"] == 2);
    v.feed.message(live_way::received, head_of(0x040A), std::vector<std::byte>(1));
    row = viewer.row("set_travel_speed");
    CHECK(row["error"].get<std::string>().find("byte") != std::string::npos);
    CHECK(!row.contains("fields"));
    // A code that no catalogue has.
    v.feed.message(live_way::received, head_of(0xD123), std::vector<std::byte>(3));
    row = viewer.row("");
    CHECK(row["code"] == "D123h");
    CHECK(row["size"] == 19);

    // A second viewer gets all rows at once, with their units.
    web_client second{v.port()};
    REQUIRE(second.watch().status == 101);
    const auto all = second.next();
    CHECK(all.contains("hello"));
    REQUIRE(all["messages"].size() == 4);
    CHECK(all["messages"][0]["count"] == 2);
    CHECK(all["messages"][0].contains("units"));
}

TEST_CASE("acknowledgements are rows of their own") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    viewer.next();
    const auto next = [&](std::size_t id) { // the rates of the others change
        auto row = viewer.row("set_wrench_effort");
        while (row["id"] != id) row = viewer.row("set_wrench_effort");
        return row;
    };
    auto head = head_of(0x0405);
    v.feed.message(live_way::received, head, effort_of(1));
    CHECK(!next(1).contains("acknowledgement"));
    // A message that wants one is in the row of those that do not.
    head.ack_nak = jaus::ack_nak::request;
    v.feed.message(live_way::received, head, effort_of(1));
    auto row = next(1);
    while (row["count"] != 2) row = next(1);
    CHECK(row["acknowledgement"] == "request");
    CHECK(row["fields"].size() == 1);

    // From the same source: both ends may send the message.
    head.ack_nak = jaus::ack_nak::ack;
    v.feed.message(live_way::received, head, {});
    row = next(2);
    CHECK(row["acknowledgement"] == "ack");
    CHECK(row["size"] == 16);
    CHECK(!row.contains("fields"));
    CHECK(!row.contains("error"));
    head.ack_nak = jaus::ack_nak::nak;
    v.feed.message(live_way::received, head, {});
    row = next(3);
    CHECK(row["acknowledgement"] == "nak");
    CHECK(row["count"] == 1);
    CHECK(!row.contains("fields"));
    CHECK(!row.contains("error"));

    // That of SAE JAUS has no message ID.
    const std::vector<std::byte> bytes(14);
    v.feed.message(live_way::seen, net::live_sae_message{.from = 1U << 16U | 1U << 8U | 32U,
                                                         .to = 2U << 16U | 2U << 8U | 33U,
                                                         .message = bytes,
                                                         .payload_begin = 12,
                                                         .acknowledgement = jaus::ack_nak::ack});
    row = viewer.row("");
    CHECK(row["generation"] == "sae");
    CHECK(row["code"] == "");
    CHECK(row["acknowledgement"] == "ack");
    CHECK(!row.contains("error"));
}

TEST_CASE("enumerations have their names, and members of lists their paths") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    viewer.next();
    const auto& all = catalogue::ra_3_3();
    const auto put = [&](const char* line) {
        const auto message = all.from_text(line);
        REQUIRE(message);
        v.feed.message(live_way::received, head_of(message->command_code()), *message->encode());
    };
    put("report_component_status primary_status_code=ready secondary_status_code=0");
    CHECK(viewer.row("report_component_status")["fields"]["primary_status_code"] == "ready");
    put("set_joint_positions joint[0].joint_position=0.5 joint[1].joint_position=-1");
    const auto row = viewer.row("set_joint_positions");
    CHECK(row["fields"]["joint.0.joint_position"].get<double>() == Approx(0.5).margin(1e-6));
    CHECK(row["fields"]["joint.1.joint_position"].get<double>() == Approx(-1).margin(1e-6));
    CHECK(row["units"]["joint.1.joint_position"] == "rad");
}

TEST_CASE("messages of SAE are decoded by their own catalogue") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    viewer.next();
    const auto message = catalogue::sae_core_1_1().from_text("request_control authority_code=7");
    REQUIRE(message);
    const auto payload = *message->encode();
    v.feed.message(live_way::seen, net::live_sae_message{.message_id = 0x000D,
                                                         .from = 1U << 16U | 1U << 8U | 32U,
                                                         .to = 300U << 16U | 2U << 8U | 33U,
                                                         .message = payload,
                                                         .payload_size = payload.size()});
    const auto row = viewer.row("request_control");
    CHECK(row["generation"] == "sae");
    CHECK(row["from"] == "1.1.32");
    CHECK(row["to"] == "300.2.33");
    CHECK(row["fields"]["authority_code"] == 7);
}

TEST_CASE("a long message is cut") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    viewer.next();
    v.feed.message(live_way::received, head_of(0x0405), std::vector<std::byte>(4000));
    const auto row = viewer.row("set_wrench_effort");
    CHECK(row["size"] == 4016);
    CHECK(row["cut"] == true);
    CHECK(row["hex"].get<std::string>().size() == 2 * 512);
    CHECK(!row.contains("fields"));
    CHECK(!row.contains("error"));
}

TEST_CASE("state is sent when it has changed, and faults once") {
    view v;
    v.server.fault(net::live_level::bad, "slave 2 does not answer");
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    const auto first = viewer.next();
    REQUIRE(first["faults"].size() == 1);
    CHECK(first["faults"][0]["level"] == "bad");
    CHECK(first["faults"][0]["text"] == "slave 2 does not answer");
    const net::live_state state{
        .systems = {{.subsystem = 2, .name = "robot", .address = "127.0.0.1:3794", .is_alive = true}},
        .components =
            {{.id = driver, .is_own = true, .name = "driver", .state = "ready", .controller = ocu, .authority = 4}},
        .buses = {{.name = "eth0",
                   .state = "op",
                   .period = std::chrono::milliseconds{1},
                   .cycles = 7,
                   .lateness_limits_us = {1, 2},
                   .lateness_counts = {5, 1, 1},
                   .slaves = {{.position = 0,
                               .station = 0x1001,
                               .name = "arm",
                               .state = "op",
                               .wanted = "op",
                               .is_in_service = true}}}}};
    v.feed.set_state(state);
    const auto frame = viewer.next([](const json& one) { return one.contains("systems"); });
    CHECK(frame["systems"] == json::parse(R"([{"subsystem": 2, "name": "robot", "address": "127.0.0.1:3794",
        "generation": "ra", "alive": true}])"));
    CHECK(frame["components"] == json::parse(R"([{"id": "2.2.33.1", "own": true, "name": "driver", "state": "ready",
        "controller": "1.1.32.1", "authority": 4}])"));
    CHECK(frame["buses"] == json::parse(R"([{"name": "eth0", "state": "op", "period_us": 1000, "cycles": 7,
        "working_counter": {"expected": 0, "last": 0, "wrong": 0}, "frames_lost": 0,
        "histogram": {"upper_us": [1, 2], "counts": [5, 1, 1]},
        "slaves": [{"position": 0, "name": "arm", "station": "1001h", "state": "op", "wanted": "op", "al_status": "",
        "in_service": true, "at_rest": false}]}])"));
    CHECK(!frame.contains("faults"));
    v.feed.set_state(state);
    v.server.fault(net::live_level::warning, "another");
    const auto next = viewer.next([](const json& one) { return one.contains("faults"); });
    CHECK(!next.contains("systems"));
    CHECK(!next.contains("buses"));
    // The node's thread does nothing, and then works on.
    const auto old = viewer.next([](const json& one) { return one.contains("state_age"); });
    CHECK(old["state_age"] >= 2);
    v.feed.set_state(state);
    viewer.next([](const json& one) { return !one.contains("state_age"); });
}

TEST_CASE("the last 200 faults are kept") {
    view v;
    for (int i = 0; i != 250; ++i) v.server.fault(net::live_level::info, std::to_string(i));
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    const auto first = viewer.next();
    REQUIRE(first["faults"].size() == 200);
    CHECK(first["faults"][0]["text"] == "50");
    CHECK(first["faults"][199]["text"] == "249");
}

TEST_CASE("nothing is copied while no viewer is there") {
    view v;
    CHECK(!v.feed.is_watched());
    v.feed.message(live_way::received, head_of(0x0405), effort_of(1));
    CHECK(v.feed.samples().begin_read() == nullptr);
    {
        web_client viewer{v.port()};
        REQUIRE(viewer.watch().status == 101);
        viewer.next();
        CHECK(v.feed.is_watched());
        CHECK(v.server.counts().viewers == 1);
    }
    eventually([&] { return !v.feed.is_watched(); });
    CHECK(v.server.counts().viewers == 0);
}

TEST_CASE("messages that come faster than they are read are lost, and counted") {
    net::live_feed feed; // that no server reads
    feed.set_watched(true);
    constexpr auto capacity = net::detail::sample_ring::capacity;
    for (std::size_t i = 0; i != capacity + 100; ++i) feed.message(live_way::sent, head_of(0x0405), effort_of(1));
    CHECK(feed.samples().lost() == 100);
}

TEST_CASE("kinds of messages beyond the limit are lost, and counted") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    viewer.next();
    for (unsigned i = 0; i != net::live_server::max_rows + 10; ++i)
        v.feed.message(live_way::sent, head_of(static_cast<std::uint16_t>(0xD000 + i)), {});
    std::size_t rows = 0;
    const auto last = viewer.next([&](const json& frame) {
        if (frame.contains("messages"))
            for (const auto& one : frame["messages"]) rows = std::max(rows, one["id"].get<std::size_t>());
        return frame["lost"] == 10;
    });
    CHECK(rows == net::live_server::max_rows);
}

TEST_CASE("a slow viewer misses updates, and the others do not") {
    view v{{.send_buffer = 4096}};
    web_client slow{v.port(), 4096}, quick{v.port()};
    REQUIRE(slow.watch().status == 101);
    REQUIRE(quick.watch().status == 101);
    quick.next();
    // 200 rows of half a kilobyte change in each update.
    const std::vector<std::byte> body(400);
    for (std::uint64_t updates = 0; v.server.counts().skipped < 20; ++updates) {
        for (unsigned i = 0; i != 200; ++i)
            v.feed.message(live_way::sent, head_of(static_cast<std::uint16_t>(0xD000 + i)), body);
        REQUIRE(quick.next().is_object());
        REQUIRE(updates < 1000);
    }
    CHECK(v.server.counts().lost == 0);
    // It gets on where it is, and is told what it has missed.
    const auto late = slow.next([](const json& frame) { return frame["skipped"] != 0; });
    CHECK(late["messages"].size() <= 200);
}

TEST_CASE("what a viewer sends is ignored, and a long text ends its connection") {
    view v;
    web_client viewer{v.port()};
    REQUIRE(viewer.watch().status == 101);
    viewer.next();
    viewer.say(1024);
    CHECK(viewer.next().is_object());
    CHECK(viewer.next().is_object());
    viewer.say(1025);
    for (int i = 0; i != 1000 && !viewer.next().is_null(); ++i) {}
    CHECK(viewer.close_code == 1009);
    eventually([&] { return v.server.counts().viewers == 0; });
}

TEST_CASE("a ninth viewer is refused") {
    view v;
    std::vector<std::unique_ptr<web_client>> viewers;
    for (std::size_t i = 0; i != net::live_server::max_viewers; ++i) {
        viewers.push_back(std::make_unique<web_client>(v.port()));
        REQUIRE(viewers.back()->watch().status == 101);
    }
    CHECK(web_client{v.port()}.watch().status == 503);
    CHECK(web_client{v.port()}.request("/").status == 200);
    viewers.pop_back();
    eventually([&] { return v.server.counts().viewers < net::live_server::max_viewers; });
    CHECK(web_client{v.port()}.watch().status == 101);
}
