// One field out of received bytes, without decoding the message: what a filter, a logger or a router does.
//     view_fields
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/value.hpp>
#include <jauscat/version.hpp>
#include <jauscat/wire/view.hpp>

#include <array>
#include <iostream>
#include <string_view>

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "view_fields (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    // A Set Wrench Effort for 2.2.33.1: half of the force forward, and a quarter of the resistance.
    constexpr std::array<unsigned char, 21> octets{0x06, 0x02, 0x05, 0x04, 1,    33,   2,    2,    1,    32,  1,
                                                   1,    5,    0,    0x22, 0x00, 0x41, 0x00, 0x00, 0x40, 0x40};
    const auto message = std::as_bytes(std::span{octets});

    // A view checks once that the bytes are complete; then each field is read at its offset.
    constexpr std::size_t header_size = wire::max_size<jaus::header>;
    const wire::view<jaus::header> head{message.first(header_size)};
    if (!head) return std::cerr << describe(head.error()) << '\n', 1;
    std::cout << "to component " << int{head.get<&jaus::header::destination>().get<&jaus::address::component>()} << ", "
              << head.get<&jaus::header::data_size>() << " bytes of body\n";

    using command = jaus::set_wrench_effort;
    const wire::view<command> body{message.subspan(header_size)};
    if (!body) return std::cerr << describe(body.error()) << '\n', 1;
    if (const auto forward = body.get<&command::propulsive_linear_effort_x>())
        std::cout << "forward: " << *forward << " %, on the wire "
                  << body.get_raw<&command::propulsive_linear_effort_x>().value_or(0) << '\n';
    if (const auto resistance = body.get<&command::resistive_linear_effort_x>()) // behind a field of another size
        std::cout << "resistance: " << *resistance << " %\n";
    if (!body.get<&command::propulsive_linear_effort_y>()) std::cout << "sideways: not in this message\n";

    const wire::view<command> cut{message.subspan(header_size, 4)};
    std::cout << "without its last byte: " << describe(cut.error()) << '\n';
    if (!std::cout.flush()) return std::cerr << "view_fields: standard output cannot be written\n", 1;
}
