// A browser's part of HTTP and WebSocket, as far as the tests need it: blocking, with a limit of time.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <istream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/time.h>

namespace live_test {

using json = nlohmann::json;
using boost::asio::ip::tcp;

struct answer {
    int status{};
    std::string header{}, body{};
};

/// A connection to a live view on the loopback interface.
class web_client {
  public:
    /// `receive_buffer`: of the socket, in bytes; 0: the system's.
    explicit web_client(std::uint16_t port, int receive_buffer = 0) : port_{port} {
        socket_.open(tcp::v4());
        if (receive_buffer != 0) socket_.set_option(boost::asio::socket_base::receive_buffer_size{receive_buffer});
        socket_.connect({boost::asio::ip::address_v4::loopback(), port});
        const ::timeval limit{.tv_sec = 60, .tv_usec = 0}; // only a test that fails waits so long
        ::setsockopt(socket_.native_handle(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        ::setsockopt(socket_.native_handle(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    }

    [[nodiscard]] std::string own_host() const { return "127.0.0.1:" + std::to_string(port_); }
    void send(const std::string& text) { write(text.data(), text.size()); }

    /// `more`: lines of the header, each with its end.
    answer request(const std::string& target, const std::string& more = {}, std::string host = {},
                   const std::string& method = "GET") {
        if (host.empty()) host = own_host();
        send(method + " " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
        return read_answer(method != "HEAD");
    }
    answer read_answer(bool has_body = true) {
        answer made;
        for (char c{}; !made.header.ends_with("\r\n\r\n"); made.header += c)
            if (!read(&c, 1)) throw std::runtime_error{"the connection was closed: " + made.header};
        made.status = std::stoi(made.header.substr(made.header.find(' ')));
        if (made.status == 101 || !has_body) return made;
        for (char c{}; read(&c, 1);) made.body += c;
        return made;
    }
    /// Begins to watch; the answer is 101 where that is granted.
    answer watch(const std::string& target = "/live", const std::string& more = {}, const std::string& host = {}) {
        return request(target,
                       "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
                           more,
                       host);
    }
    /// Sends a text of `size` characters.
    void say(std::size_t size) {
        std::string frame = "\x81";
        if (size < 126) {
            frame += static_cast<char>(0x80 | size);
        } else {
            frame += static_cast<char>(0x80 | 126);
            frame += static_cast<char>(size >> 8U);
            frame += static_cast<char>(size & 255U);
        }
        frame += std::string(4, '\0'); // the mask
        send(frame + std::string(size, 'x'));
    }
    /// The next text; nothing (null) where the connection was closed.
    json next() {
        for (;;) {
            std::array<unsigned char, 8> head{};
            if (!read(head.data(), 2)) return nullptr;
            const auto kind = head[0] & 15;
            std::uint64_t size = head[1] & 127;
            if (const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0; more != 0) {
                if (!read(head.data(), more)) return nullptr;
                size = 0;
                for (std::size_t i = 0; i != more; ++i) size = size << 8U | head[i];
            }
            std::string text(static_cast<std::size_t>(size), '\0');
            if (!read(text.data(), text.size())) return nullptr;
            if (kind == 8) {
                close_code = text.size() < 2
                                 ? 0
                                 : static_cast<unsigned char>(text[0]) << 8 | static_cast<unsigned char>(text[1]);
                return nullptr;
            }
            if (kind == 1) return json::parse(text);
        }
    }
    /// The first text from now on of which this is true.
    template <class Predicate> json next(Predicate is_it) {
        for (int i = 0; i != 1000; ++i) { // only a test that fails reads so many
            auto frame = next();
            if (frame.is_null()) throw std::runtime_error{"the connection was closed"};
            if (is_it(frame)) return frame;
        }
        throw std::runtime_error{"it was not shown"};
    }
    /// The first row of a message of this name from now on.
    json row(const std::string& name) {
        json found;
        next([&](const json& frame) {
            if (!frame.contains("messages")) return false;
            for (const auto& one : frame["messages"])
                if (one["name"] == name) found = one;
            return !found.is_null();
        });
        return found;
    }
    int close_code{};

  private:
    bool read(void* to, std::size_t size) {
        auto* at = static_cast<char*>(to);
        while (size != 0) {
            const auto got = ::recv(socket_.native_handle(), at, size, 0);
            if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) throw std::runtime_error{"nothing was sent"};
            if (got <= 0) return false;
            at += got;
            size -= static_cast<std::size_t>(got);
        }
        return true;
    }
    void write(const char* from, std::size_t size) {
        while (size != 0) {
            const auto sent = ::send(socket_.native_handle(), from, size, MSG_NOSIGNAL);
            if (sent <= 0) return; // the answer says why
            from += sent;
            size -= static_cast<std::size_t>(sent);
        }
    }

    boost::asio::io_context context_{};
    tcp::socket socket_{context_};
    std::uint16_t port_;
};

} // namespace live_test
