// Frames for the links' tests.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

namespace test {

template <class... B> std::vector<std::byte> bytes(B... values) { return {static_cast<std::byte>(values)...}; }

/// A padded frame with one BRD datagram of index 5Ah, address 0130h and `data` bytes 01 02 03 ...; no source address.
inline std::vector<std::byte> frame(std::size_t data) {
    const auto low = [](std::size_t value) { return static_cast<std::byte>(value & 0xFF); };
    const auto high = [](std::size_t value) { return static_cast<std::byte>(value >> 8); };
    auto result = bytes(0x01, 0x01, 0x05, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0x88, 0xA4);
    const std::size_t all = 12 + data;
    result.insert(result.end(), {low(all),
                                 high(all) | std::byte{0x10},
                                 std::byte{7},
                                 std::byte{0x5A},
                                 {},
                                 {},
                                 std::byte{0x30},
                                 std::byte{1},
                                 low(data),
                                 high(data),
                                 {},
                                 {}});
    for (std::size_t i = 1; i <= data; ++i) result.push_back(low(i));
    result.insert(result.end(), 2, std::byte{});
    result.resize(std::max<std::size_t>(result.size(), 60));
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

} // namespace test
