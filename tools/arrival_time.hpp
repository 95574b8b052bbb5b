// When the frame arrived that was received last, for emulated slaves with distributed clocks.
#pragma once
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <linux/sockios.h>
#include <sys/ioctl.h>

/// By the kernel's note: this program may have been woken up later. The first call switches the notes on.
inline jauscat::time_point arrival_time(int socket) {
    timespec noted{}, real{};
    const auto now = jauscat::net::now();
    ::clock_gettime(CLOCK_REALTIME, &real);
    if (::ioctl(socket, SIOCGSTAMPNS_OLD, &noted) != 0) return now;
    const auto since =
        std::chrono::seconds{real.tv_sec - noted.tv_sec} + std::chrono::nanoseconds{real.tv_nsec - noted.tv_nsec};
    return now - std::clamp<jauscat::duration>(since, jauscat::duration{}, std::chrono::seconds{1});
}
