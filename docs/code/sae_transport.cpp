// Two nodes of SAE JAUS in memory: what one sends, the other gets.
// [includes]
#include <jauscat/sae/transport/transport.hpp>

#include <iostream>
// [includes end]

namespace {

namespace sae = jauscat::sae;

std::string_view text_of(sae::sent_outcome outcome) { return describe(outcome); }

} // namespace

int main() {
    // [transport]
    constexpr sae::jaus_id controller{20, 1, 126}, component{10, 1, 126}; // 126.1.20 and 126.1.10
    static sae::transport_storage<> memory;                               // of one node: no heap is used
    std::array<sae::local_component, 1> components{{{controller}}};
    sae::transport transport{components, memory.memory()};
    // [transport end]

    static sae::transport_storage<> other_memory;
    std::array<sae::local_component, 1> other_components{{{component}}};
    sae::transport other{other_components, other_memory.memory()};
    const jauscat::time_point now{};

    // [send]
    constexpr std::array request_control{std::byte{0x0D}, std::byte{0x00}, std::byte{200}};
    const auto number =
        transport.send({.source = controller, .destination = component, .is_acknowledged = true}, request_control, now);
    if (!number) std::cout << describe(number.error()) << '\n';
    while (const auto datagram = transport.next_datagram(now)) {
        std::cout << datagram->bytes.size() << " bytes to " << (datagram->to ? "the peer" : "the group") << '\n';
        other.on_datagram({1}, datagram->bytes, now, [](const sae::received_message& m) {
            std::cout << sae::jaus_id_text{m.to}.view() << " gets " << m.payload.size() << " bytes of "
                      << sae::jaus_id_text{m.header.source}.view() << '\n';
        });
    }
    // [send end]
    while (const auto datagram = other.next_datagram(now))
        transport.on_datagram({2}, datagram->bytes, now, [](const sae::received_message&) {});
    // [outcome]
    while (const auto done = transport.next_outcome())
        std::cout << "message " << done->first_number << ": " << text_of(done->outcome) << '\n';
    // [outcome end]
}
