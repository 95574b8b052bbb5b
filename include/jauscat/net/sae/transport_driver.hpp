// Drives a transport of SAE JAUS by the clock and a timer of Boost.Asio; what sends its datagrams is the medium's.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/sae/transport/transport.hpp>

#include <boost/asio/io_context.hpp>

#include <functional>
#include <string_view>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// What the media of SAE JAUS call; each function may be empty.
struct sae_handlers {
    std::function<void(const sae::received_message&)> on_message{}; ///< a message for a component
    std::function<void(const sae::finished_message&)> on_outcome{}; ///< of a message sent with acknowledgement
    std::function<void(std::string_view text)> on_error{};          ///< a line for the log
};

/// Passes packets to a transport, and its datagrams to `put`, from the thread that runs the io_context.
class transport_driver {
  public:
    /// Sends a datagram; its bytes are valid during the call.
    using put_handler = std::function<void(const sae::outgoing_datagram&)>;

    /// `transport` must outlive it.
    JAUSCAT_DECL transport_driver(boost::asio::io_context& context, sae::transport& transport, put_handler put);

    /// Sends what waits.
    JAUSCAT_DECL void start(sae_handlers handlers);
    /// No handler is called afterwards.
    JAUSCAT_DECL void stop();

    /// See sae::transport.
    JAUSCAT_DECL jaus::datagram_form on_datagram(sae::endpoint_key from, std::span<const std::byte> datagram);
    JAUSCAT_DECL void on_packet(sae::endpoint_key from, const sae::split_transport_message& packet);
    JAUSCAT_DECL result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message,
                                                                 std::span<const std::byte> payload);
    /// Passes a line to the handler, at a limited rate.
    JAUSCAT_DECL void report(std::string_view text);

    [[nodiscard]] sae::transport& transport() noexcept { return transport_; }

  private:
    JAUSCAT_DECL void deliver(const sae::received_message& message) const;
    JAUSCAT_DECL void run();

    sae::transport& transport_;
    put_handler put_;
    sae_handlers handlers_{};
    limited_log log_;
    bool is_running_{};
    detail::wake_timer timer_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/transport_driver.ipp>
#endif
