// Access list: endpoints from which messages of each JAUS source are accepted.
#pragma once

#include <jauscat/jaus/routing/address_map.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/config/verdict.hpp>
#include <jauscat/net/detail/mapped_address.hpp>

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace jauscat::net {

/// Senders that an access list accepts.
enum class access : std::uint8_t {
    closed, ///< those in the list
    open,   ///< all, for tests
};

/// Accepts a message only from the endpoint to which a reply would be sent. The RA has no authentication; this check
/// does not stop spoofed datagrams or eavesdropping.
///
/// A check costs a look-up in an address_map and a comparison with the addresses of one system, at most 8, independent
/// of the number of systems. Only the constructors allocate.
class access_list {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;

    /// Result of the check. `peer` is the place of the system in the configuration, if the source is one of its.
    struct finding {
        /// `taken`, or the reason for the refusal
        verdict what{};
        std::optional<std::size_t> peer{}; ///< see above
    };

    /// The systems of `config` that speak the RA. Closed by default; open if there is no other one.
    explicit access_list(const jaus_config& config, access how = access::closed)
        : how_{std::ranges::count_if(config.systems, &system_entry::has_ra) > 1 ? how : access::open},
          places_(std::bit_ceil(config.systems.size() + config.systems.size() / 2 + 2)),
          peers_{places_} {
        for (const auto& system : config.systems) {
            if (system.has_ra)
                static_cast<void>(peers_.insert(system.jausip, static_cast<std::uint32_t>(senders_.size())));
            sender made{.ips = {system.ip}, .port = system.any_source_port ? std::uint16_t{0} : system.port};
            made.ips.insert(made.ips.end(), system.more_ips.begin(), system.more_ips.end());
            for (auto& ip : made.ips) ip = detail::unmapped(ip);
            senders_.push_back(std::move(made));
        }
    }

    access_list(const access_list&) = delete;
    access_list& operator=(const access_list&) = delete;

    /// Whether a message of this source is accepted from there: `taken`, `unknown_peer` or `wrong_sender`. The system
    /// with the most specific jausip counts, as for sending: if there is a system 1.2.0.0, its messages are not
    /// accepted from 1.0.0.0. An open list accepts all, and finds a peer only where a closed one would.
    [[nodiscard]] finding check(const jaus::address& source, const endpoint& from) const noexcept {
        const auto* const found = peers_.find(source);
        if (!found) return refused(verdict::unknown_peer);
        const auto& peer = senders_[found->value];
        const bool right_port = peer.port == 0 || peer.port == from.port();
        if (!right_port || std::ranges::find(peer.ips, detail::unmapped(from.address())) == peer.ips.end())
            return refused(verdict::wrong_sender);
        return {verdict::accepted, found->value};
    }

    /// Whether it accepts messages from all senders.
    [[nodiscard]] bool is_open() const noexcept { return how_ == access::open; }

  private:
    struct sender {
        std::vector<boost::asio::ip::address> ips{};
        std::uint16_t port{}; ///< 0: any
    };

    [[nodiscard]] finding refused(verdict why) const noexcept { return {is_open() ? verdict::accepted : why, {}}; }

    access how_;
    std::vector<jaus::address_place<std::uint32_t>> places_;
    jaus::address_map<std::uint32_t> peers_;
    std::vector<sender> senders_{};
};

} // namespace jauscat::net
