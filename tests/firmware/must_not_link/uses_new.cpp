// A node that keeps what it receives in a container on the heap.
#include "node.hpp"

#include <vector>

namespace {
constinit std::vector<std::byte> received;
}

void firmware::on_bytes(std::span<const std::byte> bytes, std::chrono::nanoseconds) noexcept {
    received.insert(received.end(), bytes.begin(), bytes.end());
}
void firmware::on_time(std::chrono::nanoseconds) noexcept { send(line::jaus, received); }
