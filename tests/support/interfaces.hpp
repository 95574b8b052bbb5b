// The interfaces of the network namespace that a test runs in: see in_veth.sh.
#pragma once

#include <cstdlib>
#include <string>

namespace support {

/// Changes or checks them with `ip`. True when that was done.
inline bool ip(const std::string& arguments) { return std::system(("ip " + arguments).c_str()) == 0; }

/// Waits until the kernel has taken note of a cable, which it does a moment after it was put in or out. `state` is as
/// `ip link` says it, such as UP, or LOWERLAYERDOWN while the other end is down. False when that does not come.
inline bool comes_to(const std::string& state, const std::string& interface) {
    const auto is_so = "ip link show " + interface + " | grep -q 'state " + state + " '";
    return std::system(("for i in $(seq 1000); do " + is_so + " && exit 0; sleep 0.01; done; exit 1").c_str()) == 0;
}

} // namespace support
