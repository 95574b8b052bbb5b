// From a JAUS datagram to the actuator: an operator's program sends Set Wrench Effort now and then, a controller takes
// it to the slave by the mailbox or by the process image.
#pragma once

#include "slave_end.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/net/link/cycle_runner.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/link/udp_transport.hpp>
#include <jauscat/net/node/run_until.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <random>

namespace wire_bench {

namespace jaus = jauscat::jaus;

/// Sends a command to `port` at a random moment, waits until the actuator has it, `count` times.
class operator_unit {
  public:
    operator_unit(std::uint16_t port, slave_end& slave, unsigned count, jauscat::net::latency_histogram& times)
        : thread_{[this, port, &slave, count, &times] { work(port, slave, count, times); }} {}
    ~operator_unit() { thread_.join(); }
    operator_unit(const operator_unit&) = delete;
    operator_unit& operator=(const operator_unit&) = delete;

    [[nodiscard]] bool done() const noexcept { return done_; }
    [[nodiscard]] unsigned lost() const noexcept { return lost_; }

  private:
    void work(std::uint16_t port, slave_end& slave, unsigned count, jauscat::net::latency_histogram& times) {
        using std::chrono::microseconds;
        using clock = std::chrono::steady_clock;
        boost::asio::io_context context;
        boost::asio::ip::udp::socket socket{context, {boost::asio::ip::address_v4::loopback(), 0}};
        socket.connect({boost::asio::ip::address_v4::loopback(), port});
        std::mt19937 random{1};
        std::array<std::byte, 64> message{};
        for (unsigned i = 0; i != count; ++i) {
            const jaus::header head{
                .destination = {.instance = 1, .component = component, .node = station, .subsystem = 1},
                .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 2},
                .sequence_number = static_cast<std::uint16_t>(i)};
            const auto made = jaus::make_message(
                head, jaus::set_wrench_effort{.propulsive_linear_effort_x = i % 100, .resistive_linear_effort_x = 1},
                message);
            std::this_thread::sleep_for(microseconds{500 + random() % 2000});
            const auto before = slave.commands();
            const auto sent = clock::now();
            socket.send(boost::asio::buffer(message.data(), made->size()));
            const auto patience = sent + std::chrono::seconds{1};
            while (slave.commands() == before && clock::now() < patience)
                std::this_thread::sleep_for(microseconds{200});
            if (slave.commands() == before)
                ++lost_;
            else
                times.add(slave.last_command() - sent);
        }
        done_ = true;
    }

    std::atomic<bool> done_{};
    std::atomic<unsigned> lost_{};
    std::thread thread_;
};

/// A controller's socket; messages go to `take`.
class jaus_socket {
  public:
    template <class Take> explicit jaus_socket(Take take) {
        transport_.start([take](auto bytes, const auto&, auto) { take(bytes); }, [](std::string_view) {});
    }
    [[nodiscard]] std::uint16_t port() const { return transport_.local().port(); }
    boost::asio::io_context& context() noexcept { return context_; }

  private:
    boost::asio::io_context context_{};
    jauscat::net::udp_transport transport_{context_, {boost::asio::ip::address_v4::loopback(), 0}};
};

/// By the mailbox: translated to an SDO download packet, which the master executes.
inline unsigned command_by_mailbox(row& into, unsigned count, jauscat::net::raw_link& link, ethercat::master& master,
                                   slave_end& slave) {
    using delivery = bridging::delivery<translation::self_contained_table>;
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation{};
    jaus_socket socket{[&](std::span<const std::byte> message) {
        std::array<std::byte, delivery::translator::max_packet_size> packet; // not zeroed: to_packet returns its size
        const auto translated = delivery::translator::to_packet(message, packet);
        static_cast<void>(ethercat::execute_packet(master, translated ? *translated : std::span<std::byte>{},
                                                   confirmation, [&] { return jauscat::net::run(link, master); }));
    }};
    const operator_unit unit{socket.port(), slave, count, into.times};
    while (!jauscat::net::run_until(socket.context(), std::chrono::milliseconds{20}, [&] { return unit.done(); })) {}
    return unit.lost();
}

/// By the process image: in the slave with the next cycle.
inline unsigned command_by_cycle(row& into, unsigned count, jauscat::net::cycle_runner<jauscat::net::raw_link>& cycles,
                                 ethercat::process_data& data, const ethercat::slave_record& record, slave_end& slave) {
    const auto now = [] { return jauscat::net::now(); };
    efforts_by_cycle efforts{{.subsystem = 1, .station = station}, component};
    static_cast<void>(efforts.start(data.outputs(record), data.inputs(record)));
    jaus_socket socket{[&](std::span<const std::byte> bytes) {
        const auto message = jaus::split(bytes);
        if (message && efforts.takes(message.header))
            static_cast<void>(
                efforts.on_command(message.header, message.body, data.outputs(record), data.inputs(record), now()));
    }};
    const operator_unit unit{socket.port(), slave, count, into.times};
    while (!unit.done()) cycles.run([&] { socket.context().poll(); });
    return unit.lost();
}

} // namespace wire_bench
