// Frames for the links' tests.
#pragma once

#include "support/bytes.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

namespace support {

/// A padded frame with one BRD datagram of index 5Ah, address 0130h and `data` bytes 01 02 03 ...; no source address.
inline std::vector<std::byte> frame(std::size_t data) {
    const auto low = [](std::size_t value) { return value & 0xFF; };
    const auto high = [](std::size_t value) { return value >> 8; };
    const std::size_t all = 12 + data;
    const auto start = bytes(0x01, 0x01, 0x05, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0x88, 0xA4, //
                             low(all), 0x10 | high(all),                                 //
                             7, 0x5A, 0, 0, 0x30, 0x01, low(data), high(data), 0, 0);
    std::vector<std::byte> result(start.begin(), start.end());
    result.resize(std::max<std::size_t>(16 + all, 60));
    for (std::size_t i = 0; i < data; ++i) result[26 + i] = static_cast<std::byte>(low(i + 1));
    return result;
}

/// A buffer that takes any frame, full of rubbish before each, so that bytes a link forgot show.
struct frame_buffer {
    template <class Link>
    std::size_t receive_from(Link& link, std::chrono::nanoseconds timeout = std::chrono::seconds{5}) {
        storage.fill(std::byte{0xEE});
        return size = link.receive(storage, timeout);
    }
    std::vector<std::byte> frame() const {
        return {storage.begin(), storage.begin() + static_cast<std::ptrdiff_t>(size)};
    }

    std::array<std::byte, 1514> storage{};
    std::size_t size{};
};

} // namespace support
