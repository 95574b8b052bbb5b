// UDP payloads, TCP segments and EtherCAT frames out of a capture, of a file or as packets pass.
#pragma once
#include "packet_reader.hpp"

#include <cstdint>
#include <memory>

struct pcap;

namespace jausdump {

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
