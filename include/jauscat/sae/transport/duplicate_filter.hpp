// Recognises packets that were received before.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/sae/transport/message.hpp>

#include <chrono>
#include <span>

namespace jauscat::sae {

/// A packet that was received.
struct seen_packet {
    jaus_id source{};       ///< of its header
    std::uint16_t number{}; ///< its sequence number
    std::uint32_t digest{}; ///< of its payload
    bool is_acknowledged{}; ///< its source repeats it until it gets the acknowledgement
    time_point until{};     ///< how long it is remembered; the place is free then
};

/// Result of a packet.
enum class seen : std::uint8_t {
    fresh,       ///< remembered from now on
    repeated,    ///< received before
    no_capacity, ///< every place, or the share of its node, is taken: not to be processed nor acknowledged
};

/// Remembers packets by source, sequence number and payload for some time, in memory of the caller. The payload is
/// compared, too, so that a source that restarts and counts from the same number is heard.
///
/// A packet with acknowledgement request is remembered for the whole time, or refused, so that it is never processed
/// twice. Another packet takes the place of the oldest one of its kind if all are taken.
class duplicate_filter {
  public:
    /// `window`: longer than a source repeats a packet and the network delays it.
    JAUSCAT_CONSTEXPR explicit duplicate_filter(std::span<seen_packet> places,
                                                duration window = std::chrono::seconds{3}) noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR seen on_packet(const transport_header& head, std::span<const std::byte> payload,
                                                   std::uint16_t number, time_point now) noexcept;
    /// A packet that was fresh is not processed after all: its repeat will be fresh again.
    JAUSCAT_CONSTEXPR void forget(const transport_header& head, std::span<const std::byte> payload,
                                  std::uint16_t number) noexcept;

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::uint32_t digest_of(const transport_header& head,
                                                                   std::span<const std::byte> payload) noexcept;

    std::span<seen_packet> places_;
    duration window_;
};

} // namespace jauscat::sae

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/sae/transport/impl/duplicate_filter.ipp>
#endif
