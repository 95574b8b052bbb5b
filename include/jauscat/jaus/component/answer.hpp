// Functions that send replies.
#pragma once
#include <jauscat/jaus/component/message_outcome.hpp>
#include <jauscat/jaus/large_data/large_data_sender.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/message/message_sink.hpp>

#include <algorithm>
#include <array>

namespace jauscat::jaus {

/// Decodes a body and passes it to `use(const T&)`, which returns a message_outcome or nothing (then it counts as
/// executed).
template <coded_message T, class F>
constexpr message_outcome decode_for(std::span<const std::byte> body, F&& use) noexcept {
    T message{};
    if (!wire::decode(message, body)) return message_outcome::malformed;
    if constexpr (std::same_as<std::invoke_result_t<F&, const T&>, message_outcome>) {
        return use(std::as_const(message));
    } else {
        use(std::as_const(message));
        return message_outcome::handled;
    }
}

namespace detail {
// Out of line: g++ 12 warns about the size of the buffer where it sees the sizes of body and buffer, but not the check.
template <coded_message T>
[[gnu::noinline]] constexpr result<void, errc> put_in(std::span<std::byte> room, const header& head, const T& body,
                                                      message_sink out) noexcept {
    const auto message = make_message(head, body, room);
    if (!message) return message.error() == errc::no_space ? errc::body_too_large : message.error();
    out(*message);
    return {};
}
} // namespace detail

/// Hands the message of `head` and `body` to `out`. Errors, and then nothing is sent: invalid_body, invalid_header,
/// body_too_large for more than 4080 bytes.
template <coded_message T>
constexpr result<void, errc> put(const header& head, const T& body, message_sink out) noexcept {
    std::array<std::byte, header_size + std::min(wire::max_size<T>, max_body_size)> bytes{};
    if constexpr (max_body_size < wire::max_size<T>) return detail::put_in(bytes, head, body, out);
    const auto message = make_message(head, body, bytes);
    if (!message) return message.error();
    out(*message);
    return {};
}
/// The same for a body of any size: one of more than 4080 bytes goes as a large data set, all packets of which are
/// handed to `out` at once. `memory`: header and body of a message must fit; for a large data set also 4096 bytes.
/// Errors: invalid_body, invalid_header, no_space.
template <coded_message T>
constexpr result<void, errc> put(header head, const T& body, std::span<std::byte> memory, message_sink out) noexcept {
    constexpr std::size_t packet_size = header_size + max_body_size;
    const auto message = make_message(head, body, memory);
    if (message) {
        out(*message);
        return {};
    }
    if (memory.size() <= packet_size) return message.error();
    const auto whole = memory.subspan(packet_size);
    const auto encoded = wire::encode(body, whole);
    if (!encoded) return encoded.error() == wire::errc::no_space ? errc::no_space : errc::invalid_body;
    head.command_code = command_code_of<T>;
    large_data_sender packets{head, *encoded, memory.first(packet_size)};
    while (packets.next(out)) {}
    return packets.error();
}

/// Answers `request` from `self`. Errors as of `put`, and then nothing is sent.
template <coded_message T>
constexpr result<void, errc> answer(const header& request, const address& self, const T& body,
                                    message_sink out) noexcept {
    return put(answer_to(request, self), body, out);
}
/// The same for a body of any size, with the memory that `put` needs.
template <coded_message T>
constexpr result<void, errc> answer(const header& request, const address& self, const T& body,
                                    std::span<std::byte> memory, message_sink out) noexcept {
    return put(answer_to(request, self), body, memory, out);
}

template <uncoded_type T> constexpr result<void, errc> put(const header&, const T&, auto&&...) noexcept {
    refuse_uncoded_type<T>();
    return errc::invalid_body;
}
template <uncoded_type T>
constexpr result<void, errc> answer(const header&, const address&, const T&, auto&&...) noexcept {
    refuse_uncoded_type<T>();
    return errc::invalid_body;
}
template <uncoded_type T> constexpr message_outcome decode_for(std::span<const std::byte>, auto&&) noexcept {
    refuse_uncoded_type<T>();
    return message_outcome::malformed;
}

/// Answers `request` with an ACK or a NAK from `self`. Error: invalid_header.
constexpr result<void, errc> acknowledge(header request, const address& self, ack_nak how, message_sink out) noexcept {
    request.destination = self;
    std::array<std::byte, header_size> bytes{};
    const auto message = make_acknowledgement(request, how, bytes);
    if (!message) return message.error();
    out(*message);
    return {};
}

} // namespace jauscat::jaus
