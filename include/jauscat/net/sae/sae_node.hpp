// A node of SAE JAUS: one transport over UDP, TCP and a serial line, as the configuration has them.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/config/access_list.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/link/udp_counters.hpp>
#include <jauscat/net/sae/jserial_link.hpp>
#include <jauscat/net/sae/jtcp_link.hpp>
#include <jauscat/net/sae/shared_judp.hpp>
#include <jauscat/net/sae/transport_driver.hpp>
#include <jauscat/wire/encode.hpp>

#include <boost/asio/io_context.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// All options have defaults.
struct sae_node_options {
    /// Closed: packets are processed of components that a system of the configuration has, from the addresses and media
    /// of that system. Open: of all.
    access accept{access::closed};
    /// The IDs of its components within its node; empty: the component that the configuration names.
    std::vector<std::uint8_t> components{};
    sae::transport_sizes memory{.fragments = 272, .queue = 272, .message_size = std::size_t{1} << 20U}; // 3 MiB
    sae::transport_options transport{}; ///< without has_group and is_closed, which the configuration decides
    udp_options socket{};
    jtcp_options jtcp{};       ///< without listen, from, accepted and limit
    jserial_options jserial{}; ///< without device and baud
    /// Sends a datagram from the port of a node of the RA, which calls on_datagram; see shared_judp. Empty: JUDP has a
    /// socket of its own.
    shared_judp::send_handler send_datagram{};
    rate log_limit{.per_second = 20, .burst = 100}; ///< lines about refused messages
};

/// Counts since construction.
struct sae_node_counters {
    std::uint64_t unknown_peer{}; ///< messages that no system of the configuration may send
    std::uint64_t wrong_sender{}; ///< from another address or medium than that of the system
    std::uint64_t rate_limited{}; ///< more than the rate of the system
    sae::transport_counters transport{};
    udp_counters judp{}; ///< of its own socket, since the last start, as those of the other media
    jtcp_counters jtcp{};
    jserial_counters jserial{};
};

/// The components that a program has of the configuration's own system, at all media of its `<sae>`. A message goes by
/// the medium and to the address from which its destination was heard last; before, to those of the destination's
/// system in the configuration; without one, to the group of every medium. Use it from the thread that runs the
/// io_context.
///
///     net::sae_node node{context, net::read_jaus_config("JausConfig.xml")};
///     node.start({.on_message = [&](const sae::received_message& m) { ... }, .on_error = log});
///     node.send({.destination = {10, 1, 126}, .is_acknowledged = true}, message);
class sae_node {
  public:
    using bytes = std::span<const std::byte>;
    using endpoint = boost::asio::ip::udp::endpoint;

    /// Throws `config_error` if its system has no SAE JAUS or names no node, or a component is outside of it.
    JAUSCAT_DECL sae_node(boost::asio::io_context& context, jaus_config config, sae_node_options options = {});
    JAUSCAT_DECL ~sae_node();
    sae_node(const sae_node&) = delete;
    sae_node& operator=(const sae_node&) = delete;

    /// Opens the media; nobody is known at first. Must not be called from a handler. Throws `open_error`.
    JAUSCAT_DECL void start(sae_handlers handlers);
    /// Closes the media. No handler is called afterwards. May be called from a handler.
    JAUSCAT_DECL void stop();
    /// Between start and stop.
    [[nodiscard]] bool running() const noexcept { return is_running_; }

    /// Sends a message; returns its sequence number. A source of 0.0.0 is the first component. Errors: not_running,
    /// unroutable, queue_full, too_large, invalid_message; the reason is a sae::transport_errc.
    JAUSCAT_DECL result<std::uint16_t, error> send(sae::outgoing_message message, bytes payload);
    /// The same for a typed message. A value that does not encode gives errc::not_encodable.
    template <class T>
    requires(!std::convertible_to<const T&, bytes>)
    result<std::uint16_t, error> send(const sae::outgoing_message& message, const T& typed) {
        payload_.resize(std::min(wire::encoded_size(typed), sae::max_payload_size));
        const auto written = wire::encode(typed, std::span{payload_});
        if (!written) return not_encodable(written.error());
        return send(message, bytes{*written});
    }
    /// A datagram of SAE JAUS that a node of the RA has received; see sae_node_options::send_datagram.
    JAUSCAT_DECL void on_datagram(bytes datagram, const endpoint& from);

    [[nodiscard]] const jaus_config& config() const noexcept { return config_; }
    /// The first of its components.
    [[nodiscard]] const sae::jaus_id& self() const noexcept { return components_.front().id; }
    /// The components that were heard, and where.
    [[nodiscard]] const sae::peer_table& peers() const noexcept { return transport_.peers(); }
    /// Where a key of `peers` or a message is: "UDP 192.168.1.10:3794", "TCP ...", "the serial line ...".
    [[nodiscard]] JAUSCAT_DECL std::string place_of(sae::endpoint_key key) const;
    [[nodiscard]] JAUSCAT_DECL sae_node_counters counts() const;

  private:
    struct media; ///< those of the last start
    struct storage {
        explicit storage(const sae::transport_sizes& sizes);
        [[nodiscard]] sae::transport_memory memory() noexcept;

        std::vector<sae::known_peer> peers;
        std::vector<sae::seen_packet> seen;
        std::vector<sae::held_fragment> fragments;
        std::vector<std::byte> fragment_bytes, message;
        std::vector<sae::queued_packet> queue;
        std::vector<std::byte> queue_bytes;
        std::vector<sae::queued_reply> replies;
    };

    [[nodiscard]] JAUSCAT_DECL static std::vector<sae::local_component> components_of(const jaus_config& config,
                                                                                      const sae_node_options& options);
    [[nodiscard]] JAUSCAT_DECL sae::transport_options transport_options_of() const;
    [[nodiscard]] JAUSCAT_DECL bool is_accepted(const sae::transport_header& head, sae::endpoint_key from);
    [[nodiscard]] JAUSCAT_DECL verdict check(const sae::jaus_id& source, sae::endpoint_key from);
    [[nodiscard]] JAUSCAT_DECL bool is_of(const system_entry& system, sae::endpoint_key from) const;
    JAUSCAT_DECL void learn_configured(const sae::jaus_id& destination);

    boost::asio::io_context& context_;
    jaus_config config_;
    sae_node_options options_;
    std::vector<sae::local_component> components_;
    storage storage_;
    sae::transport transport_;
    transport_driver driver_;
    std::unique_ptr<media> media_{};
    bool is_running_{};
    std::vector<token_bucket> buckets_; ///< of the systems
    std::function<void(std::string_view)> on_error_{};
    limited_log log_;
    std::vector<std::byte> payload_{};
    sae_node_counters counters_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/sae_node.ipp>
#endif
