// A node with a global object that is not constant at start-up.
#include "node.hpp"

namespace {
struct started {
    started() noexcept { firmware::send(firmware::line::jaus, {}); }
};
started object;
} // namespace

void firmware::on_bytes(std::span<const std::byte>, std::chrono::nanoseconds) noexcept {}
void firmware::on_time(std::chrono::nanoseconds) noexcept {}
