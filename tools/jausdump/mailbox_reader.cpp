#include "mailbox_reader.hpp"

#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>

namespace jausdump {

namespace {

namespace ethercat = jauscat::ethercat;
namespace registers = jauscat::ethercat::esc_registers;
namespace wire = jauscat::wire;
using ethercat::command;

using bytes = std::span<const std::byte>;

constexpr std::size_t mailbox_overhead = wire::max_size<ethercat::mailbox_header>;

bool is_by_position(command cmd) { return cmd == command::aprd || cmd == command::apwr || cmd == command::aprw; }
bool is_write(command cmd) { return cmd == command::fpwr || cmd == command::apwr; }
bool is_read(command cmd) { return cmd == command::fprd || cmd == command::aprd; }

/// The shortest body that a message of a protocol has.
std::size_t shortest_body(ethercat::mailbox_type type) {
    switch (type) {
    case ethercat::mailbox_type::error: return wire::max_size<ethercat::mailbox_error_reply>;
    case ethercat::mailbox_type::aoe:
    case ethercat::mailbox_type::eoe:
    case ethercat::mailbox_type::coe:
    case ethercat::mailbox_type::foe:
    case ethercat::mailbox_type::soe:
    case ethercat::mailbox_type::voe: return 1;
    }
    return SIZE_MAX; // no protocol
}

/// The header of a mailbox message at the front of `data`, if there is one.
std::optional<ethercat::mailbox_header> mailbox_header_of(bytes data) {
    ethercat::mailbox_header header{};
    if (!wire::decode_prefix(header, data)) return {};
    if (header.length < shortest_body(header.type) || header.length > data.size() - mailbox_overhead) return {};
    return header;
}

} // namespace

void mailbox_reader::read(bytes frame) {
    const ethercat::ethernet_header ethernet{.ether_type = ethercat::ether_type_ethercat};
    framed_.resize(wire::max_size<ethercat::ethernet_header>);
    static_cast<void>(wire::encode(ethernet, framed_));
    framed_.insert(framed_.end(), frame.begin(), frame.end());

    ethercat::frame_view view;
    if (const auto size = view.parse(framed_); !size)
        return listener_.skipped("EtherCAT: " + std::string{describe(size.error())});
    bool has_message = false;
    for (const auto& each : view) has_message = take(each) || has_message;
    if (!has_message) listener_.skipped("EtherCAT frame without a mailbox message");
}

void mailbox_reader::finish() {
    for (auto& [slave, direction] : lanes_) pend(direction, {});
}

/// Whether the datagram holds a mailbox message.
bool mailbox_reader::take(const datagram& each) {
    const command cmd = each.header.cmd;
    const bool executed = each.working_counter != 0;
    if (is_by_position(cmd) && !executed)
        on_the_way_[each.header.index] = position_access{cmd, each.header.ado, each.header.adp};
    if (each.header.ado < registers::process_ram.address) {
        if (executed) note_setup(each);
        return false;
    }
    // A read without a working counter was captured before the slaves, or the mailbox was empty.
    if (!is_write(cmd) && !(is_read(cmd) && executed)) return false;
    const auto header = mailbox_header_of(each.data);
    if (!header) return false;

    const auto message = each.data.first(mailbox_overhead + header->length);
    const auto slave = address_of(each);
    auto& direction = lanes_[{slave, is_write(cmd)}];
    // A sender that counts gives each message another counter than the previous one.
    const bool same_message = header->counter != 0 || direction.last_index == each.header.index;
    if (same_message && std::ranges::equal(message, direction.last)) return true;
    if (!executed) {
        pend(direction, message);
        return true;
    }
    direction.pending.clear();
    direction.last.assign(message.begin(), message.end());
    direction.last_index = each.header.index;
    listener_.message(
        {.slave = slave, .to_slave = is_write(cmd), .type = header->type, .body = message.subspan(mailbox_overhead)});
    return true;
}

/// Registers with the identity of a slave, or that reset its mailbox.
void mailbox_reader::note_setup(const datagram& each) {
    const auto& header = each.header;
    ethercat::esc_word station{};
    if (header.cmd == command::apwr && header.ado == registers::station_address.address &&
        wire::decode_prefix(station, each.data))
        stations_[position_of(each)] = station.value;
    if (header.ado != registers::al_control.address) return;
    // Another master may follow, with counters from the start.
    if (header.cmd == command::bwr)
        lanes_.clear();
    else if (is_write(header.cmd))
        for (const bool to_slave : {false, true}) lanes_.erase({address_of(each), to_slave});
}

/// Keeps a write until it comes back executed; counts the one before it that did not.
void mailbox_reader::pend(lane& direction, bytes message) {
    if (std::ranges::equal(direction.pending, message)) return;
    if (!direction.pending.empty()) listener_.skipped("EtherCAT mailbox message that no slave took: working counter 0");
    direction.pending.assign(message.begin(), message.end());
}

std::uint16_t mailbox_reader::position_of(const datagram& each) const {
    const auto& out = on_the_way_[each.header.index];
    const bool known = out && out->cmd == each.header.cmd && out->ado == each.header.ado;
    return static_cast<std::uint16_t>(-(known ? out->adp : each.header.adp));
}

slave_address mailbox_reader::address_of(const datagram& each) const {
    if (!is_by_position(each.header.cmd)) return {.number = each.header.adp};
    const auto position = position_of(each);
    const auto known = stations_.find(position);
    if (known == stations_.end()) return {.by_position = true, .number = position};
    return {.number = known->second};
}

} // namespace jausdump
