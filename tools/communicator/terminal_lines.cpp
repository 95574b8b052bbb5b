#include "line_source.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <editline/readline.h>
#include <iostream>
#include <system_error>

namespace {

/// The library hands lines to a function without a context, and asks for completions by another.
std::deque<std::string> lines;
bool at_end{};

std::string prompt_text;
line_completer complete;

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

/// The library frees what these return. It asks for one word after the other, from `state` 0 on.
char* next_completion(const char* /*word*/, int state) {
    static std::vector<std::string> found;
    if (state == 0) found = complete(std::string_view{rl_line_buffer, static_cast<std::size_t>(rl_point)});
    const auto at = static_cast<std::size_t>(state);
    return at < found.size() ? ::strdup(found[at].c_str()) : nullptr;
}
char** all_completions(const char* word, int /*start*/, int /*end*/) {
    rl_attempted_completion_over = 1; // no names of files
    return rl_completion_matches(word, &next_completion);
}

class terminal final : public line_source {
  public:
    terminal(const std::string& prompt, line_completer completer, std::filesystem::path history)
        : history_{std::move(history)} {
        static char breaks[] = " ";
        rl_catch_signals = 0;
        rl_initialize();
        rl_attempted_completion_function = &all_completions;
        rl_basic_word_break_characters = breaks; // what libedit looks at
        rl_completer_word_break_characters = breaks;
        rl_completion_append_character = '\0';
        prompt_text = prompt;
        complete = std::move(completer);
        if (!history_.empty()) read_history(history_.c_str());
        stifle_history(1000);
        begin_line();
    }
    ~terminal() override {
        rl_callback_handler_remove();
        std::error_code none; // without a place for it, the history ends with the program
        std::filesystem::create_directories(history_.parent_path(), none);
        if (!history_.empty() && !none) write_history(history_.c_str());
    }

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

  private:
    std::filesystem::path history_;
};

} // namespace

std::unique_ptr<line_source> terminal_lines(const std::string& prompt, line_completer completer,
                                            std::filesystem::path history) {
    return std::make_unique<terminal>(prompt, std::move(completer), std::move(history));
}
