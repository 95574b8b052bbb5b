// A message that does not fit one packet: cut into packets by its sender, put together by its receiver. One of them
// is overtaken by the next, one is lost and sent again.
//     large_data
#include <jauscat/jaus/large_data/large_data_sender.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/schema/jaus/environment_sensor.hpp>
#include <jauscat/version.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>
#include <string_view>
#include <vector>

namespace jaus = jauscat::jaus;
using namespace std::chrono_literals;

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "large_data (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    // Report Image, with a picture of 15000 bytes.
    const std::vector<std::byte> picture(15000, std::byte{0x5A});
    const jaus::report_image image{.camera_id = 1, .image_data = picture};
    std::vector<std::byte> body(jauscat::wire::encoded_size(image));
    if (const auto encoded = jauscat::wire::encode(image, body); !encoded)
        return std::cerr << describe(encoded.error()) << '\n', 1;

    // The receiver: memory for two data sets at a time, of at most 8 packets each. Nothing is allocated.
    std::array<jaus::partial_data_set, 2> places{};
    std::array<jaus::held_packet, 2 * 8> packets{};
    std::vector<std::byte> memory(2 * 8 * jaus::max_body_size);
    jaus::reassembler receiver{places, packets, memory, 5s};

    std::size_t received = 0;
    const auto take = [&](const jaus::header&, std::span<const std::byte> whole) { // its body, as if it had fitted
        jaus::report_image shown{};
        std::array<std::byte, 256> room{};
        jauscat::wire::arena arena{room};
        if (!jauscat::wire::decode(shown, whole, arena)) return;
        received = shown.image_data.size();
        std::cout << "camera " << int{shown.camera_id} << ": a picture of " << received << " bytes\n";
    };
    const auto lost = [](const jaus::partial_data_set& incomplete) {
        std::cout << "given up with " << incomplete.packets << " packets\n";
    };
    const auto now = jauscat::net::now(); // of all packets: no pause of this program comes between them
    const auto receive = [&](std::span<const std::byte> packet) {
        const auto message = jaus::split(packet);
        if (!message) return;
        const auto what = receiver.on_packet(message.header, message.body, now, take, lost);
        std::cout << "packet " << message.header.sequence_number << ", " << packet.size()
                  << " bytes: " << describe(what) << '\n';
    };

    // The sender makes one packet at each call, so that its caller paces them.
    std::array<std::byte, jaus::header_size + jaus::max_body_size> packet{};
    jaus::large_data_sender sender{{.command_code = jaus::command_code_of<jaus::report_image>,
                                    .destination = {.instance = 1, .component = 32, .node = 1, .subsystem = 1},
                                    .source = {.instance = 1, .component = 37, .node = 2, .subsystem = 2}},
                                   body,
                                   packet};
    if (sender.error() != jaus::errc::ok) return std::cerr << describe(sender.error()) << '\n', 1;
    std::cout << sender.packets() << " packets\n";

    std::vector<std::byte> late;
    sender.next([&](std::span<const std::byte> first) { late.assign(first.begin(), first.end()); });
    sender.next(receive);
    receive(late); // overtaken
    sender.next([](std::span<const std::byte>) { std::cout << "packet 2 is lost\n"; });
    while (sender.next(receive)) {}
    const bool repeated = sender.repeat(2, receive);
    if (!std::cout.flush()) return std::cerr << "large_data: standard output cannot be written\n", 1;
    return repeated && received == picture.size() ? 0 : 1;
}
