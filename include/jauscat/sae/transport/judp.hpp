// JUDP: messages of AS5669A in datagrams. A version byte, then one or more messages back to back.
#pragma once
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/sae/transport/message.hpp>

namespace jauscat::sae {

/// The version byte of AS5669A, in front of a datagram and of a connection.
inline constexpr std::byte transport_version{2};
/// UDP and TCP port of JAUS.
inline constexpr std::uint16_t jaus_port = 3794;
/// Multicast group of JUDP, 239.255.0.1, and the number of routers that its datagrams may pass, plus 1.
inline constexpr std::array<std::uint8_t, 4> judp_group{239, 255, 0, 1};
inline constexpr std::uint8_t judp_ttl = 16;

/// Whether a datagram is for this transport: its version byte is that of AS5669A, and it is no bare message of the RA.
[[nodiscard]] constexpr bool is_judp2(std::span<const std::byte> datagram) noexcept {
    return !datagram.empty() && datagram[0] == transport_version &&
           jaus::form_of(datagram) != jaus::datagram_form::bare;
}

/// The messages of a datagram, one after the other. One that is faulty does not hide those behind it, unless its end is
/// unknown.
///
///     for (sae::datagram_reader messages{datagram}; messages.has_next();)
///         if (const auto m = messages.next()) ...
class datagram_reader {
  public:
    /// `datagram`: by the length of UDP, because Ethernet pads short frames.
    constexpr explicit datagram_reader(std::span<const std::byte> datagram) noexcept
        : rest_{datagram.empty() ? datagram : datagram.subspan(1)},
          is_other_{datagram.empty() || datagram[0] != transport_version},
          has_next_{is_other_ || !rest_.empty()} {}

    [[nodiscard]] constexpr bool has_next() const noexcept { return has_next_; }
    /// The next message, or one error of `split`, or wrong_version.
    [[nodiscard]] constexpr split_transport_message next() noexcept {
        split_transport_message m{};
        if (is_other_)
            m.error = transport_errc::wrong_version;
        else
            m = split(rest_);
        rest_ = m.rest;
        has_next_ = !rest_.empty();
        return m;
    }

  private:
    std::span<const std::byte> rest_;
    bool is_other_;
    bool has_next_;
};

/// Writes a datagram of one message to the front of `out`; errors as `join`. Known peers read the first message only.
[[nodiscard]] constexpr result<std::span<std::byte>, transport_errc> put_datagram(const transport_header& head,
                                                                                  std::span<const std::byte> payload,
                                                                                  std::uint16_t number,
                                                                                  std::span<std::byte> out) noexcept {
    if (out.empty()) return transport_errc::no_space;
    const auto message = join(head, payload, number, out.subspan(1));
    if (!message) return message.error();
    out[0] = transport_version;
    return out.first(1 + message->size());
}

} // namespace jauscat::sae
