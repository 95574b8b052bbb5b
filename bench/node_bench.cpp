// Messages received, dispatched and answered each second over the loopback interface, next to a bare echo by recvfrom
// and sendto, in turns: what a node costs beside its sockets. Prints Markdown.
#include "node/client.hpp"
#include "wire/report.hpp"
#include <jauscat/jaus/dispatcher.hpp>
#include <jauscat/net/datagram_gate.hpp>
#include <jauscat/net/udp_transport.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <thread>

namespace {

using namespace node_bench;
using namespace std::chrono_literals;
namespace jaus = jauscat::jaus;
namespace net = jauscat::net;

/// What a program does that knows nothing of JAUS: each datagram goes back as it came.
class bare_echo {
  public:
    std::uint16_t port() const { return port_of(socket_); }
    void run(const std::atomic<bool>& stop) {
        std::array<std::byte, 4096> buffer;
        while (!stop) {
            sockaddr_in from{};
            socklen_t size = sizeof from;
            auto* const address = reinterpret_cast<sockaddr*>(&from);
            const auto got = ::recvfrom(socket_, buffer.data(), buffer.size(), 0, address, &size);
            if (got > 0) ::sendto(socket_, buffer.data(), static_cast<std::size_t>(got), 0, address, size);
        }
    }
    void stop() {} // its receives end after a while

  private:
    int socket_{open_socket()};
};

/// The client as the only peer, without a limit.
net::jaus_config config_for(std::uint16_t client_port) {
    const auto loopback = boost::asio::ip::make_address("127.0.0.1");
    net::system_entry client{.name = "client", .jausip = {.subsystem = 1}, .ip = loopback, .port = client_port};
    client.limits.messages.per_second = 0;
    return {.this_system = "here",
            .systems = {{.name = "here", .jausip = {.subsystem = 2}, .ip = loopback, .port = 1}, client}};
}

/// A component that is asked for its status: transport, dispatcher, typed answer.
class component {
  public:
    component() {
        udp_.start([this](auto message, const auto& from, auto framing) { answer(message, from, framing); },
                   [](std::string_view) {});
    }
    /// Takes messages from the client alone.
    void guard(std::uint16_t client_port) {
        gate_.emplace(config_for(client_port));
        udp_.set_filter([this](auto message, const auto& from) {
            return (*gate_)(message, from, clock::now().time_since_epoch());
        });
    }
    std::uint16_t port() const { return udp_.local().port(); }
    void run(const std::atomic<bool>&) {
        context_.restart();
        context_.run();
    }
    void stop() { context_.stop(); }

  private:
    void answer(std::span<const std::byte> message, const net::udp_transport::endpoint& from, jaus::framing framing) {
        const auto m = jaus::split(message);
        if (!m) return;
        std::array<std::byte, 64> out;
        std::size_t size = 0;
        jaus::dispatcher handlers{jaus::on<jaus::query_component_status>([&](const jaus::header& head, const auto&) {
            size = jaus::make_message(
                       jaus::answer_to(head),
                       jaus::report_component_status{.primary_status_code = jaus::primary_status_code::ready}, out)
                       .size();
        })};
        if (handlers(m.header, m.body) == jaus::dispatched::handled)
            udp_.post(std::span{out}.first(size), from, framing);
    }

    std::optional<net::datagram_gate> gate_{};
    boost::asio::io_context context_{1};
    net::udp_transport udp_{context_, {boost::asio::ip::address_v4::loopback(), 0}};
};

struct measured {
    load_result load{};
    nanoseconds cpu{}; ///< of the answering thread, each message
};

template <class Server> measured measure(Server& server, client& asking, std::size_t window, nanoseconds time) {
    measured result;
    nanoseconds cpu{};
    std::atomic<bool> stop{false};
    {
        std::jthread answering{[&] {
            wire_bench::pin(1);
            const auto before = wire_bench::cpu_time();
            server.run(stop);
            cpu = wire_bench::cpu_time() - before;
        }};
        result.load = asking.run(server.port(), window, time);
        stop = true;
        server.stop();
    }
    result.cpu = cpu / static_cast<std::int64_t>(std::max<std::uint64_t>(result.load.answered, 1));
    return result;
}

/// The run with the median throughput.
measured median(std::vector<measured>& runs) {
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::ranges::nth_element(runs, middle, {}, [](const measured& m) { return m.load.per_second(); });
    return *middle;
}

void print(const char* name, std::size_t window, const measured& m, double share) {
    std::printf("| %s | %zu | %.0f | %.0f %% | %.2f | %.1f | %.1f | %llu |\n", name, window, m.load.per_second(),
                100 * share, wire_bench::us(m.cpu), wire_bench::us(m.load.latency.quantile(0.5)),
                wire_bench::us(m.load.latency.quantile(0.99)), static_cast<unsigned long long>(m.load.lost));
}

void run(unsigned rounds, nanoseconds time) {
    std::printf(
        "| who answers | on their way | messages/s | of the echo | processor us each | p50 us | p99 us | lost |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    client asking;
    bare_echo echo;
    component node, guarded;
    guarded.guard(asking.port());
    wire_bench::pin(0);
    for (const std::size_t window : {1u, 8u, 64u}) {
        std::vector<measured> echoes, nodes, guardeds;
        for (unsigned i = 0; i != rounds; ++i) { // in turns, so that what else the machine does hits both
            echoes.push_back(measure(echo, asking, window, time));
            nodes.push_back(measure(node, asking, window, time));
            guardeds.push_back(measure(guarded, asking, window, time));
        }
        const auto bare = median(echoes);
        print("recvfrom, sendto", window, bare, 1);
        for (auto& [name, runs] : {std::pair{"component", &nodes}, std::pair{"component behind a gate", &guardeds}}) {
            const auto m = median(*runs);
            print(name, window, m, m.load.per_second() / bare.load.per_second());
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 3 || (argc > 1 && std::atoi(argv[1]) < 1)) {
        std::fprintf(stderr, "node_bench [ROUNDS [MILLISECONDS]]: 5 rounds of 500 ms each unless given\n");
        return 2;
    }
    try {
        run(argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 5,
            std::chrono::milliseconds{argc > 2 ? std::max(std::atoi(argv[2]), 1) : 500});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "node_bench: %s\n", error.what());
        return 1;
    }
}
