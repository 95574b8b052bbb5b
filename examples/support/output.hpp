// Output that cannot be written, because a disk is full for example, is a failure of the program.
#pragma once
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>

namespace example {

/// What keeps standard output from being written, with all that the program has written so far; empty if nothing does.
inline std::string output_problem() {
    errno = 0;
    std::cout.flush();
    const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
    if (is_written) return {};
    return "standard output cannot be written" + (errno != 0 ? ": " + std::string{std::strerror(errno)} : "");
}

/// Throws if standard output cannot be written: for programs whose output is all that they do.
inline void require_output() {
    if (const auto problem = output_problem(); !problem.empty()) throw std::runtime_error{problem};
}

/// The exit code of a program that ends with `code`: 1, and a line on standard error, where its output was not written.
inline int with_output(const char* program, int code) {
    const auto problem = output_problem();
    if (problem.empty()) return code;
    std::cerr << program << ": " << problem << "\n";
    return code == 0 ? 1 : code;
}

} // namespace example
