// A locale with a decimal comma, so that tests find text that depends on the locale.
#pragma once
#include <array>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace support {

/// Sets such a locale while it lives: one that is installed, or one that localedef makes in a folder of its own.
class decimal_comma {
  public:
    decimal_comma() {
        for (const char* const name : {"de_DE.UTF-8", "fr_FR.UTF-8", "es_ES.UTF-8"})
            if (found_ || (found_ = std::setlocale(LC_ALL, name) != nullptr)) return;
        make();
    }
    ~decimal_comma() {
        std::setlocale(LC_ALL, "C");
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    decimal_comma(const decimal_comma&) = delete;
    decimal_comma& operator=(const decimal_comma&) = delete;

    /// False where the system has no such locale and nothing to make one with.
    [[nodiscard]] explicit operator bool() const noexcept { return found_; }

  private:
    void make() {
        std::filesystem::create_directory(folder_);
        std::ofstream{folder_ / "comma"} << "LC_NUMERIC\ndecimal_point \"<U002C>\"\nthousands_sep \"<U002E>\"\n"
                                            "grouping 3;3\nEND LC_NUMERIC\n";
        // localedef warns about the categories that are missing, and says so by its exit status.
        const std::string where = folder_.string();
        const std::string command =
            "localedef --no-archive -c -i " + where + "/comma -f UTF-8 " + where + "/de_DE >/dev/null 2>&1";
        [[maybe_unused]] const int warned = std::system(command.c_str());
        ::setenv("LOCPATH", where.c_str(), 1);
        found_ = std::setlocale(LC_NUMERIC, "de_DE") != nullptr;
        ::unsetenv("LOCPATH");
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("decimal_comma." + std::to_string(::getpid()));
    bool found_{};
};

} // namespace support
