// A program on a terminal of its own, as a user sees it.
#pragma once
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <poll.h>
#include <pty.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace support {

/// Runs until it ends by itself, or with this object.
class terminal_program {
  public:
    explicit terminal_program(std::vector<std::string> command) {
        pid_ = ::forkpty(&terminal_, nullptr, nullptr, nullptr);
        if (pid_ < 0) throw std::runtime_error{"no pseudo-terminal"};
        if (pid_ != 0) return;
        ::setenv("TERM", "xterm", 1);
        std::vector<char*> words;
        for (auto& word : command) words.push_back(word.data());
        words.push_back(nullptr);
        ::execv(words[0], words.data());
        ::_exit(127);
    }
    terminal_program(const terminal_program&) = delete;
    terminal_program& operator=(const terminal_program&) = delete;
    ~terminal_program() {
        if (pid_ > 0) {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
        }
        ::close(terminal_);
    }

    void type(std::string_view keys) const {
        if (::write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
            throw std::runtime_error{"the terminal takes no keys"};
    }
    /// The window has another size.
    void resize(unsigned short columns, unsigned short rows) const {
        const winsize size{.ws_row = rows, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
        if (::ioctl(terminal_, TIOCSWINSZ, &size) != 0) throw std::runtime_error{"the terminal has no size"};
    }
    /// Waits for `text` behind all that was waited for before.
    void wait_for(std::string_view text) {
        std::size_t found{};
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{1};
        while ((found = seen_.find(text, waited_)) == std::string::npos)
            if (!read_some() || std::chrono::steady_clock::now() > end)
                throw std::runtime_error{"not seen: " + std::string{text} + "\nbut: " + seen_};
        waited_ = found + text.size();
    }
    /// Waits for the end; -1 after a signal.
    int exit_code() {
        while (read_some()) {}
        int status = 0;
        ::waitpid(std::exchange(pid_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    [[nodiscard]] const std::string& seen() const noexcept { return seen_; }

  private:
    /// False when the program has closed its terminal, or says nothing for half a minute.
    bool read_some() {
        pollfd input{.fd = terminal_, .events = POLLIN, .revents = 0};
        if (::poll(&input, 1, 30000) <= 0) return false;
        std::array<char, 4096> part{};
        const auto size = ::read(terminal_, part.data(), part.size());
        if (size <= 0) return false;
        seen_.append(part.data(), static_cast<std::size_t>(size));
        return true;
    }

    int terminal_{-1};
    pid_t pid_{-1};
    std::string seen_{};
    std::size_t waited_{};
};

} // namespace support
