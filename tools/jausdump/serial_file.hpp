// The bytes of a file, device or pipe as they come.
#pragma once
#include "record.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <memory>
#include <poll.h>
#include <unistd.h>

namespace jausdump {

/// Passes the bytes on until the file ends or `stop` returns true. `path` "-" is standard input. Throws input_error.
inline void read_bytes(const std::string& path, const std::function<void(std::span<const std::byte>)>& on_bytes,
                       const std::function<bool()>& stop) {
    const int file = path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) throw input_error{path + ": " + std::strerror(errno)};
    const std::unique_ptr<const int, void (*)(const int*)> closed{&file, [](const int* one) { ::close(*one); }};
    std::array<std::byte, 65536> part{};
    while (!stop()) {
        constexpr int wait_ms = 100;
        pollfd input{.fd = file, .events = POLLIN, .revents = 0};
        if (::poll(&input, 1, wait_ms) <= 0) continue;
        const auto size = ::read(file, part.data(), part.size());
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) throw input_error{path + ": " + std::strerror(errno)};
        if (size == 0) return;
        on_bytes(std::span{part}.first(static_cast<std::size_t>(size)));
    }
}

} // namespace jausdump
