// Reads words of a slave's SII, 4 or 8 bytes per access. The caller assigns the SII to the master before, and back
// afterwards: take_sii, give_sii.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Adds the datagrams that assign the SII to the master: by force, then without.
inline void take_sii(frame_builder& frame, std::uint16_t station) noexcept {
    frame.write(station, esc_registers::sii_owner, {.force = true});
    frame.write(station, esc_registers::sii_owner, {});
}
/// Adds the datagram that assigns the SII to the slave's application.
inline void give_sii(frame_builder& frame, std::uint16_t station) noexcept {
    frame.write(station, esc_registers::sii_owner, {.pdi = true});
}

/// State machine: `request` adds the datagram of the present step, `reply` takes its return. Two frames for each read.
class sii_read {
  public:
    sii_read() noexcept = default;
    /// `into.size()` bytes from the word `address` on. `into` stays in place until the read is done.
    sii_read(std::uint32_t address, std::span<std::byte> into) noexcept : word_{address}, rest_{into} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    void request(frame_builder& frame, std::uint16_t station) const noexcept {
        if (started_)
            frame.read(station, esc_registers::sii_access);
        else
            frame.write(station, esc_registers::sii_request, {.cmd = sii_command::read, .address = word_});
    }

    /// `datagram` was executed.
    progress reply(const datagram_view& datagram, time_point now, const master_config& config) noexcept {
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

  private:
    progress fail(const master_error& error) noexcept {
        result_ = error;
        return progress::done;
    }

    std::uint32_t word_{}; // to be read next
    std::span<std::byte> rest_{};
    bool started_{};
    timeout timeout_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
