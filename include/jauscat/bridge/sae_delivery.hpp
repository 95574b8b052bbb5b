// Maps an SAE message to an object of an EtherCAT slave, and back.
#pragma once
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/schema/sae/transport/message_head.hpp>

namespace jauscat::bridging {

/// Delivery of SAE messages to slaves by a translation table between sae::message_head and the SDO download request.
template <class Table> struct sae_delivery {
    using translator = translate::translator<Table>;

    /// Whether a message can go to one slave at all: errors fragment_to_slave, broadcast_names_no_slave.
    [[nodiscard]] static constexpr translate::errc deliverable(const sae::transport_header& head) noexcept {
        if (head.fragment_flag != sae::fragment_flag::single) return translate::errc::fragment_to_slave;
        if (head.destination.node == 0 || head.destination.node == 255)
            return translate::errc::broadcast_names_no_slave;
        return translate::errc::ok;
    }

    /// The object access that a packet requests. Its data are `ulDataCnt` bytes; bytes behind them are ignored.
    [[nodiscard]] static constexpr object_access object_of(std::span<const std::byte> bytes) noexcept {
        return detail::object_of(bytes);
    }

    /// Writes the SAE message of a written object, and returns it. Errors: as translator::from_packet.
    [[nodiscard]] static constexpr result<std::span<std::byte>, translate::errc>
    message_of(const object_access& object, std::span<std::byte> out) noexcept {
        return detail::message_of<Table>(object, {}, out);
    }
};

} // namespace jauscat::bridging
