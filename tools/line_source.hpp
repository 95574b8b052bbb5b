// Where the lines of a user come from: a terminal with line editing, or a script through standard input.
#pragma once

#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <poll.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

class line_source {
  public:
    line_source() = default;
    line_source(const line_source&) = delete;
    line_source& operator=(const line_source&) = delete;
    virtual ~line_source() = default;

    /// The next line, if there is one now. Does not wait.
    virtual std::optional<std::string> next() = 0;
    /// No more lines will come.
    [[nodiscard]] virtual bool ended() const = 0;
    /// Shows text, without harm to what the user is typing.
    virtual void show(std::string_view text) = 0;
};

/// Whether standard input has something to read or has ended.
inline bool input_is_ready() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    return ::poll(&input, 1, 0) > 0;
}

/// Lines of standard input as they come.
class script_lines final : public line_source {
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

/// The words that may stand in place of the last one of a line, which may be begun.
using line_completer = std::function<std::vector<std::string>(std::string_view line)>;
/// Line editing, completion by Tab, and history, which is kept in a file unless its name is empty; only one at a time.
std::unique_ptr<line_source> terminal_lines(const std::string& prompt, line_completer completer,
                                            std::filesystem::path history);
