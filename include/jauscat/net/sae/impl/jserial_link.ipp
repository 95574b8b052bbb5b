// The functions of jserial_link.
#pragma once
#include <jauscat/net/sae/jserial_link.hpp>

#include <boost/asio/error.hpp>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL jserial_link::jserial_link(boost::asio::io_context& context, sae::transport& transport,
                                        const jserial_options& options)
    : port_{context},
      message_(std::max(options.message_size, sae::transport_overhead)),
      reader_{message_},
      driver_{context, transport, [this](const sae::outgoing_datagram& datagram) { put(datagram); }},
      writer_{port_, options.max_waiting, [this](const boost::system::error_code& error) { failed(error); }},
      device_{options.device} {
    using base = boost::asio::serial_port_base;
    boost::system::error_code error;
    port_.open(options.device, error);
    if (!error) port_.set_option(base::baud_rate{options.baud}, error);
    if (!error) port_.set_option(base::character_size{8}, error);
    if (!error) port_.set_option(base::parity{base::parity::none}, error);
    if (!error) port_.set_option(base::stop_bits{base::stop_bits::one}, error);
    if (!error) port_.set_option(base::flow_control{base::flow_control::none}, error);
    if (!error) return;
    const bool is_refused = error == boost::asio::error::access_denied;
    throw open_error{{.code = is_refused ? errc::not_permitted : errc::not_opened,
                      .reason = error,
                      .message = "cannot open the serial line " + options.device + ": " + error.message() +
                                 (is_refused ? "; its group, mostly dialout, may use it" : "")}};
}

JAUSCAT_DECL void jserial_link::start(sae_handlers handlers) {
    driver_.start(std::move(handlers));
    receive();
}

JAUSCAT_DECL void jserial_link::stop() {
    driver_.stop();
    alive_ = std::make_shared<char>();
    boost::system::error_code ignored;
    port_.close(ignored);
}

JAUSCAT_DECL void jserial_link::receive() {
    port_.async_read_some(boost::asio::buffer(input_), [this, token = std::weak_ptr<char>{alive_}](
                                                           const boost::system::error_code& error, std::size_t size) {
        if (token.expired()) return;
        if (error) return failed(error);
        received(std::span{input_}.first(size));
        if (!token.expired()) receive();
    });
}

JAUSCAT_DECL void jserial_link::received(std::span<const std::byte> bytes) {
    reader_.on_bytes(bytes, [this, token = std::weak_ptr<char>{alive_}](const sae::serial_frame& frame) {
        if (token.expired()) return; // a handler has stopped it
        if (!frame) {
            ++counters_.faults[static_cast<std::size_t>(frame.error)];
            return;
        }
        ++counters_.frames;
        driver_.on_packet({}, sae::split(frame.message));
    });
}

JAUSCAT_DECL void jserial_link::put(const sae::outgoing_datagram& datagram) {
    frame_.resize(sae::max_serial_frame_size(datagram.message().size()));
    const auto frame = sae::put_serial_frame(datagram.message(), frame_);
    if (!frame || !writer_.write(*frame, alive_)) ++counters_.dropped;
}

JAUSCAT_DECL void jserial_link::failed(const boost::system::error_code& error) {
    driver_.report("the serial line " + device_ + " has failed: " + error.message());
    stop();
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
