// A bad network between two programs on the loopback interface: a relay that loses datagrams.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <random>
#include <thread>

namespace soak {

using udp = boost::asio::ip::udp;

inline udp::endpoint loopback(std::uint16_t port = 0) { return {boost::asio::ip::address_v4::loopback(), port}; }

/// Each of two ends sees the other as a socket of the relay, which hands on what comes there, from a thread of its own.
class lossy_relay {
  public:
    struct counters {
        std::atomic<std::uint64_t> taken{}, lost{};
    };

    /// Loses this share of the datagrams, 0 to 1, each way; which ones follows from `seed`.
    lossy_relay(double loss, unsigned seed) : loss_{loss}, random_{std::mt19937{seed}, std::mt19937{seed + 1}} {
        // What is lost is to be the relay's choice, as far as the system permits.
        for (auto& socket : sockets_) socket.set_option(udp::socket::receive_buffer_size{4 << 20});
    }
    lossy_relay(const lossy_relay&) = delete;
    lossy_relay& operator=(const lossy_relay&) = delete;
    ~lossy_relay() {
        context_.stop();
        if (thread_.joinable()) thread_.join();
    }

    /// Where the end `from`, 0 or 1, sends what is for the other, and gets what comes from it.
    [[nodiscard]] std::uint16_t port(std::size_t from) const { return sockets_[from].local_endpoint().port(); }
    /// What each end has sent.
    [[nodiscard]] const counters& of(std::size_t from) const { return counts_[from]; }
    /// From now on nothing passes.
    void cut() { is_cut_ = true; }

    /// The ends listen at these ports.
    void start(std::array<std::uint16_t, 2> ports) {
        ends_ = {loopback(ports[0]), loopback(ports[1])};
        for (std::size_t end : {0U, 1U}) receive(end);
        thread_ = std::thread{[this] { context_.run(); }};
    }

  private:
    void receive(std::size_t end) {
        sockets_[end].async_receive_from(boost::asio::buffer(datagrams_[end]), sender_[end],
                                         [this, end](boost::system::error_code error, std::size_t size) {
                                             if (!error) hand_on(end, size); // an error is about an earlier datagram
                                             receive(end);
                                         });
    }
    void hand_on(std::size_t end, std::size_t size) {
        ++counts_[end].taken;
        if (is_cut_ || chance_(random_[end]) < loss_) {
            ++counts_[end].lost;
            return;
        }
        boost::system::error_code ignored; // of a program that has ended
        sockets_[1 - end].send_to(boost::asio::buffer(datagrams_[end], size), ends_[1 - end], 0, ignored);
    }

    double loss_;
    boost::asio::io_context context_{1};
    std::array<udp::socket, 2> sockets_{udp::socket{context_, loopback()}, udp::socket{context_, loopback()}};
    std::array<udp::endpoint, 2> ends_{}, sender_{};
    std::array<std::array<std::byte, 65536>, 2> datagrams_{};
    std::array<std::mt19937, 2> random_;
    std::uniform_real_distribution<double> chance_{};
    std::array<counters, 2> counts_{};
    std::atomic<bool> is_cut_{};
    std::thread thread_{};
};

} // namespace soak
