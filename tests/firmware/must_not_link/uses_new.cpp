// A node that keeps what it receives in a container on the heap.
#include "node.hpp"

#include <vector>

namespace {
constinit std::vector<std::byte> received;
}

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point) noexcept {
    received.insert(received.end(), bytes.begin(), bytes.end());
}
void firmware::on_time(jauscat::time_point) noexcept { send(line::jaus, received); }
