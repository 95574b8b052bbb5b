// Cyclic exchange: outputs to a slave and its inputs back, a frame every millisecond. The slave is emulated in this
// process; over a raw_link the same code runs on a wire.
//     process_data
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/cycle_runner.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/version.hpp>

#include <iostream>
#include <string_view>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;
using namespace std::chrono_literals;

/// No objects but the standard ones.
struct no_objects {
    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = ethercat::abort_code::no_object};
    }
    ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return ethercat::abort_code::no_object;
    }
};

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "process_data (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    // The slave: one byte of outputs, one of inputs.
    constexpr std::uint8_t unsigned8 = 0x05;
    constexpr ethercat::pdo_entry target{0x7000, 1, 8, unsigned8, "target"}, actual{0x6000, 1, 8, unsigned8, "actual"};
    const ethercat::slave_description description{
        .vendor = 1, .product = 1, .outputs = {&target, 1}, .inputs = {&actual, 1}};
    no_objects own{};
    ethercat::standard_objects objects{description, own};
    ethercat::slave device{description, objects};
    ethercat::loopback_link link{std::span{&device, 1}};

    // The master: from INIT to SAFE-OP, one job after the other.
    ethercat::master_for<16> master;
    constexpr std::uint16_t station = 1;
    const auto fail = [](const ethercat::master_error& error) {
        std::cout << describe(error) << '\n';
        return 1;
    };
    const auto slave = net::run(link, master, ethercat::bring_up{.position = 0, .station = station});
    if (!slave) return fail(slave.error());
    // Finds out what process data the slave has, and sets its watchdog.
    const auto place = net::run(link, master, ethercat::configure{.station = station});
    if (!place) return fail(place.error());
    const auto safe_op =
        net::run(link, master, ethercat::change_state{.station = station, .goal = ethercat::al_state::safe_op});
    if (!safe_op) return fail(safe_op.error());

    // A slave goes to OP while outputs flow.
    ethercat::process_data_for<1, 2> data{master.slaves()};
    net::cycle_runner cycles{link, data, master, {.period = 1ms}};
    const auto outputs = data.outputs(*master.find(station));
    const auto inputs = data.inputs(*master.find(station));
    const auto op = cycles.run_job(
        ethercat::change_state{.station = station, .goal = ethercat::al_state::op}, 10s, [] {},
        [](const net::cycle_report&) {});
    if (!op) return fail(op.error());
    std::cout << "in OP: " << outputs.size() << " byte of outputs, " << inputs.size() << " of inputs\n";

    // Each cycle: outputs are written just before the frame is sent; its inputs are the result of the slave's previous
    // cycle.
    for (int i = 1; i <= 100; ++i) {
        cycles.run([&] { outputs[0] = static_cast<std::byte>(i); });
        if (device.take_outputs()) device.inputs()[0] = device.outputs()[0]; // the slave's application
    }
    const bool good = data.is_complete() && std::to_integer<int>(inputs[0]) == 99;
    std::cout << "the last target: 100, the last actual value: " << std::to_integer<int>(inputs[0]) << '\n'
              << (data.is_complete() ? "every slave took part in the last cycle\n" : "the last cycle is incomplete\n");
    if (!std::cout.flush()) return std::cerr << "process_data: standard output cannot be written\n", 1;
    return good ? 0 : 1;
}
