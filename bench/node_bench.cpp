// Messages received, dispatched and answered each second over the loopback interface, next to a bare echo by recvfrom
// and sendto, in turns: what a node costs beside its sockets, and what the way through another node costs. Prints
// Markdown. scripts/measure node runs it.
#include "measuring.hpp"
#include "node/client.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/net/node/jaus_node.hpp>
#include <jauscat/schema/jaus/platform.hpp>

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

net::system_entry entry(std::string name, const jaus::address& jausip, std::uint16_t port) {
    net::system_entry made{
        .name = std::move(name), .jausip = jausip, .ip = boost::asio::ip::make_address("127.0.0.1"), .port = port};
    made.limits.messages.per_second = 0; // none
    return made;
}
/// The system "here" and its neighbours.
net::jaus_config config_of(std::vector<net::system_entry> systems) {
    return {.this_system = "here", .systems = std::move(systems), .source = "node_bench"};
}
std::uint16_t free_port() {
    const int socket = open_socket();
    const auto port = port_of(socket);
    ::close(socket);
    return port;
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
        gate_.emplace(config_of({entry("here", {.subsystem = 2}, 1), entry("client", {.subsystem = 1}, client_port)}));
        udp_.set_filter([this](auto message, const auto& from, auto framing) {
            return (*gate_)(message, from, net::now(), framing);
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
                       ->size();
        })};
        if (handlers(m.header, m.body) == jaus::dispatched::handled)
            udp_.post(std::span{out}.first(size), from, framing);
    }

    std::optional<net::datagram_gate> gate_{};
    boost::asio::io_context context_{1};
    net::udp_transport udp_{context_, {boost::asio::ip::address_v4::loopback(), 0}};
};

/// A whole node with a component of its own, 33, that is asked for its status: transport, gate, router, node manager,
/// the component's state machines and its dispatcher.
class component_node {
  public:
    component_node(boost::asio::io_context& context, const net::jaus_config& config, const jaus::address& self)
        : core_{self, memory_, {}, {}},
          node_{context, config, {.log = [](std::string_view line) {
                    std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
                }}} {
        core_.change(jaus::state_event::initialized);
        node_.add(core_, own_);
        node_.start();
    }

  private:
    static constexpr auto ignore = [](const jaus::header&, const auto&) {};
    jaus::component_memory<> memory_{};
    jaus::component<> core_;
    decltype(jaus::dispatcher{jaus::on<jaus::set_wrench_effort>(ignore)}) own_{
        jaus::on<jaus::set_wrench_effort>(ignore)};
    net::jaus_node node_;
};

/// Node 1 of subsystem 2, by which the client gets to node 2. They share a thread, so that the difference of one and
/// two is a node's work, not the scheduler's.
class two_nodes {
  public:
    explicit two_nodes(std::uint16_t client_port) : client_port_{client_port} {}

    std::uint16_t port() const { return ports_[0]; }
    void run(const std::atomic<bool>&) {
        context_.restart();
        context_.run();
    }
    void stop() { context_.stop(); }

  private:
    std::uint16_t client_port_;
    std::array<std::uint16_t, 2> ports_{free_port(), free_port()};
    boost::asio::io_context context_{1};
    component_node first_{context_,
                          config_of({entry("client", {.subsystem = 1}, client_port_),
                                     entry("here", {.node = 1, .subsystem = 2}, ports_[0]),
                                     entry("behind", {.node = 2, .subsystem = 2}, ports_[1])}),
                          {1, 33, 1, 2}};
    component_node second_{
        context_,
        config_of({entry("others", {.subsystem = 1}, ports_[0]), entry("first", {.node = 1, .subsystem = 2}, ports_[0]),
                   entry("here", {.node = 2, .subsystem = 2}, ports_[1])}),
        {1, 33, 2, 2}};
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
            measuring::pin(1);
            const auto before = measuring::cpu_time();
            server.run(stop);
            cpu = measuring::cpu_time() - before;
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

void print(const char* name, std::size_t window, const measured& m, const measured& echo) {
    std::printf("| %s | %zu | %.0f | %.0f %% | %.2f | %.0f %% | %.1f | %.1f | %llu |\n", name, window,
                m.load.per_second(), 100 * m.load.per_second() / echo.load.per_second(), measuring::us(m.cpu),
                100 * measuring::us(m.cpu) / measuring::us(echo.cpu), measuring::us(m.load.latency.quantile(0.5)),
                measuring::us(m.load.latency.quantile(0.99)), static_cast<unsigned long long>(m.load.lost));
}

void run(unsigned rounds, nanoseconds time) {
    std::printf(
        "| server | outstanding | messages/s | of the echo | processor us each | of the echo | p50 us | p99 us | "
        "lost |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
    client asking;
    bare_echo echo;
    component bare, guarded;
    guarded.guard(asking.port());
    two_nodes nodes{asking.port()};
    const jaus::address first{1, 33, 1, 2}, second{1, 33, 2, 2};
    measuring::pin(0);
    for (const std::size_t window : {1u, 8u, 64u}) {
        struct row {
            const char* name;
            std::vector<measured> runs{};
        };
        std::array<row, 5> rows{{{"recvfrom, sendto"},
                                 {"transport and dispatcher"},
                                 {"the same behind a gate"},
                                 {"jaus_node"},
                                 {"jaus_node through another"}}};
        for (unsigned i = 0; i != rounds; ++i) { // in turns, so that what else the machine does hits all
            asking.to = first;
            rows[0].runs.push_back(measure(echo, asking, window, time));
            rows[1].runs.push_back(measure(bare, asking, window, time));
            rows[2].runs.push_back(measure(guarded, asking, window, time));
            rows[3].runs.push_back(measure(nodes, asking, window, time));
            asking.to = second;
            rows[4].runs.push_back(measure(nodes, asking, window, time));
        }
        const auto bare_run = median(rows[0].runs);
        for (auto& [name, runs] : rows) print(name, window, median(runs), bare_run);
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
