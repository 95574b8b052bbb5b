// Where the components are that were heard: JAUS IDs and endpoints.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/sae/transport/jaus_id.hpp>

#include <chrono>
#include <cstdint>
#include <span>

namespace jauscat::sae {

/// Where packets come from and go to, as the medium numbers it: such as IPv4 address and port, or a connection.
struct endpoint_key {
    std::uint64_t value{};
    friend constexpr bool operator==(const endpoint_key&, const endpoint_key&) = default;
};

/// A place for a component and its endpoint.
struct known_peer {
    bool is_used{};          ///< whether the place is taken
    bool is_fixed{};         ///< configured: it never moves and is never forgotten
    jaus_id id{};            ///< of the component
    endpoint_key endpoint{}; ///< where it is
    time_point heard_at{};   ///< time of its last packet
};

/// Result of a packet's source.
enum class learnt : std::uint8_t {
    known,          ///< where it was
    added,          ///< new
    moved,          ///< from another endpoint
    no_capacity,    ///< new, and not remembered: every place, or the share of its endpoint, is taken
    wrong_endpoint, ///< configured for another endpoint: not to be processed
};

/// Learns the endpoint of each component by the source of its packets, in memory of the caller.
///
/// If all places are taken, a new component takes that of the longest silent one that has been silent for the timeout.
class peer_table {
  public:
    JAUSCAT_CONSTEXPR explicit peer_table(std::span<known_peer> places,
                                          duration timeout = std::chrono::seconds{60}) noexcept;

    /// Configures the endpoint of a component; false if no place is free.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool fix(const jaus_id& id, endpoint_key endpoint) noexcept;
    /// A packet of `id` has arrived from `endpoint`.
    JAUSCAT_CONSTEXPR learnt on_packet(const jaus_id& id, endpoint_key endpoint, time_point now) noexcept;
    /// The components of a connection that has ended are not known any more, except configured ones.
    JAUSCAT_CONSTEXPR void forget(endpoint_key endpoint) noexcept;
    /// The component, or nullptr. Valid until the next packet.
    [[nodiscard]] JAUSCAT_CONSTEXPR const known_peer* find(const jaus_id& id) const noexcept;
    /// All places, used or not.
    [[nodiscard]] constexpr std::span<const known_peer> places() const noexcept { return places_; }

  private:
    std::span<known_peer> places_;
    duration timeout_;
};

} // namespace jauscat::sae

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/sae/transport/impl/peer_table.ipp>
#endif
