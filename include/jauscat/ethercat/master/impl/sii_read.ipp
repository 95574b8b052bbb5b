// The functions of sii_read.
#pragma once
#include <jauscat/ethercat/master/sii_read.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void take_sii(frame_builder& frame, std::uint16_t station) noexcept {
    frame.write(station, esc_registers::sii_owner, {.force = true});
    frame.write(station, esc_registers::sii_owner, {});
}

JAUSCAT_FUNCTION void give_sii(frame_builder& frame, std::uint16_t station) noexcept {
    frame.write(station, esc_registers::sii_owner, {.pdi = true});
}

JAUSCAT_FUNCTION void sii_read::request(frame_builder& frame, std::uint16_t station) const noexcept {
    if (started_)
        frame.read(station, esc_registers::sii_access);
    else
        frame.write(station, esc_registers::sii_request, {.cmd = sii_command::read, .address = word_});
}

JAUSCAT_FUNCTION progress sii_read::reply(const datagram_view& datagram, time_point now,
                                          const master_config& config) noexcept {
    if (!started_) {
        started_ = true;
        timeout_.renew();
        return progress::send;
    }
    const auto access = datagram.value(esc_registers::sii_access);
    if (access.request.busy)
        return timeout_.expired(now, config.sii_timeout) ? fail({.code = master_errc::sii_busy}) : progress::wait;
    if (access.request.command_error) return fail({.code = master_errc::sii_error, .sii_word = word_});
    const std::size_t count = std::min<std::size_t>(access.request.eight_byte_reads ? 8 : 4, rest_.size());
    std::ranges::copy(std::span{access.data}.first(count), rest_.begin());
    rest_ = rest_.subspan(count);
    word_ += static_cast<std::uint32_t>(count / 2);
    started_ = false;
    return rest_.empty() ? progress::done : progress::send;
}

JAUSCAT_FUNCTION progress sii_read::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

} // namespace jauscat::ethercat
