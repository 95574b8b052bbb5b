// A live view of a program's own.
// [includes]
#include <jauscat/app/node_options.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/net/live/live_server.hpp>
// [includes end]

#include <cstdint>
#include <iostream>

int main() {
    constexpr std::uint16_t port = 0; // any that is free
    // [serve]
    jauscat::net::live_feed feed;
    jauscat::net::live_server server{{.port = port, .program = "robot", .messages = &jauscat::catalogue::ra_3_3()}};
    server.add(feed);
    server.start(); // server.link() is the page's address

    jauscat::node_options options;
    options.on_received = [&](const auto&, const auto& head, auto body) {
        feed.message(jauscat::net::live_way::received, head, body);
    };
    options.on_sent = [&](auto message) { feed.message(jauscat::net::live_way::sent, message); };
    // [serve end]
    options.on_received({}, {}, {}); // costs nothing: nobody watches
    std::cout << (server.link().starts_with("http://127.0.0.1:") ? "on this machine" : server.link()) << ", "
              << server.counts().viewers << " viewers\n";
}
