// Two UDP sockets on the loopback interface, one sending to the other.
#pragma once
#include <cstddef>
#include <netinet/in.h>
#include <span>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

namespace support {

class udp_pair {
  public:
    udp_pair() {
        for (const int socket : {from_, to_})
            if (socket < 0) throw std::runtime_error{"no UDP socket"};
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        const timeval patience{.tv_sec = 5, .tv_usec = 0};
        auto* const generic = reinterpret_cast<sockaddr*>(&address);
        if (::bind(to_, generic, size) != 0 || ::getsockname(to_, generic, &size) != 0 ||
            ::connect(from_, generic, size) != 0 ||
            ::setsockopt(to_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience) != 0)
            throw std::runtime_error{"no UDP on the loopback interface"};
    }
    ~udp_pair() {
        ::close(from_);
        ::close(to_);
    }
    udp_pair(const udp_pair&) = delete;
    udp_pair& operator=(const udp_pair&) = delete;

    /// What arrives of `datagram`; nothing where none does within five seconds.
    std::vector<std::byte> carry(std::span<const std::byte> datagram) {
        std::vector<std::byte> received(65536);
        if (::send(from_, datagram.data(), datagram.size(), 0) < 0) return {};
        const auto size = ::recv(to_, received.data(), received.size(), 0);
        received.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
        return received;
    }

  private:
    int from_ = ::socket(AF_INET, SOCK_DGRAM, 0);
    int to_ = ::socket(AF_INET, SOCK_DGRAM, 0);
};

} // namespace support
