// Puts the fragments of IPv4 packets together, RFC 791.
#pragma once
#include "ip_headers.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace jausdump {

/// Of the last packets that are incomplete, 64 at most.
class ip_fragments {
  public:
    /// What follows the header of a packet; the whole of it when this fragment was the last one that lacked.
    /// Overlapping bytes are those that came first.
    std::optional<std::vector<std::byte>> add(const ipv4_header& ip, std::span<const std::byte> part);
    /// Fragments of packets that were never complete.
    [[nodiscard]] std::size_t left_over() const;

  private:
    struct packet {
        ipv4_header first{};
        std::vector<std::byte> bytes{};
        std::vector<bool> has{};           ///< each of them
        std::optional<std::size_t> size{}; ///< known from the last fragment
        std::size_t fragments{};
    };
    static constexpr std::size_t most = 64;
    std::deque<packet> packets_{};
    std::size_t given_up_{};
};

} // namespace jausdump
