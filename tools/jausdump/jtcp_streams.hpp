// Messages of SAE JAUS out of captured TCP segments.
#pragma once
#include "record.hpp"
#include <jauscat/sae/transport/jtcp.hpp>

#include <deque>
#include <functional>
#include <map>
#include <memory>

namespace jausdump {

struct tcp_segment {
    std::uint32_t sequence_number{};
    bool synchronises{}; ///< SYN: the stream begins
    std::span<const std::byte> payload{};
};

struct jtcp_listener {
    /// `part`: the bytes of the message, empty where they are lost.
    std::function<void(const sae::split_transport_message&, std::span<const std::byte> part, const origin&)> message{};
    std::function<void(const std::string& reason)> skipped{}; ///< a segment of another protocol
};

/// Puts the segments of each direction of a connection in order, and takes the messages of JTCP out of them. A stream
/// whose beginning was not captured is read from the first segment on that begins with a message.
class jtcp_streams {
  public:
    explicit jtcp_streams(jtcp_listener listener) : listener_{std::move(listener)} {}

    /// `from` says which stream it belongs to.
    void on_segment(const tcp_segment& segment, const origin& from);
    /// The capture has ended.
    void finish();

  private:
    struct held_segment {
        std::vector<std::byte> bytes{};
        jausdump::origin origin{};
    };
    struct stream {
        std::string from{}, to{};
        std::optional<std::uint32_t> next{};             ///< sequence number of the next byte
        std::map<std::uint32_t, held_segment> waiting{}; ///< behind a missing one, by distance from `base`
        std::uint32_t base{};
        bool has_beginning{};           ///< `base` is that of its first byte
        bool begins{};                  ///< its first byte is the version
        std::vector<std::byte> front{}; ///< that are too few to tell the protocol
        std::vector<std::byte> buffer{};
        std::optional<sae::jtcp_reader> reader{}; ///< empty: the protocol is not known
        origin last{};
    };

    stream& stream_of(const origin& from);
    void take(stream& s, std::span<const std::byte> bytes, const origin& from);
    void read(stream& s, std::span<const std::byte> bytes, const origin& from);
    void take_waiting(stream& s);
    void skip_gap(stream& s);
    void end(stream& s);
    void lose_message(stream& s, sae::transport_errc why);

    jtcp_listener listener_;
    std::deque<stream> streams_{};
};

} // namespace jausdump
