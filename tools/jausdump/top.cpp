#include "top.hpp"

#include "support/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <poll.h>
#include <string_view>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace jausdump {

namespace {

std::size_t width_of(int terminal) {
    winsize size{};
    return ::ioctl(terminal, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

/// Whether standard output understands escape sequences.
bool has_screen() {
    const char* const kind = std::getenv("TERM");
    const std::string_view terminal{kind != nullptr ? kind : ""};
    return ::isatty(STDOUT_FILENO) == 1 && !terminal.empty() && terminal != "dumb";
}

} // namespace

/// The terminal: its second screen, keys without Enter. The destructor gives it back.
class top::screen {
  public:
    screen() {
        if (::isatty(STDIN_FILENO) == 1 && ::tcgetattr(STDIN_FILENO, &before_) == 0) {
            termios keys = before_;
            keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
            keys.c_cc[VMIN] = 0;
            keys.c_cc[VTIME] = 0;
            // What stops or kills the program at once would leave the terminal as it is now.
            keys.c_cc[VSUSP] = keys.c_cc[VQUIT] = _POSIX_VDISABLE;
            has_keys_ = ::tcsetattr(STDIN_FILENO, TCSADRAIN, &keys) == 0;
        }
        write("\033[?1049h\033[?25l"); // second screen, no cursor
    }
    ~screen() {
        write("\033[?25h\033[?1049l");
        if (has_keys_) ::tcsetattr(STDIN_FILENO, TCSADRAIN, &before_);
    }
    screen(const screen&) = delete;
    screen& operator=(const screen&) = delete;

    /// The lines, from the top of the screen on.
    void show(const std::vector<std::string>& lines) {
        std::string text = "\033[H";
        for (std::size_t i = 0; i != lines.size(); ++i) text += (i != 0 ? "\r\n" : "") + lines[i] + "\033[K";
        write(text + "\033[J");
    }
    /// What was typed.
    [[nodiscard]] std::string keys() const {
        std::string typed;
        pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
        std::array<char, 64> part{};
        while (has_keys_ && ::poll(&input, 1, 0) > 0) {
            const auto size = ::read(STDIN_FILENO, part.data(), part.size());
            if (size <= 0) break;
            typed.append(part.data(), static_cast<std::size_t>(size));
        }
        return typed;
    }
    [[nodiscard]] winsize size() const {
        winsize size{};
        if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
            return {.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
        return size;
    }
    /// The terminal was closed.
    [[nodiscard]] bool is_lost() const { return is_lost_; }

  private:
    void write(std::string_view text) {
        while (!text.empty() && !is_lost_) {
            const auto size = ::write(STDOUT_FILENO, text.data(), text.size());
            if (size < 0 && errno == EINTR) continue;
            if (size <= 0)
                is_lost_ = true;
            else
                text.remove_prefix(static_cast<std::size_t>(size));
        }
    }

    termios before_{};
    bool has_keys_{}, is_lost_{};
};

top::top(top_options how) : how_{how}, table_{how.live} {
    if (how.live && !how.as_json && has_screen()) screen_ = std::make_unique<screen>();
    if (!screen_) set_next(); // the first table shows messages
}

top::~top() = default;

void top::follow(options& how) {
    how.quiet = true;
    how.receiver = [this](const record& message) { table_.add(message); };
}

top_table::time top::now() const {
    return how_.live ? std::chrono::system_clock::now().time_since_epoch() : table_.newest();
}

void top::set_next() {
    constexpr double usual_s = 0.5;
    next_ = clock::now() + std::chrono::milliseconds{static_cast<long>(how_.interval_s.value_or(usual_s) * 1000)};
}

bool top::tick() {
    if (screen_) on_keys(screen_->keys());
    if ((screen_ || how_.interval_s) && clock::now() >= next_) {
        set_next();
        screen_ ? draw() : print();
    }
    return is_ended_ || (screen_ && screen_->is_lost());
}

void top::on_keys(std::string_view keys) {
    if (keys.empty()) return;
    const std::size_t page = std::max<std::size_t>(screen_->size().ws_row, 4) - 3;
    const auto scroll = [&](std::ptrdiff_t by) {
        const auto to = static_cast<std::ptrdiff_t>(first_row_) + by;
        first_row_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(to, 0));
    };
    struct key {
        std::string_view typed;
        std::function<void()> act;
    };
    const auto order = [&](top_order by) { return [this, by] { how_.order = by; }; };
    const auto step = static_cast<std::ptrdiff_t>(page);
    const std::array all{key{"q", [&] { is_ended_ = true; }},  key{"c", order(top_order::code)},
                         key{"m", order(top_order::message)},  key{"s", order(top_order::source)},
                         key{"n", order(top_order::count)},    key{"r", order(top_order::rate)},
                         key{"a", order(top_order::age)},      key{"\033[A", [&] { scroll(-1); }},
                         key{"\033[B", [&] { scroll(1); }},    key{"\033[5~", [&] { scroll(-step); }},
                         key{"\033[6~", [&] { scroll(step); }}};
    while (!keys.empty()) {
        const auto found = std::ranges::find_if(all, [&](const key& one) { return keys.starts_with(one.typed); });
        if (found != all.end()) found->act();
        keys.remove_prefix(found != all.end() ? found->typed.size() : 1);
    }
    next_ = {}; // shown at once
}

void top::draw() {
    const auto size = screen_->size();
    const std::size_t height = size.ws_row > 3 ? size.ws_row - 3U : 1, rows = table_.rows();
    first_row_ = std::min(first_row_, rows > height ? rows - height : 0);
    auto lines =
        table_.lines(now(), how_.order, {.width = size.ws_col, .colours = example::colours()}, first_row_, height);
    std::string status =
        "jausdump: " + std::to_string(table_.messages()) + (table_.messages() == 1 ? " message" : " messages");
    if (rows > height)
        status += ", rows " + std::to_string(first_row_ + 1) + " to " + std::to_string(first_row_ + height) + " of " +
                  std::to_string(rows) + " (arrows, Page Up, Page Down)";
    status += "; by c code, m message, s source, n count, r rate, a age; q ends";
    lines.insert(lines.begin(), {status.substr(0, size.ws_col), ""});
    screen_->show(lines);
}

void top::print() const {
    if (how_.as_json) {
        std::cout << table_.json_lines(now(), how_.order);
    } else {
        const std::size_t width = ::isatty(STDOUT_FILENO) == 1 ? width_of(STDOUT_FILENO) : 0;
        for (const auto& line : table_.lines(now(), how_.order, {.width = width, .colours = example::colours()}))
            std::cout << line << "\n";
        if (how_.interval_s) std::cout << "\n";
    }
    example::require_output();
}

void top::finish() {
    screen_.reset();
    print();
}

} // namespace jausdump
