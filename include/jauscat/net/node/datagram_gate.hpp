// Filters datagrams before a node: access list and rate limits.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/config/access_list.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <cstddef>
#include <map>
#include <random>
#include <span>
#include <vector>

namespace jauscat::net {

/// Decides on each datagram before it is processed. A refused datagram is not stored and not answered.
///
/// Each peer of the configuration has a limit of its own. In an open list all other senders share a table of 1024
/// places, by IP address. Only the constructor allocates.
///
///     datagram_gate gate{config};
///     transport.set_filter([&](auto message, const auto& from, auto framing) {
///         return gate(message, from, net::now(), framing);
///     });
class datagram_gate {
  public:
    using endpoint = access_list::endpoint;

    /// For the configuration's own system.
    explicit datagram_gate(const jaus_config& config, access how = access::closed)
        : datagram_gate{config, how, std::random_device{}()} {}
    /// `seed`: a random number; see rate_limit.
    datagram_gate(const jaus_config& config, access how, std::uint64_t seed)
        : list_{config, how}, strangers_{system_limits{}.messages, seed} {
        for (const auto& system : config.systems) {
            const auto place = peers_.size();
            peers_.push_back({system.limits.messages, {}, system.framing == jaus::framing::judp1});
            hosts_.emplace(detail::unmapped(system.ip), place);
            for (const auto& ip : system.more_ips) hosts_.emplace(detail::unmapped(ip), place);
        }
    }

    /// `message` is a datagram's content without the framing; it may be anything. A system of the configuration may
    /// send bare messages and `JAUS01.0`, and judp1 where that is its framing; a stranger any.
    [[nodiscard]] verdict operator()(std::span<const std::byte> message, const endpoint& from, time_point now,
                                     jaus::framing framing = jaus::framing::bare) noexcept {
        jaus::header head;
        if (!wire::decode_prefix(head, message) || !jaus::names_one_component(head.source)) return verdict::malformed;
        const auto found = list_.check(head.source, from);
        if (found.what != verdict::accepted) return found.what;
        if (framing == jaus::framing::judp1 && found.peer && !peers_[*found.peer].takes_judp1)
            return verdict::other_framing;
        const bool within = found.peer ? peers_[*found.peer].bucket.take(peers_[*found.peer].limit, now)
                                       : strangers_.take(key_of(from.address()), now);
        return within ? verdict::accepted : verdict::rate_limited;
    }

    /// Decides on a datagram of SAE JAUS by its host: JAUS IDs of the configuration are those of the RA. It counts in
    /// the rate of the first system that has the host.
    [[nodiscard]] verdict check_sae(const endpoint& from, time_point now) noexcept {
        const auto found = hosts_.find(detail::unmapped(from.address()));
        if (found == hosts_.end() && !list_.is_open()) return verdict::unknown_peer;
        const bool within = found != hosts_.end() ? peers_[found->second].bucket.take(peers_[found->second].limit, now)
                                                  : strangers_.take(key_of(from.address()), now);
        return within ? verdict::accepted : verdict::rate_limited;
    }

    [[nodiscard]] const access_list& list() const noexcept { return list_; }

  private:
    struct peer {
        rate limit{};
        token_bucket bucket{};
        bool takes_judp1{};
    };

    static rate_key key_of(const boost::asio::ip::address& ip) noexcept {
        if (ip.is_v4()) return {0, ip.to_v4().to_uint()};
        const auto bytes = ip.to_v6().to_bytes();
        return std::bit_cast<rate_key>(bytes);
    }

    access_list list_;
    std::vector<peer> peers_{};
    std::map<boost::asio::ip::address, std::size_t> hosts_{}; ///< of the systems, and their places in peers_
    rate_limit<1024> strangers_;
};

} // namespace jauscat::net
