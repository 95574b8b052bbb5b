// A message of one's own over EtherCAT: written are the message and its layout (gripper_messages.hpp), its place in the
// list of codes, and what a slave does with it. Translation and delivery know nothing of it.
#include "gripper_messages.hpp"
#include <jauscat/bridge/packet_exchange.hpp>
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/packet_status_text.hpp>
#include <jauscat/version.hpp>

#include <iostream>
#include <string_view>

namespace {

using namespace jauscat;

/// The codes of RA 3.3 keep their ranks; Set Gripper is appended and has rank 159.
constexpr auto command_codes = translation::ra_command_codes_and<jaus::command_code_of<gripper::set_gripper>>;
using table = translation::self_contained_table_of<translation::manufacturer_index_base, command_codes>::type;

/// The slave's application: data written to its objects become a message again.
class gripper_slave {
  public:
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        std::cout << "slave: object " << text::hex_number(index, 4) << ":" << int{subindex} << ", " << data.size()
                  << " bytes\n";
        const auto restored = delivery::message_of({station, index, subindex, data}, {.station = station}, message_);
        if (!restored) return ethercat::abort_code::parameter_incompatible;
        const auto received = jaus::split(*restored);
        if (!received) return ethercat::abort_code::parameter_incompatible;
        jaus::dispatcher handlers{jaus::on<gripper::set_gripper>(
            [&](const jaus::header&, const gripper::set_gripper& command) { obeyed = command; })};
        return handlers(received.header, received.body) == jaus::dispatched::handled
                   ? ethercat::abort_code::none
                   : ethercat::abort_code::value_range;
    }
    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = ethercat::abort_code::write_only};
    }

    static constexpr std::uint16_t station = 2;
    gripper::set_gripper obeyed{};

  private:
    using delivery = bridging::delivery<table>;
    std::array<std::byte, delivery::translator::max_message_size> message_{};
};

/// Brings the slave up and has one request packet executed; returns the confirmation, empty where there is no slave.
std::span<const std::byte> execute(std::span<const std::byte> request, std::span<std::byte> confirmation,
                                   ethercat::slave& device) {
    ethercat::loopback_link link{std::span{&device, 1}};
    ethercat::master_for<16> master;
    if (!net::run(link, master, ethercat::bring_up{.position = 0, .station = gripper_slave::station})) return {};
    return ethercat::execute_packet(master, request, confirmation, [&] { return net::run(link, master); });
}

int failed(std::string_view why) {
    std::cout << "FAILED: " << why << "\n";
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "private_message (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    const gripper::set_gripper command{.finger = 0, .opening = 80.0, .force = 20.0};
    std::array<std::byte, jaus::header_size + wire::max_size<gripper::set_gripper>> message{};
    const auto made = jaus::make_message({.ack_nak = jaus::ack_nak::request,
                                          .experimental = true,
                                          .destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 1},
                                          .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1},
                                          .sequence_number = 7},
                                         command, message);
    if (!made) return failed(describe(made.error()));
    std::cout << "Set Gripper\n" << text::annotate_message(*made, private_messages{});

    // Forth: an SDO download of the subobject of its rank. Back: the same message.
    using exchange_type = bridging::packet_exchange<table>;
    exchange_type exchange{{.subsystem = 1, .station = gripper_slave::station}};
    std::array<std::byte, exchange_type::buffer_size> buffer{};
    auto step = exchange.begin(*made, buffer);
    if (step.what != bridging::exchange_progress::request) return failed(describe(exchange.error()));
    const auto packet = std::span{buffer}.first(step.size);
    std::cout << "SDO download request\n"
              << text::annotate<hilscher::sdo_download_request>(packet)
              << "  abSdoData: " << text::hex(packet.subspan(wire::max_size<hilscher::sdo_download_request>)) << "\n";
    std::array<std::byte, message.size()> again{};
    const auto back = translate::translator<table>::from_packet(packet, again);
    if (!back || back->size() != made->size() || again != message) return failed("the packet is not the message");
    std::cout << "translated back: the same " << back->size() << " bytes\n";

    gripper_slave application;
    ethercat::slave device{{.vendor = 1, .product = 1, .name = "gripper"}, application};
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation{};
    step = exchange.on_confirmation(execute(packet, confirmation, device), buffer);
    std::cout << "confirmation: " << text::explain(exchange.status()) << "\n";
    if (step.what != bridging::exchange_progress::done) return failed("the slave did not take the message");

    const auto& obeyed = application.obeyed;
    std::cout << "slave: finger " << int{obeyed.finger} << ", opening " << text::to_text(obeyed.opening.value_or(0))
              << " mm, force " << text::to_text(obeyed.force.value_or(0)) << " %\n";
    std::array<std::byte, wire::max_size<gripper::set_gripper>> body{};
    const auto encoded = wire::encode(obeyed, body);
    if (!std::ranges::equal(*encoded, std::span{message}.subspan(jaus::header_size)))
        return failed("the slave has made another message of the object");
    const auto acknowledgement = std::span{buffer}.first(exchange.acknowledgement(buffer));
    std::cout << "answer: " << text::summary(jaus::split(acknowledgement).header) << "\n";
    if (!std::cout.flush()) return std::cerr << "private_message: standard output cannot be written\n", 1;
    return 0;
}
