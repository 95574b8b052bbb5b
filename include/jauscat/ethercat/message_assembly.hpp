// Between a JAUS transport and the delivery to slaves: one message of each large data set, because an SDO carries it
// whole or not at all.
#pragma once

#include <jauscat/jaus/large_data_set.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <span>

namespace jauscat::ethercat {

/// Puts large data sets together, `Places` at a time, as far as one SDO packet of `Table` carries them: `max_body`
/// bytes. Holds its own memory, about 8 KiB for each place; cannot be copied.
template <class Table, std::size_t Places = 4> class message_assembly {
  public:
    using translator = translate::translator<Table>;
    /// Bytes of body that one SDO packet carries: under the seed table 1532 of 1540 bytes of data.
    static constexpr std::size_t max_body = translator::max_body;
    static_assert(max_body <= jaus::max_body_size, "message_assembly: a header cannot state such a size");

    /// `patience`: a data set that has been silent so long gives its place up to another.
    explicit message_assembly(std::chrono::nanoseconds patience) noexcept
        : large_{places_, packets_, memory_, patience} {}
    message_assembly(const message_assembly&) = delete;
    message_assembly& operator=(const message_assembly&) = delete;

    /// A message, header on, that came at `now`; `head` is its header. `take(std::span<const std::byte>)` gets a
    /// message that is complete, before this returns: `only` as it came, `whole` as if it had come in one packet, with
    /// sequence number and properties of packet 0. `too_large`, and `no_room`, mean that the data set cannot be
    /// delivered.
    jaus::reassembled on_message(const jaus::header& head, std::span<const std::byte> message,
                                 std::chrono::nanoseconds now, auto&& take) {
        if (head.data_flag == jaus::data_flag::only) {
            take(message);
            return jaus::reassembled::only;
        }
        const auto join = [&](jaus::header whole, std::span<const std::byte> body) {
            whole.data_flag = jaus::data_flag::only;
            whole.data_size = static_cast<std::uint16_t>(body.size());
            static_cast<void>(wire::encode(whole, message_));
            std::ranges::copy(body, std::span{message_}.subspan(jaus::header_size).begin());
            take(std::span<const std::byte>{message_}.first(jaus::header_size + body.size()));
        };
        return large_.on_packet(head, message.subspan(jaus::header_size), now, join, [](const auto&) {});
    }

  private:
    std::array<jaus::partial_data_set, Places> places_{};
    std::array<jaus::held_packet, Places * max_body> packets_{}; // of one byte each, if a sender likes that
    std::array<std::byte, Places * max_body> memory_{};
    std::array<std::byte, translator::max_message_size> message_{};
    jaus::reassembler large_;
};

} // namespace jauscat::ethercat
