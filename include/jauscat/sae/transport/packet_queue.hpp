// Packets that wait to be sent, by priority, and to be acknowledged.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/sae/transport/fragments.hpp>
#include <jauscat/sae/transport/judp.hpp>

#include <chrono>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::sae {

/// What became of a message that was sent with acknowledgement request.
enum class sent_outcome : std::uint8_t {
    acknowledged, ///< by the receiver, in all its packets
    refused,      ///< by the receiver: negative reply
    timed_out,    ///< no reply in time
};

/// The outcome in one line, for logs.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(sent_outcome outcome) noexcept;

/// Outcome of a message.
struct finished_message {
    sent_outcome outcome{};       ///< what became of it
    jaus_id source{};             ///< of the message
    jaus_id destination{};        ///< of the message
    std::uint16_t first_number{}; ///< sequence number of its first packet, as `send` returned it
};

/// A packet that waits.
struct queued_packet {
    enum class state : std::uint8_t {
        free,
        queued,   ///< to be sent at `due`
        awaiting, ///< sent, and not acknowledged until `due`
        finished, ///< the message's outcome waits to be fetched
    };
    state phase{};                          ///< what it waits for
    sae::priority priority{};               ///< of its header
    bool is_repeated{};                     ///< until it is acknowledged
    jaus_id source{}, destination{};        ///< of its header
    std::uint16_t number{}, first_number{}; ///< its sequence number, and that of its message's first packet
    std::size_t size{};                     ///< bytes of its datagram
    std::uint32_t attempts{};               ///< how often it was sent
    time_point due{};                       ///< see `phase`
    std::uint64_t order{};                  ///< the higher the later, among packets of one priority
    sent_outcome outcome{};                 ///< of its message, once that is finished
};

/// Sends packets of the highest priority first, in the order in which they came, and repeats those that want an
/// acknowledgement until they get it. All memory is the caller's. A quarter of the places is for packets of priority
/// safety critical, so that others cannot keep them out.
class packet_queue {
  public:
    /// A datagram to send. Without its first byte it is a message of a stream.
    struct datagram {
        jaus_id destination{};              ///< of its header
        std::span<const std::byte> bytes{}; ///< valid until the next call
    };

    /// Each of the places has an equal share of `memory`, which holds one datagram.
    JAUSCAT_CONSTEXPR packet_queue(std::span<queued_packet> places, std::span<std::byte> memory,
                                   const retry_policy& retry) noexcept;

    /// Bytes of payload that a place holds.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t payload_capacity() const noexcept;
    /// Takes all packets of a message, or none. The numbers follow each other from `first_number`. With
    /// `is_repeated` the packets ask for acknowledgement until they get it, and the message has an outcome; without it
    /// they ask for it, if `head` does, once. Errors: no_capacity, too_large (more packets than places), and those of
    /// join.
    [[nodiscard]] JAUSCAT_CONSTEXPR result<void, transport_errc> put(const transport_header& head,
                                                                     const cut_payload& payload,
                                                                     std::uint16_t first_number, bool is_repeated,
                                                                     time_point now) noexcept;
    /// The next datagram that is due at `now`, which counts as sent; nothing where none is due.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<datagram> next_datagram(time_point now) noexcept;
    /// A reply to a packet; false if none waits for it.
    JAUSCAT_CONSTEXPR bool on_reply(const transport_header& head, std::uint16_t number) noexcept;
    /// The next outcome. A message keeps a place until its outcome is fetched.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<finished_message> next_outcome() noexcept;
    /// When `next_datagram` has something to do.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;
    /// Number of places that are taken.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t waiting() const noexcept;

  private:
    using state = queued_packet::state;
    JAUSCAT_CONSTEXPR void finish(queued_packet& packet, sent_outcome outcome) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<std::byte> bytes_of(const queued_packet& place) const noexcept;

    std::span<queued_packet> places_;
    std::span<std::byte> memory_;
    retry_policy retry_;
    std::uint64_t order_{};
};

} // namespace jauscat::sae

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/sae/transport/impl/packet_queue.ipp>
#endif
