// Checks a received frame and iterates over its datagrams. Uses the announced length, not the frame's size.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_errc.hpp>
#include <jauscat/schema/ethercat/datagram.hpp>
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/wire/decode.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

namespace jauscat::ethercat {

/// A datagram of a frame. `Byte` is not const where a slave changes it in place.
template <class Byte> struct basic_datagram {
    datagram_header header{};
    std::uint16_t working_counter{};
    std::span<Byte> data{};
    std::span<Byte> bytes{}; ///< header, data and trailer

    /// The register that was read; zeros where the data have another size. `Register`: esc_register_of.
    template <class Register>
    [[nodiscard]] constexpr typename Register::value_type value(const Register&) const noexcept {
        typename Register::value_type value{};
        static_cast<void>(wire::decode(value, data));
        return value;
    }
};

/// The datagrams of a checked frame: `frame_view view; if (view.parse(bytes)) for (auto datagram : view) ...`.
template <class Byte> class basic_frame_view {
  public:
    /// Checks all of `frame`, a VLAN tag allowed, and returns the number of bytes used, padding excluded.
    /// Errors: too_short, not_ethercat, not_datagrams, length_beyond_frame, truncated_datagram, length_mismatch.
    /// After an error the view is empty.
    [[nodiscard]] constexpr result<std::size_t, frame_errc> parse(std::span<Byte> frame) noexcept {
        datagrams_ = {};
        std::size_t at = 0;
        frame_header header{};
        if (const auto wrong = parse_head(frame, at, header); wrong != frame_errc::ok) return wrong;
        if (frame.size() - at < header.length) return frame_errc::length_beyond_frame;
        const auto datagrams = frame.subspan(at, header.length);
        frame_errc why{};
        const std::size_t walked = walk(datagrams, why);
        if (why != frame_errc::ok) return why;
        if (walked != datagrams.size()) return frame_errc::length_mismatch;
        datagrams_ = datagrams;
        return at + walked;
    }
    /// As a slave controller does: the length in the frame's header is not looked at. The datagrams are those up to the
    /// last one, or to one that the frame does not hold whole; there may be none. Errors: too_short, not_ethercat,
    /// not_datagrams.
    [[nodiscard]] constexpr result<void, frame_errc> parse_datagrams(std::span<Byte> frame) noexcept {
        datagrams_ = {};
        std::size_t at = 0;
        frame_header header{};
        if (const auto wrong = parse_head(frame, at, header); wrong != frame_errc::ok) return wrong;
        frame_errc why{};
        datagrams_ = frame.subspan(at, walk(frame.subspan(at), why));
        return {};
    }

    class iterator {
      public:
        using value_type = basic_datagram<Byte>;
        using difference_type = std::ptrdiff_t;

        constexpr iterator() noexcept = default;
        /// At the first datagram of what is left of the frame.
        constexpr explicit iterator(std::span<Byte> rest) noexcept : rest_{rest} {}

        constexpr value_type operator*() const noexcept {
            value_type datagram{};
            const std::size_t header = *wire::decode_prefix(datagram.header, rest_);
            datagram.data = rest_.subspan(header, datagram.header.length);
            datagram.bytes = rest_.first(datagram_overhead + datagram.header.length);
            datagram_trailer trailer{};
            static_cast<void>(wire::decode_prefix(trailer, rest_.subspan(header + datagram.header.length)));
            datagram.working_counter = trailer.working_counter;
            return datagram;
        }
        constexpr iterator& operator++() noexcept {
            rest_ = rest_.subspan((**this).bytes.size());
            return *this;
        }
        constexpr iterator operator++(int) noexcept {
            const auto before = *this;
            ++*this;
            return before;
        }
        constexpr bool operator==(std::default_sentinel_t) const noexcept { return rest_.empty(); }
        constexpr bool operator==(const iterator& other) const noexcept { return rest_.size() == other.rest_.size(); }

      private:
        std::span<Byte> rest_{};
    };

    [[nodiscard]] constexpr iterator begin() const noexcept { return iterator{datagrams_}; }
    [[nodiscard]] constexpr std::default_sentinel_t end() const noexcept { return {}; }

  private:
    /// Up to the datagrams, which begin at `at`.
    static constexpr frame_errc parse_head(std::span<Byte> frame, std::size_t& at, frame_header& header) noexcept {
        ethernet_header ethernet{};
        auto used = wire::decode_prefix(ethernet, frame);
        if (!used) return frame_errc::too_short;
        at = *used;
        if (ethernet.ether_type == ether_type_vlan) {
            vlan_tag tag{};
            used = wire::decode_prefix(tag, frame.subspan(at));
            if (!used) return frame_errc::too_short;
            at += *used;
            ethernet.ether_type = tag.ether_type;
        }
        if (ethernet.ether_type != ether_type_ethercat) return frame_errc::not_ethercat;
        used = wire::decode_prefix(header, frame.subspan(at));
        if (!used) return frame_errc::too_short;
        at += *used;
        return header.type == frame_type::datagrams ? frame_errc::ok : frame_errc::not_datagrams;
    }
    /// Bytes of the datagrams up to the last one; `why`: the one behind them is not whole.
    static constexpr std::size_t walk(std::span<Byte> datagrams, frame_errc& why) noexcept {
        std::size_t walked = 0;
        for (bool more = true; more;) {
            datagram_header datagram{};
            if (!wire::decode_prefix(datagram, datagrams.subspan(walked)) ||
                datagrams.size() - walked < datagram_overhead + datagram.length) {
                why = frame_errc::truncated_datagram;
                return walked;
            }
            walked += datagram_overhead + datagram.length;
            more = datagram.more;
        }
        return walked;
    }

    std::span<Byte> datagrams_{};
};

/// A datagram to read.
using datagram_view = basic_datagram<const std::byte>;
/// A frame to read.
using frame_view = basic_frame_view<const std::byte>;
/// A frame with datagrams that a slave processes.
using mutable_frame_view = basic_frame_view<std::byte>;

} // namespace jauscat::ethercat
