// The node in raw values: efforts as the integers of the wire. Needs no floating point.
#include "jauscat_node.hpp"
#include <jauscat/wire/raw.hpp>

namespace {
using namespace firmware;
constinit jauscat_node<jauscat::wire::raw<jaus::set_wrench_effort>, jauscat::wire::raw<jaus::report_wrench_effort>>
    node;
} // namespace

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) noexcept {
    node.on_bytes(bytes, now);
}
void firmware::on_time(jauscat::time_point now) noexcept { node.on_time(now); }
