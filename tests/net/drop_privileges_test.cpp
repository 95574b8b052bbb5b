// Privileges are gone for good after drop_privileges, and open sockets stay. Each case runs in a process of its own.
#include "support/catch.hpp"
#include <jauscat/net/link/detail/ethernet_interface.hpp>
#include <jauscat/net/link/drop_privileges.hpp>

#include <arpa/inet.h>
#include <iostream>
#include <linux/if_packet.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/wait.h>

using namespace jauscat;

namespace {

/// What `work` returns, 0 to 255, in a child process; 255 for an exception.
template <class Work> int in_child(Work work) {
    std::cout.flush();
    const auto child = ::fork();
    if (child == 0) {
        try {
            ::_exit(work());
        } catch (...) {
            ::_exit(255);
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 254;
}

int raw_socket() { return ::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC, 0); }

bool may_open_raw_sockets() {
    const int socket = raw_socket();
    if (socket >= 0) ::close(socket);
    if (socket < 0) std::cout << "SKIPPED: raw sockets need CAP_NET_RAW\n";
    return socket >= 0;
}

/// What a raw_link does all the time, and when its interface has come back.
bool works(int socket) {
    char byte{};
    sockaddr_ll address{};
    address.sll_family = AF_PACKET;
    address.sll_ifindex = static_cast<int>(::if_nametoindex("lo"));
    packet_mreq every_destination{};
    every_destination.mr_ifindex = address.sll_ifindex;
    every_destination.mr_type = PACKET_MR_PROMISC;
    return net::detail::state_of_interface(socket, "lo") != net::detail::interface_state::gone &&
           ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
           ::setsockopt(socket, SOL_PACKET, PACKET_ADD_MEMBERSHIP, &every_destination, sizeof every_destination) == 0 &&
           ::recv(socket, &byte, 1, MSG_DONTWAIT) < 0 && errno == EAGAIN;
}

} // namespace

TEST_CASE("after privileges were dropped no raw socket can be opened, and the open one works") {
    if (!may_open_raw_sockets()) return;
    CHECK(in_child([] {
              ::unsetenv("SUDO_UID");
              const int open = raw_socket();
              if (!net::drop_privileges()) return 1;
              if (raw_socket() >= 0 || errno != EPERM) return 2;
              return works(open) ? 0 : 3;
          }) == 0);
}

TEST_CASE("a program started by sudo permanently becomes the user who called it") {
    if (::geteuid() != 0) {
        std::cout << "SKIPPED: only root can become another user\n";
        return;
    }
    CHECK(in_child([] {
              ::setenv("SUDO_UID", "12345", 1);
              ::setenv("SUDO_GID", "23456", 1);
              const int open = raw_socket();
              if (!net::drop_privileges()) return 1;
              if (::getuid() != 12345 || ::geteuid() != 12345 || ::getgid() != 23456 || ::getegid() != 23456) return 2;
              if (::getgroups(0, nullptr) != 0) return 3;
              if (::setuid(0) == 0 || ::seteuid(0) == 0 || ::setgid(0) == 0) return 4;
              if (raw_socket() >= 0) return 5;
              return open < 0 || works(open) ? 0 : 6;
          }) == 0);
}

TEST_CASE("a program without privileges drops none") {
    CHECK(in_child([] {
              if (::geteuid() == 0 && ::setresuid(12345, 12345, 12345) != 0) return 1;
              ::setenv("SUDO_UID", "0", 1); // whoever sets it gains nothing
              if (!net::drop_privileges()) return 2;
              if (!net::drop_privileges()) return 3;
              return ::getuid() == 0 || raw_socket() >= 0 ? 4 : 0;
          }) == 0);
}

TEST_CASE("a program executed after privileges were dropped has none") {
    if (!may_open_raw_sockets()) return;
    CHECK(in_child([] {
              ::unsetenv("SUDO_UID");
              if (!net::drop_privileges()) return 1;
              ::execl("/bin/sh", "sh", "-c", "grep -q '^CapEff:[[:space:]]*0*$' /proc/self/status",
                      static_cast<char*>(nullptr));
              return 2;
          }) == 0);
}
