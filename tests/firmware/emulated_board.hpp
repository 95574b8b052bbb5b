// An emulated MPS2 AN385 board that runs one of the firmware's images, with both serial lines in our hands.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <poll.h>
#include <signal.h>
#include <span>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace jauscat::test {

/// QEMU in a process of its own, ended with the object. Each wait for the board is bounded.
class emulated_board {
  public:
    /// A folder of images other than those of the build, chosen by the environment; nullptr without one.
    static const char* other_images() { return std::getenv("JAUSCAT_FIRMWARE_IMAGES"); }

    /// Starts `image`, the name of a firmware image without its suffix.
    explicit emulated_board(const std::string& image)
        : process_{start(folder() + "/" + image + ".elf", jaus_.boards, card_.boards)} {}
    emulated_board(const emulated_board&) = delete;
    emulated_board& operator=(const emulated_board&) = delete;
    ~emulated_board() {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }

    /// Sends bytes into the line `jaus`.
    void send(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const auto count = write(jaus_.ours, bytes.data(), bytes.size());
            if (count <= 0) throw std::runtime_error{"the board's line is closed"};
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        }
    }

    /// What the board said on its two lines.
    struct output {
        std::vector<std::byte> jaus{}, card{};
    };
    /// What the board has said since the last call, until it has said `end` on the line `jaus`; less if that does not
    /// come within 20 seconds.
    output receive_until(std::span<const std::byte> end) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{20};
        output said;
        while (said.jaus.size() < end.size() || !std::equal(end.rbegin(), end.rend(), said.jaus.rbegin())) {
            std::array<pollfd, 2> lines{pollfd{jaus_.ours, POLLIN, 0}, pollfd{card_.ours, POLLIN, 0}};
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
            if (left.count() <= 0 || poll(lines.data(), lines.size(), static_cast<int>(left.count())) <= 0) break;
            append_waiting(jaus_.ours, said.jaus);
            append_waiting(card_.ours, said.card);
        }
        append_waiting(card_.ours, said.card);
        return said;
    }

  private:
    struct line {
        line() {
            std::array<int, 2> ends{};
            if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) throw std::runtime_error{"no socket pair"};
            ours = ends[0];
            boards = ends[1];
        }
        line(const line&) = delete;
        line& operator=(const line&) = delete;
        ~line() {
            close(ours);
            close(boards);
        }
        int ours{}, boards{};
    };

    static std::string folder() { return other_images() != nullptr ? other_images() : FIRMWARE_IMAGES; }

    static pid_t start(const std::string& image, int jaus, int card) {
        const auto socket = [](const char* name, int descriptor) {
            return "socket,id=" + std::string{name} + ",fd=" + std::to_string(descriptor);
        };
        std::vector<std::string> words{FIRMWARE_QEMU,
                                       "-M",
                                       "mps2-an385",
                                       "-display",
                                       "none",
                                       "-monitor",
                                       "none",
                                       "-chardev",
                                       socket("jaus", jaus),
                                       "-serial",
                                       "chardev:jaus",
                                       "-chardev",
                                       socket("card", card),
                                       "-serial",
                                       "chardev:card",
                                       "-kernel",
                                       image};
        std::vector<char*> arguments;
        for (auto& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        pid_t process{};
        if (posix_spawn(&process, FIRMWARE_QEMU, nullptr, nullptr, arguments.data(), environ) != 0)
            throw std::runtime_error{"cannot start " FIRMWARE_QEMU};
        return process;
    }

    static void append_waiting(int from, std::vector<std::byte>& to) {
        std::array<std::byte, 4096> buffer{};
        for (ssize_t count = 0; (count = recv(from, buffer.data(), buffer.size(), MSG_DONTWAIT)) > 0;)
            to.insert(to.end(), buffer.begin(), buffer.begin() + count);
    }

    line jaus_, card_;
    pid_t process_;
};

} // namespace jauscat::test
