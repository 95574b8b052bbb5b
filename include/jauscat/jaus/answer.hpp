// What a component's state machines have in common: what they make of a message, and how they answer it.
#pragma once
#include <jauscat/jaus/message.hpp>
#include <jauscat/jaus/message_sink.hpp>

#include <array>

namespace jauscat::jaus {

/// What a state machine made of a message.
enum class message_outcome : std::uint8_t {
    not_mine,  ///< another's business: nothing was done
    taken,     ///< done, and answered where the standard has an answer; an ACK is due if one was asked for
    refused,   ///< understood, but not done: a NAK is due if an acknowledgement was asked for
    malformed, ///< its own, but the body does not decode; nothing was done, a NAK is due
    deferred,  ///< executed later; acknowledged by component::finish
};

/// The outcome in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(message_outcome what) noexcept {
    switch (what) {
    case message_outcome::not_mine: return "no message that is handled here";
    case message_outcome::taken: return "taken";
    case message_outcome::refused: return "refused";
    case message_outcome::malformed: return "malformed: the body does not decode";
    case message_outcome::deferred: return "deferred: executed and acknowledged later";
    }
    return "unknown";
}

/// Decodes a body and hands it to `use(const T&)`, which returns a message_outcome or nothing (then it is taken).
template <coded_message T, class F>
constexpr message_outcome decode_for(std::span<const std::byte> body, F&& use) noexcept {
    T message{};
    if (!wire::decode(message, body)) return message_outcome::malformed;
    if constexpr (std::same_as<std::invoke_result_t<F&, const T&>, message_outcome>) {
        return use(std::as_const(message));
    } else {
        use(std::as_const(message));
        return message_outcome::taken;
    }
}

/// Hands the message of `head` and `body` to `out`; false where it does not encode.
template <coded_message T> constexpr bool put(const header& head, const T& body, message_sink out) noexcept {
    std::array<std::byte, header_size + wire::max_size<T>> bytes{};
    const result size = make_message(head, body, bytes);
    if (!size) return false;
    out(std::span<const std::byte>{bytes}.first(size.size()));
    return true;
}

/// Answers `request` from `self`; false where the answer does not encode.
template <coded_message T>
constexpr bool answer(const header& request, const address& self, const T& body, message_sink out) noexcept {
    return put(answer_to(request, self), body, out);
}

/// Answers `request` with an ACK or a NAK from `self`.
constexpr bool acknowledge(header request, const address& self, ack_nak how, message_sink out) noexcept {
    request.destination = self;
    std::array<std::byte, header_size> bytes{};
    const result size = make_acknowledgement(request, how, bytes);
    if (size) out(bytes);
    return static_cast<bool>(size);
}

} // namespace jauscat::jaus
