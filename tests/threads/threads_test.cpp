// Several threads, each with objects of its own: nothing is shared behind their backs. Run under the thread sanitizer
// (`scripts/test tsan`), which sees what these checks cannot.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/random_message.hpp"
#include "support/until.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/net/link/udp_transport.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/translate/translator.hpp>

#include <thread>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using udp = boost::asio::ip::udp;

namespace {

/// A message through codec, translator, dispatcher and text; the text of all of them.
std::string work(std::uint64_t seed) {
    support::generator random{seed};
    std::string said;
    jaus::dispatcher handlers{jaus::on<jaus::set_wrench_effort>([&](const jaus::header& head, const auto& command) {
        said += text::summary(head) + std::to_string(wire::encoded_size(command));
    })};
    for (int i = 0; i != 200; ++i) {
        const auto command = support::random_message<jaus::set_wrench_effort>(random);
        std::array<std::byte, 64> message{}, again{};
        std::array<std::byte, 128> packet{};
        const jaus::header head{.destination = {1, 33, 2, 2}, .source = {1, 32, 1, 1}};
        const auto made = jaus::make_message(head, command, message);
        using translator = translate::translator<translation::seed_table>;
        const auto there = translator::to_packet(*made, packet);
        const auto back = translator::from_packet(*there, again);
        const auto m = jaus::split(*back);
        if (m && handlers(m.header, m.body) == jaus::dispatched::handled)
            said += text::annotate_message(*back, jaus::message_list<jaus::set_wrench_effort>{});
    }
    return said;
}

} // namespace

TEST_CASE("codec, translator, dispatcher and text work on several threads concurrently") {
    std::array<std::string, 4> said;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i != said.size(); ++i) threads.emplace_back([&said, i] { said[i] = work(i % 2); });
    }
    CHECK(said[0].size() > 200 * 100);
    CHECK(said[0] == said[2]);
    CHECK(said[1] == said[3]);
    CHECK(said[0] == work(0));
}

TEST_CASE("a slave on one thread serves a master on another") {
    auto slave_link = net::udp_link::serve(0, "127.0.0.1");
    auto master_link = net::udp_link::connect("127.0.0.1", slave_link.port());
    const std::jthread serving{[&slave_link](const std::stop_token& stop) {
        test::objects objects;
        objects.add(0x6000, 1, 28);
        ethercat::slave device{{.vendor = 1, .product = 2}, ethercat::object_dictionary{objects}};
        std::array<std::byte, ethercat::max_frame_size> frame{};
        while (!stop.stop_requested()) {
            const auto size = slave_link.receive(frame, 10ms);
            if (size == 0) continue;
            device.process(std::span{frame}.first(size));
            static_cast<void>(slave_link.send(std::span{frame}.first(size))); // the master repeats what is lost
        }
    }};

    // Patient: a sanitizer makes all of it slow.
    ethercat::master_for<16> master{
        {.frame_timeout = 1s, .sii_timeout = 10s, .state_timeout = 10s, .mailbox_timeout = 10s}};
    REQUIRE(net::run(master_link, master, ethercat::bring_up{0, 2}, 60s));
    for (unsigned i = 0; i != 20; ++i) {
        std::array<std::byte, 28> data{}, back{};
        data.fill(static_cast<std::byte>(i + 1));
        REQUIRE(net::run(master_link, master, ethercat::download{2, 0x6000, 1, data}, 60s));
        REQUIRE(net::run(master_link, master, ethercat::upload{2, 0x6000, 1, back}, 60s));
        CHECK(back == data);
    }
}

TEST_CASE("stations on threads of their own exchange messages") {
    boost::asio::io_context here, there;
    const udp::endpoint any_port{boost::asio::ip::make_address("127.0.0.1"), 0};
    net::udp_transport asking{here, any_port}, echoing{there, any_port};
    const auto echo = echoing.local();
    const auto nothing = [](std::string_view) {};
    std::uint64_t failed = 0;
    echoing.start(
        [&](auto message, const udp::endpoint& from, auto framing) { failed += !echoing.send(message, from, framing); },
        nothing);
    std::jthread thread{[&there] { there.run(); }};

    std::vector<std::byte> heard;
    asking.start([&](auto message, const auto&, auto) { heard.assign(message.begin(), message.end()); }, nothing);
    for (unsigned i = 0; i != 100; ++i) {
        const std::vector<std::byte> message(16 + i, static_cast<std::byte>(i));
        REQUIRE(asking.send(message, echo));
        REQUIRE(support::until(here, [&] { return heard == message; }));
    }
    there.stop();
    thread.join();
    CHECK(echoing.counts().received == 100);
    CHECK(failed == 0);
}
