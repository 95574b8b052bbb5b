// A node that takes memory from the C library.
#include "node.hpp"

#include <cstdlib>

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point) noexcept {
    auto* const copy = static_cast<std::byte*>(std::malloc(bytes.size()));
    if (copy != nullptr) send(line::jaus, {copy, bytes.size()});
}
void firmware::on_time(jauscat::time_point) noexcept {}
