// Two drives as axes in radians: one moves to and fro, the other follows it at half its angle.
//     two_axes eth0
#include <jauscat/app.hpp>
#include <jauscat/version.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/signal_set.hpp>

#include <exception>
#include <iostream>
#include <string_view>

boost::asio::awaitable<void> run(jauscat::bus& bus) {
    using enum jauscat::cia402::mode;
    const jauscat::drive_options radians{.increments = 10'000, .max_velocity = 2, .acceleration = 10};
    jauscat::drive first{bus.slave({.position = 0}), radians}, second{bus.slave({.position = 1}), radians};
    co_await bus.async_start();
    for (auto* const each : {&first, &second}) co_await each->async_operate();
    for (auto* const each : {&first, &second}) co_await each->async_enable(cyclic_synchronous_position);
    bus.every_cycle([first, second] { second.move_to(first.feedback().position / 2); });
    for (double angle = 1;; angle = -angle) {
        co_await first.async_move_to(angle);
        std::cout << first.feedback().position << ", " << second.feedback().position << std::endl;
    }
}
int main(int argc, char** argv) try {
    if (argc != 2) return std::cerr << "two_axes INTERFACE, such as eth0 or udp:127.0.0.1\n", 2;
    if (argv[1] == std::string_view{"--version"})
        return std::cout << "two_axes (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    boost::asio::io_context context;
    jauscat::bus bus{context, argv[1], {.thread = true}};
    boost::asio::signal_set stop{context, SIGINT, SIGTERM};
    stop.async_wait([&](auto, int) { context.stop(); }); // the end of the bus brings the axes to rest
    boost::asio::co_spawn(context, run(bus), [](const std::exception_ptr& problem) {
        if (problem) std::rethrow_exception(problem);
    });
    context.run();
} catch (const std::exception& e) {
    return std::cerr << "two_axes: " << e.what() << '\n', 1;
}
