// A node with nodes of other vendors: discovered, queried and controlled as by them, byte by byte.
#include "net/foreign_node.hpp"
#include "net/node_program.hpp"
#include "support/pcap.hpp"
#include <jauscat/jaus/events/service_connections.hpp>
#include <jauscat/jaus/message/framing.hpp>

using namespace net_test;

namespace {

using numbers = std::vector<unsigned>;

/// The robot 2.1 with a primitive driver, 2.1.33.1, that reports its wrench effort to service connections.
struct robot {
    static constexpr auto period = 50ms; // of heartbeats
    static constexpr auto patience = 2s;

    explicit robot(boost::asio::io_context& context, const std::string& others = "",
                   net::access who = net::access::open)
        : port{free_ports<1>()[0]},
          node{context,
               config("robot", system("robot", "2.1.0.0", port,
                                      "<node id='1' name='arm'/><component id='33' name='driver' authority='3'/>") +
                                   others),
               options(who)} {
        core.change(jaus::state_event::initialized);
        node.add(core, application);
        node.add(plain, application);
        node.start();
    }
    net::jaus_node_options options(net::access who) {
        net::jaus_node_options made{.accept = who};
        made.beat.period = period;
        made.timeout = patience;
        made.log = [this](std::string_view line) { log.emplace_back(line); };
        made.appeared = [this](const jaus::address& one) { appeared.push_back(one); };
        made.disappeared = [this](const jaus::address& one) { disappeared.push_back(one); };
        return made;
    }

    struct filler {
        std::optional<std::size_t> operator()(std::uint16_t, std::uint32_t, std::span<std::byte> body) const {
            const auto encoded = wire::encode(jaus::report_wrench_effort{.propulsive_linear_effort_x = 50}, body);
            return encoded ? std::optional{encoded->size()} : std::nullopt;
        }
    } fill{};
    struct handler {
        std::vector<jaus::set_wrench_effort> efforts{};
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte> body) {
            if (head.command_code != jaus::command_code_of<jaus::set_wrench_effort>)
                return jaus::message_outcome::unhandled;
            return jaus::decode_for<jaus::set_wrench_effort>(body, [&](const auto& m) { efforts.push_back(m); });
        }
    } application{};

    std::uint16_t port;
    std::vector<std::string> log{};
    std::vector<jaus::address> appeared{}, disappeared{};
    std::array<std::byte, 256> report{};
    std::array<jaus::connectable_report, 1> reports{{{0x4405, 1, 100}}};
    jaus::service_connections<4> connections{make(2, 1, 33), reports, fill, report};
    jaus::component_memory<> memory{}, plain_memory{};
    jaus::component<jaus::service_connections<4>> core{make(2, 1, 33), memory, {}, {}, connections};
    jaus::component<> plain{make(2, 1, 34), plain_memory, {}, {}};
    net::jaus_node node;
};

constexpr jaus_id communicator{7, 1, 35, 1}, commander{7, 1, 32, 1}, manager{2, 1, 1, 1}, driver{2, 1, 33, 1},
    all_managers{255, 255, 1, 1};

std::string text_of(const numbers& body, std::size_t from) {
    std::string text;
    for (std::size_t i = from; i < body.size() && body[i] != 0; ++i) text += static_cast<char>(body[i]);
    return text;
}

/// The message with the code `answer` that `m` leads to.
raw_message asked(foreign_node& other, std::uint16_t port, const raw_message& m, unsigned answer) {
    other.send(port, m);
    auto got = other.wait_for(answer);
    REQUIRE(got);
    return *std::move(got);
}

} // namespace

TEST_CASE("a foreign communicator finds an open node without configuration and gets all answers") {
    boost::asio::io_context context;
    robot r{context};
    foreign_node other{context};
    const auto ask = [&](const raw_message& m, unsigned answer) {
        const auto got = asked(other, r.port, m, answer);
        REQUIRE(got.source == m.destination);
        REQUIRE(got.destination == m.source);
        REQUIRE(got.properties == 0x0206);
        return got.body;
    };
    other.send(r.port, {.code = 0x4202, .source = communicator, .destination = all_managers, .sequence = 9});
    const auto beat = other.wait_for(0x4202);
    REQUIRE(beat);
    REQUIRE(beat->source == manager);
    REQUIRE(beat->destination == all_managers);
    REQUIRE(beat->body.empty());
    REQUIRE(has(r.appeared, make(7, 1, 35)));

    // Subsystem: query type 2. Authority, type 30001 = 7531h, 80 characters.
    auto body = ask({.code = 0x2B00, .source = communicator, .destination = manager, .body = {2}}, 0x4B00);
    REQUIRE(body.size() == 84);
    REQUIRE(numbers(body.begin(), body.begin() + 4) == numbers{2, 0, 0x31, 0x75});
    REQUIRE(text_of(body, 4) == "robot");
    // Its components: one node, 1, with three.
    body = ask({.code = 0x2B01, .source = communicator, .destination = manager, .body = {2}}, 0x4B01);
    REQUIRE(body == numbers{1, 1, 3, 1, 1, 33, 1, 34, 1});
    body = ask({.code = 0x2B01, .source = communicator, .destination = manager, .body = {3}}, 0x4B01);
    REQUIRE(body == numbers{1, 1, 3, 1, 1, 33, 1, 34, 1});
    // An event of every change of that report, with the query in it: presence 40h, request 0, type 1.
    body = ask({.code = 0x01F0,
                .source = communicator,
                .destination = manager,
                .body = {0x80, 0, 0x01, 0x4B, 1, 1, 0, 0, 0, 2}},
               0x01F3);
    REQUIRE(body.size() == 6);
    REQUIRE(numbers(body.begin(), body.begin() + 4) == numbers{0, 0, 0x01, 0x4B});
    REQUIRE(body[5] == 0);
    // Then the node, and each component: who it is and what it can do.
    body = ask({.code = 0x2B00, .source = communicator, .destination = manager, .body = {3}}, 0x4B00);
    REQUIRE(text_of(body, 4) == "arm");
    body = ask({.code = 0x2B00, .source = communicator, .destination = driver, .body = {4}}, 0x4B00);
    REQUIRE(numbers(body.begin(), body.begin() + 4) == numbers{4, 3, 0x61, 0xEA});
    REQUIRE(text_of(body, 4) == "driver");
    body = ask({.code = 0x2B00, .source = communicator, .destination = {2, 1, 34, 1}, .body = {4}}, 0x4B00);
    REQUIRE(text_of(body, 4) == "component 34");
    body = ask({.code = 0x2B03, .source = communicator, .destination = driver}, 0x4B03);
    REQUIRE(numbers(body.begin(), body.begin() + 3) == numbers{2, 0, 0}); // the service of type 0, and
    constexpr auto core_size = 1 + 2 + 1 + 17 * 6 + 1 + 9 * 6;
    REQUIRE(numbers(body.begin() + core_size, body.end()) ==
            numbers{33,   0,                                                    // a primitive driver's:
                    8,                                                          // it takes
                    8,    0,    0,    0,    0,    0,    10,   0,    0, 0, 0, 0, // requests for service connections
                    11,   0,    0,    0,    0,    0,    12,   0,    0, 0, 0, 0, //
                    0xF0, 1,    0,    0,    0,    0,    0xF1, 1,    0, 0, 0, 0, // and events,
                    0xF2, 1,    0,    0,    0,    0,    0xF0, 0x21, 0, 0, 0, 0, //
                    6,                                                          // and gives
                    9,    0,    0,    0,    0,    0,                            // the confirmation of the former,
                    5,    0x44, 0xFF, 0xFF, 0xFF, 0xFF,                         // Report Wrench Effort,
                    0xF3, 1,    0,    0,    0,    0,    0xF4, 1,    0, 0, 0, 0, // and what belongs to events
                    0xF1, 0x41, 0,    0,    0,    0,    0xF0, 0x41, 0, 0, 0, 0});
    body = ask({.code = 0x2B03, .source = communicator, .destination = {2, 1, 34, 1}}, 0x4B03);
    REQUIRE(numbers(body.begin() + core_size, body.begin() + core_size + 2) == numbers{34, 0}); // only what all have
    REQUIRE(body.size() == core_size + 2 + 1 + 8 * 6 + 1 + 5 * 6);
    body = ask({.code = 0x2B03, .source = communicator, .destination = manager}, 0x4B03);
    REQUIRE(numbers(body.begin(), body.begin() + 3) == numbers{1, 1, 0});
    body = ask({.code = 0x2B02, .source = communicator, .destination = manager}, 0x4B02);
    REQUIRE(body == numbers{2, 2, 1, 1, 1, 7, 1, 35, 1});
    body = ask({.code = 0x2202, .source = communicator, .destination = driver}, 0x4202);
    REQUIRE(body.empty());
    body = ask({.code = 0x2002, .source = communicator, .destination = driver}, 0x4002);
    REQUIRE(body == numbers{1, 0, 0, 0, 0}); // Ready
    REQUIRE(r.log.empty());
}

TEST_CASE("a foreign operator connects, takes control, commands, and loses control without heartbeats") {
    boost::asio::io_context context;
    robot r{context};
    foreign_node other{context};
    const auto ask = [&](const raw_message& m, unsigned answer) { return asked(other, r.port, m, answer).body; };
    other.repeat(r.port, {.code = 0x4202, .source = communicator, .destination = all_managers});

    // 20 Hz of Report Wrench Effort, all fields. Rates are scaled: 1092 Hz are FFFFh.
    const unsigned rate = 20 * 65535 / 1092;
    auto body = ask({.code = 0x0008,
                     .source = commander,
                     .destination = driver,
                     .body = {0x05, 0x44, rate & 0xFF, rate >> 8, 0xFF, 0xFF, 0, 0}},
                    0x0009);
    REQUIRE(body.size() == 6);
    REQUIRE(numbers(body.begin(), body.begin() + 2) == numbers{0x05, 0x44});
    REQUIRE(body[3] + 256 * body[4] == rate);
    REQUIRE(body[5] == 0);
    for (unsigned sequence = 0; sequence != 5; ++sequence) {
        const auto report = other.wait_for(0x4405);
        REQUIRE(report);
        REQUIRE(report->properties == 0x0246); // the service connection flag
        REQUIRE(report->sequence == sequence);
        REQUIRE(report->destination == commander);
        REQUIRE(report->body == numbers{0x01, 0x00, 0x00, 0x40});
    }
    other.send(r.port, {.code = 0x000C, .source = commander, .destination = driver, .body = {0x05, 0x44, body[2]}});
    while (other.wait_for(0x4405, 200ms)) {}
    // A component without this one says so.
    body = ask({.code = 0x0008,
                .source = commander,
                .destination = {2, 1, 34, 1},
                .body = {0x05, 0x44, rate & 0xFF, rate >> 8, 0xFF, 0xFF, 0, 0}},
               0x0009);
    REQUIRE(body == numbers{0x05, 0x44, 0, 0, 0, 6});
    body =
        ask({.code = 0x01F0, .source = commander, .destination = {2, 1, 34, 1}, .body = {0, 7, 0x05, 0x44, 1}}, 0x01F4);
    REQUIRE(numbers(body.begin() + 1, body.begin() + 3) == numbers{7, 5}); // message not supported

    REQUIRE(ask({.code = 0x000D, .source = commander, .destination = driver, .body = {127}}, 0x000F) == numbers{0});
    REQUIRE(ask({.code = 0x200D, .source = commander, .destination = driver}, 0x400D) == numbers{7, 1, 32, 1, 127});
    // Acknowledged: the same code and number, no body, ACK is 30h.
    other.send(r.port, {.code = 0x0405,
                        .source = commander,
                        .destination = driver,
                        .properties = 0x0216,
                        .sequence = 4711,
                        .body = {0x01, 0x00, 0x00, 0x40}});
    auto ack = other.wait_for(0x0405);
    REQUIRE(ack);
    REQUIRE(ack->properties == 0x0236);
    REQUIRE(ack->sequence == 4711);
    REQUIRE(ack->body.empty());
    REQUIRE(r.application.efforts.size() == 1);
    // All presence bits, and the twelve fields: the bits without a field are ignored, and logged once.
    numbers all_bits{0xFF, 0xFF, 0, 0x40};
    all_bits.resize(2 + 6 * 2 + 6);
    for (const unsigned sequence : {4712U, 4713U}) {
        other.send(r.port, {.code = 0x0405,
                            .source = commander,
                            .destination = driver,
                            .properties = 0x0216,
                            .sequence = sequence,
                            .body = all_bits});
        ack = other.wait_for(0x0405);
        REQUIRE(ack);
        REQUIRE(ack->properties == 0x0236);
    }
    REQUIRE(r.application.efforts.size() == 3);
    CHECK(r.application.efforts[2].propulsive_linear_effort_x.value() > 49);
    CHECK(std::ranges::count_if(r.log, [](const std::string& line) {
              return line == "Set Wrench Effort (0x0405) 7.1.32.1 -> 2.1.33.1: presence bits without a field are "
                             "ignored: 0xF000";
          }) == 1);
    // Another of its subsystem has no control: NAK, and control is refused to it.
    constexpr jaus_id second{7, 1, 40, 1};
    other.send(r.port, {.code = 0x0405,
                        .source = second,
                        .destination = driver,
                        .properties = 0x0216,
                        .body = {0x01, 0x00, 0x00, 0x40}});
    ack = other.wait_for(0x0405);
    REQUIRE(ack);
    REQUIRE(ack->properties == 0x0226);
    REQUIRE(ask({.code = 0x000D, .source = second, .destination = driver, .body = {127}}, 0x000F) == numbers{2});
    // But it may stop the machine, and let it go on.
    other.send(r.port, {.code = 0x0006, .source = second, .destination = driver, .body = {1, 0}});
    REQUIRE(ask({.code = 0x2002, .source = second, .destination = driver}, 0x4002) == numbers{5, 0, 0, 0, 0});
    other.send(r.port, {.code = 0x0007, .source = second, .destination = driver, .body = {1, 0}});
    REQUIRE(ask({.code = 0x2002, .source = second, .destination = driver}, 0x4002) == numbers{2, 0, 0, 0, 0});
    REQUIRE(r.core.control().controls(make(7, 1, 32)));

    // Only the communicator sends heartbeats: with them the whole subsystem is gone.
    other.fall_silent();
    REQUIRE(support::until(context, [&] { return has(r.disappeared, make(7, 1, 35)); }));
    REQUIRE_FALSE(r.core.control().controller());
}

TEST_CASE("a foreign robot connects to the core reports of any component, and to events of their changes") {
    boost::asio::io_context context;
    robot r{context};
    foreign_node other{context};
    const auto ask = [&](const raw_message& m, unsigned answer) { return asked(other, r.port, m, answer).body; };
    other.repeat(r.port, {.code = 0x4202, .source = communicator, .destination = all_managers});
    constexpr jaus_id plain{2, 1, 34, 1};
    const unsigned rate = 20 * 65535 / 1092;
    for (const auto& of : {plain, manager})
        for (const unsigned report : {0x4001U, 0x4002U, 0x400DU, 0x4011U, 0x4202U, 0x4B00U, 0x4B03U}) {
            CAPTURE(report, of[2]);
            const auto confirmed = ask({.code = 0x0008,
                                        .source = commander,
                                        .destination = of,
                                        .body = {report & 0xFF, report >> 8, rate & 0xFF, rate >> 8, 0xFF, 0xFF, 0, 0}},
                                       0x0009);
            REQUIRE(confirmed[5] == 0);
            auto sent = other.wait_for(report);
            while (sent && sent->properties != 0x0246) sent = other.wait_for(report); // heartbeats of its own
            REQUIRE(sent);
            REQUIRE(sent->source == of);
            std::vector<unsigned> query;
            if (report == 0x4011) query = {3};
            if (report == 0x4B00) query = {4};
            other.send(r.port, {.code = 0x000C,
                                .source = commander,
                                .destination = of,
                                .body = {report & 0xFF, report >> 8, confirmed[2]}});
            if (report != 0x4011) // it has passed
                REQUIRE(ask({.code = report - 0x2000, .source = commander, .destination = of, .body = query}, report) ==
                        sent->body);
        }
    // An event of every change of the state.
    REQUIRE(ask({.code = 0x01F0, .source = commander, .destination = plain, .body = {0, 7, 0x02, 0x40, 1}},
                0x01F3)[1] == 7);
    other.send(r.port, {.code = 0x0006, .source = commander, .destination = plain, .body = {1, 0}});
    const auto emergency = other.wait_for(0x41F1);
    REQUIRE(emergency);
    REQUIRE(numbers(emergency->body.begin() + 1, emergency->body.end()) ==
            numbers{0x02, 0x40, 0, 5, 0, 0, 0, 5, 0, 0, 0, 0});
}

namespace {

/// A datagram of AS5669-2007 with these messages.
std::vector<std::byte> judp1(std::initializer_list<raw_message> messages) {
    std::vector<std::byte> all{std::byte{1}};
    for (const auto& m : messages) {
        const auto bytes = datagram_of(m, false);
        for (const auto value : {std::size_t{0}, std::size_t{0}, bytes.size() >> 8, bytes.size() & 0xFF})
            all.push_back(static_cast<std::byte>(value));
        all.insert(all.end(), bytes.begin(), bytes.end());
    }
    return all;
}
/// The command code of a datagram of one message of AS5669-2007; 0: it is none.
unsigned code_of_judp1(const std::vector<std::byte>& bytes) {
    const auto part = jaus::remove_framing(bytes);
    const auto m = jaus::split(part.message);
    return part.how == jaus::framing::judp1 && part.rest.empty() && m ? m.header.command_code : 0;
}
const raw_message query_status{.code = 0x2002, .source = commander, .destination = driver};
const raw_message query_authority{.code = 0x2001, .source = commander, .destination = driver};

} // namespace

TEST_CASE("a system of AS5669-2007 is answered in its form, also several messages of a datagram") {
    boost::asio::io_context context;
    foreign_node other{context};
    const auto other_system = "<system name='other' jausip='7.0.0.0' ip='127.0.0.1' port='" +
                              std::to_string(other.port()) + "' framing='judp1'/>";
    robot r{context, other_system, net::access::closed};
    other.send(r.port, judp1({query_status, query_authority}));
    std::vector<unsigned> answers;
    while (answers.size() != 2) {
        const auto got = other.receive();
        REQUIRE_FALSE(got.empty());
        const auto code = code_of_judp1(got);
        REQUIRE(code != 0);
        if (code != 0x4202 && code != 0x2B01) answers.push_back(code);
    }
    CHECK(answers == std::vector<unsigned>{0x4002, 0x4001});
    CHECK(r.node.counts().received == 2);
    CHECK(r.log.empty());
    // Bytes behind the last message are reported.
    auto longer = judp1({query_status});
    longer.push_back(std::byte{});
    other.send(r.port, longer);
    REQUIRE(support::until(context, [&] { return !r.log.empty(); }));
    CHECK(r.log.back().find("its last 1 bytes are no message of AS5669-2007") != std::string::npos);
}

TEST_CASE("other forms are named in the log, with what is to be configured") {
    boost::asio::io_context context;
    foreign_node other{context};
    robot r{context, system("other", "7.0.0.0", other.port()), net::access::closed};
    other.send(r.port, judp1({query_status}));
    REQUIRE(support::until(context, [&] { return !r.log.empty(); }));
    CHECK(r.log.back().find("AS5669-2007") != std::string::npos);
    CHECK(r.log.back().find("framing=\"judp1\"") != std::string::npos);
    CHECK(r.node.counts().other_framing == 1);
    r.log.clear();
    auto sae = std::vector<std::byte>(19); // a whole message of AS5669A: 14 bytes around four
    sae[0] = std::byte{2};
    sae[2] = std::byte{18};
    other.send(r.port, sae);
    REQUIRE(support::until(context, [&] { return !r.log.empty(); }));
    CHECK(r.log.back().find("it is SAE JAUS (AS5669A, version 2), which this node does not take: set the"
                            " option on_sae_datagram") != std::string::npos);
    CHECK(r.node.counts().other_generation == 1);
    // Each form of a host is named once.
    other.send(r.port, sae);
    other.send(r.port, judp1({query_status}));
    REQUIRE(support::until(context, [&] { return r.node.counts().other_framing == 2; }));
    CHECK(r.node.counts().other_generation == 2);
    CHECK(r.log.size() == 1);
}

TEST_CASE("a stranger of AS5669-2007 is answered in its form by an open node") {
    boost::asio::io_context context;
    foreign_node other{context};
    robot r{context};
    other.send(r.port, judp1({query_status}));
    for (unsigned code = 0; code != 0x4002;) {
        const auto got = other.receive();
        REQUIRE_FALSE(got.empty());
        code = code_of_judp1(got);
        REQUIRE(code != 0);
    }
}

TEST_CASE("a foreign communicator is notified of changes by the event that it created") {
    boost::asio::io_context context;
    const auto port = free_ports<1>()[0];
    const auto second = system("tool", "2.2.0.0", port);
    robot r{context, second};
    foreign_node other{context};
    other.send(r.port, {.code = 0x01F0,
                        .source = communicator,
                        .destination = manager,
                        .body = {0x80, 0, 0x01, 0x4B, 1, 1, 0, 0, 0, 2}});
    other.repeat(r.port, {.code = 0x4202, .source = communicator, .destination = all_managers});
    const auto confirmed = other.wait_for(0x01F3);
    REQUIRE(confirmed);
    program tool{context, config("tool", system("robot", "2.1.0.0", r.port) + second), make(2, 2, 50)};
    // Event: presence vector, ID, report, sequence number, size and body. First the node manager, then its components.
    for (const auto& [sequence, report] : {std::pair<unsigned, numbers>{0, {2, 1, 3, 1, 1, 33, 1, 34, 1, 2, 1, 1, 1}},
                                           {1, {2, 1, 3, 1, 1, 33, 1, 34, 1, 2, 2, 1, 1, 50, 1}}}) {
        const auto event = other.wait_for(0x41F1);
        REQUIRE(event);
        REQUIRE(event->source == manager);
        REQUIRE(event->destination == communicator);
        numbers expected{confirmed->body[4], 0x01, 0x4B, sequence, static_cast<unsigned>(report.size()), 0, 0, 0};
        expected.insert(expected.end(), report.begin(), report.end());
        REQUIRE(numbers(event->body.end() - static_cast<std::ptrdiff_t>(expected.size()), event->body.end()) ==
                expected);
    }
    tool.node.stop();
    const auto event = other.wait_for(0x41F1);
    REQUIRE(event);
    REQUIRE(event->body.back() == 1);
}

TEST_CASE("a stranger is answered at its last address, and gets no heartbeats when it is silent") {
    boost::asio::io_context context;
    robot r{context};
    foreign_node before{context}, after{context};
    const raw_message query{.code = 0x2002, .source = commander, .destination = driver};
    before.send(r.port, query);
    REQUIRE(before.wait_for(0x4002));
    after.send(r.port, datagram_of(query, false)); // bare is answered bare
    bytes answer;
    while (answer.size() != 21) REQUIRE_FALSE((answer = after.receive()).empty());
    REQUIRE(answer[2] == std::byte{0x02});
    REQUIRE(answer[3] == std::byte{0x40});
    while (before.wait_for(0x4202, 100ms)) {}
    REQUIRE_FALSE(before.wait_for(0x4202, 200ms));
    // Counted, not timed: a busy machine sends fewer in its time, never more.
    constexpr int most = robot::patience / robot::period + 1;
    const auto until_silence = [&] {
        int count = 0;
        while (count <= 10 * most && !after.receive(6 * r.period).empty()) ++count;
        return count;
    };
    REQUIRE(until_silence() <= most);
    // Nor reports that go on by themselves. What is for it alone goes out all the same.
    after.send(
        r.port,
        {.code = 0x0008, .source = commander, .destination = driver, .body = {0x05, 0x44, 0xB0, 4, 0xFF, 0xFF, 0, 0}});
    REQUIRE(after.wait_for(0x4405));
    constexpr int pulses = 8;                      // it is asked whether it is still there
    REQUIRE(until_silence() <= 2 * most + pulses); // heartbeats, and reports as often
    REQUIRE(r.node.send({.destination = make(7, 1, 32), .source = make(2, 1, 33)}, jaus::query_component_status{}));
    REQUIRE_FALSE(after.receive().empty());
}

TEST_CASE("a closed node answers no stranger, and a stranger cannot replace the route of a configured system") {
    boost::asio::io_context context;
    foreign_node known{context}, stranger{context};
    const auto others = system("other", "7.0.0.0", known.port(), "<framing>JAUS01.0</framing>");
    {
        robot r{context, others, net::access::closed};
        for (const auto& source : {commander, jaus_id{9, 1, 1, 1}, driver})
            stranger.send(r.port, {.code = 0x2002, .source = source, .destination = driver});
        REQUIRE(stranger.receive(200ms).empty());
        REQUIRE(r.node.counts().unknown_peer == 1);
        REQUIRE(r.node.counts().wrong_sender == 2);
    }
    robot r{context, others, net::access::open};
    while (!known.receive(1ms).empty()) {}
    stranger.send(r.port, {.code = 0x2002, .source = commander, .destination = driver});
    REQUIRE(known.wait_for(0x4002)); // there it is configured
    REQUIRE_FALSE(stranger.wait_for(0x4002, 200ms));
    stranger.send(r.port, {.code = 0x2002, .source = {9, 1, 1, 1}, .destination = driver});
    REQUIRE(stranger.wait_for(0x4002));
}

TEST_CASE("a foreign node of the same subsystem is queried for its components, and queries those of all") {
    boost::asio::io_context context;
    foreign_node other{context};
    robot r{context, system("tool", "2.2.0.0", other.port(), "<framing>JAUS01.0</framing>"), net::access::closed};
    constexpr jaus_id tool{2, 2, 1, 1};
    other.send(r.port, {.code = 0x4202, .source = tool, .destination = {2, 255, 1, 1}}); // within the subsystem
    const auto query = other.wait_for(0x2B01);
    REQUIRE(query);
    REQUIRE(query->source == manager);
    REQUIRE(query->destination == tool);
    REQUIRE(query->body == numbers{3});
    other.send(
        r.port,
        {.code = 0x4B01, .source = tool, .destination = manager, .body = {1, 2, 3, 1, 1, 37, 1, 37, 2}}); // two cameras
    REQUIRE(support::until(context, [&] { return has(r.appeared, make(2, 2, 37, 2)); }));
    other.send(r.port, {.code = 0x2B01, .source = tool, .destination = manager, .body = {2}});
    const auto report = other.wait_for(0x4B01);
    REQUIRE(report);
    REQUIRE(report->body == numbers{2, 1, 3, 1, 1, 33, 1, 34, 1, 2, 3, 1, 1, 37, 1, 37, 2});
    // With its node manager go its components.
    REQUIRE(support::until(context, [&] { return has(r.disappeared, make(2, 2, 37, 1)); }));
}

TEST_CASE("a stranger received by multicast is answered by unicast, and receives the group") {
    boost::asio::io_context context;
    const auto group_port = free_ports<1>()[0], port = free_ports<1>()[0];
    const std::string group =
        "<multicast group='224.1.0.1' port='" + std::to_string(group_port) + "' interface='lo' ttl='0'/>";
    program robot{context, config("robot", system("robot", "2.1.0.0", port, group + "<framing>JAUS01.0</framing>")),
                  make(2, 1, 33)};
    foreign_node other{context};
    const net::multicast_options options{.port = group_port, .interface_name = "lo", .ttl = 0};
    other.send_to_group(options, {.code = 0x4202, .source = communicator, .destination = all_managers});
    REQUIRE(support::until(context, [&] { return has(robot.appeared, make(7, 1, 35)); }));
    REQUIRE(robot.node.send({.destination = make(7, 1, 35), .source = robot.self}, jaus::query_services{}));
    const auto query = other.wait_for(0x2B03);
    REQUIRE(query);
    REQUIRE(query->destination == communicator);
    // The heartbeats go to the group alone, where such a node listens.
    REQUIRE_FALSE(other.wait_for(0x4202, 300ms));
    udp::socket member{context, udp::v4()};
    member.set_option(udp::socket::reuse_address{true});
    member.bind({options.group, group_port});
    net::join_group(member, options);
    REQUIRE(support::until(context, [&] { return member.available() != 0; }));
    std::vector<std::byte> beat(100);
    beat.resize(member.receive(boost::asio::buffer(beat)));
    REQUIRE(read_datagram(beat));
    REQUIRE(read_datagram(beat)->code == 0x4202);
}

TEST_CASE("the requests of a recorded foreign node are answered as by its recorded peer") {
    // Robot 152 of the recording: its node 5. 120 is the operator, 130 another.
    boost::asio::io_context context;
    foreign_node ocu{context}, base{context};
    const auto port = free_ports<1>()[0];
    const auto all = system("robot", "152.5.0.0", port) +
                     system("ocu", "120.0.0.0", ocu.port(), "<framing>JAUS01.0</framing>") +
                     system("base", "130.0.0.0", base.port(), "<framing>JAUS01.0</framing>");
    struct handler {
        int waypoints{}, speeds{};
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte> body) {
            using jaus::decode_for;
            if (head.command_code == jaus::command_code_of<jaus::set_global_waypoint>)
                return decode_for<jaus::set_global_waypoint>(body, [&](const auto&) { ++waypoints; });
            if (head.command_code == jaus::command_code_of<jaus::set_travel_speed>)
                return decode_for<jaus::set_travel_speed>(body, [&](const auto&) { ++speeds; });
            return jaus::message_outcome::unhandled;
        }
    } application{};
    std::vector<jaus::address> appeared;
    std::vector<std::string> log;
    net::jaus_node_options options{.log = [&](std::string_view line) { log.emplace_back(line); },
                                   .appeared = [&](const jaus::address& who) { appeared.push_back(who); }};
    options.beat.period = 1min;
    jaus::component_memory<> memory{};
    jaus::component<> mission{make(152, 5, 45), memory, {}, {}};
    mission.change(jaus::state_event::initialized);
    net::jaus_node node{context, config("robot", all), std::move(options)};
    node.add(mission, application);
    node.start();
    REQUIRE(ocu.wait_for(0x4202)); // the first heartbeat
    REQUIRE(base.wait_for(0x4202));

    int answers = 0, sent = 0;
    for (const auto& frame : jauscat::test::read_pcap("jaus_ra.pcap")) {
        constexpr std::size_t ip = 14, udp_payload = 14 + 20 + 8;
        if (frame.size() < udp_payload + 24 || frame[ip + 9] != std::byte{17}) continue;
        const auto size =
            std::to_integer<std::size_t>(frame[ip + 24]) * 256 + std::to_integer<std::size_t>(frame[ip + 25]) - 8;
        const auto first = frame.begin() + static_cast<std::ptrdiff_t>(udp_payload);
        const std::vector<std::byte> datagram(first, first + static_cast<std::ptrdiff_t>(size));
        const auto m = read_datagram(datagram);
        REQUIRE(m);
        const auto& to = m->destination;
        if (m->source[0] != 152) {
            if (to[0] != 255 && !(to[0] == 152 && to[1] == 5)) continue;
            (m->source[0] == 120 ? ocu : base).send(port, datagram);
            support::until(context, [&, before = node.counts().received] { return node.counts().received != before; });
            ++sent;
        } else if (m->source == jaus_id{152, 5, 45, 1} && (m->code == 0x000F || (m->properties & 0x20) != 0)) {
            // What the recorded component confirmed or acknowledged, this one has too, byte by byte.
            REQUIRE(ocu.receive() == datagram);
            ++answers;
        }
    }
    REQUIRE(sent == 84 + 114 + 88 + 56 + 58 + 20 + 14 + 12 + 12);
    REQUIRE(answers == 1 + 5 + 1);
    REQUIRE(application.waypoints == 5);
    REQUIRE(application.speeds == 1);
    REQUIRE(has(appeared, make(120, 1)));
    REQUIRE(has(appeared, make(130, 1)));
    REQUIRE_FALSE(mission.control().controller()); // it was released
    REQUIRE(node.counts().malformed + node.counts().wrong_sender + node.counts().unknown_peer == 0);
}
