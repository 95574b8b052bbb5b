// A folder for the files of a test.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

namespace jauscat::test {

/// A folder of this test's own, removed with it.
class scratch {
  public:
    scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "jauscat-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error{"no temporary folder"};
        folder_ = name;
    }
    scratch(const scratch&) = delete;
    scratch& operator=(const scratch&) = delete;
    ~scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    [[nodiscard]] std::string operator/(const std::string& name) const { return (folder_ / name).string(); }

  private:
    std::filesystem::path folder_{};
};

inline std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream{path, std::ios::binary}.rdbuf();
    return text.str();
}

} // namespace jauscat::test
