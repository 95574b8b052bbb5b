// The node in real values: efforts in percent.
#include "jauscat_node.hpp"

namespace {
using namespace firmware;
constinit jauscat_node<jaus::set_wrench_effort, jaus::report_wrench_effort> node;
} // namespace

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) noexcept {
    node.on_bytes(bytes, now);
}
void firmware::on_time(jauscat::time_point now) noexcept { node.on_time(now); }
