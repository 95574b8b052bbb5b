#include "capture_writer.hpp"

#include "ip_headers.hpp"
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/sae/transport/judp.hpp>
#include <jauscat/wire/encode.hpp>

#include <boost/asio/ip/address_v4.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <pcap/pcap.h>

namespace jausdump {

namespace {

using bytes = std::span<const std::byte>;

constexpr int longest_packet = 262144; // of libpcap

struct ip_endpoint {
    std::array<std::byte, 4> ip{};
    std::uint16_t port{};
};

/// "10.0.0.1:3794"
ip_endpoint endpoint_of(const std::string& text) {
    const auto colon = text.rfind(':');
    const auto ip = boost::asio::ip::make_address_v4(text.substr(0, colon)).to_bytes();
    ip_endpoint made{.port = static_cast<std::uint16_t>(std::stoul(text.substr(colon + 1)))};
    std::ranges::transform(ip, made.ip.begin(), [](unsigned char octet) { return std::byte{octet}; });
    return made;
}

/// RFC 1071, of whole 16-bit words.
std::uint16_t checksum(bytes header) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i + 1 < header.size(); i += 2)
        sum += std::to_integer<std::uint32_t>(header[i]) << 8 | std::to_integer<std::uint32_t>(header[i + 1]);
    while (sum > 0xFFFF) sum = (sum & 0xFFFF) + (sum >> 16);
    return static_cast<std::uint16_t>(~sum);
}

/// A frame with the datagram. The stations' addresses are 0, the UDP checksum is left out.
std::vector<std::byte> frame_of(bytes payload, const origin& from) {
    namespace ethercat = jauscat::ethercat;
    constexpr std::size_t ip_size = wire::min_size<ipv4_header>, udp_size = wire::min_size<udp_header>;
    constexpr std::size_t ethernet_size = wire::min_size<ethercat::ethernet_header>;
    constexpr std::size_t headers = ethernet_size + ip_size + udp_size;
    std::vector<std::byte> frame(headers);
    const std::span all{frame};
    const auto source = endpoint_of(from.from), destination = endpoint_of(from.to);
    ipv4_header ip{.words = ip_size / 4,
                   .version = 4,
                   .total_size = static_cast<std::uint16_t>(ip_size + udp_size + payload.size()),
                   .time_to_live = 64,
                   .protocol = 17,
                   .source = source.ip,
                   .destination = destination.ip};
    ethercat::ethernet_header ethernet{};
    ethernet.ether_type = 0x0800;
    const udp_header udp{.source_port = source.port,
                         .destination_port = destination.port,
                         .size = static_cast<std::uint16_t>(udp_size + payload.size())};
    const auto ip_bytes = all.subspan(ethernet_size, ip_size);
    static_cast<void>(wire::encode(ethernet, all)); // they fit
    static_cast<void>(wire::encode(ip, ip_bytes));
    ip.checksum = checksum(ip_bytes);
    static_cast<void>(wire::encode(ip, ip_bytes));
    static_cast<void>(wire::encode(udp, all.subspan(ethernet_size + ip_size)));
    frame.insert(frame.end(), payload.begin(), payload.end());
    return frame;
}

int close_file(std::FILE* file) { return std::fclose(file); }

} // namespace

bool is_part_of_message(bytes datagram) {
    if (jaus::form_of(datagram) != jaus::datagram_form::judp2) return false;
    for (bytes rest = datagram.subspan(1); !rest.empty();) {
        const auto message = sae::split(rest);
        if (message.header.fragment_flag != sae::fragment_flag::single) return true;
        rest = message.rest;
    }
    return false;
}

capture_writer::capture_writer(const std::string& path, const std::string& source)
    : path_{path}, opened_{nullptr, &close_file}, format_{nullptr, &pcap_close}, file_{nullptr, &pcap_dump_close} {
    std::error_code is_missing;
    if (!source.empty() && std::filesystem::equivalent(path, source, is_missing))
        throw input_error{"--write " + path + ": this is the capture that is read"};
    opened_.reset(std::fopen(path.c_str(), "wb"));
    if (!opened_) throw input_error{"--write " + path + ": " + std::strerror(errno)};
}

capture_writer::~capture_writer() = default;

void capture_writer::require(bool good) const {
    if (!good) throw std::runtime_error{"--write " + path_ + ": " + std::strerror(errno)};
}

void capture_writer::follow(options& how) {
    how.on_message = [this] { has_message_ = true; };
    how.on_skipped = [this] { is_skipped_ = true; };
}

void capture_writer::follow(capture_listener& listener, bool live) {
    listener.datagram = [this, pass_on = std::move(listener.datagram)](auto payload, const auto& from) {
        datagram_ = payload;
        pass_on(payload, from);
    };
    if (listener.ethercat)
        listener.ethercat = [this, pass_on = std::move(listener.ethercat)](auto frame, const auto& from) {
            is_ethercat_ = true;
            pass_on(frame, from);
        };
    listener.packet = [this, live](const captured_packet& packet) {
        bool is_wanted = !is_skipped_ || is_ethercat_;
        if (datagram_) {
            // One that is not in this packet alone came in fragments, of which those before are in the file.
            const bool is_whole = datagram_->empty() || (datagram_->data() >= packet.frame.data() &&
                                                         datagram_->data() < packet.frame.data() + packet.frame.size());
            is_wanted = has_message_ || !is_whole || is_part_of_message(*datagram_);
        }
        if (is_wanted) write(packet, live);
        has_message_ = is_skipped_ = is_ethercat_ = false;
        datagram_.reset();
    };
}

void capture_writer::on_datagram(bytes payload, const origin& from) {
    if (std::exchange(has_message_, false) || is_part_of_message(payload)) {
        const auto frame = frame_of(payload, from);
        write({link_type::ethernet, from.time.value_or(std::chrono::nanoseconds{}), frame, frame.size()}, true);
    }
    is_skipped_ = false;
}

void capture_writer::begin(int link_type) {
    if (file_) return;
    format_.reset(pcap_open_dead_with_tstamp_precision(link_type, longest_packet, PCAP_TSTAMP_PRECISION_NANO));
    require(format_ != nullptr);
    file_.reset(pcap_dump_fopen(format_.get(), opened_.get()));
    require(file_ != nullptr);
    static_cast<void>(opened_.release()); // it is closed with the dumper now
}

void capture_writer::write(const captured_packet& packet, bool flush) {
    begin(packet.link_type);
    const auto seconds = std::chrono::floor<std::chrono::seconds>(packet.time);
    pcap_pkthdr head{};
    head.ts.tv_sec = static_cast<decltype(head.ts.tv_sec)>(seconds.count());
    head.ts.tv_usec = static_cast<decltype(head.ts.tv_usec)>((packet.time - seconds).count()); // nanoseconds
    head.caplen = static_cast<bpf_u_int32>(packet.frame.size());
    head.len = static_cast<bpf_u_int32>(packet.size);
    pcap_dump(reinterpret_cast<unsigned char*>(file_.get()), &head,
              reinterpret_cast<const unsigned char*>(packet.frame.data()));
    require(std::ferror(pcap_dump_file(file_.get())) == 0);
    if (flush) require(pcap_dump_flush(file_.get()) == 0);
}

void capture_writer::finish() {
    begin(link_type::ethernet); // a file without a packet
    require(pcap_dump_flush(file_.get()) == 0);
}

} // namespace jausdump
