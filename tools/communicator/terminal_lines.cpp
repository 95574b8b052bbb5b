#include "line_source.hpp"

#include <cstdlib>
#include <deque>
#include <editline/readline.h>
#include <iostream>

namespace {

/// The library hands lines to a function without a context.
std::deque<std::string> lines;
bool at_end{};

std::string prompt_text;

void take_line(char* line);

/// Before each line: libedit leaves the terminal to the system after one, without editing and history.
void begin_line() { rl_callback_handler_install(prompt_text.c_str(), &take_line); }

void take_line(char* line) {
    if (line == nullptr) { // Ctrl-D
        at_end = true;
        return;
    }
    if (*line != '\0') add_history(line);
    lines.emplace_back(line);
    std::free(line);
    begin_line();
}

class terminal final : public line_source {
  public:
    explicit terminal(const std::string& prompt) {
        rl_catch_signals = 0;
        prompt_text = prompt;
        begin_line();
    }
    ~terminal() override { rl_callback_handler_remove(); }

    std::optional<std::string> next() override {
        while (lines.empty() && !at_end && input_is_ready()) rl_callback_read_char();
        if (lines.empty()) return {};
        auto line = std::move(lines.front());
        lines.pop_front();
        return line;
    }
    [[nodiscard]] bool ended() const override { return at_end && lines.empty(); }
    void show(std::string_view text) override {
        std::cout << "\r\033[K" << text << std::flush; // over the prompt, which is written again after it
        rl_forced_update_display();
    }
};

} // namespace

std::unique_ptr<line_source> terminal_lines(const std::string& prompt) { return std::make_unique<terminal>(prompt); }
