#include "capture.hpp"

#include "ip_fragments.hpp"
#include "ip_headers.hpp"
#include <jauscat/wire/decode.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <pcap/pcap.h>
#include <poll.h>
#include <vector>

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

/// Of the loopback interface of Linux, which a packet passes twice.
constexpr std::uint16_t hardware_loopback = 772;
constexpr std::uint16_t direction_outgoing = 4;

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
bool is_serial(int link_type) {
    return link_type == DLT_RTAC_SERIAL || (link_type >= DLT_USER0 && link_type <= DLT_USER15);
}

void take_serial(int link_type, bytes frame, origin& from, const capture_listener& listener) {
    from.from.clear();
    if (link_type == DLT_RTAC_SERIAL) {
        const auto event = take<rtac_serial_header>(frame, "RTAC serial").event;
        if (frame.empty()) return; // a change of the line's state
        const bool is_sent = event == rtac_event::data_tx_start || event == rtac_event::data_tx_end;
        from.from = is_sent ? "TX" : "RX";
    }
    listener.serial(frame, from);
}

packet packet_of(int link_type, bytes frame) {
    switch (link_type) {
    case DLT_EN10MB: {
        const auto ether_type = take<jauscat::ethercat::ethernet_header>(frame, "Ethernet").ether_type;
        return behind_vlan_tags(ether_type, frame);
    }
    case DLT_LINUX_SLL: {
        const auto ether_type = take<cooked_header>(frame, "Linux cooked").protocol;
        return behind_vlan_tags(ether_type, frame);
    }
    case DLT_LINUX_SLL2: {
        const auto ether_type = take<cooked_header_2>(frame, "Linux cooked").protocol;
        return behind_vlan_tags(ether_type, frame);
    }
    case DLT_NULL:
    case DLT_LOOP: return {.data = behind_address_family(frame)};
    default: return {.data = frame}; // raw IP
    }
}

bool has_link_type(int link_type) {
    switch (link_type) {
    case DLT_EN10MB:
    case DLT_LINUX_SLL:
    case DLT_LINUX_SLL2:
    case DLT_NULL:
    case DLT_LOOP:
    case DLT_RAW:
    case DLT_IPV4: return true;
    default: return is_serial(link_type);
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

std::chrono::nanoseconds time_of(const timeval& when) {
    return std::chrono::seconds{when.tv_sec} + std::chrono::nanoseconds{when.tv_usec}; // opened with nanoseconds
}

/// A packet on its way out by the loopback interface: it is seen again on its way in.
bool comes_again(int link_type, bytes frame) {
    cooked_header head{};
    return link_type == DLT_LINUX_SLL && wire::decode_prefix(head, frame) && head.direction == direction_outgoing &&
           head.hardware_type == hardware_loopback;
}

/// The next packet of a capture, or why it is of no use.
void pass_on(int link_type, const pcap_pkthdr& head, bytes frame, origin& from, const capture_listener& listener,
             ip_fragments& fragments) {
    ++from.number;
    from.time = time_of(head.ts);
    try {
        if (is_serial(link_type))
            take_serial(link_type, frame, from, listener);
        else
            hand_over(packet_of(link_type, frame), from, listener, fragments);
    } catch (const useless& packet) {
        listener.skipped(packet.reason);
    }
}

} // namespace

void read_capture(const std::string& path, const capture_listener& listener) {
    std::error_code no_size;
    const auto file_size = std::filesystem::file_size(path, no_size);
    std::array<char, PCAP_ERRBUF_SIZE> problem{};
    const std::unique_ptr<pcap_t, decltype(&pcap_close)> file{
        pcap_open_offline_with_tstamp_precision(path.c_str(), PCAP_TSTAMP_PRECISION_NANO, problem.data()), &pcap_close};
    if (!file) { // some of libpcap's messages name the file, others do not
        const std::string why{problem.data()};
        throw input_error{why.starts_with(path) ? why : path + ": " + why};
    }
    const int link_type = pcap_datalink(file.get());
    if (!has_link_type(link_type)) {
        const char* name = pcap_datalink_val_to_name(link_type);
        throw input_error{
            path + ": link type " + (name != nullptr ? name : std::to_string(link_type)) +
            " is not supported: Ethernet, Linux cooked, raw IP, loopback, RTAC serial and USER0 to USER15 are"};
    }

    ip_fragments fragments;
    const auto tell_left_over = [&] {
        for (std::size_t i = fragments.left_over(); i != 0; --i)
            listener.skipped("IPv4 fragment of a packet that is not complete");
    };
    origin from{.place = "packet"};
    for (;;) {
        pcap_pkthdr* head = nullptr;
        const unsigned char* data = nullptr;
        const int got = pcap_next_ex(file.get(), &head, &data);
        if (got == PCAP_ERROR_BREAK || listener.stop()) return tell_left_over();
        if (got != 1)
            throw input_error{path + ": after packet " + std::to_string(from.number) + ": " + pcap_geterr(file.get())};
        pass_on(link_type, *head, std::as_bytes(std::span{data, head->caplen}), from, listener, fragments);
        if (!no_size && file_size != 0)
            listener.progress(static_cast<double>(std::ftell(pcap_file(file.get()))) / static_cast<double>(file_size));
    }
}

port_capture::port_capture(std::uint16_t port) : packets_{nullptr, &pcap_close} {
    constexpr int longest = 65535, wait_ms = 100;
    std::array<char, PCAP_ERRBUF_SIZE> problem{};
    const auto require = [&](bool good) {
        if (good) return;
        const char* const why = packets_ ? pcap_geterr(packets_.get()) : problem.data();
        const auto number = std::to_string(port);
        throw input_error{"UDP port " + number + " is taken by another program, and its messages cannot be captured (" +
                          why + "); run jausdump as root, or: sudo tcpdump -i any -U -w - udp port " + number +
                          " | jausdump -"};
    };
    packets_.reset(pcap_create("any", problem.data()));
    require(packets_ != nullptr);
    auto* const packets = packets_.get();
    pcap_set_snaplen(packets, longest);
    pcap_set_immediate_mode(packets, 1);
    pcap_set_timeout(packets, wait_ms);
    pcap_set_tstamp_precision(packets, PCAP_TSTAMP_PRECISION_NANO);
    require(pcap_activate(packets) >= 0);
    bpf_program filter{};
    const auto wanted = "udp port " + std::to_string(port) + " or tcp port " + std::to_string(port) +
                        " or (ip proto 17 and ip[6:2] & 0x1fff != 0)";
    require(pcap_compile(packets, &filter, wanted.c_str(), 1, PCAP_NETMASK_UNKNOWN) == 0);
    const int filtered = pcap_setfilter(packets, &filter);
    pcap_freecode(&filter);
    require(filtered == 0 && pcap_setnonblock(packets, 1, problem.data()) == 0);
}

void port_capture::run(const capture_listener& listener) {
    auto* const packets = packets_.get();
    const int link_type = pcap_datalink(packets);
    ip_fragments fragments;
    origin from{.place = "packet"};
    while (!listener.stop()) {
        pcap_pkthdr* head = nullptr;
        const unsigned char* data = nullptr;
        const int got = pcap_next_ex(packets, &head, &data);
        if (got < 0) throw input_error{std::string{"the capture ends: "} + pcap_geterr(packets)};
        if (got == 0) {
            pollfd readable{.fd = pcap_get_selectable_fd(packets), .events = POLLIN, .revents = 0};
            ::poll(&readable, 1, 100);
            continue;
        }
        const bytes frame = std::as_bytes(std::span{data, head->caplen});
        if (!comes_again(link_type, frame)) pass_on(link_type, *head, frame, from, listener, fragments);
    }
}

} // namespace jausdump
