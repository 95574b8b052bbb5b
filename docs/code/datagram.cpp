// catalogue.md: prints the message of any datagram. Without a file it prints one of its own.
//     docs_datagram [FILE]
// [includes]
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/text/jaus.hpp>

#include <fstream>
#include <iostream>
#include <iterator>

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
// [includes end]

namespace {

// [print]
void print(std::span<const std::byte> datagram) {
    const auto parts = jaus::split(jaus::remove_framing(datagram).message);
    if (!parts) return void(std::cout << describe(parts.error) << '\n' << text::hex_dump(datagram));
    std::cout << text::summary(parts.header) << '\n';
    if (const auto* const known = catalogue::ra_3_3().find(parts.header.command_code))
        std::cout << known->to_text(parts.body);
    else
        std::cout << text::hex_dump(parts.body);
}
// [print end]

/// A datagram with the message of a line.
std::vector<std::byte> datagram_of(std::string_view line) {
    // [make]
    const auto message = catalogue::ra_3_3().from_text(line);
    if (!message) return std::cerr << describe(message.error()) << '\n', std::vector<std::byte>{};
    const auto body = message->encode();
    if (!body) return std::cerr << describe(body.error()) << '\n', std::vector<std::byte>{};
    std::vector<std::byte> bytes(jaus::header_size + body->size());
    const jaus::header head{.command_code = message->command_code(),
                            .destination = {.instance = 1, .component = 33, .node = 1, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1}};
    const auto made = jaus::join(head, *body, bytes);
    // [make end]
    return made ? bytes : std::vector<std::byte>{};
}

} // namespace

int main(int count, char** words) {
    if (count == 2) {
        std::ifstream file{words[1], std::ios::binary};
        const std::string read{std::istreambuf_iterator{file}, {}};
        print(std::as_bytes(std::span{read}));
        return file ? 0 : 1;
    }
    print(datagram_of("set_joint_efforts joint[0].joint_effort=-100 joint[1].joint_effort=12.5"));
    const auto bytes = datagram_of("set_wrench_effort propulsive_linear_effort_x=50");
    print(bytes);
    // [facts]
    const auto& type = **catalogue::ra_3_3().find("query_wrench_effort");
    std::cout << text::message_name(type.command_code()) << ": " << type.min_size() << " to " << type.max_size()
              << " bytes, answered by " << text::message_name(type.report()) << '\n';
    // [facts end]
    // [malformed]
    std::cout << catalogue::ra_3_3().why_malformed(0x0405, std::span{bytes}.subspan(jaus::header_size, 3)) << '\n';
    // [malformed end]
    return bytes.empty() ? 1 : 0;
}
