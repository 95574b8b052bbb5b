// Reads a slave's AL status and whether its mailbox is full.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <cstdint>

namespace jauscat::ethercat {

/// State machine of one step.
class slave_check {
  public:
    slave_check() noexcept = default;
    explicit slave_check(const slave_record& slave) noexcept
        : station_{slave.station}, has_mailbox_{slave.mailbox.send_size != 0} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    [[nodiscard]] const al_status& al() const noexcept { return al_; }
    [[nodiscard]] bool reply_waiting() const noexcept { return mailbox_.enable && mailbox_.full; }

    void request(frame_builder& frame) const noexcept {
        frame.read(station_, esc_registers::al_status);
        if (has_mailbox_) frame.read(station_, sync_manager_handshake_of(1));
    }
    progress reply(replies datagrams, time_point, const master_config&) noexcept {
        result_ = executed_by_one(datagrams);
        if (!result_) return progress::done;
        al_ = datagrams.front().value(esc_registers::al_status);
        if (has_mailbox_) mailbox_ = datagrams.back().value(sync_manager_handshake_of(1));
        return progress::done;
    }

  private:
    std::uint16_t station_{};
    bool has_mailbox_{};
    al_status al_{};
    sync_manager_handshake mailbox_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
