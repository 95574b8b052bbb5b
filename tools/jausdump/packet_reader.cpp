#include "packet_reader.hpp"

#include "ip_headers.hpp"
#include <jauscat/wire/decode.hpp>

#include <array>
#include <memory>

namespace jausdump {

namespace {

using bytes = std::span<const std::byte>;

/// A frame that is of no use, and why.
struct useless {
    std::string reason{};
};

/// Takes a header off the front.
template <class Header> Header take(bytes& rest, const char* name) {
    Header header{};
    const auto used = wire::decode_prefix(header, rest);
    if (!used) throw useless{std::string{"shorter than its "} + name + " header"};
    rest = rest.subspan(*used);
    return header;
}

constexpr std::uint16_t ether_type_ipv4 = 0x0800;
constexpr std::uint16_t ether_type_provider_vlan = 0x88A8;
constexpr std::uint8_t protocol_tcp = 6, protocol_udp = 17;
constexpr std::uint16_t ethercat_port = jauscat::ethercat::ether_type_ethercat;

/// What a frame carries, without its link layer.
struct packet {
    std::uint16_t ether_type{ether_type_ipv4};
    bytes data{};
};

packet behind_vlan_tags(std::uint16_t ether_type, bytes rest) {
    while (ether_type == jauscat::ethercat::ether_type_vlan || ether_type == ether_type_provider_vlan)
        ether_type = take<jauscat::ethercat::vlan_tag>(rest, "VLAN").ether_type;
    return {ether_type, rest};
}

/// The address family in front of a packet from a loopback device, in the byte order of the machine that wrote it.
bytes behind_address_family(bytes frame) {
    if (frame.size() < 4) throw useless{"shorter than its loopback header"};
    constexpr std::byte internet{2};
    if (frame[0] != internet && frame[3] != internet) throw useless{"not IPv4: another address family"};
    return frame.subspan(4);
}

/// The one standard link type of a serial line, and those that a user defines: here its bytes alone.
bool is_serial(int type) {
    return type == link_type::rtac_serial || (type >= link_type::user_0 && type <= link_type::user_15);
}

void take_serial(int type, bytes frame, origin& from, const capture_listener& listener) {
    if (!listener.serial) throw useless{"of a serial line"};
    from.from.clear();
    if (type == link_type::rtac_serial) {
        const auto event = take<rtac_serial_header>(frame, "RTAC serial").event;
        if (frame.empty()) return; // a change of the line's state
        const bool is_sent = event == rtac_event::data_tx_start || event == rtac_event::data_tx_end;
        from.from = is_sent ? "TX" : "RX";
    }
    listener.serial(frame, from);
}

packet packet_of(int type, bytes frame) {
    switch (type) {
    case link_type::ethernet: {
        const auto ether_type = take<jauscat::ethercat::ethernet_header>(frame, "Ethernet").ether_type;
        return behind_vlan_tags(ether_type, frame);
    }
    case link_type::linux_cooked: {
        const auto ether_type = take<cooked_header>(frame, "Linux cooked").protocol;
        return behind_vlan_tags(ether_type, frame);
    }
    case link_type::linux_cooked_2: {
        const auto ether_type = take<cooked_header_2>(frame, "Linux cooked").protocol;
        return behind_vlan_tags(ether_type, frame);
    }
    case link_type::null:
    case link_type::loopback: return {.data = behind_address_family(frame)};
    default: return {.data = frame}; // raw IP
    }
}

std::string endpoint(const std::array<std::byte, 4>& ip, std::uint16_t port) {
    std::string text;
    for (const std::byte octet : ip) {
        if (!text.empty()) text += '.';
        text += std::to_string(std::to_integer<int>(octet));
    }
    return text + ":" + std::to_string(port);
}

struct ip_payload {
    ipv4_header head{};
    bytes content{};
    std::vector<std::byte> of_fragments{}; ///< what `content` is in, where it came in several packets
};

/// What an IPv4 packet carries, or what this fragment completes.
std::optional<ip_payload> ip_payload_of(bytes packet, bool with_tcp, ip_fragments& fragments) {
    const bytes whole = packet;
    const auto ip = take<ipv4_header>(packet, "IPv4");
    const std::size_t header_size = std::size_t{ip.words} * 4;
    if (ip.version != 4) throw useless{"not IPv4: IP version " + std::to_string(ip.version)};
    if (header_size < wire::min_size<ipv4_header> || header_size > ip.total_size) throw useless{"broken IPv4 header"};
    if (ip.protocol != protocol_udp && !(with_tcp && ip.protocol == protocol_tcp))
        throw useless{"not UDP: IP protocol " + std::to_string(ip.protocol)};
    if (ip.total_size > whole.size()) throw useless{"not captured to its end"};

    ip_payload made{.head = ip, .content = whole.subspan(header_size, ip.total_size - header_size)};
    if (ip.more_fragments || ip.fragment_offset != 0) {
        auto complete = fragments.add(ip, made.content);
        if (!complete) return std::nullopt;
        made.of_fragments = *std::move(complete);
        made.content = made.of_fragments;
    }
    return made;
}

/// Passes the payload of a UDP datagram on; fills in the ends of `from`.
void take_udp(const ip_payload& ip, origin& from, const capture_listener& listener) {
    bytes datagram = ip.content;
    const auto udp = take<udp_header>(datagram, "UDP");
    if (udp.size < wire::min_size<udp_header> || udp.size - wire::min_size < udp_header >> datagram.size())
        throw useless{"broken UDP header"};
    from.from = endpoint(ip.head.source, udp.source_port);
    from.to = endpoint(ip.head.destination, udp.destination_port);
    const bool ethercat =
        listener.ethercat && (udp.source_port == ethercat_port || udp.destination_port == ethercat_port);
    (ethercat ? listener.ethercat : listener.datagram)(datagram.first(udp.size - wire::min_size<udp_header>), from);
}

void take_tcp(const ip_payload& ip, origin& from, const capture_listener& listener) {
    bytes rest = ip.content;
    const auto tcp = take<tcp_header>(rest, "TCP");
    const std::size_t header_size = std::size_t{tcp.words} * 4;
    if (header_size < wire::min_size<tcp_header> || header_size > ip.content.size()) throw useless{"broken TCP header"};
    from.from = endpoint(ip.head.source, tcp.source_port);
    from.to = endpoint(ip.head.destination, tcp.destination_port);
    listener.tcp({tcp.sequence_number, tcp.synchronises, ip.content.subspan(header_size)}, from);
}

void hand_over(const packet& found, origin& from, const capture_listener& listener, ip_fragments& fragments) {
    if (found.ether_type == jauscat::ethercat::ether_type_ethercat) {
        if (!listener.ethercat) throw useless{"EtherCAT: --ethercat shows the JAUS messages in it"};
        return listener.ethercat(found.data, from);
    }
    if (found.ether_type != ether_type_ipv4)
        throw useless{"not IPv4: EtherType " + text::hex_number(found.ether_type, 4)};
    const auto carried = ip_payload_of(found.data, static_cast<bool>(listener.tcp), fragments);
    if (carried) (carried->head.protocol == protocol_udp ? take_udp : take_tcp)(*carried, from, listener);
}

} // namespace

bool has_link_type(int type) {
    switch (type) {
    case link_type::ethernet:
    case link_type::linux_cooked:
    case link_type::linux_cooked_2:
    case link_type::null:
    case link_type::loopback:
    case link_type::raw_ip:
    case link_type::raw_ip_in_files:
    case link_type::ipv4: return true;
    default: return is_serial(type);
    }
}

void packet_reader::read(int type, std::chrono::nanoseconds time, std::span<const std::byte> frame) {
    ++from_.number;
    from_.time = time;
    try {
        if (is_serial(type))
            take_serial(type, frame, from_, listener_);
        else
            hand_over(packet_of(type, frame), from_, listener_, fragments_);
    } catch (const useless& packet) {
        listener_.skipped(packet.reason);
    }
}

void packet_reader::finish() {
    for (std::size_t i = fragments_.left_over(); i != 0; --i)
        listener_.skipped("IPv4 fragment of a packet that is not complete");
}

} // namespace jausdump
