// The functions of raw_link.
#pragma once
#include <jauscat/net/link/detail/ethernet_interface.hpp>
#include <jauscat/net/link/raw_link.hpp>

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <linux/filter.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <system_error>
#include <utility>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL raw_link::raw_link(std::string interface) : name_{std::move(interface)} {
    // Protocol 0 receives nothing; `bind` sets the EtherType, so that no frame of another interface is received.
    if (socket_.get() < 0) throw open_error{no_socket()};
    receive_datagrams_only();
    detail::limit_blocking(socket_.get());
    if (::if_nametoindex(name_.c_str()) == 0)
        throw open_error{{.code = errc::no_interface,
                          .reason = last_system_error(),
                          .message = "there is no interface " + name_ + "; " + detail::all_interfaces()}};
    if (const auto bound = bind(); !bound) throw open_error{bound.error()};
    const auto state = detail::state_of_interface(socket_.get(), name_);
    problem_ = detail::problem_of_interface(state, name_);
    if (state == detail::interface_state::down) throw open_error{{.code = errc::interface_down, .message = problem_}};
}

JAUSCAT_DECL bool raw_link::send(std::span<const std::byte> frame) {
    problem_.clear();
    lost_ = 0;
    if (frame.size() < header_size) {
        problem_ = "a frame of " + std::to_string(frame.size()) + " bytes has no Ethernet header";
        return false;
    }
    static constexpr std::array<std::byte, ethercat::min_frame_size> zeros{};
    const auto given = frame.subspan(mac_.size(), mac_.size());
    const auto source =
        std::ranges::equal(given, std::span{zeros}.first(mac_.size())) ? std::span{std::as_const(mac_)} : given;
    std::array parts{part(frame.first(mac_.size())), part(source), part(frame.subspan(2 * mac_.size())),
                     part(std::span{zeros}.subspan(std::min(zeros.size(), frame.size())))};
    msghdr message{};
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    if (::sendmsg(socket_.get(), &message, MSG_DONTWAIT) >= 0) return true;
    if (errno == ENOBUFS) { // dropped by the queue or the driver, such as until the kernel takes note of a lost link
        lost_ = errno;
        return true;
    }
    explain(errno);
    return false;
}

JAUSCAT_DECL std::size_t raw_link::receive(std::span<std::byte> buffer, duration timeout) {
    problem_.clear();
    const auto size = wait_.receive(socket_.get(), buffer, timeout, [&](int flags) { return take(buffer, flags); });
    if (size == 0 && problem_.empty() && timeout > duration{}) explain(lost_);
    return size;
}

JAUSCAT_DECL iovec raw_link::part(std::span<const std::byte> bytes) noexcept {
    return {.iov_base = const_cast<std::byte*>(bytes.data()), .iov_len = bytes.size()}; // sendmsg only reads it
}

JAUSCAT_DECL std::optional<std::size_t> raw_link::take(std::span<std::byte> buffer, int flags) {
    // MSG_TRUNC: the result is the size of the whole frame.
    const auto size = ::recv(socket_.get(), buffer.data(), buffer.size(), flags | MSG_TRUNC);
    if (size >= 0 && static_cast<std::size_t>(size) <= buffer.size()) return static_cast<std::size_t>(size);
    if (size >= 0 || errno == EAGAIN || errno == EINTR) return {};
    explain(errno);
    return 0;
}

JAUSCAT_DECL void raw_link::explain(int error) {
    problem_ = detail::problem_of_interface(detail::state_of_interface(socket_.get(), name_), name_);
    if (problem_.empty() && ::if_nametoindex(name_.c_str()) != index_) problem_ = bind().error().message;
    if (problem_.empty() && error != 0) problem_ = "interface " + name_ + ": " + std::strerror(error);
}

JAUSCAT_DECL result<void, net::error> raw_link::bind() {
    sockaddr_ll address{};
    address.sll_family = AF_PACKET;
    address.sll_protocol = htons(ethercat::ether_type_ethercat);
    address.sll_ifindex = static_cast<int>(::if_nametoindex(name_.c_str()));
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (::bind(socket_.get(), generic, size) != 0 || ::getsockname(socket_.get(), generic, &size) != 0)
        return not_opened("cannot use interface " + name_ + ": ");
    if (address.sll_hatype != ARPHRD_ETHER)
        return net::error{.code = errc::not_ethernet,
                          .message = name_ + " is not an Ethernet interface; " + detail::all_interfaces()};
    index_ = static_cast<unsigned>(address.sll_ifindex);
    std::memcpy(mac_.data(), address.sll_addr, mac_.size());
    return receive_every_destination();
}

JAUSCAT_DECL result<void, net::error> raw_link::receive_every_destination() {
    packet_mreq membership{};
    membership.mr_ifindex = static_cast<int>(index_);
    membership.mr_type = PACKET_MR_PROMISC;
    if (::setsockopt(socket_.get(), SOL_PACKET, PACKET_ADD_MEMBERSHIP, &membership, sizeof membership) == 0) return {};
    return not_opened("interface " + name_ + " cannot listen to every address: ");
}

JAUSCAT_DECL void raw_link::receive_datagrams_only() {
    constexpr unsigned ether_type_at = 12, type_at = 15, refuse = 0, take_all = 0xFFFF;
    std::array program{
        sock_filter{BPF_LD | BPF_H | BPF_ABS, 0, 0, ether_type_at},
        sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, 3, ethercat::ether_type_ethercat},
        sock_filter{BPF_LD | BPF_B | BPF_ABS, 0, 0, type_at}, // the upper 4 bits are the EtherCAT header's type
        sock_filter{BPF_ALU | BPF_RSH | BPF_K, 0, 0, 4},
        sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 1, 0, static_cast<unsigned>(ethercat::frame_type::datagrams)},
        sock_filter{BPF_RET | BPF_K, 0, 0, refuse},
        sock_filter{BPF_RET | BPF_K, 0, 0, take_all},
    };
    const sock_fprog filter{.len = program.size(), .filter = program.data()};
    if (::setsockopt(socket_.get(), SOL_SOCKET, SO_ATTACH_FILTER, &filter, sizeof filter) != 0)
        throw open_error{not_opened("the packet socket takes no filter: ")};
}

JAUSCAT_DECL net::error raw_link::not_opened(const std::string& what) {
    const auto reason = last_system_error();
    return {.code = errc::not_opened, .reason = reason, .message = what + reason.message()};
}

JAUSCAT_DECL net::error raw_link::no_socket() {
    if (errno != EPERM) return not_opened("no packet socket: ");
    const auto reason = last_system_error();
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    return {.code = errc::not_permitted,
            .reason = reason,
            .message = "raw Ethernet needs the capability CAP_NET_RAW; run once: sudo setcap cap_net_raw+ep " +
                       (unknown ? "<this program>" : program.string())};
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
