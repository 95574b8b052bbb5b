// What a node takes from the heap for each datagram: nothing.
#include "net/node_program.hpp"
#include "support/allocations.hpp"
#include "support/catch.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/asio/steady_timer.hpp>

namespace {

using namespace net_test;

/// A node, and a socket that its configuration knows as system 1.
struct asked_node {
    using endpoint = boost::asio::ip::udp::endpoint;

    boost::asio::io_context context{1};
    boost::asio::ip::udp::socket asking{context, {boost::asio::ip::address_v4::loopback(), 0}};
    jaus::address self{1, 33, 1, 2}, other{1, 32, 1, 1};
    std::uint16_t port = free_ports<1>()[0];
    jaus::component_memory<16, 256, 4096> memory{};
    // One source may send 100000 a second that ask for acknowledgement.
    jaus::component<> core{self, memory, {}, {.memory = 20ms}};
    std::size_t efforts{};
    jaus::message_outcome apply(const jaus::header& head, std::span<const std::byte> body) {
        if (head.command_code != jaus::command_code_of<jaus::set_wrench_effort>)
            return jaus::message_outcome::unhandled;
        return jaus::decode_for<jaus::set_wrench_effort>(body, [&](const auto&) { ++efforts; });
    }
    struct handler {
        asked_node& mine;
        auto operator()(const jaus::header& head, std::span<const std::byte> body) const {
            return mine.apply(head, body);
        }
    } application{*this};
    std::size_t log_lines{};
    net::jaus_node node{
        context,
        config("robot", system("other", "1.0.0.0", asking.local_endpoint().port(), "<limits rate='0'/>") +
                            system("robot", "2.0.0.0", port)),
        {.beat = {.to = {1, 1, 255, 255}, .period = 1ms}, // as many as it can
         .log = [this](std::string_view) { ++log_lines; }}};

    asked_node() {
        core.change(jaus::state_event::initialized);
        node.add(core, application);
        node.start();
        asking.non_blocking(true);
    }

    /// Runs the node until `wanted(header)` says that a message that came from it is the one.
    void run_until_heard(auto&& wanted) {
        const auto end = std::chrono::steady_clock::now() + 10s;
        for (;;) {
            if (std::chrono::steady_clock::now() > end) FAIL("no answer within 10 seconds");
            REQUIRE(context.run_one() == 1);
            endpoint from{};
            boost::system::error_code none;
            const auto got = asking.receive_from(boost::asio::buffer(in), from, 0, none);
            jaus::header head{};
            if (none || !wire::decode_prefix(head, std::span{in}.first(got))) continue;
            if (head.command_code == jaus::command_code_of<jaus::report_heartbeat_pulse>) ++beats;
            if (head.source == self && wanted(head)) return;
        }
    }
    void send(std::size_t size) {
        asking.send_to(boost::asio::buffer(out.data(), size), {boost::asio::ip::address_v4::loopback(), port});
    }
    /// Sends a message, and waits until the component has answered or acknowledged it.
    template <class T> void ask(const T& body, jaus::ack_nak wish) {
        const jaus::header head{.ack_nak = wish, .destination = self, .source = other, .sequence_number = ++number};
        const auto made = jaus::make_message(head, body, out);
        REQUIRE(made);
        send(made->size());
        run_until_heard([&](const jaus::header& answer) { return answer.sequence_number == number; });
        ++answers;
    }
    /// The component sends a message until it is acknowledged.
    void command() {
        REQUIRE(core.send({.destination = other}, jaus::resume{}, net::jaus_node::now(), node.out()));
        run_until_heard([&](const jaus::header& head) {
            if (head.command_code != jaus::command_code_of<jaus::resume>) return false;
            const auto message_bytes = jaus::make_acknowledgement(head, jaus::ack_nak::ack, out);
            REQUIRE(message_bytes);
            send(message_bytes->size());
            return true;
        });
        while (core.waiting() != 0) REQUIRE(context.run_one() == 1);
    }
    void all_of_it(unsigned times) {
        for (unsigned i = 0; i != times; ++i) {
            ask(jaus::query_component_status{}, jaus::ack_nak::none);
            ask(jaus::set_wrench_effort{.propulsive_linear_effort_x = 5}, jaus::ack_nak::request);
            command();
        }
    }

    /// What else a program does in the same thread.
    void tick() {
        timer.expires_after(1ms);
        timer.async_wait([this](boost::system::error_code error) {
            if (!error) tick();
        });
    }
    boost::asio::steady_timer timer{context};

    std::array<std::byte, 128> out{}, in{};
    std::uint16_t number{};
    std::size_t answers{}, beats{};
};

} // namespace

TEST_CASE("a node that answers 10000 datagrams, sends commands and heartbeats allocates nothing") {
    asked_node n;
    n.tick();
    n.all_of_it(500);
    const auto before = support::allocations();
    const auto answers = n.answers, beats = n.beats;
    n.all_of_it(5'000);
    REQUIRE(support::allocations() - before == 0);
    REQUIRE(n.answers - answers == 10'000);
    REQUIRE(n.beats > beats);
    REQUIRE(n.efforts == 5'500);
    REQUIRE(n.log_lines == 0);
}
