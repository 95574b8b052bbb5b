// Sets a slave's process data up: process_setup, and the uploads that it waits for.
#pragma once

#include <jauscat/base/compilation.hpp>
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
#include <span>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return, `lost` their absence.
/// Without error, place and watchdog are in the slave's record when it is done. The record stays in place while it
/// runs.
class slave_setup {
  public:
    slave_setup() noexcept = default;
    /// As process_setup.
    JAUSCAT_FUNCTION slave_setup(slave_record& slave, std::uint32_t& image_end, std::chrono::nanoseconds watchdog,
                                 std::uint32_t logical_base, std::span<process_object> objects) noexcept;

    [[nodiscard]] const master_result<>& result() const noexcept { return setup_.result(); }
    [[nodiscard]] const process_place& place() const noexcept { return setup_.place(); }
    /// At most, of the present request: bytes and datagrams.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t request_size() const noexcept;
    [[nodiscard]] std::size_t request_datagrams() const noexcept { return uploads_ ? 1 : setup_.request_datagrams(); }

    JAUSCAT_FUNCTION void request(frame_builder& frame) noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;
    [[nodiscard]] bool was_refused() const noexcept { return uploads_ && upload_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return !uploads_ || upload_.is_repeatable(); }
    JAUSCAT_FUNCTION void lost() noexcept;
    [[nodiscard]] master_error cancel(const master_error& why) noexcept { return uploads_ ? upload_.cancel(why) : why; }

  private:
    slave_record* slave_{};
    process_setup setup_{};
    mailbox_session<sdo_transfer> upload_{};
    bool uploads_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_setup.ipp>
#endif
