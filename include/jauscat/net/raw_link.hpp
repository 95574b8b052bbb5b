// EtherCAT on an Ethernet interface: a packet socket (Linux AF_PACKET) that sees frames of EtherType 88A4h alone.
// It needs the capability CAP_NET_RAW.
#pragma once

#include <jauscat/net/detail/receive_frame.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/schema/ethercat/frame.hpp>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/generic/raw_protocol.hpp>
#include <boost/asio/io_context.hpp>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <linux/if_packet.h>
#include <memory>
#include <net/if.h>
#include <net/if_arp.h>
#include <optional>
#include <span>
#include <string>
#include <sys/socket.h>
#include <system_error>
#include <utility>

namespace jauscat::net {

/// A link on a network interface, for a master or a slave.
///
/// Own frames are not heard: the kernel copies outgoing frames only to sockets for every EtherType. A reply's VLAN tag
/// has been taken off by the kernel before the EtherType is looked at. When the interface goes down, `send` and
/// `receive` fail with a `problem()` until it is up again; the link need not be opened anew.
class raw_link {
  public:
    /// Opens the interface of that name, such as "eth0". Throws `open_error` when the program may not, when there is
    /// no such interface, when it is down, and when it is not Ethernet.
    explicit raw_link(std::string interface) : name_{std::move(interface)} {
        using protocol = boost::asio::generic::raw_protocol;
        boost::system::error_code error;
        // Protocol 0 receives nothing; `bind` sets the EtherType, so that no other interface's frame slips in between.
        socket_.open(protocol{AF_PACKET, 0}, error);
        if (error == boost::system::errc::operation_not_permitted) throw open_error{not_permitted()};
        if (error) throw open_error{"no packet socket: " + error.message()};

        sockaddr_ll address{};
        address.sll_family = AF_PACKET;
        address.sll_protocol = htons(ethercat::ether_type_ethercat);
        address.sll_ifindex = static_cast<int>(::if_nametoindex(name_.c_str()));
        if (address.sll_ifindex == 0) throw open_error{no_such_interface()};
        socket_.bind({&address, sizeof address}, error);
        if (error) throw open_error{"cannot use interface " + name_ + ": " + error.message()};

        const auto bound = socket_.local_endpoint();
        std::memcpy(&address, bound.data(), std::min(bound.size(), sizeof address));
        if (address.sll_hatype != ARPHRD_ETHER) throw open_error{name_ + " is not an Ethernet interface; " + choice()};
        std::memcpy(mac_.data(), address.sll_addr, mac_.size());
        if (pending_error() == ENETDOWN)
            throw open_error{"interface " + name_ + " is down; run: sudo ip link set " + name_ + " up"};

        hear_every_destination(address.sll_ifindex);
        socket_.non_blocking(true);
    }

    raw_link(raw_link&&) = default; ///< no assignment: a socket goes before its io_context

    /// Sends a frame, padded to 60 bytes, with the interface's address as source if the frame has zeros there.
    /// False when it has no Ethernet header or the interface does not take it; `problem()` says why.
    bool send(std::span<const std::byte> frame) {
        using boost::asio::const_buffer;
        if (frame.size() < header_size) {
            problem_ = "a frame of " + std::to_string(frame.size()) + " bytes has no Ethernet header";
            return false;
        }
        static constexpr std::array<std::byte, ethercat::min_frame_size> zeros{};
        const auto given = frame.subspan(mac_.size(), mac_.size());
        const auto source =
            std::ranges::equal(given, std::span{zeros}.first(mac_.size())) ? std::span{std::as_const(mac_)} : given;
        const std::array parts{const_buffer{frame.data(), mac_.size()}, const_buffer{source.data(), source.size()},
                               const_buffer{frame.data() + 2 * mac_.size(), frame.size() - 2 * mac_.size()},
                               const_buffer{zeros.data(), zeros.size() - std::min(zeros.size(), frame.size())}};
        boost::system::error_code error;
        socket_.send(parts, 0, error);
        return !failed(error);
    }

    /// The next frame, padded to 60 bytes. `buffer` takes at least 60 bytes, or nothing is received; 1514 take all.
    std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) {
        problem_.clear();
        return detail::receive_frame(socket_.native_handle(), buffer, timeout, busy_poll_,
                                     [&] { return take(buffer); });
    }

    /// Why the last `send` or `receive` failed, in one line; empty if it did not, or if nothing came in time.
    const std::string& problem() const noexcept { return problem_; }

    /// The interface's Ethernet address.
    const std::array<std::byte, 6>& mac() const noexcept { return mac_; }

    /// How long `receive` polls before it sleeps; 20 microseconds unless set.
    void busy_poll(std::chrono::nanoseconds time) noexcept { busy_poll_ = time; }

  private:
    static constexpr std::size_t header_size = wire::max_size<ethercat::ethernet_header>;

    std::optional<std::size_t> take(std::span<std::byte> buffer) {
        boost::system::error_code error;
        const auto size = socket_.receive(boost::asio::buffer(buffer.data(), buffer.size()), MSG_TRUNC, error);
        if (error == boost::asio::error::would_block) return {};
        if (failed(error)) return 0;
        return size <= buffer.size() ? std::optional{size}
                                     : std::nullopt; // MSG_TRUNC told the true size of a larger one
    }

    bool failed(boost::system::error_code error) {
        problem_.clear();
        if (error) problem_ = "interface " + name_ + ": " + error.message();
        return static_cast<bool>(error);
    }

    /// Slaves take any destination address, so a link takes all of them: it listens promiscuously while it is open.
    void hear_every_destination(int interface_index) {
        packet_mreq membership{};
        membership.mr_ifindex = interface_index;
        membership.mr_type = PACKET_MR_PROMISC;
        if (::setsockopt(socket_.native_handle(), SOL_PACKET, PACKET_ADD_MEMBERSHIP, &membership, sizeof membership) !=
            0)
            throw open_error{"interface " + name_ + " cannot listen to every address: " + std::strerror(errno)};
    }

    int pending_error() {
        int error = 0;
        socklen_t size = sizeof error;
        ::getsockopt(socket_.native_handle(), SOL_SOCKET, SO_ERROR, &error, &size);
        return error;
    }

    static std::string not_permitted() {
        std::error_code unknown;
        const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
        return "raw Ethernet needs the capability CAP_NET_RAW; run once: sudo setcap cap_net_raw+ep " +
               (unknown ? "<this program>" : program.string());
    }

    std::string no_such_interface() const { return "there is no interface " + name_ + "; " + choice(); }

    static std::string choice() {
        std::string names;
        if (auto* const all = ::if_nameindex()) {
            for (const auto* one = all; one->if_index != 0; ++one)
                names += std::string{names.empty() ? "" : ", "} + one->if_name;
            ::if_freenameindex(all);
        }
        return "this machine has: " + names;
    }

    std::unique_ptr<boost::asio::io_context> context_{std::make_unique<boost::asio::io_context>()};
    boost::asio::generic::raw_protocol::socket socket_{*context_};
    std::string name_;
    std::array<std::byte, 6> mac_{};
    std::chrono::nanoseconds busy_poll_{std::chrono::microseconds{20}};
    std::string problem_{};
};

} // namespace jauscat::net
