// State of a network interface.
#pragma once

#include <cstring>
#include <net/if.h>
#include <string>
#include <sys/ioctl.h>

namespace jauscat::net::detail {

enum class interface_state { ready, no_link, down, gone };

/// The state of the interface `name`; `socket` is any socket.
inline interface_state state_of_interface(int socket, const std::string& name) noexcept {
    ifreq request{};
    if (name.size() >= sizeof request.ifr_name) return interface_state::gone;
    std::memcpy(request.ifr_name, name.data(), name.size());
    if (::ioctl(socket, SIOCGIFFLAGS, &request) != 0) return interface_state::gone;
    const auto flags = static_cast<unsigned>(request.ifr_flags);
    if ((flags & IFF_UP) == 0) return interface_state::down;
    return (flags & IFF_RUNNING) == 0 ? interface_state::no_link : interface_state::ready;
}

/// The reason why the interface `name` is not ready, in one line with what to do; empty if it is ready.
inline std::string problem_of_interface(interface_state state, const std::string& name) {
    switch (state) {
    case interface_state::ready: break;
    case interface_state::no_link: return "no link on " + name + ": is the cable in, and the other end on?";
    case interface_state::down: return "interface " + name + " is down; run: sudo ip link set " + name + " up";
    case interface_state::gone: return "interface " + name + " is gone";
    }
    return {};
}

/// "this machine has: lo, eth0"
inline std::string all_interfaces() {
    std::string names;
    if (auto* const all = ::if_nameindex()) {
        for (const auto* one = all; one->if_index != 0; ++one)
            names += std::string{names.empty() ? "" : ", "} + one->if_name;
        ::if_freenameindex(all);
    }
    return "this machine has: " + names;
}

} // namespace jauscat::net::detail
