// Pseudo-terminals as serial lines.
#pragma once

#include "support/catch.hpp"

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <string>
#include <termios.h>
#include <unistd.h>

namespace support {

/// Without line discipline; closed at the end.
struct pseudo_terminal {
    pseudo_terminal() {
        REQUIRE(master >= 0);
        REQUIRE(::grantpt(master) == 0);
        REQUIRE(::unlockpt(master) == 0);
        termios raw{};
        REQUIRE(::tcgetattr(master, &raw) == 0);
        ::cfmakeraw(&raw);
        REQUIRE(::tcsetattr(master, TCSANOW, &raw) == 0);
    }
    ~pseudo_terminal() {
        if (master >= 0) ::close(master);
    }
    pseudo_terminal(const pseudo_terminal&) = delete;
    pseudo_terminal& operator=(const pseudo_terminal&) = delete;

    /// The file of the other end.
    [[nodiscard]] std::string device() const {
        std::array<char, 128> name{};
        REQUIRE(::ptsname_r(master, name.data(), name.size()) == 0);
        return name.data();
    }

    int master{::posix_openpt(O_RDWR | O_NOCTTY)};
};

/// What is read from one of two descriptors is written to the other, while the io_context runs.
inline void join(boost::asio::posix::stream_descriptor& a, boost::asio::posix::stream_descriptor& b) {
    struct way {
        boost::asio::posix::stream_descriptor &in, &out;
        std::array<std::byte, 256> bytes{};

        static void pass(const std::shared_ptr<way>& self) {
            self->in.async_read_some(
                boost::asio::buffer(self->bytes), [self](boost::system::error_code error, std::size_t size) {
                    if (error) return;
                    boost::asio::async_write(self->out, boost::asio::buffer(self->bytes, size),
                                             [self](boost::system::error_code failed, std::size_t) {
                                                 if (!failed) pass(self);
                                             });
                });
        }
    };
    way::pass(std::shared_ptr<way>{new way{a, b}});
    way::pass(std::shared_ptr<way>{new way{b, a}});
}

} // namespace support
