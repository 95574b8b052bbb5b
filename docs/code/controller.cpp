// machinery-controller.md: JAUS messages carried to an EtherCAT slave, and its reports back.
// [includes]
#include "driver.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/bridge/packet_exchange.hpp>
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/packet_status_text.hpp>

#include <iostream>

namespace net = jauscat::net;
// [includes end]

// [controller]
/// Sends messages to the slave with the station address 2, over any link.
template <ethercat::link Link> class controller {
  public:
    explicit controller(Link& link) : link_{link} {}

    /// Brings the slave up.
    auto start() { return net::run(link_, master_, ethercat::bring_up{.position = 0, .station = station}); }

    /// Delivers a message; passes its report, if it is a query, and its acknowledgement to `answer`.
    template <class Answer> void carry(std::span<const std::byte> message, Answer answer) {
        auto step = exchange_.begin(message, buffer_);
        while (step.what == bridging::exchange_progress::request)
            step = exchange_.on_confirmation(execute(std::span{buffer_}.first(step.size)), buffer_);
        if (exchange_.error() != jauscat::translate::errc::ok)
            std::cout << "refused: " << describe(exchange_.error()) << '\n'; // by the table
        else if (step.what == bridging::exchange_progress::failed)
            std::cout << "refused: " << jauscat::text::explain(exchange_.status()) << '\n'; // by the slave
        if (step.size != 0) answer(std::span{buffer_}.first(step.size));
        if (const auto size = exchange_.acknowledgement(buffer_); size != 0) answer(std::span{buffer_}.first(size));
    }

  private:
    /// Executes a request packet by the master; returns the confirmation.
    std::span<const std::byte> execute(std::span<const std::byte> request) {
        return ethercat::execute_packet(master_, request, confirmation_, [&] { return net::run(link_, master_); });
    }

    static constexpr std::uint16_t station = 2;
    using exchange = bridging::packet_exchange<driver_table>;

    Link& link_;
    ethercat::master_for<16> master_{};
    exchange exchange_{{.subsystem = 2, .station = station}};
    std::array<std::byte, exchange::buffer_size> buffer_{};
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation_{};
};
// [controller end]

/// Makes a message for the driver.
template <class T> std::span<const std::byte> message_of(const T& body, std::span<std::byte> buffer) {
    const jaus::header head{.ack_nak = jaus::ack_nak::request,
                            .destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1}};
    return *jaus::make_message(head, body, buffer);
}

int main() {
    // The slave of write-a-slave.md.
    driver application{};
    bridging::listed_objects objects{std::span{&driver_objects::description, 1}, application};
    ethercat::slave device{{.vendor = 1, .product = 33, .name = "driver"}, objects};
    ethercat::loopback_link link{std::span{&device, 1}};

    // [use]
    controller robot{link};
    if (const auto up = robot.start(); !up) return std::cerr << describe(up.error()) << '\n', 1;
    const auto show = [](std::span<const std::byte> answer) {
        const auto message = jaus::split(answer);
        std::cout << "  answer: " << jauscat::text::summary(message.header) << '\n';
        if (jaus::is_acknowledgement(message.header)) return;
        std::cout << jauscat::text::annotate<jaus::report_wrench_effort>(message.body, jaus::header_size);
    };

    std::array<std::byte, 64> buffer{};
    std::cout << "Set Wrench Effort\n";
    robot.carry(message_of(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50}, buffer), show);
    std::cout << "Query Wrench Effort\n";
    robot.carry(message_of(jaus::query_wrench_effort{.presence_vector = 1}, buffer), show);
    std::cout << "Set Travel Speed, which this slave does not know\n";
    robot.carry(message_of(jaus::set_travel_speed{.desired_speed = 2}, buffer), show);
    // [use end]
}
