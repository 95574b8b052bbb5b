// A node with a global object that is not constant at start-up.
#include "node.hpp"

namespace {
struct started {
    started() noexcept {
        constexpr std::byte hello{0x05};
        firmware::send(firmware::line::jaus, {&hello, 1});
    }
};
started object;
} // namespace

void firmware::on_bytes(std::span<const std::byte>, jauscat::time_point) noexcept {}
void firmware::on_time(jauscat::time_point) noexcept {}
