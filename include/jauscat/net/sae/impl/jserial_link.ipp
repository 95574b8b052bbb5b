// The functions of jserial_link.
#pragma once
#include <jauscat/net/sae/jserial_link.hpp>

#include <boost/asio/error.hpp>

#include <algorithm>
#include <chrono>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL jserial_link::jserial_link(boost::asio::io_context& context, sae::transport& transport,
                                        const jserial_options& options)
    : options_{options},
      port_{context},
      pause_{context},
      pauses_{options.reopen},
      message_(std::max(options.message_size, sae::transport_overhead)),
      reader_{message_},
      medium_{context, transport, putter()} {
    open_first();
}
JAUSCAT_DECL jserial_link::jserial_link(boost::asio::io_context& context, transport_driver& driver,
                                        const jserial_options& options)
    : options_{options},
      port_{context},
      pause_{context},
      pauses_{options.reopen},
      message_(std::max(options.message_size, sae::transport_overhead)),
      reader_{message_},
      medium_{driver, putter()} {
    open_first();
}

JAUSCAT_DECL void jserial_link::open_first() {
    if (const auto error = open()) {
        const bool is_refused = error == boost::asio::error::access_denied;
        throw open_error{{.code = is_refused ? errc::not_permitted : errc::not_opened,
                          .reason = error,
                          .message = "cannot open the serial line " + options_.device + ": " + error.message() +
                                     (is_refused ? "; its group, mostly dialout, may use it" : "")}};
    }
    make_writer();
}

JAUSCAT_DECL boost::system::error_code jserial_link::open() {
    using base = boost::asio::serial_port_base;
    boost::system::error_code error;
    port_.open(options_.device, error);
    if (!error) port_.set_option(base::baud_rate{options_.baud}, error);
    if (!error) port_.set_option(base::character_size{8}, error);
    if (!error) port_.set_option(base::parity{base::parity::none}, error);
    if (!error) port_.set_option(base::stop_bits{base::stop_bits::one}, error);
    if (!error) port_.set_option(base::flow_control{base::flow_control::none}, error);
    return error;
}

JAUSCAT_DECL void jserial_link::make_writer() {
    writer_.emplace(port_, options_.max_waiting, [this](const boost::system::error_code& error) { failed(error); });
}

JAUSCAT_DECL void jserial_link::start(sae_handlers handlers) {
    medium_.start(std::move(handlers));
    receive();
}

JAUSCAT_DECL void jserial_link::stop() {
    medium_.stop();
    alive_ = std::make_shared<char>();
    pause_.cancel();
    boost::system::error_code ignored;
    port_.close(ignored);
}

JAUSCAT_DECL void jserial_link::receive() {
    port_.async_read_some(boost::asio::buffer(input_), [this, token = std::weak_ptr<char>{alive_}](
                                                           const boost::system::error_code& error, std::size_t size) {
        if (token.expired()) return;
        if (error) return failed(error);
        pauses_.reset();
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
        medium_.on_packet({}, sae::split(frame.message));
    });
}

JAUSCAT_DECL void jserial_link::put(const sae::outgoing_datagram& datagram) {
    frame_.resize(sae::max_serial_frame_size(datagram.message().size()));
    const auto frame = sae::put_serial_frame(datagram.message(), frame_);
    if (!frame || !port_.is_open() || !writer_->write(*frame, alive_)) ++counters_.dropped;
}

// What the reader has of a frame is lost with the device. The writer may be the caller: it stays until the next one.
JAUSCAT_DECL void jserial_link::failed(const boost::system::error_code& error) {
    alive_ = std::make_shared<char>(); // no handler of the closed device runs
    boost::system::error_code ignored;
    port_.close(ignored);
    reader_ = sae::jserial_reader{message_};
    reopen_later();
    medium_.report("the serial line " + options_.device + " has failed: " + error.message() +
                   "; it is opened again when it is there: see its cable and its power");
}

JAUSCAT_DECL void jserial_link::reopen_later() {
    pause_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(pauses_.next()));
    pause_.async_wait([this, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& aborted) {
        if (aborted || token.expired()) return;
        if (open()) {
            boost::system::error_code ignored;
            port_.close(ignored);
            return reopen_later();
        }
        make_writer();
        ++counters_.reopened;
        receive();
        medium_.report("the serial line " + options_.device + " is open again");
    });
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
