// Builds an Ethernet frame of datagrams; sets "more" bits, lengths and padding.
#pragma once

#include <jauscat/ethercat/frame_errc.hpp>
#include <jauscat/schema/ethercat/datagram.hpp>
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Bytes of the Ethernet and the EtherCAT header.
inline constexpr std::size_t frame_header_size = wire::max_size<ethernet_header> + wire::max_size<frame_header>;
/// Bytes that a datagram takes besides its data.
inline constexpr std::size_t datagram_overhead = wire::max_size<datagram_header> + wire::max_size<datagram_trailer>;

/// Broadcast header. A link replaces the zero source address with its own.
inline constexpr ethernet_header broadcast_ethernet_header = [] {
    ethernet_header header{};
    header.destination.fill(std::byte{0xFF});
    header.ether_type = ether_type_ethercat;
    return header;
}();

/// Builds one frame in a caller's buffer. An error sticks: `finish` reports it.
class frame_builder {
  public:
    /// `out` holds the frame; 1514 bytes suffice for any. `index` tags every datagram added by command.
    constexpr explicit frame_builder(std::span<std::byte> out, std::uint8_t index = 0,
                                     const ethernet_header& ethernet = broadcast_ethernet_header) noexcept
        : out_{out.first(std::min(out.size(), max_frame_size))}, index_{index}, next_index_{index} {
        if (out_.size() < frame_header_size || !wire::encode(ethernet, out_)) error_ = frame_errc::no_space;
    }

    /// Tags every datagram after the first with `index`, if added by command.
    constexpr void tag_rest(std::uint8_t index) noexcept { next_index_ = index; }

    /// Adds a datagram and returns its data, zeroed, to be filled in; empty after an error or if `header.length` is 0.
    /// `header.more` is set as needed; the working counter starts at 0.
    constexpr std::span<std::byte> add(datagram_header header) noexcept {
        if (error_ != frame_errc::ok) return {};
        if (header.length > max_datagram_data || out_.size() - end_ < datagram_overhead + header.length) {
            error_ = frame_errc::no_space;
            return {};
        }
        if (last_ != 0) announce_another();
        header.more = false;
        if (!wire::encode(header, out_.subspan(end_))) {
            error_ = frame_errc::field_out_of_range;
            return {};
        }
        last_ = end_;
        ++datagrams_;
        const auto body =
            out_.subspan(end_ + wire::max_size<datagram_header>, header.length + wire::max_size<datagram_trailer>);
        std::ranges::fill(body, std::byte{});
        end_ += datagram_overhead + header.length;
        return body.first(header.length);
    }

    /// Adds a datagram that carries `length` zero bytes to be filled in, or to be replaced by what a slave reads.
    constexpr std::span<std::byte> add(command cmd, std::uint16_t adp, std::uint16_t ado, std::size_t length) noexcept {
        // A length that does not fit the field is refused as too large for a frame.
        const auto checked = static_cast<std::uint16_t>(std::min(length, max_datagram_data + 1));
        const auto index = last_ == 0 ? index_ : next_index_;
        return add(datagram_header{.cmd = cmd, .index = index, .adp = adp, .ado = ado, .length = checked});
    }

    /// Adds a datagram that carries `data`.
    constexpr void add(command cmd, std::uint16_t adp, std::uint16_t ado, std::span<const std::byte> data) noexcept {
        const auto room = add(cmd, adp, ado, data.size());
        if (room.size() == data.size()) std::ranges::copy(data, room.begin());
    }

    /// Adds a datagram that carries one message, such as a register's layout.
    template <wire::message T>
    constexpr void add(command cmd, std::uint16_t adp, std::uint16_t ado, const T& message) noexcept {
        const auto room = add(cmd, adp, ado, wire::encoded_size(message));
        if (!room.empty() && !wire::encode(message, room)) error_ = frame_errc::field_out_of_range;
    }

    /// Adds a read of a register in the slave with this station address. `Register`: esc_register_of.
    template <class Register> constexpr void read(std::uint16_t station, const Register& at) noexcept {
        add(command::fprd, station, at.address, wire::max_size<typename Register::value_type>);
    }
    /// Adds a write of a register in the slave with this station address.
    template <class Register>
    constexpr void write(std::uint16_t station, const Register& at,
                         const typename Register::value_type& value) noexcept {
        add(command::fpwr, station, at.address, value);
    }
    /// The same in all slaves at once: what comes back is or-ed.
    template <class Register> constexpr void read_all(const Register& at) noexcept {
        add(command::brd, 0, at.address, wire::max_size<typename Register::value_type>);
    }
    template <class Register>
    constexpr void write_all(const Register& at, const typename Register::value_type& value) noexcept {
        add(command::bwr, 0, at.address, value);
    }

    /// Datagrams that were added.
    [[nodiscard]] constexpr std::size_t datagrams() const noexcept { return datagrams_; }
    /// Bytes left for datagrams, their overhead included.
    [[nodiscard]] constexpr std::size_t room() const noexcept { return out_.size() - end_; }

    /// Writes the length and pads with zeros to 60 bytes. Returns the frame, without check sequence.
    /// Errors: empty, no_space, field_out_of_range.
    [[nodiscard]] constexpr result<std::span<std::byte>, frame_errc> finish() noexcept {
        if (error_ == frame_errc::ok && last_ == 0) error_ = frame_errc::empty;
        const std::size_t size = std::max(end_, min_frame_size);
        if (error_ == frame_errc::ok && out_.size() < size) error_ = frame_errc::no_space;
        if (error_ != frame_errc::ok) return error_;
        const frame_header header{.length = static_cast<std::uint16_t>(end_ - frame_header_size),
                                  .type = frame_type::datagrams};
        static_cast<void>(wire::encode(header, out_.subspan(wire::max_size<ethernet_header>)));
        std::ranges::fill(out_.subspan(end_, size - end_), std::byte{});
        return out_.first(size);
    }

  private:
    constexpr void announce_another() noexcept {
        datagram_header previous{};
        static_cast<void>(wire::decode_prefix(previous, out_.subspan(last_)));
        previous.more = true;
        static_cast<void>(wire::encode(previous, out_.subspan(last_)));
    }

    std::span<std::byte> out_;
    std::uint8_t index_, next_index_;
    frame_errc error_{};
    std::size_t end_ = frame_header_size;
    std::size_t datagrams_{};
    std::size_t last_ = 0; // where the last datagram starts; 0: none yet
};

} // namespace jauscat::ethercat
