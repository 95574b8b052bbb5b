// The functions of acknowledged_sender.
#pragma once
#include <jauscat/jaus/component/acknowledged_sender.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR std::string_view describe(delivered what) noexcept {
    switch (what) {
    case delivered::acknowledged: return "acknowledged";
    case delivered::refused: return "refused by the receiver (NAK)";
    case delivered::timed_out: return "no acknowledgement in time";
    case delivered::control_lost: return "control was lost before an acknowledgement";
    }
    return "unknown";
}

JAUSCAT_CONSTEXPR std::string_view describe(send_errc error) noexcept {
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

JAUSCAT_CONSTEXPR std::string_view describe(const send_error& error) noexcept {
    switch (error.code) {
    case send_errc::invalid_message: return describe(error.message);
    case send_errc::not_encodable: return wire::describe(error.body);
    default: return describe(error.code);
    }
}

JAUSCAT_CONSTEXPR acknowledged_sender::acknowledged_sender(std::span<awaited_message> places,
                                                           std::span<std::byte> copies,
                                                           const acknowledgement_options& options) noexcept
    : places_{places.first(std::min<std::size_t>(places.size(), 0xFFFE))},
      copies_{copies},
      options_{options},
      next_{counted(options.first_number)} {}

JAUSCAT_CONSTEXPR send_result acknowledged_sender::send(std::span<const std::byte> message, time_point now,
                                                        message_sink out) noexcept {
    header head{};
    if (!wire::decode_prefix(head, message)) return not_a_message(errc::truncated);
    if (message.size() != header_size + head.data_size) return not_a_message(errc::wrong_size);
    if (head.data_flag != data_flag::only) return send_error{send_errc::too_large};
    return send(head, head.command_code, now, out, [&](const header& numbered, std::span<std::byte> copy) {
        return with_error(join(numbered, message.subspan(header_size), copy));
    });
}

JAUSCAT_CONSTEXPR bool acknowledged_sender::forget(const header& sent) noexcept {
    const auto found = std::ranges::find_if(places_, [&](const awaited_message& m) {
        return m.size != 0 && m.header.command_code == sent.command_code &&
               m.header.sequence_number == sent.sequence_number && m.header.destination == sent.destination;
    });
    if (found == places_.end()) return false;
    *found = {};
    return true;
}

JAUSCAT_CONSTEXPR std::optional<time_point> acknowledged_sender::next_event() const noexcept {
    std::optional<time_point> first;
    for (const awaited_message& m : places_)
        if (m.size != 0 && (!first || m.due < *first)) first = m.due;
    return first;
}

JAUSCAT_CONSTEXPR std::size_t acknowledged_sender::waiting() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(places_, [](const auto& m) { return m.size != 0; }));
}

JAUSCAT_CONSTEXPR send_error acknowledged_sender::not_a_message(errc why) noexcept {
    return {.code = send_errc::invalid_message, .message = why};
}

JAUSCAT_CONSTEXPR acknowledged_sender::written
acknowledged_sender::with_error(const result<std::span<std::byte>, errc>& message) noexcept {
    if (message) return *message;
    const bool large = message.error() == errc::no_space || message.error() == errc::body_too_large;
    return large ? send_error{send_errc::too_large} : not_a_message(message.error());
}

JAUSCAT_CONSTEXPR std::uint16_t acknowledged_sender::counted(std::uint16_t number) noexcept {
    return std::max<std::uint16_t>(number, 1);
}

JAUSCAT_CONSTEXPR std::uint16_t acknowledged_sender::following(std::uint16_t number) noexcept {
    return counted(static_cast<std::uint16_t>(number + 1));
}

JAUSCAT_CONSTEXPR std::uint16_t acknowledged_sender::free_number(const header& head) const noexcept {
    std::uint16_t number = next_;
    while (std::ranges::any_of(places_, [&](const awaited_message& m) {
        return m.size != 0 && m.header.sequence_number == number && m.header.command_code == head.command_code &&
               m.header.destination == head.destination;
    }))
        number = following(number);
    return number;
}

JAUSCAT_CONSTEXPR std::span<std::byte> acknowledged_sender::copy_of(const awaited_message& place) const noexcept {
    const std::size_t share = copies_.size() / places_.size();
    return copies_.subspan(static_cast<std::size_t>(&place - places_.data()) * share, share);
}

} // namespace jauscat::jaus
