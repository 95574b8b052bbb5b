// Sending large data sets, repeated packet by packet over a bad network, in simulated time.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/net/node/detail/large_data_queue.hpp>
#include <jauscat/net/node/detail/node_components.hpp>

#include <functional>
#include <map>
#include <random>
#include <string>

namespace {

namespace jaus = jauscat::jaus;
using jauscat::net::detail::large_data_queue;
using namespace std::chrono_literals;
using support::instant;
using bytes = std::vector<std::byte>;
using nanoseconds = std::chrono::nanoseconds;

constexpr jaus::address camera{1, 40, 1, 1}, screen{1, 32, 1, 2};
constexpr jaus::header head{
    .ack_nak = jaus::ack_nak::request, .command_code = 0xD111, .destination = screen, .source = camera};

struct conditions {
    unsigned loss{};       ///< percent, each way
    nanoseconds longest{}; ///< that a datagram is on its way
    bool takes{true};      ///< what the receiver makes of a whole data set
    bool receiver_is_there{true};
};

/// A sender, a receiver that acknowledges each packet, and a network between them that loses and delays.
struct transfer {
    explicit transfer(const conditions& c) : network{c} {
        core.change(jaus::state_event::initialized);
        components.add({core, take});
        components.start(std::size_t{1} << 22U, nullptr);
    }

    conditions network;
    large_data_queue queue{std::size_t{1} << 20U, {}};
    std::vector<bytes> arrived{};
    std::vector<jaus::delivered> outcomes{};
    std::size_t packets{};
    std::function<void()> on_packet{}, on_done{};

    void run(instant until) {
        const jauscat::time_point end = until;
        while (now < end) {
            queue.on_time(
                now,
                [&](std::span<const std::byte> packet) {
                    ++packets;
                    if (on_packet) on_packet();
                    if (jaus::split(packet).header.destination == screen) put(packet, to_receiver);
                },
                [&](const jaus::header& of, jaus::delivered what) {
                    CHECK(of.command_code == head.command_code);
                    outcomes.push_back(what);
                    if (const auto f = on_done) f();
                });
            arrive(to_receiver, [&](const jaus::header& h, std::span<const std::byte> body) { receive(h, body); });
            arrive(to_sender,
                   [&](const jaus::header& h, std::span<const std::byte>) { queue.on_acknowledgement(h, now); });
            if (queue.size() == 0) break;
            now += 500us;
        }
    }

    jauscat::time_point now{};

  private:
    using wire = std::multimap<jauscat::time_point, bytes>;

    void put(std::span<const std::byte> packet, wire& on) {
        if (random() % 100 < network.loss) return;
        const auto takes_time =
            network.longest == 0ns ? 0ns : nanoseconds{random() % static_cast<unsigned>(network.longest.count())};
        on.emplace(now + takes_time, bytes(packet.begin(), packet.end()));
    }
    void arrive(wire& from, auto&& use) {
        while (!from.empty() && from.begin()->first <= now) {
            const bytes packet = from.extract(from.begin()).mapped();
            const auto m = jaus::split(packet);
            REQUIRE(m);
            use(m.header, m.body);
        }
    }
    void receive(const jaus::header& h, std::span<const std::byte> body) {
        if (network.receiver_is_there)
            components.hand_on(0, h, body, {.now = now},
                               [&](std::span<const std::byte> answer) { put(answer, to_sender); });
    }
    jaus::message_outcome keep(std::span<const std::byte> whole) {
        arrived.emplace_back(whole.begin(), whole.end());
        return network.takes ? jaus::message_outcome::handled : jaus::message_outcome::refused;
    }

    std::mt19937 random{5};
    wire to_receiver{}, to_sender{};
    jaus::component_memory<> memory{};
    jaus::component<> core{screen, memory, {}, {}};
    struct taker {
        transfer& mine;
        auto operator()(const jaus::header&, std::span<const std::byte> whole) const { return mine.keep(whole); }
    } take{*this};
    const jauscat::net::jaus_node_options options{};
    jauscat::net::limited_log log{{}};
    jauscat::net::detail::node_components components{options, log};
};

bytes image(std::size_t size, unsigned seed) {
    std::mt19937 random{seed};
    bytes made(size);
    for (auto& b : made) b = static_cast<std::byte>(random());
    return made;
}

} // namespace

TEST_CASE("large data sets arrive once each, in order, although datagrams are lost and reordered") {
    transfer t{conditions{.loss = 20, .longest = 3ms}};
    std::vector<bytes> sent;
    for (unsigned i = 0; i != 60; ++i) {
        // Some are equal to the one before, some differ in one packet only.
        bytes one = image(i % 3 == 0 ? 5'000 : 150'000, i % 5 < 2 ? 1 : i);
        if (i % 7 == 0) one[4500] ^= std::byte{1};
        REQUIRE(t.queue.push(head, one) == jaus::errc::ok);
        sent.push_back(std::move(one));
        t.run(t.now + 20s);
        REQUIRE(t.queue.size() == 0);
        CAPTURE(i, t.arrived.size(), t.outcomes.size());
        REQUIRE((t.arrived == sent)); // not printed: it is long
    }
    REQUIRE(t.outcomes == std::vector(60, jaus::delivered::acknowledged));
}

TEST_CASE("each packet of a large data set is sent once without faults") {
    transfer t{conditions{}};
    for (unsigned i = 0; i != 4; ++i) REQUIRE(t.queue.push(head, image(150'000, i)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.arrived.size() == 4);
    REQUIRE(t.packets == 4 * 37);
    REQUIRE(t.now < instant{4 * (37ms / 4 + 12ms + 40ms)}); // a short pause after each
}

TEST_CASE("a large data set without an answer is abandoned after its attempts, and the next one is sent") {
    transfer t{conditions{.receiver_is_there = false}};
    REQUIRE(t.queue.push(head, image(150'000, 1)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.outcomes == std::vector{jaus::delivered::timed_out});
    REQUIRE(t.packets == 21); // the first, and nothing behind it
    REQUIRE(t.now >= instant{21 * 50ms});
    t.network.receiver_is_there = true;
    REQUIRE(t.queue.push(head, image(150'000, 2)) == jaus::errc::ok);
    t.run(40s);
    REQUIRE(t.arrived.size() == 1);
    REQUIRE((t.arrived.front() == image(150'000, 2)));
    REQUIRE(t.outcomes.back() == jaus::delivered::acknowledged);
}

TEST_CASE(
    "after an abandoned large data set the next one begins when acknowledgements of the old one can no longer arrive") {
    transfer t{conditions{.receiver_is_there = false}};
    REQUIRE(t.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.outcomes == std::vector{jaus::delivered::timed_out});
    REQUIRE(t.queue.push(head, image(20'000, 2)) == jaus::errc::ok);
    REQUIRE(t.queue.next_event());
    REQUIRE(*t.queue.next_event() - t.now >= 990ms);
    REQUIRE(*t.queue.next_event() - t.now <= 1000ms);
}

TEST_CASE("a packet equal to that of the previous large data set is sent twice, and the next one waits no longer") {
    transfer t{conditions{}};
    bytes one = image(20'000, 1), other = image(20'000, 2);
    std::copy_n(one.begin() + jaus::max_body_size, jaus::max_body_size, other.begin() + jaus::max_body_size);
    for (const auto& body : {one, other, image(20'000, 3)}) REQUIRE(t.queue.push(head, body) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.arrived.size() == 3);
    REQUIRE((t.arrived[1] == other));
    REQUIRE(t.packets == 3 * 5 + 1);
    REQUIRE(t.now < instant{3 * (10ms + 40ms)});
}

TEST_CASE("a large data set equal to that of another sender does not wait, and each packet is sent once") {
    transfer t{conditions{.longest = 3ms}};
    auto other = head;
    other.source.component = 41;
    REQUIRE(t.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    REQUIRE(t.queue.push(other, image(20'000, 1)) == jaus::errc::ok);
    t.run(20s);
    CHECK(t.arrived.size() == 2);
    CHECK(t.packets == 2 * 5);
    CHECK(t.now < instant{100ms});
}

TEST_CASE("large data sets of one source and code do not overtake each other, also where one is in its pause") {
    transfer t{conditions{}};
    const bytes same = image(20'000, 1), other = image(20'000, 2);
    for (const auto& body : {same, same, other}) REQUIRE(t.queue.push(head, body) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.arrived.size() == 3);
    CHECK((t.arrived[1] == same));
    CHECK((t.arrived[2] == other));
}

TEST_CASE("a large data set overtakes none of its source and code to all nodes, also where that waits for another") {
    large_data_queue queue{std::size_t{1} << 20U, {}};
    auto plain = head;
    plain.ack_nak = jaus::ack_nak::none;
    auto to_all = plain, to_other = plain;
    to_all.destination.subsystem = to_all.destination.node = 255;
    to_other.destination.node = 7;
    for (const auto& each : {plain, to_all, to_other}) REQUIRE(queue.push(each, bytes(20'000)) == jaus::errc::ok);
    std::vector<jaus::address> begun;
    while (const auto next = queue.next_event())
        queue.on_time(*next,
                      [&](std::span<const std::byte> packet) {
                          const auto sent = jaus::split(packet).header;
                          if (sent.data_flag == jaus::data_flag::first) begun.push_back(sent.destination);
                      },
                      {});
    CHECK(begun == std::vector{plain.destination, to_all.destination, to_other.destination});
}

TEST_CASE("a large report that takes the place of one that waits needs no room beside it") {
    large_data_queue queue{10'000, {}};
    auto report = head;
    report.command_code = 0x4000;
    report.ack_nak = jaus::ack_nak::none;
    REQUIRE(queue.push(report, bytes(9000)) == jaus::errc::ok);
    CHECK(queue.push(report, bytes(9500)) == jaus::errc::ok);
    CHECK(queue.size() == 1);
    CHECK(queue.push(report, bytes(10'001)) == jaus::errc::no_space);
    CHECK(queue.size() == 1);
    report.destination.component = 99;
    CHECK(queue.push(report, bytes(501)) == jaus::errc::no_space);
    CHECK(queue.push(report, bytes(500)) == jaus::errc::ok);
}

TEST_CASE("a large data set waits for none to another node, and all share the pacing") {
    transfer t{conditions{}};
    auto elsewhere = head; // where nobody answers
    elsewhere.destination.subsystem = 3;
    for (std::uint8_t i = 1; i != 11; ++i) {
        elsewhere.destination.component = i;
        REQUIRE(t.queue.push(elsewhere, image(20'000, i)) == jaus::errc::ok);
    }
    for (std::uint8_t i = 0; i != 20; ++i) { // without acknowledgement
        auto plain = head;
        plain.ack_nak = jaus::ack_nak::none;
        plain.destination.subsystem = static_cast<std::uint8_t>(10 + i);
        REQUIRE(t.queue.push(plain, image(40'000, i)) == jaus::errc::ok);
    }
    REQUIRE(t.queue.push(head, image(20'000, 99)) == jaus::errc::ok);
    std::vector<jauscat::time_point> sent;
    t.on_packet = [&] { sent.push_back(t.now); };
    t.run(1s);
    CHECK(t.arrived.size() == 1);
    CHECK(t.outcomes == std::vector{jaus::delivered::acknowledged});
    CHECK(t.queue.size() == 10);
    for (std::size_t i = 4; i < sent.size(); ++i) REQUIRE(sent[i] - sent[i - 4] >= 1ms);
}

TEST_CASE("large data sets to several nodes are sent in turn, those to one node one after the other") {
    const auto order = [](std::uint8_t other_subsystem) {
        large_data_queue queue{std::size_t{1} << 20U, {}};
        auto plain = head;
        plain.ack_nak = jaus::ack_nak::none;
        REQUIRE(queue.push(plain, bytes(10 * jaus::max_body_size)) == jaus::errc::ok);
        plain.destination = {1, 33, 1, other_subsystem};
        REQUIRE(queue.push(plain, bytes(10 * jaus::max_body_size)) == jaus::errc::ok);
        std::string made;
        for (jauscat::time_point now{}; queue.size() != 0; now += 1ms)
            queue.on_time(now,
                          [&](std::span<const std::byte> packet) {
                              made += jaus::split(packet).header.destination == screen ? 'a' : 'b';
                          },
                          {});
        return made;
    };
    CHECK(order(screen.subsystem) == "aaaaaaaaaabbbbbbbbbb");
    CHECK(order(3) == "aaaabbbbaaaabbbbaabb");
}

TEST_CASE("a large report that waits is replaced by the next one, and a command is not") {
    for (const std::uint16_t code : std::initializer_list<std::uint16_t>{0x3FFF, 0x4000, 0x5FFF, 0x6000, 0xD111}) {
        CAPTURE(code);
        const bool is_report = code == 0x4000 || code == 0x5FFF;
        large_data_queue queue{std::size_t{1} << 20U, {}};
        auto plain = head;
        plain.command_code = code;
        plain.ack_nak = jaus::ack_nak::none;
        std::vector<std::byte> firsts;
        jauscat::time_point now{};
        for (unsigned i = 0; i != 10; ++i) {
            REQUIRE(queue.push(plain, bytes(9000, static_cast<std::byte>(i))) == jaus::errc::ok);
            queue.on_time(now,
                          [&](std::span<const std::byte> packet) {
                              const auto m = jaus::split(packet);
                              if (m.header.data_flag == jaus::data_flag::first) firsts.push_back(m.body[0]);
                          },
                          {});
        }
        CHECK(queue.size() == (is_report ? 1 : 9));
        if (is_report) {
            auto awaited = plain;
            awaited.ack_nak = jaus::ack_nak::request;
            large_data_queue waiting{std::size_t{1} << 20U, {}};
            REQUIRE(waiting.push(plain, bytes(9000)) == jaus::errc::ok);
            REQUIRE(waiting.push(awaited, bytes(9000)) == jaus::errc::ok);
            CHECK(waiting.size() == 2); // one without acknowledgement is replaced by its like only
        }
        now += 501ms;
        queue.on_time(now, [&](std::span<const std::byte> packet) { firsts.push_back(jaus::split(packet).body[0]); },
                      {});
        REQUIRE(firsts.size() >= 2);
        CHECK(firsts[1] == (is_report ? std::byte{9} : std::byte{1}));
    }
}

TEST_CASE("a large report that waits is not replaced by one to another component of its node") {
    large_data_queue queue{20'000, {}};
    auto plain = head;
    plain.command_code = 0x4807;
    plain.ack_nak = jaus::ack_nak::none;
    auto other = plain;
    other.destination.component = 33;
    // Those that were replaced take no bytes of the queue.
    for (unsigned i = 0; i != 10; ++i) REQUIRE(queue.push(plain, bytes(5'000)) == jaus::errc::ok);
    CHECK(queue.size() == 1);
    REQUIRE(queue.push(other, bytes(5'000)) == jaus::errc::ok);
    CHECK(queue.size() == 2);
}

TEST_CASE("a large data set after one that was refused waits for the pause") {
    transfer t{conditions{.takes = false}};
    REQUIRE(t.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.outcomes == std::vector{jaus::delivered::refused});
    REQUIRE(t.queue.push(head, image(20'000, 2)) == jaus::errc::ok);
    CHECK(*t.queue.next_event() - t.now >= 490ms);
    CHECK(*t.queue.next_event() - t.now <= 500ms);
}

TEST_CASE("a large data set waits while its receiver knows an equal one, also after another that was abandoned") {
    transfer t{conditions{}};
    REQUIRE(t.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    t.run(20s);
    t.network.receiver_is_there = false;
    REQUIRE(t.queue.push(head, image(20'000, 2)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.outcomes == std::vector{jaus::delivered::acknowledged, jaus::delivered::timed_out});
    REQUIRE(t.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    CHECK(*t.queue.next_event() - t.now >= 2490ms);
}

namespace {

/// A queue whose packets are acknowledged after a while, unless `is_lost(number)`, and their numbers.
struct answered_queue {
    large_data_queue queue{std::size_t{1} << 20U, {}};
    jauscat::time_point now{};
    jauscat::duration trip{}; ///< both ways
    std::vector<std::uint16_t> sent{};
    std::function<bool(std::uint16_t)> is_lost{};

    bool acknowledge(const jaus::header& packet) {
        return queue.on_acknowledgement({.ack_nak = jaus::ack_nak::ack,
                                         .command_code = packet.command_code,
                                         .destination = packet.source,
                                         .source = packet.destination,
                                         .sequence_number = packet.sequence_number},
                                        now);
    }
    /// Until all is sent, or `done()`.
    void run(const std::function<bool()>& done = [] { return false; }) {
        std::multimap<jauscat::time_point, jaus::header> answers;
        for (const auto end = now + 20s; queue.size() != 0 && now < end && !done(); now += 1ms) {
            queue.on_time(now,
                          [&](std::span<const std::byte> packet) {
                              const auto m = jaus::split(packet);
                              sent.push_back(m.header.sequence_number);
                              if (!is_lost || !is_lost(m.header.sequence_number)) answers.emplace(now + trip, m.header);
                          },
                          {});
            while (!answers.empty() && answers.begin()->first <= now)
                acknowledge(answers.extract(answers.begin()).mapped());
        }
    }
};

} // namespace

TEST_CASE("a packet is not sent twice because a large data set to another node has an equal one") {
    answered_queue q;
    q.trip = 3ms;
    auto other = head;
    other.destination.subsystem = 3;
    for (const auto& to : {head, other}) {
        REQUIRE(q.queue.push(to, image(20'000, 1)) == jaus::errc::ok);
        q.run();
    }
    CHECK(q.sent.size() == 2 * 5);
}

TEST_CASE("a large data set after one of which a packet was repeated once waits for the pause") {
    answered_queue q;
    unsigned copies = 0;
    q.is_lost = [&](std::uint16_t number) { return number == 1 && ++copies == 1; };
    REQUIRE(q.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    q.run();
    REQUIRE(q.sent.size() == 6);
    REQUIRE(q.queue.push(head, image(20'000, 2)) == jaus::errc::ok);
    CHECK(*q.queue.next_event() - q.now >= 490ms);
}

TEST_CASE("a large data set that begins again counts no acknowledgement from before") {
    answered_queue q;
    q.is_lost = [](std::uint16_t number) { return number == 1; };
    REQUIRE(q.queue.push(head, image(3 * jaus::max_body_size, 1)) == jaus::errc::ok);
    q.run([&] { return std::ranges::count(q.sent, 0) == 2; });
    REQUIRE(std::ranges::count(q.sent, 1) == 4);
    auto late = head;
    late.sequence_number = 1;
    REQUIRE(q.acknowledge(late)); // its packet is not the component's, but has to be sent again
    q.is_lost = {};
    q.sent.clear();
    const auto begin = q.now;
    q.run();
    CHECK(q.sent == std::vector<std::uint16_t>{1, 2});
    CHECK(q.now - begin < 10ms); // each in its turn, none for want of an answer
}

TEST_CASE("a handler of an outcome may clear the queue, and push") {
    transfer t{conditions{}};
    t.on_done = [&] {
        t.queue.clear();
        REQUIRE(t.queue.push(head, image(20'000, 9)) == jaus::errc::ok);
        t.on_done = nullptr;
    };
    for (unsigned i = 0; i != 3; ++i) REQUIRE(t.queue.push(head, image(20'000, i)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.arrived.size() == 2);
    CHECK((t.arrived[1] == image(20'000, 9)));
}

// Its program was suspended; the receiver knows a whole data set for two seconds.
TEST_CASE("a large data set is not repeated when its receiver may have forgotten that it received it") {
    large_data_queue queue{100'000, {}};
    const jauscat::time_point begin = instant{10s};
    std::vector<std::uint16_t> sent;
    std::vector<jaus::delivered> outcomes;
    const auto drive = [&](jauscat::time_point now) {
        queue.on_time(
            now, [&](std::span<const std::byte> packet) { sent.push_back(jaus::split(packet).header.sequence_number); },
            [&](const jaus::header&, jaus::delivered what) { outcomes.push_back(what); });
    };
    const auto acknowledge = [&](std::uint16_t number, jauscat::time_point now) {
        auto answer = jaus::answer_to(head);
        answer.command_code = head.command_code;
        answer.ack_nak = jaus::ack_nak::ack;
        answer.sequence_number = number;
        REQUIRE(queue.on_acknowledgement(answer, now));
    };
    REQUIRE(queue.push(head, image(5'000, 1)) == jaus::errc::ok);
    drive(begin);
    acknowledge(0, begin);
    // The last one gets no answer: after four attempts all is sent again.
    jauscat::time_point now = begin;
    while (sent != std::vector<std::uint16_t>{0, 1, 1, 1, 1, 0}) {
        drive(now += 1ms);
        REQUIRE(now < begin + 1s);
    }
    drive(now + 3s); // suspended
    REQUIRE(sent.size() == 6);
    REQUIRE(outcomes == std::vector{jaus::delivered::timed_out});
}

TEST_CASE("a large data set that is refused ends at the first NAK") {
    transfer refused{conditions{.takes = false}};
    REQUIRE(refused.queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    refused.run(20s);
    REQUIRE(refused.outcomes == std::vector{jaus::delivered::refused});
    REQUIRE(refused.now < instant{100ms});
}

TEST_CASE("a component that is alone in its program has all memory for large data sets") {
    transfer t{conditions{}};
    const std::size_t most = (std::size_t{1} << 22U) / jauscat::net::jaus_node_options{}.large_data_sets;
    REQUIRE(t.queue.push(head, image(most, 1)) == jaus::errc::ok);
    t.run(20s);
    CHECK(t.outcomes == std::vector{jaus::delivered::acknowledged});
    CHECK(t.arrived.size() == 1);
}

TEST_CASE("no packet of a large data set is sent after a NAK of one of them") {
    large_data_queue queue{std::size_t{1} << 20U, {}};
    std::vector<std::uint16_t> sent;
    std::vector<jaus::delivered> outcomes;
    jauscat::time_point now{};
    const auto pass = [&] {
        now += 1ms;
        queue.on_time(
            now, [&](std::span<const std::byte> packet) { sent.push_back(jaus::split(packet).header.sequence_number); },
            [&](const jaus::header&, jaus::delivered what) { outcomes.push_back(what); });
    };
    const auto answer = [&](std::uint16_t number, jaus::ack_nak how) {
        REQUIRE(queue.on_acknowledgement({.ack_nak = how,
                                          .command_code = head.command_code,
                                          .destination = head.source,
                                          .source = head.destination,
                                          .sequence_number = number},
                                         now));
    };
    REQUIRE(queue.push(head, image(20 * jaus::max_body_size, 1)) == jaus::errc::ok);
    pass();
    REQUIRE(sent == std::vector<std::uint16_t>{0});
    answer(0, jaus::ack_nak::ack);
    pass();
    REQUIRE(sent.size() == 5);
    pass();
    REQUIRE(sent.size() == 9); // waits for no acknowledgement but the first
    answer(1, jaus::ack_nak::nak);
    answer(2, jaus::ack_nak::ack); // has no effect, and is not the component's
    pass();
    CHECK(sent.size() == 9);
    CHECK(outcomes == std::vector{jaus::delivered::refused});
    CHECK(queue.size() == 0);
}

TEST_CASE("a data set without acknowledgement, or for a broadcast address, is sent once") {
    transfer t{conditions{.receiver_is_there = false}};
    auto other = head;
    other.ack_nak = jaus::ack_nak::none;
    REQUIRE(t.queue.push(other, image(20'000, 1)) == jaus::errc::ok);
    other = head;
    other.destination.subsystem = 255;
    REQUIRE(t.queue.push(other, image(20'000, 1)) == jaus::errc::ok);
    t.run(20s);
    REQUIRE(t.packets == 2 * 5);
    REQUIRE(t.outcomes.empty());
    REQUIRE(t.now < instant{100ms + 500ms}); // the second goes to the receiver of the first too
}

TEST_CASE("the first packet of a large data set has its flag in each repeat, and the next ones follow it") {
    large_data_queue queue{100'000, {}};
    std::vector<std::pair<jaus::data_flag, std::uint16_t>> sent;
    jauscat::time_point now{};
    const auto pass = [&](nanoseconds time) {
        for (const auto end = now + time; now < end; now += 1ms)
            queue.on_time(now,
                          [&](std::span<const std::byte> packet) {
                              const auto m = jaus::split(packet);
                              sent.emplace_back(m.header.data_flag, m.header.sequence_number);
                          },
                          {});
    };
    REQUIRE(queue.push(head, image(10'000, 1)) == jaus::errc::ok);
    pass(101ms);
    REQUIRE(queue.on_acknowledgement(
        {.ack_nak = jaus::ack_nak::ack, .command_code = 0xD111, .destination = camera, .source = screen}, now));
    pass(2ms);
    using enum jaus::data_flag;
    const std::vector<std::pair<jaus::data_flag, std::uint16_t>> expected{
        {first, 0}, {first, 0}, {first, 0}, {middle, 1}};
    CHECK((sent == expected));
}

TEST_CASE("a large data set without acknowledgement waits for the last one to its destination, whatever went between") {
    large_data_queue queue{100'000, {}};
    auto plain = head;
    plain.ack_nak = jaus::ack_nak::none;
    auto elsewhere = plain;
    elsewhere.destination.subsystem = 3;
    jauscat::time_point now{};
    const auto sent_after = [&](const jaus::header& to) {
        REQUIRE(queue.push(to, bytes(5'000)) == jaus::errc::ok);
        const auto begin = now;
        for (; queue.size() != 0; now += 1ms) queue.on_time(now, [](std::span<const std::byte>) {}, {});
        return now - begin;
    };
    CHECK(sent_after(plain) < 10ms);
    CHECK(sent_after(elsewhere) < 10ms);
    CHECK(sent_after(plain) > 480ms);
}

TEST_CASE(
    "a large data set of which only the first packet came is dropped after its timeout, also if that was copied") {
    jaus::component_memory<> memory{};
    jaus::component core{screen, memory, {}, {}};
    auto application = [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::handled; };
    const jauscat::net::jaus_node_options options{.large_data_timeout = 2s}; // not that of peers
    std::vector<std::string> lines;
    jauscat::net::limited_log log{[&](std::string_view line) { lines.emplace_back(line); }};
    jauscat::net::detail::node_components components{options, log};
    components.add({core, application});
    components.start(1U << 20U, nullptr);
    const auto ignore = [](std::span<const std::byte>) {};
    auto packet = head;
    packet.data_flag = jaus::data_flag::first;
    for (const auto at : {10s, 11s}) components.hand_on(0, packet, image(10, 1), {.now = instant{at}}, ignore);
    components.on_time(instant{12s}, ignore);
    CHECK(lines.empty());
    REQUIRE(components.next_event() == instant{13s});
    components.on_time(instant{13s}, ignore);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].find("is dropped after 1 packets") != std::string::npos);
}

TEST_CASE("the components beside a node manager have equal parts of the memory for large data sets") {
    std::array<jaus::liveness_table::place, 4> places{};
    const jaus::liveness_table present{places};
    jaus::component_memory<> first{}, second{}, third{};
    jaus::component manager{{1, 1, 1, 2}, first, {}, {}}, one{{1, 32, 1, 2}, second, {}, {}},
        other{{1, 33, 1, 2}, third, {}, {}};
    for (auto* const each : {&manager, &one, &other}) each->change(jaus::state_event::initialized);
    unsigned taken = 0;
    auto application = [&](const jaus::header&, std::span<const std::byte>) {
        ++taken;
        return jaus::message_outcome::handled;
    };
    const jauscat::net::jaus_node_options options{.large_data_sets = 1};
    jauscat::net::limited_log log{{}};
    jauscat::net::detail::node_components components{options, log};
    components.add({manager, application});
    components.add({one, application});
    components.add({other, application});
    components.start(20'000, &present); // 5,000 are the node manager's
    const auto takes = [&](std::uint16_t place, std::size_t size) {
        const auto before = taken;
        auto packet = head;
        packet.ack_nak = jaus::ack_nak::none;
        packet.command_code = static_cast<std::uint16_t>(0xD111 + size % 2);
        for (const auto flag : {jaus::data_flag::first, jaus::data_flag::last}) {
            packet.data_flag = flag;
            packet.sequence_number = flag == jaus::data_flag::last;
            const std::size_t part = flag == jaus::data_flag::first ? 4'000 : size - 4'000;
            components.hand_on(place, packet, bytes(part), {.now = instant{1s}}, [](std::span<const std::byte>) {});
        }
        return taken != before;
    };
    CHECK(takes(0, 5'000));
    CHECK_FALSE(takes(0, 5'001));
    for (const std::uint16_t place : {std::uint16_t{1}, std::uint16_t{2}}) {
        CHECK(takes(place, 7'500));
        CHECK_FALSE(takes(place, 7'501));
    }
}

TEST_CASE("acknowledgements for other senders are not consumed by the queue") {
    large_data_queue queue{100'000, {}};
    const auto answer = [](jaus::header to) {
        to = jaus::answer_to(to);
        to.command_code = head.command_code;
        to.ack_nak = jaus::ack_nak::ack;
        return to;
    };
    REQUIRE_FALSE(queue.on_acknowledgement(answer(head), instant{0ns}));
    REQUIRE(queue.push(head, image(20'000, 1)) == jaus::errc::ok);
    auto other = head;
    other.destination.component = 99;
    REQUIRE_FALSE(queue.on_acknowledgement(answer(other), instant{0ns}));
    other = head;
    other.sequence_number = 5; // of 0 to 4
    REQUIRE_FALSE(queue.on_acknowledgement(answer(other), instant{0ns}));
    REQUIRE_FALSE(queue.on_acknowledgement(answer(head), instant{0ns})); // nothing is sent yet
    queue.on_time(instant{1s}, [](std::span<const std::byte>) {}, {});
    REQUIRE(queue.on_acknowledgement(answer(head), instant{1s}));
    REQUIRE(queue.push(head, image(100'000, 1)) == jaus::errc::no_space);
}

TEST_CASE("a large data set that the component refused is refused again if the NAK was lost") {
    jaus::component_memory<> memory{};
    jaus::component core{screen, memory, {}, {}};
    core.change(jaus::state_event::initialized);
    unsigned count = 0;
    auto application = [&](const jaus::header&, std::span<const std::byte>) {
        return ++count % 2 == 1 ? jaus::message_outcome::refused : jaus::message_outcome::handled;
    };
    const jauscat::net::jaus_node_options options{};
    jauscat::net::limited_log log{{}};
    jauscat::net::detail::node_components components{options, log};
    components.add({core, application});
    components.start(1U << 20U, nullptr);
    jauscat::time_point now{};
    const auto answer_to = [&](jaus::data_flag flag, std::uint16_t number, std::byte content) {
        auto packet = head;
        packet.data_flag = flag;
        packet.sequence_number = number;
        jaus::ack_nak what{};
        components.hand_on(0, packet, std::span{&content, 1}, {.now = now += 10ms},
                           [&](std::span<const std::byte> message) {
                               const auto m = jaus::split(message);
                               REQUIRE(m);
                               REQUIRE(m.header.sequence_number == number);
                               what = m.header.ack_nak;
                           });
        return what;
    };
    using enum jaus::data_flag;
    REQUIRE(answer_to(first, 0, std::byte{1}) == jaus::ack_nak::ack);
    REQUIRE(answer_to(last, 1, std::byte{2}) == jaus::ack_nak::nak);
    REQUIRE(answer_to(last, 1, std::byte{2}) == jaus::ack_nak::nak);
    // The next one is taken.
    REQUIRE(answer_to(first, 0, std::byte{3}) == jaus::ack_nak::ack);
    REQUIRE(answer_to(last, 1, std::byte{2}) == jaus::ack_nak{}); // it may be a late copy
    REQUIRE(answer_to(last, 1, std::byte{2}) == jaus::ack_nak::ack);
    REQUIRE(answer_to(last, 1, std::byte{2}) == jaus::ack_nak::ack);
    REQUIRE(count == 2);
    // An acknowledgement that came too late for the queue, with the data flag of what it acknowledges.
    auto late = head;
    late.ack_nak = jaus::ack_nak::ack;
    late.data_flag = first;
    components.hand_on(0, late, {}, {.now = now}, [](std::span<const std::byte>) { FAIL("answered"); });
    REQUIRE(core.count(jaus::component_outcome::unmatched_acknowledgement) == 1);
}

TEST_CASE(
    "a packet of a large data set is acknowledged once packet 0 has come, and a deferred one with its last packet") {
    jaus::component_memory<> memory{};
    jaus::component core{screen, memory, {}, {}};
    core.change(jaus::state_event::initialized);
    auto application = [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::deferred; };
    const jauscat::net::jaus_node_options options{};
    jauscat::net::limited_log log{{}};
    jauscat::net::detail::node_components components{options, log};
    components.add({core, application});
    components.start(1U << 20U, nullptr);
    const auto answer_to = [&](jaus::data_flag flag, std::uint16_t number) {
        auto packet = head;
        packet.data_flag = flag;
        packet.sequence_number = number;
        jaus::ack_nak what{};
        components.hand_on(0, packet, std::array{std::byte{1}}, {.now = instant{1s}},
                           [&](std::span<const std::byte> message) { what = jaus::split(message).header.ack_nak; });
        return what;
    };
    CHECK(answer_to(jaus::data_flag::middle, 1) == jaus::ack_nak::none);
    CHECK(answer_to(jaus::data_flag::first, 0) == jaus::ack_nak::ack);
    CHECK(answer_to(jaus::data_flag::middle, 1) == jaus::ack_nak::ack);
    CHECK(answer_to(jaus::data_flag::last, 2) == jaus::ack_nak::ack);
}

TEST_CASE("one node does not take all places of the large data sets that a receiver remembers") {
    jaus::component_memory<> memory{};
    jaus::component core{screen, memory, {}, {}};
    core.change(jaus::state_event::initialized);
    unsigned taken = 0;
    auto application = [&](const jaus::header&, std::span<const std::byte>) {
        ++taken;
        return jaus::message_outcome::handled;
    };
    const jauscat::net::jaus_node_options options{};
    jauscat::net::limited_log log{{}};
    jauscat::net::detail::node_components components{options, log};
    components.add({core, application});
    components.start(1U << 20U, nullptr);
    const auto is_taken = [&](const jaus::address& source, std::uint16_t code, jaus::ack_nak wish) {
        const auto before = taken;
        unsigned answers = 0;
        for (const auto flag : {jaus::data_flag::first, jaus::data_flag::last}) {
            const jaus::header packet{.ack_nak = wish,
                                      .command_code = code,
                                      .destination = screen,
                                      .source = source,
                                      .data_flag = flag,
                                      .sequence_number = flag == jaus::data_flag::last};
            components.hand_on(0, packet, std::array<std::byte, 1>{}, {.now = instant{1s}},
                               [&](std::span<const std::byte>) { ++answers; });
        }
        CHECK(answers == (wish == jaus::ack_nak::none ? 0 : 1 + taken - before));
        return taken != before;
    };
    std::uint16_t code = 0xD111;
    while (code != 0xE000 && is_taken(camera, code, jaus::ack_nak::request)) ++code;
    CHECK(code == 0xD111 + 256 * 3 / 4);
    CHECK(is_taken(camera, 0xD110, jaus::ack_nak::none)); // is not remembered
    CHECK(is_taken({1, 40, 1, 3}, code, jaus::ack_nak::request));
}

TEST_CASE("an unlimited timeout never expires and requests no timer") {
    jaus::component_memory<> memory{};
    jaus::component core{screen, memory, {}, {}};
    auto application = [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::handled; };
    const jauscat::net::jaus_node_options options{.large_data_timeout = nanoseconds::max()};
    std::size_t lines = 0;
    jauscat::net::limited_log log{[&](std::string_view) { ++lines; }};
    jauscat::net::detail::node_components components{options, log};
    components.add({core, application});
    components.start(1U << 20U, nullptr);
    const auto ignore = [](std::span<const std::byte>) {};
    auto packet = head;
    packet.data_flag = jaus::data_flag::first;
    components.hand_on(0, packet, image(10, 1), {.now = instant{1s}}, ignore);
    REQUIRE(components.next_event() == std::nullopt);
    components.on_time(instant{1000h}, ignore);
    REQUIRE(components.next_event() == std::nullopt);
    REQUIRE(lines == 0);
}
