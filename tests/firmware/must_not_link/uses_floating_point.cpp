// A node for a core without floating point that computes with real values.
#include "node.hpp"

namespace {
double average{};
}

void firmware::on_bytes(std::span<const std::byte> bytes, std::chrono::nanoseconds) noexcept {
    average = 0.9 * average + 0.1 * static_cast<double>(bytes.size());
}
void firmware::on_time(std::chrono::nanoseconds) noexcept {
    if (average > 10) send(line::jaus, {});
}
