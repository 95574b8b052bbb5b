// UDP payloads, TCP segments and EtherCAT frames out of a capture, of a file or as packets pass.
#pragma once
#include "jtcp_streams.hpp"

#include <cstdint>
#include <functional>
#include <memory>

struct pcap;

namespace jausdump {

/// Receives the content of a capture.
struct capture_listener {
    std::function<void(std::span<const std::byte> payload, const origin&)> datagram{};
    std::function<void(const tcp_segment&, const origin&)> tcp{}; ///< not set: passed over
    /// An EtherCAT frame, its EtherCAT header on: of Ethernet, or the payload of UDP port 34980. Not set: passed over.
    std::function<void(std::span<const std::byte> frame, const origin&)> ethercat{};
    /// Bytes of a serial line; `from` is "TX" or "RX" where the capture tells it. Not set: passed over.
    std::function<void(std::span<const std::byte> part, const origin&)> serial{};
    std::function<void(const std::string& reason)> skipped{}; ///< a frame with none of these
    std::function<void(double part)> progress{};              ///< of the file, 0 to 1
    std::function<bool()> stop{};
};

/// Reads a capture file of libpcap's or the next generation's format. Link types: Ethernet (also with VLAN tags), Linux
/// cooked, raw IP, loopback; of serial lines RTAC_SERIAL, and USER0 to USER15, whose packets are bytes of one line.
/// Throws input_error if the file cannot be read, or not to its end; everything before that has been passed on by then.
void read_capture(const std::string& path, const capture_listener& listener);

/// The datagrams and TCP segments from and to a port of this machine as they pass, at all interfaces, whoever has the
/// port.
class port_capture {
  public:
    /// Throws input_error: that needs CAP_NET_RAW.
    explicit port_capture(std::uint16_t port);

    /// Until `stop` returns true.
    void run(const capture_listener& listener);

  private:
    std::unique_ptr<pcap, void (*)(pcap*)> packets_;
};

} // namespace jausdump
