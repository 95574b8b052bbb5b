// Sets a slave's process data up: process_setup, and the uploads that it waits for.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/mailbox_session.hpp>
#include <jauscat/ethercat/master/process_setup.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return, `lost` their absence.
/// Without error, place and watchdog are in the slave's record when it is done. The record stays in place while it
/// runs.
class slave_setup {
  public:
    slave_setup() noexcept = default;
    /// As process_setup.
    slave_setup(slave_record& slave, std::uint32_t& image_end, std::chrono::nanoseconds watchdog,
                std::uint32_t logical_base) noexcept
        : slave_{&slave}, setup_{slave, image_end, watchdog, logical_base} {
        slave.watchdog = {};
    }

    [[nodiscard]] const master_result<>& result() const noexcept { return setup_.result(); }
    [[nodiscard]] const process_place& place() const noexcept { return setup_.place(); }
    /// At most, of the present request: bytes and datagrams.
    [[nodiscard]] std::size_t request_size() const noexcept {
        const auto& mailbox = slave_->mailbox;
        const std::size_t largest = std::max(mailbox.receive_size, mailbox.send_size);
        return uploads_ ? datagram_overhead + largest : process_setup::request_size();
    }
    static constexpr std::size_t request_datagrams() noexcept { return process_setup::request_datagrams(); }

    void request(frame_builder& frame) noexcept {
        if (uploads_)
            upload_.request(frame);
        else
            setup_.request(frame);
    }
    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        auto next = uploads_ ? upload_.reply(datagrams, now, config) : setup_.reply(datagrams, now, config);
        if (uploads_ && next == progress::done) {
            uploads_ = false;
            next = setup_.uploaded(upload_.result());
        }
        if (next != progress::done && !uploads_ && setup_.wants_upload()) {
            uploads_ = true;
            upload_ = {};
            upload_.begin(*slave_, setup_.upload());
        }
        if (next == progress::done && setup_.result()) {
            slave_->process_data = setup_.place();
            slave_->watchdog = setup_.watchdog();
        }
        return next;
    }
    [[nodiscard]] bool was_refused() const noexcept { return uploads_ && upload_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return !uploads_ || upload_.is_repeatable(); }
    void lost() noexcept {
        if (uploads_) upload_.lost();
    }
    [[nodiscard]] master_error cancel(const master_error& why) noexcept { return uploads_ ? upload_.cancel(why) : why; }

  private:
    slave_record* slave_{};
    process_setup setup_{};
    mailbox_session<sdo_transfer> upload_{};
    bool uploads_{};
};

} // namespace jauscat::ethercat
