#include "line_source.hpp"

#include <array>
#include <cerrno>
#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace {

class script final : public line_source {
  public:
    std::optional<std::string> next() override {
        while (buffer_.find('\n') == std::string::npos && !at_end_ && input_is_ready()) read_some();
        const auto end = buffer_.find('\n');
        if (end == std::string::npos && (!at_end_ || buffer_.empty())) return {};
        std::string line = buffer_.substr(0, end); // the last line may have no end
        buffer_.erase(0, end == std::string::npos ? end : end + 1);
        return line;
    }
    [[nodiscard]] bool ended() const override { return at_end_ && buffer_.empty(); }
    void show(std::string_view text) override { std::cout << text << std::flush; }

  private:
    void read_some() {
        std::array<char, 4096> part{};
        const auto size = ::read(STDIN_FILENO, part.data(), part.size());
        if (size > 0) buffer_.append(part.data(), static_cast<std::size_t>(size));
        if (size == 0 || (size < 0 && errno != EINTR && errno != EAGAIN)) at_end_ = true;
    }
    std::string buffer_{};
    bool at_end_{};
};

} // namespace

bool input_is_ready() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    return ::poll(&input, 1, 0) > 0;
}

std::unique_ptr<line_source> script_lines() { return std::make_unique<script>(); }
