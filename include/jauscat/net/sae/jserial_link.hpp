// SAE JAUS over a serial line with Boost.Asio.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/net/sae/detail/bounded_writer.hpp>
#include <jauscat/net/sae/growing_pause.hpp>
#include <jauscat/net/sae/transport_driver.hpp>
#include <jauscat/sae/transport/jserial.hpp>

#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

struct jserial_options {
    std::string device{};                ///< such as /dev/ttyS0
    std::uint32_t baud{115200};          ///< 8 data bits, no parity, 1 stop bit, no flow control
    std::size_t message_size{8192};      ///< largest received message, header included
    std::size_t max_waiting{256 * 1024}; ///< bytes that wait to be sent; what exceeds it is dropped
    pause_limits reopen{};               ///< pauses before the device is opened again after a failure
};

/// Counts since construction.
struct jserial_counters {
    std::uint64_t frames{};                 ///< received
    std::uint64_t dropped{};                ///< not sent: too many bytes waited, or the device was away
    std::uint64_t reopened{};               ///< how often the device was opened again
    std::array<std::uint64_t, 24> faults{}; ///< by sae::transport_errc
};

/// Sends and receives the messages of a transport at a serial line; every message reaches all that are connected to it.
/// A device that fails, such as an adapter that is unplugged, is opened again after a pause, and the log is told.
/// Use it from the thread that runs the io_context.
class jserial_link {
  public:
    /// Opens the device. `transport` must outlive it, and has a group. Throws `open_error`.
    JAUSCAT_DECL jserial_link(boost::asio::io_context& context, sae::transport& transport,
                              const jserial_options& options);
    /// The same as one of several media of a driver, which has the handlers.
    JAUSCAT_DECL jserial_link(boost::asio::io_context& context, transport_driver& driver,
                              const jserial_options& options);
    jserial_link(const jserial_link&) = delete;
    jserial_link& operator=(const jserial_link&) = delete;

    /// Starts to receive while the io_context runs.
    JAUSCAT_DECL void start(sae_handlers handlers);
    /// Closes the device. No handler is called afterwards.
    JAUSCAT_DECL void stop();

    /// See sae::transport::send.
    result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message,
                                                    std::span<const std::byte> payload) {
        return medium_.send(message, payload);
    }
    /// The number of the medium in its driver.
    [[nodiscard]] std::size_t medium() const noexcept { return medium_.number(); }
    /// The key in the transport of all components at the line.
    [[nodiscard]] sae::endpoint_key key() const noexcept { return medium_.in_transport({}); }
    const jserial_counters& counts() const noexcept { return counters_; }

  private:
    [[nodiscard]] transport_driver::put_handler putter() {
        return [this](const sae::outgoing_datagram& datagram) { put(datagram); };
    }
    JAUSCAT_DECL void open_first();
    JAUSCAT_DECL void receive();
    JAUSCAT_DECL void received(std::span<const std::byte> bytes);
    JAUSCAT_DECL void put(const sae::outgoing_datagram& datagram);
    JAUSCAT_DECL void failed(const boost::system::error_code& error);
    JAUSCAT_DECL void reopen_later();
    [[nodiscard]] JAUSCAT_DECL boost::system::error_code open();
    JAUSCAT_DECL void make_writer();

    jserial_options options_;
    boost::asio::serial_port port_;
    boost::asio::steady_timer pause_;
    growing_pause pauses_;
    std::vector<std::byte> message_;
    sae::jserial_reader reader_;
    std::array<std::byte, 4096> input_{};
    std::vector<std::byte> frame_{};
    transport_medium medium_;
    std::optional<detail::bounded_writer<boost::asio::serial_port>> writer_{};
    jserial_counters counters_{};
    std::shared_ptr<char> alive_{std::make_shared<char>()};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/jserial_link.ipp>
#endif
