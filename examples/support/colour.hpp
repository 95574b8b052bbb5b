// Coloured output on terminals that support it, and not if NO_COLOR is set (no-color.org).
#pragma once
#include "support/log_format.hpp"

#include <cstdlib>
#include <string>
#include <string_view>
#include <unistd.h>

namespace example {

/// Escape sequences before and after a text; empty without colours.
struct palette {
    const char *bold{""}, *good{""}, *bad{""}, *faint{""}, *end{""};
    static constexpr palette coloured() { return {"\033[1m", "\033[32m", "\033[31m", "\033[2m", "\033[0m"}; }
};

/// Of STDOUT_FILENO or STDERR_FILENO.
inline const palette& colours(int stream = STDOUT_FILENO) {
    static constexpr palette coloured = palette::coloured(), plain{};
    const auto says = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::string_view{value != nullptr ? value : ""};
    };
    const bool wanted = chosen_log_format() == log_format::text && ::isatty(stream) == 1 && says("NO_COLOR").empty() &&
                        says("TERM") != "dumb";
    return wanted ? coloured : plain;
}

/// For standard output.
inline std::string bold(const std::string& text) { return colours().bold + text + colours().end; }
inline std::string good(const std::string& text) { return colours().good + text + colours().end; }
inline std::string bad(const std::string& text) { return colours().bad + text + colours().end; }

} // namespace example
