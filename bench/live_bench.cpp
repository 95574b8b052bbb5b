// A JAUS node on the loopback interface with and without a viewer of its live view, in turns: messages answered each
// second, and the processor time of the node's thread for each. Prints Markdown. scripts/measure node runs it.
#include "measuring.hpp"
#include "node/client.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/net/live/live_server.hpp>
#include <jauscat/net/node/jaus_node.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace node_bench;
using namespace std::chrono_literals;
namespace net = jauscat::net;

std::uint16_t free_port() {
    const int socket = open_socket();
    const auto port = port_of(socket);
    ::close(socket);
    return port;
}

/// A node with a component, 2.1.33.1, that is asked for its status. All messages go to the live view, too.
class shown_node {
  public:
    explicit shown_node(std::uint16_t client_port) : client_port_{client_port} {
        core_.change(jaus::state_event::initialized);
        node_.add(core_, nothing_);
        node_.start();
        server_.add(feed_);
        server_.start();
    }
    std::uint16_t port() const { return port_; }
    net::live_server& server() { return server_; }
    void run() {
        context_.restart();
        context_.run();
    }
    void stop() { context_.stop(); }

  private:
    net::jaus_config config() const {
        const auto system = [](std::string name, std::uint8_t subsystem, std::uint16_t port) {
            net::system_entry made{.name = std::move(name),
                                   .jausip = {.subsystem = subsystem},
                                   .ip = boost::asio::ip::make_address("127.0.0.1"),
                                   .port = port};
            made.limits.messages.per_second = 0; // none
            return made;
        };
        return {.this_system = "here",
                .systems = {system("client", 1, client_port_), system("here", 2, port_)},
                .source = "live_bench"};
    }
    net::jaus_node_options options() {
        return {.log = [](std::string_view) {},
                .on_received =
                    [this](const jaus::address&, const jaus::header& head, std::span<const std::byte> body) {
                        feed_.message(net::live_way::received, head, body);
                    },
                .on_sent = [this](std::span<const std::byte> message) { feed_.message(net::live_way::sent, message); }};
    }
    struct no_messages {
        jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) const {
            return jaus::message_outcome::unhandled;
        }
    };

    std::uint16_t client_port_, port_{free_port()};
    net::live_feed feed_{};
    net::live_server server_{{.program = "live_bench", .messages = &jauscat::catalogue::ra_3_3()}};
    boost::asio::io_context context_{1};
    jaus::component_memory<> memory_{};
    jaus::component<> core_{{1, 33, 1, 2}, memory_, {}, {}};
    no_messages nothing_{};
    net::jaus_node node_{context_, config(), options()};
};

/// Reads what a live view sends, until its end.
class viewer {
  public:
    explicit viewer(net::live_server& of) : server_{of}, socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
        const auto address = loopback(of.port());
        const auto request = "GET /live HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(of.port()) +
                             "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
            ::send(socket_, request.data(), request.size(), 0) != static_cast<ssize_t>(request.size()))
            throw std::runtime_error{"no live view"};
        thread_ = std::thread{[this] {
            std::array<char, 65536> buffer;
            while (::recv(socket_, buffer.data(), buffer.size(), 0) > 0) {}
        }};
        while (server_.counts().updates == before_) std::this_thread::sleep_for(1ms);
    }
    ~viewer() {
        ::shutdown(socket_, SHUT_RDWR);
        thread_.join();
        ::close(socket_);
        while (server_.counts().viewers != 0) std::this_thread::sleep_for(1ms);
        std::this_thread::sleep_for(50ms); // the feed is not watched any more
    }
    viewer(const viewer&) = delete;
    viewer& operator=(const viewer&) = delete;

  private:
    net::live_server& server_;
    std::uint64_t before_{server_.counts().updates};
    int socket_;
    std::thread thread_{};
};

struct measured {
    load_result load{};
    nanoseconds cpu{}; ///< of the node's thread, each message
};

measured measure(shown_node& node, auto&& ask) {
    measured result;
    nanoseconds cpu{};
    {
        std::jthread answering{[&] {
            measuring::pin(1);
            const auto before = measuring::cpu_time();
            node.run();
            cpu = measuring::cpu_time() - before;
        }};
        result.load = ask();
        node.stop();
    }
    result.cpu = cpu / static_cast<std::int64_t>(std::max<std::uint64_t>(result.load.answered, 1));
    return result;
}

struct series {
    std::vector<double> rates{}, costs{};
    std::uint64_t lost{};

    void add(const measured& one) {
        rates.push_back(one.load.per_second());
        costs.push_back(measuring::us(one.cpu));
        lost += one.load.lost;
    }
};
double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}
/// Of pairs that were measured one after the other.
double median_ratio(const std::vector<double>& with, const std::vector<double>& without) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i != with.size(); ++i) ratios.push_back(with[i] / without[i]);
    return median(ratios);
}

void run(unsigned rounds, nanoseconds time) {
    client asking;
    shown_node node{asking.port()};
    measuring::pin(0);
    std::printf("| load | viewer | messages/s | with a viewer | processor us each | with a viewer | lost |\n"
                "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n");
    const auto compare = [&](const char* name, auto&& ask) {
        series without, with;
        for (unsigned i = 0; i != rounds; ++i) { // in turns, so that what else the machine does hits both
            without.add(measure(node, ask));
            const viewer one{node.server()};
            with.add(measure(node, ask));
        }
        std::printf("| %s | no | %.0f | | %.2f | | %llu |\n", name, median(without.rates), median(without.costs),
                    static_cast<unsigned long long>(without.lost));
        std::printf("| %s | yes | %.0f | %.1f %% | %.2f | %.1f %% | %llu |\n", name, median(with.rates),
                    100 * median_ratio(with.rates, without.rates), median(with.costs),
                    100 * median_ratio(with.costs, without.costs), static_cast<unsigned long long>(with.lost));
    };
    compare("10,000 queries a second", [&] { return asking.run_paced(node.port(), 10, time); });
    compare("8 queries outstanding", [&] { return asking.run(node.port(), 8, time); });
    std::printf("\nNot shown: %llu messages, %llu updates.\n",
                static_cast<unsigned long long>(node.server().counts().lost),
                static_cast<unsigned long long>(node.server().counts().skipped));
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 3 || (argc > 1 && std::atoi(argv[1]) < 1)) {
        std::fprintf(stderr, "live_bench [ROUNDS [MILLISECONDS]]: 5 rounds of 500 ms each unless given\n");
        return 2;
    }
    try {
        run(argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 5,
            std::chrono::milliseconds{argc > 2 ? std::max(std::atoi(argv[2]), 1) : 500});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "live_bench: %s\n", error.what());
        return 1;
    }
}
