// The node written by hand, in raw values: efforts as the integers of the wire.
#include "hand_written_node.hpp"

namespace {
constinit by_hand::node<by_hand::raw_values> node;
}

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) noexcept {
    node.on_bytes(bytes, now);
}
void firmware::on_time(jauscat::time_point now) noexcept { node.on_time(now); }
