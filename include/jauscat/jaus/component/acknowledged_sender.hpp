// Repeats messages until they are acknowledged, without blocking: RA 3.3 part 2, ACK/NAK.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/command_rules.hpp>

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
    control_lost, ///< the receiver has sent Reject Component Control: not repeated; it may have been executed before
};

/// The outcome in one line, for logs.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(delivered what) noexcept;

enum class send_errc : std::uint8_t {
    ok,
    no_capacity,     ///< as many messages wait for an acknowledgement as there are places: send it again later
    too_large,       ///< more bytes than a place holds, or more than one packet
    not_one_address, ///< an octet of the destination is 0 or 255: no single receiver would acknowledge it
    invalid_message, ///< header and body are no message; `send_error::message` says why
    not_encodable,   ///< a value of the body does not encode; `send_error::body` says why
};

/// The error in one line, for logs.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(send_errc error) noexcept;

/// Why a message was not sent. Only the member that send_errc names for the code has a value.
struct send_error {
    send_errc code{};
    errc message{};
    wire::errc body{};

    friend constexpr bool operator==(const send_error&, const send_error&) = default;
};

/// The error in one line, with the reason where there is one.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(const send_error& error) noexcept;

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
    JAUSCAT_CONSTEXPR acknowledged_sender(std::span<awaited_message> places, std::span<std::byte> copies,
                                          const acknowledgement_options& options = {}) noexcept;

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
    [[nodiscard]] JAUSCAT_CONSTEXPR send_result send(std::span<const std::byte> message, time_point now,
                                                     message_sink out) noexcept;

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

    /// The component `of` has sent Reject Component Control: commands to it that only a controller may send are not
    /// repeated, and `tell` gets control_lost for each.
    constexpr void on_control_lost(const address& of, auto&& tell) {
        for (awaited_message& place : places_) {
            const header& head = place.header;
            if (place.size == 0 || head.destination != of || rule_of(head.command_code) == command_rule::open) continue;
            const awaited_message m = std::exchange(place, {});
            tell(m, delivered::control_lost);
        }
    }

    /// Sends a waiting message no more: it has no outcome, and may have arrived. `sent`: its header with the sequence
    /// number. False: no such message waits.
    JAUSCAT_CONSTEXPR bool forget(const header& sent) noexcept;

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
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;
    /// Number of messages that await an acknowledgement.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t waiting() const noexcept;

  private:
    using written = result<std::span<std::byte>, send_error>;

    [[nodiscard]] JAUSCAT_CONSTEXPR static send_error not_a_message(errc why) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static written
    with_error(const result<std::span<std::byte>, errc>& message) noexcept;
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
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::uint16_t counted(std::uint16_t number) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::uint16_t following(std::uint16_t number) noexcept;
    // There are fewer places than numbers, so one is free.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint16_t free_number(const header& head) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<std::byte> copy_of(const awaited_message& place) const noexcept;

    std::span<awaited_message> places_;
    std::span<std::byte> copies_;
    acknowledgement_options options_;
    std::uint16_t next_;
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/acknowledged_sender.ipp>
#endif
