// The functions of transport_driver and transport_medium.
#pragma once
#include <jauscat/net/sae/transport_driver.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL transport_driver::transport_driver(boost::asio::io_context& context, sae::transport& transport)
    : transport_{transport},
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

JAUSCAT_DECL std::size_t transport_driver::add(put_handler put) {
    auto place = std::ranges::find_if(media_, [](const put_handler& one) { return !one; });
    if (place == media_.end()) place = media_.emplace(place);
    *place = std::move(put);
    return static_cast<std::size_t>(place - media_.begin());
}

JAUSCAT_DECL void transport_driver::report(std::string_view text) {
    log_(now(), [&] { return std::string{text}; });
}

JAUSCAT_DECL void transport_driver::pass(sae::endpoint_key from, const sae::split_transport_message& packet) {
    if (accept_ && packet && !accept_(packet.header, from)) return;
    const auto before = transport_.counts();
    transport_.on_packet(from, packet, now(), [this](const sae::received_message& message) {
        if (is_running_ && handlers_.on_message) handlers_.on_message(message);
    });
    report_refused(before, packet);
}

JAUSCAT_DECL void transport_driver::report_refused(const sae::transport_counters& before,
                                                   const sae::split_transport_message& packet) {
    const auto& after = transport_.counts();
    const auto tell = [&](std::string_view why) {
        log_(now(), [&] {
            const std::string whose =
                packet ? "a packet of " + std::string{sae::jaus_id_text{packet.header.source}.view()} : "a packet";
            return whose + " is refused: " + std::string{why};
        });
    };
    const auto fault = std::ranges::mismatch(after.faults, before.faults).in1;
    if (fault != after.faults.end()) tell(describe(static_cast<sae::transport_errc>(fault - after.faults.begin())));
    if (after.no_capacity != before.no_capacity)
        tell("no capacity: too many packets at a time for the memory (sae_node_options::memory)");
}

JAUSCAT_DECL jaus::datagram_form transport_driver::on_datagram(sae::endpoint_key from,
                                                               std::span<const std::byte> datagram) {
    if (!sae::is_judp2(datagram)) {
        const auto form = jaus::form_of(datagram);
        transport_.count_foreign(form);
        return form;
    }
    for (sae::datagram_reader messages{datagram}; messages.has_next();) pass(from, messages.next());
    run();
    return jaus::datagram_form::judp2;
}

JAUSCAT_DECL void transport_driver::on_packet(sae::endpoint_key from, const sae::split_transport_message& packet) {
    pass(from, packet);
    run();
}

JAUSCAT_DECL result<std::uint16_t, sae::transport_errc> transport_driver::send(const sae::outgoing_message& message,
                                                                               std::span<const std::byte> payload) {
    const auto number = transport_.send(message, payload, now());
    if (number) run();
    return number;
}

JAUSCAT_DECL void transport_driver::put(const sae::outgoing_datagram& datagram) const {
    if (!datagram.to) {
        for (const auto& medium : media_)
            if (medium) medium(datagram);
        return;
    }
    const auto number = transport_medium::number_of(*datagram.to);
    if (number < media_.size() && media_[number])
        media_[number]({transport_medium::own_key(*datagram.to), datagram.bytes});
}

JAUSCAT_DECL void transport_driver::run() {
    const auto at = now();
    while (is_running_) {
        const auto datagram = transport_.next_datagram(at);
        if (!datagram) break;
        put(*datagram);
    }
    while (is_running_) {
        const auto done = transport_.next_outcome();
        if (!done) break;
        if (handlers_.on_outcome) handlers_.on_outcome(*done);
    }
    if (const auto next = transport_.next_event(); next && is_running_) timer_.arm(*next);
}

JAUSCAT_DECL transport_medium::transport_medium(boost::asio::io_context& context, sae::transport& transport,
                                                transport_driver::put_handler put)
    : own_{std::make_unique<transport_driver>(context, transport)},
      driver_{*own_},
      number_{driver_.add(std::move(put))} {}
JAUSCAT_DECL transport_medium::transport_medium(transport_driver& shared, transport_driver::put_handler put)
    : driver_{shared}, number_{driver_.add(std::move(put))} {}
JAUSCAT_DECL transport_medium::~transport_medium() { driver_.remove(number_); }

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
