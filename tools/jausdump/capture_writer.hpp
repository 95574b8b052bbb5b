// Writes what is shown as a capture file that Wireshark and jausdump read.
#pragma once
#include "dump.hpp"
#include "packet_reader.hpp"

#include <cstdio>
#include <memory>

struct pcap;
struct pcap_dumper;

namespace jausdump {

/// Writes the packets of the messages that pass the filters. A datagram is written when one of its messages passes.
/// Parts of messages in several packets are always written: IPv4 fragments, packets of SAE JAUS, segments of TCP,
/// serial data, EtherCAT frames.
class capture_writer {
  public:
    /// Creates the file. Throws input_error if that fails, or if it is the file `source`.
    explicit capture_writer(const std::string& path, const std::string& source = {});
    /// The file is whole after each packet of a port, and at the end.
    ~capture_writer();
    capture_writer(const capture_writer&) = delete;
    capture_writer& operator=(const capture_writer&) = delete;

    /// Notes the messages that pass, and the packets without one.
    void follow(options& how);
    /// Writes packets of a capture. `live`: each is in the file at once.
    void follow(capture_listener& listener, bool live);
    /// A datagram of a port, behind its messages: written with headers made for it.
    void on_datagram(std::span<const std::byte> payload, const origin& from);
    /// Throws std::runtime_error if the file could not be written.
    void finish();

  private:
    void begin(int link_type);
    void write(const captured_packet& packet, bool flush);
    void require(bool good) const;

    std::string path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> opened_;
    std::unique_ptr<pcap, void (*)(pcap*)> format_;
    std::unique_ptr<pcap_dumper, void (*)(pcap_dumper*)> file_;
    // Of the packet that is read:
    bool has_message_{}, is_skipped_{}, is_ethercat_{};
    std::optional<std::span<const std::byte>> datagram_{};
};

/// Whether a datagram holds a packet of a message of SAE JAUS in several packets.
bool is_part_of_message(std::span<const std::byte> datagram);

} // namespace jausdump
