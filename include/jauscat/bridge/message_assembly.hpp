// Reassembles large data sets before delivery to a slave, because an SDO carries a whole message.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace jauscat::bridging {

/// Puts large data sets together, `Places` at a time and each of at most `MaxBody` bytes of body: a translator's
/// `max_body`, under the seed table 1532, or hilscher::max_sdo_data, which none exceeds. Holds its own memory, about 14
/// KiB for each place; cannot be copied.
template <std::size_t MaxBody, std::size_t Places = 4> class message_assembly {
  public:
    static_assert(MaxBody <= jaus::max_body_size, "message_assembly: a header cannot state such a size");

    /// `timeout`: a data set that has been silent so long gives its place up to another.
    explicit message_assembly(duration timeout) noexcept : large_{places_, packets_, memory_, timeout} {}
    message_assembly(const message_assembly&) = delete;
    message_assembly& operator=(const message_assembly&) = delete;

    /// A message, from its header on, received at `now`; `head` is its header. `take(std::span<const std::byte>)` gets
    /// a message that is complete, before this returns: `only` as received, `whole` as if received in one packet. The
    /// header of a `whole` is that of packet 0, with sequence number and acknowledgement of the packet that completed
    /// it, because its sender waits for an answer to that one. `too_large` and `no_capacity` mean that the data set
    /// cannot be delivered.
    jaus::reassembled on_message(const jaus::header& head, std::span<const std::byte> message, time_point now,
                                 auto&& take) {
        if (head.data_flag == jaus::data_flag::only) {
            take(message);
            return jaus::reassembled::only;
        }
        const auto deliver = [&](jaus::header whole, std::span<const std::byte> body) {
            whole.data_flag = jaus::data_flag::only;
            whole.sequence_number = head.sequence_number;
            whole.ack_nak = head.ack_nak;
            const auto made = jaus::join(whole, body, message_); // decoded from packets: it fits
            take(*made);
        };
        return large_.on_packet(head, message.subspan(jaus::header_size), now, deliver, [](const auto&) {});
    }

  private:
    std::array<jaus::partial_data_set, Places> places_{};
    std::array<jaus::held_packet, Places * MaxBody> packets_{}; // of one byte each, if a sender likes that
    std::array<std::byte, Places * MaxBody> memory_{};
    std::array<std::byte, jaus::header_size + MaxBody> message_{};
    jaus::reassembler large_;
};

} // namespace jauscat::bridging
