// The SAE transport: any datagrams, streams and serial lines.
#include "support/target.hpp"
#include <jauscat/sae/transport/jserial.hpp>
#include <jauscat/sae/transport/jtcp.hpp>
#include <jauscat/sae/transport/transport.hpp>

#include <chrono>
#include <memory>

using namespace fuzz;
using namespace jauscat;

namespace {

constexpr sae::jaus_id self{1, 1, 1};
constexpr sae::transport_sizes sizes{
    .peers = 4, .seen = 8, .fragments = 8, .queue = 8, .replies = 4, .payload_size = 32, .message_size = 100};

// What a reader finds, if the bytes arrive in parts of this size: the errors, and the bytes of messages.
template <class Reader>
std::vector<std::pair<sae::transport_errc, byte_vector>> read(std::span<const std::byte> bytes, std::size_t part) {
    byte_vector buffer(64);
    Reader reader{buffer};
    std::vector<std::pair<sae::transport_errc, byte_vector>> found;
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(part, bytes.size())))
        reader.on_bytes(copy_of(bytes.first(std::min(part, bytes.size()))), [&](const auto& one) {
            if constexpr (requires { one.message; })
                found.emplace_back(one.error, copy_of(one.message));
            else
                found.emplace_back(one.error, copy_of(one.bytes));
        });
    return found;
}

void check_message(const sae::split_transport_message& m) {
    if (!m || m.header.compression != sae::compression::none) return;
    if (m.header.broadcast > sae::broadcast::global || sae::has_zero(m.header.destination)) return;
    byte_vector out(m.bytes.size());
    const auto again = sae::join(m.header, m.payload, m.sequence_number, out);
    check(again && std::ranges::equal(*again, m.bytes), "a message that may be sent is encoded to its bytes");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    input_reader in{input};
    const std::size_t part = std::size_t{in.take()} + 1;
    const auto all = copy_of(in.rest());
    check(read<sae::jtcp_reader>(all, all.size() + 1) == read<sae::jtcp_reader>(all, part),
          "it does not matter in which pieces a stream arrives");
    check(read<sae::jserial_reader>(all, all.size() + 1) == read<sae::jserial_reader>(all, part),
          "it does not matter in which pieces the bytes of a serial line arrive");

    // The same bytes as datagrams: of each the size, its endpoint, and its time after the one before.
    const auto storage = std::make_unique<sae::transport_storage<sizes>>();
    std::array<sae::local_component, 1> components{{{self}}};
    sae::transport transport{components, storage->memory(), {.payload_size = 32}};
    time_point now{};
    std::size_t sent = 0, delivered = 0;
    while (!in.empty()) {
        const std::size_t size = in.take();
        now += std::chrono::milliseconds{in.take() * 16};
        const sae::endpoint_key from{in.take()};
        const auto datagram = copy_of(in.rest().first(std::min(size, in.rest().size())));
        static_cast<void>(in.take_bytes(datagram.size()));
        for (sae::datagram_reader messages{datagram}; messages.has_next();) check_message(messages.next());
        transport.on_datagram(from, datagram, now, [&](const sae::received_message& m) {
            ++delivered;
            check(m.to == self, "a message is for a component of the transport");
            check(m.payload.size() >= 2, "a message has its ID");
            if (transport.send({.source = self, .destination = m.header.source, .is_acknowledged = size % 2 == 0},
                               m.payload, now))
                ++sent;
        });
        while (const auto out = transport.next_datagram(now))
            check(static_cast<bool>(sae::datagram_reader{out->bytes}.next()), "what is sent is a message");
        while (transport.next_outcome()) continue;
    }
    for (int i = 0; i != 100 && transport.next_event(); ++i) {
        now = std::max(now, *transport.next_event());
        while (transport.next_datagram(now)) continue;
        while (transport.next_outcome()) continue;
    }
    check(!transport.next_event(), "repetition ends");
    check(sent <= delivered, "a message is answered once");
}
