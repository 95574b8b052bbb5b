// Messages out of pasted lines and captures: those that jausdump shows.
#pragma once
#include "jausdump/dump.hpp"
#include "jausdump/ethercat_reader.hpp"
#include "jausdump/packet_reader.hpp"
#include "web/stages.hpp"

#include <map>
#include <optional>

namespace page {

/// Collects the messages of one input.
class capture {
  public:
    explicit capture(const jausdump::object_table& table);

    /// A packet of a capture.
    void on_packet(int link_type, std::chrono::nanoseconds time, std::span<const std::byte> frame) {
        packets_.read(link_type, time, frame);
    }
    /// A line of hex digits: a message, a datagram, or a payload of SAE JAUS.
    void on_line(const std::string& line, std::size_t number);
    /// A frame of EtherCAT, its Ethernet header first.
    void on_frame(std::span<const std::byte> frame) { on_packet(jausdump::link_type::ethernet, {}, frame); }

    /// The input has ended: {"messages", "skipped"}.
    json finish();

  private:
    void add(const jausdump::record& message);

    json messages_ = json::array();
    std::map<std::string, std::size_t> skipped_{};
    jausdump::dump dump_;
    std::optional<jausdump::dump> payloads_{}; ///< for lines that are payloads of SAE JAUS
    jausdump::ethercat_reader ring_;
    jausdump::jtcp_streams streams_;
    jausdump::packet_reader packets_;
};

} // namespace page
