// Repeats messages until they are acknowledged, without blocking: RA 3.3 part 2, ACK/NAK.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace jauscat::jaus {

/// A message that waits for its acknowledgement: a place in the memory of an acknowledged_sender.
struct awaited_message {
    jaus::header header{}; ///< as sent
    std::size_t size{};    ///< of the message, header included; 0: the place is free
    std::uint32_t sent{};  ///< how often
    time_point due{};      ///< when it is repeated or abandoned
    deadline until{};      ///< from then on it is not sent again, however often it was
};

/// Outcome of a message that requested an acknowledgement.
enum class delivered : std::uint8_t {
    acknowledged, ///< ACK: the receiver has executed it
    refused,      ///< NAK: the receiver has not executed it
    timed_out,    ///< no answer to any copy: it may have arrived
};

/// The outcome in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(delivered what) noexcept {
    switch (what) {
    case delivered::acknowledged: return "acknowledged";
    case delivered::refused: return "refused by the receiver (NAK)";
    case delivered::timed_out: return "no acknowledgement in time";
    }
    return "unknown";
}

enum class send_errc : std::uint8_t {
    ok,
    no_capacity,     ///< as many messages wait for an acknowledgement as there are places: send it again later
    too_large,       ///< more bytes than a place holds, or more than one packet
    not_one_address, ///< an octet of the destination is 0 or 255: no single receiver would acknowledge it
    invalid_message, ///< header and body are no message; `send_error::message` says why
    not_encodable,   ///< a value of the body does not encode; `send_error::body` says why
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(send_errc error) noexcept {
    switch (error) {
    case send_errc::ok: return "ok";
    case send_errc::no_capacity: return "too many messages wait for an acknowledgement";
    case send_errc::too_large: return "the message is larger than the place for its copy";
    case send_errc::not_one_address: return "only a message to a single component can be acknowledged";
    case send_errc::invalid_message: return "header and body are no message";
    case send_errc::not_encodable: return "a value of the body does not encode";
    }
    return "unknown error";
}

/// Why a message was not sent. Only the member that send_errc names for the code has a value.
struct send_error {
    send_errc code{};
    errc message{};
    wire::errc body{};

    friend constexpr bool operator==(const send_error&, const send_error&) = default;
};

/// The error in one line, with the reason where there is one.
[[nodiscard]] constexpr std::string_view describe(const send_error& error) noexcept {
    switch (error.code) {
    case send_errc::invalid_message: return describe(error.message);
    case send_errc::not_encodable: return wire::describe(error.body);
    default: return describe(error.code);
    }
}

/// Result of sending: the sequence number, which identifies the message when its outcome is reported.
using send_result = result<std::uint16_t, send_error>;

struct acknowledgement_options {
    /// By default a message times out after one second. The receiver must remember it for longer than `retry.total()`.
    retry_policy retry{.interval = std::chrono::milliseconds{250}, .attempts = 4};
    /// The first sequence number; 1 instead of 0. A restarted program should not begin with the same number: receivers
    /// that remember its messages would treat the new ones as repeats. A random number suffices.
    std::uint16_t first_number{};
};

/// Sends messages that ask for an acknowledgement, keeps a copy of each, and sends it again until the ACK or NAK is
/// there or all attempts are made. A message is known by its command code, sequence number and destination; sequence
/// numbers are given here, one after the other and around at 65536, never one that still waits, and never 0: that is
/// the number of those that do not count, whose repeats a receiver cannot tell from new messages. Each message has one
/// outcome.
///
/// A program that was suspended calls on_time late. What would be sent again after `options.retry.total()` is given up:
/// its receiver may have forgotten it, and would do it twice.
///
///     std::array<jaus::awaited_message, 16> places{};
///     std::array<std::byte, 16 * 64> copies{};
///     jaus::acknowledged_sender commands{places, copies, {.retry = {.interval = 100ms, .attempts = 4}}};
///     if (const auto sent = commands.send(head, jaus::standby{}, now, out); !sent) log(describe(sent.error()));
///     commands.on_message(received_header, [&](const jaus::awaited_message& m, jaus::delivered what) { ... });
class acknowledged_sender {
  public:
    /// Each place has an equal share of `copies`, which bounds the size of a message. Both must outlive this. Of the
    /// places 65534 are used at most: fewer than there are sequence numbers.
    constexpr acknowledged_sender(std::span<awaited_message> places, std::span<std::byte> copies,
                                  const acknowledgement_options& options = {}) noexcept
        : places_{places.first(std::min<std::size_t>(places.size(), 0xFFFE))},
          copies_{copies},
          options_{options},
          next_{counted(options.first_number)} {}

    /// Sends `body` with `head`, after setting its command code, sequence number and acknowledgement request.
    template <coded_message T>
    [[nodiscard]] constexpr send_result send(const header& head, const T& body, time_point now,
                                             message_sink out) noexcept {
        return send(head, command_code_of<T>, now, out, [&](const header& numbered, std::span<std::byte> copy) {
            const auto made = make_message(numbered, body, copy);
            if (made.error() != errc::invalid_body) return with_error(made);
            const auto encoded = wire::encode(body, copy.subspan(header_size)); // again, for its error
            return written{send_error{.code = send_errc::not_encodable, .body = encoded.error()}};
        });
    }
    template <uncoded_type T> constexpr send_result send(const header&, const T&, time_point, message_sink) noexcept {
        refuse_uncoded_type<T>();
        return send_error{send_errc::invalid_message};
    }
    /// The same for an encoded message; its header is rewritten. A message of several packets is too large.
    [[nodiscard]] constexpr send_result send(std::span<const std::byte> message, time_point now,
                                             message_sink out) noexcept {
        header head{};
        if (!wire::decode_prefix(head, message)) return not_a_message(errc::truncated);
        if (message.size() != header_size + head.data_size) return not_a_message(errc::wrong_size);
        if (head.data_flag != data_flag::only) return send_error{send_errc::too_large};
        return send(head, head.command_code, now, out, [&](const header& numbered, std::span<std::byte> copy) {
            return with_error(join(numbered, message.subspan(header_size), copy));
        });
    }

    /// A received message, with or without a body. True: it is an ACK or NAK of a waiting message, and `tell(const
    /// awaited_message&, delivered)` was called with the outcome. False for late and unknown acknowledgements.
    constexpr bool on_message(const header& head, auto&& tell) {
        if (!is_acknowledgement(head)) return false;
        const auto found = std::ranges::find_if(places_, [&](const awaited_message& m) {
            return m.size != 0 && m.header.command_code == head.command_code &&
                   m.header.sequence_number == head.sequence_number && m.header.destination == head.source &&
                   m.header.source == head.destination;
        });
        if (found == places_.end()) return false;
        const awaited_message m = std::exchange(*found, {}); // free first: `tell` may send the next one
        tell(m, head.ack_nak == ack_nak::ack ? delivered::acknowledged : delivered::refused);
        return true;
    }

    /// Sends a waiting message no more: it has no outcome, and may have arrived. `sent`: its header with the sequence
    /// number. False: no such message waits.
    constexpr bool forget(const header& sent) noexcept {
        const auto found = std::ranges::find_if(places_, [&](const awaited_message& m) {
            return m.size != 0 && m.header.command_code == sent.command_code &&
                   m.header.sequence_number == sent.sequence_number && m.header.destination == sent.destination;
        });
        if (found == places_.end()) return false;
        *found = {};
        return true;
    }

    /// Repeats messages that were not acknowledged within the interval; after the last attempt they time out.
    constexpr void on_time(time_point now, message_sink out, auto&& tell) {
        for (awaited_message& place : places_) {
            if (place.size == 0 || now < place.due) continue;
            if (options_.retry.allows_another(place.sent) && !place.until.is_reached(now)) {
                ++place.sent;
                place.due = saturating_add(now, options_.retry.interval);
                out(copy_of(place).first(place.size));
            } else {
                const awaited_message m = std::exchange(place, {});
                tell(m, delivered::timed_out);
            }
        }
    }
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        std::optional<time_point> first;
        for (const awaited_message& m : places_)
            if (m.size != 0 && (!first || m.due < *first)) first = m.due;
        return first;
    }
    /// Number of messages that await an acknowledgement.
    [[nodiscard]] constexpr std::size_t waiting() const noexcept {
        return static_cast<std::size_t>(std::ranges::count_if(places_, [](const auto& m) { return m.size != 0; }));
    }

  private:
    using written = result<std::span<std::byte>, send_error>;

    [[nodiscard]] static constexpr send_error not_a_message(errc why) noexcept {
        return {.code = send_errc::invalid_message, .message = why};
    }
    [[nodiscard]] static constexpr written with_error(const result<std::span<std::byte>, errc>& message) noexcept {
        if (message) return *message;
        const bool large = message.error() == errc::no_space || message.error() == errc::body_too_large;
        return large ? send_error{send_errc::too_large} : not_a_message(message.error());
    }
    constexpr send_result send(header head, std::uint16_t command_code, time_point now, message_sink out,
                               auto&& write) noexcept {
        if (!names_one_component(head.destination)) return send_error{send_errc::not_one_address};
        const auto place = std::ranges::find(places_, std::size_t{0}, &awaited_message::size);
        if (place == places_.end()) return send_error{send_errc::no_capacity};
        head.command_code = command_code;
        head.ack_nak = ack_nak::request;
        head.sequence_number = free_number(head);
        const auto copy = copy_of(*place);
        const written message = write(std::as_const(head), copy);
        if (!message) return message.error();
        head.data_size = static_cast<std::uint16_t>(message->size() - header_size);
        const auto& retry = options_.retry;
        *place = {head, message->size(), 1, saturating_add(now, retry.interval), deadline{now, retry.total()}};
        next_ = following(head.sequence_number);
        out(*message);
        return head.sequence_number;
    }
    [[nodiscard]] static constexpr std::uint16_t counted(std::uint16_t number) noexcept {
        return std::max<std::uint16_t>(number, 1);
    }
    [[nodiscard]] static constexpr std::uint16_t following(std::uint16_t number) noexcept {
        return counted(static_cast<std::uint16_t>(number + 1));
    }
    // There are fewer places than numbers, so one is free.
    [[nodiscard]] constexpr std::uint16_t free_number(const header& head) const noexcept {
        std::uint16_t number = next_;
        while (std::ranges::any_of(places_, [&](const awaited_message& m) {
            return m.size != 0 && m.header.sequence_number == number && m.header.command_code == head.command_code &&
                   m.header.destination == head.destination;
        }))
            number = following(number);
        return number;
    }
    [[nodiscard]] constexpr std::span<std::byte> copy_of(const awaited_message& place) const noexcept {
        const std::size_t share = copies_.size() / places_.size();
        return copies_.subspan(static_cast<std::size_t>(&place - places_.data()) * share, share);
    }

    std::span<awaited_message> places_;
    std::span<std::byte> copies_;
    acknowledgement_options options_;
    std::uint16_t next_;
};

} // namespace jauscat::jaus
