// An EtherCAT bus: lists the objects of its first slave.
//     objects udp:127.0.0.1
#include <jauscat/app.hpp>
#include <jauscat/version.hpp>

#include <boost/asio/co_spawn.hpp>

#include <exception>
#include <iostream>
#include <string_view>

namespace asio = boost::asio;

// [bus]
asio::awaitable<void> list_objects(jauscat::bus& bus) {
    co_await bus.async_start(); // finds the slaves and brings them to PRE-OP
    const auto slave = bus.slave({.position = 0});
    std::cout << slave.info().name << '\n';
    for (const auto index : co_await slave.async_list_objects()) {
        const auto object = co_await slave.async_describe(index);
        std::cout << "  " << std::hex << index << "h " << object.name << '\n';
    }
    const auto vendor = co_await slave.async_read<std::uint32_t>(0x1018, 1);
    std::cout << "vendor " << std::hex << vendor << "h\n";
}
// [bus end]

int main(int argc, char** argv) try {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "objects (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc != 2 || argv[1][0] == '-') return std::cerr << "objects INTERFACE, such as eth0 or udp:127.0.0.1\n", 2;
    asio::io_context context;
    jauscat::bus bus{context, argv[1]};
    asio::co_spawn(context, list_objects(bus), [&](const std::exception_ptr& problem) {
        bus.stop();
        if (problem) std::rethrow_exception(problem);
    });
    context.run();
    if (!std::cout.flush()) return std::cerr << "objects: standard output cannot be written\n", 1;
} catch (const std::exception& e) {
    return std::cerr << "objects: " << e.what() << '\n', 1;
}
