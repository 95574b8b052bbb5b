// Large data sets between nodes in simulated time, over networks that lose, double and delay, with restarts: what is
// acknowledged has arrived, once, and what arrives was sent.
#include "net/simulated_program.hpp"

#include <deque>
#include <list>
#include <map>

using namespace net_test;

namespace {

constexpr std::uint16_t image_code = 0xD111;

/// A body that says which one it is. Many begin alike and differ late only.
bytes body_of(std::uint32_t number, std::size_t size) {
    bytes made(size, std::byte{0x55});
    std::memcpy(made.data() + size - sizeof number, &number, sizeof number);
    if (number % 3 == 0) return made;
    std::mt19937 random{number};
    for (std::size_t at = number % 2 == 0 ? 0 : size / 2; at + sizeof number < size; ++at)
        made[at] = static_cast<std::byte>(random());
    return made;
}
std::uint32_t number_of(const bytes& body) {
    std::uint32_t number{};
    std::memcpy(&number, body.data() + body.size() - sizeof number, sizeof number);
    return number;
}
jaus::header to(const jaus::address& destination, const jaus::address& source,
                jaus::ack_nak wish = jaus::ack_nak::request) {
    return {.ack_nak = wish, .command_code = image_code, .destination = destination, .source = source};
}

/// A receiver, system 1, and any number of senders behind it.
struct senders_and_receiver {
    explicit senders_and_receiver(unsigned count, unsigned seed = 1, const net::jaus_node_options& options = {})
        : network{seed} {
        std::string systems;
        for (unsigned i = 1; i <= count + 1; ++i)
            systems += system("s" + std::to_string(i), std::to_string(i) + ".0.0.0", 1000 + i);
        for (unsigned i = 1; i <= count + 1; ++i)
            all.emplace_back(network, config("s" + std::to_string(i), systems), make(i, 1, 32), options);
        receiver = &all.front();
        network.run(network.now + 1s);
    }
    void send(simulated_program& from, const bytes& body, jaus::ack_nak wish = jaus::ack_nak::request) {
        REQUIRE(from.node.send(to(receiver->self, from.self, wish), std::span<const std::byte>{body}, network.now));
    }
    void run_for(std::chrono::nanoseconds time) { network.run(network.now + time); }
    void restart(simulated_program& which, std::chrono::nanoseconds away) {
        which.node.stop();
        run_for(away);
        which.node.start(network.now);
    }

    simulated_network network;
    std::list<simulated_program> all{};
    simulated_program* receiver{};
};

} // namespace

TEST_CASE("large data sets of many senders at once are acknowledged on arrival, and not before") {
    senders_and_receiver s{7}; // with places for four
    for (auto& one : s.all)
        if (&one != s.receiver) s.send(one, body_of(one.self.subsystem, 8000));
    s.run_for(10s);
    for (const auto& one : s.all)
        if (&one != s.receiver) CHECK(one.large_done == std::vector{jaus::delivered::acknowledged});
    REQUIRE(s.receiver->large.size() == 7);
    for (const auto& body : s.receiver->large) REQUIRE((body == body_of(number_of(body), 8000)));
}

TEST_CASE("several large data sets that are sent at once arrive in order") {
    senders_and_receiver s{1};
    s.network.faults = {.lose = 10};
    for (std::uint32_t i = 0; i != 7; ++i) s.send(s.all.back(), body_of(i, 8000 + 3000 * i));
    s.run_for(30s);
    REQUIRE(s.all.back().large_done == std::vector(7, jaus::delivered::acknowledged));
    REQUIRE(s.receiver->large.size() == 7);
    for (std::uint32_t i = 0; i != 7; ++i) REQUIRE((s.receiver->large[i] == body_of(i, 8000 + 3000 * i)));
}

TEST_CASE("a large data set arrives completely although the receiver restarts during it") {
    for (const std::size_t size : {8'000U, 30'000U, 200'000U}) {
        senders_and_receiver s{1};
        s.send(s.all.back(), body_of(7, size));
        s.run_for(size == 8'000 ? 50us : 5ms);
        s.restart(*s.receiver, 100ms);
        s.run_for(10s);
        REQUIRE(s.all.back().large_done == std::vector{jaus::delivered::acknowledged});
        REQUIRE(s.receiver->large.size() == 1);
        REQUIRE((s.receiver->large.front() == body_of(7, size)));
    }
}

TEST_CASE("the end of one large data set and the start of the next are not combined") {
    for (const auto wish : {jaus::ack_nak::request, jaus::ack_nak::none}) {
        senders_and_receiver s{1, 1, {.large_data_pace = 1}};
        const bytes one(200'000, std::byte{0x11}), two(160'000, std::byte{0x22});
        s.send(s.all.back(), one, wish);
        s.run_for(30ms);
        s.restart(*s.receiver, 10ms); // it gets the tail of the first one
        s.send(s.all.back(), two, wish);
        s.run_for(20s);
        for (const auto& body : s.receiver->large) REQUIRE((body == one || body == two));
        REQUIRE((s.receiver->large.back() == two));
        if (wish == jaus::ack_nak::request) REQUIRE(s.receiver->large.size() == 2);
    }
}

TEST_CASE("the next large data set of a restarted sender does not complete its previous one") {
    for (const auto wish : {jaus::ack_nak::request, jaus::ack_nak::none}) {
        senders_and_receiver s{1};
        auto& sender = s.all.back();
        bytes one(24'000, std::byte{0x11}), two = one;
        two[21'000] = std::byte{0x22}; // the last packet alone differs
        s.send(sender, one, wish);
        s.run_for(150us);
        s.network.faults = {.lose = 100};
        s.run_for(2ms);
        s.network.faults = {};
        sender.node.stop();
        sender.node.start(s.network.now);
        s.send(sender, two, wish);
        s.run_for(10s);
        REQUIRE(s.receiver->large.size() == 1);
        REQUIRE((s.receiver->large.front() == two));
    }
}

TEST_CASE("an equal large data set arrives again") {
    senders_and_receiver s{1};
    s.network.faults = {.lose = 10};
    for (int i = 0; i != 4; ++i) s.send(s.all.back(), body_of(5, 20'000));
    s.run_for(60s);
    REQUIRE(s.all.back().large_done == std::vector(4, jaus::delivered::acknowledged));
    REQUIRE((s.receiver->large == std::vector(4, body_of(5, 20'000))));
}

TEST_CASE("an equal large data set arrives again after one whose last acknowledgements were lost") {
    senders_and_receiver s{1};
    auto& sender = s.all.back();
    s.send(sender, body_of(5, 8'000));
    REQUIRE(s.network.run(s.network.now + 1s, [&] { return !s.receiver->large.empty(); }));
    s.network.deaf = sender.at;
    REQUIRE(s.network.run(s.network.now + 10s, [&] { return !sender.large_done.empty(); }));
    REQUIRE(sender.large_done == std::vector{jaus::delivered::timed_out});
    s.network.deaf.reset();
    s.send(sender, body_of(5, 8'000));
    s.run_for(60s);
    CHECK(sender.large_done.back() == jaus::delivered::acknowledged);
    CHECK(s.receiver->large.size() == 2);
}

TEST_CASE("a large command that its component does not take is refused") {
    senders_and_receiver s{2};
    auto& other = *std::next(s.all.begin());
    SECTION("because another one has control") {
        REQUIRE(other.node.send({.destination = s.receiver->self, .source = other.self},
                                jaus::request_component_control{.authority_code = 100}, s.network.now));
        s.run_for(100ms);
        REQUIRE(s.receiver->core.control().controls(other.self));
    }
    SECTION("because it is not ready") {
        REQUIRE(
            other.node.send({.destination = s.receiver->self, .source = other.self}, jaus::standby{}, s.network.now));
        s.run_for(100ms);
        REQUIRE(s.receiver->core.state() == jaus::primary_status_code::standby);
    }
    SECTION("because no part and no application handles it") { s.receiver->outcome = jaus::message_outcome::unhandled; }
    s.send(s.all.back(), body_of(5, 8'000));
    s.run_for(10s);
    CHECK(s.all.back().large_done == std::vector{jaus::delivered::refused});
}

TEST_CASE("a large data set that the memory of its receiver does not hold is refused") {
    senders_and_receiver s{1};
    s.send(s.all.back(), body_of(5, 2'000'000));
    s.run_for(10s);
    CHECK(s.all.back().large_done == std::vector{jaus::delivered::refused});
    CHECK(s.receiver->large.empty());
}

TEST_CASE("a large data set that no component handles is ended") {
    senders_and_receiver s{1};
    s.network.detach(s.receiver->at);
    s.send(s.all.back(), body_of(5, 20'000));
    const auto begin = s.network.now;
    REQUIRE(s.network.run(begin + 10s, [&] { return !s.all.back().large_done.empty(); }));
    REQUIRE(s.all.back().large_done.front() == jaus::delivered::timed_out);
    REQUIRE(s.network.now - begin < 2s);
}

TEST_CASE("the log says why a large data set is given up, and nothing about one that is acknowledged") {
    senders_and_receiver s{1};
    auto& sender = s.all.back();
    s.send(sender, body_of(5, 20'000));
    s.run_for(10s);
    REQUIRE(sender.large_done == std::vector{jaus::delivered::acknowledged});
    CHECK(sender.log.empty());

    s.send(sender, body_of(5, 2'000'000)); // more than the receiver's memory holds
    s.run_for(10s);
    CHECK(sender.logged(": a large data set is given up: refused by the receiver (NAK)"));

    s.network.detach(s.receiver->at);
    s.send(sender, body_of(5, 20'000));
    s.run_for(10s);
    CHECK(sender.logged(": a large data set is given up: no acknowledgement in time"));
}

TEST_CASE("over bad networks with restarts, acknowledged data arrive once, and arriving data were sent") {
    struct conditions {
        simulated_network::faults_type faults{};
        unsigned restarts{}; ///< in 1000 sends, of either end
    };
    // A copy that the network itself makes is held back for less than the shortest pause.
    for (const auto& [faults, restarts] : {conditions{{.lose = 10, .delay = 10, .longest = 300ms}, 0},
                                           conditions{{.lose = 20, .delay = 30, .longest = 3ms}, 100},
                                           conditions{{.lose = 10, .duplicate = 20, .delay = 50, .longest = 15ms}, 50},
                                           conditions{{.lose = 40, .delay = 20, .longest = 100ms}, 20}}) {
        senders_and_receiver s{3, 7};
        s.network.faults = faults;
        std::mt19937 random{11};
        struct sent_body {
            std::size_t size{};
            bool is_acknowledged{};
            unsigned arrived{};
        };
        std::map<std::uint32_t, sent_body> sent;
        std::map<const simulated_program*, std::deque<std::uint32_t>> waiting; // for their outcomes
        std::size_t seen = 0, acknowledged = 0;
        const auto check = [&] {
            for (; seen != s.receiver->large.size(); ++seen) {
                const auto& body = s.receiver->large[seen];
                const auto number = number_of(body);
                REQUIRE(sent.contains(number));
                auto& original = sent[number];
                REQUIRE((body == body_of(number, original.size)));
                ++original.arrived;
                if (original.is_acknowledged) REQUIRE(original.arrived == 1);
            }
            for (auto& one : s.all) {
                auto& queue = waiting[&one];
                for (const auto what : one.large_done) {
                    REQUIRE_FALSE(queue.empty());
                    if (what == jaus::delivered::acknowledged) {
                        REQUIRE(sent[queue.front()].arrived == 1);
                        ++acknowledged;
                    }
                    queue.pop_front();
                }
                one.large_done.clear();
            }
            return false;
        };
        for (std::uint32_t i = 1; i != 600; ++i) {
            auto& from = *std::next(s.all.begin(), 1 + static_cast<int>(random() % 3));
            const bool asks = random() % 4 != 0;
            // More than one packet, seldom many.
            const std::size_t size = 4081 + random() % (random() % 8 == 0 ? 150'000 : 12'000);
            sent[i] = {size, asks};
            if (asks) waiting[&from].push_back(i);
            s.send(from, body_of(i, size), asks ? jaus::ack_nak::request : jaus::ack_nak::none);
            s.network.run(s.network.now + std::chrono::milliseconds{random() % 700}, check);
            if (random() % 1000 >= restarts) continue;
            auto& which = *std::next(s.all.begin(), static_cast<int>(random() % 4));
            check();
            which.node.stop();
            waiting[&which].clear();
            which.node.start(s.network.now);
        }
        s.network.run(s.network.now + 300s, check);
        for (auto& one : s.all) CHECK(waiting[&one].empty());
        CHECK(acknowledged > 200);
        CHECK(s.receiver->large.size() > 300);
    }
}
