// Two drives in OP: their process data once a millisecond.
//     two_drives eth0
#include <jauscat/app.hpp>
#include <jauscat/version.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/signal_set.hpp>

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <string_view>

namespace asio = boost::asio;

// [run]
asio::awaitable<void> run(jauscat::bus& bus) {
    using namespace std::chrono_literals;
    co_await bus.async_start();
    const auto left = bus.slave({.position = 0}), right = bus.slave({.position = 1});
    bus.every_cycle([left, right] { // the right one repeats what the left one reports
        if (!left.is_operating() || !right.is_operating()) return;
        const auto from = left.inputs();
        const auto to = right.outputs();
        std::copy_n(from.begin(), std::min(from.size(), to.size()), to.begin());
    });
    co_await left.async_operate({.period = 1ms});
    co_await right.async_operate({.period = 1ms});
}
// [run end]

int main(int argc, char** argv) try {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "two_drives (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc != 2) return std::cerr << "two_drives INTERFACE, such as eth0 or udp:127.0.0.1\n", 2;
    asio::io_context context;
    jauscat::bus bus{context, argv[1], {.thread = true}};
    asio::signal_set stop{context, SIGINT, SIGTERM};
    stop.async_wait([&](auto, int) { context.stop(); }); // the end of the bus brings the drives to rest
    asio::co_spawn(context, run(bus), [](const std::exception_ptr& problem) {
        if (problem) std::rethrow_exception(problem);
    });
    context.run();
} catch (const std::exception& e) {
    return std::cerr << "two_drives: " << e.what() << '\n', 1;
}
