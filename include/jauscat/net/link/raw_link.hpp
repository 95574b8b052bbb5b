// EtherCAT on an Ethernet interface: a packet socket (Linux AF_PACKET) that receives EtherCAT datagrams only.
// Needs the capability CAP_NET_RAW.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/net/link/detail/ethernet_interface.hpp>
#include <jauscat/net/link/detail/file_descriptor.hpp>
#include <jauscat/net/link/detail/frame_wait.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/schema/ethercat/frame.hpp>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <linux/filter.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <optional>
#include <span>
#include <string>
#include <sys/socket.h>
#include <sys/uio.h>
#include <system_error>
#include <utility>

namespace jauscat::net {

/// A link on a network interface, for a master or a slave.
///
/// Own frames are not received: the kernel copies outgoing frames only to sockets for every EtherType. The kernel
/// removes a reply's VLAN tag before it checks the EtherType. While the interface is down, without link or removed,
/// `problem()` reports that; the link need not be opened again.
class raw_link {
  public:
    /// Opens the interface of that name, such as "eth0". Throws `open_error` without the capability, and if the
    /// interface does not exist, is down or is not Ethernet. It need not have a link yet: `problem()` reports that.
    explicit raw_link(std::string interface) : name_{std::move(interface)} {
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
        if (state == detail::interface_state::down)
            throw open_error{{.code = errc::interface_down, .message = problem_}};
    }

    /// Takes the socket over.
    raw_link(raw_link&&) = default;

    /// Sends a frame, padded to 60 bytes, with the interface's address as source if the frame has zeros there.
    /// False if it has no Ethernet header or the interface refuses it; `problem()` has the reason.
    [[nodiscard]] bool send(std::span<const std::byte> frame) {
        problem_.clear();
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
        explain(errno);
        return false;
    }

    /// The next frame, padded to 60 bytes. `buffer` must have 60 bytes, or nothing is received; 1514 hold every frame.
    /// Without a frame, `problem()` reports whether the interface is the reason.
    [[nodiscard]] std::size_t receive(std::span<std::byte> buffer, duration timeout) {
        problem_.clear();
        const auto size = wait_.receive(socket_.get(), buffer, timeout, [&](int flags) { return take(buffer, flags); });
        if (size == 0 && problem_.empty() && timeout > duration{}) explain(0);
        return size;
    }

    /// The reason for the failure of the last `send` or `receive`, in one line; empty without a failure, and for a
    /// timeout with a ready interface.
    const std::string& problem() const noexcept { return problem_; }

    /// The socket, for select or poll: when it is readable, `receive` does not wait.
    [[nodiscard]] int native_handle() const noexcept { return socket_.get(); }
    /// The interface's Ethernet address.
    const std::array<std::byte, 6>& mac() const noexcept { return mac_; }

    /// Time for which `receive` polls before it sleeps; default 50 microseconds.
    void busy_poll(duration time) noexcept { wait_.busy_poll(time); }

  private:
    static constexpr std::size_t header_size = wire::max_size<ethercat::ethernet_header>;

    static iovec part(std::span<const std::byte> bytes) noexcept {
        return {.iov_base = const_cast<std::byte*>(bytes.data()), .iov_len = bytes.size()}; // sendmsg only reads it
    }

    std::optional<std::size_t> take(std::span<std::byte> buffer, int flags) {
        // MSG_TRUNC: the result is the size of the whole frame.
        const auto size = ::recv(socket_.get(), buffer.data(), buffer.size(), flags | MSG_TRUNC);
        if (size >= 0 && static_cast<std::size_t>(size) <= buffer.size()) return static_cast<std::size_t>(size);
        if (size >= 0 || errno == EAGAIN || errno == EINTR) return {};
        explain(errno);
        return 0;
    }

    /// Determines the reason for a failure with `error`, or for a missing frame (0). Binds again to an interface that
    /// was removed and has returned under its name, such as a USB adapter.
    void explain(int error) {
        problem_ = detail::problem_of_interface(detail::state_of_interface(socket_.get(), name_), name_);
        if (problem_.empty() && ::if_nametoindex(name_.c_str()) != index_) problem_ = bind().error().message;
        if (problem_.empty() && error != 0) problem_ = "interface " + name_ + ": " + std::strerror(error);
    }

    /// Binds to the interface that has the name now.
    [[nodiscard]] result<void, net::error> bind() {
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

    /// Slaves accept any destination address, so a link must, too: it is promiscuous while it is open.
    [[nodiscard]] result<void, net::error> receive_every_destination() {
        packet_mreq membership{};
        membership.mr_ifindex = static_cast<int>(index_);
        membership.mr_type = PACKET_MR_PROMISC;
        if (::setsockopt(socket_.get(), SOL_PACKET, PACKET_ADD_MEMBERSHIP, &membership, sizeof membership) == 0)
            return {};
        return not_opened("interface " + name_ + " cannot listen to every address: ");
    }

    /// Other frames of the EtherType, such as network variables, would wake the receiver without need.
    ///
    /// Two other options were measured and are not used: PACKET_QDISC_BYPASS saves 0.1 of 3.6 microseconds, and hides
    /// sent frames from captures on this machine; SO_BUSY_POLL makes no difference at a packet socket.
    void receive_datagrams_only() {
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

    /// The system's last error.
    static net::error not_opened(const std::string& what) {
        const auto reason = last_system_error();
        return {.code = errc::not_opened, .reason = reason, .message = what + reason.message()};
    }
    static net::error no_socket() {
        if (errno != EPERM) return not_opened("no packet socket: ");
        const auto reason = last_system_error();
        std::error_code unknown;
        const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
        return {.code = errc::not_permitted,
                .reason = reason,
                .message = "raw Ethernet needs the capability CAP_NET_RAW; run once: sudo setcap cap_net_raw+ep " +
                           (unknown ? "<this program>" : program.string())};
    }

    detail::file_descriptor socket_{::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC, 0)};
    detail::frame_wait wait_{std::chrono::microseconds{50}};
    std::string name_;
    unsigned index_{};
    std::array<std::byte, 6> mac_{};
    std::string problem_{};
};

} // namespace jauscat::net
