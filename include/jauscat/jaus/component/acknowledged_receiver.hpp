// Acknowledges messages that request it, and filters repetitions. RA 3.3 part 2, ACK/NAK.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <algorithm>
#include <chrono>

namespace jauscat::jaus {

/// A message that was acknowledged: a place in the memory of an acknowledged_receiver.
struct acknowledged_message {
    address source{};
    std::uint16_t command_code{};    ///< which message
    std::uint16_t sequence_number{}; ///< by which a repeat is known
    std::uint32_t digest{};          ///< of the body
    ack_nak answer{};                ///< the one that was given; request: still pending; none: the place is free
    bool superseded{};               ///< the same message again is a new one
    time_point until{};              ///< when it is forgotten, unless it is pending
};

/// Result of a received message.
enum class received : std::uint8_t {
    handed_on,   ///< delivered; acknowledged by the handler's outcome if requested, or by `finish`
    repeated,    ///< delivered before: acknowledged again with the same answer, and dropped
    pending,     ///< delivered before and not finished yet: dropped without an answer
    no_capacity, ///< dropped without an answer, because its repeats could not be recognised: the sender will retry
};

/// What a component knows of a message before it is handled.
struct receiver_context {
    bool is_refused{};           ///< `handle` refuses it by a rule: it is not remembered, and takes no place
    bool is_of_controller{true}; ///< its source has control; of others, three quarters of the places at most
    const address* controller{}; ///< nullptr: none
};

/// Delivers messages and acknowledges them: ACK if the handler has executed one, NAK if not. Messages without
/// acknowledgement request are delivered without this check, as are messages to a broadcast address: these are not
/// acknowledged, because all receivers would answer at once.
///
/// A repeat has source, command code, sequence number and body of a message received within `memory`. The RA sets no
/// time: it must be longer than a sender repeats (a second with acknowledged_sender's defaults) and than copies are
/// delayed by the network, and shorter than a sender needs to use its 65536 numbers. Within it no message is delivered
/// twice: when all places are used, or one source has half of them, its next message is dropped. So there must be twice
/// as many places as one source sends messages with acknowledgement request within `memory`. A quarter of the places is
/// kept for the controller. What a rule refuses is not remembered: its repeat is refused again.
///
/// A handler may defer its message: it is then pending, and its repeats are dropped without an answer, until `finish`
/// acknowledges it. A pending message keeps its place however long that takes.
///
/// Some nodes number all messages 0, and some programs restart with the same numbers. So the body is compared too, and
/// a number that is used for another message removes remembered messages: the number 0 those with this number, any
/// other number all that the source sent before it restarted, as it must have. A message that cannot be distinguished
/// from a repeat counts as one: an old command must not move anything again.
///
/// Of a source that has used only the number 0, any event in between makes the same message a new one: another command
/// of the source, also one that is not remembered, an executed command of another source, and a change by the component
/// itself (`on_change`). Standby after Standby and Resume is not a repeat, nor is Resume after Resume and a failure. If
/// it is then refused, it is not answered: it may be a repeat of an executed message.
///
/// Set Emergency and queries are always delivered and never remembered: a new emergency must not count as a repeat, and
/// the answer to a query may have been lost.
class acknowledged_receiver {
  public:
    /// `places` must outlive this.
    JAUSCAT_CONSTEXPR acknowledged_receiver(const address& self, std::span<acknowledged_message> places,
                                            duration memory = std::chrono::seconds{2}) noexcept;

    /// Processes a message that is not an acknowledgement. `handle()` executes it and returns a message_outcome; the
    /// answer is sent after it.
    constexpr received on_message(const header& head, std::span<const std::byte> body, time_point now, message_sink out,
                                  auto&& handle, const receiver_context& known = {}) {
        at_ = now;
        const bool wants_answer = is_acknowledged(head);
        const auto obey = [&] {
            const message_outcome outcome = handle();
            const bool is_obeyed = outcome == message_outcome::handled || outcome == message_outcome::deferred;
            if (is_obeyed && is_command(head.command_code))
                end_unnumbered(now, [&](const address& source) { return source != head.source; });
            return outcome;
        };
        if (!wants_answer || may_be_repeated(head.command_code)) {
            if (is_command(head.command_code) && head.sequence_number == 0) {
                const auto is_its = [&](const address& source) { return source == head.source; };
                wants_answer ? end_zero(is_its) : end_unnumbered(now, is_its);
            }
            const message_outcome outcome = obey();
            if (wants_answer && outcome != message_outcome::deferred)
                static_cast<void>(acknowledge(head, self_, answer_of(outcome), out)); // its header was received
            return received::handed_on;
        }
        const acknowledged_message key{head.source, head.command_code, head.sequence_number, digest_of(body)};
        const search found = find(key, now, known.controller);
        if (found.same != nullptr) {
            if (found.same->answer == ack_nak::request) return received::pending;
            static_cast<void>(acknowledge(head, self_, found.same->answer, out)); // its header was received
            return received::repeated;
        }
        if (known.is_refused) {
            static_cast<void>(handle());
            if (!found.may_be_done) static_cast<void>(acknowledge(head, self_, ack_nak::nak, out));
            return received::handed_on;
        }
        const bool is_kept_free = !known.is_of_controller && 4 * found.of_others >= 3 * places_.size();
        if (found.free == nullptr || 2 * found.of_source >= places_.size() || is_kept_free)
            return received::no_capacity;
        acknowledged_message& place = *found.free;
        place = key;
        used_ = std::max(used_, static_cast<std::size_t>(&place - places_.data()) + 1);
        place.answer = ack_nak::request; // pending while it is handled
        place.until = saturating_add(now, memory_);
        knows_unnumbered_ = knows_unnumbered_ || key.sequence_number == 0;
        const message_outcome outcome = obey();
        if (outcome == message_outcome::deferred) return received::handed_on;
        if (found.may_be_done && answer_of(outcome) == ack_nak::nak) { // no answer, and none to the next one
            place.answer = ack_nak::ack;
            place.superseded = true;
        } else {
            settle(place, head, answer_of(outcome), out);
        }
        return received::handed_on;
    }
    /// The component has changed without a message: its state, or its controller.
    JAUSCAT_CONSTEXPR void on_change() noexcept;
    /// Acknowledges a message that its handler deferred: ACK if it was executed, NAK if not. The answer is remembered
    /// for `memory` from now on. Several with the same header are finished in order of arrival. False: the message is
    /// not pending, or requested no acknowledgement; nothing is sent.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool finish(const header& head, bool executed, time_point now,
                                                message_sink out) noexcept;

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_acknowledged(const header& head) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static ack_nak answer_of(message_outcome outcome) noexcept;
    JAUSCAT_CONSTEXPR void settle(acknowledged_message& place, const header& head, ack_nak answer,
                                  message_sink out) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR acknowledged_message* first_pending(const header& head) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool may_be_repeated(std::uint16_t command_code) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_command(std::uint16_t command_code) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_pending(const acknowledged_message& m) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_free(const acknowledged_message& m, time_point now) noexcept;
    struct search {
        acknowledged_message* same{};
        acknowledged_message* free{};
        std::size_t of_source{}; // places that the source has
        std::size_t of_others{}; // places that all have but the controller
        bool may_be_done{};      // executed or pending, or it is new; its number does not tell
    };
    [[nodiscard]] JAUSCAT_CONSTEXPR search find(const acknowledged_message& key, time_point now,
                                                const address* controller) noexcept;
    // Behind them no place is in use.
    [[nodiscard]] constexpr std::span<acknowledged_message> used() const noexcept { return places_.first(used_); }
    // Whether a message of the restarted source `key` was sent after its restart: before `key`, by its number, and
    // received after the message that had the number of `key`.
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_later(const acknowledged_message& m, const acknowledged_message& key,
                                                         time_point used_until) noexcept;
    // A sender that counts uses the number 0 once in 65536 commands: a new command with 0 ends the entries of earlier
    // ones.
    constexpr void end_zero(auto&& concerns) noexcept {
        for (acknowledged_message& m : used())
            if (m.sequence_number == 0 && concerns(m.source)) m.superseded = true;
    }
    // Ends the entries of sources for which `concerns` is true and that number all messages 0.
    constexpr void end_unnumbered(time_point now, auto&& concerns) noexcept {
        if (!knows_unnumbered_) return;
        const auto is_known = [&](const acknowledged_message& m) { return !is_free(m, now) && !m.superseded; };
        knows_unnumbered_ = false;
        for (acknowledged_message& m : used()) {
            if (m.sequence_number != 0 || !is_known(m)) continue;
            const bool counts = std::ranges::any_of(
                used(), [&](const acknowledged_message& other) { return is_known(other) && shows_count(other, m); });
            // A sender that counts gives the number 0 to one command only.
            const bool repeats_zero = std::ranges::any_of(used(), [&](const acknowledged_message& other) {
                return other.superseded && now < other.until && other.source == m.source && other.sequence_number == 0;
            });
            if (concerns(m.source) && (repeats_zero || !counts))
                m.superseded = true;
            else
                knows_unnumbered_ = true;
        }
    }
    // Whether the number 0 of `zero` is one of a sender that counts: others came after it, or the last numbers before
    // it. Other messages before may be from a program that counted and was restarted as one that does not; so may those
    // of the same instant, because they may have waited in the socket.
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool shows_count(const acknowledged_message& other,
                                                            const acknowledged_message& zero) noexcept;
    // FNV-1a of 32 bits.
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::uint32_t digest_of(std::span<const std::byte> body) noexcept;

    address self_;
    std::span<acknowledged_message> places_;
    std::size_t used_{};
    duration memory_;
    time_point at_{};         // of the last message
    bool knows_unnumbered_{}; // a message with the number 0 may be remembered
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/acknowledged_receiver.ipp>
#endif
