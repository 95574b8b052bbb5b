#include "capture.hpp"

#include "ip_headers.hpp"
#include <jauscat/wire/decode.hpp>

#include <filesystem>
#include <memory>
#include <pcap/pcap.h>
#include <poll.h>

namespace jausdump {

namespace {

using bytes = std::span<const std::byte>;

/// Of the loopback interface of Linux, which a packet passes twice.
constexpr std::uint16_t hardware_loopback = 772;
constexpr std::uint16_t direction_outgoing = 4;

std::chrono::nanoseconds time_of(const timeval& when) {
    return std::chrono::seconds{when.tv_sec} + std::chrono::nanoseconds{when.tv_usec}; // opened with nanoseconds
}

/// A packet on its way out by the loopback interface: it is seen again on its way in.
bool comes_again(int type, bytes frame) {
    cooked_header head{};
    return type == link_type::linux_cooked && wire::decode_prefix(head, frame) &&
           head.direction == direction_outgoing && head.hardware_type == hardware_loopback;
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
    const int type = pcap_datalink(file.get());
    if (!has_link_type(type)) {
        const char* name = pcap_datalink_val_to_name(type);
        throw input_error{
            path + ": link type " + (name != nullptr ? name : std::to_string(type)) +
            " is not supported: Ethernet, Linux cooked, raw IP, loopback, RTAC serial and USER0 to USER15 are"};
    }

    packet_reader packets{listener};
    std::size_t read = 0;
    for (;;) {
        pcap_pkthdr* head = nullptr;
        const unsigned char* data = nullptr;
        const int got = pcap_next_ex(file.get(), &head, &data);
        if (got == PCAP_ERROR_BREAK || listener.stop()) return packets.finish();
        if (got != 1)
            throw input_error{path + ": after packet " + std::to_string(read) + ": " + pcap_geterr(file.get())};
        const captured_packet packet{type, time_of(head->ts), std::as_bytes(std::span{data, head->caplen}), head->len};
        packets.read(type, packet.time, packet.frame);
        if (listener.packet) listener.packet(packet);
        ++read;
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
    const int type = pcap_datalink(packets);
    packet_reader reader{listener};
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
        if (comes_again(type, frame)) continue;
        reader.read(type, time_of(head->ts), frame);
        if (listener.packet) listener.packet({type, time_of(head->ts), frame, head->len});
    }
}

} // namespace jausdump
