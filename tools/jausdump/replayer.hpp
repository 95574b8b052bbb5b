// Sends the datagrams of a capture to a host again.
#pragma once
#include "dump.hpp"
#include "packet_reader.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

namespace jausdump {

/// Sends each datagram with a message that passes the filters, also packets of a message of SAE JAUS in several
/// packets. TCP streams and serial lines are not sent: their messages have no datagrams.
class replayer {
  public:
    /// `target`: HOST:PORT. `speed`: factor of the recorded pace; 0: without pauses. Throws input_error if the host is
    /// not known or cannot be reached.
    replayer(const std::string& target, double speed, std::function<bool()> stop);

    /// Notes the messages that pass.
    void follow(options& how);
    /// Sends the datagrams of a capture.
    void follow(capture_listener& listener);
    /// Prints the counts. Returns whether everything was sent and nothing refused. Throws std::runtime_error if there
    /// was no datagram to send.
    bool finish(bool as_json);

  private:
    void on_datagram(std::span<const std::byte> payload, std::chrono::nanoseconds time);
    void wait_for(std::chrono::nanoseconds time);
    void send(std::span<const std::byte> payload);
    void note_refusal(const boost::system::error_code& failed);
    void show_progress();

    using steady = std::chrono::steady_clock;

    boost::asio::io_context context_{};
    boost::asio::ip::udp::socket socket_{context_};
    std::string target_;
    double speed_;
    std::function<bool()> stop_;
    bool has_message_{};
    std::optional<steady::time_point> begun_{};
    std::chrono::nanoseconds first_{}; ///< time of the first datagram in the capture
    std::size_t sent_{}, bytes_{}, refused_{}, too_large_{}, passed_over_{}, of_tcp_{}, of_serial_{};
    bool is_stopped_{};
    bool shows_progress_{};
    double part_{}; ///< of the file, 0 to 1
    steady::time_point shown_{};
};

} // namespace jausdump
