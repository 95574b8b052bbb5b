// The transport of a node: packets and time in, messages and packets out. No socket, no clock.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/sae/transport/duplicate_filter.hpp>
#include <jauscat/sae/transport/fragments.hpp>
#include <jauscat/sae/transport/packet_queue.hpp>
#include <jauscat/sae/transport/peer_table.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::sae {

/// A component of this transport, and its count of packets.
struct local_component {
    jaus_id id{};                 ///< names one component
    std::uint16_t next_number{1}; ///< sequence number of its next packet
};

/// A reply that waits to be sent.
struct queued_reply {
    endpoint_key to{};         ///< where the packet came from
    transport_header header{}; ///< of the reply
    std::uint16_t number{};    ///< of the packet
};

/// Memory of a transport. It must outlive the transport; see transport_storage.
struct transport_memory {
    std::span<known_peer> peers{};         ///< components that are heard
    std::span<seen_packet> seen{};         ///< packets that are recognised if they are repeated
    std::span<held_fragment> fragments{};  ///< packets of incomplete messages
    std::span<std::byte> fragment_bytes{}; ///< their payloads, an equal share for each
    std::span<std::byte> message{};        ///< payload of one message of several packets
    std::span<queued_packet> queue{};      ///< packets to be sent or acknowledged
    std::span<std::byte> queue_bytes{};    ///< their datagrams, an equal share for each
    std::span<queued_reply> replies{};     ///< acknowledgements to be sent
};

/// Sizes of a transport_storage.
struct transport_sizes {
    std::size_t peers{64};                            ///< components that are heard
    std::size_t seen{256};                            ///< packets remembered
    std::size_t fragments{32};                        ///< packets of incomplete messages
    std::size_t queue{32};                            ///< packets to be sent or acknowledged
    std::size_t replies{32};                          ///< acknowledgements to be sent
    std::size_t payload_size{usual_payload_size};     ///< of one packet, in both directions
    std::size_t message_size{16 * std::size_t{1024}}; ///< payload of a received message of several packets
};

/// Memory of a transport in arrays.
template <transport_sizes Sizes = transport_sizes{}> class transport_storage {
  public:
    [[nodiscard]] constexpr transport_memory memory() noexcept {
        return {peers_, seen_, fragments_, fragment_bytes_, message_, queue_, queue_bytes_, replies_};
    }

  private:
    std::array<known_peer, Sizes.peers> peers_{};
    std::array<seen_packet, Sizes.seen> seen_{};
    std::array<held_fragment, Sizes.fragments> fragments_{};
    std::array<std::byte, Sizes.fragments * Sizes.payload_size> fragment_bytes_{};
    std::array<std::byte, Sizes.message_size> message_{};
    std::array<queued_packet, Sizes.queue> queue_{};
    std::array<std::byte, Sizes.queue * (1 + transport_overhead + Sizes.payload_size)> queue_bytes_{};
    std::array<queued_reply, Sizes.replies> replies_{};
};

struct transport_options {
    /// Payload of a sent packet; a longer one is cut. Limited by the queue's memory, too.
    std::size_t payload_size{usual_payload_size};
    /// Whether the medium can send to all at once: a multicast group, every open connection, a serial line.
    bool has_group{true};
    /// Whether packets are processed of components alone that `fix` has configured.
    bool is_closed{};
    /// Repetition of packets that want an acknowledgement.
    retry_policy retry{.interval = std::chrono::milliseconds{250}, .attempts = 4};
    /// How long received packets are remembered; see duplicate_filter.
    duration duplicate_window{std::chrono::seconds{3}};
    /// How long a part of a message waits for the others; see fragment_reassembler.
    duration fragment_timeout{std::chrono::seconds{10}};
    /// How long a silent component keeps its place if others need it; see peer_table.
    duration peer_timeout{std::chrono::seconds{60}};
};

/// A message to send.
struct outgoing_message {
    jaus_id source{};                                ///< a component of this transport
    jaus_id destination{};                           ///< may have wildcards
    sae::priority priority{sae::priority::standard}; ///< the higher, the earlier it is sent
    sae::broadcast broadcast{};                      ///< as it is in the header
    bool is_acknowledged{};                          ///< repeated until it is acknowledged, and has an outcome
};

/// A message that was received, for one of the components.
struct received_message {
    jaus_id to{};                         ///< the component
    transport_header header{};            ///< of the packet; of several, of the last one that came
    std::span<const std::byte> payload{}; ///< message ID first; valid during the call
    std::uint16_t first_number{};         ///< sequence number of its first packet
    endpoint_key from{};                  ///< where the packet came from
};

/// A datagram to send.
struct outgoing_datagram {
    std::optional<endpoint_key> to{};   ///< nothing: to the group
    std::span<const std::byte> bytes{}; ///< version byte and one message; valid until the next call

    /// For streams: without the version byte.
    [[nodiscard]] constexpr std::span<const std::byte> message() const noexcept { return bytes.subspan(1); }
};

/// Counts since construction. Each received packet is in one of the first nine or in `faults`.
struct transport_counters {
    std::uint64_t packets{};        ///< processed: messages, and parts of them
    std::uint64_t replies{};        ///< acknowledgements of packets that waited for them
    std::uint64_t late_replies{};   ///< acknowledgements that nothing waited for
    std::uint64_t repeated{};       ///< received before
    std::uint64_t not_here{};       ///< for no component of this transport
    std::uint64_t own{};            ///< sent by a component of this transport: the group's loopback, or a forgery
    std::uint64_t unknown_source{}; ///< of a component that a closed transport does not have
    std::uint64_t wrong_endpoint{}; ///< the source is configured for another endpoint
    std::uint64_t no_capacity{};    ///< dropped because memory was full
    std::uint64_t delivered{};      ///< messages passed on
    std::uint64_t unknown_peers{};  ///< packets not sent because the destination was forgotten
    std::uint64_t lost_replies{};   ///< acknowledgements not sent because too many waited
    std::uint64_t unlearnt{};       ///< packets of components for which no place was free
    std::array<std::uint64_t, 24> faults{}; ///< by transport_errc
    std::array<std::uint64_t, 8> foreign{}; ///< datagrams of other forms, by jaus::datagram_form

    [[nodiscard]] constexpr std::uint64_t& of(transport_errc why) noexcept {
        static_assert(static_cast<std::size_t>(transport_errc::noise) < std::tuple_size_v<decltype(faults)>);
        return faults[static_cast<std::size_t>(why)];
    }
    [[nodiscard]] constexpr std::uint64_t& of(jaus::datagram_form form) noexcept {
        return foreign[static_cast<std::size_t>(form)];
    }
    [[nodiscard]] constexpr std::uint64_t of(transport_errc why) const noexcept {
        return faults[static_cast<std::size_t>(why)];
    }
    [[nodiscard]] constexpr std::uint64_t of(jaus::datagram_form form) const noexcept {
        return foreign[static_cast<std::size_t>(form)];
    }
    friend constexpr bool operator==(const transport_counters&, const transport_counters&) = default;
};

/// Sends and receives messages of AS5669A for the components of a node.
///
/// A packet with acknowledgement request for one component is acknowledged once it is processed; one that memory cannot
/// take is not, so it is repeated. A message that is acknowledged was delivered once; one that is not, once or never.
///
/// A destination that was not heard gets its packet by the group, as a global broadcast with acknowledgement request,
/// as known peers do it: the reply says where the destination is.
///
///     transport.on_datagram(from, bytes, now, [&](const sae::received_message& m) { ... });
///     while (const auto datagram = transport.next_datagram(now)) socket.send(...);
///     while (const auto done = transport.next_outcome()) ...
///     timer.expires_at(transport.next_event());
class transport {
  public:
    /// All memory must outlive the transport.
    JAUSCAT_CONSTEXPR transport(std::span<local_component> components, const transport_memory& memory,
                                const transport_options& options = {}) noexcept;

    /// Processes a datagram, and calls `take(const received_message&)` for each message and component. Returns judp2,
    /// or the form of a datagram that is not for this transport, which is counted: it may be for the RA node.
    constexpr jaus::datagram_form on_datagram(endpoint_key from, std::span<const std::byte> datagram, time_point now,
                                              auto&& take) {
        if (!is_judp2(datagram)) {
            const auto form = jaus::form_of(datagram);
            ++counters_.of(form);
            return form;
        }
        for (datagram_reader messages{datagram}; messages.has_next();) on_packet(from, messages.next(), now, take);
        return jaus::datagram_form::judp2;
    }
    /// The same for one message of a stream, as its reader gives it.
    constexpr void on_packet(endpoint_key from, const split_transport_message& packet, time_point now, auto&& take) {
        const auto [payload, first_number] = process(from, packet, now);
        if (payload.empty()) return;
        for (const local_component& component : components_) {
            if (!covers(packet.header.destination, component.id)) continue;
            ++counters_.delivered;
            take(received_message{component.id, packet.header, payload, first_number, from});
        }
    }

    /// Counts a datagram of another form that the medium has recognised.
    constexpr void count_foreign(jaus::datagram_form form) noexcept { ++counters_.of(form); }

    /// Queues a message; returns the sequence number of its first packet. Errors: unknown_source, invalid_destination,
    /// local_destination, unknown_peer, not_one_component, no_message_id, too_large, no_capacity, invalid_header.
    [[nodiscard]] JAUSCAT_CONSTEXPR result<std::uint16_t, transport_errc>
    send(const outgoing_message& message, std::span<const std::byte> payload, time_point now) noexcept;

    /// The next datagram to send at `now`; nothing where none is due.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<outgoing_datagram> next_datagram(time_point now) noexcept;
    /// The next outcome of a message that was sent with acknowledgement. It keeps a place of the queue until it is
    /// fetched.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<finished_message> next_outcome() noexcept;
    /// When next_datagram is to be called again; nothing while there is nothing to do.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;

    /// Configures where a component is; false if no place is free.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool fix(const jaus_id& id, endpoint_key endpoint) noexcept;
    /// Tells where a component is said to be, until a packet of it comes from elsewhere; false if no place is free.
    JAUSCAT_CONSTEXPR bool learn(const jaus_id& id, endpoint_key endpoint, time_point now) noexcept;
    /// A connection has ended: its components are not known any more.
    JAUSCAT_CONSTEXPR void forget(endpoint_key endpoint) noexcept;

    [[nodiscard]] constexpr const peer_table& peers() const noexcept { return peers_; }
    [[nodiscard]] constexpr const transport_counters& counts() const noexcept { return counters_; }

  private:
    // A message that is complete, or nothing.
    struct processed {
        std::span<const std::byte> payload{};
        std::uint16_t first_number{};
    };
    [[nodiscard]] JAUSCAT_CONSTEXPR processed process(endpoint_key from, const split_transport_message& packet,
                                                      time_point now) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR processed process_part(endpoint_key from, const split_transport_message& packet,
                                                           time_point now) noexcept;
    JAUSCAT_CONSTEXPR void reply(endpoint_key to, const split_transport_message& packet) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR local_component* component_of(const jaus_id& id) const noexcept;

    std::span<local_component> components_;
    transport_options options_;
    peer_table peers_;
    duplicate_filter filter_;
    fragment_reassembler reassembler_;
    packet_queue queue_;
    std::span<queued_reply> replies_;
    std::size_t first_reply_{};
    std::size_t reply_count_{};
    std::array<std::byte, 1 + transport_overhead> reply_bytes_{};
    transport_counters counters_{};
};

} // namespace jauscat::sae

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/sae/transport/impl/transport.ipp>
#endif
