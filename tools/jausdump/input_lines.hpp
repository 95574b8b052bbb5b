// Lines of standard input.
#pragma once
#include <array>
#include <cerrno>
#include <functional>
#include <poll.h>
#include <string>
#include <unistd.h>

namespace jausdump {

/// Passes each line on, until the input ends or `stop` returns true; a signal is noticed also without input.
inline void read_input_lines(const std::function<void(const std::string&)>& line, const std::function<bool()>& stop) {
    constexpr int look_again = 100; // milliseconds: the signal may come just before poll does
    std::string rest;
    std::array<char, 65536> part{};
    while (!stop()) {
        pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
        if (::poll(&input, 1, look_again) <= 0) continue;
        const auto size = ::read(STDIN_FILENO, part.data(), part.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) break;
        std::size_t begin = 0, searched = rest.size();
        rest.append(part.data(), static_cast<std::size_t>(size));
        for (std::size_t end{}; (end = rest.find('\n', searched)) != std::string::npos && !stop();
             begin = searched = end + 1)
            line(rest.substr(begin, end - begin));
        rest.erase(0, begin);
    }
    if (!rest.empty() && !stop()) line(rest); // the last line may have no end
}

} // namespace jausdump
