// Drives a transport of SAE JAUS by the clock and a timer of Boost.Asio; its media send the datagrams.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/sae/transport/transport.hpp>

#include <boost/asio/io_context.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// What the media of SAE JAUS call; each function may be empty.
struct sae_handlers {
    std::function<void(const sae::received_message&)> on_message{}; ///< a message for a component
    std::function<void(const sae::finished_message&)> on_outcome{}; ///< of a message sent with acknowledgement
    std::function<void(std::string_view text)> on_error{};          ///< a line for the log
};

/// Passes packets of its media to a transport, and the transport's datagrams to the medium of their endpoint, those to
/// the group to every medium. Use it from the thread that runs the io_context.
class transport_driver {
  public:
    /// Sends a datagram; its bytes are valid during the call.
    using put_handler = std::function<void(const sae::outgoing_datagram&)>;
    /// Decides whether a packet is passed to the transport.
    using filter = std::function<bool(const sae::transport_header& head, sae::endpoint_key from)>;

    /// `transport` must outlive it.
    JAUSCAT_DECL transport_driver(boost::asio::io_context& context, sae::transport& transport);
    transport_driver(const transport_driver&) = delete;
    transport_driver& operator=(const transport_driver&) = delete;

    /// Without a filter every packet is passed.
    void set_filter(filter accept) { accept_ = std::move(accept); }
    /// Sends what waits.
    JAUSCAT_DECL void start(sae_handlers handlers);
    /// No handler is called afterwards.
    JAUSCAT_DECL void stop();

    /// See sae::transport.
    JAUSCAT_DECL result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message,
                                                                 std::span<const std::byte> payload);
    /// Passes a line to the handler, at a limited rate.
    JAUSCAT_DECL void report(std::string_view text);

    [[nodiscard]] sae::transport& transport() noexcept { return transport_; }

  private:
    friend class transport_medium;

    [[nodiscard]] JAUSCAT_DECL std::size_t add(put_handler put);
    void remove(std::size_t number) { media_[number] = nullptr; }
    JAUSCAT_DECL jaus::datagram_form on_datagram(sae::endpoint_key from, std::span<const std::byte> datagram);
    JAUSCAT_DECL void on_packet(sae::endpoint_key from, const sae::split_transport_message& packet);
    JAUSCAT_DECL void pass(sae::endpoint_key from, const sae::split_transport_message& packet);
    JAUSCAT_DECL void report_refused(const sae::transport_counters& before, const sae::split_transport_message& packet);
    JAUSCAT_DECL void put(const sae::outgoing_datagram& datagram) const;
    JAUSCAT_DECL void run();

    sae::transport& transport_;
    filter accept_{};
    std::vector<put_handler> media_{}; ///< by number; empty: of a medium that was destroyed
    sae_handlers handlers_{};
    limited_log log_;
    bool is_running_{};
    detail::wake_timer timer_;
};

/// A medium of a driver: of one of its own, or of one that several media share. The transport's endpoint keys have the
/// number of the medium in the driver, from 0, in the upper 8 bits, and the key of the medium in the others.
class transport_medium {
  public:
    /// With a driver of its own. `transport` must outlive it.
    JAUSCAT_DECL transport_medium(boost::asio::io_context& context, sae::transport& transport,
                                  transport_driver::put_handler put);
    /// `shared` must outlive it.
    JAUSCAT_DECL transport_medium(transport_driver& shared, transport_driver::put_handler put);
    JAUSCAT_DECL ~transport_medium();
    transport_medium(const transport_medium&) = delete;
    transport_medium& operator=(const transport_medium&) = delete;

    /// The number of the medium of an endpoint, and the medium's key.
    [[nodiscard]] static constexpr std::size_t number_of(sae::endpoint_key key) noexcept {
        return static_cast<std::size_t>(key.value >> key_bits);
    }
    [[nodiscard]] static constexpr sae::endpoint_key own_key(sae::endpoint_key key) noexcept {
        return {key.value & ((std::uint64_t{1} << key_bits) - 1)};
    }
    /// The transport's key of an endpoint.
    [[nodiscard]] constexpr sae::endpoint_key in_transport(sae::endpoint_key own) const noexcept {
        return {std::uint64_t{number_} << key_bits | own.value};
    }
    [[nodiscard]] constexpr std::size_t number() const noexcept { return number_; }

    /// See transport_driver. A shared driver has its own handlers, start and stop.
    void start(sae_handlers handlers) {
        if (own_) own_->start(std::move(handlers));
    }
    void stop() {
        if (own_) own_->stop();
    }
    jaus::datagram_form on_datagram(sae::endpoint_key from, std::span<const std::byte> datagram) {
        return driver_.on_datagram(in_transport(from), datagram);
    }
    void on_packet(sae::endpoint_key from, const sae::split_transport_message& packet) {
        driver_.on_packet(in_transport(from), packet);
    }
    result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message,
                                                    std::span<const std::byte> payload) {
        return driver_.send(message, payload);
    }
    void report(std::string_view text) { driver_.report(text); }
    void count_foreign(jaus::datagram_form form) { driver_.transport().count_foreign(form); }
    void forget(sae::endpoint_key endpoint) { driver_.transport().forget(in_transport(endpoint)); }

  private:
    static constexpr unsigned key_bits = 56;

    std::unique_ptr<transport_driver> own_{};
    transport_driver& driver_;
    std::size_t number_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/transport_driver.ipp>
#endif
