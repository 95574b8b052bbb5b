// UDP payloads, TCP segments, EtherCAT frames and serial data out of the packets of a capture. Needs no library for
// captures.
#pragma once
#include "ip_fragments.hpp"
#include "jtcp_streams.hpp"

#include <chrono>
#include <functional>
#include <span>
#include <string>
#include <utility>

namespace jausdump {

/// Numbers of link types, as files and libpcap have them.
namespace link_type {
inline constexpr int null = 0, ethernet = 1, raw_ip = 12, raw_ip_in_files = 101, loopback = 108, linux_cooked = 113,
                     user_0 = 147, user_15 = 162, ipv4 = 228, rtac_serial = 250, linux_cooked_2 = 276;
} // namespace link_type
/// Whether packets of the link type can be read.
bool has_link_type(int type);

/// A packet as it was captured.
struct captured_packet {
    int link_type{};
    std::chrono::nanoseconds time{}; ///< since 1970, UTC
    std::span<const std::byte> frame{};
    std::size_t size{}; ///< bytes on the wire; the frame may be cut
};

/// Receives the content of a capture.
struct capture_listener {
    std::function<void(std::span<const std::byte> payload, const origin&)> datagram{};
    std::function<void(const tcp_segment&, const origin&)> tcp{}; ///< not set: passed over
    /// An EtherCAT frame, its EtherCAT header on: of Ethernet, or the payload of UDP port 34980. Not set: passed over.
    std::function<void(std::span<const std::byte> frame, const origin&)> ethercat{};
    /// Bytes of a serial line; `from` is "TX" or "RX" where the capture tells it. Not set: passed over.
    std::function<void(std::span<const std::byte> part, const origin&)> serial{};
    std::function<void(const std::string& reason)> skipped{}; ///< a frame with none of these
    std::function<void(const captured_packet&)> packet{};     ///< after what it holds. Not set: passed over
    std::function<void(double part)> progress{};              ///< of the file, 0 to 1
    std::function<bool()> stop{};
};

/// Takes packets apart, and puts fragments of IPv4 together.
class packet_reader {
  public:
    explicit packet_reader(capture_listener listener) : listener_{std::move(listener)} {}

    /// The next packet.
    void read(int type, std::chrono::nanoseconds time, std::span<const std::byte> frame);
    /// The capture has ended.
    void finish();

  private:
    capture_listener listener_;
    ip_fragments fragments_{};
    origin from_{.place = "packet"};
};

} // namespace jausdump
