// Answers with lists, which may not fit one packet.
#pragma once
#include <jauscat/jaus/answer.hpp>
#include <jauscat/jaus/large_data_sender.hpp>

namespace jauscat::jaus {

/// Answers `request` from `self` with a message or, if the body is longer than 4080 bytes, with a large data set, all
/// packets of which go to `out` at once. `memory`: header and body of a message must fit; for a large data set also
/// 4096 bytes. False, and nothing is sent, where it is too small or a value does not encode.
template <coded_message T>
constexpr bool answer_in_packets(const header& request, const address& self, const T& body, std::span<std::byte> memory,
                                 message_sink out) noexcept {
    constexpr std::size_t packet_size = header_size + max_body_size;
    header head = answer_to(request, self);
    if (const result size = make_message(head, body, memory)) {
        out(std::span<const std::byte>{memory}.first(size.size()));
        return true;
    }
    if (memory.size() <= packet_size) return false;
    const auto whole = memory.subspan(packet_size);
    const wire::result size = wire::encode(body, whole);
    if (!size) return false;
    head.command_code = command_code_of<T>;
    large_data_sender packets{head, whole.first(size.size()), memory.first(packet_size)};
    while (packets.next(out)) {}
    return packets.error() == errc::ok;
}

} // namespace jauscat::jaus
