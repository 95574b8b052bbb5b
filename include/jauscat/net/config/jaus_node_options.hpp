// Options and callbacks of a JAUS node.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/routing/node_description.hpp>
#include <jauscat/net/config/access_list.hpp>
#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <boost/asio/ip/udp.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace jauscat::net {

/// All options have defaults.
struct jaus_node_options {
    /// Closed: accepts only systems of the configuration, from their endpoints. Open: accepts all; replies to unknown
    /// subsystems go to their last endpoint. See access_list.
    access accept{access::closed};
    /// The node ID within the system; 0: the one that the configuration names, or 1.
    std::uint8_t node{};
    /// The node that relays within the subsystem; 0: none. See jaus::router.
    std::uint8_t primary{};
    /// What its subsystem is, in Report Identification; without, what the configuration says.
    std::optional<jaus::subsystem_type> type{};
    udp_options socket{};

    jaus::heartbeat beat = jaus::heartbeat_to_all(); ///< of the node manager
    /// A component is lost after this time without a heartbeat. A peer that a local component depends on, and whose
    /// node sends no heartbeats, is lost after this time without any message. See detail::peer_watch.
    duration timeout{std::chrono::seconds{3}};

    /// Large data sets that each component can receive at a time. They share the `largedata` bytes of the
    /// configuration: the node manager gets up to 64 KiB, the components equal parts of the rest.
    std::size_t large_data_sets{4};
    /// A large data set is discarded after this time without a packet.
    duration large_data_timeout{std::chrono::seconds{5}};
    /// Sending rate of large data sets, in packets of 4 KiB per millisecond.
    unsigned large_data_pace{4};
    /// Pause between two large data sets of the same source and code to the same destination, unless the first one was
    /// acknowledged without a repeat. It must exceed the longest delay of a datagram in the network by a quarter of the
    /// pause, which is the time that a receiver waits for the next packet of a set without acknowledgement. Must be the
    /// same at both ends.
    duration large_data_pause{std::chrono::milliseconds{500}};
    /// Of each of their packets, if `ack_nak` of the header requests acknowledgement.
    retry_policy large_data_retry{.interval = std::chrono::milliseconds{50}, .attempts = 21};
    /// Limit of queued bytes: of large data sets to be sent, and of messages between components of the node.
    std::size_t max_waiting{std::size_t{16} << 20U};

    /// Receives a line for each message that was refused, unroutable or lost.
    std::function<void(std::string_view line)> log{};
    rate log_limit{.per_second = 20, .burst = 100}; ///< lines of each cause
    /// Describes the field and byte at which decoding failed, for the log. text::why_malformed does, for the messages
    /// of a list.
    std::function<std::string(std::uint16_t command_code, std::span<const std::byte> body)> explain_malformed{};
    /// Called for each message before a local component gets it, the node manager included.
    std::function<void(const jaus::address& component, const jaus::header& head, std::span<const std::byte> body)>
        on_received{};
    /// Called for each message of a local component, the node manager included, before it is sent.
    std::function<void(std::span<const std::byte> message)> on_sent{};
    /// Called for each message delivered to a local component, the node manager included, with its outcome.
    std::function<void(const jaus::address& component, const jaus::header& head, std::span<const std::byte> body,
                       jaus::component_outcome what)>
        on_message{};
    /// Called when a component has appeared, or timed out, at the node manager.
    std::function<void(const jaus::address& who)> appeared{}, disappeared{};
    /// Called with each datagram of SAE JAUS (AS5669A, version 2) at the node's port or at `sae_group`. In a closed
    /// node its host must be that of a system of the configuration; the datagram counts in the rate of that system.
    /// Empty: such datagrams are dropped and counted, and the log names each host once. See sae_node, shared_judp.
    std::function<void(std::span<const std::byte> datagram, const boost::asio::ip::udp::endpoint& from)>
        on_sae_datagram{};
    /// The group of SAE JAUS, which the node joins for on_sae_datagram; nothing: that of the system's `<judp>`.
    /// Datagrams to groups are sent with interface, TTL and loop of the system's `<multicast>`, where it has one.
    std::optional<multicast_options> sae_group{};
    /// Called with the outcome of a large data set that requested an acknowledgement, and with the header that `send`
    /// got. Acknowledged: the receiving
    /// component has received and accepted all of it. Refused: it has not. Timed out: an answer is missing, and it may
    /// have been accepted.
    std::function<void(const jaus::header& head, jaus::delivered what)> large_data_done{};
};

} // namespace jauscat::net
