// The functions of acknowledged_receiver.
#pragma once
#include <jauscat/jaus/component/acknowledged_receiver.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR acknowledged_receiver::acknowledged_receiver(const address& self,
                                                               std::span<acknowledged_message> places,
                                                               duration memory) noexcept
    : self_{self}, places_{places}, memory_{memory} {}

JAUSCAT_CONSTEXPR void acknowledged_receiver::on_change() noexcept {
    end_unnumbered(at_, [](const address&) { return true; });
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::finish(const header& head, bool executed, time_point now,
                                                     message_sink out) noexcept {
    if (!is_acknowledged(head)) return false;
    const ack_nak answer = executed ? ack_nak::ack : ack_nak::nak;
    if (may_be_repeated(head.command_code)) return acknowledge(head, self_, answer, out).has_value();
    acknowledged_message* const place = first_pending(head);
    if (place == nullptr) return false;
    place->until = saturating_add(now, memory_);
    settle(*place, head, answer, out);
    return true;
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::is_acknowledged(const header& head) noexcept {
    return head.ack_nak == ack_nak::request && names_one_component(head.destination);
}

JAUSCAT_CONSTEXPR ack_nak acknowledged_receiver::answer_of(message_outcome outcome) noexcept {
    return outcome == message_outcome::handled ? ack_nak::ack : ack_nak::nak;
}

JAUSCAT_CONSTEXPR void acknowledged_receiver::settle(acknowledged_message& place, const header& head, ack_nak answer,
                                                     message_sink out) noexcept {
    place.answer = answer;
    static_cast<void>(acknowledge(head, self_, answer, out)); // its header was received
}

JAUSCAT_CONSTEXPR acknowledged_message* acknowledged_receiver::first_pending(const header& head) const noexcept {
    acknowledged_message* first = nullptr;
    for (acknowledged_message& m : used()) {
        const bool is_it = m.answer == ack_nak::request && m.source == head.source &&
                           m.command_code == head.command_code && m.sequence_number == head.sequence_number;
        if (is_it && (first == nullptr || m.until < first->until)) first = &m;
    }
    return first;
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::may_be_repeated(std::uint16_t command_code) noexcept {
    return command_code == command_code_of<set_emergency> || report_code_of(command_code) != 0;
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::is_command(std::uint16_t command_code) noexcept {
    return command_code < 0x2000 || command_code >= 0x6000; // or private, and not known to be none
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::is_pending(const acknowledged_message& m) noexcept {
    return m.answer == ack_nak::request;
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::is_free(const acknowledged_message& m, time_point now) noexcept {
    return !is_pending(m) && (m.answer == ack_nak::none || m.superseded || m.until <= now);
}

JAUSCAT_CONSTEXPR acknowledged_receiver::search
acknowledged_receiver::find(const acknowledged_message& key, time_point now, const address* controller) noexcept {
    search found{};
    const acknowledged_message* used_again = nullptr; // the last message that had this number
    const auto is_over = [&](const acknowledged_message& m) { return !is_pending(m) && m.until <= now; };
    while (used_ != 0 && is_over(places_[used_ - 1])) --used_;
    for (acknowledged_message& m : used()) {
        const bool is_same_message = m.source == key.source && m.sequence_number == key.sequence_number &&
                                     m.command_code == key.command_code && m.digest == key.digest;
        if (!is_free(m, now) && (controller == nullptr || m.source != *controller)) ++found.of_others;
        if (is_free(m, now)) {
            if (found.free == nullptr || (is_over(m) && !is_over(*found.free))) found.free = &m;
            const bool was_done = m.superseded && m.answer == ack_nak::ack && !is_over(m);
            found.may_be_done |= was_done && is_same_message && key.sequence_number == 0;
        } else if (m.source == key.source) {
            ++found.of_source;
            // It is pending, and its answer is still to come: a refusal of the new one would look like that answer.
            found.may_be_done |= m.superseded && is_pending(m) && is_same_message && key.sequence_number == 0;
            if (m.superseded || m.sequence_number != key.sequence_number) continue;
            if (is_same_message)
                found.same = &m;
            else if (used_again == nullptr || used_again->until < m.until)
                used_again = &m;
        }
    }
    const bool has_more = used_ != places_.size();
    if (has_more && (found.free == nullptr || !is_over(*found.free))) found.free = &places_[used_];
    if (used_again == nullptr) return found;
    const auto used_until = used_again->until;
    for (acknowledged_message& m : used())
        if (m.source == key.source &&
            (key.sequence_number == 0 ? m.sequence_number == 0 : !is_later(m, key, used_until)))
            m.superseded = true;
    return find(key, now, controller);
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::is_later(const acknowledged_message& m, const acknowledged_message& key,
                                                       time_point used_until) noexcept {
    return m.sequence_number != 0 && m.until > used_until &&
           static_cast<std::int16_t>(m.sequence_number - key.sequence_number) < 0;
}

JAUSCAT_CONSTEXPR bool acknowledged_receiver::shows_count(const acknowledged_message& other,
                                                          const acknowledged_message& zero) noexcept {
    if (other.source != zero.source || other.sequence_number == 0) return false;
    const bool is_next = other.until == zero.until && other.sequence_number <= 0xFF;
    return is_next || other.sequence_number >= 0xFF00 || other.until > zero.until;
}

JAUSCAT_CONSTEXPR std::uint32_t acknowledged_receiver::digest_of(std::span<const std::byte> body) noexcept {
    std::uint32_t digest = 0x811C9DC5;
    for (const std::byte b : body) digest = (digest ^ std::to_integer<std::uint32_t>(b)) * 0x01000193;
    return digest;
}

} // namespace jauscat::jaus
