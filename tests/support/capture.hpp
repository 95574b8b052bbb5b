// What passes an interface, as Wireshark's programs see it: dumpcap records, tshark reads.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace jauscat::test {

/// Records from its construction to `end`. Needs dumpcap and tshark.
class capture {
  public:
    explicit capture(const std::string& interface) {
        std::array<int, 2> output{};
        if (::mkdtemp(folder_.data()) == nullptr || ::pipe(output.data()) != 0)
            throw std::runtime_error{"no capture file"};
        recorder_ = ::fork();
        if (recorder_ == 0) {
            ::dup2(output[1], STDERR_FILENO);
            ::execlp("dumpcap", "dumpcap", "-q", "-i", interface.c_str(), "-w", file().c_str(), nullptr);
            ::_exit(127);
        }
        ::close(output[1]);
        wait_for(output[0], "File:"); // dumpcap says so once it records
        log_ = output[0];
    }
    ~capture() {
        end();
        ::close(log_);
        std::filesystem::remove_all(folder_);
    }
    capture(const capture&) = delete;
    capture& operator=(const capture&) = delete;

    void end() {
        if (recorder_ == 0) return;
        std::this_thread::sleep_for(std::chrono::milliseconds{300}); // dumpcap fetches the frames in batches
        ::kill(recorder_, SIGINT);
        ::waitpid(recorder_, nullptr, 0);
        recorder_ = 0;
    }

    /// The frames that `filter` (Wireshark's display filter) lets pass: for each one line with the values of `fields`,
    /// separated by spaces, "-" where a frame has none, by commas where it has several.
    [[nodiscard]] std::vector<std::string> rows(const std::string& filter,
                                                std::initializer_list<const char*> fields) const {
        std::string command = "tshark -r " + file() + " -Y '" + filter + "' -T fields -E separator=/t";
        for (const char* field : fields) command += std::string{" -e "} + field;
        std::vector<std::string> rows;
        for (const auto& line : lines_of(command + " 2>/dev/null")) {
            std::string row;
            for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
                to = line.find('\t', from);
                const auto value = line.substr(from, to - from);
                row += (from == 0 ? "" : " ") + (value.empty() ? "-" : value);
            }
            rows.push_back(row);
        }
        return rows;
    }

    /// What tshark prints for the frames that `filter` lets pass, one line each.
    [[nodiscard]] std::vector<std::string> summary(const std::string& filter) const {
        return lines_of("tshark -r " + file() + " -Y '" + filter + "' 2>/dev/null");
    }

  private:
    [[nodiscard]] std::string file() const { return folder_ + "/wire.pcapng"; }

    static void wait_for(int stream, const std::string& text) {
        std::string said;
        std::array<char, 256> part{};
        while (said.find(text) == std::string::npos) {
            const auto size = ::read(stream, part.data(), part.size());
            if (size <= 0) throw std::runtime_error{"dumpcap does not record: " + said};
            said.append(part.data(), static_cast<std::size_t>(size));
        }
    }

    static std::vector<std::string> lines_of(const std::string& command) {
        auto* const output = ::popen(command.c_str(), "r");
        if (output == nullptr) throw std::runtime_error{"cannot run " + command};
        std::vector<std::string> lines;
        std::string line;
        for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) {
            if (c != '\n') {
                line += static_cast<char>(c);
                continue;
            }
            lines.push_back(line);
            line.clear();
        }
        if (::pclose(output) != 0) throw std::runtime_error{"this failed: " + command};
        return lines;
    }

    std::string folder_ = std::filesystem::temp_directory_path().string() + "/jauscat-XXXXXX";
    pid_t recorder_{};
    int log_{-1};
};

} // namespace jauscat::test
