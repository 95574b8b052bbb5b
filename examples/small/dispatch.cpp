// From received messages to the handlers of their types, by a table that is made at compile time.
//     dispatch
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/version.hpp>
#include <jauscat/wire/raw.hpp>

#include <array>
#include <iostream>
#include <string_view>

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "dispatch (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    using speed = jauscat::wire::raw<jaus::set_travel_speed>; // this one as the integer of the wire
    jaus::dispatcher vehicle{
        jaus::on<jaus::set_wrench_effort>([](const jaus::header&, const jaus::set_wrench_effort& command) {
            std::cout << "forward: " << command.propulsive_linear_effort_x.value_or(0) << " %\n";
        }),
        jaus::on<speed>([](const jaus::header&, const speed& command) {
            std::cout << "speed, raw: " << command.get<&jaus::set_travel_speed::desired_speed>() << '\n';
        }),
        jaus::on<jaus::query_component_status>([](const jaus::header& head, const jaus::query_component_status&) {
            std::cout << text::to_text(head.source) << " asks for the status\n";
        }),
        // Without these three, such messages are left to the value that the call returns.
        jaus::on_unknown([](const jaus::header& head, std::span<const std::byte>) {
            std::cout << "no handler for " << text::message_name(head.command_code) << '\n';
        }),
        jaus::on_malformed([](const jaus::header& head, std::span<const std::byte>, jauscat::wire::errc error) {
            std::cout << text::message_name(head.command_code) << ": " << describe(error) << '\n';
        }),
        jaus::on_acknowledgement([](const jaus::header& head) { std::cout << text::summary(head) << '\n'; })};

    const jaus::header head{.destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1}};
    // Makes a message as another node would, and takes it as this one does.
    const auto receive = [&](const auto& body) {
        std::array<std::byte, 64> buffer{};
        const auto message_bytes = jaus::make_message(head, body, buffer);
        const auto message = jaus::split(*message_bytes);
        return message ? vehicle(message.header, message.body) : jaus::dispatched::malformed;
    };
    receive(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50});
    receive(jaus::set_travel_speed{.desired_speed = 2.5});
    receive(jaus::query_component_status{});
    receive(jaus::set_emergency{});

    // Bodies that do not decode never reach the handler of their type.
    jaus::header short_one = head;
    short_one.command_code = jaus::command_code_of<jaus::set_wrench_effort>;
    vehicle(short_one, std::array{std::byte{0x01}, std::byte{0x00}});

    jaus::header acknowledgement = short_one;
    acknowledgement.ack_nak = jaus::ack_nak::ack;
    const bool is_one = vehicle(acknowledgement, {}) == jaus::dispatched::acknowledgement;
    if (!std::cout.flush()) return std::cerr << "dispatch: standard output cannot be written\n", 1;
    return is_one ? 0 : 1;
}
