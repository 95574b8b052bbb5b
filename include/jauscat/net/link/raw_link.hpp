// EtherCAT on an Ethernet interface: a packet socket (Linux AF_PACKET) that receives EtherCAT datagrams only.
// Needs the capability CAP_NET_RAW.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/net/link/detail/file_descriptor.hpp>
#include <jauscat/net/link/detail/frame_wait.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/schema/ethercat/frame.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <sys/socket.h>
#include <sys/uio.h>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// A link on a network interface, for a master or a slave.
///
/// Own frames are not received: the kernel copies outgoing frames only to sockets for every EtherType. The kernel
/// removes a reply's VLAN tag before it checks the EtherType. While the interface is down, without link or removed,
/// `problem()` reports that; the link need not be opened again.
class raw_link {
  public:
    /// Opens the interface of that name, such as "eth0". Throws `open_error` without the capability, and if the
    /// interface does not exist, is down or is not Ethernet. It need not have a link yet: `problem()` reports that.
    JAUSCAT_DECL explicit raw_link(std::string interface);

    /// Takes the socket over.
    raw_link(raw_link&&) = default;

    /// Sends a frame, padded to 60 bytes, with the interface's address as source if the frame has zeros there.
    /// False if it has no Ethernet header or the interface refuses it; `problem()` has the reason. A frame that the
    /// interface accepts and drops is lost as on the wire: true, and a `receive` without a frame reports it.
    [[nodiscard]] JAUSCAT_DECL bool send(std::span<const std::byte> frame);

    /// The next frame, padded to 60 bytes. `buffer` must have 60 bytes, or nothing is received; 1514 hold every frame.
    /// Without a frame, `problem()` reports whether the interface is the reason.
    [[nodiscard]] JAUSCAT_DECL std::size_t receive(std::span<std::byte> buffer, duration timeout);

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

    JAUSCAT_DECL static iovec part(std::span<const std::byte> bytes) noexcept;

    JAUSCAT_DECL std::optional<std::size_t> take(std::span<std::byte> buffer, int flags);

    /// Determines the reason for a failure or a missing frame; `error` is the system's, or 0. Binds again to an
    /// interface that was removed and has returned under its name, such as a USB adapter.
    JAUSCAT_DECL void explain(int error);

    /// Binds to the interface that has the name now.
    [[nodiscard]] JAUSCAT_DECL result<void, net::error> bind();

    /// Slaves accept any destination address, so a link must, too: it is promiscuous while it is open.
    [[nodiscard]] JAUSCAT_DECL result<void, net::error> receive_every_destination();

    /// Other frames of the EtherType, such as network variables, would wake the receiver without need.
    ///
    /// Two other options were measured and are not used: PACKET_QDISC_BYPASS saves 0.1 of 3.6 microseconds, and hides
    /// sent frames from captures on this machine; SO_BUSY_POLL makes no difference at a packet socket.
    JAUSCAT_DECL void receive_datagrams_only();

    /// The system's last error.
    JAUSCAT_DECL static net::error not_opened(const std::string& what);
    JAUSCAT_DECL static net::error no_socket();

    detail::file_descriptor socket_{::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC, 0)};
    detail::frame_wait wait_{std::chrono::microseconds{50}};
    std::string name_;
    unsigned index_{};
    std::array<std::byte, 6> mac_{};
    std::string problem_{};
    int lost_{}; ///< the system's error that dropped the last frame sent, or 0
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/link/impl/raw_link.ipp>
#endif
