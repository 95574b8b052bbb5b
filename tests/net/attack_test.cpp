// Attacks and their effects: spoofed sources, replays, floods, and storms of malformed datagrams, without sockets and
// through them.
#include "net/defended_node.hpp"
#include "support/allocations.hpp"
#include "support/instant.hpp"
#include "support/random_message.hpp"
#include "support/until.hpp"
#include <jauscat/net/link/udp_transport.hpp>

#include <map>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using support::instant;
using namespace net_test;
using net::verdict;
using byte_vector = std::vector<std::byte>;

namespace {

template <class T> byte_vector message(const jaus::address& source, const T& body, jaus::header head = {}) {
    byte_vector out(4096);
    head.source = source;
    head.destination = robot_arm;
    out.resize(jaus::make_message(head, body, out)->size());
    return out;
}

const jaus::set_wrench_effort forward{.propulsive_linear_effort_x = 50};
const jaus::query_component_status status_query{};

/// A node and the number of its answers.
struct target {
    defended_node node{guarded_config};
    std::uint64_t answers{};
    verdict receive(std::span<const std::byte> datagram, const net::access_list::endpoint& from, instant now) {
        return node.receive(datagram, from, now, [this](auto) { ++answers; });
    }
};

/// Random datagrams of four kinds: anything at all; a well-formed message of the OCU from elsewhere; and from the OCU,
/// random messages under headers that are right, and right messages with a byte changed.
class storm {
  public:
    explicit storm(std::uint64_t seed) : random_{seed}, effort_{message(ocu, forward)} {}

    std::span<const std::byte> next() {
        kind_ = support::below(random_, 4);
        if (kind_ != 3) {
            datagram_ = std::span{memory_}.first(support::below(random_, 200));
            support::fill(random_, datagram_);
        } else {
            datagram_ = std::span{memory_}.first(effort_.size());
            std::ranges::copy(effort_, datagram_.begin());
            datagram_[support::below(random_, datagram_.size())] ^=
                static_cast<std::byte>(1U << support::below(random_, 8));
        }
        if ((kind_ == 1 || kind_ == 2) && datagram_.size() >= jaus::header_size) write_header();
        return datagram_;
    }
    net::access_list::endpoint from() {
        if (kind_ == 0) return {boost::asio::ip::make_address_v4(static_cast<std::uint32_t>(random_())), 3794};
        return kind_ == 1 ? stranger : peer;
    }

  private:
    void write_header() {
        static constexpr std::array flags{jaus::data_flag::only,   jaus::data_flag::only,     jaus::data_flag::first,
                                          jaus::data_flag::middle, jaus::data_flag::repeated, jaus::data_flag::last};
        jaus::header head{.ack_nak = static_cast<jaus::ack_nak>(support::below(random_, 4)),
                          .command_code = code(),
                          .destination = robot_arm,
                          .source = ocu,
                          .data_size = static_cast<std::uint16_t>(datagram_.size() - jaus::header_size),
                          .data_flag = flags[support::below(random_, flags.size())],
                          .sequence_number = static_cast<std::uint16_t>(support::below(random_, 20))};
        static_cast<void>(wire::encode(head, datagram_)); // fits
    }
    std::uint16_t code() {
        static constexpr std::array<std::uint16_t, 4> classes{0x0000, 0x2000, 0x4000, 0x0400};
        return static_cast<std::uint16_t>(classes[support::below(random_, classes.size())] +
                                          support::below(random_, 20));
    }

    support::generator random_;
    net::access_list::endpoint peer{at("10.0.0.1")}, stranger{at("10.0.0.66")};
    byte_vector effort_;
    std::array<std::byte, 256> memory_{};
    std::span<std::byte> datagram_{};
    std::size_t kind_{};
};

} // namespace

TEST_CASE("any spoofed source is refused without an answer") {
    target robot;
    for (const auto& source : {ocu, camera, robot_arm, jaus::address{1, 32, 1, 77}})
        for (const auto& from : {at("10.0.0.66"), at("10.0.0.1", 40000), at("::1")}) {
            CHECK(robot.receive(message(source, forward), from, 1s) != verdict::accepted);
            CHECK(robot.receive(message(source, status_query), from, 1s) != verdict::accepted);
        }
    CHECK(robot.receive(message(camera, forward), at("10.0.0.1"), 1s) == verdict::wrong_sender); // a peer as another
    CHECK(robot.receive(message({1, 32, 1, 77}, forward), at("10.0.0.1"), 1s) == verdict::unknown_peer);
    CHECK(robot.node.well_formed == 0);
    CHECK(robot.answers == 0);

    CHECK(robot.receive(message(ocu, forward), at("10.0.0.1"), 1s) == verdict::accepted);
    CHECK(robot.receive(message(ocu, status_query), at("10.0.0.1"), 1s) == verdict::accepted);
    CHECK(robot.node.commands == 1);
    CHECK(robot.answers == 1);
}

TEST_CASE("a replayed command is refused from another address, and executed once while it is remembered") {
    target robot;
    const auto recorded = message(ocu, forward, {.ack_nak = jaus::ack_nak::request, .sequence_number = 7});
    CHECK(robot.receive(recorded, at("10.0.0.1"), 1s) == verdict::accepted);
    for (int i = 0; i != 50; ++i) {
        CHECK(robot.receive(recorded, at("10.0.0.66"), 1s) == verdict::wrong_sender);
        CHECK(robot.receive(recorded, at("10.0.0.1"), 1s + i * 10ms) == verdict::accepted);
    }
    CHECK(robot.node.commands == 1);
    // A sender that can use the peer's address is not excluded: docs/security.md.
    CHECK(robot.receive(recorded, at("10.0.0.1"), 1min) == verdict::accepted);
    CHECK(robot.node.commands == 2);
}

TEST_CASE("a flooding peer is limited to its rate, without effect on other peers") {
    target robot;
    std::uint64_t taken = 0, of_camera = 0;
    const auto flood = message(ocu, forward), other = message(camera, forward);
    for (int i = 0; i != 200'000; ++i) { // 100 a millisecond, for two seconds
        const auto now = 1s + i * 10us;
        taken += robot.receive(flood, at("10.0.0.1"), now) == verdict::accepted ? 1 : 0;
        if (i % 200 == 0) of_camera += robot.receive(other, at("10.0.0.3"), now) == verdict::accepted ? 1 : 0;
    }
    CHECK(taken >= 2099);
    CHECK(taken <= 2101);
    CHECK(of_camera == 1000);
}

TEST_CASE("strangers cannot use up a peer's rate") {
    target robot;
    for (int i = 0; i != 10'000; ++i)
        CHECK(robot.receive(message(ocu, forward), at("10.0.0.66"), 1s) == verdict::wrong_sender);
    CHECK(robot.receive(message(ocu, forward), at("10.0.0.1"), 1s) == verdict::accepted);
}

TEST_CASE("one million random datagrams allocate nothing, and the node continues to work") {
    auto robot = std::make_unique<target>();
    storm datagrams{20260711};
    std::map<verdict, std::uint64_t> verdicts;
    for (const auto v :
         {verdict::accepted, verdict::malformed, verdict::unknown_peer, verdict::wrong_sender, verdict::rate_limited})
        verdicts[v] = 0;
    std::uint64_t answers_to_refused = 0;
    jauscat::time_point now{1s};
    const auto before = support::allocations();
    for (int i = 0; i != 1'000'000; ++i) {
        now += 1ms; // within the rate, so that they come through
        const auto datagram = datagrams.next();
        const auto answered = robot->answers;
        const auto what = robot->receive(datagram, datagrams.from(), now);
        ++verdicts[what];
        if (what != verdict::accepted) answers_to_refused += robot->answers - answered;
        if (i % 100 == 0) robot->node.on_time(now, [&](auto) { ++robot->answers; });
    }
    CHECK(support::allocations() - before == 0);
    CHECK(answers_to_refused == 0);
    CHECK(verdicts[verdict::malformed] > 50'000);
    CHECK(verdicts[verdict::unknown_peer] > 100'000);
    CHECK(verdicts[verdict::wrong_sender] > 100'000);
    CHECK(verdicts[verdict::accepted] > 300'000);
    CHECK(robot->node.well_formed > 300'000);

    // It still does its work; a storm that asked for Shutdown got that.
    const auto answered = robot->answers;
    CHECK(robot->receive(message(ocu, status_query), at("10.0.0.1"), now + 1h) == verdict::accepted);
    CHECK(robot->answers == answered + 1);
}

TEST_CASE("every datagram of a flood through a socket is counted, and the next message is answered") {
    boost::asio::io_context context;
    using udp = boost::asio::ip::udp;
    const udp::endpoint loopback{boost::asio::ip::make_address("127.0.0.1"), 0};
    net::udp_transport transport{context, loopback, {.receive_buffer = 4'000'000}};
    udp::socket console{context, loopback}, stranger{context, loopback};
    const auto config = parse(
        "<thissystem>robot</thissystem><system name='robot' jausip='2.0.0.0' ip='127.0.0.1' port='" +
        std::to_string(transport.local().port()) + "'/><system name='ocu' jausip='1.0.0.0' ip='127.0.0.1' port='" +
        std::to_string(console.local_endpoint().port()) + "'><limits rate='0'/></system>");
    net::datagram_gate gate{config};
    defended_node node{config};
    const auto clock = [] { return net::now(); };
    transport.set_filter(
        [&](auto bytes, const auto& from, auto framing) { return gate(bytes, from, clock(), framing); });
    transport.start(
        [&](auto bytes, const auto& from, auto framing) {
            node.take(bytes, clock(), [&](auto answer) { transport.post(answer, from, framing); });
        },
        [](std::string_view text) { FAIL(std::string{text}); });

    const auto& counts = transport.counts();
    const auto seen = [&] {
        return counts.received + counts.malformed + counts.unknown_peer + counts.wrong_sender + counts.rate_limited +
               counts.dropped + counts.oversize;
    };
    storm datagrams{3};
    support::generator random{4};
    const auto query = message(ocu, status_query);
    std::uint64_t sent = 0;
    while (sent != 40'000) {
        auto& from = support::chance(random, 0.5) ? console : stranger;
        const auto next = datagrams.next();
        from.send_to(boost::asio::const_buffer{next.data(), next.size()}, transport.local());
        stranger.send_to(boost::asio::buffer(query), transport.local()); // an answer would go to whoever is spoofed
        if ((sent += 2) % 100 == 0) REQUIRE(support::until(context, [&] { return seen() == sent; }));
    }
    CHECK(counts.received > 5'000);
    CHECK(counts.wrong_sender > 20'000);
    CHECK(counts.malformed > 1'000);
    CHECK(counts.errors == 0);
    CHECK(stranger.available() == 0);

    byte_vector buffer(65536);
    while (console.available() != 0) console.receive(boost::asio::buffer(buffer));
    console.send_to(boost::asio::buffer(query), transport.local());
    REQUIRE(support::until(context, [&] { return console.available() != 0; }));
    buffer.resize(console.receive(boost::asio::buffer(buffer)));
    const auto answer = jaus::split(buffer);
    REQUIRE(answer);
    CHECK(answer.header.command_code == jaus::command_code_of<jaus::report_component_status>);
}
