// Attacks on a running node, through its socket: spoofed and repeated commands, a flood, a storm of a million
// datagrams, attempts to take control, and the traffic that a stranger can cause.
#include "net/foreign_node.hpp"
#include "net/node_program.hpp"
#include "support/random_message.hpp"

using namespace net_test;

namespace {

constexpr jaus_id operator_id{1, 1, 32, 1}, second_id{3, 1, 32, 1}, robot_id{2, 1, 33, 1}, manager_id{2, 1, 1, 1};
const raw_message query{.code = 0x2002, .source = operator_id, .destination = robot_id};

/// The robot 2.1.33.1; its operator 1.1.32.1 and a second one, 3.1.32.1, each at a port of its own; a stranger.
struct besieged {
    explicit besieged(const std::string& limits = "", net::access who = net::access::closed)
        : robot{context,
                config("robot", system("robot", "2.1.0.0", port) +
                                    system("ocu", "1.0.0.0", ocu.port(), "<framing>JAUS01.0</framing>" + limits) +
                                    system("second", "3.0.0.0", second.port(), "<framing>JAUS01.0</framing>")),
                make(2, 1, 33), options(who)} {}
    static net::jaus_node_options options(net::access who) {
        net::jaus_node_options made{.accept = who};
        made.socket.receive_buffer = 4'000'000;
        return made;
    }
    /// Until all that was sent so far has been looked at.
    void settle(std::uint64_t sent) {
        REQUIRE(support::until(context, [&] { return looked_at() >= sent; }));
    }
    [[nodiscard]] std::uint64_t looked_at() const {
        const auto c = robot.node.counts();
        return c.received + c.malformed + c.unknown_peer + c.wrong_sender + c.rate_limited + c.dropped + c.oversize;
    }
    [[nodiscard]] std::size_t efforts() const {
        return static_cast<std::size_t>(std::ranges::count_if(robot.seen, [](const seen_message& m) {
            return m.head.command_code == 0x0405 && m.what == jaus::component_outcome::handled;
        }));
    }

    boost::asio::io_context context{};
    foreign_node ocu{context}, second{context}, stranger{context};
    std::uint16_t port = free_ports<1>()[0];
    program robot;
};

raw_message effort(const jaus_id& source, unsigned sequence = 0, unsigned properties = 0x0206) {
    return {.code = 0x0405,
            .source = source,
            .destination = robot_id,
            .properties = properties,
            .sequence = sequence,
            .body = {0x01, 0x00, 0x00, 0x40}};
}

} // namespace

TEST_CASE("a replayed command is acknowledged again and not executed again") {
    besieged b;
    const auto recorded = datagram_of(effort(operator_id, 7, 0x0216));
    for (int i = 0; i != 20; ++i) {
        b.ocu.send(b.port, recorded);
        const auto ack = b.ocu.wait_for(0x0405);
        REQUIRE(ack);
        REQUIRE(ack->properties == 0x0236);
        REQUIRE(ack->sequence == 7);
    }
    REQUIRE(b.efforts() == 1);
    // From elsewhere not even that.
    for (int i = 0; i != 20; ++i) b.stranger.send(b.port, recorded);
    REQUIRE(support::until(b.context, [&] { return b.robot.node.counts().wrong_sender == 20; }));
    REQUIRE(b.stranger.receive(50ms).empty());
    REQUIRE(b.efforts() == 1);
    // The next number is another command.
    b.ocu.send(b.port, effort(operator_id, 8, 0x0216));
    REQUIRE(b.ocu.wait_for(0x0405));
    REQUIRE(b.efforts() == 2);
}

TEST_CASE("a flooding peer is limited to its rate while another is served") {
    besieged b{"<limits rate='1000' burst='100'/>"};
    const auto flood = datagram_of(effort(operator_id));
    const auto start = net::jaus_node::now();
    std::uint64_t sent = 0;
    for (int round = 0; round != 100; ++round) {
        for (int i = 0; i != 200; ++i) b.ocu.send(b.port, flood);
        auto other = query;
        other.source = second_id;
        b.second.send(b.port, other);
        REQUIRE(b.second.wait_for(0x4002)); // each time
        b.settle(sent += 201);
    }
    const auto seconds = std::chrono::duration<double>(net::jaus_node::now() - start).count();
    const auto counts = b.robot.node.counts();
    REQUIRE(static_cast<double>(b.efforts()) <= 101 + 1000 * seconds);
    REQUIRE(b.efforts() >= 100);
    REQUIRE(counts.rate_limited == 20'000 - b.efforts());
    REQUIRE(counts.dropped == 0);
    REQUIRE(b.robot.logged("rate-limited"));
    REQUIRE(b.robot.log.size() < 300);
}

TEST_CASE("control can only be taken over by a higher authority from its configured address") {
    besieged b;
    const auto ask = [&](foreign_node& from, const raw_message& m, unsigned answer) {
        from.send(b.port, m);
        const auto got = from.wait_for(answer);
        REQUIRE(got);
        return got->body;
    };
    using numbers = std::vector<unsigned>;
    const auto request = [](const jaus_id& source, unsigned authority) {
        return raw_message{.code = 0x000D, .source = source, .destination = robot_id, .body = {authority}};
    };
    const auto& control = b.robot.core.control();
    REQUIRE(ask(b.ocu, request(operator_id, 100), 0x000F) == numbers{0});
    REQUIRE(control.controls(make(1, 1, 32)));

    // Another peer, with a lower and the same authority.
    for (const unsigned authority : {0U, 99U, 100U})
        REQUIRE(ask(b.second, request(second_id, authority), 0x000F) == numbers{2});
    // Another component of the operator's own system, too.
    REQUIRE(ask(b.ocu, request({1, 1, 40, 1}, 100), 0x000F) == numbers{2});
    // A stranger, and the other peer, as the operator: release, request, confirm, reject, all commands.
    std::uint64_t forged = 0;
    for (auto* const attacker : {&b.stranger, &b.second})
        for (const unsigned code :
             {0x000EU, 0x000DU, 0x000FU, 0x0010U, 0x0001U, 0x0002U, 0x0003U, 0x0005U, 0x0405U, 0x0006U}) {
            raw_message m{.code = code, .source = operator_id, .destination = robot_id, .properties = 0x0216};
            if (code == 0x000D || code == 0x0001) m.body = {255};
            if (code == 0x000F) m.body = {0};
            if (code == 0x0006) m.body = {1, 0};
            if (code == 0x0405) m.body = {0x01, 0x00, 0x00, 0x40};
            attacker->send(b.port, m);
            ++forged;
        }
    // Messages that say to come from the robot itself, to it and to its manager.
    for (const auto& self : {robot_id, manager_id}) {
        b.stranger.send(b.port, {.code = 0x0002, .source = self, .destination = robot_id});
        b.ocu.send(b.port, {.code = 0x0002, .source = self, .destination = robot_id});
        forged += 2;
    }
    REQUIRE(support::until(b.context, [&] { return b.robot.node.counts().wrong_sender == forged; }));
    REQUIRE(b.stranger.receive(50ms).empty());
    REQUIRE(control.controls(make(1, 1, 32)));
    REQUIRE(control.authority_code() == 0);
    REQUIRE(b.robot.core.state() == jaus::primary_status_code::ready);
    REQUIRE(b.efforts() == 0);
    // The other peer under its own name: all listed commands get a NAK, Release has no effect.
    for (const unsigned code : {0x0002U, 0x0003U, 0x0005U, 0x000EU, 0x0405U}) {
        raw_message m{
            .code = code, .source = second_id, .destination = robot_id, .properties = 0x0216, .sequence = code};
        if (code == 0x0405) m.body = {0x01, 0x00, 0x00, 0x40};
        b.second.send(b.port, m);
        const auto answer = b.second.wait_for(code);
        REQUIRE(answer);
        REQUIRE(answer->properties == 0x0226);
    }
    REQUIRE(control.controls(make(1, 1, 32)));
    b.ocu.send(b.port, effort(operator_id, 1, 0x0216));
    REQUIRE(b.ocu.wait_for(0x0405));
    REQUIRE(b.efforts() == 1);
    // What the standard gives: a higher authority takes control, and the operator is told.
    REQUIRE(ask(b.second, request(second_id, 101), 0x000F) == numbers{0});
    REQUIRE(b.ocu.wait_for(0x0010));
    // And who sees the danger may stop the machine, control or not.
    b.ocu.send(b.port, {.code = 0x0006, .source = operator_id, .destination = robot_id, .body = {1, 0}});
    REQUIRE(ask(b.ocu, query, 0x4002) == numbers{5, 0, 0, 0, 0});
}

TEST_CASE("one million random and mutated datagrams are all counted, and the node still answers") {
    besieged b{"<limits rate='0'/>"};
    support::generator random{20261121};
    std::vector<std::vector<std::byte>> valid;
    for (const auto& m : {effort(operator_id, 1, 0x0216), query, effort(operator_id, 2),
                          raw_message{.code = 0x2B01, .source = operator_id, .destination = manager_id, .body = {2}},
                          raw_message{.code = 0x01F0,
                                      .source = operator_id,
                                      .destination = manager_id,
                                      .body = {0x80, 0, 0x01, 0x4B, 1, 1, 0, 0, 0, 2}},
                          raw_message{.code = 0x4202, .source = {1, 1, 1, 1}, .destination = {255, 255, 1, 1}},
                          raw_message{.code = 0x0008,
                                      .source = operator_id,
                                      .destination = robot_id,
                                      .body = {0x05, 0x44, 0xB0, 4, 0xFF, 0xFF, 0, 0}},
                          raw_message{.code = 0x0405, .source = operator_id, .destination = robot_id}})
        valid.push_back(datagram_of(m));
    b.robot.node.stop(); // begun anew without the hook that keeps all messages
    net::jaus_node_options options = besieged::options(net::access::closed);
    std::uint64_t lines = 0;
    options.log = [&](std::string_view) { ++lines; };
    jaus::component_memory<> memory{};
    jaus::component<> core{make(2, 1, 33), memory, {}, {}};
    core.change(jaus::state_event::initialized);
    std::uint64_t obeyed = 0;
    const auto application = [&](const jaus::header&, std::span<const std::byte>) {
        ++obeyed;
        return jaus::message_outcome::handled;
    };
    net::jaus_node node{b.context, b.robot.node.config(), options};
    node.add(core, application);
    node.start();
    const auto begun = std::chrono::steady_clock::now();
    const auto looked_at = [&] {
        const auto c = node.counts();
        return c.received + c.malformed + c.unknown_peer + c.wrong_sender + c.rate_limited + c.dropped + c.oversize;
    };

    constexpr std::uint64_t all = 1'000'000;
    std::vector<std::byte> datagram;
    for (std::uint64_t sent = 0; sent != all;) {
        const auto kind = support::below(random, 4);
        if (kind == 0) {
            datagram.resize(support::below(random, 300));
            support::fill(random, datagram);
        } else {
            datagram = valid[support::below(random, valid.size())];
            // One to three changes: a byte, a bit, the length.
            for (std::size_t changes = support::below(random, 3) + 1; changes != 0 && !datagram.empty(); --changes) {
                auto& byte = datagram[support::below(random, datagram.size())];
                switch (support::below(random, 4)) {
                case 0: byte = static_cast<std::byte>(random()); break;
                case 1: byte ^= static_cast<std::byte>(1U << support::below(random, 8)); break;
                case 2: datagram.resize(support::below(random, datagram.size() + 1)); break;
                default: datagram.resize(datagram.size() + support::below(random, 40)); break;
                }
            }
        }
        auto& from = kind == 3 ? b.stranger : b.ocu;
        from.send(b.port, datagram);
        ++sent;
        if (sent % 125 == 0 || sent == all) {
            REQUIRE(support::until(b.context, [&] { return looked_at() == sent; }));
            if (sent % 5000 == 0)
                while (!b.ocu.receive(0ms).empty()) {}
        }
    }
    const auto counts = node.counts();
    REQUIRE(counts.dropped == 0);
    REQUIRE(counts.received > 200'000);
    REQUIRE(counts.malformed > 50'000);
    REQUIRE(counts.wrong_sender > 100'000);
    REQUIRE(b.stranger.receive(10ms).empty()); // nothing was ever sent there
    // A cause logs 100 lines at once and 20 a second, each with a line about suppressed ones. There are fewer than 16.
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begun;
    REQUIRE(static_cast<double>(lines) < 16 * 2 * (100 + 20 * elapsed.count()));
    REQUIRE(obeyed > 0);

    while (!b.ocu.receive(1ms).empty()) {}
    b.ocu.send(b.port, query);
    REQUIRE(b.ocu.wait_for(0x4002));
    b.ocu.send(b.port, {.code = 0x2B00, .source = operator_id, .destination = manager_id, .body = {2}});
    REQUIRE(b.ocu.wait_for(0x4B00));
}

TEST_CASE("the traffic that a stranger can cause at an open node is small, and bounded for each of its datagrams") {
    besieged b{"", net::access::open};
    constexpr jaus_id stranger{9, 1, 32, 1};
    const auto drain = [&] {
        std::size_t size = 0;
        for (auto got = b.stranger.receive(30ms); !got.empty(); got = b.stranger.receive(30ms)) {
            const auto m = read_datagram(got);
            if (m && m->code != 0x4202) size += got.size();
        }
        return size;
    };
    struct question {
        unsigned code;
        jaus_id to;
        std::vector<unsigned> body;
        std::size_t most; ///< bytes of the answer
    };
    const std::vector<question> questions{
        {0x2B00, manager_id, {2}, 24 + 84}, {0x2B00, robot_id, {4}, 24 + 84},  {0x2B03, robot_id, {}, 24 + 250},
        {0x2B03, manager_id, {}, 24 + 83},  {0x2B01, manager_id, {2}, 24 + 9}, {0x2B02, manager_id, {}, 24 + 40},
        {0x2002, robot_id, {}, 24 + 5},     {0x2202, robot_id, {}, 24},        {0x9999, robot_id, {}, 24},
        {0x2002, {2, 1, 99, 1}, {}, 0},     {0x2002, {4, 1, 33, 1}, {}, 0},
    };
    for (const auto& q : questions) {
        const raw_message m{.code = q.code, .source = stranger, .destination = q.to, .body = q.body};
        b.stranger.send(b.port, m);
        const auto answered = drain();
        CAPTURE(q.code, q.to[2], answered);
        REQUIRE(answered <= q.most);
    }
    // To all of the node: an answer of each component, and no more.
    b.stranger.send(b.port, {.code = 0x2002, .source = stranger, .destination = {2, 1, 255, 255}});
    REQUIRE(drain() == 2 * (24 + 5));
    // Who takes control is asked for its pulse, at most three times before it has lost control.
    b.stranger.send(b.port, {.code = 0x000D, .source = stranger, .destination = robot_id, .body = {1}});
    std::size_t sent = 0;
    for (std::optional<raw_message> m; !m || m->code != 0x0010;) {
        const auto got = b.stranger.receive();
        m = read_datagram(got);
        REQUIRE(m);
        if (m->code != 0x4202) sent += got.size();
    }
    REQUIRE(sent <= 24 + 1 + 3 * 24 + 24);
    // A closed one sends nothing at all.
    besieged closed;
    for (const auto& q : questions)
        closed.stranger.send(closed.port, {.code = q.code, .source = stranger, .destination = q.to, .body = q.body});
    REQUIRE(closed.stranger.receive(200ms).empty());
    REQUIRE(closed.robot.node.counts().unknown_peer == questions.size());
}
