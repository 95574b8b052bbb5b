// Large data sets sent: a body that does not fit one packet is cut into several, one at each call, so that the caller
// paces them. RA 3.3 part 2, large data sets. The receiving side is reassembler.hpp.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/message/message_sink.hpp>

#include <algorithm>

namespace jauscat::jaus {

/// Splits one body into packets: data flag first, middle or last, sequence number from 0, the rest of the header on
/// each. A body that fits one packet is sent in one, with the sequence number of the header.
///
///     std::array<std::byte, jaus::header_size + jaus::max_body_size> packet{};
///     jaus::large_data_sender image{{.command_code = 0x4807, .destination = ocu, .source = camera}, jpeg, packet};
///     if (image.error() != jaus::errc::ok) ...
///     while (image.next(send)) wait_a_little();
///
/// The RA has no message that requests a packet again. A sender that needs an acknowledgement of each packet sets
/// `head.ack_nak`, and repeats the packets that are not acknowledged.
class large_data_sender {
  public:
    /// Packets that sequence numbers can count.
    static constexpr std::size_t max_packets = 65536;

    /// `head` gives all of the packets' headers but data size, data flag and, where there are several, sequence number.
    /// `packet` holds one packet: its bytes after the header are filled, up to 4080. `body` and `packet` must outlive
    /// this.
    constexpr large_data_sender(const header& head, std::span<const std::byte> body,
                                std::span<std::byte> packet) noexcept
        : header_{head}, body_{body}, packet_{packet} {
        if (packet.size() <= header_size) {
            error_ = errc::no_space;
            return;
        }
        share_ = std::min(packet.size() - header_size, max_body_size);
        packets_ = std::max<std::size_t>((body.size() + share_ - 1) / share_, 1);
        if (packets_ > max_packets) error_ = errc::body_too_large;
        header_.data_size = 0;
        if (error_ == errc::ok && !wire::encode(header_, packet_)) error_ = errc::invalid_header;
        if (error_ != errc::ok) packets_ = 0;
    }

    /// ok, or why nothing is sent: no_space (`packet` has no byte behind the header), body_too_large (more than 65536
    /// packets), invalid_header.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }
    /// Number of packets; 0 after an error.
    [[nodiscard]] constexpr std::size_t packets() const noexcept { return packets_; }
    /// Number of packets sent by next().
    [[nodiscard]] constexpr std::size_t sent() const noexcept { return sent_; }

    /// Hands the next packet to `out`; false, and nothing is sent, when there is none left.
    constexpr bool next(message_sink out) {
        if (sent_ == packets_) return false;
        put(sent_, flag_of(sent_), out);
        ++sent_;
        return true;
    }
    /// Sends packet `sequence_number` to `out` again, whether next() has sent it or not; false if there is no such
    /// packet. Its flag is `repeated`, but that of the last packet remains `last`: nothing else states how many there
    /// are, and the one sent before may be lost.
    [[nodiscard]] constexpr bool repeat(std::size_t sequence_number, message_sink out) {
        if (sequence_number >= packets_) return false;
        const bool ends = sequence_number + 1 == packets_;
        put(sequence_number, ends ? flag_of(sequence_number) : data_flag::repeated, out);
        return true;
    }
    /// The next packet is the first again.
    constexpr void restart() noexcept { sent_ = 0; }

  private:
    [[nodiscard]] constexpr data_flag flag_of(std::size_t number) const noexcept {
        if (packets_ == 1) return data_flag::only;
        if (number == 0) return data_flag::first;
        return number + 1 == packets_ ? data_flag::last : data_flag::middle;
    }
    constexpr void put(std::size_t number, data_flag flag, message_sink out) {
        const auto part = body_.subspan(number * share_, std::min(share_, body_.size() - number * share_));
        header head = header_;
        head.data_flag = flag;
        if (packets_ != 1) head.sequence_number = static_cast<std::uint16_t>(number);
        const auto message = join(head, part, packet_);
        out(*message); // encoded when this was made, with other values of the same width
    }

    header header_;
    std::span<const std::byte> body_;
    std::span<std::byte> packet_;
    std::size_t share_{}, packets_{}, sent_{};
    errc error_{};
};

} // namespace jauscat::jaus
