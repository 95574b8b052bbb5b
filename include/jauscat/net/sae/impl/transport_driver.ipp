// The functions of transport_driver.
#pragma once
#include <jauscat/net/sae/transport_driver.hpp>

#include <string>
#include <utility>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL transport_driver::transport_driver(boost::asio::io_context& context, sae::transport& transport,
                                                put_handler put)
    : transport_{transport},
      put_{std::move(put)},
      log_{[this](std::string_view line) {
          if (is_running_ && handlers_.on_error) handlers_.on_error(line);
      }},
      timer_{context, [this] { run(); }} {}

JAUSCAT_DECL void transport_driver::start(sae_handlers handlers) {
    handlers_ = std::move(handlers);
    is_running_ = true;
    run();
}

// May be called by a handler, so the handlers stay.
JAUSCAT_DECL void transport_driver::stop() {
    timer_.cancel();
    is_running_ = false;
}

JAUSCAT_DECL void transport_driver::deliver(const sae::received_message& message) const {
    if (is_running_ && handlers_.on_message) handlers_.on_message(message);
}

JAUSCAT_DECL void transport_driver::report(std::string_view text) {
    log_(now(), [&] { return std::string{text}; });
}

JAUSCAT_DECL jaus::datagram_form transport_driver::on_datagram(sae::endpoint_key from,
                                                               std::span<const std::byte> datagram) {
    const auto form =
        transport_.on_datagram(from, datagram, now(), [this](const sae::received_message& m) { deliver(m); });
    run();
    return form;
}

JAUSCAT_DECL void transport_driver::on_packet(sae::endpoint_key from, const sae::split_transport_message& packet) {
    transport_.on_packet(from, packet, now(), [this](const sae::received_message& m) { deliver(m); });
    run();
}

JAUSCAT_DECL result<std::uint16_t, sae::transport_errc> transport_driver::send(const sae::outgoing_message& message,
                                                                               std::span<const std::byte> payload) {
    const auto number = transport_.send(message, payload, now());
    if (number) run();
    return number;
}

JAUSCAT_DECL void transport_driver::run() {
    const auto at = now();
    while (is_running_) {
        const auto datagram = transport_.next_datagram(at);
        if (!datagram) break;
        put_(*datagram);
    }
    while (is_running_) {
        const auto done = transport_.next_outcome();
        if (!done) break;
        if (handlers_.on_outcome) handlers_.on_outcome(*done);
    }
    if (const auto next = transport_.next_event(); next && is_running_) timer_.arm(*next);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
