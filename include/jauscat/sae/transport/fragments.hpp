// Messages of several packets: a payload is cut, and put together in memory of the caller. AS5669A, data flags.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/sae/transport/message.hpp>

#include <algorithm>
#include <chrono>
#include <span>
#include <string_view>

namespace jauscat::sae {

/// A payload cut into parts, one for each packet. Their sequence numbers follow each other.
class cut_payload {
  public:
    /// `most`: bytes in one packet, at least 1.
    constexpr cut_payload(std::span<const std::byte> payload, std::size_t most) noexcept
        : payload_{payload},
          most_{std::max<std::size_t>(most, 1)},
          packets_{std::max<std::size_t>((payload.size() + most_ - 1) / most_, 1)} {}

    /// At least 1.
    [[nodiscard]] constexpr std::size_t packets() const noexcept { return packets_; }
    /// The bytes of packet `number`, from 0.
    [[nodiscard]] constexpr std::span<const std::byte> part(std::size_t number) const noexcept {
        return payload_.subspan(number * most_, std::min(most_, payload_.size() - number * most_));
    }
    [[nodiscard]] constexpr fragment_flag flag(std::size_t number) const noexcept {
        if (packets_ == 1) return fragment_flag::single;
        if (number == 0) return fragment_flag::first;
        return number + 1 == packets_ ? fragment_flag::last : fragment_flag::middle;
    }

  private:
    std::span<const std::byte> payload_;
    std::size_t most_;
    std::size_t packets_;
};

/// Result of a packet with a part of a message.
enum class fragment_outcome : std::uint8_t {
    waiting,     ///< kept; other parts are missing
    whole,       ///< the last missing part: the payload is complete
    repeated,    ///< it is held already
    no_capacity, ///< dropped: every place, or the share of its node, is taken
    too_large,   ///< dropped together with its message, which has more bytes than the memory
};

/// The result in one line, for logs.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(fragment_outcome outcome) noexcept;

/// A packet that is held.
struct held_fragment {
    bool is_used{};            ///< whether the place is taken
    jaus_id source{};          ///< of its header
    jaus_id destination{};     ///< of its header
    std::uint16_t number{};    ///< its sequence number
    sae::fragment_flag flag{}; ///< of its header
    std::size_t size{};        ///< bytes of its payload
    time_point received_at{};  ///< when it came
};

/// Puts messages together by source, destination and sequence numbers that follow each other. Packets may be reordered
/// and repeated. All memory is the caller's.
///
/// A packet is dropped when it has waited for the timeout: longer than a sender repeats. One that is acknowledged is
/// never dropped before, so a full memory refuses new packets.
class fragment_reassembler {
  public:
    struct received {
        fragment_outcome outcome{};           ///< what became of the packet
        std::span<const std::byte> payload{}; ///< of the whole message; valid until the next packet
        std::uint16_t first_number{};         ///< sequence number of its first packet
    };

    /// `places` and `parts` hold packets: each place has an equal share of `parts`, which holds the payload of one
    /// packet. `whole` holds the payload of one message, and so limits it.
    JAUSCAT_CONSTEXPR fragment_reassembler(std::span<held_fragment> places, std::span<std::byte> parts,
                                           std::span<std::byte> whole,
                                           duration timeout = std::chrono::seconds{10}) noexcept;

    /// Processes a packet whose flag is not `single`.
    [[nodiscard]] JAUSCAT_CONSTEXPR received on_packet(const transport_header& head, std::span<const std::byte> payload,
                                                       std::uint16_t number, time_point now) noexcept;
    /// Number of packets that are held.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t held() const noexcept;

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR held_fragment* find(const transport_header& head,
                                                        std::uint16_t number) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR held_fragment* free_place(const jaus_id& source) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<std::byte> bytes_of(const held_fragment& place) const noexcept;
    JAUSCAT_CONSTEXPR void drop_old(time_point now) noexcept;
    JAUSCAT_CONSTEXPR void drop(const transport_header& head, std::uint16_t from, std::uint16_t to) noexcept;

    std::span<held_fragment> places_;
    std::span<std::byte> parts_;
    std::span<std::byte> whole_;
    duration timeout_;
};

} // namespace jauscat::sae

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/sae/transport/impl/fragments.ipp>
#endif
