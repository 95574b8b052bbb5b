// declare-a-message.md: what a receiver says of bytes that are wrong.
// [includes]
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

namespace jaus = jauscat::jaus;
// [includes end]

int main() {
    // [use]
    // A Set Wrench Effort that announces two efforts, and ends inside the second.
    constexpr std::array bytes{std::byte{0x03}, std::byte{0x00}, std::byte{0xff}, std::byte{0x3f}, std::byte{0x01}};
    jaus::set_wrench_effort command{};
    const auto used = jauscat::wire::decode(command, bytes);
    std::cout << describe(used.error()) << '\n';
    if (!used) std::cout << jauscat::text::to_text(jauscat::wire::diagnose<jaus::set_wrench_effort>(bytes)) << '\n';
    // [use end]
}
