// Maps a JAUS message to an object of an EtherCAT slave, and back.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>

namespace jauscat::bridging {

/// JAUS identity of a slave. Fills in the header fields that a table does not carry in the data.
struct slave_identity {
    std::uint8_t subsystem{};
    std::uint16_t station{}; ///< configured station address = JAUS node
    std::uint8_t instance{1};

    /// `asked` with the slave's own octets in place of 255 ("all"), which is no valid source. The component stays 255
    /// unless `component` is given.
    [[nodiscard]] constexpr jaus::address answering_as(jaus::address asked,
                                                       std::uint8_t component = 255) const noexcept {
        const auto fill_in = [](std::uint8_t& octet, std::uint8_t own) {
            if (octet == 255) octet = own;
        };
        fill_in(asked.subsystem, subsystem);
        fill_in(asked.node, static_cast<std::uint8_t>(station));
        fill_in(asked.component, component);
        fill_in(asked.instance, instance);
        return asked;
    }
};

/// An SDO download or upload: what crosses the wire.
struct object_access {
    std::uint16_t station{};
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::span<const std::byte> data{}; ///< points into the packet; empty for an upload
};

namespace detail {

/// The message of a written object. `own` has what the object does not carry.
template <class Table>
[[nodiscard]] constexpr result<std::span<std::byte>, translate::errc>
message_of(const object_access& object, const typename Table::header_type& own, std::span<std::byte> out) noexcept {
    typename Table::packet_type fields{};
    Table::prefill(own, fields, {.body = 0, .data = object.data.size()});
    fields.ul_node_id = object.station;
    fields.ul_index = object.index;
    fields.ul_sub_index = object.subindex;
    return translate::translator<Table>::from_packet(fields, object.data, out);
}

/// The object access that a packet requests. Its data are `ulDataCnt` bytes; bytes behind them are ignored.
[[nodiscard]] constexpr object_access object_of(std::span<const std::byte> bytes) noexcept {
    hilscher::sdo_download_request fields{};
    if (!wire::decode_prefix(fields, bytes)) return {};
    const auto data = bytes.subspan(wire::max_size<hilscher::sdo_download_request>);
    return {.station = static_cast<std::uint16_t>(fields.ul_node_id),
            .index = static_cast<std::uint16_t>(fields.ul_index),
            .subindex = static_cast<std::uint8_t>(fields.ul_sub_index),
            .data = data.first(std::min<std::size_t>(fields.ul_data_cnt, data.size()))};
}

} // namespace detail

/// Delivery of JAUS messages to slaves by a translation table between jaus::header and the SDO download request.
template <class Table> struct delivery {
    using packet = hilscher::sdo_download_request;
    using translator = translate::translator<Table>;

    /// Whether a message can go to one slave at all: errors fragment_to_slave, broadcast_names_no_slave.
    [[nodiscard]] static constexpr translate::errc deliverable(const jaus::header& head) noexcept {
        if (head.data_flag != jaus::data_flag::only) return translate::errc::fragment_to_slave;
        if (head.destination.node == 0 || head.destination.node == 255)
            return translate::errc::broadcast_names_no_slave;
        return translate::errc::ok;
    }

    /// The object access that a packet requests. Its data are `ulDataCnt` bytes; bytes behind them are ignored.
    [[nodiscard]] static constexpr object_access object_of(std::span<const std::byte> bytes) noexcept {
        return detail::object_of(bytes);
    }

    /// Writes the JAUS message of a written object, and returns it. What the object does not carry (under the seed
    /// table: subsystem, instance and data flag) is filled in as if the message were sent to `self`. Errors: as
    /// translator::from_packet.
    [[nodiscard]] static constexpr result<std::span<std::byte>, translate::errc>
    message_of(const object_access& object, const slave_identity& self, std::span<std::byte> out) noexcept {
        const jaus::header own{.destination = {.instance = self.instance,
                                               .node = static_cast<std::uint8_t>(self.station),
                                               .subsystem = self.subsystem}};
        return detail::message_of<Table>(object, own, out);
    }
};

} // namespace jauscat::bridging
