// Options and callbacks of a JAUS node.
#pragma once

#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/routing/node_description.hpp>
#include <jauscat/net/config/access_list.hpp>
#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace jauscat::net {

/// All options have defaults.
struct jaus_node_options {
    /// Closed: accepts only systems of the configuration, from their endpoints. Open: accepts all; replies to unknown
    /// subsystems go to their last endpoint. See access_list.
    access who{access::closed};
    /// The node of its system that this is; 0: the one that the configuration names, or 1.
    std::uint8_t node{};
    /// The node that relays within the subsystem; 0: none. See jaus::router.
    std::uint8_t primary{};
    udp_options socket{}; ///< how the socket is opened

    jaus::heartbeat beat = jaus::heartbeat_to_all(); ///< of the node manager
    /// A component that sends no heartbeat for so long is gone; and a peer that a component here depends on, whose node
    /// is not heard, when it sends nothing and does not answer for so long. See detail::peer_watch.
    std::chrono::nanoseconds timeout{std::chrono::seconds{3}};

    /// Large data sets that each component can receive at a time. They share the configuration's `largedata` bytes, of
    /// which the node manager has up to 64 KiB and the components equal parts of the rest.
    std::size_t large_data_sets{4};
    /// A large data set of which nothing has come for so long is given up.
    std::chrono::nanoseconds large_data_timeout{std::chrono::seconds{5}};
    /// Sending rate of large data sets, in packets of 4 KiB per millisecond.
    unsigned large_data_pace{4};
    /// Between two large data sets of the same source and code to the same destination, unless the first one was
    /// acknowledged without a repeat: longer than the network holds a datagram back, and than a quarter of it more,
    /// which is how long a receiver waits for the next packet of one that asks for no acknowledgement. The same at both
    /// ends.
    std::chrono::nanoseconds large_data_pause{std::chrono::milliseconds{500}};
    /// How their packets are repeated where `ack_nak` of the header asks for acknowledgement.
    jaus::acknowledgement_options large_data_acknowledgement{.timeout = std::chrono::milliseconds{50}, .retries = 20};
    /// Bytes of large data sets that may wait to be sent, and of messages between components of the node.
    std::size_t most_waiting{std::size_t{16} << 20U};

    /// Gets a line about all that was refused, unroutable or lost.
    std::function<void(std::string_view line)> log{};
    rate log_limit{.per_second = 20, .burst = 100}; ///< lines of each cause that go to the log
    /// Describes the field and byte at which decoding failed, for the log. text::why_malformed does, for the messages
    /// of a list.
    std::function<std::string(std::uint16_t command_code, std::span<const std::byte> body)> explain_malformed{};
    /// Called for each message delivered to a local component, the node manager included, with its outcome.
    std::function<void(const jaus::address& component, const jaus::header& head, std::span<const std::byte> body,
                       jaus::component_outcome what)>
        on_message{};
    /// Called when a component has appeared, or timed out, at the node manager.
    std::function<void(const jaus::address& who)> appeared{}, disappeared{};
    /// Called with the outcome of a large data set that requested an acknowledgement. Acknowledged: the receiving
    /// component has all of it and has taken it. Refused: it has not. Timed out: an answer is missing, and it may have
    /// been taken.
    std::function<void(const jaus::header& head, jaus::delivered what)> large_data_done{};
};

} // namespace jauscat::net
